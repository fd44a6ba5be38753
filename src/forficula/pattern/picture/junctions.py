"""Junctions of drawn segments, and edges between them."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from forficula.arrays import Array, Indices
from forficula.pattern.picture.drawn_segments import DrawnSegment

_CROSSING = np.radians(3.0)  # [chosen] least angle between lines whose crossing is computed
_BEYOND = 2.5  # [chosen] line widths by which segments are extended to a crossing
_GAPS = 1.5  # [chosen] gaps between dashes by which dashed segments are extended in addition
_SHORT = 0.1  # [chosen] share of its length by which a segment is extended, at most, beyond a third of the others
_LEAST_BEYOND = 6.0  # pixels
_TOGETHER = 2.0  # [chosen] line widths within which crossings are one junction
_LEAST_TOGETHER = 5.0  # pixels
_BLOT = 8.0  # [chosen] line widths, length above which a segment is no blot at a crossing
_BLOT_REACH = 5.0  # [chosen] line widths between the ends of a blot and the crossing
_ALONG = 1e-4  # weight of the ends of segments along their line


@dataclass(frozen=True, kw_only=True, eq=False)
class Junctions:
    """Network of drawn lines.

    Attributes:
        places: junctions, pixels, shape (N, 2).
        errors: standard error of each junction, pixels, shape (N,).
        edges: the two junctions of every edge, shape (E, 2).
        lines: segments without those that are blots at junctions.
        segments: number in `lines` of the segment of every edge, shape (E,).
        free_ends: ends of segments that reach no junction, and middles of segments without any, pixels, shape (F, 2).
    """

    places: Array
    errors: Array
    edges: Indices
    lines: tuple[DrawnSegment, ...]
    segments: Indices
    free_ends: Array


def junctions(segments: Sequence[DrawnSegment], line_width: float) -> Junctions:
    """Find the junctions of segments, and the edges between them.

    Segments meet where their lines cross within, or slightly beyond, both of them. Crossings close to each other are
    one junction, whose position is the least-squares point of all its lines, weighted by their standard errors.

    Args:
        segments: straight segments of ink.
        line_width: typical width of a line, pixels.
    """
    beyond = max(_LEAST_BEYOND, _BEYOND * line_width)
    together = max(_LEAST_TOGETHER, _TOGETHER * line_width)
    segments = _without_blots(segments, beyond, line_width)
    candidates = _crossings(segments, beyond)
    if not candidates:
        return _without_junctions(segments)
    points = np.array([point for point, _, _ in candidates])
    groups = _groups(points, together)
    count = int(groups.max()) + 1
    through: list[set[int]] = [set() for _ in range(count)]
    for group, (_, one, other) in zip(groups.tolist(), candidates, strict=True):
        through[group] |= {one, other}
    places, errors = np.empty((count, 2)), np.empty(count)
    for group in range(count):
        near = points[groups == group].mean(axis=0)
        places[group], errors[group] = least_squares_point([segments[line] for line in sorted(through[group])], near)
    edges, numbers, free_ends = _edges(segments, places, through, beyond)
    return Junctions(
        places=places, errors=errors, edges=edges, lines=tuple(segments), segments=numbers, free_ends=free_ends
    )


def _without_blots(segments: Sequence[DrawnSegment], beyond: float, line_width: float) -> Sequence[DrawnSegment]:
    """Return the segments without the short ones at a crossing of longer ones, where strokes run into each other."""
    longer = [segment for segment in segments if segment.length > _BLOT * line_width]
    crossings = _crossings(longer, beyond)
    if not crossings:
        return segments
    tree = cKDTree(np.array([point for point, _, _ in crossings]))
    kept = list(longer)
    for segment in segments:
        if segment.length > _BLOT * line_width:
            continue
        ends = np.stack([segment.place(segment.start), segment.place(segment.end)])
        one, other = (set(near) for near in tree.query_ball_point(ends, max(beyond, _BLOT_REACH * line_width)))
        if not one & other:
            kept.append(segment)
    return kept


def _without_junctions(segments: Sequence[DrawnSegment]) -> Junctions:
    ends = [segment.place(position) for segment in segments for position in (segment.start, segment.end)]
    return Junctions(
        places=np.zeros((0, 2)),
        errors=np.zeros(0),
        edges=np.zeros((0, 2), dtype=np.int64),
        lines=tuple(segments),
        segments=np.zeros(0, dtype=np.int64),
        free_ends=np.array(ends).reshape(-1, 2),
    )


def _crossings(segments: Sequence[DrawnSegment], beyond: float) -> list[tuple[Array, int, int]]:
    """Return the crossings of pairs of segments, with the numbers of both."""
    middles = np.array([segment.middle for segment in segments]).reshape(-1, 2)
    along = np.array([segment.along for segment in segments]).reshape(-1, 2)
    # strokes of text beside the pattern are short, and must not reach it
    reach = np.array(
        [
            min(beyond + min(_GAPS * segment.longest_gap, 3 * beyond), beyond / 3 + _SHORT * segment.length)
            for segment in segments
        ]
    )
    low = np.array([segment.ink_start for segment in segments])
    high = np.array([segment.ink_end for segment in segments])
    crossings: list[tuple[Array, int, int]] = []
    for one in range(len(segments)):
        others = np.arange(one + 1, len(segments))
        sine = along[one, 0] * along[others, 1] - along[one, 1] * along[others, 0]
        offset = middles[others] - middles[one]
        with np.errstate(divide="ignore", invalid="ignore"):
            first = (offset[:, 0] * along[others, 1] - offset[:, 1] * along[others, 0]) / sine
            second = (offset[:, 0] * along[one, 1] - offset[:, 1] * along[one, 0]) / sine
        crosses = np.abs(sine) >= np.sin(_CROSSING)
        # how far a crossing lies beyond the ends of both segments
        before, after = (
            np.maximum(np.maximum(start - position, position - end), 0.0)
            for position, start, end in ((first, low[one], high[one]), (second, low[others], high[others]))
        )
        crosses &= (before <= reach[one]) & (after <= reach[others])
        crosses &= before + after <= np.maximum(reach[one], reach[others])
        crossings += [
            (segments[one].place(float(first[k])), one, int(others[k])) for k in np.flatnonzero(crosses).tolist()
        ]
        # lines that continue each other with a slight bend, or with another colour
        for k in np.flatnonzero(np.abs(sine) < np.sin(_CROSSING)).tolist():
            point = _continuation(segments[one], segments[int(others[k])], beyond)
            if point is not None:
                crossings.append((point, one, int(others[k])))
    return crossings


def _continuation(one: DrawnSegment, other: DrawnSegment, beyond: float) -> Array | None:
    """Return the point between the ends at which one segment continues another; None where they do not."""
    if one.along @ other.along < 0:
        ends = ((one.start, other.start), (one.end, other.end))
    else:
        ends = ((one.end, other.start), (one.start, other.end))
    for first, second in ends:
        start, end = one.place(first), other.place(second)
        offset = end - start
        aside = abs(offset[0] * one.along[1] - offset[1] * one.along[0])
        if np.linalg.norm(offset) <= beyond + max(one.longest_gap, other.longest_gap) and aside <= beyond / 2:
            return np.asarray((start + end) / 2)
    return None


def _groups(points: Array, together: float) -> Indices:
    """Return the number of the group of every point; points within a distance of each other are one group."""
    pairs = cKDTree(points).query_pairs(together, output_type="ndarray")
    near = coo_array((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(len(points), len(points)))
    return np.asarray(connected_components(near, directed=False)[1], dtype=np.int64)


def least_squares_point(lines: Sequence[DrawnSegment], near: Array) -> tuple[Array, float]:
    """Compute the point that is nearest to some lines, each weighted by its standard error there.

    Args:
        lines: segments whose lines meet.
        near: a point near the result, pixels, shape (2,); it decides the position along lines that are parallel.

    Returns:
        The point, pixels, shape (2,), and its standard error, pixels.
    """
    normals = np.array([[-line.along[1], line.along[0]] for line in lines])
    distances = np.array([normal @ line.middle for normal, line in zip(normals, lines, strict=True)])
    sigma = np.array([line.standard_error(float((near - line.middle) @ line.along)) for line in lines])
    weights = 1 / np.maximum(sigma, 1e-3) ** 2
    matrix = (normals.T * weights) @ normals
    weak = _ALONG * float(np.trace(matrix)) * np.eye(2)
    place = np.linalg.solve(matrix + weak, normals.T @ (weights * distances) + weak @ near)
    aside = normals @ place - distances
    excess = max(1.0, float(weights @ aside**2) / max(len(lines) - 2, 1))
    error = float(np.sqrt(np.trace(np.linalg.inv(matrix + weak)) * excess))
    return np.asarray(place), error


def snapped_points(points: Array, places: Array, reach: float) -> tuple[Array, Indices]:
    """Move points to the nearest junction within a distance, such as clicks in a picture.

    Args:
        points: pixels, shape (P, 2).
        places: junctions, pixels, shape (N, 2).
        reach: largest distance, pixels.

    Returns:
        The points, pixels, shape (P, 2), and the number of the junction of each, -1 where none is within reach.
    """
    if not len(places):
        return points.copy(), np.full(len(points), -1, dtype=np.int64)
    distances, numbers = cKDTree(places).query(points)
    numbers = np.where(distances <= reach, numbers, -1).astype(np.int64)
    return np.where((numbers >= 0)[:, np.newaxis], places[numbers], points), numbers


def _edges(
    segments: Sequence[DrawnSegment], places: Array, lines: Sequence[set[int]], beyond: float
) -> tuple[Indices, Indices, Array]:
    """Return the edges between neighbouring junctions of each segment, their segments, and the free ends."""
    on: list[list[int]] = [[] for _ in segments]
    for junction, numbers in enumerate(lines):
        for number in numbers:
            on[number].append(junction)
    pairs: dict[tuple[int, int], int] = {}
    free_ends = []
    for number, (segment, at) in enumerate(zip(segments, on, strict=True)):
        positions = sorted((float((places[junction] - segment.middle) @ segment.along), junction) for junction in at)
        if not at:
            free_ends.append(segment.place((segment.start + segment.end) / 2))
            continue
        reach = beyond + _GAPS * segment.longest_gap
        if positions[0][0] > segment.start + reach:
            free_ends.append(segment.place(segment.start))
        if positions[-1][0] < segment.end - reach:
            free_ends.append(segment.place(segment.end))
        for (_, one), (_, other) in itertools.pairwise(positions):
            if one != other:
                key = (min(one, other), max(one, other))
                known = pairs.get(key)
                if known is None or segments[known].count < segment.count:
                    pairs[key] = number
    edges = np.array(list(pairs), dtype=np.int64).reshape(-1, 2)
    return edges, np.array(list(pairs.values()), dtype=np.int64), np.array(free_ends).reshape(-1, 2)
