import math
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from forficula.errors import InputError
from forficula.pattern import EarwigFan, earwig_pattern, kawasaki_residuals, pleat_pattern, read_drawing, write_svg
from tests.pattern.drawings import BLACK, BLUE, GREEN, RED, YELLOW, faces_like, line, read, rim, svg


@given(
    radius=st.floats(0, 0.03),
    angle=st.floats(0.1, 0.6),
    units=st.integers(1, 3),
    fold=st.floats(0.01, 1),
)
def test_what_is_drawn_is_read_back_as_the_same_pattern(tmp_path_factory, radius, angle, units, fold):
    """To the last digit of the drawing, a nanometre, where its smallest part is wider than the tolerance."""
    fan = EarwigFan(
        proximal_length=0.1,
        distal_length=0.07,
        hub_radius=0 if radius < 1e-3 else radius,
        sector_angle=angle,
        units=units,
    )
    pattern = earwig_pattern(fan)
    path = tmp_path_factory.getbasetemp() / "fan.svg"
    write_svg(pattern, path)
    again, remarks = read_drawing(path, tolerance=1e-6)
    lowest = pattern.vertices_coords.min(axis=0)
    for end in (0, 1):
        place, drawn = (sheet.vertices_coords[sheet.edges_vertices[:, end]] for sheet in (again, pattern))
        np.testing.assert_allclose(place, drawn - lowest, rtol=0, atol=2e-9)
    assert faces_like(again, pattern) == {frozenset(face) for face in pattern.faces_vertices}
    np.testing.assert_allclose(again.edges_fold_angle, pattern.edges_fold_angle, rtol=0, atol=1e-12)
    assert again.title == pattern.title
    assert remarks == [f"faces found between the lines, {len(pattern.faces_vertices)}"]
    assert again.edges_assignment == pattern.edges_assignment  # edges keep their order
    assert np.abs(kawasaki_residuals(again) - kawasaki_residuals(pattern)).max() < 1e-5
    half = type(pattern)(**{**vars(pattern), "edges_fold_angle": fold * pattern.edges_fold_angle})
    write_svg(half, path)
    np.testing.assert_allclose(read_drawing(path, tolerance=1e-6)[0].edges_fold_angle, half.edges_fold_angle, atol=1e-5)


def test_y_points_up_and_the_lower_left_corner_is_the_origin(tmp_path):
    pattern, _ = read(tmp_path, line(20, 60, 80, 60))
    crease = pattern.edges_vertices[pattern.edges_assignment.index("M")]
    assert pattern.vertices_coords[crease] == pytest.approx(np.array([[0, 0.02, 0], [0.06, 0.02, 0]]))
    assert pattern.vertices_coords.min(axis=0).tolist() == [0, 0, 0]


def test_lines_are_split_where_they_cross_and_touch(tmp_path):
    pattern, remarks = read(tmp_path, line(20, 20, 80, 80), line(80, 20, 20, 80, BLUE), line(50, 50, 50, 80, BLUE))
    assert remarks == ["lines split where they cross, at 1 place", "faces found between the lines, 5"]
    assert sorted(pattern.edges_assignment) == sorted("BBBBB" + "MM" + "VVV")
    centre = np.flatnonzero(np.isclose(pattern.vertices_coords[:, :2], 0.03).all(axis=1))
    assert (pattern.edges_vertices == centre).any(axis=1).sum() == 5


def test_gaps_within_the_tolerance_are_closed_with_a_remark(tmp_path):
    gaps = line(20.004, 20, 50, 50), line(50.005, 50.001, 80, 79.997)
    pattern, remarks = read(tmp_path, *gaps)
    assert remarks[0] == "3 gaps between ends closed, the largest 5.099 µm wide; the tolerance is 6 µm"
    assert len(pattern.faces_vertices) == 2
    with pytest.raises(
        InputError, match=r"line 1: need lines that continue .*; the nearest other line is 5\.099 µm away"
    ):
        read(tmp_path, *gaps, tolerance=2.5e-6)


def test_a_line_that_stops_short_of_another_is_named_with_the_gap(tmp_path):
    with pytest.raises(
        InputError,
        match=r"sheet\.svg: line 1 \(id \"a\"\): need lines that continue to others, got a free end 30 mm right of and"
        r" 0\.5 mm above the .* corner; the nearest other line is 0\.5 mm away: draw it to there, or give a tolerance",
    ):
        read(tmp_path, line(50, 20, 50, 79.5, more='id="a"'))
    assert len(read(tmp_path, line(50, 20, 50, 79.5), tolerance=1e-3)[0].faces_vertices) == 2


