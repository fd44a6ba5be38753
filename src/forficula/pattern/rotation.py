"""Rotation matrices about an axis, and onto one."""

from __future__ import annotations

import math

import numpy as np

from forficula.arrays import Array


def rotation_about(axis: Array, angle: float) -> Array:
    """Compute the rotation by an angle about a unit vector, (3, 3) (Rodrigues' formula)."""
    x, y, z = axis.tolist()
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    # the double half sine keeps the digits that 1 - cos loses at small angles
    return np.asarray(np.eye(3) + math.sin(angle) * cross + 2 * math.sin(angle / 2) ** 2 * cross @ cross)


def rotation_to_z(direction: Array) -> Array:
    """Compute the rotation about an axis across both that brings a unit vector to +z, (3, 3) (Rodrigues 1840)."""
    x, y, z = direction.tolist()
    if z < -1 + 1e-12:
        return np.diag([1.0, -1.0, -1.0])
    across = np.array([[0.0, 0.0, -x], [0.0, 0.0, -y], [x, y, 0.0]])
    return np.asarray(np.eye(3) + across + across @ across / (1 + z))
