"""Study: a design, factors, and what is asked of every point."""

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
        name: what outputs call it.
        source: where the question comes from.
        base: the design that is varied.
        factors: what is varied.
        points: the values of every point by dotted key, as a design file has them; what is not there is the base's.
        sampled: whether the points were drawn; otherwise they are the grid of all factors, the last fastest.
        search: the values to try for the least ones; None runs the protocol as it is.
        choices: where factors are varied one at a time, the value of one of them each, by key; the first is empty, the
            base. Otherwise none.
        grid: the factors whose whole grid is repeated at every choice, the last fastest.
        reproduces: name of the paper that its results are set beside; None for none.
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
        """How many points over what."""
        keys = ", ".join(factor.key for factor in (*self.factors, *self.grid))
        return f"<Study {self.name}: {len(self.points)} points of {self.base.name} over {keys}>"
