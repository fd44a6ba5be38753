"""Conversion of drawn lines to a network: nearby ends are joined, crossing lines split, duplicates merged."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.pattern.crease_pattern import ASSIGNMENTS
from forficula.pattern.drawings.drawing import DrawnLine
from forficula.pattern.drawings.segments import crossings, points_on_segments

_ROUNDING = 1e-9  # share of the tolerance below which a gap counts as 0
_ROUNDS = 8  # joining bends lines by less than the tolerance, so that they may touch others in the next round
_SAME_ANGLE = 1e-6  # rad


@dataclass(frozen=True, kw_only=True, eq=False)
class LineNetwork:
    """Lines that meet only at their ends.

    Attributes:
        points: m, shape (N, 2).
        edges: the two points of every piece of a line, shape (E, 2), without duplicates.
        lines: number of the drawn line of every piece, shape (E,).
        gaps: widths of the gaps that were closed, m, shape (G,).
        lost: number of lines shorter than the tolerance.
        crossings: number of places where crossing lines were split.
    """

    points: Array
    edges: Indices
    lines: Indices
    gaps: Array
    lost: int
    crossings: int


def line_network(lines: Sequence[DrawnLine], ends: Array, tolerance: float) -> LineNetwork:
    """Join, split and merge lines.

    Ends closer than the tolerance become one point in their middle. A line is split at every point within the tolerance
    and where it crosses another line.

    Args:
        lines: drawn lines.
        ends: ends of the lines, m, shape (L, 2, 2).
        tolerance: m.

    Raises:
        InputError: a chain of close ends that would join points further apart than twice the tolerance, or pieces of
            two lines at the same place with different letters or fold angles.
    """
    labels, points, gaps = joined_points(ends.reshape(-1, 2), tolerance)
    edges, numbers = labels.reshape(-1, 2), np.arange(len(lines))
    whole = edges[:, 0] != edges[:, 1]
    edges, numbers = edges[whole], numbers[whole]
    crossed = 0
    for _ in range(_ROUNDS):
        points, splits, count = _splits(points, edges, tolerance)
        if not splits:
            break
        crossed += count
        edges, numbers = _split_edges(points, edges, numbers, splits)
    kept = _each_once(lines, points, edges, numbers)
    lost = int(len(lines) - np.count_nonzero(whole))
    return LineNetwork(points=points, edges=edges[kept], lines=numbers[kept], gaps=gaps, lost=lost, crossings=crossed)


def joined_points(points: Array, tolerance: float) -> tuple[Indices, Array, Array]:
    """Join points that are closer than a tolerance.

    Args:
        points: m, shape (P, 2).
        tolerance: m.

    Returns:
        The number of the joined point for each point, in order of appearance, shape (P,); the joined points, in the
        middle of their groups, m, shape (J, 2); and the width of each group that was not at one place, m, shape (G,).

    Raises:
        InputError: a chain of close points is longer than twice the tolerance.
    """
    pairs = scipy.spatial.cKDTree(points).query_pairs(tolerance, output_type="ndarray")
    near = coo_array((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(len(points), len(points)))
    count, groups = connected_components(near, directed=False)
    first = np.full(count, len(points))
    np.minimum.at(first, groups, np.arange(len(points)))
    order = np.argsort(np.argsort(first))
    labels = order[groups]
    low, high = np.full((count, 2), np.inf), np.full((count, 2), -np.inf)
    np.minimum.at(low, labels, points)
    np.maximum.at(high, labels, points)
    widths = np.hypot(*(high - low).T)
    if (widths > 2 * tolerance).any():
        raise InputError(
            f"tolerance: need less than the distance of points that differ, got {1e3 * tolerance:.4g} mm, which joins"
            f" points {1e3 * widths.max():.4g} mm apart through others between them"
        )
    middles = np.where(widths[:, np.newaxis] > 0, (low + high) / 2, low)
    return labels, middles, widths[widths > _ROUNDING * tolerance]


def _splits(points: Array, edges: Indices, tolerance: float) -> tuple[Array, dict[int, set[int]], int]:
    """Return all points including crossings, the points at which each edge is split, and the number of crossings."""
    starts, ends = points[edges[:, 0]], points[edges[:, 1]]
    touching, _ = points_on_segments(points, starts, ends, tolerance)
    splits: dict[int, set[int]] = {}
    for point, edge in touching.tolist():
        splits.setdefault(edge, set()).add(point)
    pairs, places = crossings(starts, ends, tolerance)
    if len(pairs):
        nearest, point = scipy.spatial.cKDTree(points).query(places)
        new = nearest > tolerance
        if new.any():
            labels, middles, _ = joined_points(places[new], tolerance)
            point[new] = len(points) + labels
            points = np.concatenate([points, middles])
        for (one, other), at in zip(pairs.tolist(), point.tolist(), strict=True):
            for edge in (one, other):
                if at not in edges[edge]:
                    splits.setdefault(edge, set()).add(at)
    return points, splits, len(pairs)


def _split_edges(
    points: Array, edges: Indices, numbers: Indices, splits: dict[int, set[int]]
) -> tuple[Indices, Indices]:
    """Split edges at points on them; return the pieces and the numbers of their lines."""
    pieces: list[tuple[int, int]] = []
    of: list[int] = []
    for edge, (tail, head) in enumerate(edges.tolist()):
        inside = list(splits.get(edge, ()))
        along = points[head] - points[tail]
        inside.sort(key=lambda point: float((points[point] - points[tail]) @ along))
        path = [tail, *inside, head]
        pieces += itertools.pairwise(path)
        of += [int(numbers[edge])] * (len(path) - 1)
    return np.array(pieces, dtype=np.int64).reshape(-1, 2), np.array(of, dtype=np.int64)


def _each_once(lines: Sequence[DrawnLine], points: Array, edges: Indices, numbers: Indices) -> Indices:
    """Return the numbers of the edges without duplicates; raise InputError if two duplicates differ in kind."""
    kept: dict[tuple[int, int], int] = {}
    for edge, (tail, head) in enumerate(edges.tolist()):
        first = kept.setdefault((min(tail, head), max(tail, head)), edge)
        one, other = lines[numbers[first]], lines[numbers[edge]]
        equal = math.isnan(one.fold_angle) or abs(one.fold_angle - other.fold_angle) <= _SAME_ANGLE
        if one.letter != other.letter or not equal:
            meanings = [ASSIGNMENTS[line.letter] for line in (one, other)]
            got = " and ".join(meanings) if meanings[0] != meanings[1] else f"two fold angles of one {meanings[0]}"
            place = place_text((points[tail] + points[head]) / 2)
            raise InputError(f"{other.name}: need one kind of line at a place, got {got}, over {one.name}, {place}")
    return np.array(sorted(kept.values()), dtype=np.int64)


def place_text(point: Array) -> str:
    """Describe the position of a point on the sheet in words."""
    x, y = (1e3 * point).tolist()
    return f"{x:.4g} mm right of and {y:.4g} mm above the drawing's lower left corner"
