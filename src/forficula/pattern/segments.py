"""Straight lines in a plane: which of them cross, and which points lie on them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

_CHUNK = 2_000_000  # pairs of boxes that are compared at a time


def crossings(
    starts: NDArray[np.float64], ends: NDArray[np.float64], margin: float
) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Find the segments that cross inside, away from their ends.

    Args:
        starts: m, shape (S, 2).
        ends: m, shape (S, 2).
        margin: how far, in m, both ends of a segment must lie beside the line of the other, on two sides.

    Returns:
        Numbers of two segments, the lower first, shape (K, 2), and where they cross, m, shape (K, 2).
    """
    low, high = np.minimum(starts, ends), np.maximum(starts, ends)
    pairs = boxes_that_meet(low, high, low, high)
    pairs = pairs[pairs[:, 0] < pairs[:, 1]]
    first, second = pairs.T
    here, there = ends[first] - starts[first], ends[second] - starts[second]
    between = starts[second] - starts[first]
    with np.errstate(divide="ignore", invalid="ignore"):
        # how far the ends of one lie to the left of the line of the other
        second_starts, second_ends = (_cross(here, way) / _length(here) for way in (between, between + there))
        first_starts, first_ends = (_cross(there, way) / _length(there) for way in (-between, here - between))
    crossing = _apart(second_starts, second_ends, margin) & _apart(first_starts, first_ends, margin)
    from_start, from_end = first_starts[crossing], first_ends[crossing]
    share = from_start / (from_start - from_end)
    return pairs[crossing], starts[first[crossing]] + share[:, np.newaxis] * here[crossing]


def points_on_segments(
    points: NDArray[np.float64], starts: NDArray[np.float64], ends: NDArray[np.float64], tolerance: float
) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Find the points that lie on a segment, further than the tolerance from its ends.

    Args:
        points: m, shape (P, 2).
        starts: m, shape (S, 2).
        ends: m, shape (S, 2).
        tolerance: how far beside a segment a point still lies on it, m.

    Returns:
        Numbers of a point and of a segment, shape (K, 2), and how far beside it the point lies, m, shape (K,).
    """
    low, high = np.minimum(starts, ends) - tolerance, np.maximum(starts, ends) + tolerance
    pairs = boxes_that_meet(points, points, low, high)
    point, segment = pairs.T
    along, way = ends[segment] - starts[segment], points[point] - starts[segment]
    length = _length(along)
    with np.errstate(divide="ignore", invalid="ignore"):
        beside = np.abs(_cross(along, way)) / length
    on = (beside <= tolerance) & (_length(way) > tolerance) & (_length(way - along) > tolerance)
    return pairs[on], beside[on]


def boxes_that_meet(
    low: NDArray[np.float64],
    high: NDArray[np.float64],
    other_low: NDArray[np.float64],
    other_high: NDArray[np.float64],
) -> NDArray[np.int64]:
    """Find the boxes of one list that touch those of another.

    Args:
        low: lower corners, m, shape (A, 2).
        high: upper corners, m, shape (A, 2).
        other_low: lower corners of the others, m, shape (B, 2).
        other_high: upper corners of the others, m, shape (B, 2).

    Returns:
        Number in the first and in the second list, shape (K, 2), in increasing order.
    """
    rows = max(1, _CHUNK // max(1, len(other_low)))
    found = []
    for first in range(0, len(low), rows):
        part_low, part_high = low[first : first + rows, np.newaxis], high[first : first + rows, np.newaxis]
        meet = np.ones((len(part_low), len(other_low)), dtype=bool)
        for axis in (0, 1):
            meet &= (part_low[..., axis] <= other_high[:, axis]) & (other_low[:, axis] <= part_high[..., axis])
        found.append(np.argwhere(meet) + np.array([first, 0]))
    return np.concatenate(found) if found else np.empty((0, 2), dtype=np.int64)


def _cross(one: NDArray[np.float64], other: NDArray[np.float64]) -> NDArray[np.float64]:
    product: NDArray[np.float64] = one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]
    return product


def _length(vectors: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray(np.hypot(vectors[:, 0], vectors[:, 1]))


def _apart(one: NDArray[np.float64], other: NDArray[np.float64], margin: float) -> NDArray[np.bool_]:
    """Whether two distances from a line are on two sides of it."""
    sides: NDArray[np.bool_] = (np.minimum(np.abs(one), np.abs(other)) > margin) & (one * other < 0)
    return sides
