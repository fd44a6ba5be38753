"""Run designs through their protocols. A timestep "auto" is determined so that the results do not depend on it."""

from __future__ import annotations

import math
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from forficula.analysis import Outcome, Verdict, measure
from forficula.analysis.confirmation import same_ending
from forficula.analysis.verdict import UNSETTLED
from forficula.design import Design, put
from forficula.dynamics import (
    Model,
    NumericalCheck,
    Record,
    TrialChains,
    batch_key,
    check_available,
    check_device,
    compile_model,
    contact_timestep,
    design_in_model_units,
    design_trial,
    simulate_each,
    tried_transition,
    with_timestep,
)
from forficula.dynamics.stepping.simulate import CertainOutcome, Progress
from forficula.errors import InputError
from forficula.quantities import show_duration, show_value
from forficula.statics.survey import check_quasi_static, stage_rest_path
from forficula.structure import Structure, drive_keys, structure_of, with_protocol
from forficula.study.running.second_runs import check_of, other_designs, second_designs, with_checks, with_step

# Allowed relative difference of times between two timesteps; the shorter one is used.
_TIME_TOLERANCE = 0.02
# Number of successive timesteps that must agree. It is smaller for sheets of nodes, because their bars require a
# timestep far below the one that resolves their folding.
_AGREEING, _OF_NODES = 3, 2
# Largest number of times that a timestep is halved.
_HALVINGS = 8
# Order at which the energy residual decreases with the timestep: between linear and quadratic.
_RESIDUAL_ORDER = 1.3
# An attempt that takes longer than this, s, is announced with its expected time.
_LONG = 60.0
# Time for building models before the first of them run, s. It doubles each time, because many side by side are faster.
_FIRST_SECONDS = 1.0


@dataclass(frozen=True, kw_only=True)
class _Attempt:
    """A design at a timestep, with its outcomes at longer ones.

    Attributes:
        number: number of the design.
        design: design with the timestep, s; before the first attempt it may be "auto".
        halvings: number of times the first timestep was halved; None if the design sets the timestep.
        before: timesteps, s, and outcomes of at most two earlier attempts.
        agreeing: number of timesteps that must agree.
        expected: expected time by the time of the previous attempt, s; 0 if unknown.
    """

    number: int
    design: Design
    halvings: int | None
    before: tuple[tuple[float, Outcome], ...] = ()
    agreeing: int = _AGREEING
    expected: float = 0.0


def run(design: Design, progress: Progress | None = None, *, confirm: bool = False) -> Record:
    """Run the protocol of one structure.

    A timestep "auto" is found by halving, starting from the longest one that the stiffest mode allows. The search ends
    when three successive timesteps (two for sheets of nodes) agree: their energy residual is at most
    `protocol.residual_limit`, their verdicts are the same, and no transition time deviates from that at the shortest
    timestep by more than 2 %. The record is that of the shortest timestep, which its design contains.

    Args:
        design: structure and protocol.
        progress: called now and then with the stage's name, the time so far and the time limit, s.
        confirm: whether to run the design also at half the timestep and from a slightly different start, side by side,
            and a design on a device also in double precision. With a timestep "auto" the last but one run replaces the
            one at half the timestep.

    Returns:
        The record, sampled at the protocol's interval.

    Raises:
        InputError: the design cannot be built.
    """
    others = second_designs(design) if confirm and design.protocol.timestep != "auto" else {}
    runs: dict[int, Record | InputError] = {}
    for number, result in run_each([design, *others.values()], progress=progress):
        if number == 0 and isinstance(result, InputError):
            raise result  # before the second runs, which may be possible
        runs[number] = result
    record = runs[0]
    assert isinstance(record, Record)
    if confirm and design.protocol.timestep == "auto":
        others = other_designs(record.design)
        runs |= {number + 1: checked for number, checked in run_each([*others.values()], progress=progress)}
    return with_checks(record, {name: runs[number] for number, name in enumerate(others, start=1)})


