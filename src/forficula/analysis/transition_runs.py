"""Transitions of a run: the stages that drive them, whether they succeed, and their times and works."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from forficula.analysis.states import State, ended_without_divergence, stage_end_state, within_bounds
from forficula.analysis.verdict import ENDING_TEXTS
from forficula.design import stage_drives
from forficula.dynamics import Record, StageEnd
from forficula.quantities import show_value
from forficula.structure import Drive, StageGoal, Transition, drive_of, first_driven_stage, goal_of, state_of

_FIRST_STEP = 1.5  # timesteps, because times are multiples of the timestep up to rounding


@dataclass(frozen=True, kw_only=True)
class TransitionOutcome:
    """Outcome of a transition, such as folding.

    Attributes:
        strength: of its drive, in the SI unit of `drive_unit`.
        succeeded: whether the goal was reached, and the state held after the release if a release ends in it.
        time: from the start of the first driven stage after the previous state until the goal was reached, s; None if
            it failed.
        work: of the motors over the driven stages since the previous state, J: the integral of torque over angle.
        largest_force: largest total force along a displacement over the stage, N; None for other drives.
        drives: names of the drives of the driven stages since the previous state, in the order of their first use.
        held: whether the state held after the release; None if no release ends in the state.
        sprung_back: for a release that follows but ends in no named state: the readings furthest from the goal at the
            end of the driven stage and at the end of the release, rad or m; else None.
    """

    strength: float
    succeeded: bool
    time: float | None
    work: float
    largest_force: float | None
    drives: tuple[str, ...]
    held: bool | None = None
    sprung_back: tuple[float, float] | None = None

    def __repr__(self) -> str:
        """Success, time and work."""
        time = "" if self.time is None else f" after {show_value(self.time, 's')}"
        return f"<TransitionOutcome: {'succeeded' if self.succeeded else 'failed'}{time}, {show_value(self.work, 'J')}>"


@dataclass(frozen=True, kw_only=True)
class TransitionRun:
    """A transition in a run: the stages that drive it and that end at its goal, and the state at the end or later.

    A transition may begin with driven stages before its own. The stages after its goal may have goals of
    their own, up to the one that ends in the state, and `missed` is the first stage that missed such a goal.
    """

    transition: Transition
    begun: StageEnd | None
    driven: StageEnd | None
    ended: StageEnd | None
    missed: StageEnd | None
    state: State | None
    holds: bool


def transition_run(record: Record, transition: Transition) -> TransitionRun:
    """Return a transition in a run: its stages, its final state, and whether that state holds."""
    structure, number = record.structure, transition.stage
    if number is None or number >= len(record.stages):
        return TransitionRun(
            transition=transition, begun=None, driven=None, ended=None, missed=None, state=None, holds=False
        )
    driven, last = record.stages[number], transition.goal_stage
    begins = first_driven_stage(structure, record.design.protocol.stages, transition)
    ended = record.stages[last] if last is not None and last < len(record.stages) else None
    names = structure.stage_states
    named = next((place for place in range(number, len(names)) if names[place] == transition.state), number)
    end = (
        record.stages[named]
        if ended_without_divergence(record, named)
        else driven
        if ended_without_divergence(record, number)
        else None
    )
    rest_state = state_of(structure, transition.state)
    state = None if end is None else stage_end_state(record, end, transition.state)
    stage_goal = goal_of(structure, transition.goal if ended is None else ended.stage.until)
    ends_transition = _same_goal(stage_goal, goal_of(structure, transition.goal))
    reached = ended is not None and (ended.goal_time is not None or stage_goal.kind != "bounds")
    after = number if last is None else last
    missed = next(
        (end for end in record.stages[after + 1 : named + 1] if end.goal_time is None and has_bounds(record, end)),
        None,
    )
    holds = False
    if state is not None and rest_state is not None and missed is None:
        # a stage that does not end at a bound cannot reach it, so its final state decides
        kept = goal_of(structure, transition.released if ends_transition else rest_state.goal)
        holds = reached and within_bounds(state.coordinates, kept)
        # a goal that was met before the drive acted is not an effect of the drive
        holds = holds and ended is not None and not early_goal(record, ended)
    return TransitionRun(
        transition=transition,
        begun=driven if begins is None else record.stages[begins],
        driven=driven,
        ended=ended,
        missed=missed,
        state=state,
        holds=holds,
    )


def _same_goal(one: StageGoal, other: StageGoal) -> bool:
    """Return whether two goals have the same bounds, even if their names differ."""
    same_bounds = np.array_equal(one.least, other.least) and np.array_equal(one.most, other.most)
    return one.kind == other.kind and same_bounds


def has_bounds(record: Record, end: StageEnd) -> bool:
    """Return whether the goal of a stage is a bound."""
    return goal_of(record.structure, end.stage.until).kind == "bounds"


def early_goal(record: Record, end: StageEnd) -> str:
    """Return a warning if the goal of a driven stage, a bound, is met at its first step; else an empty text."""
    if end.goal_time is None or not stage_drives(end.stage) or not has_bounds(record, end):
        return ""
    early = end.goal_time - end.start <= _FIRST_STEP * float(record.design.protocol.timestep)
    # a quasi-static stage first comes to rest without its drive
    early = early or end.share == 0
    return ENDING_TEXTS["not held, early"].format(stage=end.stage.name) if early else ""


def transition_outcome(
    record: Record, run: TransitionRun, holds: Mapping[str, bool | None]
) -> TransitionOutcome | None:
    """Return the outcome of a transition in a run; None if the run did not get to it.

    Args:
        record: of the run.
        run: the transition in the run.
        holds: by name of a state, whether it was reached and held; None if the run is inconclusive.
    """
    begun, end, transition = run.begun, run.driven, run.transition
    if end is None or begun is None:
        return None
    succeeded = bool(holds[transition.state])
    reached = None if run.ended is None else run.ended.goal_time
    drive = drive_of(record.structure, transition.drive)
    released = run.state is not None and run.state.time > end.end
    return TransitionOutcome(
        strength=drive.strength,
        succeeded=succeeded,
        time=reached - begun.start if succeeded and reached is not None else None,
        work=motor_work(record, begun.start, end.end),
        largest_force=_largest_force(record, drive, end),
        drives=_drives(record, begun, end),
        held=holds[transition.state] if released else None,
        sprung_back=None if released else _readings_at_release(record, transition),
    )


def _drives(record: Record, begun: StageEnd, end: StageEnd) -> tuple[str, ...]:
    """Return the names of the drives of the stages from one to another, in the order of their first use."""
    stages = record.stages[record.stages.index(begun) : record.stages.index(end) + 1]
    return tuple(dict.fromkeys(name for driven in stages for name in stage_drives(driven.stage)))


def _readings_at_release(record: Record, transition: Transition) -> tuple[float, float] | None:
    """Return the readings furthest from a transition's goal before and after a release that ends in no named state."""
    names, number = record.structure.stage_states, transition.stage
    after = (number or 0) + 1
    if (
        number is None
        or not ended_without_divergence(record, after)
        or names[after]
        or stage_drives(record.stages[after].stage)
    ):
        return None
    before, later = (
        stage_end_state(record, record.stages[stage], transition.state).furthest for stage in (number, after)
    )
    return None if before is None or later is None else (before, later)


def _largest_force(record: Record, drive: Drive, end: StageEnd) -> float | None:
    """Return the largest total force on the points that a drive displaces in a stage, N; None if it displaces none."""
    if "motor_force" not in record.series:
        return None
    motors = zip(record.structure.motors, drive.shares, strict=True)
    displaced = [motor.kind == "displacement" and share != 0 for motor, share in motors]
    during = (record.time > end.start) & (record.time <= end.end)
    forces = record.series["motor_force"][during][:, displaced].sum(axis=1)
    return float(max(forces, key=abs)) if any(displaced) and len(forces) else None


def motor_work(record: Record, start: float, end: float) -> float:
    """Return the work of the motors between two times, J."""
    before, after = (int(np.argmin(np.abs(record.time - moment))) for moment in (start, end))
    work = record.series["motor_work"]
    return sum((float(last - first) for first, last in zip(work[before], work[after], strict=True)), 0.0)
