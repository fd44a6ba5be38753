"""What a run is asked that did not come to its goal: until when it moved, and what it would have taken."""

from __future__ import annotations

import numpy as np

from forficula.analysis.advice import least_torque
from forficula.design import stage_drives
from forficula.dynamics import Record, StageEnd
from forficula.structure import Transition

_NEARLY_ALL = 0.95


def stalled_stage(record: Record) -> StageEnd | None:
    """The driven stage that ended short of its goal; None where none did, or where the run blew up."""
    short = (end for end in record.stages if stage_drives(end.stage) and end.goal_time is None)
    found = next((end for end in short if end.stage.until != "time"), None)
    return found if record.diverged_at is None else None


def still_time(record: Record, start: float, end: float) -> float:
    """When the hinges that motors act on have on average gone nearly all their way, s: the rest creeps."""
    rows = (record.time >= start) & (record.time <= end)
    driven = [hinge for motor in record.structure.motors for hinge in motor.hinges]
    angles = record.series["hinge_angle"][rows][:, driven or slice(None)]
    way = np.abs(angles - angles[0]).mean(axis=1)
    return float(record.time[rows][np.argmax(way >= _NEARLY_ALL * way.max())])


def stalled_transition(record: Record) -> Transition | None:
    """The transition that a stage was to make and did not."""
    stalled = stalled_stage(record)
    stage = None if stalled is None else record.stages.index(stalled)
    return next((each for each in record.structure.transitions if stage is not None and each.stage == stage), None)


def needed_torque(record: Record) -> float | None:
    """The least slowly growing torque that would have made the transition that a run missed, N m.

    By the statics, without inertia, up to ten times what the protocol sets.

    Returns:
        nan where none does; None where nothing was missed, or it is not torques on a tree of hinges that were to do it.
    """
    missed = stalled_transition(record)
    return None if missed is None else least_torque(record.design, record.structure, missed)