def resolved(design: Design) -> Design:
    """Return the design with the timestep that its run uses.

    Raises:
        InputError: the design cannot be built.
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
    certain: Mapping[int, CertainOutcome] | None = None,
) -> Iterator[tuple[int, Record | InputError]]:
    """Do the same as `run` with many designs side by side, and yield the index and record of each when it is done.

    The result of a design does not depend on the others, on their order, or on threads.

    Args:
        designs: designs to run.
        threads: number of threads; 0 for one per core.
        sparse: whether to keep only what an outcome needs, see `simulate`.
        until_last: whether to try designs that differ only in the strength of a drive one after another, in the
            given order. Designs that the result of one makes needless get no records, see `TrialChains`.
        progress: see `run`.
        certain: conditions that stop runs, by the numbers of designs, see `simulate_each`.

    Returns:
        Records, or why a design cannot be built.
    """
    for device in {design.protocol.device for design in designs} - {None}:
        check_available(str(device))
    attempts = [
        _Attempt(number=number, design=design, halvings=0 if design.protocol.timestep == "auto" else None)
        for number, design in enumerate(designs)
    ]
    options, chains = _RunOptions(threads, sparse, until_last, progress, certain or {}), None
    while attempts:
        start = time.perf_counter()
        left = {attempt.number: attempt for attempt in attempts}
        for attempt, result in _results(attempts, options):
            if left.pop(attempt.number, None) is None:  # needless in the meantime
                continue
            if isinstance(result, InputError):
                yield attempt.number, result
                continue
            outcome = measure(result)
            # a timestep shorter than one that resolves contacts does not keep parts apart whose contact is too soft
            longest = contact_timestep(result.structure)
            resolves = float(attempt.design.protocol.timestep) <= longest
            following = None if result.overlaps and resolves else _following(attempt, outcome, longest)
            if following is not None:
                steps = float(attempt.design.protocol.timestep) / float(following.design.protocol.timestep)
                expected = steps * (time.perf_counter() - start)
                left[attempt.number] = replace(following, expected=expected)
                continue
            doubt = result.doubt or _doubt(attempt, outcome)
            yield attempt.number, replace(result, doubt=doubt, checks=_coarser(attempt, outcome))
            if until_last and not doubt:
                chains = chains or trial_chains(designs, result.structure)
                for number in chains.needless(attempt.number, reached=reached_goal(result)):
                    left.pop(number, None)
        attempts = [left[number] for number in sorted(left)]


def topology(model: Model) -> tuple[int | str, ...]:
    """Return what models of one batch must share: sizes, update interval of creases, hinges with motors, device."""
    engine = model.engine
    sizes = (engine.nq, engine.nv, engine.nu, engine.nbody, engine.ngeom, engine.ntendon, engine.nflexvert)
    driven = tuple(hinge for motor in model.structure.motors for hinge in motor.hinges)
    medium = model.drag is not None
    others = (engine.neq, engine.nactuator, engine.na, engine.nplastic, model.followed, medium, batch_key(model))
    creases = () if model.creases is None else (model.creases.law.slots, *model.creases.hinges.tolist())
    return (*sizes, *others, len(driven), *driven, *creases)


@dataclass(frozen=True)
class _RunOptions:
    """How designs are simulated, see `run_each`."""

    threads: int
    sparse: bool
    until_last: bool
    progress: Progress | None
    certain: Mapping[int, CertainOutcome]


def _results(attempts: Sequence[_Attempt], options: _RunOptions) -> Iterator[tuple[_Attempt, Record | InputError]]:
    """Build models and simulate them: the first ones soon, then larger batches each time."""
    by_engine: dict[str, list[_Attempt]] = {}
    for attempt in attempts:
        by_engine.setdefault(_engine_key(attempt.design), []).append(attempt)
    built: list[tuple[_Attempt, Model]] = []
    seconds, start = _FIRST_SECONDS, time.perf_counter()
    for members in by_engine.values():
        model = _compile(members[0].design)
        for attempt in members:
            try:
                built.append(_with_protocol(model, attempt))
            except InputError as error:
                yield attempt, error
        if time.perf_counter() - start > seconds:
            yield from _simulated(built, options)
            seconds, start, built = 2 * seconds, time.perf_counter(), []
    yield from _simulated(built, options)


def _simulated(
    built: Sequence[tuple[_Attempt, Model]], options: _RunOptions
) -> Iterator[tuple[_Attempt, Record | InputError]]:
    """Simulate models, those of one topology side by side. A batch that exceeds the memory is halved."""
    groups: dict[tuple[int | str, ...], list[tuple[_Attempt, Model]]] = {}
    for attempt, model in built:
        groups.setdefault(topology(model), []).append((attempt, model))
    for group in groups.values():
        done: set[int] = set()
        try:
            for row, record in simulate_each(
                [model for _, model in group],
                options.threads,
                options.sparse,
                None if options.progress is None else _with_timestep_shown(options.progress, group[0][0]),
                reached_goal if options.until_last else None,
                stage_rest_path,
                {
                    row: options.certain[attempt.number]
                    for row, (attempt, _) in enumerate(group)
                    if attempt.number in options.certain
                },
            ):
                done.add(row)
                yield group[row][0], record
        except InputError as error:
            if len(group) == 1:
                yield group[0][0], error
                continue
            rest = [member for row, member in enumerate(group) if row not in done]
            for half in (rest[: len(rest) // 2], rest[len(rest) // 2 :]):
                yield from _simulated(half, options)


def _following(attempt: _Attempt, outcome: Outcome, resolving: float) -> _Attempt | None:
    """Return the next attempt, or None if this one suffices or if no further one is allowed.

    The residual shows how short a timestep must be only at timesteps that resolve contacts, up to `resolving`, s.
    """
    if attempt.halvings is None or attempt.halvings >= _HALVINGS:
        return None
    halvings = 1
    residual, limit = outcome.ending.residual, attempt.design.protocol.residual_limit
    if outcome.verdict is Verdict.UNTRUSTED and residual is not None and math.isfinite(residual):
        halvings = max(1, round(math.log2(residual / limit) / _RESIDUAL_ORDER))
        if (present := float(attempt.design.protocol.timestep)) > resolving:
            halvings = min(halvings, math.ceil(math.log2(present / resolving)))
    elif len(attempt.before) >= attempt.agreeing - 1 and all(_agree(earlier, outcome) for _, earlier in attempt.before):
        return None
    total = min(attempt.halvings + halvings, _HALVINGS)
    timestep = float(attempt.design.protocol.timestep) / 2 ** (total - attempt.halvings)
    if timestep < (attempt.design.protocol.shortest_timestep or 0.0):
        return None
    return _Attempt(
        number=attempt.number,
        design=with_step(attempt.design, timestep),
        halvings=total,
        before=(*attempt.before, (float(attempt.design.protocol.timestep), outcome))[1 - attempt.agreeing :],
        agreeing=attempt.agreeing,
    )


def _doubt(attempt: _Attempt, outcome: Outcome) -> str:
    """Return why a run at the shortest timestep is unreliable, apart from its residual; usually empty."""
    if not outcome.verdict.conclusive or not attempt.before:
        return ""
    conclusive = [earlier for _, earlier in attempt.before if earlier.verdict.conclusive]
    return "" if all(_same_ending(earlier, outcome) for earlier in conclusive) else UNSETTLED


def _coarser(attempt: _Attempt, outcome: Outcome) -> tuple[NumericalCheck, ...]:
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


def trial_chains(designs: Sequence[Design], structure: Structure) -> TrialChains:
    """Return the chains of the trials among designs, whose structures have the drives of one of them."""
    return TrialChains([design_trial(design, structure) for design in designs])


def reached_goal(record: Record) -> bool | None:
    """Return whether a run reached the state of its `tried_transition`; False if it stayed short of its goal.

    None if the verdict is inconclusive, or if the run met the goal at some moment and lost it. A larger or a smaller
    drive may then do either.
    """
    outcome, transition = measure(record), tried_transition(record.design, record.structure)
    if transition is None or transition.stage is None or not outcome.verdict.conclusive:
        return None
    if outcome.holds[transition.state]:
        return True
    last = transition.stage if transition.goal_stage is None else transition.goal_stage
    ends = record.stages[transition.stage : last + 1]
    return False if ends and ends[-1].goal_time is None and ends[-1].met is False else None


def _engine_key(design: Design) -> str:
    """Return a key of the engine model: everything in the design except the loads on the structure."""
    parted = put(design, "protocol.stages", ())
    # the estimate of a timestep depends on torques if tendons have nonlinear damping
    if design.protocol.timestep != "auto" or not _damps_nonlinearly(design):
        for key in drive_keys(design):
            parted = put(parted, key, 0.0)
    return parted.hash


def _damps_nonlinearly(design: Design) -> bool:
    try:
        tendons = structure_of(design).tendons
    except InputError:  # compiling the model reports the error
        return True
    return any(any((tendon.law.damping or ())[1:]) for tendon in tendons)


def _compile(design: Design) -> Model | InputError:
    """Return a model, or why there is none.

    A timestep "auto" starts at four times the estimated one, so that the third attempt can be the last.
    """
    try:
        started = with_timestep(design)
        if started is not design:
            started = with_step(started, 2 ** (_AGREEING - 1) * float(started.protocol.timestep))
        return compile_model(started)
    except InputError as error:
        return error


def _with_protocol(model: Model | InputError, attempt: _Attempt) -> tuple[_Attempt, Model]:
    """Return an attempt at the timestep of a model, and the model with the attempt's protocol. They share the engine.

    Raises:
        InputError: there is no model, or its protocol has too large or too small values for it.
    """
    if isinstance(model, InputError):
        raise model
    design = with_step(attempt.design, float(model.design.protocol.timestep))
    agreeing = _AGREEING if model.creases is None else _OF_NODES
    structure = with_protocol(model.structure, design)
    check_quasi_static(structure, design.protocol)
    simulated = replace(
        model,
        design=design,
        structure=structure,
        in_units=with_protocol(model.in_units, design_in_model_units(design, model.units)),
    )
    check_device(simulated)
    return replace(attempt, design=design, agreeing=agreeing), simulated


def _with_timestep_shown(progress: Progress, attempt: _Attempt) -> Progress:
    """Add the timestep to progress messages while a timestep is searched."""
    if attempt.halvings is None:
        return progress
    shown = f"timestep {show_value(float(attempt.design.protocol.timestep), 's')}"
    if attempt.expected > _LONG:
        shown += f" (about {show_duration(attempt.expected)}; protocol.shortest_timestep limits the search)"
    return lambda stage, time, longest: progress(f"{stage}, {shown}", time, longest)
