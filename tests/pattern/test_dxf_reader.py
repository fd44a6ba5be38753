import numpy as np
import pytest

from forficula.errors import InputError
from forficula.pattern import read_drawing
from tests.pattern.drawings import dxf, dxf_line

RIM = [
    (0, "LWPOLYLINE"), (8, "border"), (90, 4), (70, 1), (10, 100), (20, 100), (10, 160), (20, 100),
    (10, 160), (20, 160), (10, 100), (20, 160),
]  # fmt: skip
OLD_RIM = [
    (0, "POLYLINE"), (8, "border"), (66, 1), (70, 1), (10, 0), (20, 0),
    (0, "VERTEX"), (8, "0"), (10, 100), (20, 100), (0, "VERTEX"), (8, "0"), (10, 160), (20, 100),
    (0, "VERTEX"), (8, "0"), (10, 160), (20, 160), (0, "VERTEX"), (8, "0"), (10, 100), (20, 160), (0, "SEQEND"),
]  # fmt: skip


def crease(*more):
    return dxf_line(130, 100, 130, 160, *more)


def letter_of(path, entity, **layers):
    beside = dxf_line(115, 100, 115, 160, (62, 6)), dxf_line(145, 100, 145, 160, (62, 6))
    pattern, _ = read_drawing(dxf(path / "sheet.dxf", RIM, *beside, entity, layers=layers))
    return next(letter for letter in reversed(pattern.edges_assignment) if letter != "B")


@pytest.mark.parametrize("border", [RIM, OLD_RIM])
def test_lines_and_polylines_make_a_sheet(tmp_path, border):
    pattern, remarks = read_drawing(dxf(tmp_path / "sheet.dxf", border, crease((62, 1))))
    assert remarks == ["faces found between the lines, 2"]
    assert sorted(pattern.edges_assignment) == sorted("BBBBBBM")
    assert np.ptp(pattern.vertices_coords, axis=0) == pytest.approx([0.06, 0.06, 0])
    assert pattern.vertices_coords.min(axis=0).tolist() == [0, 0, 0]


@pytest.mark.parametrize(
    ("index", "letter"),
    [
        (1, "M"),
        (5, "V"),
        (3, "C"),
        (2, "F"),
        (6, "U"),
        (7, "C"),
        (8, "F"),
        (10, "M"),
        (170, "V"),
        (252, "F"),
        (90, "C"),
    ],
)
def test_colours_of_the_index_are_read_as_origami_programs_mean_them(tmp_path, index, letter):
    assert letter_of(tmp_path, crease((62, index))) == letter  # black within the sheet is a cut


def test_layers_say_by_name_and_else_by_colour(tmp_path):
    assert letter_of(tmp_path, [(0, "LINE"), (8, "Valley"), (62, 1), *crease()[3:]]) == "V"
    assert letter_of(tmp_path, [(0, "LINE"), (8, "V"), *crease()[3:]], V=1) == "V"
    assert letter_of(tmp_path, [(0, "LINE"), (8, "k"), *crease()[3:]], k=5) == "V"
    assert letter_of(tmp_path, [(0, "LINE"), (8, "k"), (62, 256), *crease()[3:]], k=1) == "M"
    assert letter_of(tmp_path, [(0, "LINE"), (8, "k"), (420, 0x0000FF), (62, 1), *crease()[3:]]) == "V"


def test_layers_that_are_off_and_paper_are_left_out(tmp_path):
    hidden = [(0, "LINE"), (8, "off"), *dxf_line(0, 0, 9, 500)[3:]]
    paper = dxf_line(0, 0, 9, 500, (67, 1))
    text = [(0, "TEXT"), (8, "0"), (10, 0), (20, 0), (1, "M")]
    pattern, _ = read_drawing(
        dxf(tmp_path / "sheet.dxf", RIM, hidden, paper, text, crease((62, 1)), layers={"off": -1})
    )
    assert len(pattern.faces_vertices) == 2


@pytest.mark.parametrize(("units", "metres"), [(1, 0.0254), (4, 1e-3), (5, 1e-2), (6, 1.0)])
def test_the_header_says_how_long_a_unit_is(tmp_path, units, metres):
    pattern, _ = read_drawing(dxf(tmp_path / "sheet.dxf", RIM, crease((62, 1)), units=units))
    assert np.ptp(pattern.vertices_coords[:, 0]) == pytest.approx(60 * metres)


