"""Points of a sheet by its facets: a vertex where a cut or a single corner separates facets has several points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.drawings.flat_faces import parts_of
from forficula.pattern.shared_edges import SharedEdge, shared_edges

Numbers = NDArray[np.int64]


@dataclass(frozen=True, kw_only=True)
class FacetNodes:
    """Facets and the points that they share across edges; a vertex may have several points.

    Attributes:
        vertices: vertex of every point, shape (points,).
        facets: points of every facet, in the order of its vertices.
        shared: edges between two facets, except cuts.
        plates: number of the plate of every facet; flat edges join facets to plates, shape (facets,).
        parts: number of the connected piece of the sheet of every facet, shape (facets,).
    """

    vertices: Numbers
    facets: tuple[Numbers, ...]
    shared: tuple[SharedEdge, ...]
    plates: Numbers
    parts: Numbers


def facet_nodes(pattern: CreasePattern) -> FacetNodes:
    """Separate the points of a sheet where facets are not connected.

    Raises:
        InputError: faces that are not counterclockwise.
    """
    shared, faces = tuple(shared_edges(pattern)), pattern.faces_vertices
    first = np.cumsum([0, *map(len, faces)])
    corner = {(facet, v): int(first[facet]) + index for facet, face in enumerate(faces) for index, v in enumerate(face)}
    pairs = [
        (corner[edge.left, vertex], corner[edge.right, vertex]) for edge in shared for vertex in (edge.tail, edge.head)
    ]
    points = parts_of(int(first[-1]), pairs)
    vertices = np.zeros(int(points.max()) + 1, dtype=np.int64)
    vertices[points] = [vertex for face in faces for vertex in face]
    flat = [(edge.left, edge.right) for edge in shared if pattern.edges_assignment[edge.edge] == "F"]
    return FacetNodes(
        vertices=vertices,
        facets=tuple(np.split(points, first[1:-1])),
        shared=shared,
        plates=parts_of(len(faces), flat),
        parts=parts_of(len(faces), [(edge.left, edge.right) for edge in shared]),
    )
