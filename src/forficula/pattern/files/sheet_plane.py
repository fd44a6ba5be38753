"""The plane in which a flat sheet lies, turned into a plane of constant z."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.pattern.geometry import polygon_normal
from forficula.pattern.rotation import rotation_to_z

_FLAT = 1e-6  # share of the sheet's size that vertices may lie off its plane: single precision is good to 1e-7


@dataclass(frozen=True, kw_only=True, eq=False)
class SheetPlane:
    """How a sheet is turned so that its plane is one of constant z: x -> rotation x, then z lowered.

    Attributes:
        rotation: shape (3, 3).
        height: z of the plane once turned, m; the sheet is lowered by it.
    """

    rotation: Array
    height: float

    def turned(self, points: Array) -> Array:
        """Turn points of the sheet, or of a folded state of it, m, shape (N, 3)."""
        moved: Array = points @ self.rotation.T - np.array([0.0, 0.0, self.height])
        return moved + 0.0  # no -0.0


def sheet_plane(points: Array, faces: Sequence[Sequence[int]]) -> SheetPlane | None:
    """Find the plane of a flat sheet and the side of it that is up.

    FOLD lists the vertices of a face counterclockwise as seen from above; where the faces agree, that side is up, and
    valleys stay valleys. Otherwise up is along the axis to which the plane is most nearly square. So a sheet in the
    xz plane with up along y, as Origami Simulator writes it, is seen from +y, x to the right and -z upwards:
    (x, y, z) becomes (x, -z, y). In general the turn is the smallest that brings up to z. A sheet in a plane of
    constant z is not turned.

    Args:
        points: m, shape (N, 3).
        faces: their vertices; none where they are not known.

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
