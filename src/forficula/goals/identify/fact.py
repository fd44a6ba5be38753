"""Facts: what was observed, in general terms, and what it is to be."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal

from forficula.goals.identify.row_quantity import Combination
from forficula.quantities import Unit
from forficula.study.factors import Factor

# of states, which hold under some conditions and not under others
COUNTS = ("count", "all", "none", "any")
# of numbers
NUMBERS = ("least", "largest", "mean")
# of numbers: under which condition they are least or largest
PLACES = ("least at", "largest at")
Statistic = Literal["count", "all", "none", "any", "least", "largest", "mean", "least at", "largest at"]
Order = Literal["equals", "at least", "at most"]


@dataclass(frozen=True, kw_only=True)
class LeastValue:
    """A value that grows until a state is reached.

    Attributes:
        key: of the design, such as "protocol.fold_torque".
        values: that are tried, rising, as a design file has them.
        numbers: the same in SI.
        unit: of them.
        state: that is to be reached.
        monotone: whether what reaches it with one value is taken to reach it with all larger ones; if so, few are
            tried.
    """

    key: str
    values: tuple[object, ...]
    numbers: tuple[float, ...]
    unit: Unit
    state: str
    monotone: bool


@dataclass(frozen=True, kw_only=True)
class Term:
    """A statistic of a quantity of runs over a grid of conditions.

    Attributes:
        quantity: of each run; empty for the least value itself.
        statistic: over all conditions.
        over: the grid; none for a single run.
        settings: values of every condition, by key, as a design file has them.
        until: name of the transition with whose stage runs end; None for the whole protocol.
        where: state without which a run does not count; None where all count.
        least: value that is looked for under every condition; None where there is none, and the protocol's own count.
        rising: keys of `over` along which the state, once it holds, is taken to go on holding.
        falling: keys of `over` along which it is so the other way.
        absent: number of a condition that has none, SI; None of states.
        unit: of the statistic; None of counts.
    """

    quantity: Combination
    statistic: Statistic
    over: tuple[Factor, ...]
    settings: Mapping[str, object]
    until: str | None
    where: str | None
    least: LeastValue | None
    rising: tuple[str, ...] = ()
    falling: tuple[str, ...] = ()
    absent: float | None = None
    unit: Unit | None = None

    @property
    def shape(self) -> tuple[int, ...]:
        """How many values each factor of the grid has."""
        return tuple(len(factor.values) for factor in self.over)

    @cached_property
    def conditions_by_point(self) -> Mapping[tuple[int, ...], Mapping[str, object]]:
        """The values of every point of the grid by the numbers of its factors' values, the last factor fastest."""
        keys = [factor.key for factor in self.over]
        points = itertools.product(*(factor.values for factor in self.over))
        numbers = itertools.product(*map(range, self.shape))
        return {
            number: {**self.settings, **dict(zip(keys, point, strict=True))}
            for number, point in zip(numbers, points, strict=True)
        }

    @property
    def staircase(self) -> bool:
        """Whether the state is found by its boundary, and not under every condition."""
        return bool(self.rising or self.falling)


@dataclass(frozen=True, kw_only=True)
class Fact:
    """Something that was observed.

    Attributes:
        name: short, of its own.
        source: who says so, and where.
        term: what is observed.
        order: how it is to stand to the bound.
        bound: number, SI, or another term.
        places: where the quantity is to be least or largest: allowed values by key of the grid; empty otherwise.
        tolerance: by how much it may be missed, in the term's unit, SI.
        scale: of the distance; None for that of the samples' own spread.
    """

    name: str
    source: str
    term: Term
    order: Order
    bound: float | Term
    tolerance: float
    scale: float | None = None
    places: Mapping[str, tuple[object, ...]] = field(default_factory=dict)

    @property
    def terms(self) -> tuple[Term, ...]:
        """All that must be observed."""
        return (self.term, self.bound) if isinstance(self.bound, Term) else (self.term,)
