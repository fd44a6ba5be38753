"""Geometry of a tendon across a single hinge: arms and offsets, between two bars or any two points."""

from __future__ import annotations

import math

import numpy as np

from forficula.arrays import Array
from forficula.structure.mass import inertia_about
from forficula.structure.parts import Crossing
from forficula.structure.structure import Structure
from forficula.structure.tree import ancestry, built_frames, built_points, hinges_between

# largest distance of an end from the axis that counts as 0, as a share of the tendon's length
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
    """Compute the crossing of a tendon from one bar to another; bars and hinge axis lie in the x-y plane as built.

    For bars at angles alpha and beta to the axis, with the ends at distances p and d along them, a = p sin alpha,
    b = d sin beta and c = p cos alpha + d cos beta. With offsets h and h' out of the plane the arms are hypot(a, h) and
    hypot(b, h'), and delta = atan(h / a) + atan(h' / b).

    Args:
        hinge: number of the hinge.
        axis: unit vector along the hinge, in either direction, (3,).
        bars: unit vectors outwards along the proximal and the distal bar, (3,) each; the angle between their components
            normal to the axis is at most a right angle.
        attachments: distances of the ends from the hinge along the bars, m.
        offsets: distances of the ends from the plane, towards the side to which positive angles turn the distal bar, m.
        asides: distances of the ends from their bars in the plane, counterclockwise seen from above, m.
        inertia: inertia of everything that turns about the axis, with the hinge's armature, kg m^2.
    """
    proximal, distal = bars
    arms = [attachment * sine_between(bar, axis) for attachment, bar in zip(attachments, bars, strict=True)]
    offset = attachments[0] * float(proximal @ axis) + attachments[1] * float(distal @ axis)
    if any(asides):
        upwards = np.array([0.0, 0.0, 1.0])
        # in the plane, normal to the axis, towards the distal bar
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
    """Compute the sine between two unit vectors, (3,); plain numbers take a third of the time of arrays."""
    (x, y, z), (u, v, w) = one.tolist(), other.tolist()
    return float(np.linalg.norm(np.array([y * w - z * v, z * u - x * w, x * v - y * u])))


def tendon_crossing(structure: Structure, points: tuple[int, int]) -> Crossing | None:
    """Compute the crossing of a tendon between any two points from their positions in the built shape.

    Args:
        structure: structure with bodies, points and hinges; its tendons are ignored.
        points: numbers of the tendon's ends.

    Returns:
        The crossing; None if the length depends on several hinges, or on none.
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
    # the offset angle is that from the opposite of the proximal arm to the distal arm
    opposite = -arms[0]
    return Crossing(
        hinge=between[0],
        proximal_arm=float(radii[0]),
        distal_arm=float(radii[1]),
        axial_offset=float(heights[1] - heights[0]),
        offset_angle=math.atan2(float(np.cross(opposite, arms[1]) @ axis), float(opposite @ arms[1])) - hinge.built,
        inertia=inertia_about(structure, between[0]),
    )
