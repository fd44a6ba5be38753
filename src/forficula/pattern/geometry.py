"""Vectors, triangles and polygons in space, and positions within polygons of a plane."""

from __future__ import annotations

import numpy as np

from forficula.arrays import Array

# indices of coordinates: the first three are the next coordinate of x, y, z, the last three the previous one
_AROUND = np.array([1, 2, 0, 1])


def dot(one: Array, other: Array) -> Array:
    """Compute dot products of vectors with the coordinates on the first axis, (3, ...)."""
    products = one * other
    return np.asarray(products[0] + products[1] + products[2])


def cross(one: Array, other: Array) -> Array:
    """Compute cross products with the coordinates on the first axis, (3, ...); much faster than `np.cross`."""
    one, other = one[_AROUND], other[_AROUND]
    return np.asarray(one[:3] * other[1:] - one[1:] * other[:3])


def triangle_normals(corners: Array) -> Array:
    """Compute normals of triangles with a length of twice the area, m^2, (..., 3), from corners, (..., 3, 3)."""
    return np.cross(corners[..., 1, :] - corners[..., 0, :], corners[..., 2, :] - corners[..., 0, :])


def triangle_areas(corners: Array) -> Array:
    """Compute the areas of triangles, m^2, (...), from their corners, m, (..., 3, 3)."""
    return np.asarray(np.linalg.norm(triangle_normals(corners), axis=-1) / 2)


def polygon_normal(corners: Array) -> Array:
    """Compute the normal of a polygon with a length of twice the area, m^2, (..., 3), from corners, (..., corner, 3).

    The corners are counterclockwise seen from the tip of the normal. For a polygon that is not flat, the result is
    Newell's normal.
    """
    away = corners - corners[..., :1, :]
    return np.asarray(np.cross(away, np.roll(away, -1, axis=-2)).sum(axis=-2))


def distance_to_sides(sides: Array, place: Array) -> float:
    """Compute the distance of a position from the nearest of some line segments, m, (side, 2 ends, axis)."""
    start, side = sides[:, 0], sides[:, 1] - sides[:, 0]
    share = np.clip(((place - start) * side).sum(axis=1) / (side**2).sum(axis=1), 0, 1)
    return float(np.linalg.norm(start + share[:, None] * side - place, axis=1).min())


def is_inside(place: Array, corners: Array, beside: float = 0.0) -> bool:
    """Return whether a position lies inside a polygon (even-odd rule), or within a distance of a side.

    Args:
        place: m, (2,).
        corners: corners of the polygon, m, (corner, 2).
        beside: the distance, m; with 0 the result for a position on a side is undefined.
    """
    after = np.roll(corners, -1, axis=0)
    if beside and distance_to_sides(np.stack([corners, after], axis=1), place) <= beside:
        return True
    spans = (corners[:, 1] > place[1]) != (after[:, 1] > place[1])
    low, high = corners[spans], after[spans]
    where = low[:, 0] + (place[1] - low[:, 1]) / (high[:, 1] - low[:, 1]) * (high[:, 0] - low[:, 0])
    return bool(np.count_nonzero(where > place[0]) % 2)
