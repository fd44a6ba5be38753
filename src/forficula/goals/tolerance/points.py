"""Points in the unit cube at which deviated designs are run: two samples, and one with columns of the other."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from forficula.goals.latin_points import latin_points

Points = NDArray[np.float64]


def two_samples(factors: int, count: int, seed: int) -> tuple[Points, Points]:
    """Two samples of the unit cube that are independent of one another, row by row.

    They are the halves of one Latin hypercube of twice as many columns. The first rows are the same, however many there
    are.

    Args:
        factors: columns of each.
        count: rows, a power of two, which keeps them balanced.
        seed: of the draw.

    Returns:
        Both, (count, factors), above 0 and below 1.
    """
    drawn = latin_points(2 * factors, count, seed)
    return drawn[:, :factors], drawn[:, factors:]


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
