"""Goal: what a structure must do, what may vary, and its manufacturing tolerances."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from forficula.design import Design
from forficula.displayed import Displayed
from forficula.goals.deviation import Deviation
from forficula.goals.limit import Limit
from forficula.goals.outcome_quantity import SOURCES, OutcomeQuantity, Source
from forficula.goals.parameter import Parameter
from forficula.study.search_steps import Search


@dataclass(frozen=True, kw_only=True)
class Objective:
    """A quantity to minimise or maximise.

    Attributes:
        quantity: the quantity.
        kind: "least" or "largest".
    """

    quantity: OutcomeQuantity
    kind: Literal["least", "largest"]

    def cost(self, value: float) -> float:
        """Return the number to minimise for a value in SI."""
        return value if self.kind == "least" else -value


@dataclass(frozen=True, kw_only=True)
class Goal(Displayed):
    """Requirements for a design, and what may vary to meet them.

    Attributes:
        name: name in outputs.
        source: source of the goal.
        base: the design that is varied, with the settings of the goal and the torques of `given`.
        parameters: what may vary.
        limits: limits on quantities, including the probability of working within tolerances.
        torque_limits: upper limits on least torques. They become the torques of the protocol: a design that works with
            these torques needs no larger ones.
        objectives: one, or two or three, which give a Pareto front.
        deviations: manufacturing tolerances; empty if the structure is built exactly as designed.
        simulate: whether a run must reach the goals of the protocol. Otherwise only statics is computed.
        search: search for least values if a limit or objective needs one, else None.
        runs: largest number of designs to try.
        batch: number of designs that run side by side.
        neighbours: number of variants within the tolerances that are run for one design.
        seed: seed of the random numbers.
    """

    name: str
    source: str
    base: Design
    parameters: tuple[Parameter, ...]
    limits: tuple[Limit, ...]
    torque_limits: tuple[Limit, ...]
    objectives: tuple[Objective, ...]
    deviations: tuple[Deviation, ...]
    simulate: bool
    search: Search | None
    runs: int
    batch: int
    neighbours: int
    seed: int

    def __repr__(self) -> str:
        """Return the objectives, the design and the varied keys."""
        aims = ", ".join(f"{objective.kind} {objective.quantity.name}" for objective in self.objectives)
        keys = ", ".join(parameter.key for parameter in self.parameters)
        return f"<Goal {self.name}: {aims} of {self.base.name} over {keys}>"

    @property
    def quantities(self) -> tuple[OutcomeQuantity, ...]:
        """All quantities of limits and objectives, without repetition."""
        quantities = [*(limit.quantity for limit in self.limits), *(aim.quantity for aim in self.objectives)]
        return tuple({quantity.name: quantity for quantity in quantities}.values())

    @property
    def sources(self) -> tuple[Source, ...]:
        """Sources of these quantities, the cheapest first."""
        needed = {quantity.source for quantity in self.quantities} | ({"run"} if self.simulate else set())
        return tuple(source for source in SOURCES if source in needed)

    def values(self, shares: Sequence[float]) -> Mapping[str, object]:
        """Return the values of a design by key, at a fraction of the range of each parameter."""
        return {parameter.key: parameter.value(share) for parameter, share in zip(self.parameters, shares, strict=True)}


def own_limits(goal: Goal) -> tuple[Limit, ...]:
    """Return the limits that a design meets or misses by itself, independent of variants within its tolerances."""
    return tuple(limit for limit in goal.limits if limit.quantity.source != "neighbours")
