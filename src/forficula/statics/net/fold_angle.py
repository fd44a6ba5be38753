"""Fold angles of creases with their slopes and curvatures in closed form."""

from __future__ import annotations

import numpy as np

from forficula.arrays import Array


def fold_angles(sides: Array, near: Array) -> Array:
    """Fold angles: 0 flat, valleys positive, without a jump at +-pi.

    Args:
        sides: from tail to head, from the tail to the left corner, and to the right one, m, (crease, 3, 3): side by
            side. Where a crease is open, the first is the mean of those of its two panels.
        near: angles that these follow, rad, (crease,): each comes within pi of its own.

    Returns:
        rad, (crease,).
    """
    along, left, right = np.moveaxis(sides, 1, 0)
    left_normal, right_normal = _cross(along, left), _cross(along, right)
    sine = _dot(along, _cross(left_normal, right_normal)) / np.linalg.norm(along, axis=1)
    angles = np.arctan2(sine, -_dot(left_normal, right_normal))
    return np.asarray(angles + 2 * np.pi * np.round((near - angles) / (2 * np.pi)))


def fold_angle_derivatives(sides: Array) -> tuple[Array, Array]:
    """Slope and curvature of fold angles by their sides.

    With e along the crease, u to a corner at the height h above it, n the unit normal of its panel and t = n x e / |e|,
    the slope by u is n / h, and the ones by e follow from what turning and sliding leave unchanged (Bridson, Marino and
    Fedkiw 2003, doi 10.2312/SCA03/028-036; curvature as in Tamstorf and Grinspun 2013, doi 10.1016/j.gmod.2013.07.001,
    here by sides instead of corners). Nothing is singular at any angle.

    Args:
        sides: as for `fold_angles`, (crease, 3, 3).

    Returns:
        1/m, (crease, 3, 3): by side; 1/m^2, (crease, 3, 3, 3, 3): by side and side, then by their coordinates.
    """
    count = len(sides)
    slope = np.zeros_like(sides)
    curvature = np.zeros((count, 3, 3, 3, 3))
    length = np.linalg.norm(sides[:, 0], axis=1)
    along = sides[:, 0] / length[:, None]
    # all left corners, then all right ones, for which everything has the other sign
    corner, twice, length = np.concatenate([sides[:, 1], sides[:, 2]]), np.tile(along, (2, 1)), np.tile(length, 2)
    normal = _cross(twice, corner)
    height = np.linalg.norm(normal, axis=1)
    normal = normal / height[:, None]
    across = _cross(normal, twice)
    share = _dot(corner, twice) / length
    mixed = _outer(normal, across)
    mixed = mixed + np.swapaxes(mixed, 1, 2)
    lifted = _outer(twice, normal)
    bent = -mixed / (height**2)[:, None, None]
    tilted = -share[:, None, None] * bent - lifted / (length * height)[:, None, None]
    by_corner, by_along = normal / height[:, None], (share / height)[:, None] * normal
    both = (lifted + np.swapaxes(lifted, 1, 2)) * (share / (height * length))[:, None, None]
    twisted = (share**2)[:, None, None] * bent + both - mixed / (2 * length**2)[:, None, None]
    for side, sign, mine in ((1, 1.0, slice(None, count)), (2, -1.0, slice(count, None))):
        slope[:, side] = sign * by_corner[mine]
        slope[:, 0] -= sign * by_along[mine]
        curvature[:, side, side] = sign * bent[mine]
        curvature[:, side, 0] = sign * tilted[mine]
        curvature[:, 0, side] = sign * np.swapaxes(tilted[mine], 1, 2)
        curvature[:, 0, 0] += sign * twisted[mine]
    return slope, curvature


def _dot(a: Array, b: Array) -> Array:
    return np.asarray(np.einsum("ni,ni->n", a, b))


def _outer(a: Array, b: Array) -> Array:
    return a[:, :, None] * b[:, None, :]


def _cross(a: Array, b: Array) -> Array:
    (ax, ay, az), (bx, by, bz) = a.T, b.T
    crossed = np.empty((len(a), 3))
    crossed[:, 0], crossed[:, 1], crossed[:, 2] = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
    return crossed
