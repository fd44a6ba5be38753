"""Rows of a motion between which linear interpolation is accurate."""

from __future__ import annotations

from collections.abc import Iterable
from heapq import heappop, heappush
from itertools import pairwise

import numpy as np

from forficula.arrays import Array, Indices


def kept_frames(time: Array, points: Array, moments: Iterable[float], *, most: int, tolerance: float) -> Indices:
    """Choose rows between which interpolation follows the record.

    The rows nearest to the moments, the first and the last row are kept. Then the row with the largest distance from
    the interpolation between its neighbours is added (Douglas and Peucker 1973, with time
    as the line's parameter), until no distance exceeds the tolerance or there are enough rows.

    Args:
        time: s, (time,).
        points: m, (time, point, 3); rows that are not finite as 4-byte floats are left out.
        moments: times to keep, s.
        most: number of rows; exceeded only if there are more moments.
        tolerance: distance that is not visible, m.

    Returns:
        Rows, rising, (kept,).
    """
    with np.errstate(over="ignore"):
        sound = np.flatnonzero(np.isfinite(points.astype(np.float32)).all(axis=(1, 2)))
    if not len(sound):
        return sound
    time, points = time[sound], points[sound]
    kept = {int(np.argmin(np.abs(time - moment))) for moment in moments} | {0, len(sound) - 1}
    gaps: list[tuple[float, int, int, int]] = []
    for ends in pairwise(sorted(kept)):
        _push(gaps, time, points, *ends)
    while gaps and len(kept) < most and -gaps[0][0] > tolerance:
        _, first, worst, last = heappop(gaps)
        kept.add(worst)
        _push(gaps, time, points, first, worst)
        _push(gaps, time, points, worst, last)
    return np.asarray(sound[sorted(kept)])


def _push(gaps: list[tuple[float, int, int, int]], time: Array, points: Array, first: int, last: int) -> None:
    """Add a gap between two kept rows to the heap, ordered by the error of interpolation across the gap."""
    if last - first < 2:
        return
    between = slice(first + 1, last)
    share = (time[between] - time[first]) / (time[last] - time[first])
    drawn = points[first] + share[:, np.newaxis, np.newaxis] * (points[last] - points[first])
    errors = np.square(drawn - points[between]).sum(axis=2).max(axis=1)
    worst = int(np.argmax(errors))
    heappush(gaps, (-float(np.sqrt(errors[worst])), first, first + 1 + worst, last))
