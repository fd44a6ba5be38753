"""Convex solids by their corners: from half spaces, and the depth to which two of them overlap."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations, pairwise
from typing import NamedTuple

import numpy as np
import scipy

from forficula.arrays import Array, Indices
from forficula.pattern.geometry import polygon_normal
from forficula.pattern.rotation import frame_along

_SAME = 1e-9  # of unit vectors and, times the size of a solid, of its corners: rounding
_ROWS = 4096  # pairs of solids that are compared at once, which limits memory
_THINNEST = 1e-7  # half the width of a solid, in sizes; thinner ones have no volume
_LEAST_VOLUME = 1e-6  # of three unit vectors; planes with these normals meet too far away or in a line


@dataclass(frozen=True, kw_only=True, eq=False)
class ConvexSolid:
    """The convex hull of corners.

    Attributes:
        corners: m, (corner, 3).
        faces: unit vectors normal to its faces, one for each pair of parallel faces, (face, 3).
        edges: unit vectors along its edges, one for each direction, (edge, 3).
    """

    corners: Array
    faces: Array
    edges: Array


def solid_within(normals: Array, offsets: Array, inside: Array) -> ConvexSolid | None:
    """Return the bounded solid of all positions x with normals @ x <= offsets.

    Its corners are the intersections of three planes that satisfy all conditions.

    Args:
        normals: (plane, 3).
        offsets: m, (plane,).
        inside: a position near the solid, from which sizes are measured, m, (3,).

    Returns:
        None if the solid has no volume.
    """
    lengths = np.linalg.norm(normals, axis=1)
    normals, offsets = normals / lengths[:, None], (offsets - normals @ inside) / lengths
    size = float(np.abs(offsets).max())
    offsets = offsets / size
    one, two, three = _triples(len(normals))
    crossed = np.cross(normals[:, None], normals[None])
    volumes = (normals[one] * crossed[two, three]).sum(axis=1)
    meeting = np.abs(volumes) > _LEAST_VOLUME
    one, two, three = one[meeting], two[meeting], three[meeting]
    corners = sum(
        offsets[first, None] * crossed[second, third]
        for first, second, third in ((one, two, three), (two, three, one), (three, one, two))
    )
    corners = corners / volumes[meeting, None]
    corners = corners[(corners @ normals.T <= offsets + _SAME).all(axis=1)]
    apart = np.abs(corners[:, None] - corners).max(axis=2) > 10 * _SAME
    corners = corners[(apart | ~np.tri(len(corners), k=-1, dtype=bool)).all(axis=1)]
    touched = np.abs(corners @ normals.T - offsets) <= 10 * _SAME
    bounding = touched.sum(axis=0) > 2
    if len(corners) < 4 or not np.ptp(corners @ normals[bounding].T, axis=0).min(initial=np.inf) > 2 * _THINNEST:
        return None
    # two corners are the ends of an edge if the planes that they have in common meet in a line
    tails, heads = np.triu_indices(len(corners), 1)
    common = normals * (touched[tails] & touched[heads])[..., None]
    edge = np.linalg.eigvalsh(np.swapaxes(common, 1, 2) @ common)[:, 1] > _SAME
    return ConvexSolid(
        corners=size * corners + inside,
        faces=_directions(normals[bounding]),
        edges=_directions(corners[tails[edge]] - corners[heads[edge]]),
    )


@lru_cache
def _triples(count: int) -> Array:
    """Return all sets of three numbers below `count`, (3, set)."""
    return np.array(list(combinations(range(count), 3))).T


def solid_of(corners: Array) -> ConvexSolid:
    """Return the convex hull of its corners, m, (corner, 3)."""
    faces = convex_faces(corners)
    normals = [polygon_normal(corners[list(face)]) for face in faces]
    sides = [corners[head] - corners[tail] for face in faces for tail, head in pairwise([*face, face[0]])]
    return ConvexSolid(corners=corners, faces=_directions(np.array(normals)), edges=_directions(np.array(sides)))


def convex_faces(corners: Array) -> list[tuple[int, ...]]:
    """Return the faces of the convex hull of corners, (corner, 3), each with its corners counterclockwise from outside.

    Triangles of the hull that lie in one plane are one face.
    """
    hull = scipy.spatial.ConvexHull(corners)
    size = float(np.ptp(corners, axis=0).max())
    planes: list[Array] = []
    faces: list[tuple[int, ...]] = []
    for equation in hull.equations:
        if any(float(equation[:3] @ plane[:3]) > 1 - 1e-9 for plane in planes):
            continue
        planes.append(equation)
        on_face = np.flatnonzero(corners @ equation[:3] + equation[3] > -1e-7 * size)
        middle = corners[on_face].mean(axis=0)
        across, along, _ = frame_along(equation[:3]).T
        away = corners[on_face] - middle
        order = np.argsort(np.arctan2(away @ along, away @ across))
        faces.append(tuple(on_face[order].tolist()))
    return faces


def _directions(vectors: Array) -> Array:
    """Return unit vectors without repeated and opposite ones."""
    units = vectors / np.linalg.norm(vectors, axis=1)[:, None]
    same = np.abs(units @ units.T) > 1 - _SAME
    return np.asarray(units[~np.triu(same, 1).any(axis=0)])


def overlap_depths(
    one: ConvexSolid, one_motion: tuple[Array, Array], other: ConvexSolid, other_motion: tuple[Array, Array]
) -> Array:
    """Compute how far two convex solids overlap in several poses, m, (pose,).

    The depth is the least distance by which one of them has to move until they are apart; it is negative, and not less
    than their distance, where they are apart. Two convex solids are apart if, and only if, they are apart along a
    normal of a face of one of them or along a common normal of an edge of each (Gottschalk, Lin and Manocha 1996).

    Args:
        one: a solid.
        one_motion: its rotations, (pose, 3, 3), and shifts after them, m, (pose, 3).
        other: another solid.
        other_motion: its rotations and shifts.
    """
    solids, (turns, shifts) = packed_solids([one, other]), relative_motions(one_motion, other_motion)
    numbers = np.zeros(len(turns), dtype=np.int64)
    sides = _side_depths(solids, numbers, numbers + 1, turns, shifts)
    return np.minimum(sides, _edge_depths(solids, numbers, numbers + 1, turns, shifts))


class PackedSolids(NamedTuple):
    """Corners, faces and edges of several convex solids, repeated to the same number for all of them.

    Attributes:
        corners: m, (solid, corner, 3).
        faces: (solid, face, 3).
        edges: (solid, edge, 3).
    """

    corners: Array
    faces: Array
    edges: Array


def packed_solids(solids: Sequence[ConvexSolid]) -> PackedSolids:
    """Return solids as arrays."""

    def packed(rows: Sequence[Array]) -> Array:
        most = max(map(len, rows))
        return np.array([np.concatenate([row, np.repeat(row[:1], most - len(row), axis=0)]) for row in rows])

    return PackedSolids(
        packed([solid.corners for solid in solids]),
        packed([solid.faces for solid in solids]),
        packed([solid.edges for solid in solids]),
    )


def relative_motions(one: tuple[Array, Array], other: tuple[Array, Array]) -> tuple[Array, Array]:
    """Return motions of solids in the axes of others; rotations, (row, 3, 3), and shifts after them, m, (row, 3)."""
    (turns, shifts), (other_turns, other_shifts) = one, other
    back = np.swapaxes(turns, 1, 2)
    return back @ other_turns, np.einsum("rij,rj->ri", back, other_shifts - shifts)


def pair_overlaps(
    solids: PackedSolids,
    one: Indices,
    other: Indices,
    one_motion: tuple[Array, Array],
    other_motion: tuple[Array, Array],
) -> Array:
    """Compute how far pairs of solids overlap, m, (row,); 0 where they are apart or touch.

    Args:
        solids: all solids.
        one: numbers of the first solids, (row,).
        other: numbers of the second solids, (row,).
        one_motion: rotations and shifts of the first solids, (row, 3, 3) and m, (row, 3).
        other_motion: rotations and shifts of the second solids.
    """
    result = np.zeros(len(one))
    for start in range(0, len(one), _ROWS):
        rows = np.arange(start, min(start + _ROWS, len(one)))
        motions = [(turns[rows], shifts[rows]) for turns, shifts in (one_motion, other_motion)]
        turns, shifts = relative_motions(motions[0], motions[1])
        depths = _side_depths(solids, one[rows], other[rows], turns, shifts)
        # most pairs are apart along a normal of a face
        deep = np.flatnonzero(depths > _SAME * np.ptp(solids.corners[one[rows]], axis=1).max(axis=1))
        edges = _edge_depths(solids, one[rows[deep]], other[rows[deep]], turns[deep], shifts[deep])
        result[rows[deep]] = np.maximum(np.minimum(depths[deep], edges), 0.0)
    return result


def _side_depths(solids: PackedSolids, one: Indices, other: Indices, turns: Array, shifts: Array) -> Array:
    """Compute the least overlap of pairs of solids along the normals of their faces, m, (row,)."""
    axes = np.concatenate([solids.faces[one], solids.faces[other] @ np.swapaxes(turns, 1, 2)], axis=1)
    return np.asarray(_depths_along(axes, solids, one, other, turns, shifts).min(axis=1))


def _edge_depths(solids: PackedSolids, one: Indices, other: Indices, turns: Array, shifts: Array) -> Array:
    """Compute the least overlap of pairs of solids along the common normals of their edges, m, (row,)."""
    edges = solids.edges[other] @ np.swapaxes(turns, 1, 2)
    pairs = edges.shape[1] ** 2
    crossed = np.cross(solids.edges[one][:, :, None], edges[:, None]).reshape(len(one), pairs, 3)
    lengths = np.linalg.norm(crossed, axis=2)
    apart = lengths > math.sqrt(_SAME)
    crossed = crossed / np.where(apart, lengths, 1.0)[..., None]
    depths = _depths_along(crossed, solids, one, other, turns, shifts)
    return np.asarray(np.where(apart, depths, np.inf).min(axis=1))


def _depths_along(
    axes: Array, solids: PackedSolids, one: Indices, other: Indices, turns: Array, shifts: Array
) -> Array:
    """Compute the overlap of pairs of solids along unit vectors, (row, axis, 3), m, (row, axis)."""
    corners = solids.corners[other] @ np.swapaxes(turns, 1, 2) + shifts[:, None]
    ours, theirs = (points @ np.swapaxes(axes, 1, 2) for points in (solids.corners[one], corners))
    return np.asarray(np.minimum(ours.max(axis=1) - theirs.min(axis=1), theirs.max(axis=1) - ours.min(axis=1)))


def convex_overlap(one: Array, other: Array) -> float:
    """Compute how far two convex polygons in a plane, (corner, 2), overlap, m: the least distance to part them.

    Returns:
        A number that is not above 0 if they are apart.
    """
    sides = np.concatenate([polygon - np.roll(polygon, 1, axis=0) for polygon in (one, other)])
    normals = np.column_stack([-sides[:, 1], sides[:, 0]]) / np.linalg.norm(sides, axis=1)[:, None]
    ours, theirs = one @ normals.T, other @ normals.T
    depths = np.minimum(ours.max(axis=0) - theirs.min(axis=0), theirs.max(axis=0) - ours.min(axis=0))
    return float(depths.min())


def connected_parts(solids: Sequence[ConvexSolid], least: float) -> list[list[int]]:
    """Return the numbers of convex solids that are connected with each other, because they touch along faces.

    Args:
        solids: which do not overlap.
        least: width that faces must have in common, m.
    """
    result, waiting = list[list[int]](), list(range(len(solids)))
    while waiting:
        result.append(part := [waiting.pop(0)])
        for one in part:  # grows
            touching = [other for other in waiting if _share_face(solids[one], solids[other], least)]
            part += touching
            waiting = [other for other in waiting if other not in touching]
    return result


def _share_face(one: ConvexSolid, other: ConvexSolid, least: float) -> bool:
    """Return whether two convex solids that do not overlap touch along faces that have a width in common."""
    near = max(float(np.ptp(one.corners, axis=0).max()), float(np.ptp(other.corners, axis=0).max())) * 100 * _SAME
    if not boxes_overlap(one.corners, other.corners, near):
        return False
    normals = np.concatenate([one.faces, -one.faces, other.faces, -other.faces])
    ours, theirs = one.corners @ normals.T, other.corners @ normals.T
    for number in np.flatnonzero(np.abs(ours.max(axis=0) - theirs.min(axis=0)) <= near).tolist():
        sides = frame_along(normals[number])[:, :2]
        on_ours = one.corners[ours[:, number] >= ours[:, number].max() - near] @ sides
        on_theirs = other.corners[theirs[:, number] <= theirs[:, number].min() + near] @ sides
        if len(on_ours) > 2 and len(on_theirs) > 2:
            faces = [face[scipy.spatial.ConvexHull(face).vertices] for face in (on_ours, on_theirs)]
            if convex_overlap(faces[0], faces[1]) > least:
                return True
    return False


def boxes_overlap(one: Array, other: Array, near: float = 0.0) -> bool:
    """Return whether the boxes around corners, (corner, 3), parallel to the axes, are at most `near` apart, m."""
    return bool(((one.min(axis=0) <= other.max(axis=0) + near) & (other.min(axis=0) <= one.max(axis=0) + near)).all())


def volume_of(solids: Sequence[ConvexSolid]) -> float:
    """Return the sum of the volumes of convex solids, m^3."""
    return sum(float(scipy.spatial.ConvexHull(solid.corners).volume) for solid in solids)
