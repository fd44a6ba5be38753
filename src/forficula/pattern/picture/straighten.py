"""Least movement of vertices to exact symmetry, straight lines and flat-foldability."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial import cKDTree

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern, creases_inside
from forficula.quantities import show_value
from forficula.serial import Metres

_ROUNDS = 60
_EXACT = 1e-12  # rad, residual at which a condition holds
_NEAR = 1e-9  # rad, residual that is reported as exact, above the rounding of long computations

# a sum of directions of edges, (from vertex, to vertex, factor), and its value, rad, up to multiples of twice the value
_Condition = tuple[list[tuple[int, int, int]], float]


@dataclass(frozen=True, kw_only=True)
class Straightening:
    """Correction of a pattern to exact symmetry and flat-foldability.

    Attributes:
        largest: largest movement of a vertex, m.
        mean: root mean square movement of the vertices, m.
        tolerance: largest allowed movement, m.
        symmetries: symmetries that are exact now, in words.
        straight_lines: number of pairs of edges that now continue each other exactly.
        flat_vertices: number of interior vertices at which Kawasaki's condition is exact now.
    """

    largest: Metres
    mean: Metres
    tolerance: Metres
    symmetries: tuple[str, ...]
    straight_lines: int
    flat_vertices: int


def straightened(pattern: CreasePattern, tolerance: float) -> tuple[CreasePattern, Straightening]:
    """Move the vertices of a flat pattern least, so that it is exactly symmetric, straight and flat-foldable.

    The symmetries are those mirror lines and rotations about the centre that map every vertex to within twice the
    tolerance of another one, edges to edges and the border to the border. Two edges at a vertex continue each other
    where the vertex is closer than the tolerance to the line between their other ends. Flat-foldability is Kawasaki's
    condition at every interior vertex. Sequential least squares minimise the sum of the squared movements.

    Args:
        pattern: a flat pattern.
        tolerance: largest movement of a vertex, m.

    Returns:
        The pattern with other positions, and the movements.

    Raises:
        InputError: a tolerance of half of the shortest distance between two vertices or more, a vertex with an odd
            number of creases, a vertex that would move further than the tolerance, or no such positions were found.
    """
    if not (math.isfinite(tolerance) and tolerance > 0):
        raise InputError(f"straighten: need a tolerance > 0, got {tolerance:g} m")
    start = pattern.vertices_coords[:, :2]
    # vertices that move further may exchange their positions
    most = float(cKDTree(start).query(start, k=[2])[0].min()) / 2
    if tolerance >= most:
        raise InputError(
            f"straighten: need a tolerance < {show_value(most, 'm')}, half of the shortest distance between two"
            f" vertices, got {show_value(tolerance, 'm')}"
        )
    maps, words = _symmetries(pattern, 2 * tolerance)
    flat = _flat_conditions(pattern)
    straight = _straight_conditions(pattern, tolerance)
    target = _symmetric(start, maps)
    points = target
    conditions = flat + straight
    for _ in range(_ROUNDS):
        residual, slopes = _directions(points, conditions)
        if np.abs(residual).max(initial=0.0) < _EXACT:
            break
        # the nearest point to the target at which the linearised conditions hold
        correction = np.linalg.lstsq(slopes, -residual - slopes @ (target - points).ravel(), rcond=1e-10)[0]
        points = _symmetric(target + correction.reshape(-1, 2), maps)
    residual = np.abs(_directions(points, conditions)[0])
    moved = np.linalg.norm(points - start, axis=1)
    if residual.max(initial=0.0) > _NEAR or not np.isfinite(moved).all():
        raise InputError(
            "straighten: found no positions at which all conditions hold; give a smaller tolerance, or correct the"
            " pattern in an editor"
        )
    if moved.max() > tolerance:
        vertex = int(np.argmax(moved))
        raise InputError(
            f"straighten: need a tolerance of at least {show_value(float(moved.max()), 'm')}, by which vertex {vertex}"
            f" would move, got {show_value(tolerance, 'm')}"
        )
    corrected = replace(pattern, vertices_coords=np.column_stack([points, pattern.vertices_coords[:, 2]]))
    return corrected, Straightening(
        largest=float(moved.max()),
        mean=float(np.sqrt(np.mean(moved**2))),
        tolerance=tolerance,
        symmetries=words,
        straight_lines=len(straight),
        flat_vertices=len(flat),
    )


def _flat_conditions(pattern: CreasePattern) -> list[_Condition]:
    """Return Kawasaki's conditions as alternating sums of the directions of creases."""
    conditions: list[_Condition] = []
    for vertex, edges in creases_inside(pattern):
        if len(edges) == 0:
            continue
        if len(edges) % 2:
            raise InputError(
                f"straighten: need an even number of creases at every vertex, got {len(edges)} at vertex {vertex},"
                " which never folds flat"
            )
        ends = (pattern.edges_vertices[edges].sum(axis=1) - vertex).tolist()
        terms = [(vertex, end, -2 if place % 2 == 0 else 2) for place, end in enumerate(ends)]
        conditions.append((terms, 2 * math.pi))
    return conditions


