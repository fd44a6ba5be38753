"""Contact of a net: pairs of elements that are near, the forces between those that touch, and motions that cross."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from scipy.sparse import csr_array, eye_array, kron

from forficula.arrays import Array, Indices
from forficula.statics.net.contact.closest import Closest, corner_to_triangle, edge_to_edge
from forficula.structure.contact.pairs import Pairs, near_pairs
from forficula.structure.contact.touching_parts import TouchingParts

_HALVINGS = 40  # of a motion, to locate the time at which four points are in one plane
_TIMES = np.linspace(0.0, 1.0, 4)  # at which a cubic function is known
_INTERPOLATION = np.linalg.inv(np.vander(_TIMES, increasing=True))
_MARGIN = 0.05  # of the size: additional distance within which pairs are kept while the net moves
_CROSSED = 1e-6  # of the size of two elements: their distance when they cross


@dataclass(frozen=True, kw_only=True, eq=False)
class Pressing:
    """Pairs of elements that press on each other.

    Attributes:
        pairs: a corner and a triangle, or two sides.
        forces: pushing the elements apart, > 0, N, (pair,).
    """

    pairs: Pairs
    forces: Array


@dataclass(kw_only=True, eq=False)
class _NearPairs:
    """Pairs that were near at some places, m, (corner, 3), within a reach, m."""

    places: Array = field(default_factory=lambda: np.zeros((0, 3)))
    reach: float = 0.0
    pairs: Pairs | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class NetContact:
    """Parts of a net that keep a distance from one another.

    Attributes:
        parts: of the structure.
        points: weights of the nodes of the net at the corners of the parts, (corner, node).
        stiffness: of the augmented Lagrangian, N/m; it affects the convergence and not the result.
        larger: share by which triangles and sides count as larger. Without it, corners of equal layers on one another
            are at the ends of the ranges of many closest points, and their forces converge slowly.
        size: of the largest element, m.
    """

    parts: TouchingParts
    points: csr_array
    stiffness: float
    larger: float
    size: float

    @cached_property
    def spread(self) -> csr_array:
        """Return the derivatives of the coordinates of the corners by those of the nodes."""
        return csr_array(kron(self.points, eye_array(3)))

    @cached_property
    def dense_spread(self) -> Array:
        """Return the same derivatives as a dense matrix."""
        return np.asarray(self.spread.toarray())

    def near(self, places: Array, pressing: Pressing | None = None) -> tuple[Pairs, Array]:
        """Return pairs of elements that may touch, and their forces at the last equilibrium, N, (pair,).

        Args:
            places: of the corners, m, (corner, 3).
            pressing: pairs that are included in any case; None for none.
        """
        pairs = self._pairs(places, 2 * self.larger * self.size)
        if pressing is None or not len(pressing.forces):
            return pairs, np.zeros(len(pairs.nodes))
        size = len(places)
        known, all_known = self._codes(pairs, size), self._codes(pressing.pairs, size)
        pairs = _together(pairs.some(~np.isin(known, all_known)), pressing.pairs)
        order = np.argsort(all_known)
        codes = self._codes(pairs, size)
        places_of = np.minimum(np.searchsorted(all_known[order], codes), len(order) - 1)
        same = all_known[order][places_of] == codes
        return pairs, np.where(same, pressing.forces[order][places_of], 0.0)

    def _pairs(self, places: Array, reach: float) -> Pairs:
        """Return pairs whose surfaces may be closer than a distance.

        Pairs within a larger distance are kept until a corner has moved by half the difference (Verlet 1967, Phys. Rev.
        159, 98).
        """
        last = self._last
        moved = np.inf if last.pairs is None else float(np.linalg.norm(places - last.places, axis=1).max(initial=0.0))
        if last.pairs is None or reach + 2 * moved > last.reach:
            last.reach = reach + _MARGIN * self.size
            last.places, last.pairs = places.copy(), near_pairs(self.parts, places, last.reach)
        at, first = places[last.pairs.nodes], last.pairs.of_triangles
        apart = np.concatenate([_gaps(at[:first], 1), _gaps(at[first:], 2)])
        return last.pairs.some(apart <= reach + last.pairs.thickness)

    @cached_property
    def _last(self) -> _NearPairs:
        """Return the last pairs, which change while the net moves."""
        return _NearPairs()

    def closest(self, at: Array, of_triangles: int) -> Closest:
        """Return the closest points of pairs: first those of a corner and a triangle, then those of two sides.

        Args:
            at: places of the four corners of each pair, m, (pair, 4, 3).
            of_triangles: number of pairs of a corner and a triangle.
        """
        parts = corner_to_triangle(at[:of_triangles], self.larger), edge_to_edge(at[of_triangles:], self.larger)
        return Closest(*(np.concatenate(values) for values in zip(*parts, strict=True)))

    def crossed(self, before: Array, after: Array) -> bool:
        """Return whether elements pass through each other while all corners move along straight lines.

        Args:
            before: places before the motion, m, (corner, 3).
            after: places after the motion, m, (corner, 3).
        """
        moved = float(np.linalg.norm(after - before, axis=1).max(initial=0.0))
        pairs = self._pairs(before, 2 * moved)
        start, end = before[pairs.nodes], after[pairs.nodes]
        # the volume of a moving tetrahedron is a cubic function of time
        volumes = np.array([_volumes(start + time * (end - start)) for time in _TIMES])
        rows = np.flatnonzero(volumes[0] * volumes[-1] < 0)
        if not len(rows):
            return False
        cubic = _INTERPOLATION @ volumes[:, rows]
        low, high = np.zeros(len(rows)), np.ones(len(rows))
        for _ in range(_HALVINGS):
            middle = (low + high) / 2
            value = ((cubic[3] * middle + cubic[2]) * middle + cubic[1]) * middle + cubic[0]
            same = value * cubic[0] > 0
            low, high = np.where(same, middle, low), np.where(same, high, middle)
        at = start[rows] + low[:, None, None] * (end - start)[rows]
        apart = self.closest(at, int(np.count_nonzero(rows < pairs.of_triangles))).distance
        size = np.abs(at - at.mean(axis=1, keepdims=True)).max(axis=(1, 2), initial=0.0)
        return bool(np.any(apart <= _CROSSED * size))

    def parts_of(self, pairs: Pairs) -> list[tuple[int, int]]:
        """Return the numbers of the two parts of every pair, the smaller first.

        An element on a crease belongs to several parts. Of these, the two with the fewest common corners count.
        """
        of_triangle = self._parts_of_triangles
        result = []
        for row, nodes in enumerate(pairs.nodes.tolist()):
            if row < pairs.of_triangles:
                choices = [self._at(nodes[:1]), of_triangle[tuple(nodes[1:])]]
            else:
                choices = [self._at(nodes[:2]), self._at(nodes[2:])]
            one, other = min(
                ((one, other) for one in choices[0] for other in choices[1] if one != other),
                key=lambda parts: (len(self._vertices[parts[0]] & self._vertices[parts[1]]), parts),
            )
            result.append((min(one, other), max(one, other)))
        return result

    def _at(self, nodes: Sequence[int]) -> list[int]:
        """Return the parts that have all of some corners."""
        held = [{int(self.parts.vertices[node])} for node in nodes]
        return [part for part, vertices in enumerate(self._vertices) if all(one <= vertices for one in held)]

    @cached_property
    def _vertices(self) -> tuple[set[int], ...]:
        """Return the vertices of every part."""
        vertices, result = self.parts.vertices, [set[int]() for _ in self.parts.names]
        for nodes, part in zip(self.parts.triangles, self.parts.triangle_parts, strict=True):
            result[part] |= set(vertices[nodes].tolist())
        for nodes, owners in zip(self.parts.sides, self.parts.side_parts, strict=True):
            for part in set(owners.tolist()):
                result[part] |= set(vertices[nodes].tolist())
        return tuple(result)

    @cached_property
    def _parts_of_triangles(self) -> dict[tuple[int, ...], list[int]]:
        """Return the part of each triangle, by its corners."""
        triangles = zip(self.parts.triangles.tolist(), self.parts.triangle_parts.tolist(), strict=True)
        return {tuple(nodes): [part] for nodes, part in triangles}

    @staticmethod
    def _codes(pairs: Pairs, size: int) -> Indices:
        """Return different numbers for different pairs, (pair,)."""
        codes = (np.arange(len(pairs.nodes)) >= pairs.of_triangles).astype(np.int64)
        for corner in range(4):
            codes = codes * size + pairs.nodes[:, corner]
        return codes


def _together(one: Pairs, other: Pairs) -> Pairs:
    """Return all pairs of two sets without common ones."""
    first = np.concatenate(
        [
            np.arange(len(one.nodes)) >= one.of_triangles,
            np.arange(len(other.nodes)) >= other.of_triangles,
        ]
    )
    order = np.argsort(first, kind="stable")
    return Pairs(
        nodes=np.concatenate([one.nodes, other.nodes])[order],
        of_triangles=one.of_triangles + other.of_triangles,
        thickness=np.concatenate([one.thickness, other.thickness])[order],
        parts=np.concatenate([one.parts, other.parts])[order],
    )


def _gaps(at: Array, corners: int) -> Array:
    """Return the largest gap along an axis between the first corners of pairs and the others, m, (pair,)."""
    one, other = at[:, :corners], at[:, corners:]
    gap = np.maximum(one.min(axis=1) - other.max(axis=1), other.min(axis=1) - one.max(axis=1))
    return np.asarray(gap.max(axis=1, initial=-np.inf))


def _volumes(places: Array) -> Array:
    """Return six times the signed volumes of tetrahedra, m^3, (pair,)."""
    first, second, third = (places[:, number] - places[:, 0] for number in (1, 2, 3))
    return np.asarray(np.einsum("px,px->p", first, np.cross(second, third)))
