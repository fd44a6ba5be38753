"""Heights and solids of thick panels, and the reasons why a method cannot give a sheet a thickness."""

import math
import re
from dataclasses import replace

import numpy as np
import pytest

from forficula import InputError
from forficula.pattern import miura_pattern, pleat_pattern, vertex_pattern
from forficula.pattern.shared_edges import shared_edges
from forficula.pattern.thick.convex import connected_parts, convex_faces, overlap_depths, solid_of, solid_within
from forficula.pattern.thick.thick_motion import deepest_overlap, fold_path
from forficula.pattern.thick.thick_sheet import _fault, panel_motions, thick_sheet

BOX = np.array([(x, y, z) for x in (0.0, 3.0) for y in (0.0, 2.0) for z in (0.0, 1.0)])
STAYS = (np.eye(3)[None], np.zeros((1, 3)))


def sheet(pattern, thickness, method, limit=math.pi):
    limits = [
        (-limit if letter == "M" else 0.0, limit if letter == "V" else 0.0) for letter in pattern.edges_assignment
    ]
    return thick_sheet(pattern, thickness, method, tuple(limits))


def shallow(columns=2, rows=2, fold=0.0):
    return miura_pattern(columns, rows, 0.06, 0.06, math.radians(60), fold)


def test_a_box_has_three_normals_three_edges_and_six_faces():
    box = solid_of(BOX)
    assert len(box.faces) == len(box.edges) == 3
    faces = convex_faces(BOX)
    assert sorted(map(len, faces)) == [4] * 6
    for face in faces:
        corners = BOX[list(face)]
        outwards = np.cross(corners[1] - corners[0], corners[2] - corners[1])
        assert outwards @ (corners.mean(axis=0) - BOX.mean(axis=0)) > 0


def test_half_spaces_have_the_corners_of_their_solid():
    normals = np.concatenate([np.eye(3), -np.eye(3)])
    solid = solid_within(normals, np.array([3.0, 2.0, 1.0, 0.0, 0.0, 0.0]), np.full(3, 0.5))
    assert sorted(map(tuple, np.round(solid.corners, 9) + 0.0)) == sorted(map(tuple, BOX))
    assert solid_within(normals, np.array([3.0, 2.0, 1.0, 0.0, 0.0, -1.0]), np.full(3, 0.5)) is None


@pytest.mark.parametrize(("shift", "depth"), [((2.9, 0, 0), 0.1), ((0, 0, 1.0), 0.0), ((3.5, 0.5, 0), -0.5)])
def test_the_depth_of_an_overlap_is_the_least_distance_that_parts_two_solids(shift, depth):
    box = solid_of(BOX)
    assert overlap_depths(box, STAYS, box, (STAYS[0], np.array([shift]))) == pytest.approx([depth], abs=1e-12)


def test_edges_that_cross_in_space_overlap_by_their_distance():
    turn = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]]) @ np.array([[1, 0, 0], [0, 0.8, -0.6], [0, 0.6, 0.8]])
    box = solid_of(BOX - BOX.mean(axis=0))
    apart = overlap_depths(box, STAYS, box, (turn[None], np.array([[0.0, 0, 5.0]])))
    together = overlap_depths(box, STAYS, box, (turn[None], np.array([[0.0, 0, 0.5]])))
    assert apart[0] < 0 < together[0]


@pytest.mark.parametrize("fold", [0.0, 0.6])
def test_shifted_hinges_lie_on_faces_of_boards_that_are_level(fold):
    pattern = shallow(fold=fold)
    made = sheet(pattern, 0.004, "hinge-shift")
    assert [layer.level for layer in made.layers] == pytest.approx([0.0] * 4, abs=1e-12)
    heights = sorted(made.axes[[edge.edge for edge in shared_edges(pattern)]] / 0.004)
    # one valley on top, two mountains at the bottom, the opposite mountain one thickness below
    assert heights == pytest.approx([-1.5, -0.5, -0.5, 0.5])


def test_offset_panels_keep_their_hinges_in_one_plane_and_stack():
    made = sheet(shallow(), 0.004, "offset")
    assert not made.axes.any()
    levels = np.array([layer.level for layer in made.layers]) / 0.004
    assert levels == pytest.approx([-0.5, -0.5, 1.5, 1.5])


@pytest.mark.parametrize("method", ["offset", "hinge-shift"])
def test_panels_touch_but_do_not_overlap_along_the_fold_path(method):
    pattern = vertex_pattern(np.radians([100, 60, 80, 120]), 0.06, "MVMM")
    made = sheet(pattern, 0.003, method)
    depth, _, _ = deepest_overlap(made.panels, panel_motions(made, made.path))
    assert depth < 1e-9 * made.thickness
    # half folded back, the sides of the panels overlap
    depth, _, _ = deepest_overlap(made.panels, panel_motions(made, -made.path[[3]]))
    assert depth > 0.01 * made.thickness


def test_a_letter_wraps_its_second_flap_around_the_first():
    made = sheet(pleat_pattern([0.06] * 3, 0.1, "VV"), 0.004, "hinge-shift")
    assert made.axes[1] - made.axes[0] == pytest.approx(0.002, rel=0.5)
    assert len(made.path) == 1


