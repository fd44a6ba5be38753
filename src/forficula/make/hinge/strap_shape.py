"""Straps as solids: as made, taut between their pegs, and bowed if they are slack."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array
from forficula.make.hinge.elastica import elastica
from forficula.make.hinge.joint import turned
from forficula.make.hinge.joint_layout import Arm, JointLayout
from forficula.make.hinge.straps import Strap
from forficula.make.solid.solids import Cut, Joined, Prism, Rod, Solid, band, box

# m, distance of a strap's ends perpendicular to the hinge below which they define no direction
_NOWHERE = 1e-9
# number of corners of a bow
_CORNERS = 49
# straps are moved aside at most this number of times, each time by the missing distance and this step, m; checked
# angles
_TRIES, _STEP, _ANGLES = 40, 1e-4, 31


@dataclass(frozen=True, kw_only=True, eq=False)
class StrapPlace:
    """Ends of a tendon's straps in the built structure, in the axes of the ground.

    Attributes:
        tendon: index of the tendon.
        strap: strap that forms the tendon.
        bodies: bodies of the two pegs, proximal first.
        ends: centres of a strap's eyes on the pegs, m, (strap, 2, 3).
        across: unit vectors along the two pegs, (2, 3).
        up: unit vector to the side of the overbend, (3,).
        peg_diameter: m.
    """

    tendon: int
    strap: Strap
    bodies: tuple[int, int]
    ends: Array
    across: Array
    up: Array
    peg_diameter: float

    @property
    def eye_diameter(self) -> float:
        """Outer diameter of a strap's eyes, whose walls are as thick as the strap, m."""
        return self.peg_diameter + 2 * self.strap.thickness


def strap_places(joints: Sequence[JointLayout]) -> tuple[StrapPlace, ...]:
    """Return the ends of the straps of all tendons from the pegs of joints; a tendon may cross several joints."""
    pegs: dict[int, list[tuple[JointLayout, Arm]]] = {}
    for joint in joints:
        if joint.tendon is not None:
            pegs.setdefault(joint.tendon, []).extend((joint, arm) for arm in (joint.proximal, joint.distal) if arm.peg)
    places = []
    for tendon, ((first, inner), (last, outer)) in pegs.items():
        if first.strap is None:
            continue
        across = np.array([first.across(inner), last.across(outer)])
        middles = np.array([first.peg_of(inner), last.peg_of(outer)])
        sides = (1, -1) if first.strap.count == 2 else (0,)
        places.append(
            StrapPlace(
                tendon=tendon,
                strap=first.strap,
                bodies=(inner.body, outer.body),
                ends=np.array([middles + side * first.aside * across for side in sides]),
                across=across,
                up=first.frame[:, 2],
                peg_diameter=first.make.peg_diameter,
            )
        )
    return tuple(places)


def bows_beside(joints: tuple[JointLayout, ...]) -> tuple[JointLayout, ...]:
    """Move pairs of straps aside until their bows clear both bars of a joint at all angles.

    The bars of an oblique hinge cross each other when folded, so straps that are beside one bar in the flat state may
    then be over the other. Tendons across several joints are not moved.
    """
    tendons = [joint.tendon for joint in joints]
    return tuple(
        _beside(joint)
        if joint.strap is not None and joint.strap.count == 2 and tendons.count(joint.tendon) == 1
        else joint
        for joint in joints
    )


def _beside(joint: JointLayout) -> JointLayout:
    """Return a joint whose straps are moved aside until their bows clear its bars."""
    for _ in range(_TRIES):
        (place,) = strap_places([joint])
        missing = joint.bar_diameter / 2 + place.strap.width / 2 + joint.make.clearance - _nearest(joint, place)
        if missing <= 0:
            return joint
        joint = replace(joint, aside=joint.aside + missing + _STEP)
    return joint


