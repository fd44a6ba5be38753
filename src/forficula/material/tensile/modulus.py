"""Moduli by class of strain: secant and local, for loading and unloading (Binder et al. 2025, Figure 9)."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Annotated, Literal

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.material.tensile.cycles import Cycle, CycleBranch
from forficula.quantities import Unit
from forficula.serial import Key, Written

CLASS_WIDTH = 0.1  # strain, as in the paper
_FEWEST = 5  # samples in a class
_LEAST_COVER = 0.5  # share of a class that a branch must pass

Way = Literal["loading", "unloading"]
_WAYS: tuple[Way, Way] = ("loading", "unloading")


@dataclass(frozen=True, kw_only=True)
class Quartiles:
    """How values spread.

    Attributes:
        lower: a quarter of the values is below it.
        median: half of them.
        upper: three quarters.
    """

    lower: Annotated[float, Key("lower_quartile")]
    median: float
    upper: Annotated[float, Key("upper_quartile")]


@dataclass(frozen=True, kw_only=True)
class ModulusClass:
    """The moduli in one class of strain on one way of a cycle.

    Each specimen, and each cycle where cycles are pooled, gives one value of both moduli.

    Attributes:
        cycle: number of the cycle in its test, from 1; None where cycles are pooled.
        way: loading or unloading.
        from_strain: lower edge of the class, in it.
        to_strain: upper edge, not in it.
        secant_modulus: stress over strain, Pa; a value is the median over the samples in the class.
        local_modulus: d stress / d strain, Pa; a value is the slope of a straight line through the samples in the
            class.
        values: how many specimens, times pooled cycles, gave a value.
        points: how many samples of the machine are behind them.
    """

    cycle: Annotated[int | None, Written.NEVER]
    way: Way
    from_strain: float
    to_strain: float
    secant_modulus: Annotated[Quartiles, Unit("Pa")]
    local_modulus: Annotated[Quartiles, Unit("Pa")]
    values: int
    points: int

    @property
    def of_cycle(self) -> Annotated[int | Literal["pooled"], Key("cycle"), Written.FIRST]:
        """Number of the cycle, or that cycles are pooled."""
        return "pooled" if self.cycle is None else self.cycle


@dataclass(frozen=True, kw_only=True)
class _Value:
    """What one branch gives in one class: moduli in Pa, and how many samples."""

    secant: float
    local: float
    points: int


def moduli_by_strain(
    specimens: Sequence[Sequence[Cycle]], *, width: float = CLASS_WIDTH, pool_cycles: bool = False
) -> tuple[ModulusClass, ...]:
    """Moduli in classes of strain, for loading and unloading, over specimens.

    Strain counts from the specimen's first length, as in the paper, so that slack makes the secant modulus of the low
    classes small; samples at strains <= 0 are left out. Stress counts from the cycle's `zero_stress`. The local modulus
    is by least squares over the whole class: of a curved law it is the mean of the derivative, weighted towards the
    middle of the class, and noise of n samples adds an error of sqrt(12 / n) times noise over width. A branch gives a
    value to a class if it passes at least half of it with at least five samples.

    Args:
        specimens: the cycles of each, as `find_cycles` gives them.
        width: of a class, strain, > 0.
        pool_cycles: put the cycles of a specimen together, as the paper's box plots do.

    Returns:
        One entry for each cycle, way and class that has values, in that order.

    Raises:
        InputError: no class has values, or the width is not > 0.
    """
    if not 0 < width < np.inf:
        raise InputError(f"width: need a strain > 0, got {width:g}")
    found: dict[tuple[int, int, int], list[_Value]] = defaultdict(list)
    for cycle in (cycle for cycles in specimens for cycle in cycles):
        for way, branch in enumerate((cycle.loading, cycle.unloading)):
            for place, value in _values(branch, cycle.zero_stress, width):
                found[0 if pool_cycles else cycle.number, way, place].append(value)
    if not found:
        raise InputError(f"need cycles with at least {_FEWEST} samples in half a class of {width:.0%} strain, got none")
    return tuple(_class(number, way, place, width, values) for (number, way, place), values in sorted(found.items()))


def _class(number: int, way: int, place: int, width: float, values: Sequence[_Value]) -> ModulusClass:
    """Of the cycle of that number, or of all for 0."""
    return ModulusClass(
        cycle=number or None,
        way=_WAYS[way],
        from_strain=round(place * width, 12),
        to_strain=round((place + 1) * width, 12),
        secant_modulus=_quartiles([value.secant for value in values]),
        local_modulus=_quartiles([value.local for value in values]),
        values=len(values),
        points=sum(value.points for value in values),
    )


def _values(branch: CycleBranch, zero_stress: float, width: float) -> Iterator[tuple[int, _Value]]:
    """The classes that a branch passes, and its moduli there."""
    places = np.floor(branch.strain / width).astype(np.int64)
    for place in range(max(int(places.min()), 0), int(places.max()) + 1):
        inside = (places == place) & (branch.strain > 0)
        strain, stress = branch.strain[inside], branch.stress[inside] - zero_stress
        if len(strain) >= _FEWEST and np.ptp(strain) >= _LEAST_COVER * width:
            secant = float(np.median(stress / strain))
            yield place, _Value(secant=secant, local=_slope(strain, stress), points=len(strain))


def _slope(strain: Array, stress: Array) -> float:
    """Of the straight line by least squares, Pa."""
    away = strain - strain.mean()
    return float(away @ stress / (away @ away))


def _quartiles(values: Sequence[float]) -> Quartiles:
    lower, median, upper = np.quantile(values, (0.25, 0.5, 0.75))
    return Quartiles(lower=float(lower), median=float(median), upper=float(upper))
