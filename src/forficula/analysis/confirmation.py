"""Confirmation of a run: verdict and numbers held against second runs in which only the computation differs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from forficula.analysis.verdict import Ending, Verdict
from forficula.dynamics import Check
from forficula.names import listed
from forficula.quantities import show_value

HALF_STEP = "half the timestep"
OTHER_START = "a slightly different start"
# of a value: what differs by more between two timesteps has not settled
SETTLED_WITHIN = 0.02

Values = Mapping[str, tuple[float, ...]]


@dataclass(frozen=True, kw_only=True)
class Confirmation:
    """How a run compares with second runs of the same design.

    Attributes:
        checks: the second runs.
        agree: whether all of them say the same of the structure as the run, see `same_ending`.
        uncertainty: numerical uncertainty of times, s, works and energies, J, and readings, rad or m, by name, with as
            many entries as each has; see `uncertainties`.
        unsettled: names of the values whose uncertainty exceeds 2 % of the value.
    """

    checks: tuple[Check, ...]
    agree: bool
    uncertainty: Values
    unsettled: tuple[str, ...]

    def of(self, name: str, place: int = 0) -> float | None:
        """Return the numerical uncertainty of a value, SI; None where the second runs do not have the value."""
        found = self.uncertainty.get(name)
        return None if found is None else found[place]


def confirm(ending: Ending, values: Values, timestep: float, checks: Sequence[Check]) -> Confirmation:
    """Compare a run with second runs of the same design.

    Args:
        ending: of the run.
        values: of the run, by name, SI.
        timestep: of the run, s.
        checks: the second runs.
    """
    agree = all(same_ending(ending, check) for check in checks)
    sure = uncertainties(values, timestep, checks)
    unsettled = tuple(
        name
        for name, each in sure.items()
        if name.endswith((".time", ".work"))
        and any(half > SETTLED_WITHIN * abs(value) for half, value in zip(each, values[name], strict=True))
    )
    return Confirmation(checks=tuple(checks), agree=agree, uncertainty=sure, unsettled=unsettled)


def same_ending(ending: Ending, check: Check) -> bool:
    """Return whether a second run says the same of the structure.

    A run that still moves when its time is over and one that rests by then both fall short of the goal within the time
    limit; how slowly the last of a creep dies away is no difference between outcomes.
    """
    return (_outcome_of(ending.verdict), ending.goal) == (_outcome_of(Verdict(check.verdict)), check.goal)


def _outcome_of(verdict: Verdict) -> Verdict:
    return Verdict.STUCK if verdict is Verdict.MOVING else verdict


def uncertainties(values: Values, timestep: float, checks: Sequence[Check]) -> dict[str, tuple[float, ...]]:
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
        By name, as long as the values.
    """
    found = {}
    for name, own in values.items():
        if not checks or not all(len(check.values.get(name, ())) == len(own) for check in checks):
            continue
        halves = [timestep if name.endswith(".time") else 0.0] * len(own)
        for check in checks:
            apart = abs(check.timestep - timestep)
            factor = timestep / apart if apart > 1e-9 * timestep else 1.0
            halves = [
                max(half, factor * abs(one - other))
                for half, one, other in zip(halves, own, check.values[name], strict=True)
            ]
        found[name] = tuple(halves)
    return found


def confirmation_text(ending: Ending, confirmation: Confirmation) -> str:
    """Return what the second runs say of the verdict, as a clause."""
    names = [f"{'from' if check.name == OTHER_START else 'at'} {check.name}" for check in confirmation.checks]
    if confirmation.agree:
        return f"confirmed {listed(names)}"
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
        confirmation: of it.
    """
    return f"{status} at {show_value(timestep, 's')}, but {confirmation_text(ending, confirmation)}"


def undecided(ending: Ending, why: str) -> Ending:
    """Return the ending of a run whose second runs disagree."""
    return Ending(verdict=Verdict.UNDECIDED, transition=ending.transition, residual=ending.residual, why=why)
