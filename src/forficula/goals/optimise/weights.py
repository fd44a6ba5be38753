"""Directions in which a front is looked for, evenly over it."""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import NDArray

# Parts of each side, by the number of objectives: 17 and 28 directions.
_PARTS = {1: 1, 2: 16, 3: 6}
# No objective is ever quite without weight, so that it is not given away for nothing.
_LEAST = 0.01


def aim_weights(objectives: int) -> NDArray[np.float64]:
    """Weights of objectives, one row an aim; the ends first, then those in between in an order that leaps.

    Das and Dennis, 1998, doi.org/10.1137/S1052623496307510. The least greatest weighted objective lies along the
    direction of the inverse weights.

    Args:
        objectives: 1, 2 or 3.
    """
    parts = _PARTS[objectives]
    shares = [
        np.array(each) / parts for each in itertools.product(range(parts + 1), repeat=objectives) if sum(each) == parts
    ]
    ends = [share for share in shares if share.max() == 1]
    others = [share for share in shares if share.max() < 1]
    leaping = sorted(range(len(others)), key=lambda number: (number * 7) % max(len(others), 1))
    directions = np.maximum(np.array(ends + [others[number] for number in leaping]), _LEAST)
    weights = 1 / directions
    return np.asarray(weights / weights.max(axis=1, keepdims=True))
