"""How a tendon lies across one hinge: arms and offsets, of bars that are given or of any two points."""

from __future__ import annotations

import math

import numpy as np

from forficula.arrays import Array
from forficula.structure.mass import inertia_about
from forficula.structure.parts import Crossing
from forficula.structure.structure import Structure
from forficula.structure.tree import ancestry, built_frames, built_points, hinges_between

# share of the tendon's length; an end that is nearer to the axis is on it
_ON_AXIS = 1e-9


def bar_crossing(
    *,
    hinge: int,
    axis: Array,
    bars: tuple[Array, Array],
    attachments: tuple[float, float],
    offsets: tuple[float, float] = (0.0, 0.0),
    asides: tuple[float, float] = (0.0, 0.0),
    inertia: float,
) -> Crossing:
    """The crossing of a tendon from one bar to another, both in the level plane of the hinge's axis as built.

    Bars at angles alpha and beta to the axis, with the ends at distances p and d along them, have a = p sin alpha,
    b = d sin beta and c = p cos alpha + d cos beta. Offsets h out of the plane make the arms hypot(a, h) and
    hypot(b, h'), and delta = atan(h / a) + atan(h' / b).

    Args:
        hinge: its number.
        axis: unit vector along the hinge, either way, (3,).
        bars: unit vectors outwards along the proximal and the distal bar, (3,) each; no farther than a right angle from
            each other beside the axis.
        attachments: distances of the ends from the hinge along the bars, m.
        offsets: of the ends out of the plane, towards the side to which positive angles turn the distal bar, m.
        asides: of the ends within the plane, counterclockwise of their bars seen from above, m.
        inertia: of what turns about the axis, with the hinge's armature, kg m^2.
    """
    proximal, distal = bars
    arms = [attachment * sine_between(bar, axis) for attachment, bar in zip(attachments, bars, strict=True)]
    offset = attachments[0] * float(proximal @ axis) + attachments[1] * float(distal @ axis)
    if any(asides):
        upwards = np.array([0.0, 0.0, 1.0])
        # in the plane, square to the axis, to the side of the distal bar
        outwards = np.cross(upwards, axis)
        outwards = outwards * math.copysign(1.0, outwards @ distal)
        for end, sign in ((0, -1.0), (1, 1.0)):
            across = np.cross(upwards, bars[end])
            arms[end] += sign * asides[end] * float(across @ outwards)
            offset += sign * asides[end] * float(across @ axis)
    return Crossing(
        hinge=hinge,
        proximal_arm=math.hypot(arms[0], offsets[0]),
        distal_arm=math.hypot(arms[1], offsets[1]),
        axial_offset=offset,
        offset_angle=math.atan2(offsets[0], arms[0]) + math.atan2(offsets[1], arms[1]),
        inertia=inertia,
    )


def sine_between(one: Array, other: Array) -> float:
    """Compute the sine between two unit vectors, (3,): plain numbers take a third of the time of arrays."""
    (x, y, z), (u, v, w) = one.tolist(), other.tolist()
    return float(np.linalg.norm(np.array([y * w - z * v, z * u - x * w, x * v - y * u])))


def tendon_crossing(structure: Structure, points: tuple[int, int]) -> Crossing | None:
    """The crossing of a tendon between any two points, from where they and the hinge are in the built shape.

    Args:
        structure: with its bodies, points and hinges; tendons are not looked at.
        points: numbers of the tendon's ends.

    Returns:
        None where the length depends on several hinges, or on none.
    """
    bodies = [structure.points[point].body for point in points]
    between = hinges_between(structure, bodies[0], bodies[1])
    if len(between) != 1:
        return None
    hinge = structure.hinges[between[0]]
    origins, frames = built_frames(structure)
    axis = hinge.sense * (frames[hinge.body] @ hinge.axis)
    ends = built_points(structure)[list(points)] - origins[hinge.body]
    if hinge.body in ancestry(structure, bodies[0]):
        ends = ends[::-1]
    heights = ends @ axis
    arms = ends - heights[:, None] * axis
    radii = np.linalg.norm(arms, axis=1)
    if radii.min() <= _ON_AXIS * float(np.linalg.norm(ends[1] - ends[0])):
        return None
    # from where the proximal arm points away from to where the distal one is
    opposite = -arms[0]
    return Crossing(
        hinge=between[0],
        proximal_arm=float(radii[0]),
        distal_arm=float(radii[1]),
        axial_offset=float(heights[1] - heights[0]),
        offset_angle=math.atan2(float(np.cross(opposite, arms[1]) @ axis), float(opposite @ arms[1])) - hinge.built,
        inertia=inertia_about(structure, between[0]),
    )
