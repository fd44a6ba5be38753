"""Split folds of thick panels: widths of strips, the pattern with strips, and sheets that cannot be split."""

import math
import re

import numpy as np
import pytest
import scipy

from forficula import InputError
from forficula.pattern import folded_coordinates, miura_pattern, pleat_pattern, vertex_pattern
from forficula.pattern.facet_sheet import sheet_of_facets
from forficula.pattern.thick.split_sheet import split_sheet
from forficula.pattern.thick.thick_motion import deepest_overlap, fold_path
from forficula.pattern.thick.thick_sheet import panel_motions, thick_sheet

THICK = 0.002
SIDE = 0.06


def limits_of(pattern):
    letters = pattern.edges_assignment
    return tuple((-math.pi if letter == "M" else 0.0, math.pi if letter == "V" else 0.0) for letter in letters)


def miura(columns, rows, fold=0.0, angle=60):
    return miura_pattern(columns, rows, SIDE, SIDE, math.radians(angle), fold)


def strips(pattern):
    """Widths of strips in thicknesses by the crease that they replace."""
    split = split_sheet(pattern, THICK)
    result = {}
    for face in split.pattern.faces_vertices[len(pattern.faces_vertices) :]:
        corners = split.pattern.vertices_coords[list(face)]
        beside = {frozenset(face[:2]), frozenset(face[2:])}
        edges = [edge for edge, ends in enumerate(split.pattern.edges_vertices.tolist()) if frozenset(ends) in beside]
        assert len({split.sources[edge] for edge in edges}) == 1
        result[int(split.sources[edges[0]])] = float(np.linalg.norm(corners[2] - corners[1])) / THICK
    return result


@pytest.mark.parametrize(
    ("lengths", "letters", "widths"),
    [
        ([6, 6], "V", {}),
        # an accordion wraps nothing
        ([6, 6, 6, 6], "VMV", {}),
        # the second flap of a letter goes around the first one
        ([6, 6, 6], "VV", {1: 1}),
        # rolled up: the shortest panel is inside, or the longest outside
        ([6, 5, 4, 3], "VVV", {0: 2, 1: 1}),
        ([3, 4, 5, 6], "VVV", {1: 1, 2: 2}),
    ],
)
def test_a_strip_is_as_wide_as_the_layers_that_it_goes_around(lengths, letters, widths):
    pattern = pleat_pattern([length / 100 for length in lengths], 0.1, letters)
    assert strips(pattern) == pytest.approx(widths)
    split = split_sheet(pattern, THICK)
    folds = [edge for edge, letter in enumerate(split.pattern.edges_assignment) if letter in "MV"]
    # axes on the faces at which panels meet
    senses = [1 if split.pattern.edges_assignment[edge] == "V" else -1 for edge in folds]
    assert split.axes[folds] == pytest.approx([sense * THICK / 2 for sense in senses])


@pytest.mark.parametrize("fold", [0.0, 0.6])
def test_a_miura_strip_has_all_axes_on_one_face_and_splits_its_straight_lines(fold):
    pattern = miura(4, 2, fold)
    split = split_sheet(pattern, THICK)
    roles = np.array(pattern.edges_role)
    widths = strips(pattern)
    assert {roles[edge] for edge in widths} == {"straight"}
    assert list(widths.values()) == pytest.approx([2.0] * 6)
    folds = [edge for edge, letter in enumerate(split.pattern.edges_assignment) if letter in "MV"]
    assert np.abs(split.axes[folds] - split.axes[folds[0]]).max() < 1e-9 * THICK
    assert abs(split.axes[folds[0]]) == pytest.approx(THICK / 2)


