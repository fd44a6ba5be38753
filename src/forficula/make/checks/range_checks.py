"""Checks of joints over their range: overlap, gaps, stop angles, and collisions of straps."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from manifold3d import Manifold, OpType

from forficula.arrays import Array
from forficula.make.checks.check import Check, least_check
from forficula.make.hinge.free_range import range_between
from forficula.make.hinge.joint import bar_solid, turned
from forficula.make.hinge.joint_layout import JointLayout
from forficula.make.hinge.strap_shape import StrapPlace, strap_along, strap_line
from forficula.make.part import PartSet
from forficula.make.solid.mesh import MILLIMETRES, placed, solid_of
from forficula.pattern.rotation import IDENTITY_MOTION, RigidMotion
from forficula.quantities import show_value

# mm^3: overlap of touching round parts, because circles are polygons
_TOUCH = 1e-2
_ANGLES, _GAPS, _STRAPS = 61, 13, 25
# rad, allowed deviation of stops from the design
_STOP_AGREES = math.radians(0.01)
# m, error of gaps, because round holes and rods are polygons
_GAP_AGREES = 5e-6


def range_checks(parts: PartSet) -> Iterator[Check]:
    """Check every joint of a set of parts through its range."""
    yield from lug_checks(parts)
    yield from pin_checks(parts)
    for joint in parts.joints:
        halves = [_body_shape(parts, arm.body) for arm in (joint.proximal, joint.distal)]
        yield from _pegs_on_bars(parts, joint)
        yield _overlap(joint, *halves)
        yield _gap(joint, *halves)
        yield from _stops(parts, joint)
    yield from strap_checks(parts)


def stop_angles(parts: PartSet, joint: JointLayout) -> tuple[float, float]:
    """Return the angles at which the stop faces of a joint meet, rad, without pegs; see `range_between`."""
    return range_between(joint, *(_bare_shape(parts, arm.body) for arm in (joint.proximal, joint.distal)))


def lug_checks(parts: PartSet) -> Iterator[Check]:
    """Check that every bar is longer than the lugs of the hinges at its ends, which would overlap otherwise."""
    arms = [(joint, arm) for joint in parts.joints for arm in (joint.proximal, joint.distal)]
    for body in sorted({arm.body for _, arm in arms}):
        lugs = [(joint.lug, arm.length) for joint, arm in arms if arm.body == body]
        least, length = sum(lug for lug, _ in lugs), lugs[0][1]
        yield least_check(
            "bar beyond its lugs",
            parts.structure.bodies[body].name,
            measured=length,
            least=least,
            text=f"the lugs of its hinges occupy {1e3 * least:.1f} mm of its {1e3 * length:.1f} mm",
            mend=": make it longer, or the hinge slimmer (make.hinge_wall, make.pin_diameter)",
        )


def pin_checks(parts: PartSet) -> Iterator[Check]:
    """Check that every pin turns in the distal half of its joint with its play all around; the other half holds it."""
    named = {part.name: part for part in parts.parts if part.kind == "pin"}
    for joint in parts.joints:
        pin = named.get(f"pin_{joint.name}")
        if pin is None:
            continue
        gap = pin.shape.min_gap(_body_shape(parts, joint.distal.body), 2 * joint.play * MILLIMETRES) / MILLIMETRES
        ok = gap >= joint.play - _GAP_AGREES
        yield Check(
            name="pin turns in its hole",
            part=joint.name,
            ok=ok,
            value=gap,
            limit=joint.play,
            unit="m",
            text=f"the gap between the pin and the half that turns on it is {show_value(gap, 'm')}"
            + ("" if ok else "; choose a thinner pin, or a larger make.pin_diameter"),
        )


def _pegs_on_bars(parts: PartSet, joint: JointLayout) -> Iterator[Check]:
    """Check that pegs are on their bars: beyond the lug of the hinge, and not beyond the end."""
    radius = joint.make.peg_diameter / 2
    for arm in (joint.proximal, joint.distal):
        if not arm.peg or joint.strap is None:
            continue
        room = min(arm.peg - radius - joint.lug, arm.length - arm.peg - radius)
        yield Check(
            name="peg on its bar",
            part=parts.structure.bodies[arm.body].name,
            ok=room >= 0,
            value=arm.peg,
            limit=joint.lug + radius if arm.peg < arm.length / 2 else arm.length - radius,
            unit="m",
            text=f"the bar has space for a peg from {1e3 * (joint.lug + radius):.1f} mm, where the hinge's lug ends, to"
            f" {1e3 * (arm.length - radius):.1f} mm from the hinge; the peg is at {1e3 * arm.peg:.1f} mm"
            + ("" if room >= 0 else ": change the tendon's attachment, make the bar longer, or the peg thinner"),
        )


def _between(angles: Sequence[float]) -> str:
    """Return a text with a range of angles, rad."""
    low, high = (f"{math.degrees(angle):.0f}" for angle in (min(angles), max(angles)))
    return f"at {low} deg" if low == high else f"from {low} to {high} deg"


def _overlap(joint: JointLayout, proximal: Manifold, distal: Manifold) -> Check:
    """Check that the two halves with their pegs never overlap."""
    angles = np.linspace(joint.lower, joint.upper, _ANGLES)
    volumes = [(proximal ^ placed(distal, *turned(joint, angle))).volume() for angle in angles]
    worst = int(np.argmax(volumes))
    ok = volumes[worst] <= _TOUCH
    text = f"the two halves do not overlap at {_ANGLES} angles"
    if not ok:
        where = [float(angle) for angle, volume in zip(angles, volumes, strict=True) if volume > _TOUCH]
        text = f"the two halves overlap {_between(where)}: {_apart(joint)}"
    return Check(
        name="overlap over the range",
        part=joint.name,
        ok=ok,
        value=volumes[worst] / MILLIMETRES**3,
        limit=_TOUCH / MILLIMETRES**3,
        unit="m^3",
        text=text,
    )


def _apart(joint: JointLayout) -> str:
    """Return advice that avoids an overlap of two halves."""
    arms, radius = (joint.proximal, joint.distal), joint.make.peg_diameter / 2
    if any(arm.length < joint.lug or 0 < arm.peg < joint.lug + radius for arm in arms):
        return f"a bar or its peg ends within the hinge's lug, {1e3 * joint.lug:.1f} mm from the hinge: make it longer"
    return "move the pegs apart, by unequal attachments of the tendon, larger offsets or a smaller make.peg_diameter"


def _gap(joint: JointLayout, proximal: Manifold, distal: Manifold) -> Check:
    """Check the smallest gap between the halves, at angles at which their stop faces are a clearance apart or more."""
    clearance = joint.make.clearance
    apart = clearance / (joint.knuckle_diameter / 2 + clearance)
    angles = np.linspace(joint.lower + apart, joint.upper - apart, _GAPS)
    search = 2 * clearance * MILLIMETRES
    gaps = [proximal.min_gap(placed(distal, *turned(joint, angle)), search) / MILLIMETRES for angle in angles]
    least = int(np.argmin(gaps))
    ok = gaps[least] >= clearance - _GAP_AGREES
    return Check(
        name="least gap",
        part=joint.name,
        ok=ok,
        value=gaps[least],
        limit=clearance,
        unit="m",
        text=f"the gap between the two halves is smallest at {math.degrees(angles[least]):.0f} deg, away from the stops"
        + ("" if ok else f"; it must be at least make.clearance: {_apart(joint)}"),
    )


def _stops(parts: PartSet, joint: JointLayout) -> Iterator[Check]:
    """Check that the solids meet at the stop angles of the design."""
    for name, measured, nominal in zip(
        ("fold stop", "overbend stop"), stop_angles(parts, joint), (joint.lower, joint.upper), strict=True
    ):
        yield Check(
            name=name,
            part=joint.name,
            ok=abs(measured - nominal) <= _STOP_AGREES,
            value=measured,
            limit=nominal,
            unit="rad",
            text=f"the stop faces meet at {math.degrees(measured):.4f} deg;"
            f" the design has {math.degrees(nominal):g} deg",
        )


def strap_checks(parts: PartSet) -> Iterator[Check]:
    """Check that the straps of every tendon collide with nothing at all angles, taut and slack to either side."""
    for place in parts.straps:
        joints = [joint for joint in parts.joints if joint.tendon == place.tendon]
        bodies = dict.fromkeys(arm.body for joint in joints for arm in (joint.proximal, joint.distal))
        shapes = [_bare_shape(parts, body) for body in bodies]
        name = parts.structure.tendons[place.tendon].name
        yield _strap_check(place, _swept(place, joints, shapes, taut=True), name, "taut")
        yield _strap_check(place, _swept(place, joints, shapes, taut=False), name, "slack")


@dataclass(frozen=True, kw_only=True)
class _Swept:
    """A strap at one angle: the joints' angles, summed, rad; its overlap with bars, mm^3; its bow, m."""

    angle: float
    volume: float
    bow: float


