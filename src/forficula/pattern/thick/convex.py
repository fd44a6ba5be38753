"""Convex solids by their corners: from half spaces, and the depth to which two of them overlap."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.pattern.geometry import polygon_normal
from forficula.pattern.rotation import frame_along

_SAME = 1e-9  # of unit vectors and, times the size of a solid, of its corners: rounding
_THINNEST = 1e-7  # radius of the largest ball in a solid, in sizes; thinner ones have no volume


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
    """Return the solid of all positions x with normals @ x <= offsets.

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
    # the centre of the largest ball inside
    centre = scipy.optimize.linprog(
        [0.0, 0.0, 0.0, -1.0],
        A_ub=np.column_stack([normals, np.ones(len(normals))]),
        b_ub=offsets / size,
        bounds=[(None, None)] * 3 + [(0, None)],
    )
    if centre.status != 0 or not centre.x[3] > _THINNEST:
        return None
    planes = scipy.spatial.HalfspaceIntersection(np.column_stack([normals, -offsets / size]), centre.x[:3])
    corners = planes.intersections
    # in the order of their rounded positions, because rounding changes the order in which the intersection lists them
    corners = corners[np.unique(np.round(corners / _SAME) + 0.0, axis=0, return_index=True)[1]]
    touched = np.abs(corners @ normals.T - offsets / size) <= 10 * _SAME
    # corners with two planes in common may be the ends of an edge
    common = touched.astype(np.int64) @ touched.T.astype(np.int64)
    edges = [
        corners[one] - corners[other]
        for one, other in np.argwhere(np.triu(common, 1) > 1).tolist()
        if np.linalg.matrix_rank(normals[touched[one] & touched[other]], tol=math.sqrt(_SAME)) == 2
    ]
    return ConvexSolid(
        corners=size * corners + inside,
        faces=_directions(normals[touched.sum(axis=0) > 2]),
        edges=_directions(np.array(edges)),
    )


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
    (turn, shift), (other_turn, other_shift) = one_motion, other_motion
    # in the axes of the first solid
    relative = np.swapaxes(turn, 1, 2) @ other_turn
    moved = np.einsum("pji,pj->pi", turn, other_shift - shift)
    corners = np.einsum("pij,cj->pci", relative, other.corners) + moved[:, None]
    poses = len(relative)
    edges = np.einsum("pij,ej->pei", relative, other.edges)
    crossed = np.cross(one.edges[None, :, None], edges[:, None]).reshape(poses, -1, 3)
    lengths = np.linalg.norm(crossed, axis=2)
    apart = lengths > math.sqrt(_SAME)
    crossed = crossed / np.where(apart, lengths, 1.0)[..., None]
    axes = np.concatenate(
        [
            np.broadcast_to(one.faces, (poses, *one.faces.shape)),
            np.einsum("pij,fj->pfi", relative, other.faces),
            crossed,
        ],
        axis=1,
    )
    ours, theirs = np.einsum("pai,ci->pac", axes, one.corners), np.einsum("pai,pci->pac", axes, corners)
    depths = np.minimum(ours.max(axis=2) - theirs.min(axis=2), theirs.max(axis=2) - ours.min(axis=2))
    depths[:, -crossed.shape[1] :] = np.where(apart, depths[:, -crossed.shape[1] :], np.inf)
    return np.asarray(depths.min(axis=1))


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
