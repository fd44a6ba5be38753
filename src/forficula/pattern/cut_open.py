"""Opening of a sheet along its cuts, so that the facets on both sides of a cut have separate vertices."""

from __future__ import annotations

import dataclasses
from typing import NamedTuple

import numpy as np

from forficula.arrays import Indices
from forficula.pattern.crease_pattern import CreasePattern, face_sides
from forficula.pattern.shared_edges import shared_edges


class OpenSheet(NamedTuple):
    """A pattern without cuts between faces.

    Attributes:
        pattern: pattern with a separate vertex for every part of the sheet that meets at a vertex.
        vertices: number of the original vertex for each vertex, shape (vertices,).
    """

    pattern: CreasePattern
    vertices: Indices


def cut_open(pattern: CreasePattern) -> OpenSheet:
    """Split the vertices at which cuts, "C", separate faces.

    Faces around a vertex that are connected across edges other than cuts share one vertex. The group with the lowest
    face keeps the number of the vertex, new vertices follow all others. A cut that opens has an edge on each side: that
    of the lower face keeps the number, the other follows all edges. A cut that opens at neither end stays one edge.

    Returns:
        The opened sheet; the same pattern if it has no cuts.
    """
    if "C" not in pattern.edges_assignment:
        return OpenSheet(pattern, np.arange(len(pattern.vertices_coords)))
    corners = _corner_vertices(pattern)
    sources = list(range(len(pattern.vertices_coords)))
    numbers: dict[tuple[int, int], int] = {}
    faces = []
    for face, vertices in enumerate(pattern.faces_vertices):
        row = []
        for vertex in vertices:
            group = (vertex, corners[face, vertex])
            if group not in numbers:
                taken = any(known == vertex for known, _ in numbers)
                numbers[group] = len(sources) if taken else vertex
                sources += [vertex] if taken else []
            row.append(numbers[group])
        faces.append(tuple(row))
    return OpenSheet(_with_faces(pattern, faces, np.array(sources, dtype=np.int64)), np.array(sources, dtype=np.int64))


def _corner_vertices(pattern: CreasePattern) -> dict[tuple[int, int], int]:
    """Return, by face and vertex, the lowest face that is connected to the face around the vertex."""
    first = {(face, vertex): face for face, vertices in enumerate(pattern.faces_vertices) for vertex in vertices}
    joined = [
        ((left, vertex), (right, vertex))
        for _, tail, head, left, right in shared_edges(pattern)
        for vertex in (tail, head)
    ]
    changed = True
    while changed:
        changed = False
        for one, other in joined:
            lowest = min(first[one], first[other])
            changed |= first[one] != first[other]
            first[one] = first[other] = lowest
    return first


def _with_faces(pattern: CreasePattern, faces: list[tuple[int, ...]], sources: Indices) -> CreasePattern:
    """Return the pattern with new vertices of its faces, and the edges along these faces."""
    sides: dict[frozenset[int], list[frozenset[int]]] = {}
    for face in faces:
        for tail, head in face_sides(face):
            ends = frozenset((tail, head))
            copies = sides.setdefault(frozenset((int(sources[tail]), int(sources[head]))), [])
            if ends not in copies:
                copies.append(ends)
    edges, letters = pattern.edges_vertices.tolist(), list(pattern.edges_assignment)
    angles, roles = pattern.edges_fold_angle.tolist(), list(pattern.edges_role)
    for edge, (tail, head) in enumerate(pattern.edges_vertices.tolist()):
        copies = sides.get(frozenset((tail, head)), [frozenset((tail, head))])
        for place, ends in enumerate(copies):
            one, other = sorted(ends, key=lambda vertex: int(sources[vertex]) != tail)
            if place == 0:
                edges[edge] = [one, other]
                continue
            edges.append([one, other])
            letters.append(letters[edge])
            angles.append(angles[edge])
            roles.append(roles[edge])
    return dataclasses.replace(
        pattern,
        vertices_coords=pattern.vertices_coords[sources],
        edges_vertices=np.array(edges, dtype=np.int64),
        edges_assignment=tuple(letters),
        edges_fold_angle=np.array(angles),
        edges_role=tuple(roles),
        edges_fold=np.array([*pattern.edges_fold, *range(len(pattern.edges_fold), len(edges))]),
        faces_vertices=tuple(faces),
    )
