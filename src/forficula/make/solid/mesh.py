"""Solids as meshes, by manifold3d: exact boolean operations of triangles, in mm."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from manifold3d import CrossSection, Manifold, OpType

from forficula.arrays import Array, Indices
from forficula.make.solid.solids import Cut, Hull, Joined, Prism, Rod, Shared, Solid
from forficula.pattern.rotation import frame_along

MILLIMETRES = 1e3
# corners of a circle; the polygon has the area of the circle, and its corners exceed the radius by 0.0016 of it
_CORNERS = 72
_WIDER = math.sqrt((2 * math.pi / _CORNERS) / math.sin(2 * math.pi / _CORNERS))


@dataclass(frozen=True, kw_only=True, eq=False)
class Mesh:
    """Surface triangles of a solid.

    Attributes:
        points: mm, (point, 3).
        triangles: three points each, counterclockwise seen from outside, (triangle, 3).
    """

    points: Array
    triangles: Indices


def solid_of(solid: Solid) -> Manifold:
    """Evaluate a tree of solids; circles are polygons of the same area."""
    match solid:
        case Rod():
            return _rod(solid)
        case Prism():
            flat = CrossSection([solid.outline * MILLIMETRES])
            upright = Manifold.extrude(flat, solid.height * MILLIMETRES)
            return placed(upright, solid.frame, solid.origin - solid.frame[:, 2] * solid.height / 2)
        case Hull():
            return Manifold.hull_points(solid.corners * MILLIMETRES)
        case Joined():
            return Manifold.batch_boolean([solid_of(child) for child in solid.solids], OpType.Add)
        case Shared():
            return Manifold.batch_boolean([solid_of(child) for child in solid.solids], OpType.Intersect)
        case Cut():
            taken = [solid_of(child) for child in solid.taken]
            return Manifold.batch_boolean([solid_of(solid.solid), *taken], OpType.Subtract)


def placed(solid: Manifold, frame: Array, origin: Array) -> Manifold:
    """Return a solid, in mm, rotated about the origin, (3, 3), and moved by m, (3,)."""
    return solid.transform(np.column_stack([frame, origin * MILLIMETRES]))


def mesh_of(solid: Manifold) -> Mesh:
    """Return the triangles of a solid in a reproducible order."""
    raw = solid.to_mesh64()
    points, triangles = np.asarray(raw.vert_properties)[:, :3], np.asarray(raw.tri_verts).astype(np.int64)
    # rounded as in files, to a millionth of a millimetre, without -0
    points = np.round(points, 6) + 0.0
    order = np.lexsort(points.T[::-1])
    points, triangles = points[order], np.argsort(order)[triangles]
    # each triangle begins with its first point
    rolled = np.argmin(triangles, axis=1)
    triangles = np.take_along_axis(triangles, (rolled[:, None] + np.arange(3)) % 3, axis=1)
    return Mesh(points=points, triangles=triangles[np.lexsort(triangles.T[::-1])])


def _rod(rod: Rod) -> Manifold:
    along = (rod.end - rod.start) / (length := float(np.linalg.norm(rod.end - rod.start)))
    radius = rod.diameter / 2 * MILLIMETRES * _WIDER
    upright = Manifold.cylinder(length * MILLIMETRES, radius, circular_segments=_CORNERS)
    return placed(upright, frame_along(along), rod.start)
