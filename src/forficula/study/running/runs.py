"""Designs through their protocols, with timesteps that their results bear out where these are left open."""

from __future__ import annotations

import math
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from forficula.analysis import Outcome, Verdict, measure
from forficula.analysis.confirmation import HALF_STEP, OTHER_START, same_ending
from forficula.analysis.outcome import outcome_values
from forficula.analysis.verdict import UNSETTLED
from forficula.design import Design, put
from forficula.dynamics import (
    Model,
    NumericalCheck,
    Record,
    but_last_drive,
    compile_model,
    design_in_model_units,
    simulate_each,
    with_timestep,
)
from forficula.dynamics.stepping.simulate import Progress
from forficula.errors import InputError
from forficula.quantities import show_duration, show_value
from forficula.structure import Structure, drive_keys, structure_of, with_protocol

# By how much of themselves times may differ between two timesteps of which the finer one is taken.
_TIME_TOLERANCE = 0.02
# How many timesteps, one after the other, must agree; of sheets of nodes, whose bars ask for a step far below what
# resolves their folding, fewer.
_AGREEING, _OF_NODES = 3, 2
# How often a timestep is halved before it is given up.
_HALVINGS = 8
# What is missing of the energy falls with the timestep between in proportion and with its square.
_RESIDUAL_ORDER = 1.3
# An attempt that takes longer is announced with its time, s.
_LONG = 60.0
# How long models are built before the first of them run, s; twice as long each time, for many side by side are faster.
_FIRST_SECONDS = 1.0


@dataclass(frozen=True, kw_only=True)
class _Attempt:
    """A design at a timestep, and what it came to at longer ones.

    Attributes:
        number: of the design.
        design: with the timestep, s, but for "auto" before the first attempt.
        halvings: by which it is shorter than the first one; None where the design gives it.
        before: timesteps, s, and outcomes of the attempts before, the last two at most.
        agreeing: how many timesteps must agree.
        expected: how long it may take by the time of the attempt before, s; 0 where that is not known.
    """

    number: int
    design: Design
    halvings: int | None
    before: tuple[tuple[float, Outcome], ...] = ()
    agreeing: int = _AGREEING
    expected: float = 0.0


def run(design: Design, progress: Progress | None = None, *, confirm: bool = False) -> Record:
    """Take one structure through its protocol.

    A timestep "auto" is found by halving, from what the stiffest mode allows on, until at three of them (two of sheets
    of nodes), one after the other, the energy balance misses no more than `protocol.residual_limit`, the verdict is the
    same, and no transition's time is off that of the last by more than 2 %. The record is that of the last one, and its
    design has it.

    Args:
        design: what to build and what to do with it.
        progress: called now and then with the stage's name, the time so far and the longest it can take, s.
        confirm: whether to run the design also at half the timestep and from a slightly different start, side by side.
            With a timestep "auto" the run before the last takes the place of the one at half the timestep.

    Returns:
        What happened, sampled at the protocol's interval.

    Raises:
        InputError: it cannot be built.
    """
    others = _second_designs(design) if confirm and design.protocol.timestep != "auto" else {}
    runs = dict(run_each([design, *others.values()], progress=progress))
    record = runs[0]
    if isinstance(record, InputError):
        raise record
    if confirm and design.protocol.timestep == "auto":
        other = record.design.with_other_start()
        others = {} if other is None else {OTHER_START: other}
        runs |= {number + 1: each for number, each in run_each([*others.values()], progress=progress)}
    return with_checks(record, {name: runs[number] for number, name in enumerate(others, start=1)})


def _second_designs(design: Design) -> dict[str, Design]:
    """Return the designs of the second runs that confirm one with a given timestep, by what differs."""
    half, other = half_step(design), design.with_other_start()
    return {HALF_STEP: half} | ({} if other is None else {OTHER_START: other})


def half_step(design: Design) -> Design:
    """Return the design with half its timestep."""
    return _with_step(design, float(design.protocol.timestep) / 2)


def with_checks(record: Record, others: Mapping[str, Record | InputError]) -> Record:
    """Return a record with the outcomes of second runs of its design, by what differs; those not built are left out."""
    checks = [_check(name, each) for name, each in others.items() if isinstance(each, Record)]
    return replace(record, checks=(*record.checks, *checks))


def _check(name: str, record: Record) -> NumericalCheck:
    return check_of(name, float(record.design.protocol.timestep), measure(record))


def check_of(name: str, timestep: float, outcome: Outcome) -> NumericalCheck:
    """Return what a record keeps of a second run at a timestep, s."""
    return NumericalCheck(
        name=name,
        timestep=timestep,
        verdict=outcome.verdict.value,
        goal=outcome.ending.goal,
        status=outcome.status,
        holds=dict(outcome.holds),
        values=outcome_values(outcome) if outcome.verdict.tells else {},
    )


