import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from forficula.errors import InputError
from forficula.pattern import degree4_closure, degree4_fold_angles, vertex_freedoms, vertex_walk
from tests.pattern.closing import closure_residual, opposite_fold_angle

SECTORS = st.floats(0.05, math.pi - 0.05)
FOLDS = st.one_of(st.sampled_from([-math.pi, 0.0, math.pi]), st.floats(-math.pi, math.pi))


def apart(folds, others):
    """The largest difference of fold angles, 180 deg and -180 deg being the same."""
    return np.abs(np.remainder(folds - others + math.pi, 2 * math.pi) - math.pi).max()


@given(st.tuples(SECTORS, SECTORS, SECTORS, SECTORS), FOLDS)
def test_any_vertex_of_four_creases_closes_in_both_solutions(sectors, fold):
    solutions = degree4_closure(sectors, fold)
    assume(not np.isnan(solutions).any())
    for solution in solutions:
        assert solution[0] == fold
        assert closure_residual(sectors, solution) < 1e-11


@given(st.tuples(SECTORS, SECTORS, SECTORS, SECTORS), FOLDS)
def test_a_vertex_reaches_as_far_as_its_opposite_crease_by_the_law_of_cosines(sectors, fold):
    solutions = degree4_closure(sectors, fold)
    try:
        size = opposite_fold_angle(sectors, fold)
    except InputError:
        assert np.isnan(solutions[:, 1:]).all()
    else:
        assert solutions[:, 2] == pytest.approx([size, -size])


@given(SECTORS, SECTORS, st.floats(0.05, math.pi), st.sampled_from([1, -1]))
def test_flat_foldable_vertices_match_the_half_angle_tangents(alpha, beta, fold, sign):
    assume(abs(alpha + beta - math.pi) > 0.01)
    assume(abs(alpha - beta) > 0.01)
    solutions = degree4_closure([alpha, math.pi - beta, math.pi - alpha, beta], sign * fold)
    modes = ("earwig", "miura") if sign > 0 else ("miura", "earwig")
    for solution, mode in zip(solutions, modes, strict=True):
        # sectors whose sum has the rounding error e rotate the vertex by sqrt(e) where it is folded flat
        assert apart(solution, degree4_fold_angles(alpha, beta, sign * fold, mode)) < 1e-6


def test_four_equal_plates_with_a_deficit_all_fold_by_the_published_angle():
    """Mid-wing plates of the earwig at 350 deg, Faber et al. 2018: cos(sum / 4) = cot^2((180 deg - rho) / 2)."""
    sector = math.radians(350) / 4
    fold = math.pi - 2 * math.atan(1 / math.sqrt(math.cos(sector)))
    assert degree4_closure([sector] * 4, fold)[0] == pytest.approx([fold] * 4)


def test_fold_angles_keep_the_shape_of_the_input():
    assert degree4_closure([1.0, 1.5, 1.7, 1.2], np.zeros((2, 5))).shape == (2, 4, 2, 5)


def test_panels_that_are_too_short_do_not_reach_around():
    assert np.isnan(degree4_closure([0.2, 1.0, 1.0, 2.0], 0.0)[:, 1:]).all()


@pytest.mark.parametrize(
    ("sectors", "fold", "message"),
    [
        ([1.0, 1.0, 1.0], 0.0, "sectors: need four"),
        ([1.0, 1.0, 1.0, 3.5], 0.0, "each > 0 deg and < 180 deg, got 57.2958, 57.2958, 57.2958, 200.535 deg"),
        ([1.0, 1.0, 1.0, 1.0], 4.0, "fold_angle: need -180 to 180 deg, got 229.183 deg"),
        ([1.0, 1.0, 1.0, 1.0], math.nan, "fold_angle: need -180 to 180 deg, got nan deg"),
    ],
)
def test_a_vertex_with_invalid_sectors_or_fold_is_refused(sectors, fold, message):
    with pytest.raises(InputError, match=message):
        degree4_closure(sectors, fold)


@settings(max_examples=50)
@given(st.integers(3, 8), st.integers(0, 2**32 - 1))
def test_the_walk_around_a_vertex_is_the_product_of_its_rotations(degree, seed):
    draw = np.random.default_rng(seed)
    sectors, folds = draw.uniform(0.1, 2.0, (2, 3, degree))
    product, creases = vertex_walk(sectors, folds)
    for vertex in range(3):
        distance = np.linalg.norm(product[vertex] - np.eye(3))
        assert distance == pytest.approx(closure_residual(sectors[vertex], folds[vertex]), abs=1e-12)
    assert np.linalg.norm(creases, axis=2) == pytest.approx(np.ones((3, degree)))


def test_fold_angles_turn_a_closed_walk_about_their_creases():
    sectors = np.array([1.0, 1.5, 1.7, 1.2])
    folds = degree4_closure(sectors, 0.8)[0]
    _, creases = vertex_walk(sectors, folds)
    for place in range(4):
        change = np.zeros(4)
        change[place] = 1e-6
        slope = (vertex_walk(sectors, folds + change)[0] - vertex_walk(sectors, folds - change)[0]) / 2e-6
        turned = [slope[2, 1] - slope[1, 2], slope[0, 2] - slope[2, 0], slope[1, 0] - slope[0, 1]]
        assert np.array(turned) / 2 == pytest.approx(creases[place], abs=1e-8)


def test_a_vertex_has_three_freedoms_fewer_than_creases():
    assert [vertex_freedoms(creases) for creases in (2, 3, 4, 6)] == [0, 0, 1, 3]


def test_a_walk_refuses_rows_that_do_not_match():
    with pytest.raises(InputError, match="fold_angles: need one for each sector"):
        vertex_walk([1.0, 2.0], [1.0])
