"""Outcome of a run: states, energies, work, times, verdict and the energy balance."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from typing import TYPE_CHECKING, Annotated, Literal

import numpy as np

from forficula.analysis.advice import NOTHING, Advice, edge_advice, run_advice
from forficula.analysis.confirmation import Confirmation, StateValues, Values, confirm, undecided, undecided_text
from forficula.analysis.resolution import unresolved_stops
from forficula.analysis.verdict import ENDING_TEXTS, Ending, Verdict, ending_text
from forficula.arrays import Array
from forficula.design import Design, stage_drives
from forficula.displayed import Displayed
from forficula.dynamics import AnyRun, EnergyBalance, NumericalCheck, Record, StageEnd, as_record, energy_balance
from forficula.quantities import reading_unit, show_duration, show_value
from forficula.results import pandas_module
from forficula.serial import Joules, Key, Seconds, Written
from forficula.structure import (
    Drive,
    RestState,
    StageGoal,
    Structure,
    Transition,
    drive_of,
    first_driven_stage,
    goal_coordinates,
    goal_of,
    measure_of,
    state_of,
)

if TYPE_CHECKING:
    from forficula.results import Series

_STIR = np.radians(0.1)
_STIR_SHARE = 1e-3  # of the size of the structure
_SHOWN = 1e-3  # share of a reading from which half its range is shown
_FIRST_STEP = 1.5  # timesteps, because times are multiples of the timestep up to rounding


@dataclass(frozen=True, kw_only=True)
class Reading:
    """Readings of a measure over a time window: one per hinge of an angle, rad, or a distance, m, (reading,).

    Attributes:
        kind: "angle" or "distance".
        mean: means over the window.
        low: lowest values.
        high: highest values.
    """

    kind: Literal["angle", "distance"]
    mean: Array
    low: Array
    high: Array

    def __repr__(self) -> str:
        """Return the means in the units of tables, with half the range where they swing."""
        if self.kind == "angle":
            unit, factor = "deg", float(np.degrees(1.0))
        else:
            unit, factor = reading_unit("m", float(np.abs(self.mean).max(initial=0)))
        halves = factor * (self.high - self.low) / 2
        values = (
            f"{value:.4g}{f' ± {half:.2g}' if half >= _SHOWN * abs(value) else ''}"
            for value, half in zip((factor * self.mean).tolist(), halves.tolist(), strict=True)
        )
        return f"{', '.join(values)} {unit}"


# kinds of elastic parts besides tendons; a state has an energy for each kind that the structure has
SPRUNG = ("hinge", "spring", "coupling")


@dataclass(frozen=True, kw_only=True)
class State:
    """A state that a protocol names: means over the last part of a stage, and whether it still swings.

    Attributes:
        name: such as "folded".
        time: end of the stage, s.
        coordinates: means of the coordinates that goals bound, rad or m, the angles of all hinges first, (coordinate,).
        readings: by name of the measure.
        tendon_length: m, (tendon,).
        tendon_energy: J, (tendon,).
        membrane_energy: J; nan in a sparse record of a structure with membranes.
        hinge_energy: of the hinges' springs, J, (hinge,); None if no hinge has a spring.
        spring_energy: of the springs between points, J, (spring,); None if there are none.
        coupling_energy: of the couplings between joints, J, (coupling,); None if none is elastic.
        within: whether the coordinates are within the bounds of the named state.
        swings: whether a measure still moves, an angle by more than 0.1 deg or a distance by more than 0.1 % of the
            structure's size.
        furthest: reading furthest from the goal of the transition to this state, rad or m; for other states, the
            largest reading of the first measure; None where nothing is measured.
        furthest_kind: kind of that measure.
    """

    name: str
    time: float
    coordinates: Array
    readings: Mapping[str, Reading]
    tendon_length: Array
    tendon_energy: Array
    membrane_energy: float
    hinge_energy: Array | None
    spring_energy: Array | None
    coupling_energy: Array | None
    within: bool
    swings: bool
    furthest: float | None
    furthest_kind: Literal["angle", "distance"]

    @property
    def values(self) -> StateValues:
        """Return the numbers of the state, SI: readings by the name of their measure, others by names with a dot.

        Energies of parts that the structure lacks are absent, and energies of membranes in a sparse record.
        """
        stored = {kind: getattr(self, f"{kind}_energy") for kind in SPRUNG}
        return {
            **{name: reading.mean for name, reading in self.readings.items()},
            "goal.coordinates": self.coordinates,
            "tendon.length": self.tendon_length,
            "tendon.energy": self.tendon_energy,
            **({"membrane.energy": np.array([self.membrane_energy])} if np.isfinite(self.membrane_energy) else {}),
            **{f"{kind}.energy": energy for kind, energy in stored.items() if energy is not None},
        }

    def __repr__(self) -> str:
        """Return the readings and the energy of the tendons, in the units of tables."""
        parts = [f"{name} {reading!r}" for name, reading in self.readings.items()]
        parts += [f"tendons {show_value(float(self.tendon_energy.sum()), 'J')}"] if len(self.tendon_energy) else []
        return f"<{self.name} at {show_value(self.time, 's')}: {'; '.join(parts) or 'nothing is measured'}>"


@dataclass(frozen=True, kw_only=True)
class TransitionOutcome:
    """Outcome of a transition, such as folding.

    Attributes:
        strength: of its drive, in the SI unit of `drive_unit`.
        succeeded: whether the goal was reached, and the state held after the release if a release ends in it.
        time: from the start of the first driven stage after the previous state until the goal was reached, s; None if
            it failed.
        work: of the motors over the driven stages since the previous state, J: the integral of torque over angle.
        largest_force: largest total force along a displacement over the stage, N; None for other drives.
        drives: names of the drives of the driven stages since the previous state, in the order of their first use.
        held: whether the state held after the release; None if no release ends in the state.
        sprung_back: for a release that follows but ends in no named state: the readings furthest from the goal at the
            end of the driven stage and at the end of the release, rad or m; else None.
    """

    strength: float
    succeeded: bool
    time: float | None
    work: float
    largest_force: float | None
    drives: tuple[str, ...]
    held: bool | None = None
    sprung_back: tuple[float, float] | None = None

    def __repr__(self) -> str:
        """Success, time and work."""
        time = "" if self.time is None else f" after {show_value(self.time, 's')}"
        return f"<TransitionOutcome: {'succeeded' if self.succeeded else 'failed'}{time}, {show_value(self.work, 'J')}>"


@dataclass(frozen=True, kw_only=True)
class StageOutcome:
    """Outcome of a stage of the protocol.

    Attributes:
        name: of the stage.
        drive: names of its drives.
        goal: as written in the protocol.
        reached: whether the goal was reached; None if the goal was a time, or if the run is unreliable.
        time: until the goal was reached, s; the duration of a stage without a goal; None if it missed its goal.
        work: of the motors over the stage, J.
        waited: time at rest that was skipped without stepping, s, not part of `time`; None if the stage did not wait.
        motion: "quasi-static" if statics computed the stage; None if its motion was simulated.
        share: share at the end to which the drive of a quasi-static stage has grown.
        lost: shares at which a quasi-static stage lost its equilibrium, so that the structure moved to the next one.
    """

    name: Annotated[str, Written.NEVER]
    drive: Annotated[tuple[str, ...], Written.NEVER]
    goal: str
    reached: bool | None
    time: Seconds | None
    work: Joules
    waited: Annotated[Seconds | None, Written.IF_KNOWN] = None
    motion: Annotated[str | None, Written.IF_KNOWN] = None
    share: Annotated[float | None, Written.IF_KNOWN] = None
    lost: Annotated[tuple[float, ...] | None, Written.IF_KNOWN] = None

    @property
    def driven_by(self) -> Annotated[str | tuple[str, ...], Key("drive"), Written.FIRST]:
        """Return the name of the drive, or "none", or the names of several drives."""
        return ("none" if not self.drive else self.drive[0]) if len(self.drive) < 2 else self.drive


@dataclass(frozen=True, kw_only=True)
class Outcome(Displayed):
    """Outcome of a run.

    Attributes:
        ending: verdict with its numbers.
        status: verdict in a few words.
        holds: by name of the state at the end of a transition, whether it was reached and held when released; None
            if the run diverged or is unreliable.
        states: all named states of the structure, by name; None for a state that the run did not reach in its protocol.
        state_names: names for sentences, because a state that was missed has another name.
        transitions: all transitions of the structure, by name; None for one that the protocol does not drive, or that
            the run did not get to.
        stages: stages that took place, in order.
        energy_balance: over the whole run.
        name: of the design.
        structure: simulated structure.
        confirmation: comparison with second runs of the same design; None without second runs.
        advise: computes the advice.
    """

    ending: Ending
    status: str
    holds: Mapping[str, bool | None]
    states: Mapping[str, State | None]
    state_names: Mapping[str, str]
    transitions: Mapping[str, TransitionOutcome | None]
    stages: tuple[StageOutcome, ...]
    energy_balance: EnergyBalance
    name: str
    structure: Structure
    confirmation: Confirmation | None = None
    advise: Callable[[], Advice] = field(default=lambda: NOTHING, repr=False, compare=False)

    def to_dict(self) -> dict[str, object]:
        """Return verdict, states, transitions and readings as plain values, SI, by flat keys, as one row of a table.

        Keys: `design`, `verdict`, `status`, `residual`; by state `folded` (whether it was reached and held) and
        `folded_tendon_energy_J`, and by measure `folded_distal_rad` or `..._m`, a number or a list of one per hinge; by
        transition `fold_succeeded`, `fold_time_s`, `fold_work_J`. Unknown values are None.
        """
        values: dict[str, object] = {"design": self.name, "verdict": self.verdict.value, "status": self.status}
        values |= dict(self.holds)
        for name, made in self.transitions.items():
            values[f"{name}_succeeded"] = None if made is None else made.succeeded
            values[f"{name}_time_s"] = None if made is None else made.time
            values[f"{name}_work_J"] = None if made is None else made.work
        for name, state in self.states.items():
            if state is None:
                continue
            if len(state.tendon_energy):
                values[f"{name}_tendon_energy_J"] = float(state.tendon_energy.sum())
            for measure_name, reading in state.readings.items():
                means = reading.mean.tolist()
                unit = "rad" if reading.kind == "angle" else "m"
                values[f"{name}_{measure_name}_{unit}"] = means[0] if len(means) == 1 else means
        return values | {"residual": self.ending.residual}

    def to_series(self) -> Series:
        """Return `to_dict` as a pandas series; a list of outcomes becomes a table by `pandas.DataFrame`.

        Raises:
            InputError: pandas is not installed.
        """
        return pandas_module().Series(self.to_dict(), name=self.name, dtype=object)

    def __repr__(self) -> str:
        """Return the status and the states."""
        states = [repr(state) for state in self.states.values() if state is not None]
        return "\n  ".join([f"<Outcome of {self.name}: {self.status}>", *states])

    @cached_property
    def advised(self) -> Advice:
        """Return what to change, with the new values; computed on first use, because it may need statics."""
        return self.advise()

    @property
    def advice(self) -> str:
        """Return what to change, in a sentence; empty if nothing failed, or if nothing is known to help."""
        return self.advised.text

    @property
    def verdict(self) -> Verdict:
        """Return the verdict of the run."""
        return self.ending.verdict


@dataclass(frozen=True, kw_only=True)
class _TransitionRun:
    """A transition in a run: the stages that drive it and that end at its goal, and the state at the end or later.

    The way of a transition may begin with driven stages before its own. The stages after its goal may have goals of
    their own, up to the one that ends in the state, and `missed` is the first stage that missed such a goal.
    """

    transition: Transition
    begun: StageEnd | None
    driven: StageEnd | None
    ended: StageEnd | None
    missed: StageEnd | None
    state: State | None
    holds: bool


def measure(run: AnyRun) -> Outcome:
    """Compute the outcome of a run, or of a run in a folder.

    A state is taken at the end of the stage that names it. If that stage did not take place, the state is taken at the
    end of the stage that was to lead to it. It is a mean over the protocol's window. At the end of a driven stage that
    reached its goal, it is the state at the moment of reaching.

    Raises:
        InputError: the folder does not contain a run, or it cannot be read.
    """
    record = as_record(run)
    return compared_outcome(_outcome(record), record.checks, record.design)


def outcome_values(outcome: Outcome) -> dict[str, tuple[float, ...]]:
    """Return the numbers of an outcome by name, SI: times and works of transitions, and the values of states."""
    values: dict[str, tuple[float, ...]] = {}
    for name, transition in outcome.transitions.items():
        if transition is not None and transition.time is not None:
            values |= {f"{name}.time": (transition.time,), f"{name}.work": (transition.work,)}
    for name, state in outcome.states.items():
        if state is not None:
            values |= {f"{name}.{quantity}": tuple(numbers.tolist()) for quantity, numbers in state.values.items()}
    return values


def compared_outcome(outcome: Outcome, checks: Sequence[NumericalCheck], design: Design) -> Outcome:
    """Compare an outcome with second runs of its design.

    Args:
        outcome: of the run alone.
        checks: second runs; without any, or if the verdict is not conclusive, the outcome is returned unchanged.
        design: simulated design.

    Returns:
        The outcome with its confirmation. If the verdicts differ, the verdict is "undecided". For each state on which
        the runs disagree, `holds` is None and the transition to it has no time.
    """
    if not checks or not outcome.verdict.conclusive:
        return outcome
    values: Values = outcome_values(outcome)
    timestep = float(design.protocol.timestep)
    confirmation = confirm(outcome.ending, values, timestep, checks)
    if confirmation.agree:
        return replace(outcome, confirmation=confirmation)
    ending = undecided(outcome.ending, undecided_text(outcome.status, timestep, outcome.ending, confirmation))
    holds = {
        state: held if all(check.holds.get(state) == held for check in checks) else None
        for state, held in outcome.holds.items()
    }
    leads = {transition.name: transition.state for transition in outcome.structure.transitions}
    return replace(
        outcome,
        ending=ending,
        status=ending_text(ending),
        advise=edge_advice,
        holds=holds,
        state_names={
            state.name: _rest_name(state, outcome.states[state.name], holds) for state in outcome.structure.states
        },
        transitions={
            name: replace(transition, succeeded=False, time=None)
            if transition is not None and holds[leads[name]] is None
            else transition
            for name, transition in outcome.transitions.items()
        },
        confirmation=confirmation,
    )


def _outcome(record: Record) -> Outcome:
    """Compute the outcome of a run alone, without second runs."""
    structure, protocol, balance = record.structure, record.design.protocol, energy_balance(record)
    runs = [_transition_run(record, transition) for transition in structure.transitions]
    missed, unresolved = _missed(record, runs), unresolved_stops(record)
    if record.diverged_at is not None:
        verdict = Verdict.DIVERGED
    elif record.doubt or unresolved or not balance.residual <= protocol.residual_limit:
        verdict = Verdict.UNTRUSTED
    else:
        verdict = _verdict(record.structure, missed)
    if not verdict.conclusive:
        missed = next((run.driven for run in runs if run.driven is not None), None)
    decisive = missed or next((run.driven for run in reversed(runs) if run.driven is not None), None)
    run = None if decisive is None else _transition_run_of(runs, decisive)
    ending = Ending(
        verdict=verdict,
        transition=None if run is None else run.transition,
        reading=run.state.furthest if verdict.conclusive and run is not None and run.state is not None else None,
        time=record.diverged_at,
        residual=balance.residual if record.diverged_at is None else None,
        why=record.doubt or unresolved or _reason_text(record, verdict, missed, run),
    )
    holds = {run.transition.state: run.holds if verdict.conclusive else None for run in runs}
    led_to = {run.transition.state: run.state for run in runs}
    states = {
        state.name: led_to[state.name] if state.name in led_to else _named_state(record, state)
        for state in structure.states
    }
    return Outcome(
        ending=ending,
        status=ending_text(ending),
        holds=holds,
        states=states,
        state_names={state.name: _rest_name(state, states[state.name], holds) for state in structure.states},
        transitions={run.transition.name: _transition(record, run, holds) for run in runs},
        stages=tuple(_stage(record, end, conclusive=verdict.conclusive) for end in record.stages),
        energy_balance=balance,
        name=record.design.name,
        structure=structure,
        advise=partial(run_advice, record, ending),
    )


def early_goal(record: Record, end: StageEnd) -> str:
    """Return a warning if the goal of a driven stage, a bound, is met at its first step; else an empty text."""
    if end.goal_time is None or not stage_drives(end.stage) or not _has_bounds(record, end):
        return ""
    early = end.goal_time - end.start <= _FIRST_STEP * float(record.design.protocol.timestep)
    # a quasi-static stage first comes to rest without its drive
    early = early or end.share == 0
    return ENDING_TEXTS["not held, early"].format(stage=end.stage.name) if early else ""


def _reason_text(record: Record, verdict: Verdict, missed: StageEnd | None, run: _TransitionRun | None) -> str:
    """Return why a stage missed its goal where the wording of its transition would mislead; else an empty text."""
    if missed is None or verdict not in (Verdict.MOVING, Verdict.NOT_HELD, Verdict.STUCK):
        return ""
    # the wording of a transition is about its own goal
    other = run is None or missed is run.missed
    if verdict is Verdict.STUCK:
        return ENDING_TEXTS["missed, stage"].format(stage=missed.stage.name) if other else ""
    if missed.stage.wait and missed.goal_time is None:
        limit, wait = show_value(missed.stage.time_limit, "s"), show_duration(missed.stage.wait)
        where = f'in the stage "{missed.stage.name}", which waits {wait} at rest'
        return f"did not come to rest within {limit} (time_limit) {where}"
    if verdict is Verdict.NOT_HELD:
        return early_goal(record, missed)
    if missed.at_goal:
        return ENDING_TEXTS["moving, too short"]
    if missed.at_rest:
        return ENDING_TEXTS["moving, torque rises"]
    return ENDING_TEXTS["missed, stage"].format(stage=missed.stage.name) if other else ""


def _transition_run(record: Record, transition: Transition) -> _TransitionRun:
    structure, number = record.structure, transition.stage
    if number is None or number >= len(record.stages):
        return _TransitionRun(
            transition=transition, begun=None, driven=None, ended=None, missed=None, state=None, holds=False
        )
    driven, last = record.stages[number], transition.goal_stage
    begins = first_driven_stage(structure, record.design.protocol.stages, transition)
    ended = record.stages[last] if last is not None and last < len(record.stages) else None
    names = structure.stage_states
    named = next((place for place in range(number, len(names)) if names[place] == transition.state), number)
    end = (
        record.stages[named]
        if _ended_without_divergence(record, named)
        else driven
        if _ended_without_divergence(record, number)
        else None
    )
    rest_state = state_of(structure, transition.state)
    state = None if end is None else _state(record, end, transition.state)
    stage_goal = goal_of(structure, transition.goal if ended is None else ended.stage.until)
    ends_transition = _same_goal(stage_goal, goal_of(structure, transition.goal))
    reached = ended is not None and (ended.goal_time is not None or stage_goal.kind != "bounds")
    after = number if last is None else last
    missed = next(
        (end for end in record.stages[after + 1 : named + 1] if end.goal_time is None and _has_bounds(record, end)),
        None,
    )
    holds = False
    if state is not None and rest_state is not None and missed is None:
        # a stage that does not end at a bound cannot reach it, so its final state decides
        kept = goal_of(structure, transition.released if ends_transition else rest_state.goal)
        holds = reached and _within_bounds(state.coordinates, kept)
        # a goal that was met before the drive acted is not an effect of the drive
        holds = holds and ended is not None and not early_goal(record, ended)
    return _TransitionRun(
        transition=transition,
        begun=driven if begins is None else record.stages[begins],
        driven=driven,
        ended=ended,
        missed=missed,
        state=state,
        holds=holds,
    )


def _has_bounds(record: Record, end: StageEnd) -> bool:
    """Return whether the goal of a stage is a bound."""
    return goal_of(record.structure, end.stage.until).kind == "bounds"


def _transition_run_of(runs: list[_TransitionRun], end: StageEnd) -> _TransitionRun | None:
    """Return the transition that a stage drives, or whose goal ends the stage."""
    drives = stage_drives(end.stage)
    for run in runs:
        if end in (run.driven, run.ended, run.missed):
            return run
    return next((run for run in runs if run.transition.goal == end.stage.until or run.transition.drive in drives), None)


def _missed(record: Record, runs: list[_TransitionRun]) -> StageEnd | None:
    """Return the first stage whose goal was missed or lost when released; None if there is none."""
    for run in runs:
        if run.driven is not None and not run.holds:
            return run.missed or run.ended or run.driven
    last = record.stages[-1]
    has_goal = last.stage.wait or _has_bounds(record, last)
    has_goal = has_goal or (last.stage.quasi_static and not last.at_rest)
    return last if last.goal_time is None and has_goal else None


def _verdict(structure: Structure, missed: StageEnd | None) -> Verdict:
    """Return the verdict of a reliable run from the stage whose goal it missed."""
    if missed is None:
        return Verdict.REACHED
    if missed.goal_time is not None:
        return Verdict.NOT_HELD
    # a run counts as stuck only if its drives have reached their full strength
    risen = all(missed.end - missed.start >= drive_of(structure, name).rise for name in stage_drives(missed.stage))
    return Verdict.STUCK if missed.at_rest and risen and not missed.at_goal else Verdict.MOVING


def _named_state(record: Record, state: RestState) -> State | None:
    """Return a state that no transition leads to, at the end of the stage that names it."""
    names = record.structure.stage_states
    number = names.index(state.name) if state.name in names else len(names)
    return _state(record, record.stages[number], state.name) if _ended_without_divergence(record, number) else None


def _rest_name(state: RestState, resting: State | None, holds: Mapping[str, bool | None]) -> str:
    if state.name in holds:
        held = holds[state.name]
        return state.unknown if held is None else state.name if held else state.missed
    return state.name if resting is None or resting.within else state.missed


def _within_bounds(coordinates: Array, bounds: StageGoal) -> bool:
    return bool(np.all((coordinates >= bounds.least) & (coordinates <= bounds.most)))


def _same_goal(one: StageGoal, other: StageGoal) -> bool:
    """Return whether two goals have the same bounds, even if their names differ."""
    same_bounds = np.array_equal(one.least, other.least) and np.array_equal(one.most, other.most)
    return one.kind == other.kind and same_bounds


def _ended_without_divergence(record: Record, stage: int) -> bool:
    """Return whether a stage took place without diverging."""
    return len(record.stages) > stage and (record.diverged_at is None or stage < len(record.stages) - 1)


def _state(record: Record, end: StageEnd, name: str) -> State:
    snapped = bool(stage_drives(end.stage)) and end.goal_time is not None
    # a stage that ends at its goal ends in motion, so its end is not averaged
    start = end.end if snapped else max(end.start, end.end - record.design.protocol.window)
    if end.stage.until == "rest" and end.goal_time is not None:
        start = max(start, end.goal_time)  # it still moved before
    # half a step either way, because times are multiples of the timestep up to rounding
    half = float(record.design.protocol.timestep) / 2
    # as row numbers, because applying a mask to every series takes longer
    window = np.flatnonzero((record.time >= start - half) & (record.time <= end.end + half))
    distances = record.series.get("distance")
    coordinates = goal_coordinates(
        record.structure, record.series["hinge_angle"][window], None if distances is None else distances[window]
    )
    readings = {}
    # the measures, and groups of hinges by role that goals of transitions bound without being measures
    watched = [
        *(measure.name for measure in record.structure.measures),
        *(t.measure for t in record.structure.transitions),
    ]
    for measure_name in dict.fromkeys(watched):
        values = record.measured(measure_name)[window]
        measure = measure_of(record.structure, measure_name)
        readings[measure_name] = Reading(
            kind="angle" if measure is None else measure.kind,
            mean=values.mean(axis=0),
            low=values.min(axis=0),
            high=values.max(axis=0),
        )
    swung = [readings[measure.name] for measure in record.structure.measures if measure.kind == "angle"]
    far = _STIR_SHARE * record.structure.span
    moved = [readings[measure.name] for measure in record.structure.measures if measure.kind == "distance"]
    mean, rest_state = coordinates.mean(axis=0), state_of(record.structure, name)
    hinges, springs, couplings = (
        record.series[series][window].mean(axis=0) if (series := f"{kind}_energy") in record.series else None
        for kind in SPRUNG
    )
    furthest, kind = _furthest(record.structure, name, readings)
    return State(
        name=name,
        time=end.end,
        coordinates=mean,
        readings=readings,
        tendon_length=record.series["tendon_length"][window].mean(axis=0),
        tendon_energy=record.series["tendon_energy"][window].mean(axis=0),
        membrane_energy=float(record.series["membrane_energy"][window].mean()) if record.structure.membranes else 0.0,
        hinge_energy=hinges,
        spring_energy=springs,
        coupling_energy=couplings,
        within=rest_state is not None and _within_bounds(mean, goal_of(record.structure, rest_state.goal)),
        swings=any(bool(np.any(reading.high - reading.low > _STIR)) for reading in swung)
        or any(bool(np.any(reading.high - reading.low > far)) for reading in moved),
        furthest=furthest,
        furthest_kind=kind,
    )


def _furthest(
    structure: Structure, state: str, readings: Mapping[str, Reading]
) -> tuple[float | None, Literal["angle", "distance"]]:
    """Return the reading furthest from the goal of a state, and its kind."""
    for transition in structure.transitions:
        if transition.state == state and transition.measure in readings:
            mean = readings[transition.measure].mean
            return float(np.max(mean) if transition.furthest == "largest" else np.min(mean)), transition.kind
    for measure in structure.measures:
        return float(np.max(readings[measure.name].mean)), measure.kind
    return None, "angle"


def _transition(record: Record, run: _TransitionRun, holds: Mapping[str, bool | None]) -> TransitionOutcome | None:
    begun, end, transition = run.begun, run.driven, run.transition
    if end is None or begun is None:
        return None
    succeeded = bool(holds[transition.state])
    reached = None if run.ended is None else run.ended.goal_time
    drive = drive_of(record.structure, transition.drive)
    released = run.state is not None and run.state.time > end.end
    return TransitionOutcome(
        strength=drive.strength,
        succeeded=succeeded,
        time=reached - begun.start if succeeded and reached is not None else None,
        work=_work(record, begun.start, end.end),
        largest_force=_largest_force(record, drive, end),
        drives=_drives(record, begun, end),
        held=holds[transition.state] if released else None,
        sprung_back=None if released else _readings_at_release(record, transition),
    )


def _drives(record: Record, begun: StageEnd, end: StageEnd) -> tuple[str, ...]:
    """Return the names of the drives of the stages from one to another, in the order of their first use."""
    stages = record.stages[record.stages.index(begun) : record.stages.index(end) + 1]
    return tuple(dict.fromkeys(name for driven in stages for name in stage_drives(driven.stage)))


def _readings_at_release(record: Record, transition: Transition) -> tuple[float, float] | None:
    """Return the readings furthest from a transition's goal before and after a release that ends in no named state."""
    names, number = record.structure.stage_states, transition.stage
    after = (number or 0) + 1
    if (
        number is None
        or not _ended_without_divergence(record, after)
        or names[after]
        or stage_drives(record.stages[after].stage)
    ):
        return None
    before, later = (_state(record, record.stages[stage], transition.state).furthest for stage in (number, after))
    return None if before is None or later is None else (before, later)