def _straight_conditions(pattern: CreasePattern, tolerance: float) -> list[_Condition]:
    """Return the conditions that edges continue each other."""
    points = pattern.vertices_coords[:, :2]
    around: dict[int, list[int]] = {}
    for one, other in pattern.edges_vertices.tolist():
        around.setdefault(one, []).append(other)
        around.setdefault(other, []).append(one)
    conditions: list[_Condition] = []
    for vertex, ends in around.items():
        for place, one in enumerate(ends):
            for other in ends[place + 1 :]:
                along = points[other] - points[one]
                offset = points[vertex] - points[one]
                length = float(np.linalg.norm(along))
                aside = abs(float(offset[0] * along[1] - offset[1] * along[0])) / max(length, 1e-300)
                if aside <= tolerance and 0 < offset @ along < length**2:
                    conditions.append(([(vertex, one, 1), (vertex, other, -1)], math.pi))
    return conditions


def _directions(points: Array, conditions: Sequence[_Condition]) -> tuple[Array, Array]:
    """Return the residuals of conditions, rad, shape (C,), and their derivatives, shape (C, 2 N)."""
    residual = np.zeros(len(conditions))
    slopes = np.zeros((len(conditions), len(points), 2))
    for row, (terms, value) in enumerate(conditions):
        total = 0.0
        for start, end, factor in terms:
            x, y = (points[end] - points[start]).tolist()
            total += factor * math.atan2(y, x)
            slope = factor * np.array([-y, x]) / (x * x + y * y)
            slopes[row, end] += slope
            slopes[row, start] -= slope
        # directions are known up to whole turns
        residual[row] = math.remainder(total - value, 2 * value)
    return residual, slopes.reshape(len(conditions), -1)


def _symmetries(pattern: CreasePattern, reach: float) -> tuple[list[tuple[Array, Indices]], tuple[str, ...]]:
    """Find the symmetries of a pattern about its centre.

    Returns:
        Matrix, shape (2, 2), and image of every vertex, shape (N,), of every symmetry with the identity: the matrix
        maps vertex v to the position of vertex image[v]; and the symmetries in words.
    """
    points = pattern.vertices_coords[:, :2]
    offset = points - points.mean(axis=0)
    radius = np.linalg.norm(offset, axis=1)
    count = len(points)
    identity = (np.eye(2), np.arange(count))
    first = int(np.argmax(radius))
    near = np.flatnonzero(np.abs(radius - radius[first]) <= 2 * reach)
    angles = np.arctan2(offset[:, 1], offset[:, 0])
    tree = cKDTree(offset)
    border = {
        frozenset(ends): letter == "B"
        for ends, letter in zip(pattern.edges_vertices.tolist(), pattern.edges_assignment, strict=True)
    }

    def permutation(matrix: Array) -> Indices | None:
        distance, nearest = tree.query(offset @ matrix.T)
        if (distance > reach).any() or len(np.unique(nearest)) < count:
            return None
        image = nearest.tolist()
        for ends, is_border in border.items():
            one, other = ends
            if border.get(frozenset((image[one], image[other]))) != is_border:
                return None
        return np.asarray(nearest, dtype=np.int64)

    turns = [angles[other] - angles[first] for other in near.tolist() if other != first]
    rotations = [turn for turn in turns if permutation(_rotation(turn)) is not None]
    order = len(rotations) + 1
    exact = [2 * math.pi * step / order for step in range(order)]
    if any(permutation(_rotation(turn)) is None for turn in exact):
        exact, order = [0.0], 1
    axes = [
        axis for other in near.tolist() if permutation(_mirror(axis := (angles[first] + angles[other]) / 2)) is not None
    ]
    matrices = [_rotation(turn) for turn in exact]
    words = [f"rotation by {360 / order:.4g} deg"] if order > 1 else []
    if axes:
        # the mean axis, modulo the angle between neighbouring axes
        period = math.pi / order
        axis = float(np.angle(np.exp(2j * math.pi * np.array(axes) / period).mean())) * period / (2 * math.pi)
        mirrors = [_mirror(axis + step * period) for step in range(order)]
        if all(permutation(mirror) is not None for mirror in mirrors):
            matrices += mirrors
            degrees = ", ".join(f"{math.degrees(axis + step * period) % 180:.3g}" for step in range(order))
            words.append(f"mirror line{'s' * (order > 1)} at {degrees} deg")
    maps = []
    for matrix in matrices:
        image = permutation(matrix)
        assert image is not None
        maps.append((matrix, image))
    return maps or [identity], tuple(words)


def _rotation(turn: float) -> Array:
    return np.array([[math.cos(turn), -math.sin(turn)], [math.sin(turn), math.cos(turn)]])


def _mirror(axis: float) -> Array:
    return np.array([[math.cos(2 * axis), math.sin(2 * axis)], [math.sin(2 * axis), -math.cos(2 * axis)]])


def _symmetric(points: Array, maps: Sequence[tuple[Array, Indices]]) -> Array:
    """Return the nearest positions with all symmetries: the mean over the images."""
    centre = points.mean(axis=0)
    offset = points - centre
    # vertex v is mapped to vertex image[v], so that the inverse matrix brings its position back
    return np.asarray(centre + np.mean([offset[image] @ matrix for matrix, image in maps], axis=0))