def _nearest(joint: JointLayout, place: StrapPlace) -> float:
    """Return the smallest distance of slack straps' middles to the axes of the bars, m."""
    rise, nearest = joint.standoff * joint.frame[:, 2], math.inf
    for angle in np.linspace(joint.lower, joint.upper, _ANGLES):
        pose = turned(joint, float(angle))
        bars = [(joint.origin + rise, joint.proximal), (pose.of(joint.origin + rise), joint.distal)]
        for start, end in place.ends:
            far_end = pose.of(end)
            if np.linalg.norm(far_end - start) >= place.strap.rest_length:
                continue
            for side in (1, -1):
                line = strap_line(place, start, far_end, joint.frame[:, 1], side)
                for (origin, arm), turn in zip(bars, (np.eye(3), pose.rotation), strict=True):
                    offsets, direction = line - origin, turn @ arm.along
                    along = np.clip(offsets @ direction, 0.0, arm.length)
                    nearest = min(nearest, float(np.linalg.norm(offsets - along[:, None] * direction, axis=1).min()))
    return nearest


def made_strap(place: StrapPlace) -> Solid:
    """Return a straight strap at its resting length, from its proximal peg towards the other, with its eyes."""
    start, end = place.ends[0]
    along = (end - start) / np.linalg.norm(end - start)
    return _with_eyes(place, np.array([start, start + place.strap.rest_length * along]), place.up)


def strap_line(place: StrapPlace, start: Array, end: Array, axis: Array, side: int) -> Array:
    """Return the middle of a strap between two points, m, (corner, 3): straight if taut, else bowed to a side.

    It bends about its width, which stays parallel to the hinge. Its displacement along the hinge is linear.

    Args:
        place: position of the tendon's straps.
        start: position of its proximal eye, m, (3,).
        end: position of the other eye, m, (3,).
        axis: unit vector along the hinge, (3,).
        side: +1 or -1, the side to which it bows.
    """
    along = float((end - start) @ axis)
    chord = end - start - along * axis
    apart, length = float(np.linalg.norm(chord)), place.strap.rest_length
    ahead = chord / apart if apart > _NOWHERE else np.cross(axis, place.up)
    bowed = math.sqrt(length**2 - along**2) if length > math.hypot(apart, along) else apart
    flat = elastica(max(bowed, _NOWHERE), apart, _CORNERS)
    shares = np.linspace(0.0, along, _CORNERS)
    line: Array = start + flat @ np.array([ahead, side * np.cross(axis, ahead)]) + shares[:, None] * axis
    return line


def strap_along(place: StrapPlace, line: Array, axis: Array) -> Solid:
    """Return a strap without its eyes along its middle, (corner, 3), as a chain of blocks of its width.

    A taut strap keeps its width and thickness, so it is slightly too thick.
    """
    moves = np.diff(line, axis=0)
    along = [float(move @ axis) for move in moves]
    steps = [move - shift * axis for move, shift in zip(moves, along, strict=True)]
    lengths = [float(np.linalg.norm(step)) for step in steps]
    ahead = np.array(steps) / np.array(lengths)[:, None]
    # one call for all blocks, because a call for three numbers takes as long
    frames = np.stack([ahead, np.cross(axis, ahead), np.broadcast_to(axis, ahead.shape)], axis=2)
    half, blocks = place.strap.thickness / 2, []
    for shift, length, frame, middle in zip(along, lengths, frames, (line[:-1] + line[1:]) / 2, strict=True):
        wide = (place.strap.width + abs(shift)) / 2
        # slightly longer, to fill the corners of a bend
        reach = length / 2 + half / 4
        blocks.append(box((-reach, -half, -wide), (reach, half, wide), middle, frame))
    return Joined(solids=tuple(blocks))


def _with_eyes(place: StrapPlace, ends: Array, up: Array) -> Solid:
    """Return a straight strap between the centres of two eyes."""
    along = (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0])
    across = np.cross(up, along) / np.linalg.norm(np.cross(up, along))
    half = place.strap.width / 2 * across

    def disc(middle: Array, diameter: float, longer: float) -> Rod:
        return Rod(start=middle - longer * half, end=middle + longer * half, diameter=diameter)

    length = float(np.linalg.norm(ends[1] - ends[0]))
    middle = Prism(
        outline=band(np.array([[0.0, 0.0], [length, 0.0]]), place.strap.thickness),
        origin=ends[0],
        frame=np.column_stack([along, np.cross(across, along), across]),
        height=place.strap.width,
    )
    eyes = [disc(end, place.eye_diameter, 1.0) for end in ends]
    holes = tuple(disc(end, place.peg_diameter, 2.0) for end in ends)
    return Cut(solid=Joined(solids=(middle, *eyes)), taken=holes)
