import math
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.design import load_design
from forficula.errors import InputError
from forficula.make.files.bill import bill_of
from forficula.make.flat.cut_lines import layer_texts
from forficula.make.flat.regions import area_of, loop_area, region_of, sides_of
from forficula.make.flat.sheet import cut_sheet
from forficula.make.hinge.joint_layout import joint_layouts
from forficula.make.hinge.strap_shape import bows_beside, strap_places
from forficula.make.make_parts import make_parts
from forficula.pattern import CreasePattern, vertex_pattern, write_fold, yoshimura_tube
from forficula.pattern.geometry import distance_to_sides
from forficula.structure import built_points, structure_of
from tests.sheets import sheet_design, stage

NAMED = ("miura-sheet", "waterbomb-base", "four-plate-snap", "bistable-clasp", "kresling-cell")


@cache
def sheet_of(name, *values):
    return cut_sheet(load_design(name).with_values({f"make.{key}": value for key, value in values}))


def facets_area(pattern):
    """Area of facets in space, by triangles from their first corner, m^2; it must not change when laid flat."""
    corners = [pattern.vertices_coords[list(face)] for face in pattern.faces_vertices]
    return sum(
        np.linalg.norm(np.cross(corner[1:-1] - corner[0], corner[2:] - corner[0]).sum(axis=0)) / 2 for corner in corners
    )


def offset_area(loop, distance):
    """Area of a polygon that is offset outwards by a distance with sharp corners, in closed form, m^2."""
    sides = np.roll(loop, -1, axis=0) - loop
    before = np.roll(sides, 1, axis=0)
    cross = before[:, 0] * sides[:, 1] - before[:, 1] * sides[:, 0]
    turns = np.arctan2(cross, (before * sides).sum(axis=1))
    around = np.linalg.norm(sides, axis=1).sum()
    return loop_area(loop) + around * distance + distance**2 * np.tan(turns / 2).sum()


def of_kind(sheet, *kinds):
    return [line for line in sheet.lines if line.kind in kinds]


def failed(sheet):
    return {check.name for check in sheet.checks if not check.ok}


def holed(tmp_path, **values):
    """A square of 60 mm with a square hole of 20 mm in its middle, in four facets, from a FOLD file."""
    corners = [[0, 0], [60, 0], [60, 60], [0, 60], [20, 20], [40, 20], [40, 40], [20, 40]]
    rims = [[k, (k + 1) % 4] for k in range(4)]
    pattern = CreasePattern(
        vertices_coords=np.array([[x / 1e3, y / 1e3, 0] for x, y in corners]),
        edges_vertices=np.array([*rims, *[[a + 4, b + 4] for a, b in rims], *[[k, k + 4] for k in range(4)]]),
        edges_assignment=tuple("BBBBBBBBMVMV"),
        edges_fold_angle=np.array([math.nan] * 8 + [-1.0, 1.0, -1.0, 1.0]),
        faces_vertices=tuple((k, (k + 1) % 4, (k + 1) % 4 + 4, k + 4) for k in range(4)),
    )
    write_fold(pattern, tmp_path / "holed.fold")
    return cut_sheet(load_design(tmp_path / "holed.fold", {f"make.{key}": value for key, value in values.items()}))


def made(pattern, **values):
    """The sheet of a pattern, with options of its section make."""
    rest = {"tendon": [], "protocol.stages": [stage()]}
    return cut_sheet(sheet_design(pattern, rest | {f"make.{key}": value for key, value in values.items()}))


def strip(cuts, **values):
    """Three columns of squares, 20 mm wide; between the first two an edge with each of the letters, then a valley."""
    rows, columns = len(cuts) + 1, 4
    coords = [[0.02 * column, 0.02 * row / len(cuts), 0] for row in range(rows) for column in range(columns)]
    number = np.arange(rows * columns).reshape(rows, columns)
    up, along = np.stack([number[:-1], number[1:]], axis=-1), np.stack([number[:, :-1], number[:, 1:]], axis=-1)
    letters = [letter for row in cuts for letter in ("B", row, "V", "B")]
    letters += ["B" if row in (0, rows - 1) else "F" for row in range(rows) for _ in range(columns - 1)]
    pattern = CreasePattern(
        vertices_coords=np.array(coords),
        edges_vertices=np.concatenate([up.reshape(-1, 2), along.reshape(-1, 2)]),
        edges_assignment=tuple(letters),
        edges_fold_angle=np.array([{"V": math.pi, "F": 0.0}.get(letter, math.nan) for letter in letters]),
        faces_vertices=tuple(
            (int(low[c]), int(low[c + 1]), int(high[c + 1]), int(high[c]))
            for low, high in pairwise(number)
            for c in range(columns - 1)
        ),
    )
    return made(pattern, **values)