def test_flat_lines_that_end_in_a_face_are_left_out(tmp_path):
    pattern, remarks = read(tmp_path, line(50, 20, 50, 80), line(20, 50, 45, 50, YELLOW), line(60, 40, 70, 45, "grey"))
    assert "flat lines that end inside a face left out, 2 pieces" in remarks
    assert len(pattern.faces_vertices) == 2


def test_lines_drawn_twice_are_one(tmp_path):
    pattern, _ = read(tmp_path, line(50, 20, 50, 80), line(50, 60, 50, 20), line(20, 20, 80, 20, BLACK))
    assert sorted(pattern.edges_assignment) == sorted("BBBBBB" + "MM")


@pytest.mark.parametrize(
    ("second", "got"),
    [
        (line(50, 60, 50, 20, BLUE), "mountain and valley"),
        (line(50, 60, 50, 20, RED, 'opacity=".5"'), "two fold angles of one mountain"),
    ],
)
def test_lines_at_one_place_that_differ_are_refused(tmp_path, second, got):
    with pytest.raises(
        InputError, match=f"line 2: need one kind of line at a place, got {got}, over line 1, 30 mm right"
    ):
        read(tmp_path, line(50, 20, 50, 80), second)


def test_the_rim_becomes_border_whatever_its_colour(tmp_path):
    path = svg(tmp_path / "sheet.svg", rim(GREEN), line(50, 20, 50, 80))
    pattern, remarks = read_drawing(path)
    assert sorted(pattern.edges_assignment) == sorted("BBBBBBM")
    assert "edges at the rim of the sheet taken as border, 6 drawn as cut" in remarks
    assert np.isnan(pattern.edges_fold_angle[np.array(pattern.edges_assignment) == "B"]).all()


def test_border_inside_is_a_cut_and_a_face_that_only_border_encloses_is_a_hole(tmp_path):
    window = '<polygon points="40,40 60,40 60,60 40,60" stroke="black"/>'
    creases = line(20, 20, 40, 40), line(80, 20, 60, 40), line(80, 80, 60, 60), line(20, 80, 40, 60)
    pattern, remarks = read(tmp_path, window, *creases)
    assert "holes, which only border and cuts enclose, 1" in remarks
    assert len(pattern.faces_vertices) == 4
    assert sorted(pattern.edges_assignment) == sorted("BBBBBBBBMMMM")
    slit = line(20, 50, 40, 50, BLACK), line(40, 50, 60, 50, BLUE), line(60, 50, 80, 50, GREEN)
    pattern, remarks = read(tmp_path, *slit)
    assert "border between two faces taken as a cut, 1 edges" in remarks
    assert sorted(pattern.edges_assignment) == sorted("BBBBBBCCV")


@pytest.mark.parametrize(
    ("shapes", "message"),
    [
        (
            [line(30, 30, 40, 30), line(40, 30, 40, 40), line(40, 40, 30, 30)],
            "line 1: need lines that are connected, got 2",
        ),
        (
            [line(20, 20, 30, 30), line(30, 30, 40, 30), line(40, 30, 40, 40), line(40, 40, 30, 30)],
            "line 1: need different faces on both sides, got the same face around it, 5 mm right of and 55 mm above",
        ),
        (
            [line(20, 20, 30, 25), line(30, 25, 25, 30), line(25, 30, 20, 20)],
            "need faces that are simple polygons, got one that touches itself 0 mm right of and 60 mm above",
        ),
        ([line(50, 20, 50, 80, GREEN)], "need faces with creases between them, got border and cuts only"),
        (['<line x1="50" y1="20" x2="50" y2="80"/>'], None),
        ([line(50, 20, 50, 80, "cyan"), line(40, 20, 40, 80, "url(#fill)")], None),
    ],
)
def test_lines_that_are_no_sheet_are_refused(tmp_path, shapes, message):
    if message is None:
        assert len(read(tmp_path, *shapes)[0].faces_vertices) == 1
    else:
        with pytest.raises(InputError, match=rf"sheet\.svg: {message}") as refusal:
            read(tmp_path, *shapes)
        assert "\n" not in str(refusal.value)


def test_a_drawing_of_a_point_is_refused(tmp_path):
    with pytest.raises(InputError, match=r"need a drawing of a size from 1e-12 m to .*, got 0 m"):
        read_drawing(svg(tmp_path / "point.svg", line(5, 5, 5, 5)))


def test_lines_of_other_colours_are_left_out_with_a_remark(tmp_path):
    _, remarks = read(tmp_path, line(50, 20, 50, 80, "cyan"), line(40, 20, 40, 80, "orange"), line(30, 20, 30, 80))
    assert remarks[0] == "lines left out, because neither colour nor layer defines their kind: 1 of cyan, 1 of orange"
    with pytest.raises(InputError, match=r"need lines in red \(mountain\), .*, got only 1 of cyan$"):
        read_drawing(svg(tmp_path / "other.svg", line(50, 20, 50, 80, "cyan")))


