"""Study: a design, its factors, and what to compute at every point."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from forficula.design import Design
from forficula.displayed import Displayed
from forficula.study.factors import Factor
from forficula.study.search_steps import Search


@dataclass(frozen=True, kw_only=True)
class Study(Displayed):
    """Many runs of one design.

    Attributes:
        name: name in outputs.
        source: source of the values.
        base: the design that is varied.
        factors: what is varied.
        points: values of every point by dotted key, as in a design file. Other keys have the value of the base.
        sampled: whether the points were sampled. Otherwise they are the grid of all factors; the last varies fastest.
        search: values to try in searches for least values; None to run the protocol unchanged.
        choices: if factors are varied one at a time, the changed value of each choice, by key; the first choice is
            empty (the base). Otherwise empty.
        grid: factors whose whole grid is repeated at every choice; the last varies fastest.
        reproduces: name of the paper with which the results are compared; None for no paper.
    """

    name: str
    source: str
    base: Design
    factors: tuple[Factor, ...]
    points: tuple[Mapping[str, object], ...]
    sampled: bool
    search: Search | None
    choices: tuple[Mapping[str, object], ...] = ()
    grid: tuple[Factor, ...] = ()
    reproduces: str | None = None

    def __repr__(self) -> str:
        """Return the number of points and the varied keys."""
        keys = ", ".join(factor.key for factor in (*self.factors, *self.grid))
        return f"<Study {self.name}: {len(self.points)} points of {self.base.name} over {keys}>"
