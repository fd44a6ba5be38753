"""Observations: a design, what is unknown of it, and facts."""

from __future__ import annotations

from dataclasses import dataclass

from forficula.design import Design
from forficula.displayed import Displayed
from forficula.goals.identify.fact import Fact
from forficula.names import counted
from forficula.study.factors import Factor


@dataclass(frozen=True, kw_only=True)
class Observations(Displayed):
    """What was seen of a design some of whose values are unknown.

    Attributes:
        name: what outputs call it.
        source: where the facts come from.
        base: the design, with all that is known.
        priors: the unknowns, each with a distribution, or with values that are alike in likelihood.
        facts: what was seen.
        samples: how many are drawn from the priors.
        directed: how many more are placed where they may refute that facts exclude one another.
        seed: of the random numbers.
    """

    name: str
    source: str
    base: Design
    priors: tuple[Factor, ...]
    facts: tuple[Fact, ...]
    samples: int
    directed: int
    seed: int

    def __repr__(self) -> str:
        """How many facts and unknowns of what."""
        return (
            f"<Observations {self.name}: {counted(len(self.facts), 'fact')} on"
            f" {counted(len(self.priors), 'unknown value')} of {self.base.name}>"
        )
