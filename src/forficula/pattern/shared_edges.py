"""Edges between two faces of a sheet."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern, face_sides


class SharedEdge(NamedTuple):
    """An edge between two faces.

    Attributes:
        edge: number of the edge.
        tail: start vertex.
        head: end vertex.
        left: number of the face on the left, seen from +z.
        right: number of the face on the right.
    """

    edge: int
    tail: int
    head: int
    left: int
    right: int


def shared_edges(pattern: CreasePattern) -> list[SharedEdge]:
    """List the edges between two faces, except cuts.

    Raises:
        InputError: faces that are not counterclockwise.
    """
    return list(_shared(pattern))


@lru_cache(maxsize=64)  # a pattern is frozen, and all checks and structures of a design need its edges
def _shared(pattern: CreasePattern) -> tuple[SharedEdge, ...]:
    left_of: dict[tuple[int, int], int] = {}
    for face, vertices in enumerate(pattern.faces_vertices):
        for side in face_sides(vertices):
            if side in left_of:
                raise InputError(
                    f"faces_vertices[{face}]: need faces counterclockwise, got side {side} of face {left_of[side]}"
                    " again"
                )
            left_of[side] = face
    shared = []
    for edge, (tail, head) in enumerate(pattern.edges_vertices.tolist()):
        left, right = left_of.get((tail, head)), left_of.get((head, tail))
        if left is not None and right is not None and pattern.edges_assignment[edge] != "C":
            shared.append(SharedEdge(edge, tail, head, left, right))
    return tuple(shared)