@pytest.mark.parametrize("name", NAMED)
@pytest.mark.parametrize("kerf", ["0 mm", "0.4 mm"])
def test_cutter_path_without_the_kerf_has_the_area_of_the_facets(name, kerf):
    sheet = sheet_of(name, ("kerf", kerf))
    (way,), (outline,) = (line.points for line in of_kind(sheet, "border")), sheet.outlines
    assert loop_area(outline) == pytest.approx(facets_area(load_design(name).sheet), rel=1e-7)
    assert loop_area(way) == pytest.approx(offset_area(outline, sheet.kerf / 2), rel=1e-6)
    assert failed(sheet) == set()


def test_sheet_of_a_fan_without_tendons_is_its_panels_minus_hinge_knuckles():
    sheet = cut_sheet(load_design("binder2025").with_values({"tendon": []}))
    lost = facets_area(sheet.pattern) - sum(map(loop_area, sheet.outlines))
    # 10 mm of knuckles of 5.6 mm, with 0.4 mm clearance and 1 mm of window around them and round corners; of the outer
    # veins only the half that is on the sheet
    window = 12e-3 * 8.4e-3 - (4 - math.pi) * 1e-3**2
    assert lost == pytest.approx(2 * window, rel=2e-3)


def test_a_hole_of_a_file_stays_as_large_as_it_is_drawn_and_a_margin_is_around_the_sheet_only(tmp_path):
    sheet = holed(tmp_path, kerf="0.4 mm")
    outer, hole = sorted(sheet.outlines, key=loop_area, reverse=True)
    assert [loop_area(outer), loop_area(hole)] == pytest.approx([3.6e-3, -4e-4])
    assert facets_area(sheet.pattern) == pytest.approx(3.2e-3)
    ways = {line.kind: loop_area(line.points) for line in of_kind(sheet, "border", "hole")}
    assert ways == {"border": pytest.approx(0.0604**2), "hole": pytest.approx(-(0.0196**2))}
    wider = holed(tmp_path, margin="5 mm")
    assert sorted(map(loop_area, wider.outlines)) == pytest.approx([-4e-4, 0.07**2])
    # a crease that ended at the corner continues to the new corner, and none into the hole
    lengths = [np.linalg.norm(np.diff(line.points, axis=0)) for line in of_kind(wider, "crease")]
    assert lengths == pytest.approx([25e-3 * math.sqrt(2)] * 4)


def test_taut_straps_have_their_gap_in_the_windows_of_a_fan():
    design = load_design("binder2025").with_values({"make.window": "2 mm"})
    sheet, structure = cut_sheet(design), structure_of(design)
    sides = sides_of(region_of(sheet.outlines))
    for place in strap_places(bows_beside(joint_layouts(design, structure))):
        for start, end in place.ends[:, :, :2]:
            along = (end - start) / np.linalg.norm(end - start)
            aside = place.strap.width / 2 * np.array([-along[1], along[0]])
            edges = [start + s * (end - start) + side * aside for s in np.linspace(0, 1, 9) for side in (-1, 1)]
            assert all(
                area_of(region_of([edge + 1e-6 * np.eye(3, 2)]) ^ region_of(sheet.outlines)) == 0 for edge in edges
            )
            assert min(distance_to_sides(sides, edge) for edge in edges) >= 2e-3 - 1e-6


def test_a_tendon_across_a_crease_of_a_sheet_has_a_hole_at_each_end_and_a_slot_between():
    sheet = sheet_of("letter-fold")
    windows = region_of([line.points[::-1] for line in of_kind(sheet, "window")])
    assert len(sheet.holes) == 4
    for tendon in structure_of(load_design("letter-fold")).tendons:
        ends = built_points(structure_of(load_design("letter-fold")))[list(tendon.points), :2]
        for end in ends:
            assert min(np.linalg.norm(hole.place - end) for hole in sheet.holes) < 1e-12
        # the slot ends a peg's diameter of sheet before the hole
        for peg, other in (ends, ends[::-1]):
            gap = distance_to_sides(sides_of(windows), peg) - 2.5e-3
            assert gap == pytest.approx(5e-3 + 0.05e-3, abs=1e-5)  # the cutter's path is half a kerf inside
            assert area_of(windows ^ region_of([(peg + other) / 2 + 1e-4 * np.eye(3, 2)])) > 0
    assert failed(sheet) == set()


