"""Points of the unit cube for counting with intervals: stratified along every axis, independent between axes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

# 0 and 1 would give infinite deviations of a normal distribution
_EDGE = 2.0**-33


def latin_points(columns: int, count: int, seed: int) -> NDArray[np.float64]:
    """Draw a Latin hypercube whose first half, first quarter and so on are Latin hypercubes, too.

    The first half leaves one of two halves of every interval of an axis empty. The second half fills these, in an order
    that is drawn for every axis. A count over a Latin hypercube scatters hardly more than over independent points,
    whatever the counted property is (Owen 1997, doi:10.1137/S0036142994277468: at most by n / (n - 1)), so intervals
    for independent points are valid. A short Sobol sequence in many dimensions has correlated axes and invalid
    intervals: among 64 points in 21 dimensions, some correlations are 0.7.

    Args:
        columns: number of axes.
        count: number of rows, a power of two.
        seed: seed of the draw. The first rows do not depend on the count.

    Returns:
        (count, columns), above 0 and below 1.

    Raises:
        ValueError: a count that is no power of two.
    """
    if count < 1 or count & (count - 1):
        raise ValueError(f"need a power of two, got {count} points")
    generator = np.random.default_rng(seed)
    points = generator.random((1, columns))
    while len(points) < count:
        parts = 2 * len(points)
        empty = np.floor(points * parts).astype(int) ^ 1
        points = np.concatenate([points, (generator.permuted(empty, axis=0) + generator.random(empty.shape)) / parts])
    return np.clip(points, _EDGE, 1 - _EDGE)
