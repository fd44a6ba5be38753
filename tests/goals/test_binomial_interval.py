"""Coverage of binomial intervals, computed from the binomial distribution."""

import numpy as np
import pytest
from scipy import stats

from forficula.goals.binomial_interval import binomial_interval, one_sided_upper_bound

SHARES = np.linspace(0.0005, 0.9995, 1000)


@pytest.mark.parametrize("count", [16, 60, 256])
def test_intervals_of_all_proportions_have_at_least_their_nominal_coverage(count):
    counts = np.arange(count + 1)
    low, high = np.array([binomial_interval(int(item), count) for item in counts]).T
    chances = stats.binom.pmf(counts, count, SHARES[:, None])
    assert np.sum(chances * ((low <= SHARES[:, None]) & (SHARES[:, None] <= high)), axis=1).min() >= 0.95


def test_one_sided_bound_is_exceeded_in_at_most_one_of_twenty_cases():
    counts = np.arange(61)
    largest = np.array([one_sided_upper_bound(int(count), 60) for count in counts])
    chances = stats.binom.pmf(counts, 60, SHARES[:, None])
    assert np.sum(chances * (SHARES[:, None] <= largest), axis=1).min() >= 0.95


@pytest.mark.parametrize("count", [30, 100, 1000])
def test_zero_successes_give_the_rule_of_three(count):
    high = one_sided_upper_bound(0, count)
    assert high == pytest.approx(3 / count, rel=0.06)
    # proportion for which zero successes have a probability of one in twenty
    assert (1 - high) ** count == pytest.approx(0.05)


def test_no_samples_give_the_interval_from_zero_to_one():
    assert binomial_interval(0, 0) == (0.0, 1.0)
    assert one_sided_upper_bound(0, 0) == 1.0
