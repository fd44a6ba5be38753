"""The nodes of a sheet that bends: one at every vertex, and several at a vertex where cuts separate facets."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from forficula.arrays import Flags, Indices
from forficula.design import SheetDesign
from forficula.design.sheets.sheet_drives import places_of
from forficula.design.sheets.sheet_places import (
    GROUND_PLACE,
    as_place,
    edge_of,
    facet_of,
    is_vertex,
    place_on,
    vertex_of,
)
from forficula.pattern import CreasePattern, triangulated
from forficula.pattern.added_vertices import with_vertices
from forficula.pattern.crease_pattern import face_sides
from forficula.pattern.cut_open import cut_open

# largest distance of a node from an edge on which it lies, as a share of the edge's length: rounding
_BESIDE = 1e-9


class SheetNodes(NamedTuple):
    """A sheet cut open and split into triangles.

    Attributes:
        triangles: pattern of the triangles; the edges of the sheet keep their numbers.
        parts: number of the facet to which each triangle belongs, (triangle,).
        edges: number of the sheet's edge to which each edge belongs, (edge,).
        facets: nodes around every facet.
        inside: nodes inside every facet.
        vertices: number of the sheet's vertex at each node, (node,); -1 for a node between vertices.
        names: names of the nodes.
        places: node at each place that is not written as a vertex, by the text of the place.
    """

    triangles: CreasePattern
    parts: Indices
    edges: Indices
    facets: tuple[tuple[int, ...], ...]
    inside: tuple[tuple[int, ...], ...]
    vertices: Indices
    names: tuple[str, ...]
    places: dict[str, int]


def sheet_nodes(design: SheetDesign) -> SheetNodes:
    """Find the nodes of a sheet: its vertices, and the places of tendons, measures and forces.

    Raises:
        InputError: a facet that diagonals cannot split.
    """
    sheet = design.sheet
    opened = cut_open(sheet)
    texts = _places(design)
    placed = [place_on(sheet, text) for text in texts]
    added = with_vertices(triangulated(opened.pattern), [(place.facet, place.position) for place in placed])
    count = len(sheet.vertices_coords)
    vertices = opened.vertices.tolist()
    names = [
        f"vertex{vertex}" if node < count else f"vertex{vertex}_{vertices[:node].count(vertex)}"
        for node, vertex in enumerate(vertices)
    ]
    between = range(len(names), len(added.pattern.vertices_coords))
    facets = tuple(
        _around(added.pattern, added.facets == facet, corners)
        for facet, corners in enumerate(opened.pattern.faces_vertices)
    )
    return SheetNodes(
        triangles=added.pattern,
        parts=added.facets,
        edges=added.sources,
        facets=facets,
        inside=tuple(
            tuple(sorted(_corners(added.pattern, added.facets == facet) - set(around)))
            for facet, around in enumerate(facets)
        ),
        vertices=np.array([*vertices, *(-1 for _ in between)], dtype=np.int64),
        names=(*names, *(f"place{number}" for number, _ in enumerate(between))),
        places=dict(zip(texts, added.vertices, strict=True)),
    )


def _places(design: SheetDesign) -> list[str]:
    """Return the places of tendons, measures and forces that are not vertices, without duplicates."""
    ends = [getattr(joined, end) for joined in (*design.tendon, *design.measure) for end in ("from", "to")]
    pushed = [text for drive in design.drive for text in places_of(drive)]
    written = (as_place(text) for text in (*ends, *pushed) if text is not None)
    return [text for text in dict.fromkeys(written) if text != GROUND_PLACE and not is_vertex(text)]


def _around(triangles: CreasePattern, in_facet: Flags, corners: tuple[int, ...]) -> tuple[int, ...]:
    """Return the nodes around a facet: its corners, and the nodes on its sides."""
    sides = {side for face in np.flatnonzero(in_facet).tolist() for side in face_sides(triangles.faces_vertices[face])}
    following = {tail: head for tail, head in sides if (head, tail) not in sides}
    around = [corners[0]]
    while (node := following[around[-1]]) != corners[0]:
        around.append(node)
    return tuple(around)


def _corners(triangles: CreasePattern, in_facet: Flags) -> set[int]:
    return {node for face in np.flatnonzero(in_facet).tolist() for node in triangles.faces_vertices[face]}


def node_of(sheet: CreasePattern, nodes: SheetNodes, text: str) -> int:
    """Return the node at a place such as "vertex 4", "vertex 4 of facet 2" (where cuts meet) or "edge 12 at 0.5".

    Raises:
        InputError: there is no such vertex.
    """
    if not is_vertex(text):
        return nodes.places[as_place(text)]
    vertex, facet = vertex_of(sheet, text)
    if facet is None:
        return vertex
    return next(node for node in nodes.facets[facet] if nodes.vertices[node] == vertex)


def held_axes(sheet: CreasePattern, nodes: SheetNodes, text: str, axes: str | None) -> dict[int, set[int]]:
    """Return the axes, 0 to 2, along which a support holds nodes, by the numbers of the nodes."""
    written = {"xyz".index(axis) for axis in axes or "xyz"}
    if text.strip().startswith("facet"):
        return dict.fromkeys(_corners(nodes.triangles, nodes.parts == facet_of(sheet, text)), written)
    if not is_vertex(text):
        return dict.fromkeys(_along(sheet, nodes, *edge_of(sheet, text)), written)
    return {node_of(sheet, nodes, text): written}


def _along(sheet: CreasePattern, nodes: SheetNodes, edge: int, facet: int) -> list[int]:
    """Return the nodes of a facet that lie on one of its edges."""
    tail, head = sheet.vertices_coords[sheet.edges_vertices[edge]]
    around = list(nodes.facets[facet])
    away, along = nodes.triangles.vertices_coords[around] - tail, head - tail
    beside = np.linalg.norm(np.cross(away, along / np.linalg.norm(along)), axis=1)
    return [around[place] for place in np.flatnonzero(beside <= _BESIDE * np.linalg.norm(along)).tolist()]
