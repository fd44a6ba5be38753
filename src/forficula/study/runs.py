"""Designs through their protocols, with timesteps that their results bear out where these are left open."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from forficula.analysis import Outcome, Verdict, measure
from forficula.design import Design
from forficula.dynamics import Record, WingModel, compile_wing, design_in_model_units, simulate_each, with_timestep
from forficula.dynamics.simulate import Progress
from forficula.errors import InputError
from forficula.quantities import show_value

# By how much of themselves times may differ between two timesteps of which the finer one is taken.
_TIME_TOLERANCE = 0.02
# How often a timestep is halved before it is given up.
_HALVINGS = 7
# What is missing of the energy falls with the timestep between in proportion and with its square.
_RESIDUAL_ORDER = 1.3
_CHANGES = "its outcome still changes with the timestep"


@dataclass(frozen=True, kw_only=True)
class _Attempt:
    """A design at a timestep, and what it came to at the one before.

    Attributes:
        number: of the design.
        design: with the timestep, s.
        halvings: by which it is shorter than the first one; None where the design gives it.
        before: outcome at the timestep before, or None.
    """

    number: int
    design: Design
    halvings: int | None
    before: Outcome | None = None


def run(design: Design, progress: Progress | None = None) -> Record:
    """Take one wing through its protocol.

    A timestep "auto" is found by halving, from half of what the stiffest mode allows on, until three things hold:
    the energy balance misses no more than `protocol.residual_limit`, and between the last two timesteps the verdict is
    the same and no transition's time moves by more than 2 %. The record is that of the last one, and its design has it.

    Args:
        design: what to build and what to do with it.
        progress: called now and then with the stage's name, the time so far and the longest it can take, s.

    Returns:
        What happened, sampled at the protocol's interval.

    Raises:
        InputError: the wing cannot be built.
    """
    ((_, record),) = run_each([design], progress=progress)
    if isinstance(record, InputError):
        raise record
    return record


def resolved(design: Design) -> Design:
    """The design with the timestep that a run of it takes.

    Raises:
        InputError: the wing cannot be built.
    """
    if design.protocol.timestep != "auto":
        return design
    ((_, record),) = run_each([design], sparse=True)
    if isinstance(record, InputError):
        raise record
    return design.model_copy(update={"protocol": record.design.protocol})


def run_each(
    designs: Sequence[Design],
    threads: int = 0,
    *,
    sparse: bool = False,
    until_opened: bool = False,
    progress: Progress | None = None,
) -> Iterator[tuple[int, Record | InputError]]:
    """Do as `run` does with many designs side by side, and hand on every one's number and record as it is done.

    What becomes of a design does not depend on the others, on their order, or on threads.

    Args:
        designs: what to run.
        threads: 0 for one a core.
        sparse: keep only what an outcome needs, see `simulate`.
        until_opened: whether to try designs that only their unfold torques tell apart one after another, as they come,
            until one opens; the rest of them get no records.
        progress: as of `run`.

    Returns:
        Records, or why a design cannot be built.
    """
    attempts: list[_Attempt] = []
    engines: dict[str, WingModel | InputError] = {}
    for number, design in enumerate(designs):
        try:
            attempts.append(_first(number, design))
        except InputError as error:
            yield number, error
    while attempts:
        left = {attempt.number: attempt for attempt in attempts}
        for attempt, result in _results(attempts, engines, threads, sparse, until_opened, progress):
            del left[attempt.number]
            if isinstance(result, InputError):
                yield attempt.number, result
                continue
            outcome = measure(result)
            following = _following(attempt, outcome)
            if following is not None:
                left[attempt.number] = following
                continue
            changes = attempt.before is not None and outcome.verdict.tells and not _same_ending(attempt.before, outcome)
            yield attempt.number, replace(result, doubt=_CHANGES) if changes else result
            if until_opened and outcome.opened and not changes:
                chain = _but_unfold_torque(designs[attempt.number])
                left = {
                    number: each
                    for number, each in left.items()
                    if number < attempt.number or _but_unfold_torque(designs[number]) != chain
                }
        attempts = [left[number] for number in sorted(left)]
        engines.clear()


def _first(number: int, design: Design) -> _Attempt:
    """The first attempt: with twice the estimate where the timestep is left open, so that the second one can do."""
    guessed = with_timestep(design)
    if guessed is design:
        return _Attempt(number=number, design=design, halvings=None)
    return _Attempt(number=number, design=_with_step(guessed, 2 * float(guessed.protocol.timestep)), halvings=0)


def topology(wing: WingModel) -> tuple[int, ...]:
    """The sizes that wings of one batch have in common."""
    engine = wing.engine
    sizes = (engine.nq, engine.nv, engine.nu, engine.nbody, engine.ngeom, engine.ntendon, engine.nflexvert)
    return (*sizes, engine.nactuator, engine.na, engine.nplastic)


def _results(
    attempts: Sequence[_Attempt],
    engines: dict[str, WingModel | InputError],
    threads: int,
    sparse: bool,
    until_opened: bool,
    progress: Progress | None,
) -> Iterator[tuple[_Attempt, Record | InputError]]:
    """Simulate attempts, those of one topology side by side."""
    by_topology: dict[tuple[int, ...], list[tuple[_Attempt, WingModel]]] = {}
    for attempt in attempts:
        key = _engine_key(attempt.design)
        wing = engines[key] if key in engines else engines.setdefault(key, _compile(attempt.design))
        if isinstance(wing, InputError):
            yield attempt, wing
            continue
        built = _with_protocol(wing, attempt.design)
        by_topology.setdefault(topology(built), []).append((attempt, built))
    for group in by_topology.values():
        enough = _opened if until_opened else None
        telling = None if progress is None else _with_timestep_told(progress, group[0][0])
        for row, record in simulate_each([wing for _, wing in group], threads, sparse, telling, enough):
            yield group[row][0], record


def _following(attempt: _Attempt, outcome: Outcome) -> _Attempt | None:
    """The next attempt where this one does not do, or None where it does or there is no other."""
    if attempt.halvings is None or attempt.halvings >= _HALVINGS:
        return None
    halvings = 1
    residual, limit = outcome.ending.residual, attempt.design.protocol.residual_limit
    if outcome.verdict is Verdict.UNTRUSTED and residual is not None and math.isfinite(residual):
        halvings = max(1, round(math.log2(residual / limit) / _RESIDUAL_ORDER))
    elif outcome.verdict.tells and attempt.before is not None and _agree(attempt.before, outcome):
        return None
    total = min(attempt.halvings + halvings, _HALVINGS)
    timestep = float(attempt.design.protocol.timestep) / 2 ** (total - attempt.halvings)
    return _Attempt(number=attempt.number, design=_with_step(attempt.design, timestep), halvings=total, before=outcome)


def _with_step(design: Design, timestep: float) -> Design:
    """The design with a timestep, s."""
    return design.model_copy(update={"protocol": design.protocol.model_copy(update={"timestep": timestep})})


def _agree(before: Outcome, after: Outcome) -> bool:
    """Whether a run came to the same at two timesteps, at about the same times."""
    pairs = ((before.fold, after.fold), (before.unfold, after.unfold))
    times = [(a.time, b.time) for a, b in pairs if a is not None and b is not None]
    near = all(a is b or (a and b and abs(a - b) <= _TIME_TOLERANCE * b) for a, b in times)
    return _same_ending(before, after) and near


def _same_ending(before: Outcome, after: Outcome) -> bool:
    return (before.verdict, before.ending.goal) == (after.verdict, after.ending.goal)


def _but_unfold_torque(design: Design) -> str:
    """What names a design but for its unfold torque."""
    return design.model_copy(update={"protocol": design.protocol.model_copy(update={"unfold_torque": 0.0})}).hash


def _opened(record: Record) -> bool:
    return bool(measure(record).opened)


def _engine_key(design: Design) -> str:
    """What names an engine model: all but what is done to the wing."""
    parting = {"fold_torque": 0.0, "unfold_torque": 0.0, "stages": ()}
    return design.model_copy(update={"protocol": design.protocol.model_copy(update=parting)}).hash


def _compile(design: Design) -> WingModel | InputError:
    """A wing, or why there is none."""
    try:
        return compile_wing(design)
    except InputError as error:
        return error


def _with_protocol(wing: WingModel, design: Design) -> WingModel:
    """The same wing with another protocol, its engine model shared."""
    return replace(wing, design=design, in_units=design_in_model_units(design, wing.units))


def _with_timestep_told(progress: Progress, attempt: _Attempt) -> Progress:
    """Say at which timestep a run is, where it is being looked for."""
    if attempt.halvings is None:
        return progress
    timestep = show_value(float(attempt.design.protocol.timestep), "s")
    return lambda stage, time, longest: progress(f"{stage}, timestep {timestep}", time, longest)
