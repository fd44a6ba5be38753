"""Probability that a design works, from runs of deviated ones: a share and its interval."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import scipy

from forficula.goals.share_interval import LEVEL, share_interval
from forficula.serial import Key, Written


@dataclass(frozen=True, kw_only=True)
class Probability:
    """How likely it is that something holds.

    Attributes:
        works: runs in which it holds.
        fails: runs in which it does not.
        unknown: runs that tell nothing, for they are not to be trusted.
        undecided: runs whose verdict differs at half the timestep.
        share: of the runs that tell, those in which it holds; None where none tells.
        low: lower end of the 95 % interval, with every run that tells nothing or is undecided counted as one that
            fails.
        high: upper end, with every such run counted as one that works.
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
        """All runs, those that tell nothing and undecided ones among them."""
        return self.works + self.fails + self.unknown + self.undecided


def interval_both_ways(works: int, fails: int, undecided: int) -> tuple[float, float]:
    """Compute the 95 % interval of a probability that holds whichever way undecided runs go.

    The lower end is that of `share_interval` with all undecided runs failing, the upper end that with all working.

    Args:
        works: runs in which it holds.
        fails: runs in which it does not.
        undecided: runs that leave it open.

    Raises:
        ValueError: no runs at all, or a negative number of them.
    """
    count = works + fails + undecided
    if min(works, fails, undecided) < 0 or count == 0:
        raise ValueError(f"need runs, got {works} that work, {fails} that fail, {undecided} that are undecided")
    return share_interval(works, count)[0], share_interval(works + undecided, count)[1]


def probability(works: int, fails: int, unknown: int = 0, undecided: int = 0) -> Probability:
    """Estimate a probability from runs at random points.

    The interval is the exact one of `share_interval`: of independent points it
    holds the probability at least 95 times in 100, however near to 0 or 1 that is, where Wilson's does so only on
    average. Points of a Latin hypercube scatter hardly more than independent ones, and mostly less (Owen 1997,
    doi:10.1137/S0036142994277468), so that it mostly holds more often still. Runs that tell nothing, and those
    that are undecided, widen it by all they could be (`interval_both_ways`).

    Args:
        works: runs in which it holds.
        fails: runs in which it does not.
        unknown: runs that tell nothing.
        undecided: runs whose verdict differs at half the timestep.

    Raises:
        ValueError: no runs at all, or a negative number of them.
    """
    if min(unknown, undecided) < 0:
        raise ValueError(f"need runs >= 0, got {unknown} without a result and {undecided} undecided")
    low, high = interval_both_ways(works, fails, unknown + undecided)
    told = works + fails
    return Probability(
        works=works,
        fails=fails,
        unknown=unknown,
        undecided=undecided,
        share=works / told if told else None,
        low=low,
        high=high,
    )


def surely_less(one: Probability, other: Probability, looks: int) -> bool:
    """Whether one is less than another beyond chance, by Fisher's exact test.

    Args:
        one: from some samples.
        other: from others.
        looks: how many such pairs are looked at, of which in all no more than 5 in 100 may differ by chance.
    """
    counts = [[one.works, one.fails], [other.works, other.fails]]
    return bool(scipy.stats.fisher_exact(counts, alternative="less").pvalue < (1 - LEVEL) / looks)
