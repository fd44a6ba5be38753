"""Shares that are counted: which share of all may be so, where so many of a few are."""

from __future__ import annotations

from scipy import stats

LEVEL = 0.95


def share_interval(count: int, of: int) -> tuple[float, float]:
    """The exact two-sided 95 % interval of a share (Clopper and Pearson 1934, doi:10.1093/biomet/26.4.404).

    Args:
        count: how many of them it holds of.
        of: how many there are; of none the share may be anything.
    """
    if of == 0:
        return 0.0, 1.0
    found = stats.binomtest(count, of).proportion_ci(confidence_level=LEVEL, method="exact")
    return float(found.low), float(found.high)


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
    found = stats.binomtest(count, of, alternative="less").proportion_ci(confidence_level=LEVEL, method="exact")
    return float(found.high)
