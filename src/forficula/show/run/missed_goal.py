"""Analysis of a run that missed its goal: the time until which it moved, and the torque required."""

from __future__ import annotations

import numpy as np

from forficula.analysis.advice import least_torque
from forficula.design import stage_drives
from forficula.dynamics import Record, StageEnd
from forficula.structure import Transition

_NEARLY_ALL = 0.95


def stalled_stage(record: Record) -> StageEnd | None:
    """Return the driven stage that ended short of its goal; None if there is none, or if the run diverged."""
    short = (end for end in record.stages if stage_drives(end.stage) and end.goal_time is None)
    missed = next((end for end in short if end.stage.until != "time"), None)
    return missed if record.diverged_at is None else None


def still_time(record: Record, start: float, end: float) -> float:
    """Return when the driven hinges have on average completed 95 % of their motion, s: the rest is creep."""
    rows = (record.time >= start) & (record.time <= end)
    driven = [hinge for motor in record.structure.motors for hinge in motor.hinges]
    angles = record.series["hinge_angle"][rows][:, driven or slice(None)]
    moved = np.abs(angles - angles[0]).mean(axis=1)
    return float(record.time[rows][np.argmax(moved >= _NEARLY_ALL * moved.max())])


def stalled_transition(record: Record) -> Transition | None:
    """Return the transition that a stage missed."""
    stalled = stalled_stage(record)
    stage = None if stalled is None else record.stages.index(stalled)
    return next(
        (transition for transition in record.structure.transitions if stage is not None and transition.stage == stage),
        None,
    )


def needed_torque(record: Record) -> float | None:
    """Return the least slowly growing torque for the transition that a run missed, N m.

    Computed by statics, without inertia, up to ten times the protocol's torque.

    Returns:
        nan if no torque suffices; None if no transition was missed, or it is not driven by torques on a tree of hinges.
    """
    missed = stalled_transition(record)
    return None if missed is None else least_torque(record.design, record.structure, missed)
