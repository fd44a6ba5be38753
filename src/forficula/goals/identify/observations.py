"""Observations: a design, its unknown values, and facts."""

from __future__ import annotations

from dataclasses import dataclass

from forficula.design import Design
from forficula.displayed import Displayed
from forficula.goals.identify.fact import Fact
from forficula.names import counted
from forficula.study.factors import Factor


@dataclass(frozen=True, kw_only=True)
class Observations(Displayed):
    """Facts about a design with unknown values.

    Attributes:
        name: name in outputs.
        source: source of the facts.
        base: the design, with all known values.
        priors: the unknowns, each with a distribution, or with equally likely values.
        facts: the observations.
        samples: number of samples from the priors.
        directed: number of further samples, placed to refute that facts exclude one another.
        seed: seed of the random numbers.
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
        """Return the numbers of facts and unknowns."""
        return (
            f"<Observations {self.name}: {counted(len(self.facts), 'fact')} on"
            f" {counted(len(self.priors), 'unknown value')} of {self.base.name}>"
        )
