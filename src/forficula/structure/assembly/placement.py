"""Placement of the parts of an assembly: where the axes of a part lie, from points and directions."""

from __future__ import annotations

import numpy as np

from forficula.arrays import Array
from forficula.design.assembly.joints import PlacingJoint
from forficula.errors import InputError
from forficula.pattern.rotation import IDENTITY_MOTION, RigidMotion, rotation_about

# sine of an angle between two directions below which they count as parallel
_PARALLEL = 1e-9


def part_motion(joint: PlacingJoint | None, points: Array, onto: Array) -> RigidMotion:
    """Return the motion from the axes of a part to those of the assembly, in the built shape.

    Args:
        joint: joint that places the part; None for a part that keeps the coordinates of its own design.
        points: positions of the joint's points in the axes of the part, m, (point, 3).
        onto: positions in the axes of the assembly on which they come to lie, m, (point, 3); the distance of the second
            from the first does not matter.

    Raises:
        InputError: two points that coincide, or `up` along the line through both points.
    """
    if joint is None or not len(points):
        return IDENTITY_MOTION if joint is None or joint.up is None else RigidMotion(_upright(joint), np.zeros(3))
    turn = _turn(joint, points, onto)
    return RigidMotion(turn, onto[0] - turn @ points[0])


def _upright(joint: PlacingJoint) -> Array:
    """Return the smallest turn that brings the z axis to the direction `up`."""
    return _smallest_turn(np.array([0.0, 0.0, 1.0]), _unit(joint, np.array(joint.up), "up"))


def _turn(joint: PlacingJoint, points: Array, onto: Array) -> Array:
    if len(points) < 2 or len(onto) < 2:
        return np.eye(3) if joint.up is None else _upright(joint)
    before, after = (_unit(joint, ends[1] - ends[0], key) for ends, key in ((points, "points"), (onto, "onto")))
    if joint.up is None:
        return _smallest_turn(before, after)
    one = _axes(joint, before, np.array([0.0, 0.0, 1.0]))
    other = _axes(joint, after, _unit(joint, np.array(joint.up), "up"))
    return np.asarray(other @ one.T)


def _unit(joint: PlacingJoint, vector: Array, key: str) -> Array:
    length = float(np.linalg.norm(vector))
    if not length:
        raise InputError(f"joint.{joint.name}.{key}: need two different points, got twice the same position")
    return vector / length


def _axes(joint: PlacingJoint, along: Array, upwards: Array) -> Array:
    """Return axes, as columns: a direction, and the part of another that is normal to it."""
    normal = upwards - (upwards @ along) * along
    length = float(np.linalg.norm(normal))
    if length < _PARALLEL:
        raise InputError(
            f"joint.{joint.name}.up: the z axis of the part and the line through both points are parallel; leave out"
            " up, or name other points"
        )
    return np.column_stack([along, np.cross(normal / length, along), normal / length])


def _smallest_turn(before: Array, after: Array) -> Array:
    """Return the rotation by the smallest angle from one direction to another."""
    axis, cosine = np.cross(before, after), float(before @ after)
    sine = float(np.linalg.norm(axis))
    if sine < _PARALLEL:
        if cosine > 0:
            return np.eye(3)
        # half a turn about any line that is normal to both
        axis = np.cross(before, np.eye(3)[int(np.argmin(np.abs(before)))])
    return rotation_about(axis / np.linalg.norm(axis), float(np.arctan2(sine, cosine)))