def test_the_pattern_with_strips_closes_at_half_the_fold_angles():
    pattern = miura(3, 3)
    split = split_sheet(pattern, THICK)
    path = split.path(fold_path(pattern, limits_of(pattern), 6))
    for angles in path:
        folded_coordinates(split.pattern, angles)
    split_folds = np.flatnonzero(split.pattern.edges_share == 0.5)
    for edge in split.sources[split_folds]:
        both = np.flatnonzero(split.sources == edge)
        assert len(both) == 2
        assert path[:, both].sum(axis=1) == pytest.approx(fold_path(pattern, limits_of(pattern), 6)[:, edge])


@pytest.mark.parametrize(("columns", "rows", "angle"), [(2, 2, 60), (2, 3, 60), (2, 2, 80)])
def test_panels_and_strips_do_not_overlap_between_the_poses_that_are_checked(columns, rows, angle):
    pattern = miura(columns, rows, angle=angle)
    made = thick_sheet(pattern, THICK, "split", limits_of(pattern))
    path = split_sheet(pattern, THICK).path(fold_path(pattern, limits_of(pattern), 37))
    assert deepest_overlap(made.panels, panel_motions(made, path))[0] < 1e-3 * THICK


def test_strips_lose_a_wedge_where_the_line_of_folds_closes():
    made = thick_sheet(miura(2, 2), THICK, "split", limits_of(miura(2, 2)))
    volumes = sorted(scipy.spatial.ConvexHull(panel[0].corners).volume for panel in made.panels[4:])
    # 2 t wide and t thick; the line closes to 180 deg - 2 * 60 deg
    whole, wedge = 2 * THICK**2 * SIDE, THICK**2 / math.tan(math.radians(60)) / 2 * 2 * THICK
    assert volumes == pytest.approx([whole - wedge, whole], rel=1e-9)


def test_a_narrow_strip_is_half_as_thick_as_it_is_wide():
    made = thick_sheet(pleat_pattern([SIDE] * 3, 0.1, "VV"), THICK, "split", limits_of(pleat_pattern([6] * 3, 1, "VV")))
    assert [layer.thickness for layer in made.layers] == pytest.approx([THICK, THICK, THICK, THICK / 2])
    assert all(core is not None for core in made.cores)


@pytest.mark.parametrize(
    ("pattern", "message"),
    [
        (
            vertex_pattern(np.radians([100, 60, 80, 120]), SIDE, "MVMM"),
            "vertex 0: need its creases of opposite sense, 1 and 3, in one line",
        ),
        (vertex_pattern(np.radians([60] * 6), SIDE, "MVMVMV"), "vertex 0: need four creases"),
        (vertex_pattern([math.pi / 2] * 4, SIDE, "VMMM"), "vertex 0: need sectors other than 90 deg"),
        (vertex_pattern([math.pi / 2] * 4, SIDE, "VUVM"), "vertex 0: need four creases"),
    ],
)
def test_a_sheet_that_cannot_be_split_is_refused_with_its_vertex_or_crease(pattern, message):
    with pytest.raises(InputError, match=re.escape(message)):
        split_sheet(pattern, THICK)


def test_strips_that_do_not_fit_around_a_hole_are_refused_with_a_crease():
    # a ring of four panels around a square hole, whose folds wrap different numbers of layers
    coords = np.array([(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0), (1, 1, 0), (3, 1, 0), (3, 3, 0), (1, 3, 0.0)]) / 50
    faces = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
    letters = dict(zip([(0, 4), (1, 5), (2, 6), (3, 7)], "VMMM", strict=True))
    ring = sheet_of_facets(coords, faces, {frozenset(ends): (letter, "") for ends, letter in letters.items()}, "ring")
    with pytest.raises(InputError, match=r"crease \d: need strips that fit around every hole"):
        split_sheet(ring, THICK)


def test_brackets_of_several_offset_vertices_lie_at_different_places_of_the_creases():
    pattern = miura(4, 2)
    made = thick_sheet(pattern, 0.0005, "offset", limits_of(pattern))
    assert deepest_overlap(made.panels, panel_motions(made, made.path))[0] < 1e-6 * 0.0005
