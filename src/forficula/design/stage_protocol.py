"""States and transitions that the stages of a protocol name."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from forficula.design.named_protocol import RestState, Transition, Wording
from forficula.design.protocol import GoalText, StageSection, read_goal, stage_drives
from forficula.names import listed


def is_bound(stage: StageSection) -> bool:
    """Return whether a stage ends at a goal on measures, not at a time or at rest."""
    return stage.until not in ("time", "rest")


def stage_transitions(
    stages: Sequence[StageSection], distances: Sequence[str], bound: Callable[[str], GoalText | None] = read_goal
) -> tuple[Transition, ...]:
    """Return a transition for every driven stage that ends at bounds and leads to a state.

    A stage that drives for a given time has the goal of the first stage without drives after it that ends at bounds.

    Args:
        stages: stages of a protocol.
        distances: names of the measures that are distances.
        bound: function that returns the bound of a goal's text; None for the goal that every crease is at its target.
    """
    transitions: list[Transition] = []
    for number, stage in enumerate(stages):
        ends = _goal_stage(stages, number)
        state = None if ends is None else _state_after(stages, ends)
        if ends is None or state is None:
            continue
        until = stages[ends].until
        written = bound(until)
        measure = "creases" if written is None else written.name
        transitions.append(
            Transition(
                name=stage.name,
                drive=" and ".join(stage_drives(stage)),
                stage=number,
                ends=None if ends == number else ends,
                goal=until,
                state=state,
                released=until,
                measure=measure,
                kind="distance" if measure in distances else "angle",
                furthest="smallest" if written is None or written.relation == ">" else "largest",
                begun=None,
                wording=_wording(state, listed([*(transition.state for transition in transitions), state])),
            )
        )
    return tuple(transitions)


def rest_states(stages: Sequence[StageSection]) -> tuple[RestState, ...]:
    """Return the states at the ends of stages; the goal of each is that of the last driven stage, or "time".

    The goal of a stage that drives for a given time is that of `stage_transitions`.
    """
    states: list[RestState] = []
    goal, last = "time", ""
    for number, stage in enumerate(stages):
        if stage_drives(stage):
            ends = _goal_stage(stages, number)
            goal, last = stage.until if ends is None else stages[ends].until, stage.name
        if stage.state is not None:
            states.append(
                RestState(
                    name=stage.state,
                    goal=goal,
                    missed=f"not {stage.state}",
                    unknown=f'after stage "{last or stage.name}"',
                )
            )
    return tuple(states)


def _goal_stage(stages: Sequence[StageSection], number: int) -> int | None:
    """Return the number of the stage that ends at the goal of a driven stage; None without such a goal."""
    stage = stages[number]
    if not stage_drives(stage):
        return None
    if is_bound(stage) or stage.until != "time":
        return number if is_bound(stage) else None
    for later in range(number + 1, len(stages)):
        if stage_drives(stages[later]):
            return None
        if is_bound(stages[later]):
            return later
    return None


def _state_after(stages: Sequence[StageSection], number: int) -> str | None:
    """Return the state that a driven stage leads to: its own, or the first of the stages without drives after it."""
    for stage in stages[number:]:
        if stage is not stages[number] and stage_drives(stage):
            return None
        if stage.state is not None:
            return stage.state
    return None


def _wording(state: str, done: str) -> Wording:
    """Return the words for the transition to a state."""
    return Wording(
        done=done,
        verb=f"get {state}",
        doing=f"getting {state}",
        stays=state,
        time=f"time to get {state}",
        noun=f"getting {state}",
        did=f"got {state}",
    )
