"""Whether the best designs lie at bounds that their goal set."""

from __future__ import annotations

from forficula.goals.goal import Goal
from forficula.goals.optimise.candidate import Candidate
from forficula.goals.parameter import Parameter

# of the way from bound to bound: no further from one it lies there
_NEAR = 1e-3


def bounded_text(goal: Goal, best: Candidate) -> str | None:
    """That a design lies at bounds of what may vary, in a sentence; None where it lies between all of them."""
    ends = [
        f"{parameter.key} at its {end}"
        for parameter, share in zip(goal.parameters, best.point, strict=True)
        if (end := _end(parameter, share))
    ]
    if not ends:
        return None
    return f"the best lies at the edge of what may vary, {' and '.join(ends)}: further on there may be better ones"


def _end(parameter: Parameter, share: float) -> str:
    """Which end of its range a share lies at; empty where at none, or where its values have no order."""
    if not parameter.ordered:
        return ""
    near = max(_NEAR, 1 / len(parameter.choices)) if parameter.choices else _NEAR
    return "lowest" if share < near else "highest" if share > 1 - near else ""
