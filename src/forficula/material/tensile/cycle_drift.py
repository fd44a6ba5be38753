"""Medians of cycles, and their change from cycle to cycle, over several specimens."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from forficula.errors import InputError
from forficula.material.tensile.cycles import Cycle
from forficula.quantities import Unit
from forficula.serial import JoulesPerCubicMetre, Key, Pascals, Written

_PerCycle = Annotated[float, Unit("1/cycle")]
_QUANTITIES: dict[str, Callable[[Cycle], float]] = {
    "secant_modulus": lambda cycle: cycle.secant_modulus,
    "loss": lambda cycle: cycle.loss,
    "residual_strain": lambda cycle: cycle.residual_strain,
    "slack_strain": lambda cycle: cycle.slack_strain,
    "onset_strain": lambda cycle: cycle.onset_strain,
    "largest_strain": lambda cycle: cycle.largest_strain,
}


@dataclass(frozen=True, kw_only=True)
class CycleMedians:
    """Medians of one cycle over the specimens that have it; nan if no specimen has the value.

    Attributes:
        number: number of the cycle in its test, from 1.
        specimens: number of specimens with this cycle.
        secant_modulus: stress divided by strain at the largest strain, Pa.
        loss: energy loss, J/m3.
        residual_strain: strain at which the unloading reaches zero stress.
        slack_strain: strain below which the unloading carries no force.
        onset_strain: strain above which the loading carries force.
        largest_strain: strain at the upper turning point.
    """

    number: Annotated[int, Key("cycle")]
    specimens: int
    secant_modulus: Pascals
    loss: JoulesPerCubicMetre
    residual_strain: float
    slack_strain: float
    onset_strain: float
    largest_strain: float


@dataclass(frozen=True, kw_only=True)
class CycleDrift:
    """Change from one cycle to the next; nan for a value that fewer than two cycles have.

    For each specimen, the change is the median of the slopes of all pairs of cycles (Theil 1950, Sen 1968). The median
    over the specimens is reported.

    Attributes:
        specimens: number of specimens with two cycles or more.
        secant_modulus: Pa per cycle.
        loss: J/m3 per cycle.
        residual_strain: per cycle.
        slack_strain: per cycle.
        onset_strain: per cycle.
        largest_strain: per cycle.
    """

    specimens: Annotated[int, Written.NEVER]
    secant_modulus: Annotated[float, Unit("Pa/cycle")]
    loss: Annotated[float, Unit("J/m^3/cycle")]
    residual_strain: _PerCycle
    slack_strain: _PerCycle
    onset_strain: _PerCycle
    largest_strain: _PerCycle


def cycle_medians(specimens: Sequence[Sequence[Cycle]]) -> tuple[CycleMedians, ...]:
    """Compute medians of each cycle over specimens.

    Args:
        specimens: cycles of each specimen, as `find_cycles` returns them.

    Returns:
        One entry for each number of a cycle, in order.

    Raises:
        InputError: there is no cycle.
    """
    by_number: dict[int, list[Cycle]] = {}
    for cycle in (cycle for cycles in specimens for cycle in cycles):
        by_number.setdefault(cycle.number, []).append(cycle)
    if not by_number:
        raise InputError("need the cycles of at least one specimen, got none")
    return tuple(
        CycleMedians(
            number=number,
            specimens=len(cycles),
            **{name: _median([value(cycle) for cycle in cycles]) for name, value in _QUANTITIES.items()},
        )
        for number, cycles in sorted(by_number.items())
    )


def cycle_drift(specimens: Sequence[Sequence[Cycle]]) -> CycleDrift:
    """Compute the change from one cycle to the next, over specimens.

    Args:
        specimens: cycles of each specimen, as `find_cycles` returns them.
    """
    drifting = [cycles for cycles in specimens if len(cycles) > 1]
    return CycleDrift(
        specimens=len(drifting),
        **{name: _median([_slope(cycles, value) for cycles in drifting]) for name, value in _QUANTITIES.items()},
    )


def _slope(cycles: Sequence[Cycle], value: Callable[[Cycle], float]) -> float:
    """Compute the Theil-Sen slope per cycle; nan if fewer than two cycles have the value."""
    numbers = np.array([cycle.number for cycle in cycles], dtype=np.float64)
    values = np.array([value(cycle) for cycle in cycles])
    first, second = np.triu_indices(len(cycles), k=1)
    return _median(((values[second] - values[first]) / (numbers[second] - numbers[first])).tolist())


def _median(values: Sequence[float]) -> float:
    """Compute the median of the values that are not nan; nan if there are none."""
    known = [value for value in values if value == value]
    return float(np.median(known)) if known else float("nan")
