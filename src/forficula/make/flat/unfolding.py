"""A folded sheet laid flat for cutting, facet by facet, and opened along creases if it cannot stay in one piece."""

from __future__ import annotations

import dataclasses
import math
from dataclasses import dataclass

import numpy as np
import scipy

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.pattern import CreasePattern, central_facet, facet_tree
from forficula.pattern.crease_pattern import is_unfolded
from forficula.pattern.cut_open import cut_open
from forficula.pattern.geometry import is_inside, polygon_normal
from forficula.pattern.rotation import rotation_about, rotation_to_z
from forficula.pattern.shared_edges import shared_edges

# fraction of the sheet's size: allowed bend of facets and gap at the ends of a crease, because files round coordinates
_ROUNDING = 1e-6
_UPWARDS = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True, kw_only=True, eq=False)
class Unfolding:
    """A sheet in the plane z = 0, with the motions of its facets.

    Attributes:
        pattern: flat, all faces counterclockwise; opened along cuts and seams, so that each side of these has vertices
            and edges of its own.
        edges: index of each edge in the pattern as built, (edge,).
        seams: indices, as built, of the creases at which it had to be opened, and which the maker joins.
        turns: rotation of each face from built to flat, (face, 3, 3).
        shifts: translation after the rotation, m, (face, 3).
    """

    pattern: CreasePattern
    edges: Indices
    seams: tuple[int, ...]
    turns: Array
    shifts: Array


def unfolded(pattern: CreasePattern) -> Unfolding:
    """Lay a sheet flat without stretching it.

    Facets are laid one after another beside their parent in a tree over creases, beginning with the central one. A
    crease that closes a loop is kept if both of its facets meet again. Otherwise it becomes a seam, such as that of a
    tower, or the gap of a cone.

    Args:
        pattern: flat or folded; a flat one is only moved to z = 0.

    Raises:
        InputError: a facet is not flat as built, or the facets are not connected.
    """
    turns, shifts = _identity(pattern) if is_unfolded(pattern) else _laid(pattern)
    seams = tuple(_seams(pattern, turns, shifts))
    letters = ["C" if edge in seams else letter for edge, letter in enumerate(pattern.edges_assignment)]
    opened = cut_open(dataclasses.replace(pattern, edges_assignment=tuple(letters)))
    coords = pattern.vertices_coords[opened.vertices].copy()
    for face in reversed(range(len(opened.pattern.faces_vertices))):
        corners = list(opened.pattern.faces_vertices[face])
        coords[corners] = pattern.vertices_coords[opened.vertices[corners]] @ turns[face].T + shifts[face]
    coords[:, 2] = 0.0
    number = {frozenset(pair): edge for edge, pair in enumerate(pattern.edges_vertices.tolist())}
    ends = opened.vertices[opened.pattern.edges_vertices]
    return Unfolding(
        pattern=dataclasses.replace(opened.pattern, vertices_coords=coords),
        edges=np.array([number[frozenset(pair)] for pair in ends.tolist()], dtype=np.int64),
        seams=seams,
        turns=turns,
        shifts=shifts,
    )


def laid_place(pattern: CreasePattern, sheet: Unfolding, place: Array) -> tuple[int, Array] | None:
    """Return the flat position of a point of the sheet as built.

    Args:
        pattern: pattern as built.
        sheet: the same, flat.
        place: m, (3,).

    Returns:
        The lowest face on which it lies, and its position, m, (2,); None if it lies on none.
    """
    size = float(np.ptp(pattern.vertices_coords, axis=0).max())
    for face, corners in enumerate(pattern.faces_vertices):
        points = pattern.vertices_coords[list(corners)] @ sheet.turns[face].T + sheet.shifts[face]
        flat = sheet.turns[face] @ place + sheet.shifts[face]
        if abs(flat[2] - points[0, 2]) <= _ROUNDING * size and is_inside(flat[:2], points[:, :2], _ROUNDING * size):
            return face, flat[:2]
    return None


def _identity(pattern: CreasePattern) -> tuple[Array, Array]:
    """Return rotations and translations of a sheet that is flat already."""
    count = len(pattern.faces_vertices)
    lowered = -_UPWARDS * pattern.vertices_coords[0, 2]
    return np.tile(np.eye(3), (count, 1, 1)), np.tile(lowered, (count, 1))