@pytest.mark.parametrize(
    ("pattern", "thickness", "method", "message"),
    [
        (vertex_pattern(np.radians([60] * 6), 0.06, "MVMVMV"), 1e-3, "hinge-shift", "vertex 0: need four creases"),
        (
            vertex_pattern(np.radians([80, 60, 90, 130]), 0.06, "VMVV"),
            1e-3,
            "hinge-shift",
            "vertex 0: need opposite sectors that add up to 180 deg, as in a vertex that folds flat",
        ),
        (vertex_pattern(np.radians([80, 60, 90, 130]), 0.06, "VMVV"), 1e-3, "offset", "need a sheet that folds flat"),
        (vertex_pattern([math.pi / 2] * 4, 0.06, "VUVM"), 1e-3, "offset", "need mountains and valleys, got crease 1"),
        (
            vertex_pattern(np.radians([100, 60, 80, 120]), 0.02, "MVMM"),
            8e-3,
            "hinge-shift",
            "need <= 6.83 mm, got 8 mm: notches for brackets of other panels divide the panel on facet 0",
        ),
        (shallow(), 0.06, "tapered", "need <= 9.08 mm, got 6 cm: nothing is left of the faces of the panel on facet 0"),
    ],
)
def test_an_impossible_thickness_is_refused_with_the_vertex_or_the_largest_thickness(
    pattern, thickness, method, message
):
    with pytest.raises(InputError, match=re.escape(message)) as refused:
        sheet(pattern, thickness, method, math.radians(170) if method == "tapered" else math.pi)
    if message.startswith("need <= 6.83 mm"):
        # only the ratio of thickness and size matters: 8 / 6.83, rounded up
        assert str(refused.value).endswith("a sheet that is 1.18 times as large would also fold flat")


@pytest.fixture(scope="module")
def stacked():
    """A sheet of two rows whose brackets slide through several panels while it closes."""
    return sheet(shallow(4), 0.003, "offset")


def test_notches_make_room_for_brackets_along_the_whole_path(stacked):
    limits = [(-math.pi, math.pi)] * len(stacked.pattern.edges_vertices)
    # poses other than those of the construction, and close to the flat-folded state
    path = np.concatenate(
        [fold_path(stacked.pattern, limits, 60), fold_path(stacked.pattern, limits, 71, slowing=True)]
    )
    depth, _, _ = deepest_overlap(stacked.panels, panel_motions(stacked, path))
    assert depth < 1e-6 * stacked.thickness


def test_pieces_of_a_panel_that_notches_leave_are_connected(stacked):
    for solids in stacked.panels:
        assert len(connected_parts(solids, 0.05 * stacked.thickness)) == 1


@pytest.mark.parametrize("unit", [0.1, 0.3])
def test_panels_of_a_sheet_in_another_unit_of_length_have_the_same_pieces_and_corners(unit):
    # a wrong pairing of corners would draw the panels of a run, whose engine has units of its own, with spikes
    metres = sheet(shallow(4, fold=0.02), 0.004, "offset")
    pattern = replace(metres.pattern, vertices_coords=metres.pattern.vertices_coords / unit)
    other = sheet(pattern, 0.004 / unit, "offset")
    for ours, theirs in zip(metres.panels, other.panels, strict=True):
        for one, scaled in zip(ours, theirs, strict=True):
            assert unit * scaled.corners == pytest.approx(one.corners, abs=1e-12)


def test_solids_that_touch_along_an_edge_are_not_connected():
    beside, diagonal = (solid_of(BOX + np.array(shift)) for shift in ([3, 1.5, 0], [3, 2, 0]))
    assert connected_parts([solid_of(BOX), beside], 0.4) == [[0, 1]]
    # the faces have a width of 0.5 in common
    assert connected_parts([solid_of(BOX), beside], 0.6) == [[0], [1]]
    assert connected_parts([solid_of(BOX), diagonal], 1e-6) == [[0], [1]]


def test_panels_that_overlap_are_named_with_their_common_crease():
    made = sheet(shallow(), 0.003, "hinge-shift")
    # folded back, the sides of neighbouring panels overlap
    fault = _fault(replace(made, path=-made.path[[3]]))
    one, other = fault.facets
    edge = next(edge.edge for edge in shared_edges(made.pattern) if {edge.left, edge.right} == {one, other})
    assert fault.text.startswith(f"the panels on facets {one} and {other} at crease {edge} overlap by")


def test_facets_with_an_inner_corner_are_refused():
    from forficula.pattern.facet_sheet import sheet_of_facets

    coords = np.array([(0, 0, 0), (4, 0, 0), (4, 4, 0), (2, 1, 0), (0, 4, 0), (0, -3, 0), (4, -3, 0.0)])
    arrow = sheet_of_facets(coords, [(0, 1, 2, 3, 4), (5, 6, 1, 0)], {frozenset((0, 1)): ("V", "")}, "arrow")
    with pytest.raises(InputError, match="need convex facets, got facet 0"):
        sheet(arrow, 0.1, "hinge-shift")


def test_rounding_does_not_change_the_order_of_the_corners_of_a_solid():
    # a record lists positions of corners, and figures that are drawn later find them by their order
    rng = np.random.default_rng(1)
    normals = np.array([sign * axis for axis in np.eye(3) for sign in (-1.0, 1.0)] + [[1.0, 1.0, 0.5]])
    offsets, inside = np.array([0.0, 3.0, 0.0, 2.0, 0.0, 1.0, 4.5]), np.array([1.4, 0.9, 0.5])
    built = solid_within(normals, offsets, inside).corners
    for _ in range(20):
        nearly = (1 + 1e-14 * rng.standard_normal(values.shape) for values in (normals, offsets))
        again = solid_within(*(a * b for a, b in zip((normals, offsets), nearly, strict=True)), inside).corners
        assert again == pytest.approx(built, abs=1e-8)
