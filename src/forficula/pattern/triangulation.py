"""Splitting of facets into triangles by diagonals that do not fold."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple, NoReturn

import numpy as np

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.geometry import polygon_normal
from forficula.pattern.rotation import frame_along

# share of a facet's size: diagonals whose lengths differ by less are equal, so that the choice does not depend on the
# orientation of a sheet; corners nearer than this to a line are on it
_EQUAL = 1e-9


class Triangulation(NamedTuple):
    """A pattern of triangles.

    Attributes:
        pattern: pattern with triangles only.
        facets: number of the facet to which each triangle belongs, shape (triangles,).
    """

    pattern: CreasePattern
    facets: Indices


@lru_cache(maxsize=16)  # many structures with different creases are built from one sheet
def triangulated(pattern: CreasePattern) -> Triangulation:
    """Split every facet with more than three corners by diagonals.

    Each facet is projected on its own plane, and the corner with the shortest diagonal is cut off repeatedly until a
    triangle is left. A convex quadrilateral is thus split along its shorter diagonal, and a regular hexagon into one
    large triangle and three around it. Of diagonals with equal lengths, to 1e-9, the one with the lowest vertex numbers
    is used. The plane of a facet that is not flat is normal to its vector area (Newell's normal).

    Returns:
        The pattern with the same vertices and edges, followed by the diagonals, "F" with the role "diagonal" and the
        fold angle 0. The triangles are in the order of the facets and have their orientation.

    Raises:
        InputError: a facet that crosses itself, has no area, or can be split only along existing edges.
    """
    taken = {frozenset(ends) for ends in pattern.edges_vertices.tolist()}
    triangles: list[tuple[int, int, int]] = []
    facets: list[int] = []
    diagonals: list[tuple[int, int]] = []
    for facet, corners in enumerate(pattern.faces_vertices):
        cut = ears(pattern.vertices_coords, corners, facet, taken)
        diagonals += [(min(one, other), max(one, other)) for one, _, other in cut[:-1]]
        triangles += cut
        facets += [facet] * len(cut)
    count = len(diagonals)
    split = dataclasses.replace(
        pattern,
        edges_vertices=np.concatenate([pattern.edges_vertices, np.array(diagonals, dtype=np.int64).reshape(-1, 2)]),
        edges_assignment=(*pattern.edges_assignment, *"F" * count),
        edges_fold_angle=np.concatenate([pattern.edges_fold_angle, np.zeros(count)]),
        edges_fold=np.concatenate([pattern.edges_fold, len(pattern.edges_fold) + np.arange(count)]),
        edges_role=(*pattern.edges_role, *["diagonal"] * count),
        faces_vertices=tuple(triangles),
    )
    of_facets = np.array(facets, dtype=np.int64)
    of_facets.flags.writeable = False
    return Triangulation(split, of_facets)


def ears(
    coords: Array, corners: Sequence[int], facet: int = 0, taken: set[frozenset[int]] | None = None
) -> list[tuple[int, int, int]]:
    """Split a polygon by cutting off one corner after another, as `triangulated` does.

    Args:
        coords: positions, m, shape (N, 3).
        corners: corners of the polygon, as indices of `coords`.
        facet: number of the polygon, for messages.
        taken: existing edges, which cannot be diagonals; the diagonals are added to this set.

    Returns:
        The triangles. The diagonal of each triangle except the last is the side from its end to its start.

    Raises:
        InputError: a polygon that crosses itself, has no area, or can be split only along existing edges.
    """
    taken = set() if taken is None else taken
    if len(corners) == 3:
        return [(corners[0], corners[1], corners[2])]
    places = dict(zip(corners, _in_own_plane(coords[list(corners)], facet), strict=True))
    size = max(abs(place - other) for place in places.values() for other in places.values())
    left, cut = list(corners), []
    while len(left) > 3:
        around = [(left[k - 1], left[k], left[(k + 1) % len(left)]) for k in range(len(left))]
        free = [ear for ear in around if frozenset((ear[0], ear[2])) not in taken and _is_ear(ear, left, places, size)]
        if not free:
            _refuse(facet)
        lengths = [abs(places[ear[0]] - places[ear[2]]) for ear in free]
        shortest = [ear for ear, length in zip(free, lengths, strict=True) if length <= min(lengths) + _EQUAL * size]
        best = min(shortest, key=lambda ear: sorted((ear[0], ear[2])))
        taken.add(frozenset((best[0], best[2])))
        left.remove(best[1])
        cut.append(best)
    last = (left[0], left[1], left[2])
    if not _is_ear(last, left, places, size):
        _refuse(facet)
    return [*cut, last]


def _refuse(facet: int) -> NoReturn:
    """Raise the error for a facet that diagonals cannot split."""
    raise InputError(
        f"faces_vertices[{facet}]: need a face that diagonals split into triangles, got one that crosses itself, or"
        " whose diagonals are all edges already"
    )


def _in_own_plane(points: Array, facet: int) -> list[complex]:
    """Return the corners of a facet in its own plane, counterclockwise, m."""
    away = points - points.mean(axis=0)
    area = polygon_normal(points)
    length = float(np.linalg.norm(area))
    if not length > _EQUAL * float(np.square(away).sum()):
        raise InputError(f"faces_vertices[{facet}]: need a face with an area, got {length / 2e-4:.3g} cm2")
    return [complex(x, y) for x, y, _ in (away @ frame_along(area / length)).tolist()]


def _is_ear(ear: tuple[int, int, int], left: list[int], places: dict[int, complex], size: float) -> bool:
    """Return whether a corner is convex, and no other corner lies in its triangle or on its sides."""
    start, corner, end = (places[vertex] for vertex in ear)
    sides = [(start, corner), (corner, end), (end, start)]
    heights = [_beside(side, third) for side, third in zip(sides, [end, start, corner], strict=True)]
    if min(heights) <= _EQUAL * size:
        return False
    others = [places[vertex] for vertex in left if vertex not in ear]
    return not any(all(_beside(side, place) >= -_EQUAL * size for side in sides) for place in others)


def _beside(side: tuple[complex, complex], place: complex) -> float:
    """Compute the distance of a point to the left of the line through a side."""
    along = side[1] - side[0]
    return (along.conjugate() * (place - side[0])).imag / abs(along)
