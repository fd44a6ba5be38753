"""Roots of bars at the ground: flexible rods between a hub and sleeves at the ends of the bars."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.design import MakeSection
from forficula.make.hinge.joint import above_bed
from forficula.make.hinge.joint_layout import Arm, JointLayout
from forficula.make.solid.solids import Cut, Joined, Prism, Rod, Solid
from forficula.structure import GROUND, Structure

# length of a rod in the hub and in the sleeve, in diameters
_DEEP = 2.0
# step, m, of the search for the position along a bar at which its sleeve clears the others
_STEP = 1e-3


@dataclass(frozen=True, kw_only=True, eq=False)
class Root:
    """The flexible rod on which a bar turns.

    Attributes:
        body: index of the bar's body.
        place: position of the joint that it replaces, at the height of the bar's axis, m, (3,).
        along: unit vector from there along the bar, (3,).
        begins: distance from there to the beginning of the bar, m.
        make: how it is made.
    """

    body: int
    place: Array
    along: Array
    begins: float
    make: MakeSection

    @property
    def bends(self) -> float:
        """Distance of the middle of the bending length from the joint that it replaces, m."""
        return self.begins - self.make.root_length / 2

    @property
    def sleeve(self) -> float:
        """Diameter of the sleeve of the rod at either end, m."""
        return self.make.root_diameter + 2 * self.make.hinge_wall

    def at(self, distance: float) -> Array:
        """Return a point on its line, m, (3,)."""
        place: Array = self.place + distance * self.along
        return place


def roots_of(structure: Structure, joints: Sequence[JointLayout]) -> tuple[Root, ...]:
    """Return the roots of all bars that turn against the ground; each bar begins where its sleeve clears the others."""
    lines: dict[int, tuple[JointLayout, Arm]] = {}
    for joint in joints:
        if structure.bodies[joint.proximal.body].parent == GROUND and _turns(structure, joint.proximal.body):
            lines.setdefault(joint.proximal.body, (joint, joint.proximal))
    roots = []
    for body, (joint, arm) in lines.items():
        rise = joint.standoff * joint.frame[:, 2]
        place = joint.origin + arm.length * arm.along + rise
        make = joint.make
        root = Root(body=body, place=place, along=-arm.along, begins=make.root_length, make=make)
        roots.append(root)
    begins = [_clear(root, [other for other in roots if other is not root], lines) for root in roots]
    return tuple(
        Root(body=root.body, place=root.place, along=root.along, begins=at, make=root.make)
        for root, at in zip(roots, begins, strict=True)
    )


def hub_solid(roots: Sequence[Root]) -> Solid:
    """Return the hub: a plate with sleeves for all rods, without the rods."""
    thickness = max(root.sleeve for root in roots)
    ends = np.array([root.at(at) for root in roots for at in _held(root)])
    heights = ends[:, 2]
    low, high = float(heights.min()) - thickness / 2, float(heights.max()) + thickness / 2
    corners = ends[:, None, :2] + thickness / 2 * _circle()[None]
    flat = corners.reshape(-1, 2)
    plate = Prism(
        outline=flat[scipy.spatial.ConvexHull(flat).vertices],
        origin=np.array([0.0, 0.0, (low + high) / 2]),
        frame=np.eye(3),
        height=high - low,
    )
    return Cut(solid=plate, taken=tuple(rod_solid(root) for root in roots))


def rod_solid(root: Root) -> Rod:
    """Return the flexible rod, including its ends in the hub and in the bar's sleeve."""
    deep = _DEEP * root.make.root_diameter
    start, end = root.begins - root.make.root_length - deep, root.begins + deep
    return Rod(start=root.at(start), end=root.at(end), diameter=root.make.root_diameter)


def with_sleeve(bar: Solid, root: Root, joint: JointLayout) -> Solid:
    """Return a bar that begins at its root, with a sleeve around the rod.

    Args:
        bar: bar from the joint that the root replaces.
        root: root of the bar.
        joint: whose proximal side the bar is.
    """
    deep = _DEEP * root.make.root_diameter
    before = Rod(start=root.at(-joint.proximal.length), end=root.at(root.begins), diameter=4 * root.sleeve)
    sleeve = Rod(
        start=root.at(root.begins), end=root.at(root.begins + deep + root.make.hinge_wall), diameter=root.sleeve
    )
    begun = Joined(solids=(Cut(solid=bar, taken=(before,)), sleeve))
    return Cut(solid=begun, taken=(rod_solid(root), above_bed(joint)))


def _turns(structure: Structure, body: int) -> bool:
    """Return whether any hinge turns a body against the ground."""
    return any(hinge.body == body for hinge in structure.hinges)


def _held(root: Root) -> tuple[float, float]:
    """Return the interval of a rod that the hub holds, m from the joint."""
    end = root.begins - root.make.root_length
    return end - _DEEP * root.make.root_diameter, end - root.sleeve / 2


def _circle() -> Array:
    turns = np.linspace(0.0, 2 * np.pi, 24, endpoint=False)
    return np.column_stack([np.cos(turns), np.sin(turns)])


def _clear(root: Root, others: Sequence[Root], lines: Mapping[int, tuple[JointLayout, Arm]]) -> float:
    """Return the distance along a bar at which its sleeve clears the other bars and their sleeves, m from its joint."""
    length, least = lines[root.body][1].length, root.make.root_length
    reach = np.arange(least, length, _STEP)
    for at in reach:
        points = (
            root.at(float(at))
            + _STEP * np.arange(0, 2 + int(_DEEP * root.make.root_diameter / _STEP))[:, None] * root.along
        )
        distances = [_distance(points, other, lines[other.body][1].length) for other in others]
        if min(distances, default=np.inf) >= root.sleeve + root.make.clearance:
            return float(at)
    return float(least)


def _distance(points: Array, other: Root, length: float) -> float:
    """Return the smallest distance of points to the line of another bar, from its joint to its end, m."""
    offsets = points - other.place
    along = np.clip(offsets @ other.along, 0.0, length)
    return float(np.linalg.norm(offsets - along[:, None] * other.along, axis=1).min())
