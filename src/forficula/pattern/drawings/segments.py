"""Line segments in a plane: crossings, and points on segments."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from forficula.arrays import Array, Flags, Indices

_CHUNK = 2_000_000  # number of pairs of boxes that are compared at a time
_FEW = 10_000  # largest number of pairs of boxes that are compared without a grid
_MOST_CELLS = 8  # largest average number of cells that a box overlaps


def crossings(starts: Array, ends: Array, margin: float) -> tuple[Indices, Array]:
    """Find the segments that cross away from their ends.

    Args:
        starts: m, shape (S, 2).
        ends: m, shape (S, 2).
        margin: least distance of both ends of a segment from the line of the other, on opposite sides, m.

    Returns:
        Numbers of two segments, the lower first, shape (K, 2), and the positions of the crossings, m, shape (K, 2).
    """
    low, high = np.minimum(starts, ends), np.maximum(starts, ends)
    pairs = boxes_that_meet(low, high, low, high)
    pairs = pairs[pairs[:, 0] < pairs[:, 1]]
    first, second = pairs.T
    along_first, along_second = ends[first] - starts[first], ends[second] - starts[second]
    between = starts[second] - starts[first]
    with np.errstate(divide="ignore", invalid="ignore"):
        # distances of the ends of one segment to the left of the line of the other
        second_starts, second_ends = (
            _cross(along_first, offset) / _length(along_first) for offset in (between, between + along_second)
        )
        first_starts, first_ends = (
            _cross(along_second, offset) / _length(along_second) for offset in (-between, along_first - between)
        )
    crossing = _apart(second_starts, second_ends, margin) & _apart(first_starts, first_ends, margin)
    from_start, from_end = first_starts[crossing], first_ends[crossing]
    share = from_start / (from_start - from_end)
    return pairs[crossing], starts[first[crossing]] + share[:, np.newaxis] * along_first[crossing]


def points_on_segments(points: Array, starts: Array, ends: Array, tolerance: float) -> tuple[Indices, Array]:
    """Find the points that lie on a segment, further than the tolerance from its ends.

    Args:
        points: m, shape (P, 2).
        starts: m, shape (S, 2).
        ends: m, shape (S, 2).
        tolerance: largest distance of a point on a segment from the segment, m.

    Returns:
        Numbers of a point and of a segment, shape (K, 2), and the distance of the point from the segment, m, shape
        (K,).
    """
    low, high = np.minimum(starts, ends) - tolerance, np.maximum(starts, ends) + tolerance
    pairs = boxes_that_meet(points, points, low, high)
    point, segment = pairs.T
    along, offset = ends[segment] - starts[segment], points[point] - starts[segment]
    length = _length(along)
    with np.errstate(divide="ignore", invalid="ignore"):
        beside = np.abs(_cross(along, offset)) / length
    on = (beside <= tolerance) & (_length(offset) > tolerance) & (_length(offset - along) > tolerance)
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
        Indices in the first and in the second list, shape (K, 2), in increasing order.
    """
    if len(low) * len(other_low) <= _FEW:
        meet = (low[:, np.newaxis] <= other_high) & (other_low <= high[:, np.newaxis])
        return np.argwhere(meet.all(axis=2))
    # only boxes with a common cell of a grid are compared, n log n operations for boxes side by side
    (cells, boxes), (other_cells, others) = _cells_of_boxes([(low, high), (other_low, other_high)])
    first, last = (np.searchsorted(other_cells, cells, side) for side in ("left", "right"))
    ends = np.cumsum(last - first)
    meeting = []
    start = 0
    while start < len(cells):
        # in parts, to limit the memory
        stop = max(start + 1, int(np.searchsorted(ends, _CHUNK + (ends[start - 1] if start else 0), "right")))
        counts = (last - first)[start:stop]
        box = np.repeat(boxes[start:stop], counts)
        steps = np.arange(len(box)) - np.repeat(np.cumsum(counts) - counts, counts)
        other = others[np.repeat(first[start:stop], counts) + steps]
        meet = ((low[box] <= other_high[other]) & (other_low[other] <= high[box])).all(axis=1)
        meeting.append(box[meet] * len(other_low) + other[meet])
        start = stop
    # two boxes may share several cells
    return np.column_stack(np.divmod(np.unique(np.concatenate(meeting)), len(other_low)))


def _cells_of_boxes(lists: Sequence[tuple[Array, Array]]) -> list[tuple[Indices, Indices]]:
    """Find the cells of a grid that boxes overlap.

    Args:
        lists: lower and upper corners of boxes, m, each of shape (A, 2).

    Returns:
        For each list the cells in increasing order, shape (C,), and the boxes that overlap them, shape (C,).
    """
    corners = np.concatenate([corner for corner_pair in lists for corner in corner_pair])
    origin, size = corners.min(axis=0), np.ptp(corners, axis=0)
    divisions = max(1, math.isqrt(max(len(low) for low, _ in lists)))
    while True:
        # a monotonic function, so that boxes that touch share a cell regardless of rounding
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
    cells_and_boxes = []
    for (low, _), span in zip(ranges, spans, strict=True):
        counts = span.prod(axis=1)
        box = np.repeat(np.arange(len(low)), counts)
        across, upwards = np.divmod(np.arange(len(box)) - np.repeat(np.cumsum(counts) - counts, counts), span[box, 1])
        cells = (low[box, 0] + across) * divisions + low[box, 1] + upwards
        order = np.argsort(cells, kind="stable")
        cells_and_boxes.append((cells[order], box[order]))
    return cells_and_boxes


def _cross(one: Array, other: Array) -> Array:
    product: Array = one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]
    return product


def _length(vectors: Array) -> Array:
    return np.asarray(np.hypot(vectors[:, 0], vectors[:, 1]))


def _apart(one: Array, other: Array, margin: float) -> Flags:
    """Return whether two signed distances from a line are on opposite sides, further than a margin."""
    sides: Flags = (np.minimum(np.abs(one), np.abs(other)) > margin) & (one * other < 0)
    return sides
