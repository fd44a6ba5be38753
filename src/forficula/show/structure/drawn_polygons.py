"""Polygons of facets, plates and membranes, divided into the pieces that drawings fill."""

from __future__ import annotations

import numpy as np

from forficula.arrays import Array, Indices
from forficula.pattern.geometry import polygon_normal
from forficula.pattern.thick.convex import convex_faces
from forficula.pattern.triangulation import ears
from forficula.structure import Plate


def plate_polygons(plate: Plate, anchors: Array) -> list[tuple[int, ...]]:
    """Return the corners of the drawn polygons of a plate: its mid-plane, or the faces of its solids."""
    if not plate.solids:
        return [plate.points]
    return [
        tuple(solid[corner] for corner in face) for solid in plate.solids for face in convex_faces(anchors[list(solid)])
    ]


def convex_pieces(corners: int) -> list[tuple[int, ...]]:
    """Divide a convex polygon into pieces of three or four corners, in their order."""
    first = list(range(1, corners - 1, 2))
    return [tuple(corner for corner in (0, one, one + 1, one + 2) if corner < corners) for one in first]


def quads(triangles: Indices, built: Array) -> list[tuple[int, ...]]:
    """Merge consecutive triangles that are halves of a convex quadrilateral; keep the others."""
    pieces: list[tuple[int, ...]] = []
    for corners in map(tuple, triangles.tolist()):
        last = pieces[-1] if pieces else ()
        if len(last) == 3 and corners[:2] == (last[0], last[2]) and is_convex(built[[*last, corners[2]]]):
            pieces[-1] = (*last, corners[2])
        else:
            pieces.append(corners)
    return pieces


def is_convex(corners: Array) -> bool:
    """Return whether a polygon, m, (corner, axis), is convex."""
    sides = np.roll(corners, -1, axis=0) - corners
    return bool((np.cross(sides, np.roll(sides, -1, axis=0)) @ polygon_normal(corners) >= 0).all())


def drawn_pieces(corners: Array) -> list[tuple[int, ...]]:
    """Divide a flat polygon without crossings into pieces of three or four corners.

    Args:
        corners: m, (corner, axis).

    Returns:
        Indices of the corners of each piece, counterclockwise seen from above, or in the given order for a vertical
        polygon.
        A convex polygon of four corners is one piece.
    """
    around = range(len(corners)) if polygon_normal(corners)[2] >= 0 else range(len(corners))[::-1]
    return [tuple(around)] if len(around) == 4 and is_convex(corners) else [*ears(corners, around)]