def _laid(pattern: CreasePattern) -> tuple[Array, Array]:
    """Return rotations and translations that lay facets beside their parents."""
    normals = _normals(pattern)
    turns, shifts = np.zeros((len(normals), 3, 3)), np.zeros((len(normals), 3))
    for link in facet_tree(pattern, central_facet(pattern)):
        face = link.facet
        if link.closes:
            continue
        if link.parent is None:
            turns[face] = rotation_to_z(normals[face])
            shifts[face] = -turns[face] @ pattern.vertices_coords[pattern.faces_vertices[face][0]]
            continue
        tail, head = pattern.vertices_coords[[link.tail, link.head]]
        along = (head - tail) / np.linalg.norm(head - tail)
        laid_along = turns[link.parent] @ along
        built_axes, laid_axes = _axes(along, normals[face]), _axes(laid_along, _UPWARDS)
        turns[face] = laid_axes @ built_axes.T
        shifts[face] = turns[link.parent] @ tail + shifts[link.parent] - turns[face] @ tail
    return _straightened(pattern, turns, shifts)


def _straightened(pattern: CreasePattern, turns: Array, shifts: Array) -> tuple[Array, Array]:
    """Rotate a laid sheet into its smallest rectangle; of the four orientations, the one nearest to the built one."""
    faces = [list(face) for face in pattern.faces_vertices]
    laid = [
        pattern.vertices_coords[face] @ turn.T + shift for face, turn, shift in zip(faces, turns, shifts, strict=True)
    ]
    flat, built = np.concatenate(laid)[:, :2], pattern.vertices_coords[np.concatenate(faces)][:, :2]
    flat, built = flat - flat.mean(axis=0), built - built.mean(axis=0)
    cross = (flat[:, 0] * built[:, 1] - flat[:, 1] * built[:, 0]).sum()
    nearest = math.atan2(cross, (flat * built).sum())
    # one side of the least rectangle lies along a side of the hull (Freeman and Shapira 1975)
    corners = flat[scipy.spatial.ConvexHull(flat).vertices]
    sides = np.roll(corners, -1, axis=0) - corners
    angles = -np.arctan2(sides[:, 1], sides[:, 0])
    turned = [corners @ rotation_about(_UPWARDS, angle)[:2, :2].T for angle in angles.tolist()]
    areas = np.array([np.prod(np.ptp(points, axis=0)) for points in turned])
    rotations = [
        angle + quarter * math.pi / 2
        for angle in angles[areas <= (1 + _ROUNDING) * areas.min()]
        for quarter in range(4)
    ]
    best = min(rotations, key=lambda angle: (round(abs(math.remainder(angle - nearest, 2 * math.pi)), 6), angle))
    turn = rotation_about(_UPWARDS, best)
    return np.asarray(turn @ turns), np.asarray(shifts @ turn.T)


def _axes(along: Array, normal: Array) -> Array:
    """Return axes along a crease, beside it and out of the facet, as columns, (3, 3)."""
    return np.column_stack([along, np.cross(normal, along), normal])


def _normals(pattern: CreasePattern) -> Array:
    """Return unit normals of the facets, on the side from which they are counterclockwise, (face, 3)."""
    size, normals = float(np.ptp(pattern.vertices_coords, axis=0).max()), []
    for face, corners in enumerate(pattern.faces_vertices):
        points = pattern.vertices_coords[list(corners)]
        normal = polygon_normal(points)
        normal /= np.linalg.norm(normal)
        bent = float(np.ptp(points @ normal))
        if not bent <= _ROUNDING * size:
            raise InputError(
                f"faces_vertices[{face}]: need flat facets to lay the sheet flat, got one whose corners lie"
                f" {1e3 * bent:.4g} mm off its plane; triangles are flat"
            )
        normals.append(normal)
    return np.array(normals)


def _seams(pattern: CreasePattern, turns: Array, shifts: Array) -> list[int]:
    """Return indices of the edges at which the two facets do not meet when flat."""
    size = float(np.ptp(pattern.vertices_coords, axis=0).max())
    seams = []
    for edge, tail, head, left, right in shared_edges(pattern):
        ends = pattern.vertices_coords[[tail, head]]
        one, other = (ends @ turns[face].T + shifts[face] for face in (left, right))
        if np.abs(one - other).max() > _ROUNDING * size:
            seams.append(edge)
    return seams
