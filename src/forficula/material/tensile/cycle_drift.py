"""How cycles change, over several specimens."""

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
    """One cycle, medians over the specimens that have it; nan where no specimen has the value.

    Attributes:
        number: of the cycle in its test, from 1.
        specimens: how many have it.
        secant_modulus: stress over strain at the largest strain, Pa.
        loss: J/m3.
        residual_strain: where the unloading comes to zero stress.
        slack_strain: below which the unloading carries no force.
        onset_strain: above which the loading carries force.
        largest_strain: at the turn above.
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
    """By how much a cycle differs from the one before; nan where a value stands in fewer than two cycles.

    Of each specimen the slope over the number of the cycle, the median of those of all pairs of cycles (Theil 1950, Sen
    1968); then the median over specimens.

    Attributes:
        specimens: how many have two cycles or more.
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
    """What each cycle is, over specimens.

    Args:
        specimens: the cycles of each, as `find_cycles` gives them.

    Returns:
        One entry for each number of a cycle that some specimen has, in order.

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
    """By how much cycles change from one to the next, over specimens.

    Args:
        specimens: the cycles of each, as `find_cycles` gives them.
    """
    drifting = [cycles for cycles in specimens if len(cycles) > 1]
    return CycleDrift(
        specimens=len(drifting),
        **{name: _median([_slope(cycles, value) for cycles in drifting]) for name, value in _QUANTITIES.items()},
    )


def _slope(cycles: Sequence[Cycle], value: Callable[[Cycle], float]) -> float:
    """Theil and Sen's, per cycle; nan where fewer than two cycles have the value."""
    numbers = np.array([cycle.number for cycle in cycles], dtype=np.float64)
    values = np.array([value(cycle) for cycle in cycles])
    first, second = np.triu_indices(len(cycles), k=1)
    return _median(((values[second] - values[first]) / (numbers[second] - numbers[first])).tolist())


def _median(values: Sequence[float]) -> float:
    """Of the values that are there; nan where none is."""
    there = [value for value in values if value == value]
    return float(np.median(there)) if there else float("nan")
