"""The bars of parts cut into pieces that have a name each: hinge, peg, sleeve, and the bar between them."""

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

# beside a peg, what is still called so, m
_BESIDE = 1e-3


@dataclass(frozen=True, kw_only=True, eq=False)
class Piece:
    """A piece of a body, where it is as built.

    Attributes:
        body: its number, or GROUND.
        feature: what it is: "hinge", "peg", "sleeve", "bar" or "hub".
        shape: mm.
        ends: of a line in it, m, (2, 3).
        radius: around that line within which all of it is, m.
        frame: axes of the box that holds it, as columns, (3, 3).
        middle: of the box, m, (3,).
        half: of its sides, m, (3,).
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
    """All bars and the hub in pieces; no straps, and nothing else that bends."""
    arms: dict[int, list[tuple[JointLayout, Arm]]] = {}
    for joint in parts.joints:
        arms.setdefault(joint.proximal.body, []).append((joint, joint.proximal))
        arms.setdefault(joint.distal.body, []).append((joint, joint.distal))
    found = [piece for body in sorted(arms) for piece in _cut(parts, body, arms[body])]
    if parts.of_body(GROUND):
        found.append(_piece(GROUND, "hub", half(parts, GROUND)))
    return found


def _cut(parts: PartSet, body: int, arms: list[tuple[JointLayout, Arm]]) -> list[Piece]:
    """A bar in pieces, square to it, from where its first joint is."""
    joint, arm = arms[0]
    origin, along = joint.origin, arm.along
    zones: list[tuple[float, float, str]] = []
    for its, own in arms:
        at = float((its.origin - origin) @ along)
        way = float(np.sign(own.along @ along))
        zones.append((at - 2 * its.lug, at + 2 * its.lug, "hinge"))
        if own.peg:
            reach = PEG_HEAD * its.make.peg_diameter / 2 + _BESIDE
            zones.append((at + way * own.peg - reach, at + way * own.peg + reach, "peg"))
    for root in parts.roots:
        if root.body == body:
            deep = float((root.at(root.begins + 2 * root.make.root_diameter + root.make.hinge_wall) - origin) @ along)
            # a little before it, for a plane along its end would leave slivers of it
            zones.append((deep - _BESIDE / 10, deep + arm.length, "sleeve"))
    found, rest, begun = [], half(parts, body), -np.inf
    for low, high, feature in sorted(zones):
        before, rest = _parted(rest, along, origin, max(low, begun))
        own_piece, rest = _parted(rest, along, origin, max(high, begun))
        begun = max(high, begun)
        found += [(before, "bar"), (own_piece, feature)]
    found.append((rest, "bar"))
    return [_piece(body, feature, shape) for shape, feature in found if shape.num_tri()]


def _parted(solid: Manifold, along: Array, origin: Array, at: float) -> tuple[Manifold, Manifold]:
    """What of a solid is before a plane square to a direction, and what is beyond it."""
    if not np.isfinite(at):
        return Manifold(), solid
    beyond, before = solid.split_by_plane(along.tolist(), float(origin @ along + at) * MILLIMETRES)
    return before, beyond


def _piece(body: int, feature: str, shape: Manifold) -> Piece:
    """A piece with its box along its principal axes, and a line through its middle: that which takes the least room."""
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
