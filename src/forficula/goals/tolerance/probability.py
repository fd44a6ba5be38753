"""Probability that a design works, from runs of deviated ones: a share and its interval."""

from __future__ import annotations

from dataclasses import dataclass

import scipy

from forficula.goals.share_interval import LEVEL, share_interval


@dataclass(frozen=True, kw_only=True)
class Probability:
    """How likely it is that something holds.

    Attributes:
        works: runs in which it holds.
        fails: runs in which it does not.
        unknown: runs that tell nothing, for they are not to be trusted.
        share: of the runs that tell, those in which it holds; None where none tells.
        low: lower end of the 95 % interval, with every run that tells nothing counted as one that fails.
        high: upper end, with every such run counted as one that works.
    """

    works: int
    fails: int
    unknown: int
    share: float | None
    low: float
    high: float

    @property
    def count(self) -> int:
        """All runs, those that tell nothing among them."""
        return self.works + self.fails + self.unknown


def probability(works: int, fails: int, unknown: int = 0) -> Probability:
    """Estimate a probability from runs at random points.

    The interval is the exact one of `share_interval`: of independent points it
    holds the probability at least 95 times in 100, however near to 0 or 1 that is, where Wilson's does so only on
    average. Points of a Latin hypercube scatter hardly more than independent ones, and mostly less (Owen 1997,
    doi:10.1137/S0036142994277468), so that it mostly holds more often still. Runs that tell nothing widen it by all
    they could be.

    Args:
        works: runs in which it holds.
        fails: runs in which it does not.
        unknown: runs that tell nothing.

    Raises:
        ValueError: no runs at all, or a negative number of them.
    """
    count = works + fails + unknown
    if min(works, fails, unknown) < 0 or count == 0:
        raise ValueError(f"need runs, got {works} that work, {fails} that fail, {unknown} that tell nothing")
    told = works + fails
    return Probability(
        works=works,
        fails=fails,
        unknown=unknown,
        share=works / told if told else None,
        low=share_interval(works, count)[0],
        high=share_interval(works + unknown, count)[1],
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
