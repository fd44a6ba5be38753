"""Rotations about an axis, about a line and onto an axis, and rigid motions."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from forficula.arrays import Array


class RigidMotion(NamedTuple):
    """A rotation followed by a shift: x -> rotation x + shift.

    Attributes:
        rotation: (3, 3).
        shift: m, (3,).
    """

    rotation: Array
    shift: Array

    def of(self, points: Array) -> Array:
        """Move points, m, (..., 3)."""
        moved: Array = points @ self.rotation.T + self.shift
        return moved

    def after(self, first: RigidMotion) -> RigidMotion:
        """Return the motion that applies another one first, then this one."""
        return RigidMotion(self.rotation @ first.rotation, self.rotation @ first.shift + self.shift)


IDENTITY_MOTION = RigidMotion(np.eye(3), np.zeros(3))


def rotation_about(axis: Array, angle: float) -> Array:
    """Compute the rotation by an angle about a unit vector, (3, 3) (Rodrigues' formula)."""
    x, y, z = axis.tolist()
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    # 2 sin^2(angle / 2) is accurate at small angles, unlike 1 - cos(angle)
    return np.asarray(np.eye(3) + math.sin(angle) * cross + 2 * math.sin(angle / 2) ** 2 * cross @ cross)


def rotations_about(axis: Array, angles: Array) -> Array:
    """Compute the rotations by several angles about a unit vector, (angle, 3, 3), as `rotation_about`."""
    x, y, z = axis.tolist()
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    halves = 2 * np.sin(angles / 2) ** 2
    return np.asarray(np.eye(3) + np.sin(angles)[:, None, None] * cross + halves[:, None, None] * (cross @ cross))


def turn_about(origin: Array, axis: Array, angle: float) -> RigidMotion:
    """Compute the rotation by an angle about a line through a position, m, along a unit vector."""
    rotation = rotation_about(axis, angle)
    return RigidMotion(rotation, origin - rotation @ origin)


def motion_from(before: Array, after: Array) -> tuple[Array, Array]:
    """Compute the rigid motions that take points to other positions, by least squares (Kabsch 1976).

    Args:
        before: m, (point, 3); the points need not span space, but a plane.
        after: m, (..., point, 3).

    Returns:
        Rotations, (..., 3, 3), and shifts after them, m, (..., 3).
    """
    middle, middles = before.mean(axis=0), after.mean(axis=-2)
    one, _, other = np.linalg.svd(np.swapaxes(after - middles[..., None, :], -1, -2) @ (before - middle))
    signs = np.ones(one.shape[:-1])
    signs[..., 2] = np.linalg.det(one @ other)
    turns = one * signs[..., None, :] @ other
    return turns, middles - turns @ middle


def rotation_to_z(direction: Array) -> Array:
    """Compute the rotation that turns a unit vector to +z, about an axis normal to both, (3, 3) (Rodrigues 1840)."""
    x, y, z = direction.tolist()
    if z < -1 + 1e-12:
        return np.diag([1.0, -1.0, -1.0])
    across = np.array([[0.0, 0.0, -x], [0.0, 0.0, -y], [x, y, 0.0]])
    return np.asarray(np.eye(3) + across + across @ across / (1 + z))


def frame_along(direction: Array) -> Array:
    """Return axes in columns, (3, 3), with a unit vector as the third; robust to rounding of this vector."""
    across = np.cross(direction, np.eye(3)[int(np.argmin(np.round(np.abs(direction), 9)))])
    across /= np.linalg.norm(across)
    return np.column_stack([across, np.cross(direction, across), direction])
