"""Crease patterns of networks of drawn lines: faces, rim, and lines that lead nowhere."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Flags, Indices
from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern, face_sides
from forficula.pattern.drawings.flat_faces import faces_between, parts_of
from forficula.pattern.files.fold_frame import target_angles


@dataclass(frozen=True, kw_only=True, eq=False)
class EnclosedFaces:
    """Faces that edges enclose.

    Attributes:
        edges: numbers of the edges beside faces, shape (K,).
        faces: vertices of every face, counterclockwise.
        counts: number of faces at every one of these edges, 1 or 2, shape (K,).
        left_out: numbers of the edges that lead nowhere, or that another part of the drawing consists of, shape (L,).
    """

    edges: Indices
    faces: tuple[tuple[int, ...], ...]
    counts: Indices
    left_out: Indices


def enclosed_faces(points: Array, edges: Indices) -> EnclosedFaces:
    """Find the faces between edges that meet only at their ends, and the edges that lead nowhere.

    Args:
        points: shape (N, 2), y up.
        edges: shape (E, 2).

    Raises:
        InputError: the edges enclose no face.
    """
    kept = np.arange(len(edges))
    while len(kept):
        degrees = np.bincount(edges[kept].ravel(), minlength=len(points))
        free = (degrees[edges[kept]] == 1).any(axis=1)
        kept = kept[~free] if free.any() else _largest_part(len(points), edges, kept)
        if free.any():
            continue
        faces = faces_between(points, edges[kept])
        counts = _face_counts(edges[kept], faces)
        simple = all(len(set(face)) == len(face) for face in faces)
        if faces and simple and (counts > 0).all():
            return EnclosedFaces(
                edges=kept,
                faces=tuple(tuple(face) for face in faces),
                counts=counts,
                left_out=np.setdiff1d(np.arange(len(edges)), kept),
            )
        bridges = _bridges(edges[kept], faces) | (counts == 0)
        if not bridges.any():
            break
        kept = kept[~bridges]
    raise InputError("need lines that enclose faces, got none: the border of the sheet may be open in the picture")


def _largest_part(count: int, edges: Indices, kept: Indices) -> Indices:
    parts = parts_of(count, edges[kept])[edges[kept][:, 0]]
    return np.asarray(kept[parts == np.bincount(parts).argmax()], dtype=np.int64)


def _face_counts(edges: Indices, faces: Sequence[Sequence[int]]) -> Indices:
    at = Counter(frozenset(side) for face in faces for side in face_sides(face))
    return np.array([at[frozenset(pair)] for pair in edges.tolist()], dtype=np.int64)


def _bridges(edges: Indices, faces: Sequence[Sequence[int]]) -> Flags:
    """Return which edges have the same face on both sides."""
    same = np.zeros(len(edges), dtype=bool)
    for face in faces:
        sides = set(face_sides(face))
        same |= np.array([(one, other) in sides and (other, one) in sides for one, other in edges.tolist()])
    return same


def without_straight_vertices(enclosed: EnclosedFaces, edges: Indices, lines: Indices) -> tuple[EnclosedFaces, Indices]:
    """Join edges of one line at vertices at which no other edge ends, such as those of lines that are left out.

    Args:
        enclosed: faces and the edges beside them.
        edges: vertices of all edges, shape (E, 2).
        lines: number of the line of every edge, shape (E,).

    Returns:
        The faces with the first edge of every joined pair, and the vertices of these edges, shape (K, 2).
    """
    ends = {edge: edges[edge].tolist() for edge in enclosed.edges.tolist()}
    at: dict[int, list[int]] = {}
    for edge, pair in ends.items():
        for vertex in pair:
            at.setdefault(vertex, []).append(edge)
    dropped = set()
    for vertex, beside in at.items():
        if len(beside) != 2 or lines[beside[0]] != lines[beside[1]]:
            continue
        first, second = sorted(beside)
        near, far = sum(ends[first]) - vertex, sum(ends[second]) - vertex
        if any({near, far} == set(pair) for pair in ends.values()):
            continue  # a face would be left with two sides
        ends[first] = [near, far]
        at[far] = [first if edge == second else edge for edge in at[far]]
        del ends[second]
        dropped.add(vertex)
    kept = np.isin(enclosed.edges, list(ends))
    joined = EnclosedFaces(
        edges=enclosed.edges[kept],
        faces=tuple(tuple(vertex for vertex in face if vertex not in dropped) for face in enclosed.faces),
        counts=enclosed.counts[kept],
        left_out=enclosed.left_out,
    )
    return joined, np.array([ends[edge] for edge in joined.edges.tolist()], dtype=np.int64)


def pattern_of_edges(
    points: Array, edges: Indices, letters: Sequence[str], faces: Sequence[Sequence[int]], title: str
) -> tuple[CreasePattern, Indices]:
    """Build a pattern from points and edges that enclose faces, with its lower left corner at the origin.

    Args:
        points: m, y up, shape (N, 2); points without an edge are left out.
        edges: shape (E, 2).
        letters: E letters as in FOLD files.
        faces: vertices of every face, counterclockwise.
        title: title of the pattern.

    Returns:
        The pattern, and the numbers of its vertices among the points, shape (V,).
    """
    used = np.unique(edges)
    number = np.full(len(points), -1, dtype=np.int64)
    number[used] = np.arange(len(used))
    places = points[used] - points[used].min(axis=0)
    pattern = CreasePattern(
        vertices_coords=np.column_stack([places, np.zeros(len(used))]),
        edges_vertices=number[edges],
        edges_assignment=tuple(letters),
        edges_fold_angle=target_angles(list(letters), np.full(len(edges), np.nan)),
        faces_vertices=tuple(tuple(number[list(face)].tolist()) for face in faces),
        title=title,
    )
    return pattern, used