def _largest_force(record: Record, drive: Drive, end: StageEnd) -> float | None:
    """Return the largest total force on the points that a drive displaces in a stage, N; None if it displaces none."""
    if "motor_force" not in record.series:
        return None
    motors = zip(record.structure.motors, drive.shares, strict=True)
    displaced = [motor.kind == "displacement" and share != 0 for motor, share in motors]
    during = (record.time > end.start) & (record.time <= end.end)
    forces = record.series["motor_force"][during][:, displaced].sum(axis=1)
    return float(max(forces, key=abs)) if any(displaced) and len(forces) else None


def _stage(record: Record, end: StageEnd, *, conclusive: bool) -> StageOutcome:
    timed = end.stage.until == "time"
    moment = end.end if timed else end.goal_time
    return StageOutcome(
        name=end.stage.name,
        drive=stage_drives(end.stage),
        goal=end.stage.until,
        reached=end.goal_time is not None if conclusive and not timed else None,
        time=None if moment is None else moment - end.start,
        work=_work(record, end.start, end.end),
        waited=end.waited or None,
        motion=end.stage.motion,
        share=end.share,
        lost=end.lost if end.stage.quasi_static else None,
    )


def _work(record: Record, start: float, end: float) -> float:
    """Return the work of the motors between two times, J."""
    before, after = (int(np.argmin(np.abs(record.time - moment))) for moment in (start, end))
    work = record.series["motor_work"]
    return sum((float(last - first) for first, last in zip(work[before], work[after], strict=True)), 0.0)
