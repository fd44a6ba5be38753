"""Turning points of a signal."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def turning_points(signal: NDArray[np.float64], band: float) -> list[int]:
    """Find the extremes of a signal that differ by more than a band.

    This is the hysteresis filter of rainflow counting (ASTM E1049): an extreme counts if the signal then returns by
    more than the band. The first and the last extreme are those of the remaining signal before and after.

    Args:
        signal: shape (sample,).
        band: width of the band in the signal's unit, >= 0.

    Returns:
        Indices of alternating valleys and peaks, in order; fewer than two if the signal stays within the band.
    """
    values = signal.tolist()
    low = high = 0
    turns: list[int] = []
    rising: bool | None = None
    for sample, value in enumerate(values):
        if rising is not False and value > values[high]:
            high = sample
        if rising is not True and value < values[low]:
            low = sample
        if rising is not True and value - values[low] > band:
            turns.append(low)
            rising, high = True, sample
        elif rising is not False and values[high] - value > band:
            turns.append(high)
            rising, low = False, sample
    if rising is None:
        return []
    return [*turns, high if rising else low]
