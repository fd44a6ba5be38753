"""The two halves of a joint as solids, its pin, and the rotation of one half against the other.

Each half, except its knuckles and its peg, is confined to a wedge about the hinge's axis: the distal one from the plane
of the sheet up to half the overbend short of upright, the proximal one likewise on its side. Therefore the two meet
only at a stop, with flat faces through the axis.
"""

from __future__ import annotations

import math

import numpy as np

from forficula.arrays import Array
from forficula.make.hinge.joint_layout import Arm, JointLayout
from forficula.make.solid.solids import Cut, Joined, Prism, Rod, Shared, Solid, box, joined
from forficula.pattern.rotation import RigidMotion, turn_about

# diameter of the head of a peg, which retains the straps / diameter of the peg
PEG_HEAD = 1.3
# m, difference in height below which a peg counts as at the height of its bar
_LEVEL = 1e-6
# m, length by which subtracted solids extend beyond the surface
_BEYOND = 1e-3


def bar_solid(arms: list[tuple[JointLayout, Arm]]) -> Solid:
    """Return the bar of a body with its half of each of its joints, according to their layouts."""
    layout, arm = arms[0]
    at = [joint.origin for joint, _ in arms]
    far = at[0] + arm.along * arm.length if len(arms) == 1 else at[1]
    rise = layout.standoff * layout.frame[:, 2]
    # extended into the lugs at its ends, which the wedges then cut
    ends = [at[0] - layout.lug * arm.along, far + (layout.lug * arm.along if len(arms) > 1 else 0.0)]
    solid: Solid = Rod(start=ends[0] + rise, end=ends[1] + rise, diameter=layout.bar_diameter)
    solid = Joined(solids=(solid, *(_lug(joint) for joint, _ in arms)))
    solid = Shared(solids=(solid, *(_wedge(joint, bar_arm) for joint, bar_arm in arms)))
    solid = Cut(
        solid=solid,
        taken=(above_bed(layout), *(solid_part for joint, bar_arm in arms for solid_part in _room(joint, bar_arm))),
    )
    solid = Joined(solids=(solid, *(solid_part for joint, bar_arm in arms for solid_part in _knuckles(joint, bar_arm))))
    # an axle is part of the proximal knuckles: with a hole of its own diameter it would only touch them
    holes = [_hole(joint, bar_arm) for joint, bar_arm in arms if bar_arm is joint.distal or joint.make.hinge == "pin"]
    solid = Cut(solid=solid, taken=tuple(holes)) if holes else solid
    axles = [pin_solid(joint) for joint, bar_arm in arms if bar_arm is joint.proximal and joint.make.hinge != "pin"]
    pegs = [
        solid_part
        for joint, bar_arm in arms
        if bar_arm.peg and joint.strap
        for solid_part in peg_solids(joint, bar_arm)
    ]
    return joined(solid, *axles, *pegs)


def pin_solid(layout: JointLayout) -> Rod:
    """Return the pin, or the axle, with the width of the hinge."""
    half = layout.width / 2 * layout.frame[:, 1]
    return Rod(start=layout.origin - half, end=layout.origin + half, diameter=layout.make.pin_diameter)


def peg_solids(layout: JointLayout, arm: Arm) -> list[Solid]:
    """Return the peg across a bar, with heads that retain the straps, and its foot if it is off the bar."""
    strap, make = layout.strap, layout.make
    if strap is None:
        return []
    across, middle, radius = layout.across(arm), layout.peg_of(arm), make.peg_diameter / 2
    inner = layout.aside + strap.width / 2 + make.clearance / 2
    outer = inner + make.hinge_wall
    solids: list[Solid] = [Rod(start=middle - outer * across, end=middle + outer * across, diameter=2 * radius)]
    solids += [
        Rod(start=middle + side * inner * across, end=middle + side * outer * across, diameter=PEG_HEAD * 2 * radius)
        for side in (-1, 1)
    ]
    off = arm.height - layout.standoff
    if is_level(layout, arm):
        # the peg lies on the bed with its bar; in the folded state, the other half's pegs are as near on the other side
        level = (above_bed(layout), _below(layout, make.clearance / 2))
        return [Cut(solid=Joined(solids=tuple(solids)), taken=level)]
    low, high = (arm.height - radius, layout.standoff) if off < 0 else (layout.standoff, arm.height + radius)
    frame = np.column_stack([arm.along, np.cross(layout.frame[:, 2], arm.along), layout.frame[:, 2]])
    half = layout.bar_diameter / 2
    solids.append(box((arm.peg - radius, -half, low), (arm.peg + radius, half, high), layout.origin, frame))
    return solids


