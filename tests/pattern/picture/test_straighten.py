import math
from dataclasses import replace

import numpy as np
import pytest

from forficula import InputError
from forficula.pattern import kawasaki_residuals, miura_pattern, vertex_pattern, waterbomb_base
from forficula.pattern.picture.straighten import straightened

MIURA = miura_pattern(3, 3, 0.03, 0.025, math.radians(60))


def disturbed(pattern, size, seed=1):
    shift = np.random.default_rng(seed).normal(0, size, (len(pattern.vertices_coords), 3))
    return replace(pattern, vertices_coords=pattern.vertices_coords + shift * [1, 1, 0])


def distance_from(pattern, other):
    one, two = (item.vertices_coords - item.vertices_coords.mean(axis=0) for item in (pattern, other))
    return np.linalg.norm(one - two, axis=1).max()


def test_a_disturbed_miura_becomes_exactly_flat_foldable_and_nearer_to_the_original():
    before = disturbed(MIURA, 3e-5)
    assert np.abs(kawasaki_residuals(before)).max() > 1e-4
    after, done = straightened(before, 5e-4)
    assert np.abs(kawasaki_residuals(after)).max() < 1e-11
    assert distance_from(after, MIURA) < distance_from(before, MIURA)
    moved = np.linalg.norm(after.vertices_coords - before.vertices_coords, axis=1)
    assert done.largest == pytest.approx(moved.max())
    assert done.mean == pytest.approx(np.sqrt(np.mean(moved**2)))
    assert done.flat_vertices == 4
    assert after.edges_assignment == before.edges_assignment


def test_a_disturbed_waterbomb_base_becomes_a_square_again():
    after, done = straightened(disturbed(waterbomb_base(0.1), 5e-5), 1e-3)
    assert done.symmetries[0] == "rotation by 90 deg"
    assert done.symmetries[1].startswith("mirror lines at")
    offset = np.linalg.norm(after.vertices_coords - after.vertices_coords.mean(axis=0), axis=1)
    assert sorted(np.round(offset / offset.max(), 12).tolist()) == [0.0] + [round(math.sqrt(0.5), 12)] * 4 + [1.0] * 4


def test_the_movement_is_the_least_one():
    # at one vertex of four creases the nearest flat-foldable position lies along the gradient of the condition
    pattern = vertex_pattern([math.radians(angle) for angle in (62, 100, 120, 78)], 0.06, "MMMV")
    before = disturbed(pattern, 1e-4)
    after, done = straightened(before, 2e-3)
    change = (after.vertices_coords - before.vertices_coords)[:, :2].ravel()
    step = 1e-7
    gradient = np.empty(len(change))
    for place in range(len(change)):
        residuals = []
        for sign in (1, -1):
            moved = after.vertices_coords.copy()
            moved[place // 2, place % 2] += sign * step
            residuals.append(kawasaki_residuals(replace(after, vertices_coords=moved))[0])
        gradient[place] = (residuals[0] - residuals[1]) / (2 * step)
    cosine = abs(change @ gradient) / np.linalg.norm(change) / np.linalg.norm(gradient)
    assert cosine == pytest.approx(1, abs=1e-6)
    assert done.straight_lines == 0


def test_movements_beyond_the_tolerance_are_refused_with_the_least_one():
    with pytest.raises(
        InputError, match=r"^straighten: need a tolerance of at least .* mm, by which vertex \d+ would move"
    ):
        straightened(vertex_pattern([math.radians(angle) for angle in (60, 100, 110, 90)], 0.06, "MMMV"), 1e-4)


def test_an_odd_number_of_creases_cannot_be_straightened():
    with pytest.raises(InputError, match="need an even number of creases at every vertex, got 5 at vertex 0"):
        straightened(vertex_pattern([math.radians(72)] * 5, 0.06, "MMVMV"), 1e-3)


@pytest.mark.parametrize("tolerance", [0.0125, 1.0, 1e300])
def test_a_tolerance_that_lets_vertices_exchange_their_positions_is_refused(tolerance):
    rule = r"^straighten: need a tolerance < 12\.5 mm, half of the shortest distance between two vertices, got "
    with pytest.raises(InputError, match=rule):
        straightened(MIURA, tolerance)
