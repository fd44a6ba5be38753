"""States and transitions that the stages of a protocol name."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from forficula.design.named_protocol import RestState, Transition, Wording
from forficula.design.protocol import GoalText, StageSection, read_goal, stage_drives


def is_bound(stage: StageSection) -> bool:
    """Return whether a stage ends at a goal on measures, not at a time or at rest."""
    return stage.until not in ("time", "rest")


def stage_transitions(
    stages: Sequence[StageSection], distances: Sequence[str], bound: Callable[[str], GoalText | None] = read_goal
) -> tuple[Transition, ...]:
    """Return a transition for every driven stage that ends at bounds and leads to a state.

    Args:
        stages: stages of a protocol.
        distances: names of the measures that are distances.
        bound: function that returns the bound of a goal's text; None for the goal that every crease is at its target.
    """
    transitions: list[Transition] = []
    for number, stage in enumerate(stages):
        state = _state_after(stages, number)
        if not stage_drives(stage) or not is_bound(stage) or state is None:
            continue
        written = bound(stage.until)
        measure = "creases" if written is None else written.name
        transitions.append(
            Transition(
                name=stage.name,
                drive=" and ".join(stage_drives(stage)),
                stage=number,
                goal=stage.until,
                state=state,
                released=stage.until,
                measure=measure,
                kind="distance" if measure in distances else "angle",
                furthest="smallest" if written is None or written.relation == ">" else "largest",
                begun=None,
                wording=_wording(state, " and ".join([*(transition.state for transition in transitions), state])),
            )
        )
    return tuple(transitions)


def rest_states(stages: Sequence[StageSection]) -> tuple[RestState, ...]:
    """Return the states at the ends of stages; the goal of each is that of the last driven stage, or "time"."""
    states: list[RestState] = []
    goal, last = "time", ""
    for stage in stages:
        if stage_drives(stage):
            goal, last = stage.until, stage.name
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


def _state_after(stages: Sequence[StageSection], number: int) -> str | None:
    """Return the state that a driven stage leads to: its own state, or that of a release that follows."""
    stage = stages[number]
    if stage.state is not None or number + 1 == len(stages) or stage_drives(stages[number + 1]):
        return stage.state
    return stages[number + 1].state


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
