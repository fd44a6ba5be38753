"""Confirmation of a run: comparison of its verdict and numbers with second runs that differ only numerically."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Annotated

import numpy as np
from numpy.typing import ArrayLike

from forficula.analysis.verdict import Ending, Verdict
from forficula.arrays import Array
from forficula.dynamics import NumericalCheck
from forficula.names import listed
from forficula.quantities import show_value
from forficula.serial import Key, Seconds, Written

HALF_STEP = "half the timestep"
OTHER_START = "a slightly different start"
DOUBLE_PRECISION = "double precision"
_PREPOSITIONS = {OTHER_START: "from", DOUBLE_PRECISION: "in"}
# share of a value; a larger difference between two timesteps means that the value has not converged
SETTLED_WITHIN = 0.02

Values = Mapping[str, tuple[float, ...]]
StateValues = Mapping[str, Array]


@dataclass(frozen=True, kw_only=True)
class Confirmation:
    """How a run compares with second runs of the same design.

    Attributes:
        checks: the second runs.
        agree: whether all of them have the same outcome as the run, see `same_ending`.
        uncertainty: by name, the numerical uncertainty of times, s, works and energies, J, lengths, m, and readings,
            rad or m, each with the shape of its value; see `uncertainties`.
        unsettled: names of the times and works whose uncertainty exceeds 2 % of the value.
        values: of the run, by name, SI.
        timestep: of the run, s.
    """

    agree: Annotated[bool, Key("confirmed")]
    checks: tuple[NumericalCheck, ...]
    uncertainty: Annotated[Values, Written.NEVER]
    unsettled: tuple[str, ...]
    values: Annotated[Values, Written.NEVER] = field(repr=False)
    timestep: Annotated[Seconds, Written.NEVER]

    def of(self, name: str, place: int = 0) -> float | None:
        """Return the numerical uncertainty of a value, SI; None where the second runs do not have the value."""
        uncertainty = self.uncertainty.get(name)
        return None if uncertainty is None else uncertainty[place]

    def of_state(self, state: str, numbers: Callable[[StateValues], ArrayLike]) -> Array | None:
        """Return the numerical uncertainties of numbers that are computed from the values of a state, SI.

        The numbers are computed for the run and for every second run, and are then compared as in `uncertainties`.

        Args:
            state: its name.
            numbers: computes the numbers from the values of the state, which are those of `State.values`.

        Returns:
            As many as the numbers; None where the run or a second run does not have the values.
        """
        runs = [_values_of(state, values) for values in (self.values, *(check.values for check in self.checks))]
        try:
            first, *others = (np.asarray(numbers(values), dtype=np.float64) for values in runs)
        except KeyError:
            return None
        if not others or any(other.shape != first.shape for other in others):
            return None
        return _largest_difference(first, self.timestep, zip(self.checks, others, strict=True))


def confirm(ending: Ending, values: Values, timestep: float, checks: Sequence[NumericalCheck]) -> Confirmation:
    """Compare a run with second runs of the same design.

    Args:
        ending: of the run.
        values: of the run, by name, SI.
        timestep: of the run, s.
        checks: the second runs.
    """
    agree = all(same_ending(ending, check) for check in checks)
    uncertainty = uncertainties(values, timestep, checks)
    unsettled = tuple(
        name
        for name, halves in uncertainty.items()
        if name.endswith((".time", ".work"))
        and any(half > SETTLED_WITHIN * abs(value) for half, value in zip(halves, values[name], strict=True))
    )
    return Confirmation(
        checks=tuple(checks),
        agree=agree,
        uncertainty=uncertainty,
        unsettled=unsettled,
        values=values,
        timestep=timestep,
    )


def same_ending(ending: Ending, check: NumericalCheck) -> bool:
    """Return whether a second run has the same outcome.

    A run that still moves at the time limit and one that rests by then count as the same outcome, because both missed
    the goal within the time limit and may differ only in the decay of a creep.
    """
    return (_outcome_of(ending.verdict), ending.goal) == (_outcome_of(Verdict(check.verdict)), check.goal)


def _outcome_of(verdict: Verdict) -> Verdict:
    return Verdict.STUCK if verdict is Verdict.MOVING else verdict


def uncertainties(values: Values, timestep: float, checks: Sequence[NumericalCheck]) -> dict[str, tuple[float, ...]]:
    """Estimate the numerical uncertainty of values from second runs.

    Semi-implicit Euler is of first order, so a value is v(h) = v(0) + C h and its distance from the limit h -> 0 is
    |v(h) - v(h')| h / |h - h'| with a second timestep h' (Richardson extrapolation): twice the difference to a run at
    half the timestep, once the difference to a run at twice the timestep. The difference to a run with the same
    timestep from another start counts once. The largest counts. A time is known to one timestep at best.

    Args:
        values: of the run, by name, SI.
        timestep: of the run, s.
        checks: the second runs; only values that all of them have are compared.

    Returns:
        Uncertainties by name, with the shapes of the values.
    """
    result = {}
    for name, value in values.items():
        if not checks or not all(len(check.values.get(name, ())) == len(value) for check in checks):
            continue
        others = ((check, np.array(check.values[name])) for check in checks)
        least = timestep if name.endswith(".time") else 0.0
        result[name] = tuple(_largest_difference(np.array(value), timestep, others, least).tolist())
    return result


def _largest_difference(
    values: Array, timestep: float, others: Iterable[tuple[NumericalCheck, Array]], least: float = 0.0
) -> Array:
    """Return the largest differences between numbers of a run and of second runs, as `uncertainties` weighs them.

    Args:
        values: numbers of the run.
        timestep: of the run, s.
        others: second runs and the same numbers of each.
        least: the smallest difference that is returned.
    """
    halves = np.full(values.shape, least)
    for check, other in others:
        apart = abs(check.timestep - timestep)
        factor = timestep / apart if apart > 1e-9 * timestep else 1.0
        halves = np.fmax(halves, factor * np.abs(values - other))
    return halves


def _values_of(state: str, values: Values) -> dict[str, Array]:
    """Return the values of a state by their names in it."""
    prefix = f"{state}."
    return {name.removeprefix(prefix): np.array(numbers) for name, numbers in values.items() if name.startswith(prefix)}


def confirmation_text(ending: Ending, confirmation: Confirmation) -> str:
    """Return the result of the second runs as a clause: that they confirm the verdict, or their own outcomes.

    The runs at longer timesteps in the search for an automatic timestep are not called a confirmation.
    """
    names = [f"{_PREPOSITIONS.get(check.name, 'at')} {check.name}" for check in confirmation.checks]
    if confirmation.agree:
        confirms = any(check.name in (HALF_STEP, OTHER_START, DOUBLE_PRECISION) for check in confirmation.checks)
        return f"{'confirmed' if confirms else 'the search of the timestep found the same'} {listed(names)}"
    others = [
        f"{check.status} {name}"
        for name, check in zip(names, confirmation.checks, strict=True)
        if not same_ending(ending, check)
    ]
    return listed(others)


def undecided_text(status: str, timestep: float, ending: Ending, confirmation: Confirmation) -> str:
    """Return both outcomes of a run whose second runs disagree, as a clause.

    Args:
        status: of the run alone.
        timestep: of the run, s.
        ending: of the run alone.
        confirmation: comparison of the run with its second runs.
    """
    return f"{status} at {show_value(timestep, 's')}, but {confirmation_text(ending, confirmation)}"


def undecided(ending: Ending, why: str) -> Ending:
    """Return the ending of a run whose second runs disagree."""
    return Ending(verdict=Verdict.UNDECIDED, transition=ending.transition, residual=ending.residual, why=why)
