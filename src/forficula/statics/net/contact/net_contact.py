"""Contact of the triangles of a net: pairs of corners and triangles and of edges, and the forces between them."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

import numpy as np

from forficula.arrays import Array, Indices
from forficula.statics.net.contact.closest import Closest, corner_to_triangle, edge_to_edge

_NONE = np.zeros(0)
_CORNERS = (0, 1, 2)
_HALVINGS = 40  # of a motion, to locate the time at which four points are in one plane
_CROSSED = 1e-6  # of the largest coordinate: distance of elements that cross


@dataclass(frozen=True, kw_only=True, eq=False)
class Pressing:
    """Forces between the elements of pairs that touch.

    Attributes:
        codes: numbers of the pairs, rising, (pair,).
        forces: pushing the elements apart, > 0, N, (pair,).
    """

    codes: Indices = field(default_factory=lambda: np.zeros(0, dtype=np.int64))
    forces: Array = field(default_factory=lambda: _NONE)

    def of(self, codes: Indices) -> Array:
        """Return the forces of pairs, N, (pair,); 0 for those that do not touch."""
        if not len(self.codes):
            return np.zeros(len(codes))
        places = np.minimum(np.searchsorted(self.codes, codes), len(self.codes) - 1)
        return np.where(self.codes[places] == codes, self.forces[places], 0.0)


class Pairs(NamedTuple):
    """Pairs of a corner and a triangle, then pairs of edges.

    Attributes:
        codes: numbers of the pairs, rising, (pair,).
        points: of the corner and the triangle, or of both edges, (pair, 4).
        corners: number of pairs of a corner and a triangle; the others are pairs of edges.
        facets: facets of both elements, (pair, 2).
    """

    codes: Indices
    points: Indices
    corners: int
    facets: Indices

    def closest(self, places: Array) -> Closest:
        """Return the closest points of all pairs for points at given places, m, (point, 3)."""
        at = places[self.points]
        parts = [corner_to_triangle(at[: self.corners]), edge_to_edge(at[self.corners :])]
        return Closest(*(np.concatenate(values) for values in zip(*parts, strict=True)))


@dataclass(frozen=True, kw_only=True, eq=False)
class NetContact:
    """Triangles that keep a distance from one another.

    Elements that share a corner are not compared, because their distance is 0 in every shape. Triangles of one facet
    and triangles that are fixed to one another are not compared either.

    Attributes:
        thickness: least distance, m.
        stiffness: of the augmented Lagrangian, N/m; it affects the convergence and not the result.
        triangles: points at the corners, (triangle, 3).
        corners: numbers of the corners, equal for corners of several triangles that are joined, (triangle, 3).
        facets: number of the facet of each triangle, (triangle,).
        rigid: number of the rigid body that carries each triangle; negative, and different for all triangles, if none
            does, (triangle,).
        names: of the facets.
    """

    thickness: float
    stiffness: float
    triangles: Indices
    corners: Indices
    facets: Indices
    rigid: Indices
    names: tuple[str, ...]

    def within(self, places: Array, reach: float, pressing: Pressing | None = None) -> Pairs:
        """Return the pairs whose triangles have bounding boxes within a distance, and those that press on each other.

        Args:
            places: of the points, m, (point, 3); or before and after a motion, (2, point, 3).
            reach: m.
            pressing: forces of pairs that are included in any case.
        """
        at = places[..., self.triangles, :]
        low, high = at.min(axis=-2), at.max(axis=-2)
        if places.ndim == 3:
            low, high = low.min(axis=0), high.max(axis=0)
        first, second = self._compared
        near = np.all((low[first] <= high[second] + reach) & (low[second] <= high[first] + reach), axis=1)
        pairs = self._pairs_of(first[near], second[near])
        if pressing is None or np.isin(pressing.codes, pairs.codes, assume_unique=True).all():
            return pairs
        codes = np.union1d(pairs.codes, pressing.codes)
        everything = self._pairs_of(first, second)
        rows = np.searchsorted(everything.codes, codes)
        corners = int(np.count_nonzero(codes < self._first_edges))
        return Pairs(codes, everything.points[rows], corners, everything.facets[rows])

    def least_distance(self, places: Array) -> tuple[float, tuple[int, int]]:
        """Return the least distance of all pairs, m, and the facets of that pair; inf and (-1, -1) without pairs."""
        pairs = self._pairs_of(*self._compared)
        if not len(pairs.codes):
            return np.inf, (-1, -1)
        distance = pairs.closest(places).distance
        row = int(np.argmin(distance))
        one, other = sorted(pairs.facets[row].tolist())
        return float(distance[row]), (one, other)

    def crossed(self, before: Array, after: Array) -> bool:
        """Return whether elements pass through each other while all points move along straight lines.

        Args:
            before: places of the points before the motion, m, (point, 3).
            after: places after the motion, m, (point, 3).
        """
        pairs = self.within(np.stack([before, after]), 0.0)
        start, end = before[pairs.points], after[pairs.points]
        volumes = _volumes(start)
        rows = np.flatnonzero(volumes * _volumes(end) < 0)
        if not len(rows):
            return False
        start, end, signs = start[rows], end[rows], np.sign(volumes[rows])
        low, high = np.zeros(len(rows)), np.ones(len(rows))
        for _ in range(_HALVINGS):
            middle = (low + high) / 2
            same = np.sign(_volumes(start + middle[:, None, None] * (end - start))) == signs
            low, high = np.where(same, middle, low), np.where(same, high, middle)
        at = start + low[:, None, None] * (end - start)
        corners = rows < pairs.corners
        apart = np.empty(len(rows))
        apart[corners] = corner_to_triangle(at[corners]).distance
        apart[~corners] = edge_to_edge(at[~corners]).distance
        return bool(np.any(apart <= _CROSSED * np.abs(at - at.mean(axis=1, keepdims=True)).max()))

    @cached_property
    def _compared(self) -> tuple[Indices, Indices]:
        """Return the pairs of triangles that are compared, (pair,) each."""
        first, second = np.triu_indices(len(self.triangles), 1)
        used = (self.facets[first] != self.facets[second]) & (self.rigid[first] != self.rigid[second])
        return first[used], second[used]

    @cached_property
    def _edges(self) -> tuple[Indices, Indices, Indices]:
        """Return the edges as pairs of points, (edge, 2), as pairs of corners, and those of all triangles, (., 3)."""
        sides = np.stack([self.triangles[:, [side, (side + 1) % 3]] for side in _CORNERS], axis=1).reshape(-1, 2)
        ids = np.stack([self.corners[:, [side, (side + 1) % 3]] for side in _CORNERS], axis=1).reshape(-1, 2)
        _, rows, numbers = np.unique(np.sort(sides, axis=1), axis=0, return_index=True, return_inverse=True)
        return sides[rows], ids[rows], numbers.reshape(-1, 3)

    @cached_property
    def _common(self) -> Indices:
        """Return the number of corners that two facets share, (facet, facet)."""
        at = np.zeros((len(self.names), int(self.corners.max(initial=-1)) + 1), dtype=np.int64)
        at[np.repeat(self.facets, 3), self.corners.ravel()] = 1
        return np.asarray(at @ at.T)

    @property
    def _first_edges(self) -> int:
        """Return the first number of a pair of edges."""
        return (int(self.triangles.max(initial=0)) + 1) * len(self.triangles)

    def _pairs_of(self, first: Indices, second: Indices) -> Pairs:
        """Return the pairs of elements of pairs of triangles, each pair once."""
        # of several pairs of facets to which a pair of elements belongs, the one with the fewest common corners counts
        order = np.argsort(self._common[self.facets[first], self.facets[second]], kind="stable")
        first, second = first[order], second[order]
        codes, points, shared, facets = list[Indices](), list[Indices](), list[Indices](), list[Indices]()
        count = len(self.triangles)
        for one, other in ((first, second), (second, first)):
            for corner in _CORNERS:
                point = self.triangles[one, corner]
                codes.append(point * count + other)
                points.append(np.column_stack([point, self.triangles[other]]))
                shared.append((self.corners[one, corner][:, None] == self.corners[other]).any(axis=1))
                facets.append(np.column_stack([self.facets[one], self.facets[other]]))
        ends, ids, sides = self._edges
        for one_side in _CORNERS:
            for other_side in _CORNERS:
                edges = np.sort(np.column_stack([sides[first, one_side], sides[second, other_side]]), axis=1)
                codes.append(self._first_edges + edges[:, 0] * len(ends) + edges[:, 1])
                points.append(ends[edges].reshape(-1, 4))
                shared.append((ids[edges[:, 0]][:, :, None] == ids[edges[:, 1]][:, None]).any(axis=(1, 2)))
                facets.append(np.column_stack([self.facets[first], self.facets[second]]))
        every, known = np.concatenate(codes), np.concatenate(shared)
        rows = np.flatnonzero(~known)
        unique, at = np.unique(every[rows], return_index=True)
        rows = rows[at]
        corners = int(np.count_nonzero(unique < self._first_edges))
        return Pairs(unique, np.concatenate(points)[rows], corners, np.concatenate(facets)[rows])


def _volumes(places: Array) -> Array:
    """Return six times the signed volumes of tetrahedra, m^3, (pair,)."""
    first, second, third = (places[:, number] - places[:, 0] for number in (1, 2, 3))
    return np.asarray(np.einsum("px,px->p", first, np.cross(second, third)))
