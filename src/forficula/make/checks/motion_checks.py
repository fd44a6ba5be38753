"""What is checked of parts in a recorded motion: who touches whom, stops, and what roots go through."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from forficula.design import key_quantity, key_value
from forficula.dynamics import Record
from forficula.errors import InputError
from forficula.make.checks.check import Check
from forficula.make.flat.touching import TOUCHES, Touch, built_overlaps, touches
from forficula.make.hinge.hub import Root
from forficula.make.part import PartSet
from forficula.make.solid.mending import Mending, mendings
from forficula.make.solid.poses import poses_of, stage_at
from forficula.material.law.law_file import load_law
from forficula.names import listed
from forficula.quantities import show_value

# beyond a stop, of which a run's stops are springs, rad
_GIVES = math.radians(1.0)
# Poisson's ratio of rubbers, by which they are sheared: they keep their volume
_POISSON = 0.5


def motion_checks(parts: PartSet, record: Record, mend: bool = True) -> Iterator[Check]:
    """Check parts in a recorded motion.

    Args:
        parts: with joints.
        record: of a run of their design.
        mend: whether to try what would keep parts from touching, where any do; that takes some ten seconds.
    """
    if record.diverged_at is not None:
        yield _not_looked_at(parts)
        return
    found = touches(parts, record)
    yield from _touch_checks(parts, found)
    if found and mend:
        yield _mending_check(parts, mendings(parts, record))
    yield from _stop_checks(parts, record)
    yield from _root_checks(parts, record)


def built_checks(parts: PartSet) -> Iterator[Check]:
    """Check that bodies that no joint hinges to one another are clear of each other as they are built."""
    if len(parts.joints) < 2:
        return
    found = built_overlaps(parts)
    worst = max(found.values(), default=0.0)
    text = "no two bodies that no joint hinges to one another touch as they are built"
    if found:
        pairs = listed([f"{one} and {other} ({volume * 1e9:.3g} mm^3)" for (one, other), volume in found.items()])
        text = (
            f"in one place as they are built: {pairs}; move pegs nearer to the hinges (tendon.proximal_attachment), or"
            " take thinner bars, pegs, hinges and roots"
        )
    yield Check(
        name="overlap as built",
        part=parts.design.name,
        ok=not found,
        value=worst,
        limit=TOUCHES,
        unit="m^3",
        text=text,
    )


def _not_looked_at(parts: PartSet) -> Check:
    return Check(
        name="overlap in the recorded motion",
        part=parts.design.name,
        ok=None,
        value=math.nan,
        limit=TOUCHES,
        unit="m^3",
        text="not looked at, for the run diverged",
    )


def _touch_checks(parts: PartSet, found: Sequence[Touch]) -> Iterator[Check]:
    """Every pair of bodies that touch, the first ones first; or that none do."""
    by_pair: dict[tuple[str, str], list[Touch]] = {}
    for touch in found:
        by_pair.setdefault(touch.bodies, []).append(touch)
    for bodies, its in by_pair.items():
        first, most = its[0], max(its, key=lambda touch: touch.volume)
        told = [f"{' and '.join(each.features)} at {_when(each)}" for each in its[1:4]]
        more = f"; then {', '.join(told)}" if told else ""
        yield Check(
            name="overlap in the recorded motion",
            part=" and ".join(bodies),
            ok=False,
            value=most.volume,
            limit=TOUCHES,
            unit="m^3",
            text=f"{' and '.join(first.features)} touch from {_when(first)} on, with {_angles(first)}{more}; they come"
            f" to have {most.volume * 1e9:.3g} mm^3 in common, so this motion cannot be made with these parts",
        )
    if not by_pair:
        yield Check(
            name="overlap in the recorded motion",
            part=parts.design.name,
            ok=True,
            value=0.0,
            limit=TOUCHES,
            unit="m^3",
            text="no two bodies that no joint hinges to one another touch, in rows of the record that are as far from"
            " one another as can be; straps and rods are not looked at",
        )


def _when(touch: Touch) -> str:
    """A moment by its stage."""
    return f'{touch.after * 1e3:.1f} ms of stage "{touch.stage}"'


def _angles(touch: Touch) -> str:
    return listed([f"{name} at {math.degrees(angle):.1f} deg" for name, angle in touch.angles.items()])


def _mending_check(parts: PartSet, tried: Sequence[Mending]) -> Check:
    """What would keep parts from touching."""
    told = [f"{each.name}: {_told(each)}" for each in tried]
    free = [each for each in tried if each.touches is not None and not each.touches]
    values = ", ".join(f"{key} = {value}" for key, value in (free or tried)[-1 if not free else 0].values.items())
    return Check(
        name="what would mend the recorded motion",
        part=parts.design.name,
        ok=bool(free),
        value=float(len(free)),
        limit=1.0,
        unit="",
        text=f"tried in the same motion, {'; '.join(told)}; {free[0].name if free else tried[-1].name} is {values}",
    )


def _told(tried: Mending) -> str:
    """What became of a trial."""
    if tried.touches is None:
        return f"cannot be made ({tried.why})"
    if tried.first is None:
        return "nothing touches"
    first, bodies = tried.first, len({touch.bodies for touch in tried.touches})
    pair = " and ".join(f"{body} ({feature})" for body, feature in zip(first.bodies, first.features, strict=True))
    rest = f"something touches {listed(list(tried.states))}" if tried.states else "the named states are free"
    pairs = "1 pair" if bodies == 1 else f"{bodies} pairs"
    return f"first {pair} at {_when(first)}, {pairs} in all, {rest}"


def _stop_checks(parts: PartSet, record: Record) -> Iterator[Check]:
    """How far the run takes each joint beyond its stops."""
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
            text=f'stage "{stage.stage.name}" takes it {math.degrees(max(0.0, most)):.3g} deg beyond a stop, which is a'
            f" spring in a run; real faces are taken to give way by no more than {math.degrees(_GIVES):g} deg",
        )


def _root_checks(parts: PartSet, record: Record) -> Iterator[Check]:
    """Where rods bend beside the joints they stand for, and what moments the recorded motion needs of them."""
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
            text=f"what bends has its middle {show_value(abs(shift), 'm')} along the bar and {show_value(height, 'm')}"
            " above or below the joint that the design has there, so the bar does not turn about the place that it"
            " turns about in a run; a shorter rod (make.root_length) brings it nearer",
        )
        yield _root_moment(parts, record, root)


def _root_moment(parts: PartSet, record: Record, root: Root) -> Check:
    """The larger of the moments that bend and turn a rod as far as the run does, by the torque that folds."""
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
            f" {show_value(root.make.root_length, 'm')} long, takes {show_value(bending, 'N m')} and"
            f" {show_value(twisting, 'N m')} for that"
        )
    else:
        text += f"; the sources of {root.make.root_material} give no modulus, so no moment is known"
    if torque is not None:
        text += f", of {key} = {show_value(torque, 'N m')}; in the run it takes none"
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
    """How far a run bends a root away from how it is built, and how far it turns it about its own axis, rad.

    The rotation of the bar is taken as a turn about its own axis and then the shortest way to where it points.
    """
    turns = poses_of(record, range(len(record.time))).frames[:, root.body]
    pointing = turns @ root.along
    bends = np.arctan2(np.linalg.norm(np.cross(pointing, root.along), axis=1), pointing @ root.along)
    # of a quaternion, that about an axis: twice the angle whose tangent is vector part along it by scalar part
    vector = np.stack([turns[:, i, j] - turns[:, j, i] for i, j in ((2, 1), (0, 2), (1, 0))], axis=1)
    twist = 2 * np.arctan2(vector @ root.along, 1 + np.trace(turns, axis1=1, axis2=2))
    return float(bends.max()), float(np.abs(twist).max())


def root_moments(root: Root, bend: float, turn: float) -> tuple[float, float]:
    """What bends and turns a rod so far, evenly along it, N m: E I bend / l and G J turn / l.

    Of a round one I = pi d^4 / 64 and J = 2 I; rubbers keep their volume, so G = E / 3. Large turns are reckoned
    as small ones.

    Returns:
        nan where the sources of its material give no modulus.
    """
    law = load_law(root.make.root_material)
    if law.moduli is None:
        return math.nan, math.nan
    area = math.pi * root.make.root_diameter**4 / 64
    bending = law.moduli[0] * area / root.make.root_length
    return bending * bend, bending * turn * 2 / (2 * (1 + _POISSON))


def _fold_torque(parts: PartSet) -> tuple[float | None, str]:
    """The torque that folds, N m, and its key; None where the design has none."""
    key = "protocol.fold_torque"
    try:
        key_quantity(key, type(parts.design))
    except InputError:
        return None, key
    return float(key_value(parts.design, key)), key
