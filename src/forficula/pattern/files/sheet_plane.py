"""The plane of a flat sheet, and its rotation into a plane of constant z."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.pattern.geometry import polygon_normal
from forficula.pattern.rotation import rotation_to_z

_FLAT = 1e-6  # largest distance from the plane, as a share of the sheet's size; single precision is 1e-7


@dataclass(frozen=True, kw_only=True, eq=False)
class SheetPlane:
    """Motion that brings the plane of a sheet to z = 0: a rotation, then a shift along -z.

    Attributes:
        rotation: rotation matrix, shape (3, 3).
        height: z of the plane after the rotation, m; the sheet is lowered by it.
    """

    rotation: Array
    height: float

    def turned(self, points: Array) -> Array:
        """Move points of the sheet, or of a folded state of it, m, shape (N, 3)."""
        moved: Array = points @ self.rotation.T - np.array([0.0, 0.0, self.height])
        return moved + 0.0  # no -0.0


def sheet_plane(points: Array, faces: Sequence[Sequence[int]]) -> SheetPlane | None:
    """Find the plane of a flat sheet and its upper side.

    FOLD lists the vertices of a face counterclockwise as seen from above; where the faces agree, that side is up, and
    valleys remain valleys. Otherwise up is along the axis to which the plane is most nearly perpendicular. So a sheet
    in the xz plane with up along y, as Origami Simulator writes it, is seen from +y, with x to the right and -z
    upwards: (x, y, z) becomes (x, -z, y). The rotation is the smallest one that brings up to z. A sheet in a plane of
    constant z is not rotated.

    Args:
        points: positions of the vertices, m, shape (N, 3).
        faces: vertices of the faces; empty where they are not known.

    Returns:
        None where the sheet is not flat, to 1e-6 of its size.
    """
    centred = points - points.mean(axis=0)
    size = float(np.ptp(points, axis=0).max())
    for axis in (2, 1, 0):
        if np.ptp(points[:, axis]) <= _FLAT * size:
            normal = np.eye(3)[axis]
            break
    else:
        normal = np.linalg.svd(centred, full_matrices=False)[2][-1]
        normal = normal * np.sign(normal[np.argmax(np.abs(normal))])
        if np.ptp(centred @ normal) > _FLAT * size:
            return None
    if normal[2] == 1:
        return SheetPlane(rotation=np.eye(3), height=0.0)
    areas = np.array([polygon_normal(points[list(face)]) @ normal for face in faces])
    if len(areas) and (areas < 0).all():
        normal = -normal
    rotation = rotation_to_z(normal)
    return SheetPlane(rotation=rotation, height=float((points @ rotation[2]).mean()))
