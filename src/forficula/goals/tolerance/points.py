"""Points in the unit cube at which deviated designs are run: two samples, and one with columns of the other."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy import stats

Points = NDArray[np.float64]

# a share of 0 or 1 is an infinite deviation of a normal law
_EDGE = 2.0**-33


def two_samples(factors: int, count: int, seed: int) -> tuple[Points, Points]:
    """Two samples of the unit cube that are independent of one another, row by row.

    They are the halves of one scrambled Sobol sequence of twice as many columns (Saltelli et al. 2010,
    doi:10.1016/j.cpc.2009.09.018, section 5). The first rows are the same, however many there are.

    Args:
        factors: columns of each.
        count: rows, a power of two, which keeps them balanced.
        seed: of the scrambling.

    Returns:
        Both, (count, factors), above 0 and below 1.
    """
    power = count.bit_length() - 1
    if count != 2**power:
        raise ValueError(f"need a power of two, got {count} points")
    drawn = stats.qmc.Sobol(2 * factors, rng=np.random.default_rng(seed)).random_base2(power)
    inside = np.clip(drawn, _EDGE, 1 - _EDGE)
    return inside[:, :factors], inside[:, factors:]


def exchanged(first: Points, second: Points, columns: Sequence[int]) -> Points:
    """The first sample with some columns of the second.

    Args:
        first: (count, factors).
        second: as the first.
        columns: of one factor, or of a group.

    Returns:
        (count, factors).
    """
    mixed = first.copy()
    mixed[:, list(columns)] = second[:, list(columns)]
    return mixed
