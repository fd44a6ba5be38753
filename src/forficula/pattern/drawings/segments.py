"""Straight lines in a plane: which of them cross, and which points lie on them."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from forficula.arrays import Array, Flags, Indices

_CHUNK = 2_000_000  # pairs of boxes that are compared at a time
_FEW = 10_000  # pairs of boxes that are compared without a grid
_MOST_CELLS = 8  # a box reaches into, on average


def crossings(starts: Array, ends: Array, margin: float) -> tuple[Indices, Array]:
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


def points_on_segments(points: Array, starts: Array, ends: Array, tolerance: float) -> tuple[Indices, Array]:
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
    low: Array,
    high: Array,
    other_low: Array,
    other_high: Array,
) -> Indices:
    """Find the boxes of one list that touch those of another.

    Args:
        low: lower corners, m, shape (A, 2).
        high: upper corners, m, shape (A, 2).
        other_low: lower corners of the others, m, shape (B, 2).
        other_high: upper corners of the others, m, shape (B, 2).

    Returns:
        Number in the first and in the second list, shape (K, 2), in increasing order.
    """
    if len(low) * len(other_low) <= _FEW:
        meet = (low[:, np.newaxis] <= other_high) & (other_low <= high[:, np.newaxis])
        return np.argwhere(meet.all(axis=2))
    # boxes that meet share a cell of a grid: only those are compared, n log n where they lie side by side
    (cells, boxes), (other_cells, others) = _cells_of_boxes([(low, high), (other_low, other_high)])
    first, last = (np.searchsorted(other_cells, cells, side) for side in ("left", "right"))
    ends = np.cumsum(last - first)
    found = []
    start = 0
    while start < len(cells):
        # in parts, which a computer's memory holds whatever the boxes
        stop = max(start + 1, int(np.searchsorted(ends, _CHUNK + (ends[start - 1] if start else 0), "right")))
        counts = (last - first)[start:stop]
        box = np.repeat(boxes[start:stop], counts)
        steps = np.arange(len(box)) - np.repeat(np.cumsum(counts) - counts, counts)
        other = others[np.repeat(first[start:stop], counts) + steps]
        meet = ((low[box] <= other_high[other]) & (other_low[other] <= high[box])).all(axis=1)
        found.append(box[meet] * len(other_low) + other[meet])
        start = stop
    # two boxes may share several cells
    return np.column_stack(np.divmod(np.unique(np.concatenate(found)), len(other_low)))


def _cells_of_boxes(lists: Sequence[tuple[Array, Array]]) -> list[tuple[Indices, Indices]]:
    """Find the cells of a grid that boxes reach into.

    Args:
        lists: lower and upper corners of boxes, m, each of shape (A, 2).

    Returns:
        For each list the cells in increasing order, shape (C,), and the boxes that reach into them, shape (C,).
    """
    corners = np.concatenate([corner for corner_pair in lists for corner in corner_pair])
    origin, size = corners.min(axis=0), np.ptp(corners, axis=0)
    divisions = max(1, math.isqrt(max(len(low) for low, _ in lists)))
    while True:
        # a function that never falls: boxes that touch share a cell, whatever is rounded
        scale = np.divide(divisions, size, out=np.zeros(2), where=size > 0)
        ranges = [
            [np.clip(((corner - origin) * scale).astype(np.int64), 0, divisions - 1) for corner in pair]
            for pair in lists
        ]
        spans = [high - low + 1 for low, high in ranges]
        reached = sum(int(span.prod(axis=1).sum()) for span in spans)
        if divisions == 1 or reached <= _MOST_CELLS * sum(map(len, spans)):
            break
        divisions //= 2
    found = []
    for (low, _), span in zip(ranges, spans, strict=True):
        counts = span.prod(axis=1)
        box = np.repeat(np.arange(len(low)), counts)
        across, upwards = np.divmod(np.arange(len(box)) - np.repeat(np.cumsum(counts) - counts, counts), span[box, 1])
        cells = (low[box, 0] + across) * divisions + low[box, 1] + upwards
        order = np.argsort(cells, kind="stable")
        found.append((cells[order], box[order]))
    return found


def _cross(one: Array, other: Array) -> Array:
    product: Array = one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]
    return product


def _length(vectors: Array) -> Array:
    return np.asarray(np.hypot(vectors[:, 0], vectors[:, 1]))


def _apart(one: Array, other: Array, margin: float) -> Flags:
    """Whether two distances from a line are on two sides of it."""
    sides: Flags = (np.minimum(np.abs(one), np.abs(other)) > margin) & (one * other < 0)
    return sides
