import subprocess
import sys

import ezdxf
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


def test_the_layer_name_defines_the_kind_and_otherwise_the_colour(tmp_path):
    assert letter_of(tmp_path, [(0, "LINE"), (8, "Valley"), (62, 1), *crease()[3:]]) == "V"
    assert letter_of(tmp_path, [(0, "LINE"), (8, "V"), *crease()[3:]], V=1) == "V"
    assert letter_of(tmp_path, [(0, "LINE"), (8, "k"), *crease()[3:]], k=5) == "V"
    assert letter_of(tmp_path, [(0, "LINE"), (8, "k"), (62, 256), *crease()[3:]], k=1) == "M"
    assert letter_of(tmp_path, [(0, "LINE"), (8, "k"), (420, 0x0000FF), (62, 1), *crease()[3:]]) == "V"


def test_hidden_layers_and_paper_space_are_left_out(tmp_path):
    hidden = [(0, "LINE"), (8, "off"), *dxf_line(0, 0, 9, 500)[3:]]
    paper = dxf_line(0, 0, 9, 500, (67, 1))
    text = [(0, "TEXT"), (8, "0"), (10, 0), (20, 0), (1, "M")]
    pattern, _ = read_drawing(
        dxf(tmp_path / "sheet.dxf", RIM, hidden, paper, text, crease((62, 1)), layers={"off": -1})
    )
    assert len(pattern.faces_vertices) == 2


@pytest.mark.parametrize(("units", "metres"), [(1, 0.0254), (4, 1e-3), (5, 1e-2), (6, 1.0)])
def test_the_header_defines_the_unit(tmp_path, units, metres):
    pattern, _ = read_drawing(dxf(tmp_path / "sheet.dxf", RIM, crease((62, 1)), units=units))
    assert np.ptp(pattern.vertices_coords[:, 0]) == pytest.approx(60 * metres)


def test_a_unit_is_needed_where_the_header_has_none(tmp_path):
    path = dxf(tmp_path / "sheet.dxf", RIM, crease((62, 1)), units=0)
    with pytest.raises(InputError, match="unit: need the length of the drawing's unit, got none in the file"):
        read_drawing(path)
    assert np.ptp(read_drawing(path, unit=0.01)[0].vertices_coords[:, 0]) == pytest.approx(0.6)


def test_a_polyline_seen_from_below_is_mirrored(tmp_path):
    """Its corners are in a separate coordinate system, with x reversed where its normal is -z (AutoCAD)."""
    below = [(0, "LWPOLYLINE"), (8, "M"), (90, 2), (70, 0), (10, -130), (20, 100), (10, -130), (20, 160)]
    below += [(210, 0), (220, 0), (230, -1)]
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
        (dxf_line(1, 2, "nan", 4, (62, 1)), r"LINE 1 \(handle 1F\): need finite numbers, got nan"),
        (
            [(0, "LWPOLYLINE"), (8, "M"), (210, 1), (220, 0), (230, 0), (10, 100), (20, 100), (10, 160), (20, 160)],
            "LWPOLYLINE 2: need a polyline in the plane of the drawing",
        ),
    ],
)
def test_entities_other_than_straight_lines_are_refused_by_name(tmp_path, entity, message):
    with pytest.raises(InputError, match=rf"sheet\.dxf: {message}") as refusal:
        read_drawing(dxf(tmp_path / "sheet.dxf", RIM, entity))
    assert "\n" not in str(refusal.value)


@pytest.mark.parametrize(
    ("entity", "message"),
    [
        ([(0, "LINE"), (8, "M"), (10, 1), (20, 1), (11, 2)], "LINE 1: need coordinates of its end, got none"),
        (dxf_line(1, 2, "x", 4), "need a DXF drawing, got a damaged one: Invalid floating point values near line: 94"),
        (dxf_line(1, 2, "3,5", 4), 'need a DXF drawing, .*: recovered invalid floating point value "3,5" near line 94'),
    ],
)
def test_a_damaged_file_is_refused_with_its_line(tmp_path, entity, message):
    with pytest.raises(InputError, match=rf"sheet\.dxf: {message}"):
        read_drawing(dxf(tmp_path / "sheet.dxf", OLD_RIM, entity))


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (
            b"AutoCAD Binary DXF\r\n\x1a\x00",
            "need a DXF drawing, got a damaged binary one: DXFStructureError: missing EOF",
        ),
        (b"0\nSECTION\nx\ny\n", 'need a DXF drawing, got a damaged one: Invalid group code "x" at line 3'),
        (b"0\nEOF\n", "need a DXF drawing, got a file that does not begin with a section"),
        (b"\x89PNG\r\n\x1a\n", "need a DXF drawing, got a file that does not begin with a section"),
        (b"0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n", "need lines in red .*, got none"),
    ],
)
def test_an_invalid_dxf_file_is_refused(tmp_path, content, message):
    (tmp_path / "sheet.dxf").write_bytes(content)
    with pytest.raises(InputError, match=rf"sheet\.dxf: {message}"):
        read_drawing(tmp_path / "sheet.dxf")