def test_a_band_through_the_air_needs_no_window():
    sheet = sheet_of("bistable-clasp")
    assert not of_kind(sheet, "window")
    assert not sheet.holes  # it is attached to two corners by clips


def test_a_tower_opens_along_one_seam_and_keeps_its_edge_lengths():
    pattern, sheet = load_design("kresling-cell").sheet, sheet_of("kresling-cell")
    lengths = np.linalg.norm(np.diff(pattern.vertices_coords[pattern.edges_vertices], axis=1)[:, 0], axis=1)
    flat = sheet.pattern
    laid = np.linalg.norm(np.diff(flat.vertices_coords[flat.edges_vertices], axis=1)[:, 0], axis=1)
    assert len(laid) == len(lengths) + 1
    assert laid[: len(lengths)] == pytest.approx(lengths)
    assert sheet.notes == ("the flat sheet is open along crease 7 of the pattern: join the edges with the same number",)
    assert [label.text for label in sheet.labels] == ["1", "1"]
    # six parallelograms in a row: the smallest rectangle is as high as a triangle
    side, mountain, valley = 0.03, lengths[0], lengths[1]
    half = (side + mountain + valley) / 2
    height = 2 * math.sqrt(half * (half - side) * (half - mountain) * (half - valley)) / side
    assert sheet.size.min() == pytest.approx(height)


def test_a_pattern_that_overlaps_itself_when_flat_is_rejected():
    saddle = vertex_pattern(np.radians([100.0] * 4), 0.03)
    with pytest.raises(InputError, match="laid flat, it overlaps itself"):
        made(saddle)
    with pytest.raises(InputError, match=r"make\.margin: need 0 mm for a sheet that is laid flat along seams"):
        made(yoshimura_tube(6, 1, 0.02, 0.015), margin="1 mm")


@pytest.mark.parametrize(
    ("name", "key", "said"),
    [
        (
            "binder2025-joint",
            "window",
            r"make\.window: leaves nothing of the sheet of 21\.55 cm by 7\.552 cm; need less, got",
        ),
        ("miura-sheet", "relief_hole", r"make\.relief_hole: leaves nothing of the sheet of .*; need less, got 10 cm"),
    ],
)
def test_a_value_that_leaves_nothing_of_the_sheet_is_rejected_with_its_key(name, key, said):
    with pytest.raises(InputError, match=said):
        sheet_of(name, (key, "100 mm"))


def test_score_lines_are_the_creases_and_lie_in_the_layers_of_their_letters():
    sheet = sheet_of("waterbomb-base")
    pattern = sheet.pattern
    for line in of_kind(sheet, "crease"):
        ends = pattern.vertices_coords[pattern.edges_vertices[line.edge], :2]
        assert line.points == pytest.approx(ends, abs=1e-9)
        assert line.layer == {"M": "mountain", "V": "valley"}[pattern.edges_assignment[line.edge]]
    assert len(of_kind(sheet, "crease")) == 8
    assert list(layer_texts(sheet)) == ["cut", "mountain", "valley"]


@pytest.mark.parametrize(("cut", "bridge"), [(3e-3, 1e-3), (2e-3, 2e-3), (7e-3, 0.5e-3)])
def test_a_perforation_has_the_right_fraction_of_bridges_and_bridged_ends(cut, bridge):
    sheet = sheet_of("letter-fold", ("crease_style", "perforation"), ("crease_cut", cut), ("crease_bridge", bridge))
    slits = [line.points for line in of_kind(sheet, "slit") if line.points[0, 0] < 0.12]
    ends = np.sort(np.array([points[:, 1] for points in slits]), axis=1)
    # the cutter removes half of its kerf beyond both ends of its path
    gone = (ends[:, 1] - ends[:, 0] + sheet.kerf).sum()
    assert gone / len(slits) == pytest.approx(cut)
    length = 0.21
    assert 1 - gone / length == pytest.approx(bridge / (cut + bridge), abs=4 * (cut + bridge) / length)
    ends = ends[np.argsort(ends[:, 0])]
    gaps = ends[1:, 0] - ends[:-1, 1] - sheet.kerf
    assert gaps.min() == pytest.approx(bridge)
    assert min(ends[0, 0], 0.21 - ends[-1, 1]) - sheet.kerf / 2 >= bridge - 1e-9
    assert (ends[0, 0] - 0) == pytest.approx(0.21 - ends[-1, 1], abs=cut + bridge)


