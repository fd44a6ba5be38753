"""Search for the numerical settings of a run that a design leaves open: the timestep, and the compliance of contact."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from forficula.analysis import Outcome, Verdict
from forficula.analysis.confirmation import same_ending
from forficula.analysis.verdict import UNSETTLED
from forficula.design import Design
from forficula.design.contact import FIRST_TIME_CONSTANT
from forficula.dynamics import (
    SLIGHT_OVERLAP,
    ContactRun,
    NumericalCheck,
    Record,
    contact_timestep,
    resolving_time_constant,
    with_timestep,
)
from forficula.quantities import show_value
from forficula.study.running.second_runs import check_of, with_step

# Allowed relative difference of times between two timesteps; the shorter one is used.
_TIME_TOLERANCE = 0.02
# Number of successive timesteps that must agree. It is smaller for sheets of nodes, because their bars require a
# timestep far below the one that resolves their folding.
_AGREEING, _OF_NODES = 3, 2
# Largest number of times that a timestep is halved.
_HALVINGS = 8
# Order at which the energy residual decreases with the timestep: between linear and quadratic.
_RESIDUAL_ORDER = 1.3
# [chosen] largest number of runs with shorter and shorter time constants of contact after the first one
_STIFFENINGS = 4
# [chosen] overlap at which a shorter time constant of contact aims: less than a slight one, because it is an estimate
_AIM = 0.07
# tolerance of rounding of a timestep that resolves contacts
_ROUNDING = 1e-9


@dataclass(frozen=True, kw_only=True)
class Attempt:
    """A design with numerical settings, and its outcomes with other ones.

    Attributes:
        number: number of the design.
        design: design with the timestep, s, and the time constant of contact, s; before the first attempt the timestep
            may be "auto".
        halvings: number of times the first timestep was halved; None if the design sets the timestep.
        before: timesteps, s, and outcomes of at most two earlier attempts.
        agreeing: number of timesteps that must agree.
        expected: expected time by the time of the previous attempt, s; 0 if unknown.
        contact_runs: earlier runs with longer time constants of contact; None if the design sets the time constant.
    """

    number: int
    design: Design
    halvings: int | None
    before: tuple[tuple[float, Outcome], ...] = ()
    agreeing: int = _AGREEING
    expected: float = 0.0
    contact_runs: tuple[ContactRun, ...] | None = None


def finds_settings(design: Design) -> bool:
    """Return whether a run finds the timestep, or the time constant of contact, of a design."""
    return design.protocol.timestep == "auto" or design.with_contact_time(FIRST_TIME_CONSTANT) is not design


def first_attempt(number: int, design: Design) -> Attempt:
    """Return the first attempt at a design."""
    return _attempt(number, design, FIRST_TIME_CONSTANT, ())


def _attempt(number: int, design: Design, time_constant: float, before: tuple[ContactRun, ...]) -> Attempt:
    """Return an attempt at a design with a time constant of contact, s, if the design does not set it."""
    chosen = design.with_contact_time(time_constant)
    return Attempt(
        number=number,
        design=chosen,
        halvings=0 if design.protocol.timestep == "auto" else None,
        contact_runs=None if chosen is design else before,
    )


def started(design: Design) -> Design:
    """Return the design of a first attempt with its timestep.

    A timestep "auto" starts at four times the estimated one, so that the third attempt can be the last.

    Raises:
        InputError: the design cannot be built.
    """
    estimated = with_timestep(design)
    if estimated is design:
        return design
    return with_step(estimated, 2 ** (_AGREEING - 1) * float(estimated.protocol.timestep))


def at_timestep(attempt: Attempt, timestep: float, *, of_nodes: bool) -> Attempt:
    """Return an attempt at a timestep, s, of a structure of nodes or of another one."""
    return replace(attempt, design=with_step(attempt.design, timestep), agreeing=_OF_NODES if of_nodes else _AGREEING)


def next_attempt(attempt: Attempt, design: Design, record: Record, outcome: Outcome, seconds: float) -> Attempt | None:
    """Return the next attempt, or None if this one suffices or if no further one is allowed.

    Args:
        attempt: the attempt.
        design: the design before its first attempt.
        record: of the attempt.
        outcome: of the attempt.
        seconds: computing time of the attempt, s.
    """
    # a timestep shorter than one that resolves contacts does not keep parts apart whose contact is too soft
    longest, timestep = contact_timestep(record.structure), float(attempt.design.protocol.timestep)
    if timestep <= (1 + _ROUNDING) * longest:
        stiffer = _stiffer(attempt, design, record, seconds)
        if stiffer is not None or record.overlaps:
            return stiffer
    elif attempt.contact_runs is not None and attempt.halvings is None and _touched(record):
        resolved = _resolved(attempt.design, longest)
        return replace(attempt, design=resolved, expected=seconds * timestep / float(resolved.protocol.timestep))
    return _following(attempt, outcome, longest, seconds)


def _stiffer(attempt: Attempt, design: Design, record: Record, seconds: float) -> Attempt | None:
    """Return an attempt with a shorter time constant of contact if parts overlap deeply; None if none is needed."""
    contact, runs = record.structure.contact, known_runs(attempt, record)
    overlap = (runs[-1].overlap if runs else None) or 0.0
    if contact is None or len(runs) > _STIFFENINGS or not overlap > SLIGHT_OVERLAP:
        return None
    exact = resolving_time_constant(contact, overlap, _AIM)
    digit = 10.0 ** (math.floor(math.log10(exact)) - 1)
    time_constant = float(f"{math.floor(exact / digit) * digit:.1e}")
    shorter = time_constant / contact.stops.time_constant
    longest = contact_timestep(record.structure) * shorter
    if longest < (design.protocol.shortest_timestep or 0.0):
        return None
    following = _attempt(attempt.number, design, time_constant, runs)
    if following.halvings is None:
        following = replace(following, design=_resolved(following.design, longest))
    return replace(following, expected=seconds / shorter)


def _touched(record: Record) -> bool:
    """Return whether contacts acted in a run, parts passed through each other within a step, or the run diverged."""
    overlap = record.series.get("contact_overlap", np.zeros(1))
    return bool(np.any(record.series["contact_work"]) or np.any(overlap > 0))


def _resolved(design: Design, longest: float) -> Design:
    """Return a design whose timestep is divided by the smallest whole number that makes it at most the longest, s."""
    timestep = float(design.protocol.timestep)
    return with_step(design, timestep / math.ceil(timestep / longest - _ROUNDING))


def known_runs(attempt: Attempt, record: Record) -> tuple[ContactRun, ...]:
    """Return the runs by which the time constant of contact was derived, with this one; none if the design sets it."""
    contact = record.structure.contact
    if attempt.contact_runs is None or contact is None:
        return ()
    this = ContactRun(
        time_constant=contact.stops.time_constant,
        timestep=float(attempt.design.protocol.timestep),
        overlap=float(record.series["contact_overlap"][-1]) if "contact_overlap" in record.series else None,
    )
    return (*attempt.contact_runs, this)


def _following(attempt: Attempt, outcome: Outcome, resolving: float, seconds: float) -> Attempt | None:
    """Return the next attempt, or None if this one suffices or if no further one is allowed.

    The residual shows how short a timestep must be only at timesteps that resolve contacts, up to `resolving`, s.
    """
    if attempt.halvings is None or attempt.halvings >= _HALVINGS:
        return None
    halvings, present = 1, float(attempt.design.protocol.timestep)
    residual, limit = outcome.ending.residual, attempt.design.protocol.residual_limit
    if outcome.verdict is Verdict.UNTRUSTED and residual is not None and math.isfinite(residual):
        halvings = max(1, round(math.log2(residual / limit) / _RESIDUAL_ORDER))
        if present > resolving:
            halvings = min(halvings, math.ceil(math.log2(present / resolving)))
    elif len(attempt.before) >= attempt.agreeing - 1 and all(_agree(earlier, outcome) for _, earlier in attempt.before):
        return None
    total = min(attempt.halvings + halvings, _HALVINGS)
    timestep = present / 2 ** (total - attempt.halvings)
    if timestep < (attempt.design.protocol.shortest_timestep or 0.0):
        return None
    return replace(
        attempt,
        design=with_step(attempt.design, timestep),
        halvings=total,
        before=(*attempt.before, (present, outcome))[1 - attempt.agreeing :],
        expected=seconds * present / timestep,
    )


def attempt_doubt(attempt: Attempt, outcome: Outcome) -> str:
    """Return why a run at the shortest timestep is unreliable, apart from its residual; usually empty."""
    if not outcome.verdict.conclusive or not attempt.before:
        return ""
    conclusive = [earlier for _, earlier in attempt.before if earlier.verdict.conclusive]
    return "" if all(_same_ending(earlier, outcome) for earlier in conclusive) else UNSETTLED


def coarser_checks(attempt: Attempt, outcome: Outcome) -> tuple[NumericalCheck, ...]:
    """Return the runs at longer timesteps with which the last was compared; none if the design sets the timestep."""
    last = float(attempt.design.protocol.timestep)
    return tuple(
        check_of(f"{show_value(timestep, 's')} instead of {show_value(last, 's')}", timestep, before)
        for timestep, before in attempt.before
        if outcome.verdict.conclusive and before.verdict.conclusive
    )


def _agree(before: Outcome, after: Outcome) -> bool:
    """Return whether a reliable run has the same ending at two timesteps, at about the same times."""
    pairs = [(before.transitions[name], after.transitions[name]) for name in after.transitions]
    times = [(a.time, b.time) for a, b in pairs if a is not None and b is not None]
    near = all(a is b or (a and b and abs(a - b) <= _TIME_TOLERANCE * b) for a, b in times)
    return after.verdict.conclusive and _same_ending(before, after) and near


def _same_ending(before: Outcome, after: Outcome) -> bool:
    return same_ending(after.ending, check_of("", 0.0, before))
