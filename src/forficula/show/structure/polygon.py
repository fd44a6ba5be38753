"""Flat polygons in space, as they are drawn."""

from __future__ import annotations

import numpy as np

from forficula.arrays import Array
from forficula.pattern.geometry import polygon_normal
from forficula.pattern.triangulation import ears


def is_convex(corners: Array) -> bool:
    """Return whether no corner of a polygon, m, (corner, axis), points inwards."""
    sides = np.roll(corners, -1, axis=0) - corners
    return bool((np.cross(sides, np.roll(sides, -1, axis=0)) @ polygon_normal(corners) >= 0).all())


def drawn_pieces(corners: Array) -> list[tuple[int, ...]]:
    """Cut a flat polygon without crossings into pieces of three or four corners.

    Args:
        corners: m, (corner, axis).

    Returns:
        Numbers of the corners of each piece, counterclockwise seen from above, or in the order given where the polygon
        stands upright. A convex polygon of four corners is one piece.
    """
    around = range(len(corners)) if polygon_normal(corners)[2] >= 0 else range(len(corners))[::-1]
    return [tuple(around)] if len(around) == 4 and is_convex(corners) else [*ears(corners, around)]
