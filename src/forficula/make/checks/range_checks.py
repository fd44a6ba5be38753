"""What is checked of joints over their range: overlap, gaps, where stops are, and that straps pass everything."""

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
from forficula.pattern.rotation import STILL, RigidMotion
from forficula.quantities import show_value

# of parts that would be drawn to touch where they are round, mm^3: a polygon has corners
_TOUCH = 1e-2
_ANGLES, _GAPS, _STRAPS = 61, 13, 25
# rad, to which stops must be where the design has them
_STOP_AGREES = math.radians(0.01)
# of round holes and rods that are polygons, m
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
    """Where the stop faces of a joint meet, by its halves without pegs, rad, as `range_between` finds them."""
    return range_between(joint, *(_bare_shape(parts, arm.body) for arm in (joint.proximal, joint.distal)))


def lug_checks(parts: PartSet) -> Iterator[Check]:
    """Whether every bar is longer than the lugs of the hinges at its ends, which would stand in one another."""
    arms = [(joint, arm) for joint in parts.joints for arm in (joint.proximal, joint.distal)]
    for body in sorted({arm.body for _, arm in arms}):
        own = [(joint.lug, arm.length) for joint, arm in arms if arm.body == body]
        least, length = sum(lug for lug, _ in own), own[0][1]
        yield least_check(
            "bar beyond its lugs",
            parts.structure.bodies[body].name,
            found=length,
            least=least,
            text=f"the lugs of its hinges take {1e3 * least:.1f} mm of its {1e3 * length:.1f} mm",
            mend=": make it longer, or the hinge slimmer (make.hinge_wall, make.pin_diameter)",
        )


def pin_checks(parts: PartSet) -> Iterator[Check]:
    """Whether every pin turns in the distal half of its joint, with its play all around; the other half holds it."""
    named = {part.name: part for part in parts.parts if part.kind == "pin"}
    for joint in parts.joints:
        pin = named.get(f"pin_{joint.name}")
        if pin is None:
            continue
        gap = pin.shape.min_gap(_body_shape(parts, joint.distal.body), 2 * joint.play * MILLIMETRES) / MILLIMETRES
        held = gap >= joint.play - _GAP_AGREES
        yield Check(
            name="pin turns in its hole",
            part=joint.name,
            ok=held,
            value=gap,
            limit=joint.play,
            unit="m",
            text=f"between it and the half that turns on it there is {show_value(gap, 'm')} of room"
            + ("" if held else "; take a thinner one, or a larger make.pin_diameter"),
        )


def _pegs_on_bars(parts: PartSet, joint: JointLayout) -> Iterator[Check]:
    """Whether pegs are on their bars: beyond the lug of the hinge, and not beyond the end."""
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
            text=f"the bar has room for a peg from {1e3 * (joint.lug + radius):.1f} mm, where the hinge's lug ends, to"
            f" {1e3 * (arm.length - radius):.1f} mm from the hinge; it is at {1e3 * arm.peg:.1f} mm"
            + ("" if room >= 0 else ": change the tendon's attachment, make the bar longer, or the peg thinner"),
        )


def _between(angles: Sequence[float]) -> str:
    """From which angle to which, rad, in words."""
    low, high = (f"{math.degrees(angle):.0f}" for angle in (min(angles), max(angles)))
    return f"at {low} deg" if low == high else f"from {low} to {high} deg"


def _overlap(joint: JointLayout, proximal: Manifold, distal: Manifold) -> Check:
    """Whether the two halves are ever in one place, pegs and all."""
    angles = np.linspace(joint.lower, joint.upper, _ANGLES)
    volumes = [(proximal ^ placed(distal, *turned(joint, angle))).volume() for angle in angles]
    worst = int(np.argmax(volumes))
    held = volumes[worst] <= _TOUCH
    text = f"the two halves are never in one place, at {_ANGLES} angles"
    if not held:
        where = [float(angle) for angle, volume in zip(angles, volumes, strict=True) if volume > _TOUCH]
        text = f"the two halves are in one place {_between(where)}: {_apart(joint)}"
    return Check(
        name="overlap over the range",
        part=joint.name,
        ok=held,
        value=volumes[worst] / MILLIMETRES**3,
        limit=_TOUCH / MILLIMETRES**3,
        unit="m^3",
        text=text,
    )


def _apart(joint: JointLayout) -> str:
    """What keeps two halves apart that meet."""
    arms, radius = (joint.proximal, joint.distal), joint.make.peg_diameter / 2
    if any(arm.length < joint.lug or 0 < arm.peg < joint.lug + radius for arm in arms):
        return f"a bar or its peg ends within the hinge's lug, {1e3 * joint.lug:.1f} mm from the hinge: make it longer"
    return "move the pegs apart, by unequal attachments of the tendon, larger offsets or a smaller make.peg_diameter"


def _gap(joint: JointLayout, proximal: Manifold, distal: Manifold) -> Check:
    """The least gap between the halves where their stop faces are apart by the clearance at least."""
    clearance = joint.make.clearance
    apart = clearance / (joint.knuckle_diameter / 2 + clearance)
    angles = np.linspace(joint.lower + apart, joint.upper - apart, _GAPS)
    search = 2 * clearance * MILLIMETRES
    gaps = [proximal.min_gap(placed(distal, *turned(joint, angle)), search) / MILLIMETRES for angle in angles]
    least = int(np.argmin(gaps))
    held = gaps[least] >= clearance - _GAP_AGREES
    return Check(
        name="least gap",
        part=joint.name,
        ok=held,
        value=gaps[least],
        limit=clearance,
        unit="m",
        text=f"the two halves come as near as that at {math.degrees(angles[least]):.0f} deg, away from the stops"
        + ("" if held else f"; they must keep make.clearance apart: {_apart(joint)}"),
    )


