"""The creases and sectors around every interior vertex of a flat or folded sheet."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from forficula.arrays import Array, Indices
from forficula.pattern.crease_pattern import CreasePattern, interior_vertices
from forficula.pattern.geometry import cross
from forficula.pattern.shared_edges import shared_edges


@dataclass(frozen=True, kw_only=True, eq=False)
class VertexCreases:
    """Creases and sectors at a vertex.

    Attributes:
        vertex: number of the vertex.
        edges: numbers of the edges at the vertex without flat ones, counterclockwise, shape (degree,).
        sectors: angles between the edges, rad, shape (degree,): number i lies between edges i and i + 1; empty without
            edges.
        total: sum of the facet angles around the vertex, rad.
    """

    vertex: int
    edges: Indices
    sectors: Array
    total: float


@lru_cache(maxsize=4)  # several facts about one pattern need it
def vertex_creases(pattern: CreasePattern) -> tuple[VertexCreases, ...]:
    """Collect the creases around every interior vertex, in the order of `interior_vertices`.

    Raises:
        InputError: faces are not counterclockwise.
    """
    left_of = {(edge.tail, edge.head): (edge.left, edge.edge) for edge in shared_edges(pattern)}
    left_of |= {(edge.head, edge.tail): (edge.right, edge.edge) for edge in shared_edges(pattern)}
    start: dict[int, int] = {vertex: facet for facet, face in enumerate(pattern.faces_vertices) for vertex in face}
    return tuple(_around(pattern, vertex, start[vertex], left_of) for vertex in interior_vertices(pattern).tolist())


def _around(
    pattern: CreasePattern, vertex: int, start: int, left_of: dict[tuple[int, int], tuple[int, int]]
) -> VertexCreases:
    """Collect the creases around one vertex, beginning at the facet `start`."""
    edges: list[int] = []
    corners: list[float] = []
    facet = start
    while not corners or facet != start:
        face = pattern.faces_vertices[facet]
        place = face.index(vertex)
        corners.append(_corner(pattern.vertices_coords[list(face)], place))
        facet, edge = left_of[vertex, face[place - 1]]
        edges.append(edge)
    folds = [place for place, edge in enumerate(edges) if pattern.edges_assignment[edge] != "F"]
    # the corner after an edge is the next one in the list
    order = np.roll(corners, -1)
    if folds:
        first = min(folds, key=lambda place: edges[place])
        order, edges = np.roll(order, -first), edges[first:] + edges[:first]
        folds = [place for place, edge in enumerate(edges) if pattern.edges_assignment[edge] != "F"]
    return VertexCreases(
        vertex=vertex,
        edges=np.array([edges[place] for place in folds], dtype=np.int64),
        sectors=np.add.reduceat(order, folds) if folds else np.zeros(0),
        total=float(np.sum(corners)),
    )


def _corner(points: Array, place: int) -> float:
    """Return the angle at a corner of a facet, rad: more than 180 deg where the corner points inwards."""
    after, before = points[(place + 1) % len(points)] - points[place], points[place - 1] - points[place]
    normal = cross(after, before)
    angle = float(np.arctan2(np.linalg.norm(normal), after @ before))
    arms = (points - points[place]).T
    inwards = normal @ cross(arms, np.roll(arms, -1, axis=1)).sum(axis=1) < 0
    return 2 * math.pi - angle if inwards else angle
