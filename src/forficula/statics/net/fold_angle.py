"""Fold angles of creases between two panels, with gradient and Hessian by the sides of the panels."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from forficula.arrays import Array

_SIGNS = np.array([[1.0], [-1.0]])  # of the angle of a panel on the left and on the right of a crease
_CYCLE = np.array([0, 1, 2, 0, 1])


def fold_angles(sides: Array, near: Array) -> Array:
    """Compute fold angles: 0 flat, valleys positive, without a jump at +-pi.

    Args:
        sides: vectors from tail to head, from the tail to the left corner, and to the right corner, m, (3, side,
            crease): by coordinate. For an open crease, the first is the mean of the vectors of its two panels.
        near: reference angles, rad, (crease,): each result is within pi of its reference.

    Returns:
        Angles, rad, (crease,).
    """
    return turned_angles(crease_frames(sides), near)


class CreaseFrames(NamedTuple):
    """Unit vectors at creases and at the panels on their left and right.

    Attributes:
        along: along each crease, (3, crease).
        length: of each crease, m, (crease,).
        normal: to each panel, (3, panel, crease).
        across: in each panel, normal x along, (3, panel, crease).
        height: of the corner of each panel above the crease, m, (panel, crease).
    """

    along: Array
    length: Array
    normal: Array
    across: Array
    height: Array


def crease_frames(sides: Array) -> CreaseFrames:
    """Return the unit vectors at creases, from their sides, (3, side, crease)."""
    length = side_lengths(sides[:, 0])
    cycled = sides[_CYCLE]
    along = cycled[:, :1] / length
    normal = _cross(along, cycled[:, 1:])
    height = np.sqrt(np.einsum("ipc,ipc->pc", normal, normal))
    normal = normal / height
    return CreaseFrames(along[:3, 0], length, normal, _cross(normal[_CYCLE], along), height)


def turned_angles(frames: CreaseFrames, near: Array) -> Array:
    """Return the fold angles, rad, (crease,), within pi of references."""
    right = frames.normal[:, 1]
    sine = np.einsum("ic,ic->c", frames.across[:, 0], right)
    angles = np.arctan2(-sine, -np.einsum("ic,ic->c", frames.normal[:, 0], right))
    return np.asarray(angles + 2 * np.pi * np.round((near - angles) / (2 * np.pi)))


def angle_gradients(frames: CreaseFrames, shares: Array) -> Array:
    """Compute the gradient of fold angles by their sides, 1/m, (3, side, crease).

    With e along the crease, u to a corner at the height h above it, n the unit normal of its panel and t = n x e / |e|,
    the gradient by u is n / h. The gradients by e follow from invariance under rotation and sliding (Bridson, Marino
    and Fedkiw 2003, doi 10.2312/SCA03/028-036; Hessian as in Tamstorf and Grinspun 2013,
    doi 10.1016/j.gmod.2013.07.001, here by sides instead of corners). No angle is singular.
    """
    slope = np.empty((3, 3, len(frames.length)))
    np.multiply(frames.normal, _SIGNS / frames.height, out=slope[:, 1:])
    by_along = shares * slope[:, 1:]
    np.add(by_along[:, 0], by_along[:, 1], out=slope[:, 0])
    slope[:, 0] *= -1
    return slope


def corner_shares(sides: Array, frames: CreaseFrames) -> Array:
    """Return the positions of corners along their creases, divided by the creases' lengths, (panel, crease)."""
    return np.asarray(np.einsum("ipc,ic->pc", sides[:, 1:], frames.along) / frames.length)


def add_curvature(blocks: Array, frames: CreaseFrames, shares: Array, slope: Array, factor: Array) -> None:
    """Add the Hessian of fold angles, times a factor, to blocks of pairs of coordinates, then of sides.

    Args:
        blocks: changed in place, (3, 3, side, side, crease).
        frames: of the creases.
        shares: positions of corners along their creases, (panel, crease).
        slope: gradient of the angles, 1/m, (3, side, crease).
        factor: for each crease, (crease,).
    """
    along, length, _, across, height = frames
    by_corner = factor * slope[:, 1:]
    bent = by_corner[:, None] * (across / height)
    bent = bent + bent.swapaxes(0, 1)
    lifted = (along / length)[:, None, None] * by_corner
    tilted = shares * bent - lifted
    pairs = blocks.reshape(3, 3, 9, -1)
    pairs[:, :, 4::4] -= bent
    pairs[:, :, 3::3] += tilted
    pairs[:, :, 1:3] += tilted.swapaxes(0, 1)
    twisted = shares * (lifted + lifted.swapaxes(0, 1)) - (shares**2 + (height / length) ** 2 / 2) * bent
    pairs[:, :, 0] += twisted[:, :, 0]
    pairs[:, :, 0] += twisted[:, :, 1]


def _cross(a: Array, b: Array) -> Array:
    """Return the cross product of vectors whose first two coordinates follow the third one again, (5, ...)."""
    return np.asarray(a[1:4] * b[2:5] - a[2:5] * b[1:4])


def side_lengths(sides: Array) -> Array:
    """Return the lengths of vectors, m, (vector,), from their coordinates, (3, vector)."""
    return np.asarray(np.sqrt(np.einsum("is,is->s", sides, sides)))