def test_a_unit_is_needed_where_the_header_has_none(tmp_path):
    path = dxf(tmp_path / "sheet.dxf", RIM, crease((62, 1)), units=0)
    with pytest.raises(InputError, match="unit: need the length of the drawing's unit, got none in the file"):
        read_drawing(path)
    assert np.ptp(read_drawing(path, unit=0.01)[0].vertices_coords[:, 0]) == pytest.approx(0.6)


def test_a_polyline_seen_from_below_is_mirrored(tmp_path):
    """Its corners are in a system of its own, with x the other way where its normal is -z (AutoCAD)."""
    below = [(0, "LWPOLYLINE"), (8, "M"), (90, 2), (70, 0), (230, -1), (10, -130), (20, 100), (10, -130), (20, 160)]
    pattern, _ = read_drawing(dxf(tmp_path / "sheet.dxf", RIM, below))
    assert len(pattern.faces_vertices) == 2


@pytest.mark.parametrize(
    ("entity", "message"),
    [
        (
            [(0, "ARC"), (5, "2A"), (8, "0"), (62, 1)],
            r"ARC 1 \(handle 2A\): need straight lines, got a curve; draw it as",
        ),
        ([(0, "INSERT"), (8, "0"), (2, "part")], "INSERT 1: need lines themselves, got a block; explode it"),
        (
            [(0, "LWPOLYLINE"), (8, "M"), (10, 100), (20, 100), (42, 0.5), (10, 160), (20, 160)],
            r"LWPOLYLINE 2: need straight lines, got an arc in a polyline \(bulge, code 42\)",
        ),
        ([(0, "LINE"), (8, "M"), (10, 1), (20, 1), (11, 2)], "LINE 1: need a coordinate, code 21, got none"),
        ([(0, "LINE"), (8, "M"), (10, "x")], 'LINE 1: need a finite number, got "x"'),
        (
            [(0, "LWPOLYLINE"), (8, "M"), (210, 1), (230, 0), (10, 100), (20, 100), (10, 160), (20, 160)],
            "LWPOLYLINE 2: need a polyline in the plane of the drawing",
        ),
    ],
)
def test_what_is_no_straight_line_is_refused_with_its_name(tmp_path, entity, message):
    with pytest.raises(InputError, match=rf"sheet\.dxf: {message}") as refusal:
        read_drawing(dxf(tmp_path / "sheet.dxf", RIM, entity))
    assert "\n" not in str(refusal.value)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"AutoCAD Binary DXF\r\n\x1a\x00", "need DXF as text, got binary DXF; save it as ASCII DXF"),
        (b"0\nSECTION\nx\ny\n", 'need DXF text, pairs of lines with a number first, got "x" in line 3'),
        (b"0\nEOF\n", "need a DXF drawing as text, got no section ENTITIES"),
        (b"0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n", "need lines in red .*, got none"),
    ],
)
def test_a_file_that_is_no_drawing_is_refused(tmp_path, content, message):
    (tmp_path / "sheet.dxf").write_bytes(content)
    with pytest.raises(InputError, match=rf"sheet\.dxf: {message}"):
        read_drawing(tmp_path / "sheet.dxf")


def test_lines_of_other_colours_are_told(tmp_path):
    _, remarks = read_drawing(dxf(tmp_path / "sheet.dxf", RIM, crease((62, 1)), dxf_line(0, 0, 1, 1, (62, 4))))
    assert remarks[0].endswith('are: 1 of layer "0", colour #00ffff')


@pytest.mark.parametrize("units", ["abc", "nan", "1e400", "5.7", "-1"])
def test_a_unit_of_the_header_that_is_none_is_refused_with_its_line_and_name(tmp_path, units):
    path = dxf(tmp_path / "sheet.dxf", RIM, units=units)
    with pytest.raises(InputError, match=rf'line 12: \$INSUNITS: need a whole number from 0 on, got "{units}"$'):
        read_drawing(path)
    assert path.read_text().splitlines()[11] == units
