"""Order in which groups of hinges move after a drive is switched on."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.design import stage_drives
from forficula.dynamics import Record
from forficula.quantities import reading_unit
from forficula.structure import hinge_groups

_BEGIN, _MIDDLE = 0.05, 0.5  # shares of the travel, the first chosen
# least mean travel of the hinges of a group that counts as moving, rad, and as a share of the largest travel; chosen
_LEAST, _LEAST_SHARE = float(np.radians(1.0)), 0.1


@dataclass(frozen=True, kw_only=True)
class GroupMotion:
    """Motion of the hinges of one role after a drive is switched on.

    The travel of a hinge is the change of its angle from the start of the stage to the end of that stage, or of an
    undriven stage after it if the group is then further from its start. The progress of a group is the sum of the
    changes of its hinges towards the end of their travel, as a share of the sum of their travels.

    Attributes:
        group: role of the hinges.
        begin: time at which the progress exceeds 5 % for the last time before the middle, s in the run.
        middle: time at which the progress first reaches 50 %, s in the run.
        travel: mean travel of the hinges, rad.
    """

    group: str
    begin: float
    middle: float
    travel: float


def group_motions(record: Record, stage: int) -> tuple[GroupMotion, ...]:
    """Return the motions of the groups of hinges that move in a driven stage or in undriven stages after it.

    Groups are the roles of joints and creases. A group whose hinges travel by less than 1 deg, or by less than 10 % of
    the largest travel of a group, does not count as moving.

    Args:
        record: the simulated motion.
        stage: index of the driven stage.

    Returns:
        The motions in the order in which they pass the middle of their travel; none if the run diverged in the stage.
    """
    start = record.stages[stage].start
    ends = [record.stages[stage].end]
    for following in record.stages[stage + 1 :]:
        if stage_drives(following.stage):
            break
        ends.append(following.end)
    rows = (record.time >= start) & (record.time <= ends[-1])
    time, angles = record.time[rows], record.series["hinge_angle"][rows]
    if len(time) < 2 or not np.isfinite(angles).all():
        return ()
    last = [int(np.searchsorted(time, end, side="right")) - 1 for end in ends]
    motions = [
        motion
        for role, hinges in _roles(record).items()
        if (motion := _motion(role, time, angles[:, hinges] - angles[0, hinges], last)) is not None
    ]
    most = max((motion.travel for motion in motions), default=0.0)
    moving = [motion for motion in motions if motion.travel >= max(_LEAST, _LEAST_SHARE * most)]
    return tuple(sorted(moving, key=lambda motion: motion.middle))


def ordered_motions(record: Record, stage: int) -> tuple[GroupMotion, ...]:
    """Return the motions of a driven stage if groups move one after another; else none.

    Middles of travel that differ by no more than the interval between two rows of the record count as simultaneous.
    """
    motions = group_motions(record, stage)
    apart = record.design.protocol.sample_interval
    return motions if motions and motions[-1].middle - motions[0].middle > apart else ()


def event_texts(record: Record) -> list[str]:
    """Return one sentence for each driven stage in which groups of hinges move one after another."""
    return [
        _text(record, number, motions)
        for number, end in enumerate(record.stages)
        if stage_drives(end.stage) and (motions := ordered_motions(record, number))
    ]


def moment_texts(record: Record, stage: int, moments: Sequence[float]) -> list[str]:
    """Return times of a run, s, since the start of a stage: in one unit, to the interval between two rows."""
    start = record.stages[stage].start
    unit, factor = reading_unit("s", max(moments) - start)
    digits = max(0, -math.floor(math.log10(factor * record.design.protocol.sample_interval)))
    return [f"{factor * (moment - start):.{digits}f} {unit}" for moment in moments]


def _roles(record: Record) -> dict[str, list[int]]:
    """Return the numbers of joints and creases by role, without bends within facets."""
    groups, hinges = hinge_groups(record.structure), record.structure.hinges
    roles: dict[str, list[int]] = {}
    for number in (*groups.get("hinges", ()), *groups.get("creases", ())):
        roles.setdefault(hinges[number].role, []).append(number)
    return roles


def _motion(role: str, time: Array, changes: Array, last: list[int]) -> GroupMotion | None:
    """Return the motion of a group; None if it does not move.

    Args:
        role: role of the hinges.
        time: s, (row,).
        changes: changes of the angles since the first row, rad, (row, hinge).
        last: last rows of the stages.
    """
    travels = changes[max(last, key=lambda row: float(np.abs(changes[row]).sum()))]
    total = float(np.abs(travels).sum())
    if total == 0:
        return None
    progress = changes @ np.sign(travels) / total
    middle = int(np.argmax(progress >= _MIDDLE))
    begin = int(np.flatnonzero(progress[:middle] <= _BEGIN)[-1]) + 1
    return GroupMotion(
        group=role,
        begin=_crossing(time, progress, begin, _BEGIN),
        middle=_crossing(time, progress, middle, _MIDDLE),
        travel=total / len(travels),
    )


def _crossing(time: Array, progress: Array, row: int, level: float) -> float:
    """Return the time at which the progress reaches a level between a row and the one before, by interpolation, s."""
    before, after = progress[row - 1 : row + 1].tolist()
    return float(time[row - 1] + (level - before) / (after - before) * (time[row] - time[row - 1]))


def _text(record: Record, stage: int, motions: tuple[GroupMotion, ...]) -> str:
    moments = moment_texts(record, stage, [moment for motion in motions for moment in (motion.begin, motion.middle)])
    apart = record.design.protocol.sample_interval
    first, *others = motions
    text = (
        f'Stage "{record.stages[stage].stage.name}", times since its start: the {first.group} begins to move at'
        f" {moments[0]} and passes the middle of its travel at {moments[1]}"
    )
    for before, motion, begin, middle in zip(motions[:-1], others, moments[2::2], moments[3::2], strict=True):
        order = "then" if motion.middle - before.middle > apart else "and"
        text += f", {order} the {motion.group} at {begin} and {middle}"
    return f"{text}."
