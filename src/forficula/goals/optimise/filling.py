"""How many designs of a search fill the space, before it learns from what became of them."""

from __future__ import annotations

import math

from forficula.goals.goal import Goal
from forficula.goals.optimise.batches import filling_count
from forficula.goals.optimise.candidate import axes_of


def only_fills(goal: Goal) -> int | None:
    """How many designs fill the space of a goal where it tries no more than these, and not all there are; else None."""
    axes = axes_of(goal)
    count = filling_count(axes, goal.batch)
    places = math.prod(axis.levels for axis in axes) or math.inf
    return count if goal.runs <= count and goal.runs < places else None


def filling_text(goal: Goal) -> str | None:
    """That a goal's designs only fill the space, in a sentence; None where they do more."""
    count = only_fills(goal)
    if count is None:
        return None
    designs = "its one design does" if goal.runs == 1 else f"its {goal.runs} designs do"
    return (
        f"{designs} no more than fill the space evenly: a search that learns from them begins after {count}"
        " (search.runs)"
    )