def test_a_tolerance_that_joins_a_chain_of_points_is_refused(tmp_path):
    creases = [line(30 + 0.1 * k, 20, 30 + 0.1 * k, 80) for k in range(10)]
    with pytest.raises(
        InputError, match=r"tolerance: need less .*, got 0\.2 mm, which joins points 0\.9 mm apart through others"
    ):
        read(tmp_path, *creases, tolerance=0.2e-3)
    assert len(read(tmp_path, *creases)[0].faces_vertices) == 11
    for tolerance in (0.0, 1.0, math.nan):
        with pytest.raises(InputError, match=r"tolerance: need > 0 m and < 0\.06 m, the drawing's size, got"):
            read(tmp_path, *creases, tolerance=tolerance)


def test_a_unit_is_required_if_the_file_has_none_and_refused_if_it_contradicts(tmp_path):
    path = svg(tmp_path / "sheet.svg", rim(), line(50, 20, 50, 80), head='viewBox="0 0 100 100"')
    with pytest.raises(
        InputError, match=r'sheet\.svg: unit: need the length .* pattern\.unit = "1 mm", .* --unit "1 mm"'
    ):
        read_drawing(path)
    assert np.ptp(read_drawing(path, unit=0.01)[0].vertices_coords[:, 0]) == pytest.approx(0.6)
    with pytest.raises(InputError, match="unit: need none beside that of the file, 1 mm, got 10 mm; leave it out"):
        read(tmp_path, line(50, 20, 50, 80), unit=0.01)
    with pytest.raises(InputError, match="unit: need a length > 0, got -1 m"):
        read_drawing(path, unit=-1.0)


@pytest.mark.parametrize("seed", range(5))
def test_chords_divide_a_sheet_into_one_face_and_one_more_for_each_chord_and_crossing(tmp_path, seed):
    """Regions of a convex sheet by n chords with k crossings, no three at one place: 1 + n + k (Steiner 1826)."""
    random = np.random.default_rng(seed)
    places = random.permutation(np.arange(24) + random.uniform(0.1, 0.9, 24)).reshape(12, 2) / 24  # around the rim

    def on_rim(place):
        side, along = divmod(4 * place, 1)
        corner, way = [((20, 20), (1, 0)), ((80, 20), (0, 1)), ((80, 80), (-1, 0)), ((20, 80), (0, -1))][int(side)]
        return corner[0] + 60 * along * way[0], corner[1] + 60 * along * way[1]

    chords = [np.sort(pair) for pair in places if int(4 * pair[0]) != int(4 * pair[1])]
    crossed = sum((a < c < b) != (a < d < b) for (a, b), (c, d) in combinations(chords, 2))
    pattern, _ = read(tmp_path, *(line(*on_rim(a), *on_rim(b)) for a, b in chords))
    assert len(pattern.faces_vertices) == 1 + len(chords) + crossed
    assert len(pattern.vertices_coords) == 4 + 2 * len(chords) + crossed


def test_sixty_by_sixty_lines_are_a_sheet(tmp_path):
    """Some thousand pieces, in a second."""
    across = [line(20 + k, 20, 20 + k, 80) + line(20, 20 + k, 80, 20 + k, BLUE) for k in range(1, 60)]
    pattern, remarks = read(tmp_path, *across)
    assert len(pattern.faces_vertices) == 3600
    assert "lines split where they cross, at 3481 places" in remarks


@given(
    turn=st.floats(0, 360),
    shift=st.floats(-300, 300),
    widths=st.lists(st.floats(0.01, 0.1), min_size=2, max_size=5),
)
def test_turning_a_drawing_changes_no_length(tmp_path_factory, turn, shift, widths):
    pattern = pleat_pattern(widths, 0.1, "MV" * 2 if len(widths) == 5 else "MVMV"[: len(widths) - 1])
    path = tmp_path_factory.getbasetemp() / "strip.svg"
    write_svg(pattern, path)
    text = path.read_text(encoding="utf-8")
    first, rest = text.split("<line", 1)
    turned = f'{first}<g transform="rotate({turn}) translate({shift} 7)"><line{rest}'.replace("</svg>", "</g></svg>")
    path.write_text(turned, encoding="utf-8")
    again, _ = read_drawing(path)
    for sheet in (pattern, again):
        ends = sheet.vertices_coords[sheet.edges_vertices]
        lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
        if sheet is pattern:
            expected = lengths
    np.testing.assert_allclose(lengths, expected, rtol=0, atol=5e-9)
    assert again.edges_assignment == pattern.edges_assignment
