"""Goal: what a structure must do, what may vary, and how far off it may be built."""

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
    """What is to be as small or as large as can be.

    Attributes:
        quantity: which.
        kind: "least" or "largest".
    """

    quantity: OutcomeQuantity
    kind: Literal["least", "largest"]

    def cost(self, value: float) -> float:
        """What is to be small, of a value in SI."""
        return value if self.kind == "least" else -value


@dataclass(frozen=True, kw_only=True)
class Goal(Displayed):
    """What is asked of a design.

    Attributes:
        name: what outputs call it.
        source: where the question comes from.
        base: the design that is varied, with the settings of the goal, and the torques of `given`.
        parameters: what may vary.
        limits: on quantities; on the share of what is built that works among them.
        given: upper limits on least torques, which are the protocol's torques: what works with these needs no more.
        objectives: one, or two or three, which give a front.
        deviations: how far off what is built may be; none where it is built as designed.
        simulate: whether a design must do what its protocol asks for in a run; otherwise statics alone is asked.
        search: of the least values, where an objective is about one; else None.
        runs: how many designs are tried at most.
        batch: how many of them side by side.
        neighbours: how many designs within the tolerances are tried of one.
        seed: of the random numbers.
    """

    name: str
    source: str
    base: Design
    parameters: tuple[Parameter, ...]
    limits: tuple[Limit, ...]
    given: tuple[Limit, ...]
    objectives: tuple[Objective, ...]
    deviations: tuple[Deviation, ...]
    simulate: bool
    search: Search | None
    runs: int
    batch: int
    neighbours: int
    seed: int

    def __repr__(self) -> str:
        """What is asked, over what."""
        asked = ", ".join(f"{each.kind} {each.quantity.name}" for each in self.objectives)
        keys = ", ".join(each.key for each in self.parameters)
        return f"<Goal {self.name}: {asked} of {self.base.name} over {keys}>"

    @property
    def quantities(self) -> tuple[OutcomeQuantity, ...]:
        """All that limits and objectives are about, once each."""
        every = [*(each.quantity for each in self.limits), *(each.quantity for each in self.objectives)]
        return tuple({each.name: each for each in every}.values())

    @property
    def sources(self) -> tuple[Source, ...]:
        """What it takes to know them, the cheap before the dear."""
        needed = {each.source for each in self.quantities} | ({"run"} if self.simulate else set())
        return tuple(source for source in SOURCES if source in needed)

    def values(self, shares: Sequence[float]) -> Mapping[str, object]:
        """The values of a design by key, at a share of the way of each parameter."""
        return {each.key: each.value(share) for each, share in zip(self.parameters, shares, strict=True)}


def own_limits(goal: Goal) -> tuple[Limit, ...]:
    """The limits that a design meets or misses by itself, whatever its neighbours do."""
    return tuple(each for each in goal.limits if each.quantity.source != "neighbours")
