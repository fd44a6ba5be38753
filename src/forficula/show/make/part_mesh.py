"""A part as what draws it needs it: triangles, the faces of its stops first, and the edges between its faces."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Flags, Indices
from forficula.make.hinge.joint_layout import JointLayout
from forficula.make.part import Part
from forficula.make.solid.mesh import MILLIMETRES, Mesh, mesh_of
from forficula.pattern.geometry import triangle_normals

# triangles that meet at more than this have an edge between them; those around a circle meet at 5 deg
_EDGE = math.cos(math.radians(20.0))
# how far off the axis of a hinge the plane of a stop's face may pass, and how far it may lean, mm and sin
_OFF, _LEANS = 1e-3, 1e-6


@dataclass(frozen=True, kw_only=True)
class PartMesh:
    """Triangles around a part.

    Attributes:
        points: as built, m, (point, 3).
        triangles: counterclockwise seen from outside, those of the stops first, (triangle, 3).
        stops: how many of them are faces of stops.
        edges: numbers of points, (edge, 2).
    """

    points: Array
    triangles: Indices
    stops: int
    edges: Indices


def part_mesh(part: Part, joints: tuple[JointLayout, ...]) -> PartMesh:
    """The triangles of a part as it is built, with the stops of the joints that it is half of."""
    mesh = mesh_of(part.shape)
    corners, normals = mesh.points[mesh.triangles], _normals(mesh)
    stops = np.zeros(len(corners), dtype=bool)
    for joint in joints:
        if part.kind == "bar" and part.body in (joint.proximal.body, joint.distal.body):
            stops |= _through_axis(corners, normals, joint)
    order = np.argsort(~stops, kind="stable")
    return PartMesh(
        points=mesh.points / MILLIMETRES,
        triangles=mesh.triangles[order],
        stops=int(stops.sum()),
        edges=sharp_edges(mesh),
    )


def _normals(mesh: Mesh) -> Array:
    """Unit vectors out of the triangles, (triangle, 3)."""
    corners = mesh.points[mesh.triangles]
    normals = triangle_normals(corners)
    return np.asarray(normals / np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None])


def _through_axis(corners: Array, normals: Array, joint: JointLayout) -> Flags:
    """Which triangles lie in planes through the axis of a hinge: stops are the only flat faces that do."""
    leans = np.abs(normals @ joint.frame[:, 1]) < _LEANS
    off = np.abs(np.einsum("tca,ta->tc", corners - MILLIMETRES * joint.origin, normals)).max(axis=1)
    return np.asarray(leans & (off < _OFF))


def sharp_edges(mesh: Mesh) -> Indices:
    """Sides of triangles that meet their neighbours at an angle, numbers of points, (edge, 2)."""
    triangles, normals = mesh.triangles, _normals(mesh)
    sides = triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    own = np.repeat(np.arange(len(triangles)), 3)
    ends = np.sort(sides, axis=1)
    order = np.lexsort(ends.T[::-1])
    ends, own = ends[order], own[order]
    # of a closed mesh every side is there twice, once from either triangle
    pairs, first, second = ends[::2], own[::2], own[1::2]
    sharp = np.sum(normals[first] * normals[second], axis=1) < _EDGE
    return np.asarray(pairs[sharp])
