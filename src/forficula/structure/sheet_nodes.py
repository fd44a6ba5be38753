"""The nodes of a sheet that bends: one at every vertex, several at one where cuts let it come apart."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from forficula.design.sheet_places import facet_of, vertex_of
from forficula.pattern import CreasePattern, triangulated
from forficula.pattern.cut_open import cut_open


class SheetNodes(NamedTuple):
    """A sheet cut open and split into triangles.

    Attributes:
        triangles: the pattern of triangles; the edges of the sheet keep their numbers.
        facets: nodes of every facet.
        vertices: number of the sheet's vertex at each node, (node,).
        names: of the nodes.
    """

    triangles: CreasePattern
    facets: tuple[tuple[int, ...], ...]
    vertices: NDArray[np.int64]
    names: tuple[str, ...]


def sheet_nodes(sheet: CreasePattern) -> SheetNodes:
    """Find the nodes of a sheet.

    Raises:
        InputError: a facet that diagonals cannot split.
    """
    opened = cut_open(sheet)
    count = len(sheet.vertices_coords)
    vertices = opened.vertices.tolist()
    names = tuple(
        f"vertex{vertex}" if node < count else f"vertex{vertex}_{vertices[:node].count(vertex)}"
        for node, vertex in enumerate(vertices)
    )
    return SheetNodes(triangulated(opened.pattern).pattern, opened.pattern.faces_vertices, opened.vertices, names)


def node_of(sheet: CreasePattern, nodes: SheetNodes, text: str) -> int:
    """The node at a vertex written as "vertex 4" or, where cuts meet, "vertex 4 of facet 2".

    Raises:
        InputError: there is no such vertex.
    """
    vertex, facet = vertex_of(sheet, text)
    if facet is None:
        return vertex
    return next(node for node in nodes.facets[facet] if nodes.vertices[node] == vertex)


def held_axes(sheet: CreasePattern, nodes: SheetNodes, text: str, axes: str | None) -> dict[int, set[int]]:
    """The axes, 0 to 2, along which a support holds nodes, by their numbers."""
    written = {"xyz".index(axis) for axis in axes or "xyz"}
    if text.strip().startswith("facet"):
        return dict.fromkeys(nodes.facets[facet_of(sheet, text)], written)
    return {node_of(sheet, nodes, text): written}
