"""Pairs of parts that are close to each other: nodes near triangles, and sides near sides."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from forficula.arrays import Array, Flags, Indices
from forficula.structure.contact.distances import Nearest, node_from_triangle, side_from_side, side_through_triangle
from forficula.structure.contact.touching_parts import TouchingParts


@dataclass(frozen=True, kw_only=True, eq=False)
class Pairs:
    """Pairs of shapes with four nodes: first those of a node and a triangle, then those of two sides.

    Attributes:
        nodes: of each pair, (pair, 4).
        of_triangles: number of pairs of a node and a triangle.
        thickness: distance at which each pair touches, m, (pair,).
        parts: of the first and of the second shape, (pair, 2).
    """

    nodes: Indices
    of_triangles: int
    thickness: Array
    parts: Indices

    def nearest(self, places: Array) -> Nearest:
        """Compute the distances of all pairs for positions of the nodes, m, (node, 3)."""
        corners = places[self.nodes]
        if self.of_triangles == len(corners):
            return node_from_triangle(corners)
        one = node_from_triangle(corners[: self.of_triangles])
        other = side_from_side(corners[self.of_triangles :])
        return Nearest(
            distances=np.concatenate([one.distances, other.distances]),
            weights=np.concatenate([one.weights, other.weights]),
            normals=np.concatenate([one.normals, other.normals]),
        )

    def some(self, which: Flags) -> Pairs:
        """Select pairs."""
        return Pairs(
            nodes=self.nodes[which],
            of_triangles=int(np.count_nonzero(which[: self.of_triangles])),
            thickness=self.thickness[which],
            parts=self.parts[which],
        )


def near_pairs(parts: TouchingParts, places: Array, reach: float) -> Pairs:
    """Return the pairs whose surfaces may be closer to each other than a distance.

    Args:
        parts: of a structure.
        places: positions of the nodes, m, (node, 3).
        reach: the distance, m.
    """
    node, triangle = _near_triangles(parts, places, reach)
    one, other = _near_sides(parts, places, reach)
    of_nodes, of_triangles = parts.node_parts[node], parts.triangle_parts[triangle]
    of_one, of_other = parts.side_parts[one, 0], parts.side_parts[other, 0]
    return Pairs(
        nodes=np.concatenate(
            [
                np.column_stack([node, parts.triangles[triangle]]),
                np.column_stack([parts.sides[one], parts.sides[other]]),
            ]
        ),
        of_triangles=len(node),
        thickness=np.concatenate(
            [parts.half[of_nodes] + parts.half[of_triangles], parts.half[of_one] + parts.half[of_other]]
        ),
        parts=np.concatenate([np.column_stack([of_nodes, of_triangles]), np.column_stack([of_one, of_other])]),
    )


def parts_that_cross(parts: TouchingParts, places: Array) -> list[tuple[int, int]]:
    """Return the pairs of parts whose middle surfaces pass through each other, by number.

    Args:
        parts: of a structure.
        places: positions of the nodes, m, (node, 3).
    """
    side, triangle = _close(places[parts.sides], places[parts.triangles], 0.0)
    # sides that meet a triangle at a vertex do not pass through it
    meets = parts.vertices[parts.sides[side]][:, :, None] == parts.vertices[parts.triangles[triangle]][:, None]
    apart = parts.side_apart[parts.side_parts[side], parts.triangle_parts[triangle][:, None]].all(axis=1)
    apart &= ~meets.any(axis=(1, 2))
    side, triangle = side[apart], triangle[apart]
    through = side_through_triangle(
        np.concatenate([places[parts.sides[side]], places[parts.triangles[triangle]]], axis=1)
    )
    owners = np.column_stack([parts.side_parts[side, 0], parts.triangle_parts[triangle]])[through]
    return [(one, other) for one, other in np.unique(np.sort(owners, axis=1), axis=0).tolist()]


def _near_triangles(parts: TouchingParts, places: Array, reach: float) -> tuple[Indices, Indices]:
    """Return nodes and triangles that may be within reach of each other."""
    node, triangle = _close(places[:, None], places[parts.triangles], _surfaces(parts, reach))
    apart = parts.node_apart[node, parts.triangle_parts[triangle]]
    return node[apart], triangle[apart]


def _near_sides(parts: TouchingParts, places: Array, reach: float) -> tuple[Indices, Indices]:
    """Return pairs of sides that may be within reach of each other."""
    ends = places[parts.sides]
    one, other = _close(ends, ends, _surfaces(parts, reach))
    apart = one < other
    one, other = one[apart], other[apart]
    vertices = parts.vertices[parts.sides]
    apart = ~(vertices[one][:, :, None] == vertices[other][:, None]).any(axis=(1, 2))
    owners = parts.side_parts
    # a crease is a side of two facets
    apart &= parts.side_apart[owners[one][:, :, None], owners[other][:, None]].all(axis=(1, 2))
    return one[apart], other[apart]


def _surfaces(parts: TouchingParts, reach: float) -> float:
    """Return the distance of middle surfaces whose surfaces are within reach."""
    return reach + 2 * float(parts.half.max(initial=0.0))


def _close(one: Array, other: Array, reach: float) -> tuple[Indices, Indices]:
    """Return indices of shapes whose bounding boxes are within reach; corners, (shape, corner, 3)."""
    if not len(one) or not len(other):
        return np.zeros(0, dtype=np.int64), np.zeros(0, dtype=np.int64)
    middles = [shapes.mean(axis=1) for shapes in (one, other)]
    sizes = [
        float(np.sqrt(((shapes - middle[:, None]) ** 2).sum(axis=2)).max())
        for shapes, middle in zip((one, other), middles, strict=True)
    ]
    near = cKDTree(middles[0]).sparse_distance_matrix(cKDTree(middles[1]), sum(sizes) + reach, output_type="ndarray")
    first, second = np.asarray(near["i"], dtype=np.int64), np.asarray(near["j"], dtype=np.int64)
    gap = np.maximum(
        one.min(axis=1)[first] - other.max(axis=1)[second], other.min(axis=1)[second] - one.max(axis=1)[first]
    )
    close = (gap <= reach).all(axis=1)
    order = np.lexsort((second[close], first[close]))
    return first[close][order], second[close][order]
