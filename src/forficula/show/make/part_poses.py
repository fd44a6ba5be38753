"""Positions of parts when their joints turn, and in an exploded view."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from forficula.arrays import Array
from forficula.make.hinge.joint import turned
from forficula.make.hinge.joint_layout import JointLayout
from forficula.make.part import Part, PartSet
from forficula.make.solid.poses import tree_poses
from forficula.pattern.rotation import IDENTITY_MOTION, RigidMotion
from forficula.show.make.part_mesh import part_mesh
from forficula.structure import GROUND

# largest distances in an exploded view, as shares of the length of the arms that are moved, or of the part
_APART, _RAISED, _PULLED = 0.3, 0.45, 1.6


def angle_range(parts: PartSet) -> tuple[float, float]:
    """Return the lowest stop of folding and the highest stop of the overbend over all joints, rad.

    Thick panels without joints fold from 0 to their largest fold angle.
    """
    if not parts.joints:
        return 0.0, 0.0 if parts.fold is None else float(np.abs(parts.fold[-1]).max())
    return min(joint.lower for joint in parts.joints), max(joint.upper for joint in parts.joints)


def poses_at(parts: PartSet, angle: float) -> Mapping[int, RigidMotion]:
    """Return the motion of every body with all joints at an angle in their own senses, rad, limited by their stops.

    A single joint turns its distal half. Bars that turn against the ground keep their built positions. Thick panels
    fold along their path until their largest fold angle is the given one.
    """
    if parts.fold is not None:
        return _folded(parts, parts.fold, angle)
    by_body = {joint.distal.body: joint for joint in parts.joints}
    poses = {GROUND: IDENTITY_MOTION}
    for number, body in enumerate(parts.structure.bodies):
        pose = poses[body.parent]
        if number in by_body:
            pose = pose.after(turned(by_body[number], within(by_body[number], angle)))
        poses[number] = pose
    return poses


def _folded(parts: PartSet, fold: Array, angle: float) -> Mapping[int, RigidMotion]:
    """Return the motion of every body at a pose of the fold path of thick panels."""
    largest = float(np.abs(fold[-1]).max())
    place = np.clip(angle / largest, 0, 1) * (len(fold) - 1)
    first = min(int(place), len(fold) - 2)
    between = fold[first] + (place - first) * (fold[first + 1] - fold[first])
    poses = tree_poses(parts.structure, between[None], [0])
    motions = [RigidMotion(turn, shift) for turn, shift in zip(poses.frames[0], poses.origins[0], strict=True)]
    return {GROUND: IDENTITY_MOTION, **dict(enumerate(motions[: len(parts.structure.bodies)]))}


def within(joint: JointLayout, angle: float) -> float:
    """Return an angle, rad, limited to a joint's stops."""
    return float(np.clip(angle, joint.lower, joint.upper))


def apart(parts: PartSet) -> list[Array]:
    """Return the displacement of every part in an exploded view, in the built shape, m, (3,) each.

    A distal half moves away from its hinge with everything attached to it, a pin out of its knuckles, straps up from
    the bars, the hub away from its rods.
    """
    shifts = {GROUND: np.zeros(3)}
    by_body = {joint.distal.body: joint for joint in parts.joints}
    for number, body in enumerate(parts.structure.bodies):
        shifts[number] = shifts[body.parent]
        if number in by_body:
            joint = by_body[number]
            shifts[number] = shifts[number] + _APART * joint.distal.length * joint.distal.along
    return [_apart(parts, part, shifts) for part in parts.parts]


def _apart(parts: PartSet, part: Part, shifts: Mapping[int, Array]) -> Array:
    same = [item for item in parts.parts if item.kind == part.kind]
    index = same.index(part)
    back = np.mean([root.along for root in parts.roots], axis=0) if parts.roots else np.zeros(3)
    rod = parts.roots[0].make.root_length if parts.roots else 0.0
    match part.kind:
        case "panel":
            centres = [np.mean(part_mesh(item, ()).points, axis=0) for item in same]
            return np.asarray(_APART * (centres[index] - np.mean(centres, axis=0)))
        case "strap":
            strap = parts.straps[index]
            between = (shifts[strap.bodies[0]] + shifts[strap.bodies[1]]) / 2
            return np.asarray(between + _RAISED * strap.strap.rest_length * strap.up)
        case "pin":
            joint = [joint for joint in parts.joints if joint.make.hinge == "pin"][index]
            return np.asarray(shifts[joint.proximal.body] - _PULLED * joint.width * joint.frame[:, 1])
        case "hub":
            return np.asarray(-6 * rod * back)
        case "root":
            return np.asarray(-3 * rod * back)
    return np.asarray(shifts[GROUND if part.body is None else part.body])
