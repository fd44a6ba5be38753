"""Facets split into triangles by diagonals that do not fold."""

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

# shares of a facet's size: diagonals that differ by less are equal, so that turning a sheet does not change which one
# is taken, and corners this near a line lie on it
_ALIKE = 1e-9


class Triangulation(NamedTuple):
    """A pattern of triangles, and where they come from.

    Attributes:
        pattern: with triangles only.
        facets: number of the facet that every triangle was cut from, shape (triangles,).
    """

    pattern: CreasePattern
    facets: Indices


@lru_cache(maxsize=16)  # of one sheet many structures are built, whose creases differ
def triangulated(pattern: CreasePattern) -> Triangulation:
    """Split every facet of more than three corners by diagonals.

    From every facet, projected on its own plane, the corner is cut off that leaves the shortest diagonal, until a
    triangle is left: so a quadrilateral that is convex is split along its shorter diagonal, and a regular hexagon into
    one large triangle and three around it. Of diagonals of one length, to 1e-9, that with the lowest vertex numbers is
    taken. The plane of a facet that is not flat is the one across its vector area (Newell's normal).

    Returns:
        The pattern with the same vertices and, under their numbers, the same edges; the diagonals follow, "F" with
        the role "diagonal" and the fold angle 0. The triangles of a facet follow one another, in the order of the
        facets, with its sense around.

    Raises:
        InputError: a facet that crosses itself or has no area, or that cannot be split but along an edge there is.
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
        edges_role=(*pattern.edges_role, *["diagonal"] * count),
        faces_vertices=tuple(triangles),
    )
    of_facets = np.array(facets, dtype=np.int64)
    of_facets.flags.writeable = False
    return Triangulation(split, of_facets)


def ears(
    coords: Array, corners: Sequence[int], facet: int = 0, taken: set[frozenset[int]] | None = None
) -> list[tuple[int, int, int]]:
    """Cut one corner of a polygon off after another, as `triangulated` does.

    Args:
        coords: m, shape (N, 3).
        corners: of the polygon, numbers in these.
        facet: the polygon's number, for messages.
        taken: edges that no diagonal may lie on; the diagonals are added to them.

    Returns:
        The triangles. Every one but the last lies beyond the diagonal from its end to its start.

    Raises:
        InputError: a polygon that crosses itself or has no area, or that cannot be split but along an edge there is.
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
        alike = [ear for ear, length in zip(free, lengths, strict=True) if length <= min(lengths) + _ALIKE * size]
        best = min(alike, key=lambda ear: sorted((ear[0], ear[2])))
        taken.add(frozenset((best[0], best[2])))
        left.remove(best[1])
        cut.append(best)
    last = (left[0], left[1], left[2])
    if not _is_ear(last, left, places, size):
        _refuse(facet)
    return [*cut, last]


def _refuse(facet: int) -> NoReturn:
    """Say that no diagonals split a facet."""
    raise InputError(
        f"faces_vertices[{facet}]: need a face that diagonals split into triangles, got one that crosses itself, or of"
        " which every diagonal is an edge already"
    )


def _in_own_plane(points: Array, facet: int) -> list[complex]:
    """The corners of a facet in its own plane, counterclockwise, m."""
    away = points - points.mean(axis=0)
    area = polygon_normal(points)
    length = float(np.linalg.norm(area))
    if not length > _ALIKE * float(np.square(away).sum()):
        raise InputError(f"faces_vertices[{facet}]: need a face with an area, got {length / 2e-4:.3g} cm2")
    return [complex(x, y) for x, y, _ in (away @ frame_along(area / length)).tolist()]


def _is_ear(ear: tuple[int, int, int], left: list[int], places: dict[int, complex], size: float) -> bool:
    """Whether a corner is convex, and no other one lies in its triangle or on the rim of that."""
    start, corner, end = (places[vertex] for vertex in ear)
    sides = [(start, corner), (corner, end), (end, start)]
    heights = [_beside(side, third) for side, third in zip(sides, [end, start, corner], strict=True)]
    if min(heights) <= _ALIKE * size:
        return False
    others = [places[vertex] for vertex in left if vertex not in ear]
    return not any(all(_beside(side, place) >= -_ALIKE * size for side in sides) for place in others)


def _beside(side: tuple[complex, complex], place: complex) -> float:
    """How far a place lies to the left of the line through a side."""
    along = side[1] - side[0]
    return (along.conjugate() * (place - side[0])).imag / abs(along)
