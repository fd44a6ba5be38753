"""Which rows of a record a page keeps: what rests needs few, what snaps needs all."""

from __future__ import annotations

from collections.abc import Iterable
from heapq import heappop, heappush
from itertools import pairwise

import numpy as np

from forficula.arrays import Array, Indices


def kept_frames(time: Array, points: Array, moments: Iterable[float], *, most: int, tolerance: float) -> Indices:
    """Choose rows so that what is drawn between them goes as it went.

    The rows nearest to the moments, the first and the last are kept. Then, again and again, the row is added at which
    what is drawn between its neighbours is furthest from the record (Douglas and Peucker 1973, with time
    as the line's parameter), until none is further than the tolerance or there are enough rows.

    Args:
        time: s, (time,).
        points: m, (time, point, 3); rows that are not finite as floats of four bytes are never kept.
        moments: times that must be kept, s.
        most: number of rows; more are kept only where the moments are more.
        tolerance: distance that no one sees, m.

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
    """Add a gap between two kept rows to the heap, by how far what is drawn across it is from the record."""
    if last - first < 2:
        return
    inside = slice(first + 1, last)
    share = (time[inside] - time[first]) / (time[last] - time[first])
    drawn = points[first] + share[:, np.newaxis, np.newaxis] * (points[last] - points[first])
    errors = np.square(drawn - points[inside]).sum(axis=2).max(axis=1)
    worst = int(np.argmax(errors))
    heappush(gaps, (-float(np.sqrt(errors[worst])), first, first + 1 + worst, last))
