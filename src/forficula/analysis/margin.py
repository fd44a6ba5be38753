"""Signed success margin of a run, in [-1, 1]: finite for every run, also for one that failed or diverged."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from forficula.analysis.outcome import Outcome
from forficula.analysis.states import State
from forficula.dynamics import Record
from forficula.structure import (
    StageGoal,
    Transition,
    distance_to_goal,
    first_driven_stage,
    goal_coordinates,
    goal_of,
)

# least missing share of a failed transition, so that its margin is never 0
_LEAST_SHORT = 1e-3
NOT_TRIED = -1.0
# [chosen] size of a margin, in [-1, 1], below which a verdict is confirmed. Calibrated on 200 builds of the reference
# wing within 10 % (benchmarks/confirmation.py): the rule finds all 14 verdicts that change between 0.2 and 0.1 ms, with
# 156 repetitions.
SMALL_MARGIN = 0.05


def transition_margins(record: Record, outcome: Outcome) -> dict[str, float]:
    """Compute the signed margin of every transition: 1 at once, 0 only just, -1 not at all.

    The margin of a transition that succeeded is the share of the time limits of its stages that was left, because a
    structure that is about to stick takes ever longer. The margin of one that failed is minus the share of the way to
    its goal that was missing at the end, or, if it was lost on release, that was lost by then. A transition that was
    not tried has -1, and so have all transitions of a run without a conclusive verdict.

    Args:
        record: of a run; rows at the ends of its stages are enough.
        outcome: of the run.

    Returns:
        Dimensionless margins in [-1, 1], by name of the transition.
    """
    return {transition.name: _margin(record, outcome, transition) for transition in record.structure.transitions}


def combined_margin(margins: Sequence[float]) -> float:
    """Combine the margins of consecutive transitions into one margin.

    If all transitions succeeded, it is the least of their margins. Otherwise it is the sum of the margin of the first
    failed transition and of -1 for each transition after it, divided by the number of transitions. Every transition
    that succeeds therefore brings it nearer to 0.

    Args:
        margins: of the transitions in their order; without any, the result is 1.
    """
    if all(margin > 0 for margin in margins):
        return min(margins, default=1.0)
    first = next(number for number, margin in enumerate(margins) if margin <= 0)
    return (margins[first] + NOT_TRIED * (len(margins) - first - 1)) / len(margins)


def _margin(record: Record, outcome: Outcome, transition: Transition) -> float:
    made, state = outcome.transitions[transition.name], outcome.states[transition.state]
    if not outcome.verdict.conclusive or made is None or state is None or transition.stage is None:
        return NOT_TRIED
    stages, structure = record.design.protocol.stages, record.structure
    last = transition.stage if transition.goal_stage is None else transition.goal_stage
    if made.succeeded:
        limit = sum(stage.time_limit for stage in stages[first_driven_stage(structure, stages, transition) : last + 1])
        return 1.0 if made.time is None else max(1.0 - made.time / limit, 0.0) or np.finfo(float).eps
    reached = last < len(record.stages) and record.stages[last].goal_time is not None
    goal = goal_of(structure, transition.released if reached else transition.goal)
    final = record.stages[-1]
    if last + 1 < len(record.stages) and final.goal_time is None and not distance_to_goal(state.coordinates, goal):
        # a stage between the transition's goal and its state missed its own goal
        goal = goal_of(structure, final.stage.until)
    return -_share_short(record, transition, state, goal)


def _share_short(record: Record, transition: Transition, state: State, goal: StageGoal) -> float:
    """Return the share of the way to a goal that is missing at the end of a run, in (0, 1]."""
    assert transition.stage is not None
    row = int(np.argmin(np.abs(record.time - record.stages[transition.stage].start)))
    distances = record.series.get("distance")
    start = goal_coordinates(
        record.structure,
        record.series["hinge_angle"][row : row + 1],
        None if distances is None else distances[row : row + 1],
    )[0]
    distance, left = distance_to_goal(start, goal), distance_to_goal(state.coordinates, goal)
    share = left / distance if distance > 0 else 1.0
    return float(np.clip(share, _LEAST_SHORT, 1.0))


def margin_column(name: str) -> str:
    """Return the name of the column with the margin of a transition."""
    return f"{name}_margin"


def combined_row_margin(row: Mapping[str, object], transitions: Sequence[Transition]) -> float:
    """Return the combined margin of all transitions in a row of a study."""
    return combined_margin(
        [float(str(row.get(margin_column(transition.name), NOT_TRIED))) for transition in transitions]
    )