def test_lines_of_other_colours_are_left_out_with_a_remark(tmp_path):
    _, remarks = read_drawing(dxf(tmp_path / "sheet.dxf", RIM, crease((62, 1)), dxf_line(0, 0, 1, 1, (62, 4))))
    assert remarks[0].endswith('kind: 1 of layer "0", colour #00ffff')


@pytest.mark.parametrize("units", ["abc", "nan", "1e400", "5.7", "-1"])
def test_an_unknown_unit_in_the_header_is_refused_with_line_and_name(tmp_path, units):
    path = dxf(tmp_path / "sheet.dxf", RIM, units=units)
    with pytest.raises(InputError, match=rf'line 12: \$INSUNITS: need a whole number from 0 on, got "{units}"$'):
        read_drawing(path)
    assert path.read_text().splitlines()[11] == units


def document(version):
    """A square with a mountain across it, as ezdxf writes it."""
    drawing = ezdxf.new(version)
    space = drawing.modelspace()
    corners = [(100, 100), (160, 100), (160, 160), (100, 160)]
    add = space.add_polyline2d if version == "R12" else space.add_lwpolyline
    add(corners, close=True, dxfattribs={"layer": "border"})
    space.add_line((130, 100), (130, 160), dxfattribs={"color": 1})
    return drawing


@pytest.mark.parametrize("version", ["R12", "R2000", "R2010", "R2018"])
@pytest.mark.parametrize("kind", ["asc", "bin"])
def test_every_release_is_read_as_text_and_binary(tmp_path, version, kind):
    drawing = document(version)
    drawing.header["$INSUNITS"] = 5
    drawing.saveas(tmp_path / "sheet.dxf", fmt=kind)
    unit = 0.01 if version == "R12" else None  # ezdxf writes no unit in files of release 12
    pattern, remarks = read_drawing(tmp_path / "sheet.dxf", unit=unit)
    assert remarks == ["faces found between the lines, 2"]
    assert np.ptp(pattern.vertices_coords, axis=0) == pytest.approx([0.6, 0.6, 0])


def test_a_file_without_a_header_has_no_unit(tmp_path):
    dxf(tmp_path / "sheet.dxf", OLD_RIM, crease((62, 1)))
    text = (tmp_path / "sheet.dxf").read_text()
    (tmp_path / "sheet.dxf").write_text(text[text.index("  0\nSECTION\n  2\nTABLES") :])
    with pytest.raises(InputError, match="unit: need the length of the drawing's unit, got none in the file"):
        read_drawing(tmp_path / "sheet.dxf")


def test_polylines_of_later_releases_keep_their_layer_and_close_in_a_file_of_release_12(tmp_path):
    border = [*RIM[:1], (100, "AcDbEntity"), RIM[1], (100, "AcDbPolyline"), *RIM[2:]]
    pattern, _ = read_drawing(dxf(tmp_path / "sheet.dxf", border, crease((62, 1))))
    assert sorted(pattern.edges_assignment) == sorted("BBBBBBM")


@pytest.mark.parametrize("header", ["without a release", "none"])
def test_polylines_of_later_releases_are_read_from_a_file_that_states_no_release(tmp_path, header):
    path = dxf(tmp_path / "sheet.dxf", RIM, crease((62, 1)))
    text = path.read_text().replace("  9\n$ACADVER\n  1\nAC1009\n", "")
    path.write_text(text if header == "without a release" else text[text.index("  0\nSECTION\n  2\nTABLES") :])
    pattern, _ = read_drawing(path, unit=1e-3)
    assert sorted(pattern.edges_assignment) == sorted("BBBBBBM")


def test_a_truncated_file_is_repaired_with_a_remark(tmp_path, capfd):
    path = dxf(tmp_path / "sheet.dxf", OLD_RIM, crease((62, 1)))
    path.write_text(path.read_text().removesuffix("  0\nENDSEC\n  0\nEOF\n"))
    pattern, remarks = read_drawing(path)
    assert len(pattern.faces_vertices) == 2
    assert remarks[0].startswith("damaged file repaired: ")
    assert capfd.readouterr() == ("", "")


def test_coordinates_are_read_in_any_order(tmp_path):
    line = [(0, "LINE"), (8, "M"), (10, 130), (11, 130), (20, 100), (21, 160)]
    pattern, _ = read_drawing(dxf(tmp_path / "sheet.dxf", OLD_RIM, line))
    assert len(pattern.faces_vertices) == 2


def test_only_reading_a_drawing_imports_ezdxf():
    code = (
        "import sys, forficula, forficula.cli, forficula.commands.runs, forficula.show.folder.parts_folder\n"
        "forficula.load_design('letter-fold')\n"
        "sys.exit('ezdxf' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_layers_are_named_in_the_code_page_of_the_file(tmp_path):
    path = dxf(tmp_path / "sheet.dxf", OLD_RIM, crease((62, 1)), [(0, "LINE"), (8, "grün"), (62, 4), *crease()[3:]])
    text = path.read_text(encoding="utf-8").replace(
        "  9\n$INSUNITS", "  9\n$DWGCODEPAGE\n  3\nANSI_1252\n  9\n$INSUNITS"
    )
    for encoding in ("utf-8", "cp1252"):
        path.write_text(text, encoding=encoding)
        _, remarks = read_drawing(path)
        assert remarks[0].endswith('1 of layer "grün", colour #00ffff')
