"""Checks of parts in a recorded motion: collisions, stops, and angles of roots."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from forficula.design import key_quantity, key_value
from forficula.dynamics import Record
from forficula.errors import InputError
from forficula.make.checks.check import Check
from forficula.make.flat.clearance import LEAST_OVERLAP, Collision, built_overlaps, recorded_collisions
from forficula.make.hinge.hub import Root
from forficula.make.part import PartSet
from forficula.make.solid.poses import poses_of, stage_at
from forficula.make.solid.repair import Repair, possible_repairs
from forficula.material.law.law_file import load_law
from forficula.names import listed
from forficula.quantities import show_value

# allowed rotation beyond a stop, which is a spring in a run, rad
_GIVES = math.radians(1.0)
# Poisson's ratio of rubbers for shear: they are incompressible
_POISSON = 0.5


def motion_checks(parts: PartSet, record: Record, mend: bool = True) -> Iterator[Check]:
    """Check parts in a recorded motion.

    Args:
        parts: parts with joints.
        record: record of a run of their design.
        mend: whether to try changes that avoid collisions, if there are any; this takes about ten seconds.
    """
    if record.diverged_at is not None:
        yield _not_checked(parts)
        return
    collisions = recorded_collisions(parts, record)
    yield from _touch_checks(parts, collisions)
    if collisions and mend:
        yield _mending_check(parts, possible_repairs(parts, record))
    yield from _stop_checks(parts, record)
    yield from _root_checks(parts, record)


def built_checks(parts: PartSet) -> Iterator[Check]:
    """Check that bodies without a common joint do not overlap as built."""
    if len(parts.joints) < 2:
        return
    overlaps = built_overlaps(parts)
    worst = max(overlaps.values(), default=0.0)
    text = "no two bodies without a common joint touch as built"
    if overlaps:
        pairs = listed([f"{one} and {other} ({volume * 1e9:.3g} mm^3)" for (one, other), volume in overlaps.items()])
        text = (
            f"bodies overlap as built: {pairs}; move pegs nearer to the hinges (tendon.proximal_attachment), or"
            " choose thinner bars, pegs, hinges and roots"
        )
    yield Check(
        name="overlap as built",
        part=parts.design.name,
        ok=not overlaps,
        value=worst,
        limit=LEAST_OVERLAP,
        unit="m^3",
        text=text,
    )


def _not_checked(parts: PartSet) -> Check:
    return Check(
        name="overlap in the recorded motion",
        part=parts.design.name,
        ok=None,
        value=math.nan,
        limit=LEAST_OVERLAP,
        unit="m^3",
        text="not checked, because the run diverged",
    )


def _touch_checks(parts: PartSet, collisions: Sequence[Collision]) -> Iterator[Check]:
    """Yield a failed check for every pair of bodies that collide, the first ones first; or one passed check."""
    by_pair: dict[tuple[str, str], list[Collision]] = {}
    for touch in collisions:
        by_pair.setdefault(touch.bodies, []).append(touch)
    for bodies, collisions in by_pair.items():
        first, most = collisions[0], max(collisions, key=lambda touch: touch.volume)
        later = [f"{' and '.join(touch.features)} at {_when(touch)}" for touch in collisions[1:4]]
        more = f"; then {', '.join(later)}" if later else ""
        yield Check(
            name="overlap in the recorded motion",
            part=" and ".join(bodies),
            ok=False,
            value=most.volume,
            limit=LEAST_OVERLAP,
            unit="m^3",
            text=f"{' and '.join(first.features)} touch from {_when(first)} on, with {_angles(first)}{more}; their"
            f" overlap grows to {most.volume * 1e9:.3g} mm^3, so this motion cannot be made with these parts",
        )
    if not by_pair:
        yield Check(
            name="overlap in the recorded motion",
            part=parts.design.name,
            ok=True,
            value=0.0,
            limit=LEAST_OVERLAP,
            unit="m^3",
            text="no two bodies without a common joint touch, in rows of the record that are chosen as different from"
            " each other as possible; straps and rods are not checked",
        )


def _when(touch: Collision) -> str:
    """Return a text with a time in its stage."""
    return f'{touch.after * 1e3:.1f} ms of stage "{touch.stage}"'


def _angles(touch: Collision) -> str:
    return listed([f"{name} at {math.degrees(angle):.1f} deg" for name, angle in touch.angles.items()])


def _mending_check(parts: PartSet, tried: Sequence[Repair]) -> Check:
    """Return the changes that would avoid the collisions."""
    results = [f"{trial.name}: {_result(trial)}" for trial in tried]
    successful = [trial for trial in tried if trial.touches is not None and not trial.touches]
    best = successful[0] if successful else tried[-1]
    values = ", ".join(f"{key} = {value}" for key, value in best.values.items())
    return Check(
        name="repair of the recorded motion",
        part=parts.design.name,
        ok=bool(successful),
        value=float(len(successful)),
        limit=1.0,
        unit="",
        text=f"tried in the same motion, {'; '.join(results)}; {best.name} is {values}",
    )


def _result(tried: Repair) -> str:
    """Return a text with the result of a trial."""
    if tried.touches is None:
        return f"cannot be made ({tried.why})"
    if tried.first is None:
        return "nothing touches"
    first, bodies = tried.first, len({touch.bodies for touch in tried.touches})
    pair = " and ".join(f"{body} ({feature})" for body, feature in zip(first.bodies, first.features, strict=True))
    in_states = (
        f"parts touch in the states {listed(list(tried.states))}" if tried.states else "the named states are free"
    )
    pairs = "1 pair" if bodies == 1 else f"{bodies} pairs"
    return f"first {pair} at {_when(first)}, {pairs} in all, {in_states}"


def _stop_checks(parts: PartSet, record: Record) -> Iterator[Check]:
    """Check how far the run moves each joint beyond its stops."""
    for joint in parts.joints:
        angle = record.series["hinge_angle"][:, joint.hinge]
        beyond = np.maximum(angle - joint.upper, joint.lower - angle)
        row = int(np.argmax(beyond))
        most, stage = float(beyond[row]), stage_at(record, float(record.time[row]))
        yield Check(
            name="beyond the stops in the recorded motion",
            part=joint.name,
            ok=most <= _GIVES,
            value=most,
            limit=_GIVES,
            unit="rad",
            text=f'stage "{stage.stage.name}" moves it {math.degrees(max(0.0, most)):.3g} deg beyond a stop, which is a'
            f" spring in a run; real stops are assumed to yield by at most {math.degrees(_GIVES):g} deg",
        )


def _root_checks(parts: PartSet, record: Record) -> Iterator[Check]:
    """Check the distance of bending rods from the joints that they replace, and the moments that the motion needs."""
    for root in parts.roots:
        name, shift = parts.structure.bodies[root.body].name, root.bends
        height = abs(float(root.place[2]))
        off = math.hypot(shift, height)
        yield Check(
            name="root beside the design's joint",
            part=name,
            ok=off <= root.make.clearance,
            value=off,
            limit=root.make.clearance,
            unit="m",
            text=f"the middle of the bending rod is {show_value(abs(shift), 'm')} along the bar and"
            f" {show_value(height, 'm')} above or below the joint of the design, so the bar turns about another point"
            " than in a run; a shorter rod (make.root_length) is nearer",
        )
        yield _root_moment(parts, record, root)


def _root_moment(parts: PartSet, record: Record, root: Root) -> Check:
    """Compare the larger of the moments that bend and twist a rod as far as the run does with the folding torque."""
    name = parts.structure.bodies[root.body].name
    bend, turn = root_angles(record, root)
    bending, twisting = root_moments(root, bend, turn)
    torque, key = _fold_torque(parts)
    needed = max(bending, twisting)
    known = math.isfinite(needed) and torque is not None
    text = (
        f"the run bends it by {math.degrees(bend):.0f} deg and turns it about its axis by {math.degrees(turn):.0f} deg"
    )
    if math.isfinite(needed):
        text += (
            f"; a rod of {root.make.root_material}, {show_value(root.make.root_diameter, 'm')} thick and"
            f" {show_value(root.make.root_length, 'm')} long, needs {show_value(bending, 'N m')} and"
            f" {show_value(twisting, 'N m')} for these angles"
        )
    else:
        text += f"; the sources of {root.make.root_material} give no modulus, so the moment is unknown"
    if torque is not None:
        text += f"; {key} is {show_value(torque, 'N m')}; in the run the root has no stiffness"
    return Check(
        name="moment of the root",
        part=name,
        ok=needed <= torque if known and torque is not None else None,
        value=needed,
        limit=math.nan if torque is None else torque,
        unit="N m",
        text=text,
    )


def root_angles(record: Record, root: Root) -> tuple[float, float]:
    """Return the largest angles by which a run bends a root and twists it about its own axis, rad.

    The rotation of the bar is decomposed into a twist about its own axis and then the shortest rotation to its
    direction.
    """
    turns = poses_of(record, range(len(record.time))).frames[:, root.body]
    pointing = turns @ root.along
    bends = np.arctan2(np.linalg.norm(np.cross(pointing, root.along), axis=1), pointing @ root.along)
    # twist angle of a quaternion about an axis: 2 atan2(vector part along the axis, scalar part)
    vector = np.stack([turns[:, i, j] - turns[:, j, i] for i, j in ((2, 1), (0, 2), (1, 0))], axis=1)
    twist = 2 * np.arctan2(vector @ root.along, 1 + np.trace(turns, axis1=1, axis2=2))
    return float(bends.max()), float(np.abs(twist).max())


def root_moments(root: Root, bend: float, turn: float) -> tuple[float, float]:
    """Return the moments that bend and twist a rod evenly by these angles, N m: E I bend / l and G J turn / l.

    For a round rod I = pi d^4 / 64 and J = 2 I. Rubbers are incompressible, so G = E / 3. Large angles are treated as
    small ones.

    Returns:
        nan if the sources of its material give no modulus.
    """
    law = load_law(root.make.root_material)
    if law.moduli is None:
        return math.nan, math.nan
    area = math.pi * root.make.root_diameter**4 / 64
    bending = law.moduli[0] * area / root.make.root_length
    return bending * bend, bending * turn * 2 / (2 * (1 + _POISSON))


def _fold_torque(parts: PartSet) -> tuple[float | None, str]:
    """Return the folding torque, N m, and its key; None if the design has none."""
    key = "protocol.fold_torque"
    try:
        key_quantity(key, type(parts.design))
    except InputError:
        return None, key
    return float(key_value(parts.design, key)), key
