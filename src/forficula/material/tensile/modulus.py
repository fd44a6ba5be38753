"""Secant and local moduli in classes of strain, for loading and unloading (Binder et al. 2025, Figure 9)."""

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
_FEWEST = 5  # least number of samples in a class
_LEAST_COVER = 0.5  # share of a class that a branch must cover

Way = Literal["loading", "unloading"]
_WAYS: tuple[Way, Way] = ("loading", "unloading")


@dataclass(frozen=True, kw_only=True)
class Quartiles:
    """Quartiles of values.

    Attributes:
        lower: lower quartile.
        median: median.
        upper: upper quartile.
    """

    lower: Annotated[float, Key("lower_quartile")]
    median: float
    upper: Annotated[float, Key("upper_quartile")]


@dataclass(frozen=True, kw_only=True)
class ModulusClass:
    """Moduli in one class of strain, for loading or unloading.

    Each specimen, and each cycle if cycles are pooled, gives one value of both moduli.

    Attributes:
        cycle: number of the cycle in its test, from 1; None if cycles are pooled.
        way: loading or unloading.
        from_strain: lower edge of the class, inclusive.
        to_strain: upper edge of the class, exclusive.
        secant_modulus: stress divided by strain, Pa; a value is the median over the samples in the class.
        local_modulus: d stress / d strain, Pa; a value is the slope of a straight line through the samples in the
            class.
        values: number of values, from specimens times pooled cycles.
        points: number of samples of the machine from which the values were computed.
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
        """Number of the cycle, or "pooled"."""
        return "pooled" if self.cycle is None else self.cycle


@dataclass(frozen=True, kw_only=True)
class _Value:
    """Moduli of one branch in one class, Pa, and the number of samples."""

    secant: float
    local: float
    points: int


def moduli_by_strain(
    specimens: Sequence[Sequence[Cycle]], *, width: float = CLASS_WIDTH, pool_cycles: bool = False
) -> tuple[ModulusClass, ...]:
    """Compute moduli in classes of strain, for loading and unloading, over specimens.

    Strain is relative to the specimen's initial length, as in the paper, so that slack makes the secant modulus of the
    low classes small; samples at strains <= 0 are ignored. Stress is relative to the cycle's `zero_stress`. The local
    modulus is fitted by least squares over the whole class: for a curved law it is the mean of the derivative, weighted
    towards the middle of the class, and noise in n samples adds an error of sqrt(12 / n) times the noise divided by the
    width. A branch gives a value for a class if it covers at least half of the class with at least five samples.

    Args:
        specimens: cycles of each specimen, as `find_cycles` returns them.
        width: width of a class, strain, > 0.
        pool_cycles: pool the cycles of a specimen, as the paper's box plots do.

    Returns:
        One entry for each cycle, loading or unloading, and class with values, in that order.

    Raises:
        InputError: no class has values, or the width is not > 0.
    """
    if not 0 < width < np.inf:
        raise InputError(f"width: need a strain > 0, got {width:g}")
    classes: dict[tuple[int, int, int], list[_Value]] = defaultdict(list)
    for cycle in (cycle for cycles in specimens for cycle in cycles):
        for way, branch in enumerate((cycle.loading, cycle.unloading)):
            for index, value in _values(branch, cycle.zero_stress, width):
                classes[0 if pool_cycles else cycle.number, way, index].append(value)
    if not classes:
        raise InputError(f"need cycles with at least {_FEWEST} samples in half a class of {width:.0%} strain, got none")
    return tuple(_class(number, way, index, width, values) for (number, way, index), values in sorted(classes.items()))


def _class(number: int, way: int, index: int, width: float, values: Sequence[_Value]) -> ModulusClass:
    """Return the moduli of a class of strain, of the cycle with a number, or of pooled cycles for the number 0."""
    return ModulusClass(
        cycle=number or None,
        way=_WAYS[way],
        from_strain=round(index * width, 12),
        to_strain=round((index + 1) * width, 12),
        secant_modulus=_quartiles([value.secant for value in values]),
        local_modulus=_quartiles([value.local for value in values]),
        values=len(values),
        points=sum(value.points for value in values),
    )


def _values(branch: CycleBranch, zero_stress: float, width: float) -> Iterator[tuple[int, _Value]]:
    """Yield the indices of the classes that a branch covers, with its moduli."""
    indices = np.floor(branch.strain / width).astype(np.int64)
    for index in range(max(int(indices.min()), 0), int(indices.max()) + 1):
        inside = (indices == index) & (branch.strain > 0)
        strain, stress = branch.strain[inside], branch.stress[inside] - zero_stress
        if len(strain) >= _FEWEST and np.ptp(strain) >= _LEAST_COVER * width:
            secant = float(np.median(stress / strain))
            yield index, _Value(secant=secant, local=_slope(strain, stress), points=len(strain))


def _slope(strain: Array, stress: Array) -> float:
    """Compute the slope of a straight line by least squares, Pa."""
    away = strain - strain.mean()
    return float(away @ stress / (away @ away))


def _quartiles(values: Sequence[float]) -> Quartiles:
    lower, median, upper = np.quantile(values, (0.25, 0.5, 0.75))
    return Quartiles(lower=float(lower), median=float(median), upper=float(upper))