def resolved(design: Design) -> Design:
    """The design with the timestep that a run of it takes.

    Raises:
        InputError: it cannot be built.
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
    until_last: bool = False,
    progress: Progress | None = None,
) -> Iterator[tuple[int, Record | InputError]]:
    """Do as `run` does with many designs side by side, and hand on every one's number and record as it is done.

    What becomes of a design does not depend on the others, on their order, or on threads.

    Args:
        designs: what to run.
        threads: 0 for one a core.
        sparse: keep only what an outcome needs, see `simulate`.
        until_last: whether to try designs that only the strength of their last transition's drive tells apart one
            after another, as they come, until one does it; the rest of them get no records.
        progress: as of `run`.

    Returns:
        Records, or why a design cannot be built.
    """
    attempts = [
        _Attempt(number=number, design=design, halvings=0 if design.protocol.timestep == "auto" else None)
        for number, design in enumerate(designs)
    ]
    while attempts:
        start = time.perf_counter()
        left = {attempt.number: attempt for attempt in attempts}
        for attempt, result in _results(attempts, threads, sparse, until_last, progress):
            if left.pop(attempt.number, None) is None:  # a lesser value has done it meanwhile
                continue
            if isinstance(result, InputError):
                yield attempt.number, result
                continue
            outcome = measure(result)
            following = _following(attempt, outcome)
            if following is not None:
                steps = float(attempt.design.protocol.timestep) / float(following.design.protocol.timestep)
                expected = steps * (time.perf_counter() - start)
                left[attempt.number] = replace(following, expected=expected)
                continue
            doubt = _doubt(attempt, outcome)
            yield attempt.number, replace(result, doubt=doubt, checks=_coarser(attempt, outcome))
            structure = result.structure
            if until_last and _last_holds(outcome, structure) and not doubt:
                chain = but_last_drive(designs[attempt.number], structure)
                left = {
                    number: each
                    for number, each in left.items()
                    if number < attempt.number or but_last_drive(designs[number], structure) != chain
                }
        attempts = [left[number] for number in sorted(left)]


def topology(model: Model) -> tuple[int, ...]:
    """What models of one batch have in common: sizes, how often creases are followed, which hinges have motors."""
    engine = model.engine
    sizes = (engine.nq, engine.nv, engine.nu, engine.nbody, engine.ngeom, engine.ntendon, engine.nflexvert)
    driven = tuple(hinge for motor in model.structure.motors for hinge in motor.hinges)
    medium = model.drag is not None
    return (*sizes, engine.neq, engine.nactuator, engine.na, engine.nplastic, model.followed, medium, *driven)


def _results(
    attempts: Sequence[_Attempt], threads: int, sparse: bool, until_last: bool, progress: Progress | None
) -> Iterator[tuple[_Attempt, Record | InputError]]:
    """Build models and simulate them, the first ones soon and more of them side by side each time."""
    by_engine: dict[str, list[_Attempt]] = {}
    for attempt in attempts:
        by_engine.setdefault(_engine_key(attempt.design), []).append(attempt)
    built: list[tuple[_Attempt, Model]] = []
    seconds, start = _FIRST_SECONDS, time.perf_counter()
    for alike in by_engine.values():
        model = _compile(alike[0].design)
        for attempt in alike:
            try:
                built.append(_with_protocol(model, attempt))
            except InputError as error:
                yield attempt, error
        if time.perf_counter() - start > seconds:
            yield from _simulated(built, threads, sparse, until_last, progress)
            seconds, start, built = 2 * seconds, time.perf_counter(), []
    yield from _simulated(built, threads, sparse, until_last, progress)


def _simulated(
    built: Sequence[tuple[_Attempt, Model]],
    threads: int,
    sparse: bool,
    until_last: bool,
    progress: Progress | None,
) -> Iterator[tuple[_Attempt, Record | InputError]]:
    """Simulate models, those of one topology side by side; in halves where memory does not hold them."""
    groups: dict[tuple[int, ...], list[tuple[_Attempt, Model]]] = {}
    for attempt, model in built:
        groups.setdefault(topology(model), []).append((attempt, model))
    enough = _did_last if until_last else None
    for group in groups.values():
        telling = None if progress is None else _with_timestep_told(progress, group[0][0])
        done: set[int] = set()
        try:
            for row, record in simulate_each([model for _, model in group], threads, sparse, telling, enough):
                done.add(row)
                yield group[row][0], record
        except InputError as error:
            if len(group) == 1:
                yield group[0][0], error
                continue
            rest = [each for row, each in enumerate(group) if row not in done]
            for half in (rest[: len(rest) // 2], rest[len(rest) // 2 :]):
                yield from _simulated(half, threads, sparse, until_last, progress)


def _following(attempt: _Attempt, outcome: Outcome) -> _Attempt | None:
    """The next attempt where this one does not do, or None where it does or there is no other."""
    if attempt.halvings is None or attempt.halvings >= _HALVINGS:
        return None
    halvings = 1
    residual, limit = outcome.ending.residual, attempt.design.protocol.residual_limit
    if outcome.verdict is Verdict.UNTRUSTED and residual is not None and math.isfinite(residual):
        halvings = max(1, round(math.log2(residual / limit) / _RESIDUAL_ORDER))
    elif len(attempt.before) >= attempt.agreeing - 1 and all(_agree(each, outcome) for _, each in attempt.before):
        return None
    total = min(attempt.halvings + halvings, _HALVINGS)
    timestep = float(attempt.design.protocol.timestep) / 2 ** (total - attempt.halvings)
    if timestep < (attempt.design.protocol.shortest_timestep or 0.0):
        return None
    return _Attempt(
        number=attempt.number,
        design=_with_step(attempt.design, timestep),
        halvings=total,
        before=(*attempt.before, (float(attempt.design.protocol.timestep), outcome))[1 - attempt.agreeing :],
        agreeing=attempt.agreeing,
    )


def _with_step(design: Design, timestep: float) -> Design:
    """The design with a timestep, s."""
    return design.model_copy(update={"protocol": design.protocol.model_copy(update={"timestep": timestep})})


def _doubt(attempt: _Attempt, outcome: Outcome) -> str:
    """Why a run at the last timestep that is tried is not to be trusted, beside its residual; mostly nothing."""
    if not outcome.verdict.tells or not attempt.before:
        return ""
    told = [each for _, each in attempt.before if each.verdict.tells]
    return "" if all(_same_ending(each, outcome) for each in told) else UNSETTLED


def _coarser(attempt: _Attempt, outcome: Outcome) -> tuple[NumericalCheck, ...]:
    """The runs at longer timesteps that a search for one compared with the last; none where the step is given."""
    own = float(attempt.design.protocol.timestep)
    return tuple(
        check_of(f"{show_value(timestep, 's')} instead of {show_value(own, 's')}", timestep, before)
        for timestep, before in attempt.before
        if outcome.verdict.tells and before.verdict.tells
    )


def _agree(before: Outcome, after: Outcome) -> bool:
    """Whether a run that is to be trusted came to the same at two timesteps, at about the same times."""
    pairs = [(before.transitions[name], after.transitions[name]) for name in after.transitions]
    times = [(a.time, b.time) for a, b in pairs if a is not None and b is not None]
    near = all(a is b or (a and b and abs(a - b) <= _TIME_TOLERANCE * b) for a, b in times)
    return after.verdict.tells and _same_ending(before, after) and near


def _same_ending(before: Outcome, after: Outcome) -> bool:
    return same_ending(after.ending, check_of("", 0.0, before))


def _last_holds(outcome: Outcome, structure: Structure) -> bool:
    """Whether the last transition reached its state."""
    return bool(structure.transitions and outcome.holds[structure.transitions[-1].state])


def _did_last(record: Record) -> bool:
    return _last_holds(measure(record), record.structure)


def _engine_key(design: Design) -> str:
    """What names an engine model: all but what is done to the structure."""
    parted = put(design, "protocol.stages", ())
    # the estimate of a timestep minds torques where tendons damp more than in proportion to their speed
    if design.protocol.timestep != "auto" or not _damps_nonlinearly(design):
        for key in drive_keys(design):
            parted = put(parted, key, 0.0)
    return parted.hash


def _damps_nonlinearly(design: Design) -> bool:
    try:
        tendons = structure_of(design).tendons
    except InputError:  # whoever compiles it says why
        return True
    return any(any((tendon.law.damping or ())[1:]) for tendon in tendons)


def _compile(design: Design) -> Model | InputError:
    """A model, or why there is none.

    With four times the estimated timestep where that is left open, so that the third attempt can do.
    """
    try:
        guessed = with_timestep(design)
        if guessed is not design:
            guessed = _with_step(guessed, 2 ** (_AGREEING - 1) * float(guessed.protocol.timestep))
        return compile_model(guessed)
    except InputError as error:
        return error


def _with_protocol(model: Model | InputError, attempt: _Attempt) -> tuple[_Attempt, Model]:
    """An attempt at the timestep of a model, and that model with its protocol, the engine model shared.

    Raises:
        InputError: there is no model, or its protocol is too large or small for it.
    """
    if isinstance(model, InputError):
        raise model
    design = _with_step(attempt.design, float(model.design.protocol.timestep))
    agreeing = _AGREEING if model.creases is None else _OF_NODES
    return replace(attempt, design=design, agreeing=agreeing), replace(
        model,
        design=design,
        structure=with_protocol(model.structure, design),
        in_units=with_protocol(model.in_units, design_in_model_units(design, model.units)),
    )


def _with_timestep_told(progress: Progress, attempt: _Attempt) -> Progress:
    """Say at which timestep a run is, where it is being looked for."""
    if attempt.halvings is None:
        return progress
    told = f"timestep {show_value(float(attempt.design.protocol.timestep), 's')}"
    if attempt.expected > _LONG:
        told += f" (about {show_duration(attempt.expected)}; protocol.shortest_timestep limits the search)"
    return lambda stage, time, longest: progress(f"{stage}, {told}", time, longest)
