"""Coverage of binomial intervals, computed from the binomial distribution."""

import numpy as np
import pytest
from scipy import stats

from forficula.goals.share_interval import largest_share, share_interval

SHARES = np.linspace(0.0005, 0.9995, 1000)


@pytest.mark.parametrize("count", [16, 60, 256])
def test_intervals_of_all_proportions_have_at_least_their_nominal_coverage(count):
    counts = np.arange(count + 1)
    low, high = np.array([share_interval(int(each), count) for each in counts]).T
    chances = stats.binom.pmf(counts, count, SHARES[:, None])
    assert np.sum(chances * ((low <= SHARES[:, None]) & (SHARES[:, None] <= high)), axis=1).min() >= 0.95


def test_one_sided_bound_is_exceeded_in_at_most_one_of_twenty_cases():
    counts = np.arange(61)
    largest = np.array([largest_share(int(each), 60) for each in counts])
    chances = stats.binom.pmf(counts, 60, SHARES[:, None])
    assert np.sum(chances * (SHARES[:, None] <= largest), axis=1).min() >= 0.95


@pytest.mark.parametrize("count", [30, 100, 1000])
def test_zero_successes_give_the_rule_of_three(count):
    high = largest_share(0, count)
    assert high == pytest.approx(3 / count, rel=0.06)
    # proportion for which zero successes have a probability of one in twenty
    assert (1 - high) ** count == pytest.approx(0.05)


def test_no_samples_give_the_interval_from_zero_to_one():
    assert share_interval(0, 0) == (0.0, 1.0)
    assert largest_share(0, 0) == 1.0
