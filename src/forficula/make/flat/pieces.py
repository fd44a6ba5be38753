"""The bars of parts, divided into named pieces: hinge, peg, sleeve, and the bar between them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from manifold3d import Manifold

from forficula.arrays import Array
from forficula.make.hinge.free_range import half
from forficula.make.hinge.joint import PEG_HEAD
from forficula.make.hinge.joint_layout import Arm, JointLayout
from forficula.make.part import PartSet
from forficula.make.solid.mesh import MILLIMETRES
from forficula.structure import GROUND

# m, distance beside a peg that still belongs to the piece "peg"
_BESIDE = 1e-3


@dataclass(frozen=True, kw_only=True, eq=False)
class Piece:
    """A piece of a body, in its built position.

    Attributes:
        body: index of the body, or GROUND.
        feature: "hinge", "peg", "sleeve", "bar" or "hub".
        shape: mm.
        ends: end points of a line through the piece, m, (2, 3).
        radius: around this line that contains the whole piece, m.
        frame: axes of its bounding box, as columns, (3, 3).
        middle: middle of the box, m, (3,).
        half: half sides of the box, m, (3,).
    """

    body: int
    feature: str
    shape: Manifold
    ends: Array
    radius: float
    frame: Array
    middle: Array
    half: Array


def pieces_of(parts: PartSet) -> list[Piece]:
    """Return the pieces of all bars and of the hub; straps and other parts that bend are excluded."""
    arms: dict[int, list[tuple[JointLayout, Arm]]] = {}
    for joint in parts.joints:
        arms.setdefault(joint.proximal.body, []).append((joint, joint.proximal))
        arms.setdefault(joint.distal.body, []).append((joint, joint.distal))
    pieces = [piece for body in sorted(arms) for piece in _cut(parts, body, arms[body])]
    if parts.of_body(GROUND):
        pieces.append(_piece(GROUND, "hub", half(parts, GROUND)))
    return pieces


def _cut(parts: PartSet, body: int, arms: list[tuple[JointLayout, Arm]]) -> list[Piece]:
    """Return the pieces of a bar, cut perpendicular to it, beginning at its first joint."""
    joint, arm = arms[0]
    origin, along = joint.origin, arm.along
    zones: list[tuple[float, float, str]] = []
    for arm_joint, bar_arm in arms:
        at = float((arm_joint.origin - origin) @ along)
        direction = float(np.sign(bar_arm.along @ along))
        zones.append((at - 2 * arm_joint.lug, at + 2 * arm_joint.lug, "hinge"))
        if bar_arm.peg:
            reach = PEG_HEAD * arm_joint.make.peg_diameter / 2 + _BESIDE
            zones.append((at + direction * bar_arm.peg - reach, at + direction * bar_arm.peg + reach, "peg"))
    for root in parts.roots:
        if root.body == body:
            sleeve_start = float(
                (root.at(root.begins + 2 * root.make.root_diameter + root.make.hinge_wall) - origin) @ along
            )
            # slightly before the sleeve, because a plane along its end would leave slivers of it
            zones.append((sleeve_start - _BESIDE / 10, sleeve_start + arm.length, "sleeve"))
    pieces, rest, cut_to = [], half(parts, body), -np.inf
    for low, high, feature in sorted(zones):
        before, rest = _parted(rest, along, origin, max(low, cut_to))
        feature_piece, rest = _parted(rest, along, origin, max(high, cut_to))
        cut_to = max(high, cut_to)
        pieces += [(before, "bar"), (feature_piece, feature)]
    pieces.append((rest, "bar"))
    return [_piece(body, feature, shape) for shape, feature in pieces if shape.num_tri()]


def _parted(solid: Manifold, along: Array, origin: Array, at: float) -> tuple[Manifold, Manifold]:
    """Return the parts of a solid before and beyond a plane perpendicular to a direction."""
    if not np.isfinite(at):
        return Manifold(), solid
    beyond, before = solid.split_by_plane(along.tolist(), float(origin @ along + at) * MILLIMETRES)
    return before, beyond


def _piece(body: int, feature: str, shape: Manifold) -> Piece:
    """Return a piece with its box along its principal axes, and the axis of its smallest enclosing capsule."""
    points = np.asarray(shape.to_mesh64().vert_properties)[:, :3] / MILLIMETRES
    frame = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2].T
    low, high = (points @ frame).min(axis=0), (points @ frame).max(axis=0)
    middle, reach = frame @ (low + high) / 2, (high - low) / 2
    away = (points - middle) @ frame
    radii = [float(np.linalg.norm(np.delete(away, axis, axis=1), axis=1).max()) for axis in range(3)]
    best = min(range(3), key=lambda axis: radii[axis] ** 2 * (2 * reach[axis] + radii[axis]))
    return Piece(
        body=body,
        feature=feature,
        shape=shape,
        ends=middle + np.array([[-reach[best]], [reach[best]]]) * frame[:, best],
        radius=radii[best],
        frame=frame,
        middle=middle,
        half=reach,
    )