def test_a_crease_shorter_than_a_cut_is_scored_and_says_so():
    sheet = sheet_of("miura-sheet", ("crease_style", "perforation"), ("crease_cut", "3 cm"))
    assert {line.layer for line in of_kind(sheet, "crease")} == {"score"}
    assert "too short for a cut of 3 cm with a bridge of 1 mm at both ends, and scored instead" in sheet.notes[0]
    assert len(of_kind(sheet, "crease")) == 24
    assert "too short for dashes" in layer_texts(sheet)["score"]


def test_rows_of_a_lattice_lie_at_its_pitch_and_bridges_of_one_beside_cuts_of_the_next():
    sheet = sheet_of("letter-fold", ("crease_style", "lattice"), ("lattice_rows", 4), ("lattice_pitch", "1.5 mm"))
    slits = [line.points for line in of_kind(sheet, "slit") if line.points[0, 0] < 0.12]
    rows = {}
    for points in slits:
        rows.setdefault(round(float(points[0, 0]), 7), []).append(np.sort(points[:, 1]))
    places = np.array(sorted(rows))
    assert places - 0.099 == pytest.approx([-2.25e-3, -0.75e-3, 0.75e-3, 2.25e-3])
    for one, other in pairwise(places):
        below, cuts = np.array(sorted(map(tuple, rows[one]))), np.array(sorted(map(tuple, rows[other])))
        bridges = (below[1:, 0] + below[:-1, 1]) / 2
        bridges = bridges[np.diff(below[:, 0]) < 5e-3]  # except those across the slot of the tendon
        inside = bridges[(bridges > cuts[0, 0]) & (bridges < cuts[-1, 1])]
        assert all(((cuts[:, 0] < place) & (place < cuts[:, 1])).any() for place in inside)


def crossing(one, other):
    """Whether two line segments intersect."""

    def side(start, end, place):
        # slits of one row are collinear up to rounding
        across = (end[0] - start[0]) * (place[1] - start[1]) - (end[1] - start[1]) * (place[0] - start[0])
        return np.sign(round(across, 12))

    return side(*one, other[0]) != side(*one, other[1]) and side(*other, one[0]) != side(*other, one[1])


gaps = st.lists(st.floats(0.35, 1), min_size=4, max_size=6)


@settings(max_examples=12, deadline=None)
@given(gaps=gaps, style=st.sampled_from(["perforation", "lattice"]), hole=st.sampled_from([None, "0 mm", "3 mm"]))
def test_no_slit_meets_another_one_or_a_hole_or_the_border(gaps, style, hole):
    sectors = 2 * math.pi * np.array(gaps) / sum(gaps)
    # facets are below 180 deg
    if sectors.max() > 3:
        return
    chosen = {"crease_style": style, "kerf": "0.2 mm"} | ({} if hole is None else {"relief_hole": hole})
    sheet = made(vertex_pattern(sectors, 0.03, "VMMMMM"[: len(gaps)]), **chosen)
    slits = [line.points for line in of_kind(sheet, "slit")]
    assert len(slits) > 2 * len(gaps)
    # a bridge remains everywhere, up to the two halves of the kerf
    sides = sides_of(region_of(sheet.outlines))
    for points in slits:
        along = (points[1] - points[0]) / np.linalg.norm(points[1] - points[0])
        tips = points + sheet.kerf / 2 * np.array([-along, along])
        assert min(distance_to_sides(sides, tip) for tip in tips) >= 1e-3 - 2e-6
        for round_hole in sheet.holes:
            near = distance_to_sides(tips[None], round_hole.place)
            assert near >= round_hole.nominal / 2 + 1e-3 - 1e-6
    assert not any(crossing(one, other) for number, one in enumerate(slits) for other in slits[:number])
    assert not failed(sheet) & {"one piece", "slits"}