def _swept(place: StrapPlace, joints: Sequence[JointLayout], shapes: Sequence[Manifold], *, taut: bool) -> list[_Swept]:
    """Return the straps of a tendon at all angles at which they are taut, or slack."""
    swept, axis = [], joints[0].frame[:, 1]
    for share in np.linspace(0.0, 1.0, _STRAPS):
        angles = [joint.lower + share * (joint.upper - joint.lower) for joint in joints]
        poses = _chain(joints, angles)
        posed = [placed(shape, *pose) for shape, pose in zip(shapes, poses, strict=True)]
        for start, end in place.ends:
            near_end, far_end = (pose.of(at) for at, pose in ((start, poses[0]), (end, poses[-1])))
            if (float(np.linalg.norm(far_end - near_end)) >= place.strap.rest_length) != taut:
                continue
            for side in (1,) if taut else (1, -1):
                line = strap_line(place, near_end, far_end, axis, side)
                strap = solid_of(strap_along(place, line, axis))
                volume = sum((strap ^ body).volume() for body in posed)
                swept.append(_Swept(angle=sum(angles), volume=volume, bow=_bows(line)))
    return swept


def _strap_check(place: StrapPlace, swept: Sequence[_Swept], name: str, state: str) -> Check:
    """Check the straps of a tendon at angles at which they are taut, or slack."""
    collisions = [strap.angle for strap in swept if strap.volume > _TOUCH]
    if not swept:
        text = f"the straps are never {state} within the range"
        text += ": they have no effect, so make tendon.rest_length shorter" if state == "taut" else ""
    elif collisions:
        text = f"{state}, a strap would pass through the joint {_between(collisions)}; "
        text += (
            "two straps beside the bars (make.straps = 2) avoid this"
            if place.strap.count == 1
            else "a narrower hinge (make.hinge_width) or bars nearer to perpendicular to it avoid this"
        )
    else:
        highest = max(strap.bow for strap in swept)
        text = f"{state}, the straps collide with nothing, at {len(swept)} positions"
        text += "" if state == "taut" else f"; they bow up to {1e3 * highest:.0f} mm away from the line between pegs"
    return Check(
        name=f"straps {state}",
        part=name,
        # straps that are never taut are useless; straps that are never slack need no check of the slack state
        ok=not collisions if swept else (False if state == "taut" else None),
        value=max((strap.volume for strap in swept), default=0.0) / MILLIMETRES**3,
        limit=_TOUCH / MILLIMETRES**3,
        unit="m^3",
        text=text,
    )


