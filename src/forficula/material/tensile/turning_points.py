"""Where a signal turns back."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def turning_points(signal: NDArray[np.float64], band: float) -> list[int]:
    """Find the extremes between which a signal moves by more than a band.

    The hysteresis filter of rainflow counting (ASTM E1049): an extreme counts once the signal has come back from it by
    more than the band. The first and the last extreme are those of the rest before and after.

    Args:
        signal: shape (sample,).
        band: in the signal's unit, >= 0.

    Returns:
        Samples of valleys and peaks in turn, in order; fewer than two where the signal stays within the band.
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
