"""How often the intervals of shares hold them, by the binomial distribution itself."""

import numpy as np
import pytest
from scipy import stats

from forficula.goals.share_interval import largest_share, share_interval

SHARES = np.linspace(0.0005, 0.9995, 1000)


@pytest.mark.parametrize("count", [16, 60, 256])
def test_intervals_of_all_shares_hold_them_at_least_as_often_as_they_say(count):
    counts = np.arange(count + 1)
    low, high = np.array([share_interval(int(each), count) for each in counts]).T
    chances = stats.binom.pmf(counts, count, SHARES[:, None])
    assert np.sum(chances * ((low <= SHARES[:, None]) & (SHARES[:, None] <= high)), axis=1).min() >= 0.95


def test_no_share_is_above_the_largest_one_more_often_than_in_one_of_twenty():
    counts = np.arange(61)
    largest = np.array([largest_share(int(each), 60) for each in counts])
    chances = stats.binom.pmf(counts, 60, SHARES[:, None])
    assert np.sum(chances * (SHARES[:, None] <= largest), axis=1).min() >= 0.95


@pytest.mark.parametrize("count", [30, 100, 1000])
def test_of_none_at_all_the_share_is_below_three_by_the_samples(count):
    high = largest_share(0, count)
    assert high == pytest.approx(3 / count, rel=0.06)
    # the largest share of which none at all comes in one of twenty
    assert (1 - high) ** count == pytest.approx(0.05)


def test_of_no_samples_a_share_may_be_anything():
    assert share_interval(0, 0) == (0.0, 1.0)
    assert largest_share(0, 0) == 1.0
