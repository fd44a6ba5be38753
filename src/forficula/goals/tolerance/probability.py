"""Probability that a design works, with its confidence interval, from runs of deviating designs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import scipy

from forficula.goals.binomial_interval import LEVEL, binomial_interval
from forficula.serial import Key, Written


@dataclass(frozen=True, kw_only=True)
class Probability:
    """Probability of a property, estimated from runs.

    Attributes:
        works: number of runs with the property.
        fails: number of runs without it.
        unknown: number of inconclusive runs, because they are unreliable.
        undecided: number of runs whose verdict differs at half the timestep.
        share: fraction of the conclusive runs that have the property; None without conclusive runs.
        low: lower end of the 95 % interval, with every inconclusive or undecided run counted as a failure.
        high: upper end, with every such run counted as a success.
    """

    works: int
    fails: int
    unknown: int
    share: Annotated[float | None, Key("probability")]
    low: float
    high: float
    undecided: Annotated[int, Written.NEVER] = 0

    @property
    def count(self) -> int:
        """Number of all runs, including inconclusive and undecided ones."""
        return self.works + self.fails + self.unknown + self.undecided


def interval_both_ways(works: int, fails: int, undecided: int) -> tuple[float, float]:
    """Compute the 95 % interval of a probability for every possible outcome of undecided runs.

    The lower end is that of `binomial_interval` if all undecided runs fail, the upper end that if all of them succeed.

    Args:
        works: number of runs with the property.
        fails: number of runs without it.
        undecided: number of runs that could be either.

    Raises:
        ValueError: no runs at all, or a negative number of them.
    """
    count = works + fails + undecided
    if min(works, fails, undecided) < 0 or count == 0:
        raise ValueError(f"need runs, got {works} that work, {fails} that fail, {undecided} that are undecided")
    return binomial_interval(works, count)[0], binomial_interval(works + undecided, count)[1]


def probability(works: int, fails: int, unknown: int = 0, undecided: int = 0) -> Probability:
    """Estimate a probability from runs at random points.

    The interval is the exact one of `binomial_interval`. For independent points it contains the probability in at least
    95 of 100 cases, even near 0 or 1, whereas Wilson's interval does so only on average. Points of a Latin hypercube
    scatter hardly more than independent ones, and mostly less (Owen 1997, doi:10.1137/S0036142994277468), so the
    coverage is mostly higher. Inconclusive and undecided runs widen the interval by all that they could be
    (`interval_both_ways`).

    Args:
        works: number of runs with the property.
        fails: number of runs without it.
        unknown: number of inconclusive runs.
        undecided: number of runs whose verdict differs at half the timestep.

    Raises:
        ValueError: no runs at all, or a negative number of them.
    """
    if min(unknown, undecided) < 0:
        raise ValueError(f"need runs >= 0, got {unknown} without a result and {undecided} undecided")
    low, high = interval_both_ways(works, fails, unknown + undecided)
    conclusive = works + fails
    return Probability(
        works=works,
        fails=fails,
        unknown=unknown,
        undecided=undecided,
        share=works / conclusive if conclusive else None,
        low=low,
        high=high,
    )


def surely_less(one: Probability, other: Probability, looks: int) -> bool:
    """Return whether one probability is significantly less than another, by Fisher's exact test.

    Args:
        one: estimate from some samples.
        other: estimate from other samples.
        looks: number of compared pairs. In total, at most 5 in 100 tests are significant by chance.
    """
    counts = [[one.works, one.fails], [other.works, other.fails]]
    return bool(scipy.stats.fisher_exact(counts, alternative="less").pvalue < (1 - LEVEL) / looks)
