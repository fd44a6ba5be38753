"""Run designs through their protocols. A timestep "auto" is determined so that the results do not depend on it."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from forficula.analysis import measure
from forficula.design import Design, put
from forficula.dynamics import (
    Model,
    Record,
    TrialChains,
    batch_key,
    check_available,
    check_device,
    compile_model,
    design_in_model_units,
    design_trial,
    simulate_each,
    tried_transition,
)
from forficula.dynamics.stepping.simulate import CertainOutcome, Progress
from forficula.errors import InputError
from forficula.quantities import show_duration, show_value
from forficula.statics.survey import check_quasi_static, stage_rest_path
from forficula.structure import Structure, drive_keys, structure_of, with_protocol
from forficula.study.running.numerical_settings import (
    Attempt,
    at_timestep,
    attempt_doubt,
    coarser_checks,
    finds_settings,
    first_attempt,
    known_runs,
    next_attempt,
    started,
)
from forficula.study.running.second_runs import other_designs, second_designs, with_checks

# An attempt that takes longer than this, s, is announced with its expected time.
_LONG = 60.0
# Time for building models before the first of them run, s. It doubles each time, because many side by side are faster.
_FIRST_SECONDS = 1.0


def run(design: Design, progress: Progress | None = None, *, confirm: bool = False) -> Record:
    """Run the protocol of one structure.

    A timestep "auto" is found by halving, starting from the longest one that the stiffest mode allows. The search ends
    when three successive timesteps (two for sheets of nodes) agree: their energy residual is at most
    `protocol.residual_limit`, their verdicts are the same, and no transition time deviates from that at the shortest
    timestep by more than 2 %. The record is that of the shortest timestep, which its design contains.

    With a time constant of contact "auto" a run in which parts touch is repeated at a timestep that resolves contacts,
    and with a shorter time constant as long as parts overlap by more than a tenth of their thickness, four times at
    most. `Record.contact_runs` lists the time constants.

    Args:
        design: structure and protocol.
        progress: called now and then with the stage's name, the time so far and the time limit, s.
        confirm: whether to run the design also at half the timestep and from a slightly different start, side by side,
            and a design on a device also in double precision. With a timestep "auto" the last but one run replaces the
            one at half the timestep. All of them have the same time constant of contact.

    Returns:
        The record, sampled at the protocol's interval.

    Raises:
        InputError: the design cannot be built.
    """
    others = second_designs(design) if confirm and not finds_settings(design) else {}
    runs: dict[int, Record | InputError] = {}
    for number, result in run_each([design, *others.values()], progress=progress):
        if number == 0 and isinstance(result, InputError):
            raise result  # before the second runs, which may be possible
        runs[number] = result
    record = runs[0]
    assert isinstance(record, Record)
    if confirm and not others:
        others = (other_designs if design.protocol.timestep == "auto" else second_designs)(record.design)
        runs |= {number + 1: checked for number, checked in run_each([*others.values()], progress=progress)}
    return with_checks(record, {name: runs[number] for number, name in enumerate(others, start=1)})


def resolved(design: Design) -> Design:
    """Return the design with the timestep and the time constant of contact that its run uses.

    Raises:
        InputError: the design cannot be built.
    """
    if not finds_settings(design):
        return design
    ((_, record),) = run_each([design], sparse=True)
    if isinstance(record, InputError):
        raise record
    return record.design


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
    attempts = [first_attempt(number, design) for number, design in enumerate(designs)]
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
            seconds = time.perf_counter() - start
            following = next_attempt(attempt, designs[attempt.number], result, outcome, seconds)
            if following is not None:
                left[attempt.number] = following
                continue
            doubt = result.doubt or attempt_doubt(attempt, outcome)
            checks, runs = coarser_checks(attempt, outcome), known_runs(attempt, result)
            yield attempt.number, replace(result, doubt=doubt, checks=checks, contact_runs=runs)
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


def _results(attempts: Sequence[Attempt], options: _RunOptions) -> Iterator[tuple[Attempt, Record | InputError]]:
    """Build models and simulate them: the first ones soon, then larger batches each time."""
    by_engine: dict[str, list[Attempt]] = {}
    for attempt in attempts:
        by_engine.setdefault(_engine_key(attempt.design), []).append(attempt)
    built: list[tuple[Attempt, Model]] = []
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
    built: Sequence[tuple[Attempt, Model]], options: _RunOptions
) -> Iterator[tuple[Attempt, Record | InputError]]:
    """Simulate models, those of one topology side by side. A batch that exceeds the memory is halved."""
    groups: dict[tuple[int | str, ...], list[tuple[Attempt, Model]]] = {}
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
    """Return a model, or why there is none."""
    try:
        return compile_model(started(design))
    except InputError as error:
        return error


def _with_protocol(model: Model | InputError, attempt: Attempt) -> tuple[Attempt, Model]:
    """Return an attempt at the timestep of a model, and the model with the attempt's protocol. They share the engine.

    Raises:
        InputError: there is no model, or its protocol has too large or too small values for it.
    """
    if isinstance(model, InputError):
        raise model
    attempt = at_timestep(attempt, float(model.design.protocol.timestep), of_nodes=model.creases is not None)
    design = attempt.design
    structure = with_protocol(model.structure, design)
    check_quasi_static(structure, design.protocol)
    simulated = replace(
        model,
        design=design,
        structure=structure,
        in_units=with_protocol(model.in_units, design_in_model_units(design, model.units)),
    )
    check_device(simulated)
    return attempt, simulated


def _with_timestep_shown(progress: Progress, attempt: Attempt) -> Progress:
    """Add the timestep to progress messages while a timestep or a time constant of contact is searched."""
    if attempt.halvings is None and attempt.contact_runs is None:
        return progress
    shown = f"timestep {show_value(float(attempt.design.protocol.timestep), 's')}"
    if attempt.expected > _LONG:
        shown += f" (about {show_duration(attempt.expected)}; protocol.shortest_timestep limits the search)"
    return lambda stage, time, longest: progress(f"{stage}, {shown}", time, longest)
