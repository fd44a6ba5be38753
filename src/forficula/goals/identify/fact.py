"""Facts: observations in general terms, and the requirements on them."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal

from forficula.goals.identify.row_quantity import Combination
from forficula.quantities import Unit
from forficula.study.factors import Factor

# statistics of states, which are reached under some conditions and not under others
COUNTS = ("count", "all", "none", "any")
# statistics of numbers
NUMBERS = ("least", "largest", "mean")
# statistics of numbers: the condition under which they are least or largest
PLACES = ("least at", "largest at")
Statistic = Literal["count", "all", "none", "any", "least", "largest", "mean", "least at", "largest at"]
Order = Literal["equals", "at least", "at most"]


@dataclass(frozen=True, kw_only=True)
class LeastValue:
    """A value that grows until a state is reached.

    Attributes:
        key: key of the design, such as "protocol.fold_torque".
        values: values to try, rising, as in a design file.
        numbers: the same in SI.
        unit: unit of the values.
        state: state that must be reached.
        monotone: whether the state is assumed to be reached with all larger values, too; then only a few values are
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
        quantity: name of the quantity of each run; empty for the least value itself.
        statistic: statistic over all conditions.
        over: the grid; empty for a single run.
        settings: values under every condition, by key, as in a design file.
        until: name of the transition after whose stage runs end; None for the whole protocol.
        where: state that a run must reach to count; None if all runs count.
        least: value that is searched for under every condition; None to run the protocol unchanged.
        rising: keys of `over` along which larger values are assumed to reach the state, too.
        falling: keys of `over` along which smaller values are assumed to reach the state, too.
        absent: number for a condition without a value, SI; None for states.
        unit: unit of the statistic; None for counts.
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
        """Number of values of each factor of the grid."""
        return tuple(len(factor.values) for factor in self.over)

    @cached_property
    def conditions_by_point(self) -> Mapping[tuple[int, ...], Mapping[str, object]]:
        """Values of every point of the grid by the indices of its factors' values, the last factor fastest."""
        keys = [factor.key for factor in self.over]
        points = itertools.product(*(factor.values for factor in self.over))
        numbers = itertools.product(*map(range, self.shape))
        return {
            number: {**self.settings, **dict(zip(keys, point, strict=True))}
            for number, point in zip(numbers, points, strict=True)
        }

    @property
    def staircase(self) -> bool:
        """Whether only the boundary of the state is searched, instead of running every condition."""
        return bool(self.rising or self.falling)


@dataclass(frozen=True, kw_only=True)
class Fact:
    """An observation and the requirement on it.

    Attributes:
        name: short and unique.
        source: source of the observation.
        term: the observed quantity.
        order: relation to the bound.
        bound: number, SI, or another term.
        places: conditions at which the quantity must be least or largest: allowed values by key of the grid; else
            empty.
        tolerance: allowed deviation, in the term's unit, SI.
        scale: scale of the deviation; None for the spread of the samples.
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
        """All terms that must be observed."""
        return (self.term, self.bound) if isinstance(self.bound, Term) else (self.term,)
