"""Order in which groups of hinges move after a drive is switched on."""

from __future__ import annotations

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


def event_texts(record: Record) -> list[str]:
    """Return one sentence for each driven stage in which groups of hinges move one after another.

    Middles of travel that differ by no more than the interval between two rows of the record count as simultaneous.
    """
    texts = []
    for number, end in enumerate(record.stages):
        motions = group_motions(record, number) if stage_drives(end.stage) else ()
        apart = record.design.protocol.sample_interval
        if motions and motions[-1].middle - motions[0].middle > apart:
            texts.append(_text(end.stage.name, end.start, motions, apart))
    return texts


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


def _text(stage: str, start: float, motions: tuple[GroupMotion, ...], apart: float) -> str:
    unit, factor = reading_unit("s", motions[-1].middle - start)
    digits = max(0, -int(np.floor(np.log10(factor * apart))))

    def moments(motion: GroupMotion) -> list[str]:
        return [f"{factor * (moment - start):.{digits}f} {unit}" for moment in (motion.begin, motion.middle)]

    first, *others = motions
    begin, middle = moments(first)
    text = (
        f'Stage "{stage}", times since its start: the {first.group} begins to move at {begin} and passes the middle of'
        f" its travel at {middle}"
    )
    for before, motion in zip(motions[:-1], others, strict=True):
        begin, middle = moments(motion)
        order = "then" if motion.middle - before.middle > apart else "and"
        text += f", {order} the {motion.group} at {begin} and {middle}"
    return f"{text}."
