"""A part as triangles, the faces of its stops first, and the edges between its faces."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Flags, Indices
from forficula.make.hinge.joint_layout import JointLayout
from forficula.make.part import Part
from forficula.make.solid.mesh import MILLIMETRES, Mesh, mesh_of
from forficula.pattern.geometry import triangle_normals

# triangles at a larger angle have an edge between them; triangles around a circle meet at 5 deg
_EDGE = math.cos(math.radians(20.0))
# largest distance from a hinge's axis to the plane of a stop's face, mm, and largest sine of the angle between them
_OFF, _LEANS = 1e-3, 1e-6


@dataclass(frozen=True, kw_only=True)
class PartMesh:
    """Triangles of a part's surface.

    Attributes:
        points: vertices in the built shape, m, (point, 3).
        triangles: vertices, counterclockwise seen from outside, faces of stops first, (triangle, 3).
        stops: number of triangles that are faces of stops.
        edges: indices of points, (edge, 2).
    """

    points: Array
    triangles: Indices
    stops: int
    edges: Indices


def part_mesh(part: Part, joints: tuple[JointLayout, ...]) -> PartMesh:
    """Return the triangles of a part in the built shape, with the stops of the joints that it is part of."""
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
    """Return unit vectors out of the triangles, (triangle, 3)."""
    corners = mesh.points[mesh.triangles]
    normals = triangle_normals(corners)
    return np.asarray(normals / np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None])


def _through_axis(corners: Array, normals: Array, joint: JointLayout) -> Flags:
    """Return which triangles lie in planes through a hinge's axis: only stops are flat faces of this kind."""
    leans = np.abs(normals @ joint.frame[:, 1]) < _LEANS
    off = np.abs(np.einsum("tca,ta->tc", corners - MILLIMETRES * joint.origin, normals)).max(axis=1)
    return np.asarray(leans & (off < _OFF))


def sharp_edges(mesh: Mesh) -> Indices:
    """Return the sides at which triangles meet at an angle, indices of points, (edge, 2)."""
    triangles, normals = mesh.triangles, _normals(mesh)
    sides = triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    owners = np.repeat(np.arange(len(triangles)), 3)
    ends = np.sort(sides, axis=1)
    order = np.lexsort(ends.T[::-1])
    ends, owners = ends[order], owners[order]
    # in a closed mesh every side occurs twice, once from either triangle
    pairs, first, second = ends[::2], owners[::2], owners[1::2]
    sharp = np.sum(normals[first] * normals[second], axis=1) < _EDGE
    return np.asarray(pairs[sharp])
