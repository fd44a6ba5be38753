"""The waterbomb base as built, and the flat sheet of waterbombs."""

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
    flat_folding_faults,
    folded_coordinates,
    interior_vertices,
    kawasaki_residuals,
    maekawa_residuals,
    waterbomb_base,
    waterbomb_pattern,
)
from tests.pattern.closing import closure_residual
from tests.pattern.facets import corner_distances, vector_areas

STATES = st.one_of(
    st.tuples(st.floats(0, math.radians(179.9)), st.just("up")),
    st.tuples(st.floats(0, math.radians(89.9)), st.just("down")),
)


@settings(max_examples=50)
@given(st.floats(0.01, 1), STATES)
def test_the_facets_of_the_base_are_an_eighth_of_the_square_however_it_is_folded(side, state):
    for distances in corner_distances(waterbomb_base(side, *state)):
        assert sorted(distances[np.triu_indices(3, 1)]) == pytest.approx(
            [side / 2, side / 2, side / math.sqrt(2)], rel=1e-12
        )


@settings(max_examples=50)
@given(STATES)
def test_diagonals_of_the_base_have_the_requested_fold_and_the_vertex_closes(state):
    fold, apex = state
    folds = built_fold_angles(waterbomb_base(0.1, fold, apex))[:8]
    assert folds[1::2] == pytest.approx([-fold] * 4, abs=1e-9)
    assert np.ptp(folds[0::2]) < 1e-9
    assert folds[0] >= 0
    assert closure_residual([math.pi / 4] * 8, folds) < 1e-9


def test_the_base_has_the_same_senses_with_apex_up_and_down():
    """Near flat, midlines fold by sqrt(2) - 1 of the angle of the diagonals in one state, sqrt(2) + 1 in the other.

    The two are the solutions of tan(22.5 deg) and its inverse, which is the linearised closure of eight equal sectors.
    """
    up, down = (waterbomb_base(0.1, 1e-4, apex) for apex in ("up", "down"))
    assert up.vertices_coords[1:, 2].max() < 0 < down.vertices_coords[1:, 2].min()
    ratios = [built_fold_angles(item)[0] / 1e-4 for item in (up, down)]
    assert ratios == pytest.approx([math.sqrt(2) - 1, math.sqrt(2) + 1], rel=1e-6)


def test_the_base_folds_to_four_flaps():
    flat = waterbomb_base(0.1)
    assert folded_coordinates(flat, flat.edges_fold_angle).shape == (9, 3)  # sheets that do not close raise an error
    nearly = waterbomb_base(0.1, math.radians(180 - 1e-6)).vertices_coords
    assert nearly[1::2] == pytest.approx(np.tile([0, 0, -0.05], (4, 1)), abs=1e-8)
    assert nearly[2::2, 2] == pytest.approx([-0.05] * 4, abs=1e-8)


def test_the_flat_base_is_a_square_that_cannot_fold_flat():
    flat = waterbomb_base(0.1)
    assert np.ptp(flat.vertices_coords, axis=0) == pytest.approx([0.1, 0.1, 0], abs=1e-16)
    assert flat.edges_role == (*("midline", "diagonal") * 4, *["border"] * 8)
    assert flat.edges_vertices[:8].tolist() == [[0, k] for k in range(1, 9)]
    assert maekawa_residuals(flat).tolist() == [-2]
    assert "Maekawa fails" in flat_folding_faults(flat)[0]


@settings(max_examples=15)
@given(st.integers(1, 5), st.integers(1, 5))
def test_the_sheet_folds_flat_at_every_vertex(columns, rows):
    sheet = waterbomb_pattern(columns, rows, 0.02)
    assert np.abs(kawasaki_residuals(sheet)).max(initial=0) < 1e-12
    assert not maekawa_residuals(sheet).any()
    assert not big_little_big_residuals(sheet).any()
    inner_corners = (rows - 1) * (2 * columns - 1)
    centres = sum(columns - row % 2 for row in range(rows))
    assert len(interior_vertices(sheet)) == inner_corners + centres
    at = Counter(sheet.edges_vertices.ravel().tolist())
    assert {at[vertex] for vertex in interior_vertices(sheet).tolist()} == {6}


def test_the_sheet_is_a_rectangle_of_triangles():
    sheet = waterbomb_pattern(3, 2, 0.02)
    assert np.ptp(sheet.vertices_coords, axis=0) == pytest.approx([0.06, 0.04, 0])
    areas = vector_areas(sheet)
    assert areas[:, :2] == pytest.approx(0, abs=0)
    assert Counter(np.round(areas[:, 2] / 0.02**2, 12).tolist()) == {0.125: 24, 0.25: 12}
    assert {len(face) for face in sheet.faces_vertices} == {3}


def test_the_sheet_folds_flat_as_a_whole():
    sheet = waterbomb_pattern(3, 3, 0.02)
    shut = folded_coordinates(sheet, sheet.edges_fold_angle)  # sheets that do not close raise an error
    assert np.abs(shut[:, 2]).max() < 1e-15


def test_one_square_of_the_sheet_has_the_six_creases_of_its_centre():
    one = waterbomb_pattern(1, 1, 0.02)
    assert Counter(one.edges_role) == {"diagonal": 4, "midline": 2, "border": 6}
    assert maekawa_residuals(one).tolist() == [0]


@pytest.mark.parametrize(
    ("draw", "message"),
    [
        (lambda: waterbomb_base(0.0), "pattern.side: need > 0 and finite, got 0 cm"),
        (lambda: waterbomb_base(0.1, math.pi), "pattern.fold: need >= 0 deg and < 180 deg, got 180 deg"),
        (lambda: waterbomb_base(0.1, 2.0, "down"), "pattern.fold: need >= 0 deg and < 90 deg, got 114.592 deg"),
        (
            lambda: waterbomb_base(0.1, 1.0, "dawn"),
            'pattern.apex: need "up" or "down", got "dawn"; did you mean "down"?',
        ),
        (lambda: waterbomb_pattern(0, 1, 0.1), "pattern.columns: need a whole number, 1 or more, got 0"),
        (lambda: waterbomb_pattern(1, True, 0.1), "pattern.rows: need a whole number, 1 or more, got True"),
        (lambda: waterbomb_pattern(1, 1, math.inf), "pattern.side: need > 0 and finite, got inf cm"),
    ],
)
def test_a_waterbomb_that_cannot_be_drawn_is_refused(draw, message):
    with pytest.raises(InputError) as caught:
        draw()
    assert str(caught.value) == message