def is_level(layout: JointLayout, arm: Arm) -> bool:
    """Return whether a peg is at the height of its bar, so that it has the same flat."""
    return abs(arm.height - layout.standoff) < _LEVEL


def peg_flats(layout: JointLayout) -> tuple[float, float]:
    """Return the heights of the flats of a peg at the height of its bar, below and above its middle, m."""
    return layout.make.clearance / 2 - layout.standoff, layout.top - layout.standoff


def turned(layout: JointLayout, angle: float) -> RigidMotion:
    """Return the motion of the distal half from its built position to an angle of the hinge in its own sense, rad."""
    return turn_about(layout.origin, -layout.frame[:, 1], angle)


def _wedge(layout: JointLayout, arm: Arm) -> Solid:
    """Return the space of a half without knuckles and pegs: the angles about the hinge between its two stop faces."""
    low, high = -(math.pi + layout.lower) / 2, (math.pi - layout.upper) / 2
    far = 4 * (layout.proximal.length + layout.distal.length)
    angles = np.linspace(low, high, 4)
    corners = np.vstack([[0.0, 0.0], far * np.column_stack([np.cos(angles), np.sin(angles)])])
    if arm is layout.proximal:
        corners = (corners * [-1, 1])[::-1]
    return Prism(outline=corners, origin=layout.origin, frame=_upright(layout), height=2 * far)


def _upright(layout: JointLayout) -> Array:
    """Return axes perpendicular to the hinge: x and z of the joint, and their normal, (3, 3)."""
    return np.column_stack([layout.frame[:, 0], layout.frame[:, 2], -layout.frame[:, 1]])


def _lug(layout: JointLayout) -> Solid:
    """Return the block over the whole hinge with knuckles and stop faces; each half takes its wedge of it."""
    low = 0.0 if layout.lower <= -math.pi else -layout.knuckle_diameter / 2
    corner = (layout.lug, layout.width / 2, layout.top)
    return box((-corner[0], -corner[1], low), corner, layout.origin, layout.frame)


def above_bed(layout: JointLayout) -> Solid:
    """Return the space above the flat that lies on the printer's bed."""
    far = 4 * (layout.proximal.length + layout.distal.length)
    return box((-far, -far, layout.top), (far, far, layout.top + far), layout.origin, layout.frame)


def _below(layout: JointLayout, height: float) -> Solid:
    """Return the space below a height over the hinge, m."""
    far = 4 * (layout.proximal.length + layout.distal.length)
    return box((-far, -far, height - far), (far, far, height), layout.origin, layout.frame)


def _room(layout: JointLayout, arm: Arm) -> list[Solid]:
    """Return the space for the other half's knuckles, with the clearance around them."""
    inner, outer = layout.side_widths
    diameter = layout.knuckle_diameter + 2 * layout.make.clearance
    beyond = layout.width / 2 + layout.make.clearance + _BEYOND
    spans = [(-outer, outer)] if arm is layout.proximal else [(-beyond, -inner), (inner, beyond)]
    return [_along_hinge(layout, span, diameter) for span in spans]


def _knuckles(layout: JointLayout, arm: Arm) -> list[Solid]:
    """Return the knuckles of a half, without their hole: two outer ones (proximal), or the middle one (distal)."""
    inner, outer = layout.side_widths
    end = layout.width / 2
    spans = [(-end, -outer), (outer, end)] if arm is layout.proximal else [(-inner, inner)]
    return [_along_hinge(layout, span, layout.knuckle_diameter) for span in spans]


def _hole(layout: JointLayout, arm: Arm) -> Solid:
    """Return the hole for the pin, which turns in the distal half and is held in the proximal one."""
    play = 0.0 if arm is layout.proximal else 2 * layout.play
    end = layout.width / 2 + _BEYOND
    return _along_hinge(layout, (-end, end), layout.make.pin_diameter + play)


def _along_hinge(layout: JointLayout, span: tuple[float, float], diameter: float) -> Rod:
    """Return a rod about the hinge's axis."""
    start, end = (layout.origin + at * layout.frame[:, 1] for at in span)
    return Rod(start=start, end=end, diameter=diameter)
