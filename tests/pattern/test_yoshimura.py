"""Yoshimura patterns, as a sheet that rolls up and as a tube."""

import math
from collections import Counter

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.errors import InputError
from forficula.pattern import (
    big_little_big_residuals,
    built_fold_angles,
    folded_coordinates,
    interior_vertices,
    kawasaki_residuals,
    maekawa_residuals,
    yoshimura_pattern,
    yoshimura_tube,
)
from forficula.pattern.shared_edges import shared_edges
from tests.pattern.facets import corner_distances, folding, vector_areas


@st.composite
def rolls(draw):
    """Columns, rows, base, height and a fold that does not roll the sheet into itself."""
    columns, rows = draw(st.integers(1, 6)), draw(st.integers(1, 5))
    base, height = draw(st.floats(0.2, 5)), draw(st.floats(0.2, 5))
    climb = base / (2 * height) * math.tan(math.pi / (2 * columns))
    most = 2 * math.asin(climb) if climb < 1 else math.radians(179.9)
    return columns, rows, base, height, draw(st.floats(0, 1)) * most


def assert_triangles(pattern, base, height):
    side = math.hypot(base / 2, height)
    for distances in corner_distances(pattern):
        assert sorted(distances[np.triu_indices(3, 1)]) == pytest.approx(sorted([base, side, side]), rel=1e-11)


@settings(max_examples=60)
@given(rolls())
def test_every_facet_has_the_requested_shape_at_any_fold(roll):
    assert_triangles(yoshimura_pattern(*roll), *roll[2:4])


@settings(max_examples=40)
@given(rolls())
def test_bases_are_valleys_with_the_requested_fold_and_slanted_sides_mountains(roll):
    pattern = yoshimura_pattern(*roll)
    folds = built_fold_angles(pattern)
    # rounding of the middle of a roll of large radius grows as that over the base
    rounding = 1e-9
    for edge in folding(pattern):
        if pattern.edges_role[edge] == "base":
            assert folds[edge] == pytest.approx(roll[4], abs=rounding)
        else:
            assert folds[edge] <= rounding
    valleys = {role for role, letter in zip(pattern.edges_role, pattern.edges_assignment, strict=True) if letter == "V"}
    assert valleys <= {"base"}


@settings(max_examples=15)
@given(st.integers(1, 5), st.integers(1, 5), st.floats(0.1, math.sqrt(3) / 2))
def test_the_flat_sheet_folds_flat_at_every_vertex(columns, rows, height):
    flat = yoshimura_pattern(columns, rows, 1.0, height)
    assert not flat.vertices_coords[:, 2].any()
    assert len(interior_vertices(flat)) == (rows - 1) * (columns - 1)
    assert np.abs(kawasaki_residuals(flat)).max(initial=0) < 1e-12
    assert not maekawa_residuals(flat).any()
    assert not big_little_big_residuals(flat).any()
    folded_coordinates(flat, built_fold_angles(flat))
    assert (vector_areas(flat)[:, 2] > 0).all()


def test_triangles_steeper_than_equilateral_ones_trap_their_points():
    assert big_little_big_residuals(yoshimura_pattern(2, 2, 1.0, 0.9)).tolist() == [2]


def test_the_rolled_sheet_grows_out_of_the_flat_one():
    flat, rolled = (yoshimura_pattern(4, 3, 0.02, 0.01, fold) for fold in (0.0, 1e-7))
    assert rolled.vertices_coords == pytest.approx(flat.vertices_coords, abs=2e-8)
    assert rolled.vertices_coords[:, 2].max() <= 0


def test_a_sheet_rolled_up_to_its_last_fold_is_the_tube():
    base, height, sides = 0.02, 0.015, 6
    fold = 2 * math.asin(base / (2 * height) * math.tan(math.pi / (2 * sides)))
    sheet, tube = yoshimura_pattern(sides, 4, base, height, fold), yoshimura_tube(sides, 4, base, height)
    for line in range(5):
        ends = sheet.vertices_coords[[line * (sides + 1), line * (sides + 1) + sides]]
        assert ends[0] == pytest.approx(ends[1], abs=1e-15)
    folds = {
        (role, round(angle, 9))
        for pattern in (sheet, tube)
        for role, angle in zip(pattern.edges_role, built_fold_angles(pattern), strict=True)
        if role != "border"
    }
    assert len(folds) == 2


@settings(max_examples=30)
@given(st.integers(3, 9), st.integers(1, 4), st.floats(0.4, 4))
def test_a_tube_is_closed_of_triangles_and_seen_from_outside(sides, rows, height):
    tube = yoshimura_tube(sides, rows, 1.0, height)
    assert_triangles(tube, 1.0, height)
    assert len(shared_edges(tube)) == len(folding(tube)) == sides * (3 * rows - 1)
    middles = np.array([tube.vertices_coords[list(face)].mean(axis=0) for face in tube.faces_vertices])
    assert (np.einsum("ij,ij->i", middles[:, :2], vector_areas(tube)[:, :2]) > 0).all()
    for letter, role, fold in zip(tube.edges_assignment, tube.edges_role, tube.edges_fold_angle, strict=True):
        assert (letter, role) in {("V", "base"), ("M", "slanted"), ("B", "border")}
        assert math.isnan(fold) if letter == "B" else (fold > 0) == (letter == "V")


def test_the_radius_of_a_tube_is_that_of_its_polygons():
    tube = yoshimura_tube(5, 2, 0.02, 0.03)
    assert np.hypot(*tube.vertices_coords[:, :2].T) == pytest.approx([0.01 / math.sin(math.pi / 5)] * 15)
    assert Counter(tube.edges_role) == {"base": 5, "slanted": 20, "border": 10}


@pytest.mark.parametrize(
    ("draw", "message"),
    [
        (lambda: yoshimura_pattern(0, 1, 1, 1), "pattern.columns: need a whole number, 1 or more, got 0"),
        (lambda: yoshimura_pattern(1, 0, 1, 1), "pattern.rows: need a whole number, 1 or more, got 0"),
        (lambda: yoshimura_pattern(1, 1, 0, 1), "pattern.base: need > 0 and finite, got 0 cm"),
        (lambda: yoshimura_pattern(1, 1, 1, 1, 4.0), "pattern.fold: need >= 0 deg and < 180 deg, got 229.183 deg"),
        (
            lambda: yoshimura_pattern(4, 1, 1, 0.5, 2.0),
            "pattern.fold: need at most 48.9396 deg, where 4 columns close around their axis, got 114.592 deg",
        ),
        (lambda: yoshimura_tube(2, 1, 1, 1), "pattern.sides: need a whole number, 3 or more, got 2"),
        (lambda: yoshimura_tube(3, 1, 0.01, 0.002), "pattern.height: need > 0.288675 cm, the distance of the corners"),
    ],
)
def test_diamonds_that_cannot_be_drawn_are_refused(draw, message):
    with pytest.raises(InputError) as caught:
        draw()
    assert str(caught.value).startswith(message)