def _chain(joints: Sequence[JointLayout], angles: Sequence[float]) -> list[RigidMotion]:
    """Return the positions of the bodies of a chain of joints. The first proximal body is fixed."""
    poses = [IDENTITY_MOTION]
    for joint, angle in zip(joints, angles, strict=True):
        poses.append(poses[-1].after(turned(joint, angle)))
    return poses


def _bows(line: Array) -> float:
    """Return the largest distance of a line from the straight line between its ends, m."""
    offsets, direction = line - line[0], (line[-1] - line[0]) / np.linalg.norm(line[-1] - line[0])
    return float(np.linalg.norm(offsets - (offsets @ direction)[:, None] * direction, axis=1).max())


def _body_shape(parts: PartSet, body: int) -> Manifold:
    """Return the shape of all parts that move with a body except pins, which turn in their holes, mm."""
    return Manifold.batch_boolean([part.shape for part in parts.of_body(body) if part.kind != "pin"], OpType.Add)


def _bare_shape(parts: PartSet, body: int) -> Manifold:
    """Return a bar without its pegs, mm."""
    arms = [
        (replace(joint, strap=None), getattr(replace(joint, strap=None), side))
        for joint in parts.joints
        for side in ("proximal", "distal")
        if getattr(joint, side).body == body
    ]
    return solid_of(bar_solid(arms))
