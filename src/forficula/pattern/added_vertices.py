"""Vertices added to a sheet of triangles, where something acts on it between those that it has."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from forficula.arrays import Array, Indices
from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.geometry import triangle_areas
from forficula.pattern.triangulation import Triangulation

# share of the sheet's size: a place this near to a vertex or an edge is on it
_NEAR = 1e-6


class AddedVertices(NamedTuple):
    """A pattern of triangles with more vertices, and where its parts come from.

    Attributes:
        pattern: of triangles; vertices and edges that it had keep their numbers.
        facets: number of the facet that every triangle is part of, shape (triangles,).
        sources: number of the edge that every edge is part of, its own if it is whole or new, shape (edges,).
        vertices: number of the vertex at each place, in their order.
    """

    pattern: CreasePattern
    facets: Indices
    sources: Indices
    vertices: tuple[int, ...]


class _Edge(NamedTuple):
    """A further edge, and what it is part of."""

    ends: tuple[int, int]
    letter: str = "F"
    angle: float = 0.0
    role: str = "diagonal"
    source: int | None = None


def with_vertices(split: Triangulation, places: Sequence[tuple[int, Array]]) -> AddedVertices:
    """Make vertices of places on facets.

    A place within 1e-6 of the sheet's size of a vertex of its triangle is that vertex. One as near to an edge splits
    it: the first part, from its tail, keeps its number, the other follows all edges with its letter, angle and role,
    and flat edges run from the vertex to the corners beside it. One inside a triangle splits that into three by flat
    edges. Along a cut only the side of the facet is split.

    Args:
        split: the sheet in triangles.
        places: numbers of facets, and positions on them, m, (3,); where a facet is not flat they move onto its nearest
            triangle.
    """
    count = len(split.pattern.edges_vertices)
    sheet = AddedVertices(split.pattern, split.facets, np.arange(count), ())
    near = _NEAR * float(np.ptp(split.pattern.vertices_coords, axis=0).max())
    for facet, position in places:
        sheet = _with_vertex(sheet, facet, position, near)
    return sheet


def _with_vertex(sheet: AddedVertices, facet: int, position: Array, near: float) -> AddedVertices:
    """One more place."""
    coords = sheet.pattern.vertices_coords
    own = np.flatnonzero(sheet.facets == facet).tolist()
    shares = [_shares(coords[list(sheet.pattern.faces_vertices[face])], position) for face in own]
    best = int(np.argmax([each.min() for each in shares]))
    face, share = own[best], np.maximum(shares[best], 0.0)
    corners = sheet.pattern.faces_vertices[face]
    places = coords[list(corners)]
    sides = np.linalg.norm(np.roll(places, -2, axis=0) - np.roll(places, -1, axis=0), axis=1)
    double = 2 * float(triangle_areas(places))
    # of an edge that it is on, so that all lies on it
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
    """Barycentric coordinates of the foot of a position in a triangle's plane, (3,)."""
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
    """The sheet with triangles replaced by parts, further edges with what they are part of, and one shortened."""
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
        faces_vertices=tuple(corners for each in faces for corners in each),
    )
    sources = [first + place if edge.source is None else edge.source for place, edge in enumerate(edges)]
    return AddedVertices(
        changed,
        np.repeat(sheet.facets, [len(each) for each in faces]),
        np.array([*sheet.sources, *sources], dtype=np.int64),
        (*sheet.vertices, len(pattern.vertices_coords)),
    )
