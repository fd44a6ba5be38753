"""A design that a search tried, and what it came to."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from forficula.goals.assessor import value_of
from forficula.goals.goal import Goal
from forficula.goals.limit import Limit
from forficula.goals.optimise.axis import Axis, Point
from forficula.goals.optimise.neighbours import Neighbours
from forficula.goals.optimise.screening import Screened
from forficula.goals.optimise.trial import Trial
from forficula.goals.outcome_quantity import PROBABILITY, OutcomeQuantity


@dataclass(frozen=True, kw_only=True)
class Candidate:
    """A design that was tried.

    Attributes:
        point: where it lies in the unit cube of the parameters.
        values: of the parameters by key, as a design file has them.
        found: what it came to.
        neighbours: what became of those within the tolerances; None where it was not worth asking.
    """

    point: Point
    values: Mapping[str, object]
    found: Screened
    neighbours: Neighbours | None = None

    def value(self, quantity: OutcomeQuantity) -> float | None:
        """A quantity, SI; None where there is none or it was not asked."""
        if quantity.name == PROBABILITY:
            return None if self.neighbours is None else self.neighbours.share
        return value_of(self.found.row, quantity, self.found.design)


def axes_of(goal: Goal) -> tuple[Axis, ...]:
    """The axes of a goal's parameters, in their order."""
    return tuple(Axis(levels=len(each.choices), ordered=each.ordered) for each in goal.parameters)


def wanted_share(goal: Goal) -> Limit | None:
    """The least share of neighbours that is to work, if there is one."""
    wanted = [each for each in goal.limits if each.quantity.name == PROBABILITY and each.kind == ">="]
    return max(wanted, key=lambda each: each.bound, default=None)


def asks_probability(goal: Goal) -> bool:
    """Whether the probability of working is itself to be as large as can be."""
    return any(each.quantity.name == PROBABILITY for each in goal.objectives)


def costs(goal: Goal, candidate: Candidate) -> tuple[float, ...]:
    """What is to be small, an objective each; nan where one is not known."""
    found = []
    for each in goal.objectives:
        value = candidate.value(each.quantity)
        # what was not worth asking is not known to be worse than nothing
        unknown = 0.0 if each.quantity.name == PROBABILITY and candidate.found.meets else math.nan
        found.append(each.cost(unknown if value is None else value))
    return tuple(found)


def trial_of(goal: Goal, candidate: Candidate) -> Trial:
    """A candidate as the search sees it."""
    found, wanted, neighbours = candidate.found, wanted_share(goal), candidate.neighbours
    surplus = math.nan
    if wanted is not None and neighbours is not None:
        surplus = neighbours.share - wanted.bound
        if neighbours.tried < neighbours.wanted:
            # of those that were given up the first ones may have done well
            surplus = min(surplus, -1 / neighbours.wanted)
    margins = (*found.margins, found.works) if goal.simulate else found.margins
    return Trial(point=candidate.point, objectives=costs(goal, candidate), margins=margins, surplus=surplus)
