import re
import xml.etree.ElementTree as ElementTree

import ezdxf
import numpy as np
import pytest

from forficula.design import load_design
from forficula.make.flat.sheet import cut_sheet
from forficula.make.flat.sheet_dxf import write_sheet_dxf
from forficula.make.flat.sheet_svg import write_sheet_svg
from forficula.pattern import read_drawing

SVG = "{http://www.w3.org/2000/svg}"
SHEETS = [
    ("binder2025", {}),
    ("kresling-cell", {"make.crease_style": "perforation"}),
    ("miura-sheet", {"make.crease_style": "lattice"}),
    ("letter-fold", {"make.margin": "4 mm"}),
]


def sheet_of(name, values):
    return cut_sheet(load_design(name).with_values(values))


def extent(points):
    return np.array([np.min(points, axis=0), np.max(points, axis=0)])


@pytest.mark.parametrize(("name", "values"), SHEETS)
def test_an_independent_reader_finds_millimetres_and_the_right_size(name, values, tmp_path):
    sheet = sheet_of(name, values)
    write_sheet_dxf(sheet, tmp_path / "sheet.dxf")
    drawing = ezdxf.readfile(tmp_path / "sheet.dxf")
    audit = drawing.audit()
    assert (drawing.dxfversion, audit.errors, audit.fixes) == ("AC1009", [], [])
    assert drawing.units == ezdxf.units.MM
    space = drawing.modelspace()
    outlines = list(space.query('POLYLINE[layer=="CUT"]'))
    assert all(outline.is_closed for outline in outlines)
    corners = extent([[point.x, point.y] for outline in outlines for point in outline.points()])
    assert corners[1] - corners[0] == pytest.approx(1e3 * (sheet.size + sheet.kerf), abs=1e3 * sheet.kerf)
    assert extent([drawing.header["$EXTMIN"][:2], drawing.header["$EXTMAX"][:2]]) == pytest.approx(corners, abs=1e-6)
    layers = {entity.dxf.layer for entity in space}
    assert layers - {"NOTE"} == {line.layer.upper() for line in sheet.lines} | ({"MARK"} if sheet.labels else set())
    assert layers <= {layer.dxf.name for layer in drawing.layers}
    assert len(space.query("LINE")) == sum(not line.closed for line in sheet.lines)
    assert [hole.dxf.radius for hole in space.query("CIRCLE")] == pytest.approx(
        [1e3 * hole.diameter / 2 for hole in sheet.holes], abs=1e-6
    )
    # the legend is below the sheet
    assert max(text.dxf.insert.y for text in space.query('TEXT[layer=="NOTE"]')) < corners[0, 1]


@pytest.mark.parametrize(("name", "values"), SHEETS)
def test_the_drawing_is_in_true_size_and_a_group_is_a_layer(name, values, tmp_path):
    sheet = sheet_of(name, values)
    write_sheet_svg(sheet, tmp_path / "sheet.svg")
    root = ElementTree.parse(tmp_path / "sheet.svg").getroot()
    width, height = (float(number) for number in root.get("viewBox").split()[2:])
    assert (root.get("width"), root.get("height")) == (f"{width:.6f}mm", f"{height:.6f}mm")
    shapes = [shape for group in root.iter(f"{SVG}g") for shape in group]
    points = [
        [float(x), float(y)]
        for shape in shapes
        if shape.tag == f"{SVG}polygon"
        for x, y in (pair.split(",") for pair in shape.get("points").split())
    ]
    assert np.ptp(points, axis=0) == pytest.approx(np.ptp(1e3 * sheet.corners, axis=0), abs=1e-5)
    assert extent(points)[0] == pytest.approx([3, 3], abs=1e-5)
    groups = {group.get("id"): group for group in root.iter(f"{SVG}g")}
    assert set(groups) == {line.layer.upper() for line in sheet.lines} | ({"MARK"} if sheet.labels else set())
    assert {name: groups[name].get("stroke") for name in groups if name != "MARK"}.items() <= {
        "CUT": "#000000",
        "SCORE": "#ff00ff",
        "MOUNTAIN": "#ff0000",
        "VALLEY": "#0000ff",
    }.items()
    # lines that are cut through are solid
    dashed = {shape.get("stroke-dasharray") for shape in shapes} - {None}
    assert bool(dashed) == (sheet.style == "score")
    output = root.find(f"{SVG}desc").text
    assert "lines compensate for a cutter 0.1 mm wide (kerf)" in output
    assert all(f"layer {name}: " in output for name in groups)


def test_y_points_up_in_both(tmp_path):
    sheet = sheet_of("bistable-clasp", {})
    write_sheet_svg(sheet, tmp_path / "sheet.svg")
    write_sheet_dxf(sheet, tmp_path / "sheet.dxf")
    valley = next(line for line in sheet.lines if line.layer == "valley")
    (drawn,) = ezdxf.readfile(tmp_path / "sheet.dxf").modelspace().query('LINE[layer=="VALLEY"]')
    assert [*drawn.dxf.start.vec2, *drawn.dxf.end.vec2] == pytest.approx(1e3 * valley.points.ravel(), abs=1e-6)
    (line,) = next(
        g for g in ElementTree.parse(tmp_path / "sheet.svg").iter(f"{SVG}g") if g.get("id") == "VALLEY"
    ).iter(f"{SVG}line")
    rise = 1e3 * (valley.points[1, 1] - valley.points[0, 1])
    assert float(line.get("y1")) - float(line.get("y2")) == pytest.approx(rise, abs=1e-5)


def test_a_scored_sheet_reads_back_as_its_pattern(tmp_path):
    sheet = sheet_of("waterbomb-base", {"make.kerf": "0 mm"})
    for write, name in ((write_sheet_dxf, "sheet.dxf"), (write_sheet_svg, "sheet.svg")):
        write(sheet, tmp_path / name)
        pattern, _ = read_drawing(tmp_path / name)
        assert len(pattern.faces_vertices) == len(sheet.pattern.faces_vertices)
        letters = [letter for letter in pattern.edges_assignment if letter in "MV"]
        assert (letters.count("M"), letters.count("V")) == (4, 4)
        assert np.ptp(pattern.vertices_coords[:, :2], axis=0) == pytest.approx([0.1, 0.1], abs=1e-7)


def test_the_same_design_gives_the_same_bytes_and_plain_letters(tmp_path):
    values = {"make.crease_style": "lattice", "name": "Flügel"}
    for number in range(2):
        sheet = sheet_of("binder2025", values)
        write_sheet_dxf(sheet, tmp_path / f"{number}.dxf")
        write_sheet_svg(sheet, tmp_path / f"{number}.svg")
    for ending in ("dxf", "svg"):
        assert (tmp_path / f"0.{ending}").read_bytes() == (tmp_path / f"1.{ending}").read_bytes()
    text = (tmp_path / "0.dxf").read_bytes()
    assert b"@ 2000-01-01T" in text  # a fixed date, not today's
    assert text.isascii()
    assert b"Fl\\U+00FCgel" in text
    assert not re.search(rb"^ *-0(\.0*)?$", text, re.MULTILINE)


def test_failed_checks_are_in_the_file(tmp_path):
    sheet = sheet_of("letter-fold", {"make.crease_style": "perforation", "make.crease_bridge": "0.05 mm"})
    write_sheet_dxf(sheet, tmp_path / "sheet.dxf")
    texts = [text.dxf.text for text in ezdxf.readfile(tmp_path / "sheet.dxf").modelspace().query("TEXT")]
    assert any(text.startswith("CHECK: bridges between cuts are") for text in texts)