def test_where_the_membrane_of_a_fan_begins_is_marked():
    design, sheet = load_design("binder2025"), sheet_of("binder2025")
    structure = structure_of(design)
    places = dict(zip([point.name for point in structure.points], built_points(structure), strict=True))
    hub, ring = places["hub1"][:2], places["ring1"][:2]
    ends = np.concatenate([line.points for line in of_kind(sheet, "edge")])
    assert {line.layer for line in of_kind(sheet, "edge")} == {"mark"}
    assert np.linalg.norm(ends - (hub + 0.3 * (ring - hub)), axis=1).min() < 1e-7
    assert sheet.notes[0].startswith("the membrane in the model leaves 4.4")


@pytest.mark.parametrize("style", ["perforation", "lattice"])
def test_no_slit_runs_into_a_window_or_out_of_a_fan(style):
    sheet = sheet_of("binder2025", ("crease_style", style), ("crease_bridge", "1.5 mm"))
    sides = sides_of(region_of(sheet.outlines))
    slits = [line.points for line in of_kind(sheet, "slit")]
    assert min(distance_to_sides(sides, tip) for points in slits for tip in points) >= 1.5e-3
    # there is sheet in between
    middles = [points.mean(axis=0) for points in slits]
    solid = region_of(sheet.outlines)
    assert all(area_of(region_of([middle + 1e-4 * np.eye(3, 2)]) ^ solid) > 0 for middle in middles)


def test_cuts_of_a_pattern_stay_closed_and_end_half_a_kerf_before_what_they_do_not_cut():
    sheet = strip("VCV", kerf="0.2 mm")
    (inner,) = of_kind(sheet, "cut")
    assert np.sort(inner.points[:, 1]) == pytest.approx([0.02 / 3 + 1e-4, 0.04 / 3 - 1e-4])
    assert failed(sheet) == set()
    (outer,) = of_kind(strip("CV", kerf="0.2 mm"), "cut")
    assert np.sort(outer.points[:, 1]) == pytest.approx([0.0, 0.01 - 1e-4])


def test_a_sheet_that_cannot_be_made_fails_its_check():
    apart = strip("CC")
    check = next(check for check in apart.checks if check.name == "one piece")
    assert (check.ok, check.value, check.text) == (
        False,
        2,
        "the sheet falls into 2 pieces; check its cuts, windows and slits",
    )
    # windows that remove all of the membrane beside the middle vein
    wide = sheet_of("binder2025", ("window", "6 mm"))
    assert {"strips", "windows"} & failed(wide)
    narrow = sheet_of("letter-fold", ("crease_style", "perforation"), ("crease_bridge", "0.3 mm"), ("kerf", "0.4 mm"))
    assert failed(narrow) == {"bridges"}
    rows = sheet_of("letter-fold", ("crease_style", "lattice"), ("lattice_pitch", "0.5 mm"), ("kerf", "0.3 mm"))
    assert failed(rows) == {"lattice strips"}
    assert failed(sheet_of("miura-sheet", ("relief_hole", "1.9 cm"))) == set()
    pleats = load_design("letter-fold").with_values(
        {"pattern.panel_lengths": [0.1, 0.002], "make.crease_style": "lattice"}
    )
    # three rows at 1 mm, and the next three 2 mm on
    assert "slits" in failed(cut_sheet(pleats.with_values({"tendon": []})))
    # creases of 2 cm
    assert failed(sheet_of("miura-sheet", ("relief_hole", "2.1 cm"))) >= {"round holes"}
    with pytest.raises(InputError, match=r"make\.crease_cut: need > make\.kerf, 4 mm, the width of the cutter, got 3"):
        sheet_of("letter-fold", ("crease_style", "perforation"), ("kerf", "4 mm"))


def test_a_strip_between_windows_is_as_wide_as_they_are_apart():
    wide = load_design("binder2025-joint").with_values({"pattern.width": "12 cm"})
    checks = {check.name: check for check in cut_sheet(wide).checks}
    assert checks["windows"].ok
    assert checks["strips"].value == pytest.approx(checks["windows"].value, rel=2e-3)


def test_a_sheet_with_a_thickness_and_a_density_has_a_mass_in_its_bill():
    (row,) = bill_of(make_parts(load_design("miura-sheet")))
    design = load_design("miura-sheet")
    sides = design.pattern.long_side * design.pattern.short_side * math.sin(design.pattern.acute_angle)
    by_hand = 16 * sides * 0.2e-3 * 1270
    assert row.mass == pytest.approx(by_hand, rel=1e-9)
    assert 1e3 * row.mass == pytest.approx(1.41, abs=0.005)
