"""By how much a design meets a goal, or how far short of it it comes: finite whatever happened."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from forficula.analysis.margin import chained_row
from forficula.design import Design
from forficula.goals.assessor import value_of
from forficula.goals.goal import Goal
from forficula.goals.limit import Limit
from forficula.structure import Transition
from forficula.study.journal import Row

# what a run does, beside the limits
WORKS = "works"


@dataclass(frozen=True, kw_only=True)
class Margins:
    """Margins of a design, each in [-1, 1], > 0 or 0 where met.

    Attributes:
        works: that of what its protocol asks for, all transitions together; 1 where no run is asked for.
        limits: by limit, in the goal's order, but for that on a probability.
    """

    works: float
    limits: tuple[float, ...]

    @property
    def least(self) -> float:
        """The one that decides."""
        return min([self.works, *self.limits])

    @property
    def meets(self) -> bool:
        """Whether it works and no limit is missed."""
        return self.works > 0 and all(margin >= 0 for margin in self.limits)


def own_limits(goal: Goal) -> tuple[Limit, ...]:
    """The limits that a design meets or misses by itself, whatever its neighbours do."""
    return tuple(each for each in goal.limits if each.quantity.source != "neighbours")


def margins_of(goal: Goal, row: Row, design: Design | str, transitions: Sequence[Transition]) -> Margins:
    """The margins of a design by its row.

    Args:
        goal: what is asked.
        row: with all that the goal's sources tell.
        design: or why there is none.
        transitions: of the goal's base.
    """
    if isinstance(design, str):
        return Margins(works=-1.0, limits=tuple(-1.0 for _ in own_limits(goal)))
    return Margins(
        works=chained_row(row, transitions) if goal.simulate else 1.0,
        limits=tuple(each.margin(value_of(row, each.quantity, design)) for each in own_limits(goal)),
    )
