import math
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

from forficula.errors import InputError
from forficula.pattern import CreasePattern, EarwigFan, earwig_pattern, read_drawing, write_svg

SVG = "{http://www.w3.org/2000/svg}"
FAN = EarwigFan(proximal_length=0.12, distal_length=0.10, hub_radius=0.015, sector_angle=math.radians(20), units=2)


def drawn(pattern, path):
    write_svg(pattern, path)
    return ElementTree.parse(path).getroot()


def strip(letters, fold_angle=math.nan, lift=0.0, title=""):
    """Squares of 1 cm in a row along x, with the given letters on the edges between them."""
    columns = len(letters) + 2
    coords = np.array([[0.01 * i, 0.01 * j, lift * i] for j in (0, 1) for i in range(columns)])
    across = [(i, i + columns) for i in range(1, columns - 1)]
    along = [(i, i + 1) for row in (0, columns) for i in range(row, row + columns - 1)]
    edges = [*across, *along, (0, columns), (columns - 1, 2 * columns - 1)]
    return CreasePattern(
        vertices_coords=coords,
        edges_vertices=np.array(edges),
        edges_assignment=tuple(letters) + ("B",) * (len(edges) - len(letters)),
        edges_fold_angle=np.array([fold_angle] * len(letters) + [math.nan] * (len(edges) - len(letters))),
        faces_vertices=tuple((i, i + 1, i + 1 + columns, i + columns) for i in range(columns - 1)),
        title=title,
    )


def test_lines_are_as_long_as_the_creases_in_millimetres(tmp_path):
    root = drawn(earwig_pattern(FAN), tmp_path / "fan.svg")
    lengths = [
        math.hypot(*(float(line.get(f"{axis}2")) - float(line.get(f"{axis}1")) for axis in "xy"))
        for line in root.iter(f"{SVG}line")
    ]
    assert lengths[:10] == pytest.approx([120] * 5 + [100] * 5, abs=1e-5)
    assert len(lengths) == 22


def test_the_page_is_in_millimetres_and_holds_every_line(tmp_path):
    root = drawn(strip("MV"), tmp_path / "strip.svg")
    left, top, width, height = (float(number) for number in root.get("viewBox").split())
    assert (left, top) == (0, 0)
    assert 30 < width < 40
    assert 16 < height < 26  # with a scale bar beneath
    assert root.get("width") == f"{width:.6f}mm"
    for line in root.iter(f"{SVG}line"):
        assert all(0 < float(line.get(f"x{end}")) < width and 0 < float(line.get(f"y{end}")) < height for end in "12")


def test_y_points_up(tmp_path):
    line = next(drawn(strip("M"), tmp_path / "strip.svg").iter(f"{SVG}line"))
    assert float(line.get("y1")) > float(line.get("y2"))  # from y = 0 to y = 1 cm; SVG counts downwards


def test_colours_are_those_that_origami_programs_read_and_dashes_differ(tmp_path):
    lines = list(drawn(strip("MVCFU"), tmp_path / "strip.svg").iter(f"{SVG}line"))
    assert [line.get("stroke") for line in lines[:4]] == ["#ff0000", "#0000ff", "#00ff00", "#808080"]
    assert lines[-1].get("stroke") == "#000000"
    assert lines[-1].get("stroke-dasharray") is None
    assert len({line.get("stroke-dasharray") for line in lines}) == 6


def test_opacity_shows_the_fold_angle(tmp_path):
    lines = list(drawn(strip("MV", fold_angle=-math.pi / 4), tmp_path / "strip.svg").iter(f"{SVG}line"))
    assert [line.get("stroke-opacity") for line in lines[:3]] == ["0.25", "0.25", None]
    line = next(drawn(strip("M"), tmp_path / "strip.svg").iter(f"{SVG}line"))
    assert line.get("stroke-opacity") is None


def test_the_legend_is_text_and_every_line_is_a_crease(tmp_path):
    root = drawn(strip("MV", title="a <strip> & \x00more"), tmp_path / "strip.svg")
    assert root.find(f"{SVG}title").text == "a <strip> & more"
    assert "mountain: red" in root.find(f"{SVG}desc").text
    stroked = {child.tag for child in root if child.get("stroke", "none") != "none"}
    assert stroked == {f"{SVG}line"}


def test_a_folded_sheet_is_not_drawn(tmp_path):
    with pytest.raises(InputError, match="need one z for all vertices"):
        write_svg(strip("M", lift=0.001), tmp_path / "strip.svg")
    assert not list(tmp_path.iterdir())


def test_tendons_dots_and_the_scale_bar_are_not_read_as_creases(tmp_path):
    pattern = earwig_pattern(FAN)
    ends = np.array([[0.06, 0.01, 0.0], [0.15, -0.02, 0.0]])
    write_svg(pattern, tmp_path / "fan.svg", ends)
    root = ElementTree.parse(tmp_path / "fan.svg").getroot()
    lines, dots = list(root.iter(f"{SVG}line")), list(root.iter(f"{SVG}circle"))
    # the end of a crease in the sheet and in the drawing gives the positions of the dots
    tail = pattern.vertices_coords[pattern.edges_vertices[0, 0], :2]
    for end, dot in zip(ends, dots, strict=True):
        beside = 1e3 * (end[:2] - tail) * [1, -1]
        assert float(dot.get("cx")) - float(lines[0].get("x1")) == pytest.approx(beside[0], abs=1e-5)
        assert float(dot.get("cy")) - float(lines[0].get("y1")) == pytest.approx(beside[1], abs=1e-5)
    (bar,), (label,) = root.iter(f"{SVG}rect"), root.iter(f"{SVG}text")
    assert f"{float(bar.get('width')):g} mm" == label.text == "50 mm"
    assert max(float(line.get(f"y{end}")) for line in lines for end in "12") < float(bar.get("y"))
    assert {dot.get("stroke") for dot in (*dots, bar, label)} == {"none"}
    again, _ = read_drawing(tmp_path / "fan.svg")
    write_svg(pattern, tmp_path / "bare.svg")
    bare, _ = read_drawing(tmp_path / "bare.svg")
    assert np.array_equal(again.vertices_coords, bare.vertices_coords)
    assert again.edges_assignment == bare.edges_assignment