def _stops(parts: PartSet, joint: JointLayout) -> Iterator[Check]:
    """Whether the solids meet where the stops are to be."""
    for name, found, nominal in zip(
        ("fold stop", "overbend stop"), stop_angles(parts, joint), (joint.lower, joint.upper), strict=True
    ):
        yield Check(
            name=name,
            part=joint.name,
            ok=abs(found - nominal) <= _STOP_AGREES,
            value=found,
            limit=nominal,
            unit="rad",
            text=f"the stop faces meet at {math.degrees(found):.4f} deg; the design has {math.degrees(nominal):g} deg",
        )


def strap_checks(parts: PartSet) -> Iterator[Check]:
    """Whether the straps of every tendon pass everything at all angles: taut, and slack to either side."""
    for place in parts.straps:
        joints = [joint for joint in parts.joints if joint.tendon == place.tendon]
        bodies = dict.fromkeys(arm.body for joint in joints for arm in (joint.proximal, joint.distal))
        shapes = [_bare_shape(parts, body) for body in bodies]
        name = parts.structure.tendons[place.tendon].name
        yield _strap_check(place, _swept(place, joints, shapes, taut=True), name, "taut")
        yield _strap_check(place, _swept(place, joints, shapes, taut=False), name, "slack")


@dataclass(frozen=True, kw_only=True)
class _Swept:
    """A strap in one place: the joints' angles, summed, rad; what it takes of bars, mm^3; its bow, m."""

    angle: float
    volume: float
    bow: float


def _swept(place: StrapPlace, joints: Sequence[JointLayout], shapes: Sequence[Manifold], *, taut: bool) -> list[_Swept]:
    """The straps of a tendon wherever they are taut, or slack, at angles of all of its joints."""
    found, axis = [], joints[0].frame[:, 1]
    for share in np.linspace(0.0, 1.0, _STRAPS):
        angles = [joint.lower + share * (joint.upper - joint.lower) for joint in joints]
        poses = _chain(joints, angles)
        posed = [placed(shape, *pose) for shape, pose in zip(shapes, poses, strict=True)]
        for start, end in place.ends:
            here, there = (pose.of(at) for at, pose in ((start, poses[0]), (end, poses[-1])))
            if (float(np.linalg.norm(there - here)) >= place.strap.rest_length) != taut:
                continue
            for side in (1,) if taut else (1, -1):
                line = strap_line(place, here, there, axis, side)
                strap = solid_of(strap_along(place, line, axis))
                volume = sum((strap ^ body).volume() for body in posed)
                found.append(_Swept(angle=sum(angles), volume=volume, bow=_bows(line)))
    return found


def _strap_check(place: StrapPlace, swept: Sequence[_Swept], name: str, said: str) -> Check:
    """Check the straps of a tendon where they are taut, or where they are slack."""
    caught = [each.angle for each in swept if each.volume > _TOUCH]
    if not swept:
        text = f"the straps are never {said} within the range"
        text += ": they hold nothing, so make tendon.rest_length shorter" if said == "taut" else ""
    elif caught:
        text = f"{said}, a strap goes through the joint {_between(caught)}: it is caught there; "
        text += (
            "two straps beside the bars (make.straps = 2) pass them"
            if place.strap.count == 1
            else "a narrower hinge (make.hinge_width) or bars nearer to square to it let it pass"
        )
    else:
        highest = max(each.bow for each in swept)
        text = f"{said}, the straps pass everything, at {len(swept)} of their places"
        text += "" if said == "taut" else f"; their bows stand up to {1e3 * highest:.0f} mm off the line between pegs"
    return Check(
        name=f"straps {said}",
        part=name,
        # one that is never taut does nothing; one that is never slack need not pass anything so
        ok=not caught if swept else (False if said == "taut" else None),
        value=max((each.volume for each in swept), default=0.0) / MILLIMETRES**3,
        limit=_TOUCH / MILLIMETRES**3,
        unit="m^3",
        text=text,
    )


def _chain(joints: Sequence[JointLayout], angles: Sequence[float]) -> list[RigidMotion]:
    """Place the bodies of a chain of joints, from the first one's proximal on, which does not move."""
    poses = [STILL]
    for joint, angle in zip(joints, angles, strict=True):
        poses.append(poses[-1].after(turned(joint, angle)))
    return poses


def _bows(line: Array) -> float:
    """How far a line stands off the straight one between its ends, m."""
    off, way = line - line[0], (line[-1] - line[0]) / np.linalg.norm(line[-1] - line[0])
    return float(np.linalg.norm(off - (off @ way)[:, None] * way, axis=1).max())


def _body_shape(parts: PartSet, body: int) -> Manifold:
    """All that moves with a body but pins, which turn in what they are in, mm."""
    return Manifold.batch_boolean([part.shape for part in parts.of_body(body) if part.kind != "pin"], OpType.Add)


def _bare_shape(parts: PartSet, body: int) -> Manifold:
    """A bar without its pegs, mm."""
    arms = [
        (replace(joint, strap=None), getattr(replace(joint, strap=None), side))
        for joint in parts.joints
        for side in ("proximal", "distal")
        if getattr(joint, side).body == body
    ]
    return solid_of(bar_solid(arms))
