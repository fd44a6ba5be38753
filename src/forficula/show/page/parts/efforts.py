"""Positions and directions of drives over a run: the data for their arrows in a page."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from forficula.arrays import Array, Indices
from forficula.design import stage_drives
from forficula.dynamics import Record
from forficula.quantities import reading_unit
from forficula.show.page.data.packing import packed, packed_directions
from forficula.statics.tree.pose import Pose, pose, tree_of
from forficula.structure import GROUND, Drive, Hinge, Motor, Structure, built_points, drive_of, drive_unit, driven_motor

_WORDS = {"torque": "torque", "force": "force", "displacement": "displacement", "rest-angle": "turn of rest angles"}
_ARC, _LEAST_ARC = 0.075, 0.04  # radius of an arrow about an axis, as a share of the structure's span
_BESIDE = 0.45  # largest radius as a share of the distance to the nearest other axis
_SAME = 1e-6  # axes closer than this share of the span count as one
_MOST_MOMENTS = 100  # largest number of frames of a stage
_LONGEST_WORDS = 60


@dataclass(frozen=True, kw_only=True)
class Turn:
    """Hinge on which a torque acts.

    Attributes:
        shares: factors on the strength of each drive that acts on the hinge, (drive,).
        ends: indices of the points from which to which a crease runs, in its positive sense; None for a joint.
        pivot: a point on the axis of a joint, m, (time, 3), or (1, 3) if the point does not move.
        axis: axis of a joint in its positive sense, unit vectors, same shape as `pivot`.
        left: share of the torque that remains at the hinge's speed, (time,); None if the torque ignores speed.
        radius: radius of the arrow, m.
    """

    shares: tuple[float, ...]
    ends: tuple[int, int] | None
    pivot: Array
    axis: Array
    left: Array | None
    radius: float = 0.0


@dataclass(frozen=True, kw_only=True)
class Push:
    """Point at which a force acts.

    Attributes:
        shares: factors on the strength of each drive that acts on the point, (drive,); 0 for a displacement.
        point: index of the point.
        direction: direction of the force, unit vector, (3,).
        force: total force of a displacement on all its points, divided by its maximum, (time,); None for a force.
    """

    shares: tuple[float, ...]
    point: int
    direction: Array
    force: Array | None


@dataclass(frozen=True, kw_only=True)
class Efforts:
    """Actions of the drives over the frames of a clip.

    Attributes:
        structure: structure on which the drives act.
        time: times of the positions, s, (time,), within driven stages.
        drives: drives that the stages switch on.
        stages: start and end, s, and indices of the drives, for each driven stage.
        turns: hinges on which torques act.
        pushes: points on which forces act.
    """

    structure: Structure
    time: Array
    drives: tuple[Drive, ...]
    stages: tuple[tuple[float, float, tuple[int, ...]], ...]
    turns: tuple[Turn, ...]
    pushes: tuple[Push, ...]


def effort_word(structure: Structure, drive: Drive) -> str:
    """Return the noun of what a drive does, such as "torque"."""
    return _WORDS[driven_motor(structure, drive).kind]


def efforts_of(record: Record, rows: Indices) -> Efforts:
    """Find where drives act, at those rows of a record that a page shows."""
    structure, rows = record.structure, _acting_rows(record, rows)
    names = list(dict.fromkeys(name for end in record.stages for name in stage_drives(end.stage)))
    drives = tuple(drive_of(structure, name) for name in names)
    turns: list[Turn] = []
    pushes: list[Push] = []
    joints = any(hinge.flaps is None for hinge in structure.hinges)
    at = pose(tree_of(structure), record.series["hinge_angle"][rows]) if joints else None
    for number, motor in enumerate(structure.motors):
        shares = [drive.shares[number] for drive in drives]
        if not any(shares):
            continue
        if motor.kind == "torque":
            turns += _motor_turns(record, rows, motor, shares, at)
        elif motor.kind in ("force", "displacement"):
            pushes += _motor_pushes(record, rows, number, shares)
    return Efforts(
        structure=structure,
        time=record.time[rows],
        drives=drives,
        stages=tuple(
            (end.start, end.end, tuple(names.index(name) for name in driving))
            for end in record.stages
            if (driving := stage_drives(end.stage))
        ),
        turns=_with_radii(structure, turns),
        pushes=tuple(pushes),
    )


def _acting_rows(record: Record, rows: Indices) -> Indices:
    """Return those of the rows that lie in driven stages, thinned out: shown rows are dense where motion is fast."""
    row_groups = []
    for end in record.stages:
        if stage_drives(end.stage):
            within = rows[(record.time[rows] >= end.start) & (record.time[rows] <= end.end)]
            row_groups.append(
                within[np.unique(np.linspace(0, max(len(within) - 1, 0), _MOST_MOMENTS).astype(int))[: len(within)]]
            )
    acting = np.unique(np.concatenate([*row_groups, rows[:0]]))
    return acting if len(acting) else rows[:1]


def efforts_data(efforts: Efforts, anchors: Indices) -> dict[str, Any]:
    """Return efforts as data for JSON; arrows at points that do not move are left out."""
    structure, places = efforts.structure, {number: place for place, number in enumerate(anchors.tolist())}
    return {
        "time": packed(efforts.time, "f8"),
        "drives": [_drive_data(structure, drive) for drive in efforts.drives],
        "stages": [{"start": start, "end": end, "drives": list(drives)} for start, end, drives in efforts.stages],
        "turns": [
            {
                "shares": list(turn.shares),
                "ends": None if turn.ends is None else [places[end] for end in turn.ends],
                "radius": turn.radius,
                "pivot": packed(turn.pivot, "f4"),
                "axis": packed_directions(turn.axis),
                "left": None if turn.left is None else packed(turn.left, "f4"),
            }
            for turn in efforts.turns
            if turn.ends is None or places.keys() >= set(turn.ends)
        ],
        "pushes": [
            {
                "shares": list(push.shares),
                "point": places[push.point],
                "direction": push.direction.tolist(),
                "force": None if push.force is None else packed(push.force, "f4"),
            }
            for push in efforts.pushes
            if push.point in places
        ],
    }


def crease_ends(hinge: Hinge) -> tuple[int, int]:
    """Return the points from and to which a crease runs, so that folding turns its left flap right-handed about it."""
    assert hinge.flaps is not None
    tail, head, *_ = hinge.flaps
    return (tail, head) if hinge.sense > 0 else (head, tail)


def _drive_data(structure: Structure, drive: Drive) -> dict[str, Any]:
    kind = driven_motor(structure, drive).kind
    unit, factor = reading_unit(drive_unit(structure, drive), abs(drive.strength))
    words = drive.where
    if len(words) > _LONGEST_WORDS:
        motors = [motor for motor, share in zip(structure.motors, drive.shares, strict=True) if share]
        hinges, points = (sum(len(getattr(motor, name)) for motor in motors) for name in ("hinges", "points"))
        words = f"on {hinges} hinges" if hinges else f"on {points} points"
    return {
        "text": f"{effort_word(structure, drive)} {words}".strip(),
        "arrow": kind != "rest-angle",
        "unit": unit,
        "factor": factor,
        "strength": drive.strength,
        "rise": drive.rise,
    }


def _motor_turns(record: Record, rows: Indices, motor: Motor, shares: list[float], at: Pose | None) -> list[Turn]:
    """Return the hinges of a motor, without joints on sliding bodies, whose position does not follow from angles."""
    turns, empty = [], np.zeros((0, 3))
    for hinge, gain in zip(motor.hinges, motor.gains or (1.0,) * len(motor.hinges), strict=True):
        built, ends, pivot, axis = record.structure.hinges[hinge], None, empty, empty
        if built.flaps is not None:
            ends = crease_ends(built)
        elif at is not None and _is_anchored(record.structure, hinge):
            axis = _constant_row(at.axes[:, :, hinge].T)
            pivot = _constant_row(at.pivots[:, :, hinge].T + _middle(record.structure, hinge) * at.axes[:, :, hinge].T)
        else:
            continue
        left = None
        if np.isfinite(motor.no_load_speed):
            speeds = np.gradient(record.series["hinge_angle"][:, hinge], record.time)
            left = 1 - speeds[rows] / motor.no_load_speed
        hinge_shares = tuple(gain * share for share in shares)
        turns.append(Turn(shares=hinge_shares, ends=ends, pivot=pivot, axis=axis, left=left))
    return turns


def _motor_pushes(record: Record, rows: Indices, number: int, shares: list[float]) -> list[Push]:
    motor, force = record.structure.motors[number], None
    assert motor.direction is not None
    if motor.kind == "displacement":
        forces = record.series["motor_force"][:, number]
        force, shares = forces[rows] / (np.nanmax(np.abs(forces)) or 1.0), [0.0] * len(shares)
    return [Push(shares=tuple(shares), point=point, direction=motor.direction, force=force) for point in motor.points]


def _is_anchored(structure: Structure, hinge: int) -> bool:
    """Return whether the position of a joint follows from angles alone: no body between it and the ground slides."""
    body = structure.hinges[hinge].body
    while body != GROUND:
        if structure.bodies[body].slides:
            return False
        body = structure.bodies[body].parent
    return True


def _middle(structure: Structure, number: int) -> float:
    """Return the distance along a joint's axis from the body's origin to the middle of the body's points on it, m."""
    hinge = structure.hinges[number]
    places = np.array([point.place for point in structure.points if point.body == hinge.body]).reshape(-1, 3)
    along = hinge.sense * (places @ hinge.axis)
    off_axis = np.linalg.norm(places - np.outer(hinge.sense * along, hinge.axis), axis=1)
    on_axis = along[off_axis <= _SAME * structure.span]
    return float(on_axis.min() + on_axis.max()) / 2 if len(on_axis) else 0.0


def _constant_row(values: Array) -> Array:
    """Return only the first row of values that do not change."""
    return values[:1] if len(values) and np.allclose(values, values[:1], atol=1e-9) else values


def _with_radii(structure: Structure, turns: Sequence[Turn]) -> tuple[Turn, ...]:
    """Set the radii of arrows so that neighbouring arrows hardly overlap in the built shape."""
    span, points = structure.span, built_points(structure)
    middles = np.array([points[list(turn.ends)].mean(axis=0) if turn.ends else turn.pivot[0] for turn in turns])
    gaps = np.linalg.norm(middles[:, np.newaxis] - middles, axis=2) if len(turns) else np.zeros((0, 0))
    least = np.where(gaps > _SAME * span, gaps, np.inf).min(axis=1, initial=np.inf)
    radii = np.clip(_BESIDE * least, _LEAST_ARC * span, _ARC * span)
    return tuple(replace(turn, radius=float(radius)) for turn, radius in zip(turns, radii, strict=True))
