"""Points of a sheet as its facets hold them: what a cut parts, or what hangs together by a corner only, are two."""

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
    """Facets by the points that they share across edges; a point is a vertex, or one of several at it.

    Attributes:
        vertices: the vertex of every point, shape (points,).
        facets: the points of every facet, in the order of its vertices.
        shared: the edges between two facets, but for cuts.
        plates: of every facet, the number of the plate that it makes with those beyond its flat edges, shape (facets,).
        parts: of every facet, the number of the piece of the sheet that it is in, shape (facets,).
    """

    vertices: Numbers
    facets: tuple[Numbers, ...]
    shared: tuple[SharedEdge, ...]
    plates: Numbers
    parts: Numbers


def facet_nodes(pattern: CreasePattern) -> FacetNodes:
    """Take a sheet apart where nothing holds it together.

    Raises:
        InputError: faces that are not counterclockwise.
    """
    shared, faces = tuple(shared_edges(pattern)), pattern.faces_vertices
    first = np.cumsum([0, *map(len, faces)])
    corner = {(facet, v): int(first[facet]) + place for facet, face in enumerate(faces) for place, v in enumerate(face)}
    pairs = [
        (corner[each.left, vertex], corner[each.right, vertex]) for each in shared for vertex in (each.tail, each.head)
    ]
    points = parts_of(int(first[-1]), pairs)
    vertices = np.zeros(int(points.max()) + 1, dtype=np.int64)
    vertices[points] = [vertex for face in faces for vertex in face]
    flat = [(each.left, each.right) for each in shared if pattern.edges_assignment[each.edge] == "F"]
    return FacetNodes(
        vertices=vertices,
        facets=tuple(np.split(points, first[1:-1])),
        shared=shared,
        plates=parts_of(len(faces), flat),
        parts=parts_of(len(faces), [(each.left, each.right) for each in shared]),
    )
