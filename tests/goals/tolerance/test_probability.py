"""The 95 % interval of a probability contains the closed-form value, also near 0 and 1."""

import math
from functools import cache

import numpy as np
import pytest
from scipy import special, stats

from forficula.goals.tolerance.plan import two_samples
from forficula.goals.tolerance.probability import interval_both_ways, probability, surely_less

REPETITIONS = 200
POINTS = 256


def in_ball(points, share):
    """A ball in the middle of the unit cube with this fraction of its volume (its radius below 1/2)."""
    dimension = points.shape[1]
    unit = math.pi ** (dimension / 2) / special.gamma(dimension / 2 + 1)
    radius = (share / unit) ** (1 / dimension)
    assert radius < 0.5
    return np.sum((points - 0.5) ** 2, axis=1) < radius**2


def in_half_space(points, share):
    """Half space across a diagonal; the sum of this many uniform numbers is nearly normal (Irwin and Hall)."""
    return np.sum(points, axis=1) < irwin_hall(share, points.shape[1])


@cache
def irwin_hall(share, dimension):
    return stats.irwinhall.ppf(share, dimension)


MODELS = [
    (in_ball, 3, 0.3),
    (in_half_space, 10, 0.5),
    (in_half_space, 10, 0.85),
    (in_half_space, 25, 0.98),
    (in_half_space, 10, 0.999),
    (in_half_space, 10, 0.004),
    (in_half_space, 10, 0.0004),
]


def estimates(model, dimension, share, *, drawn):
    for seed in range(REPETITIONS):
        if drawn:
            points = two_samples(dimension, POINTS, seed)[0]
        else:
            points = np.random.default_rng(seed).random((POINTS, dimension))
        works = int(np.sum(model(points, share)))
        yield probability(works, POINTS - works)


@pytest.mark.parametrize("drawn", [True, False], ids=["points of a tolerance", "independent points"])
@pytest.mark.parametrize(("model", "dimension", "share"), MODELS)
def test_interval_contains_the_known_probability_in_at_least_95_of_100_repetitions(model, dimension, share, drawn):
    result = list(estimates(model, dimension, share, drawn=drawn))
    held = np.mean([item.low <= share <= item.high for item in result])
    # of 200 repetitions at 95 %, at least 0.90 in 999 of 1000 series
    assert held >= stats.binom.ppf(1e-3, REPETITIONS, 0.95) / REPETITIONS
    assert np.mean([item.share for item in result]) == pytest.approx(
        share, abs=4 * math.sqrt(share * (1 - share) / POINTS / REPETITIONS)
    )


@pytest.mark.parametrize("points", [32, 64, 256])
def test_interval_contains_the_known_probability_for_every_pair_of_important_factors(points):
    """A band about a diagonal, and a corner: regions that are miscounted if two axes are correlated."""
    one, other = np.triu_indices(21, k=1)
    models = (
        (lambda first, second: np.abs(first - second) < 0.55, 1 - 0.45**2),
        (lambda first, second: ~((first > 0.6) & (second > 0.5)), 0.8),
    )
    intervals = [probability(works, points - works) for works in range(points + 1)]
    for model, share in models:
        holds = np.array([interval.low <= share <= interval.high for interval in intervals])
        held = np.zeros(len(one))
        for seed in range(REPETITIONS):
            sample = two_samples(21, points, seed)[0]
            held += holds[np.sum(model(sample[:, one], sample[:, other]), axis=0)] / REPETITIONS
        # the smallest of 210 pairs
        assert held.min() >= stats.binom.ppf(1e-3 / len(one), REPETITIONS, 0.95) / REPETITIONS


@pytest.mark.parametrize(("model", "dimension", "share"), MODELS[:3])
def test_counts_over_the_points_scatter_less_than_the_interval_assumes(model, dimension, share):
    result = [estimate.share for estimate in estimates(model, dimension, share, drawn=True)]
    assert np.std(result) < 0.9 * math.sqrt(share * (1 - share) / POINTS)


def test_inconclusive_runs_widen_the_interval_by_all_possible_outcomes():
    sure, doubtful = probability(200, 50), probability(200, 50, 6)
    assert doubtful.share == sure.share == 0.8
    assert doubtful.low == probability(200, 56).low < sure.low
    assert doubtful.high == probability(206, 50).high > sure.high


def test_undecided_runs_count_as_failing_at_the_lower_end_and_as_working_at_the_upper_one():
    low, high = interval_both_ways(200, 50, 6)
    assert low == probability(200, 56).low < probability(200, 50).low
    assert high == probability(206, 50).high > probability(200, 50).high
    counted = probability(200, 50, unknown=2, undecided=4)
    assert (counted.low, counted.high) == (low, high)
    assert (counted.unknown, counted.undecided, counted.count, counted.share) == (2, 4, 256, 0.8)


def test_interval_contains_the_probability_for_every_outcome_of_undecided_runs():
    """80 % of the designs work and a tenth is undecided; all undecided ones fail, or all work."""
    for works_if_decided in (False, True):
        held = 0
        for seed in range(REPETITIONS):
            generator = np.random.default_rng(seed)
            works, undecided = generator.random(POINTS) < 0.8, generator.random(POINTS) < 0.1
            truth = 0.72 + 0.1 * works_if_decided
            low, high = interval_both_ways(
                int(np.sum(works & ~undecided)), int(np.sum(~works & ~undecided)), int(np.sum(undecided))
            )
            held += low <= truth <= high
        assert held / REPETITIONS >= stats.binom.ppf(1e-3, REPETITIONS, 0.95) / REPETITIONS


@pytest.mark.parametrize("counts", [(0, 0, 0), (3, 2, -1)])
def test_an_interval_of_no_runs_or_of_a_negative_number_of_them_is_refused(counts):
    with pytest.raises(ValueError, match="need runs"):
        interval_both_ways(*counts)


def test_interval_below_one_if_every_run_works():
    """The rule of three: no failure in n runs gives 3 / n at a one-sided 95 %, here 3.7 / n at a two-sided one."""
    always = probability(256, 0)
    assert (always.share, always.high) == (1.0, 1.0)
    assert always.low == pytest.approx(0.025 ** (1 / 256), rel=1e-12)


def test_interval_from_zero_to_one_if_all_runs_are_inconclusive():
    nothing = probability(0, 0, 16)
    assert (nothing.share, nothing.low, nothing.high) == (None, 0.0, 1.0)


def test_no_runs_are_no_estimate():
    with pytest.raises(ValueError, match="need runs"):
        probability(0, 0)


def test_unimportant_factors_have_a_significant_side_in_at_most_one_of_twenty_cases():
    factors, samples, named, repetitions = 21, 384, 0, 50
    for seed in range(repetitions):
        generator = np.random.default_rng(seed)
        works, low = generator.random(samples) < 0.8, generator.random((factors, samples)) < 0.5
        sides = [
            [probability(int(works[side].sum()), int((~works[side]).sum())) for side in (item, ~item)] for item in low
        ]
        named += any(surely_less(*pair, 2 * factors) for side in sides for pair in (side, side[::-1]))
    assert named / repetitions <= 0.05 + 3 * math.sqrt(0.05 * 0.95 / repetitions)


def test_a_side_that_fails_much_more_often_is_significant():
    assert surely_less(probability(100, 92), probability(190, 2), 42)
    assert not surely_less(probability(190, 2), probability(100, 92), 42)
