"""Confidence intervals of proportions."""

from __future__ import annotations

import scipy

LEVEL = 0.95


def binomial_interval(count: int, of: int, looks: int = 1) -> tuple[float, float]:
    """Return the exact two-sided 95 % interval of a proportion (Clopper and Pearson 1934, doi:10.1093/biomet/26.4.404).

    Args:
        count: number of successes.
        of: number of trials; with none, the interval is [0, 1].
        looks: number of proportions from which this one was selected by its value. The interval is widened so that all
            of them together hold in 95 of 100 cases (Bonferroni).
    """
    if of == 0:
        return 0.0, 1.0
    tail = (1 - LEVEL) / looks / 2
    # proportions for which this many successes or more, or this many or fewer, have the tail probability
    low = float(scipy.special.betaincinv(count, of - count + 1, tail)) if count else 0.0
    return low, _least_above(count, of, tail)


def one_sided_upper_bound(count: int, of: int) -> float:
    """Return the upper end of the one-sided 95 % interval; for 0 successes 1 - 0.05^(1/n), about 3/n (rule of three).

    Hanley and Lippman-Hand 1983, doi:10.1001/jama.1983.03330370053031. It is not an end of `binomial_interval`: a
    two-sided interval with this upper end would hold in fewer than 95 of 100 cases.

    Args:
        count: number of successes.
        of: number of trials; with none, 1 is returned.
    """
    if of == 0:
        return 1.0
    return _least_above(count, of, 1 - LEVEL)


def _least_above(count: int, of: int, chance: float) -> float:
    """Return the proportion for which this many successes or fewer have this probability; 1 if all are successes."""
    return float(scipy.special.betainccinv(count + 1, of - count, chance)) if count < of else 1.0
