"""By how much a run did what its protocol asks for, or how far short of it it came: finite whatever happened."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from forficula.analysis.outcome import Outcome, State
from forficula.dynamics import Record
from forficula.structure import StageGoal, Transition, goal_coordinates, goal_of, short_of

# what failed never looks as if it had just worked
_LEAST_SHORT = 1e-3
NOT_TRIED = -1.0


def transition_margins(record: Record, outcome: Outcome) -> dict[str, float]:
    """By how much every transition was made, from 1, at once, over 0, only just, to -1, not at all.

    Of a transition that was made it is the share of its stage's time limit that was left, for what is about to stick
    takes ever longer; of one that was not, less the share of its way that was missing at the end, or of the way back
    that was lost on release. One that was not tried, and every one of a run that says nothing, has -1.

    Args:
        record: of a run; rows at the ends of its stages are enough.
        outcome: what it came to.

    Returns:
        By name, without a unit, in [-1, 1].
    """
    return {each.name: _margin(record, outcome, each) for each in record.structure.transitions}


def chained(margins: Sequence[float]) -> float:
    """One margin of transitions that follow one another: how far along all of them a run came.

    Where all were made, the least; else the first that was not counts, and each after it as not tried, so that every
    transition that is made brings the mean nearer to 0.

    Args:
        margins: of the transitions in their order; 1 of none.
    """
    if all(margin > 0 for margin in margins):
        return min(margins, default=1.0)
    first = next(number for number, margin in enumerate(margins) if margin <= 0)
    return (margins[first] + NOT_TRIED * (len(margins) - first - 1)) / len(margins)


def _margin(record: Record, outcome: Outcome, transition: Transition) -> float:
    made, state = outcome.transitions[transition.name], outcome.states[transition.state]
    if not outcome.verdict.tells or made is None or state is None or transition.stage is None:
        return NOT_TRIED
    limit = record.design.protocol.stages[transition.stage].time_limit
    if made.succeeded:
        return 1.0 if made.time is None else max(1.0 - made.time / limit, 0.0) or np.finfo(float).eps
    goal = goal_of(record.structure, transition.goal)
    reached = record.stages[transition.stage].goal_time is not None
    return -_share_short(record, transition, state, goal_of(record.structure, transition.released) if reached else goal)


def _share_short(record: Record, transition: Transition, state: State, goal: StageGoal) -> float:
    """The share of the way to a goal that is missing where a run ended, in (0, 1]."""
    assert transition.stage is not None
    row = int(np.argmin(np.abs(record.time - record.stages[transition.stage].start)))
    distances = record.series.get("distance")
    start = goal_coordinates(
        record.structure,
        record.series["hinge_angle"][row : row + 1],
        None if distances is None else distances[row : row + 1],
    )[0]
    way, left = short_of(start, goal), short_of(state.coordinates, goal)
    share = left / way if way > 0 else 1.0
    return float(np.clip(share, _LEAST_SHORT, 1.0))


def margin_column(name: str) -> str:
    """What rows call the margin of a transition."""
    return f"{name}_margin"


def chained_row(row: Mapping[str, object], transitions: Sequence[Transition]) -> float:
    """The margin of all transitions that a row of a study tells of."""
    return chained([float(str(row.get(margin_column(each.name), NOT_TRIED))) for each in transitions])
