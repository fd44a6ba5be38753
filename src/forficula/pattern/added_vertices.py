"""Addition of vertices to a sheet of triangles, at places between its vertices where something acts on it."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from forficula.arrays import Array, Indices
from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.geometry import triangle_areas
from forficula.pattern.triangulation import Triangulation

# share of the sheet's size: a place nearer than this to a vertex or an edge is on it
_NEAR = 1e-6


class AddedVertices(NamedTuple):
    """A pattern of triangles with added vertices.

    Attributes:
        pattern: pattern of triangles; existing vertices and edges keep their numbers.
        facets: number of the facet to which each triangle belongs, shape (triangles,).
        sources: number of the edge to which each edge belongs, its own number if it is whole or new, shape (edges,).
        vertices: number of the vertex at each place, in the order of the places.
    """

    pattern: CreasePattern
    facets: Indices
    sources: Indices
    vertices: tuple[int, ...]


class _Edge(NamedTuple):
    """An additional edge, and the edge to which it belongs."""

    ends: tuple[int, int]
    letter: str = "F"
    angle: float = 0.0
    role: str = "diagonal"
    source: int | None = None


def with_vertices(split: Triangulation, places: Sequence[tuple[int, Array]]) -> AddedVertices:
    """Add vertices at places on facets.

    A place whose distance from a vertex of its triangle is less than 1e-6 of the sheet's size is that vertex. A place
    as near to an edge splits the edge: the part from the tail keeps its number, the other part follows all edges with
    the same letter, angle and role, and flat edges connect the new vertex with the opposite corners. A place inside a
    triangle splits it into three by flat edges. Along a cut only the side of the place's facet is split.

    Args:
        split: the sheet in triangles.
        places: numbers of facets with positions on them, m, (3,); on a facet that is not flat, a position is moved to
            the nearest triangle.
    """
    count = len(split.pattern.edges_vertices)
    sheet = AddedVertices(split.pattern, split.facets, np.arange(count), ())
    near = _NEAR * float(np.ptp(split.pattern.vertices_coords, axis=0).max())
    for facet, position in places:
        sheet = _with_vertex(sheet, facet, position, near)
    return sheet


def _with_vertex(sheet: AddedVertices, facet: int, position: Array, near: float) -> AddedVertices:
    """Add one vertex."""
    coords = sheet.pattern.vertices_coords
    triangles = np.flatnonzero(sheet.facets == facet).tolist()
    shares = [_shares(coords[list(sheet.pattern.faces_vertices[face])], position) for face in triangles]
    best = int(np.argmax([share.min() for share in shares]))
    face, share = triangles[best], np.maximum(shares[best], 0.0)
    corners = sheet.pattern.faces_vertices[face]
    places = coords[list(corners)]
    sides = np.linalg.norm(np.roll(places, -2, axis=0) - np.roll(places, -1, axis=0), axis=1)
    double = 2 * float(triangle_areas(places))
    # move a position near an edge exactly onto the edge
    share[share * double / sides <= near] = 0.0
    position = share @ places / share.sum()
    away = np.linalg.norm(places - position, axis=1)
    if away.min() <= near:
        return sheet._replace(vertices=(*sheet.vertices, corners[int(np.argmin(away))]))
    if share.all():
        return _in_triangle(sheet, face, position)
    beyond = int(np.argmin(share))
    return _on_edge(sheet, face, {corners[beyond - 1], corners[beyond - 2]}, position)


def _shares(corners: Array, position: Array) -> Array:
    """Compute barycentric coordinates of the projection of a position on a triangle's plane, (3,)."""
    along = (corners[1:] - corners[0]).T
    two = np.linalg.lstsq(along, position - corners[0], rcond=None)[0]
    return np.array([1 - two.sum(), *two])


def _in_triangle(sheet: AddedVertices, face: int, position: Array) -> AddedVertices:
    one, two, three = sheet.pattern.faces_vertices[face]
    added = len(sheet.pattern.vertices_coords)
    parts: list[tuple[int, ...]] = [(one, two, added), (two, three, added), (three, one, added)]
    edges = [_Edge((corner, added)) for corner in (one, two, three)]
    return _rebuilt(sheet, position, {face: parts}, edges, None)


def _on_edge(sheet: AddedVertices, face: int, ends: set[int], position: Array) -> AddedVertices:
    pattern = sheet.pattern
    edge = next(number for number, pair in enumerate(pattern.edges_vertices.tolist()) if set(pair) == ends)
    tail, head = pattern.edges_vertices[edge].tolist()
    added = len(pattern.vertices_coords)
    letter = pattern.edges_assignment[edge]
    part = _Edge((added, head), letter, float(pattern.edges_fold_angle[edge]), pattern.edges_role[edge])
    part = part._replace(source=int(sheet.sources[edge]))
    beside = [number for number, corners in enumerate(pattern.faces_vertices) if ends <= set(corners)]
    parted = letter == "C" and len(beside) > 1
    parts, edges = {}, [part]
    if parted:
        beside = [face]
        edges.append(part._replace(ends=(tail, added)))
    for number in beside:
        corners = pattern.faces_vertices[number]
        parts[number] = [tuple(added if corner == gone else corner for corner in corners) for gone in (head, tail)]
        edges.append(_Edge((sum(corners) - tail - head, added)))
    return _rebuilt(sheet, position, parts, edges, None if parted else (edge, (tail, added)))


def _rebuilt(
    sheet: AddedVertices,
    position: Array,
    parts: dict[int, list[tuple[int, ...]]],
    edges: list[_Edge],
    shortened: tuple[int, tuple[int, int]] | None,
) -> AddedVertices:
    """Return the sheet with some triangles replaced by parts, additional edges, and one edge shortened."""
    pattern = sheet.pattern
    pairs, first = pattern.edges_vertices.tolist(), len(pattern.edges_vertices)
    if shortened is not None:
        pairs[shortened[0]] = shortened[1]
    faces = [parts.get(number, [corners]) for number, corners in enumerate(pattern.faces_vertices)]
    changed = dataclasses.replace(
        pattern,
        vertices_coords=np.concatenate([pattern.vertices_coords, position[None]]),
        edges_vertices=np.array([*pairs, *(edge.ends for edge in edges)], dtype=np.int64),
        edges_assignment=(*pattern.edges_assignment, *(edge.letter for edge in edges)),
        edges_fold_angle=np.array([*pattern.edges_fold_angle, *(edge.angle for edge in edges)]),
        edges_role=(*pattern.edges_role, *(edge.role for edge in edges)),
        edges_fold=np.array([*pattern.edges_fold, *range(first, first + len(edges))]),
        faces_vertices=tuple(corners for pieces in faces for corners in pieces),
    )
    sources = [first + index if edge.source is None else edge.source for index, edge in enumerate(edges)]
    return AddedVertices(
        changed,
        np.repeat(sheet.facets, [len(pieces) for pieces in faces]),
        np.array([*sheet.sources, *sources], dtype=np.int64),
        (*sheet.vertices, len(pattern.vertices_coords)),
    )
