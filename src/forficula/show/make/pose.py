"""Where parts are when their joints are turned, and when they are taken apart."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from forficula.arrays import Array
from forficula.make.hinge.joint import turned
from forficula.make.hinge.joint_layout import JointLayout
from forficula.make.part import Part, PartSet
from forficula.pattern.rotation import STILL, RigidMotion
from forficula.structure import GROUND

# how far parts are moved apart at most, by the length of the arms that are moved, or by what they are
_APART, _RAISED, _PULLED = 0.3, 0.45, 1.6


def angle_range(parts: PartSet) -> tuple[float, float]:
    """From the stop of the fold that is furthest to the furthest stop of an overbend, rad."""
    return min(joint.lower for joint in parts.joints), max(joint.upper for joint in parts.joints)


def poses_at(parts: PartSet, angle: float) -> Mapping[int, RigidMotion]:
    """Every body with all joints at an angle in their own senses, rad, each no further than its own stops.

    A joint alone turns its distal half; bars that turn against the ground stay as they are built.
    """
    by_body = {joint.distal.body: joint for joint in parts.joints}
    poses = {GROUND: STILL}
    for number, body in enumerate(parts.structure.bodies):
        pose = poses[body.parent]
        if number in by_body:
            pose = pose.after(turned(by_body[number], within(by_body[number], angle)))
        poses[number] = pose
    return poses


def within(joint: JointLayout, angle: float) -> float:
    """An angle, rad, or the stop that it is beyond."""
    return float(np.clip(angle, joint.lower, joint.upper))


def apart(parts: PartSet) -> list[Array]:
    """How far every part is moved, as built, when all are taken apart, m, (3,) each.

    A distal half is moved away from its hinge with what hangs on it, a pin out of its knuckles, straps up from the
    bars, the hub back from its rods.
    """
    ways = {GROUND: np.zeros(3)}
    by_body = {joint.distal.body: joint for joint in parts.joints}
    for number, body in enumerate(parts.structure.bodies):
        ways[number] = ways[body.parent]
        if number in by_body:
            joint = by_body[number]
            ways[number] = ways[number] + _APART * joint.distal.length * joint.distal.along
    return [_apart(parts, part, ways) for part in parts.parts]


def _apart(parts: PartSet, part: Part, ways: Mapping[int, Array]) -> Array:
    same = [each for each in parts.parts if each.kind == part.kind]
    place = same.index(part)
    back = np.mean([root.along for root in parts.roots], axis=0) if parts.roots else np.zeros(3)
    rod = parts.roots[0].make.root_length if parts.roots else 0.0
    match part.kind:
        case "strap":
            strap = parts.straps[place]
            between = (ways[strap.bodies[0]] + ways[strap.bodies[1]]) / 2
            return np.asarray(between + _RAISED * strap.strap.rest_length * strap.up)
        case "pin":
            joint = [each for each in parts.joints if each.make.hinge == "pin"][place]
            return np.asarray(ways[joint.proximal.body] - _PULLED * joint.width * joint.frame[:, 1])
        case "hub":
            return np.asarray(-6 * rod * back)
        case "root":
            return np.asarray(-3 * rod * back)
    return np.asarray(ways[GROUND if part.body is None else part.body])
