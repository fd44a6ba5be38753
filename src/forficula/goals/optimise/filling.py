"""How many designs of a search fill the space, before it learns from what became of them."""

from __future__ import annotations

import math
from collections.abc import Sequence

from forficula.goals.goal import Goal
from forficula.goals.optimise.axis import Axis
from forficula.goals.optimise.candidate import axes_of

# trials before parabolas are of use, an axis, and at least: those of `batches`
_AN_AXIS, _LEAST = 4, 32


def filling_count(axes: Sequence[Axis], batch: int) -> int:
    """How many points fill the space evenly before a search looks closer anywhere, in whole batches.

    Args:
        axes: of the search.
        batch: points at a time.
    """
    return batch * math.ceil(max(_LEAST, _AN_AXIS * len(axes), batch) / batch)


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
