"""Points of the unit cube for what is counted, and has an interval: even along every axis, independent between them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

# a share of 0 or 1 is an infinite deviation of a normal law
_EDGE = 2.0**-33


def latin_points(columns: int, count: int, seed: int) -> NDArray[np.float64]:
    """Draw a Latin hypercube whose halves, quarters and so on, from the first row on, are ones, too.

    The rows so far leave one of two halves of every part of an axis empty; the next ones fill these, in an order that
    is drawn anew for every axis. Of a Latin hypercube a count scatters hardly more than of independent points, whatever
    decides it (Owen 1997, doi:10.1137/S0036142994277468: by at most n / (n - 1)), so that intervals made for these
    hold. Few points of a Sobol sequence in many dimensions have axes that go together, and intervals that do not hold:
    of 64 in 21 dimensions, some by a correlation of 0.7.

    Args:
        columns: axes.
        count: rows, a power of two.
        seed: of the draw. The first rows are the same, however many there are.

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
