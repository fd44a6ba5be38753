"""Shares that are counted: which share of all may be so, where so many of a few are."""

from __future__ import annotations

import scipy

LEVEL = 0.95


def share_interval(count: int, of: int, looks: int = 1) -> tuple[float, float]:
    """The exact two-sided 95 % interval of a share (Clopper and Pearson 1934, doi:10.1093/biomet/26.4.404).

    Args:
        count: how many of them it holds of.
        of: how many there are; of none the share may be anything.
        looks: out of how many shares this one was chosen for what it is: the interval is so much wider that all of
            theirs hold together 95 times in 100 (Bonferroni).
    """
    if of == 0:
        return 0.0, 1.0
    beyond = (1 - LEVEL) / looks / 2
    # the shares of which so many or more, and so few or fewer, come that seldom: quantiles of beta distributions
    low = float(scipy.special.betaincinv(count, of - count + 1, beyond)) if count else 0.0
    return low, _least_above(count, of, beyond)


def largest_share(count: int, of: int) -> float:
    """The upper end at a one-sided 95 %: where none is counted 1 - 0.05^(1/n), about 3/n, the rule of three.

    Hanley and Lippman-Hand 1983, doi:10.1001/jama.1983.03330370053031. It is no end of `share_interval`: an interval
    that took it at its ends, and halves of what is left elsewhere, would not hold 95 times in 100.

    Args:
        count: how many of them it holds of.
        of: how many there are; of none the share may be anything.
    """
    if of == 0:
        return 1.0
    return _least_above(count, of, 1 - LEVEL)


def _least_above(count: int, of: int, chance: float) -> float:
    """The share of which so few or fewer come with that chance; 1 where all are counted."""
    return float(scipy.special.betainccinv(count + 1, of - count, chance)) if count < of else 1.0
