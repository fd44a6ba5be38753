"""Faces between the edges of a flat sheet, and checks that edges and faces form a sheet."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import scipy
from numpy.typing import ArrayLike
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.pattern.crease_pattern import face_area, face_sides
from forficula.pattern.drawings.segments import crossings, points_on_segments
from forficula.pattern.geometry import is_inside

Side = tuple[int, int]

_TOUCHING = 1e-9  # share of the sheet's size within which two vertices are at the same place
_ON_EDGE = 1e-5  # rad, deviation from the direction of an edge; single precision has errors of 1e-6 on most edges


def parts_of(count: int, edges: ArrayLike) -> Indices:
    """Number the connected components of a graph.

    Args:
        count: N, number of vertices or other items.
        edges: pairs of connected items, shape (E, 2).

    Returns:
        The number of the component of every item, shape (N,).
    """
    pairs = np.asarray(edges, dtype=np.int64).reshape(-1, 2)
    joined = coo_array((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(count, count))
    _, parts = connected_components(joined, directed=False)
    return np.asarray(parts, dtype=np.int64)


def next_sides(points: Array, edges: Indices) -> dict[Side, Side]:
    """Find the next side of the face on the left: at every vertex the face turns left as sharply as possible.

    Args:
        points: m, shape (N, 2) or (N, 3); z is ignored.
        edges: edges that do not cross, shape (E, 2).

    Returns:
        The next side for every edge in both directions.
    """
    around: dict[int, list[int]] = {}
    for tail, head in edges.tolist():
        around.setdefault(tail, []).append(head)
        around.setdefault(head, []).append(tail)
    following: dict[Side, Side] = {}
    for vertex, ends in around.items():
        away = points[ends] - points[vertex]
        turn = np.argsort(np.arctan2(away[:, 1], away[:, 0])).tolist()
        for position, end in enumerate(turn):
            following[(ends[end], vertex)] = (vertex, ends[turn[position - 1]])
    return following


def faces_between(points: Array, edges: Indices) -> list[list[int]]:
    """Find the faces of a flat sheet.

    Args:
        points: m, shape (N, 2) or (N, 3); z is ignored.
        edges: edges that do not cross, shape (E, 2).

    Returns:
        The vertices of every face, counterclockwise, without the outside.
    """
    following = next_sides(points, edges)
    faces: list[list[int]] = []
    # sides are removed from the table when their face is found, so iterate over a copy
    for start in [*following]:
        side = following.pop(start, None)
        if side is None:
            continue
        face = [start[1]]
        while side != start:
            face.append(side[1])
            side = following.pop(side)
        faces.append(face)
    return [face for face in faces if face_area(points, face) > 0]


def check_edges_apart(points: Array, edges: Indices, numbers: Indices) -> None:
    """Refuse edges of a flat sheet that meet anywhere except at common vertices.

    Args:
        points: m, shape (N, 2); points without an edge are ignored.
        edges: shape (E, 2).
        numbers: numbers of the edges for messages, shape (E,).

    Raises:
        InputError: two vertices at the same place, a vertex on an edge, or edges that cross.
    """
    used = np.unique(edges)
    size = float(np.ptp(points[used], axis=0).max())
    _check_places(points, edges, _TOUCHING * size)
    starts, ends = points[edges[:, 0]], points[edges[:, 1]]
    pairs, beside = points_on_segments(points[used], starts, ends, _ON_EDGE * size)
    for (place, edge), distance in zip(pairs.tolist(), beside.tolist(), strict=True):
        vertex = int(used[place])
        tail, head = edges[edge].tolist()
        nearer = min(math.dist(points[vertex], points[end]) for end in (tail, head))
        if vertex not in (tail, head) and distance <= _ON_EDGE * nearer:
            raise InputError(
                f"edges_vertices[{numbers[edge]}]: need vertices at its ends only, got vertex {vertex} on the edge"
                f" from {tail} to {head}; write two edges, {tail} to {vertex} and {vertex} to {head}"
            )
    crossing, _ = crossings(starts, ends, _TOUCHING * size)
    for first, second in crossing.tolist():
        (a, b), (c, d) = edges[[first, second]].tolist()
        raise InputError(
            f"edges_vertices[{numbers[second]}]: need a vertex where edges cross, got {c} to {d} across edge"
            f" {numbers[first]}, {a} to {b};"
            " split both there, or read the pattern from a drawing (.svg or .dxf), whose lines are split"
        )


def _check_places(points: Array, edges: Indices, tolerance: float) -> None:
    """Refuse two vertices at the same place, except the ends of very short edges."""
    used = np.unique(edges)
    pairs = used[scipy.spatial.cKDTree(points[used]).query_pairs(tolerance, output_type="ndarray")]
    if len(pairs):
        short = np.linalg.norm(points[edges[:, 1]] - points[edges[:, 0]], axis=1) <= tolerance
        parts = parts_of(len(points), edges[short])
        for one, other in pairs[np.lexsort(pairs.T[::-1])].tolist():
            if parts[one] != parts[other]:
                raise InputError(
                    f"vertices_coords[{other}]: need vertices of a flat sheet at different positions, got that of"
                    f" vertex {one}; use vertex {one} instead"
                )


def check_face_sides(points: Array, faces: Sequence[Sequence[int]]) -> None:
    """Refuse faces that cross themselves, in the plane that fits each of them best.

    Args:
        points: m, shape (N, 3).
        faces: vertices of the faces.

    Raises:
        InputError: sides of a face cross.
    """
    for number in _not_convex(points, faces):
        face = faces[number]
        corners = points[list(face)] - points[list(face)].mean(axis=0)
        across = corners @ np.linalg.svd(corners)[2][:2].T  # in the plane that fits best
        size = float(np.ptp(across, axis=0).max())
        pairs, _ = crossings(across, np.roll(across, -1, axis=0), _TOUCHING * size)
        for first, second in pairs.tolist():
            sides = face_sides(face)
            (a, b), (c, d) = sides[first], sides[second]
            raise InputError(
                f"faces_vertices[{number}]: need a face that does not cross itself, got its sides {a} to {b} and {c} to"
                f" {d} crossing; name its vertices in their order around it"
            )


def _not_convex(points: Array, faces: Sequence[Sequence[int]]) -> list[int]:
    """List the faces that are not convex, which may cross themselves."""
    sizes = np.array([len(face) for face in faces])
    concave: list[int] = []
    for size in np.unique(sizes[sizes > 3]).tolist():
        numbers = np.flatnonzero(sizes == size)
        corners = points[np.array([faces[number] for number in numbers.tolist()])]
        corners = corners - corners.mean(axis=1, keepdims=True)
        across = corners @ np.linalg.svd(corners, full_matrices=False)[2][:, :2].swapaxes(1, 2)
        side = np.roll(across, -1, axis=1) - across
        after = np.roll(side, -1, axis=1)
        cross = side[..., 0] * after[..., 1] - side[..., 1] * after[..., 0]
        turns = np.arctan2(cross, (side * after).sum(axis=2))
        convex = (np.abs(np.sign(cross).sum(axis=1)) == size) & (np.abs(turns.sum(axis=1)) < 3 * math.pi)
        concave += numbers[~convex].tolist()
    return sorted(concave)


def check_faces_apart(points: Array, edges: Indices, faces: Sequence[Sequence[int]]) -> None:
    """Refuse faces of a flat sheet that overlap.

    Args:
        points: m, shape (N, 2).
        edges: edges that do not cross, shape (E, 2).
        faces: vertices of the faces, counterclockwise.

    Raises:
        InputError: two faces on the same side of an edge, or an edge or a part of the sheet inside a face.
    """
    following = next_sides(points, edges)
    left_of: dict[Side, int] = {}
    for number, face in enumerate(faces):
        sides = face_sides(face)
        for side, after in zip(sides, [*sides[1:], sides[0]], strict=True):
            if side in left_of:
                raise InputError(
                    f"faces_vertices[{number}]: need faces side by side, got it over face {left_of[side]} at the edge"
                    f" from {side[0]} to {side[1]}"
                )
            left_of[side] = number
            inner = following[side]
            if inner != after:
                raise InputError(
                    f"faces_vertices[{number}]: need faces between the edges, got the edge from {inner[0]} to"
                    f" {inner[1]} inside the face; split the face there, or leave out the edge"
                )
    _check_islands(points, edges, faces)


def _check_islands(points: Array, edges: Indices, faces: Sequence[Sequence[int]]) -> None:
    """Refuse parts of a sheet that lie inside a face of another part."""
    parts = parts_of(len(points), edges)
    used = set(parts[np.unique(edges)].tolist())
    if len(used) == 1:
        return
    for number, face in enumerate(faces):
        for part in used - {int(parts[face[0]])}:
            vertex = int(np.argmax(parts == part))
            if is_inside(points[vertex], points[list(face)]):
                raise InputError(
                    f"faces_vertices[{number}]: need faces side by side, got vertex {vertex}, of a part that is not"
                    " connected to the face, inside it"
                )
