"""The strongest of many factors get indices of their own, although few rows of each would rank them by chance."""

import numpy as np
import pytest

from forficula.goals.tolerance.indices import total_effects
from forficula.goals.tolerance.plan import exchanged, two_samples
from forficula.goals.tolerance.screening import deciding_factors, screening
from tests.goals.tolerance.test_indices import ishigami

FACTORS, REPETITIONS = 25, 12
# numbers of the smallest plan with a screening
POINTS, ROWS, EXCHANGED, KEPT = 128, 32, 8, 6


def ishigami_among_others(points):
    return ishigami(points[:, [4, 9, 17]])


def sobol_g(points):
    """Sobol (1993): total indices of 0.79, 0.24 and 0.034 for a of 0, 1 and 4.5, and below 0.012 for all others."""
    a = np.array([0.0, 1.0, 4.5, 9.0, *np.full(21, 99.0)])
    return np.prod((np.abs(4 * points - 2) + a) / (1 + a), axis=1)


def line(points):
    """Five factors explain 0.51, 0.23, 0.13, 0.08 and 0.06 of the variance; twenty are inactive."""
    return points[:, :5] @ [3.0, 2.0, 1.5, 1.2, 1.0]


def step(points):
    """A margin with a step at a plane: four factors have total indices of 0.77 to 0.15, 21 others of 0.035."""
    weights = np.array([2.0, 1.0, 0.8, 0.6, *np.full(21, 0.15)])
    along = (points - 0.5) @ weights
    return np.where(along > 0.25 * np.sqrt(np.sum(weights**2) / 12), -0.4, 0.6) - 0.05 * along


def screened(function, seed):
    first, second = two_samples(FACTORS, POINTS, seed)
    values = np.concatenate([function(first), function(second[:ROWS])])
    mixed = np.array([function(exchanged(first[:EXCHANGED], second[:EXCHANGED], [index])) for index in range(FACTORS)])
    steps = (second[:EXCHANGED] - first[:EXCHANGED]).T
    effects = total_effects(function(first[:EXCHANGED]), mixed, steps) / np.var(values)
    return screening(np.concatenate([first, second[:ROWS]]), values, effects, KEPT, seed)


@pytest.mark.parametrize(
    ("function", "strongest"),
    [
        (ishigami_among_others, {4, 9, 17}),
        (sobol_g, {0, 1, 2}),
        (line, {0, 1, 2, 3, 4}),
    ],
)
def test_the_strongest_of_25_factors_are_kept_in_every_repetition(function, strongest):
    for seed in range(REPETITIONS):
        assert strongest <= set(screened(function, seed).kept)


def test_strongest_factors_of_a_margin_with_a_step_are_kept():
    result = [screened(step, seed) for seed in range(REPETITIONS)]
    kept = np.mean([np.isin(range(4), item.kept) for item in result], axis=0)
    ranked = np.mean([np.isin(range(4), np.argsort(-item.effects)[:KEPT]) for item in result], axis=0)
    assert kept[:3].tolist() == [1, 1, 1]
    assert kept[3] >= 0.8
    # an earlier method lost the second to fourth strongest in a tenth to a third of the repetitions
    assert ranked[1:].mean() < 0.85


def test_factors_without_effect_are_significant_in_at_most_one_of_twenty_tables():
    """Two factors have an effect, one a larger one than the other; 23 have none."""
    false, repetitions = 0, 60
    for seed in range(repetitions):
        points = two_samples(FACTORS, POINTS, seed)[0]
        noise = np.random.default_rng(seed).standard_normal(POINTS)
        shares, resolved = deciding_factors(points, 6 * points[:, 0] + 3 * points[:, 1] + noise, seed)
        assert resolved[:2].all()
        assert shares[0] > shares[1] > shares[2:].max()
        false += resolved[2:].any()
    assert false / repetitions <= 0.05 + 3 * np.sqrt(0.05 * 0.95 / repetitions)


def test_a_constant_result_has_no_important_factor():
    shares, resolved = deciding_factors(two_samples(4, 32, 0)[0], np.full(32, 0.7), 0)
    assert not shares.any()
    assert not resolved.any()
