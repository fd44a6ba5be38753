"""What a run means: states, energies, work, times, verdict and the energy balance."""

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
    goal_coordinates,
    goal_of,
    measure_of,
    state_of,
)

if TYPE_CHECKING:
    from forficula.results import Series

_STIR = np.radians(0.1)
_STIR_SHARE = 1e-3  # of the size of the whole
_SHOWN = 1e-3  # of a reading, of which half its range is told
_FIRST_STEP = 1.5  # timesteps, for times are multiples of it up to rounding


@dataclass(frozen=True, kw_only=True)
class Reading:
    """What a measure reads over a while: of each hinge of an angle, rad, or of a distance, m, (reading,).

    Attributes:
        kind: "angle" or "distance".
        mean: over the while.
        low: lowest.
        high: highest.
    """

    kind: Literal["angle", "distance"]
    mean: Array
    low: Array
    high: Array

    def __repr__(self) -> str:
        """The means as a table has them, with half the range where they swing."""
        if self.kind == "angle":
            unit, factor = "deg", float(np.degrees(1.0))
        else:
            unit, factor = reading_unit("m", float(np.abs(self.mean).max(initial=0)))
        halves = factor * (self.high - self.low) / 2
        told = (
            f"{value:.4g}{f' ± {half:.2g}' if half >= _SHOWN * abs(value) else ''}"
            for value, half in zip((factor * self.mean).tolist(), halves.tolist(), strict=True)
        )
        return f"{', '.join(told)} {unit}"


# what has springs, beside tendons; of each there is a state's energy if the structure has any
SPRUNG = ("hinge", "spring", "coupling")


@dataclass(frozen=True, kw_only=True)
class State:
    """A state that a protocol names: the mean over the last part of a stage, and how far it still swings.

    Attributes:
        name: such as "folded".
        time: end of the stage, s.
        coordinates: means of what goals are bounds on, the angles of all hinges first, rad or m, (coordinate,).
        readings: by name of the measure.
        tendon_length: m, (tendon,).
        tendon_energy: J, (tendon,).
        membrane_energy: J; nan in a sparse record of a structure with membranes.
        hinge_energy: of the hinges' springs, J, (hinge,); None where they have none.
        spring_energy: of the springs between points, J, (spring,); None where there are none.
        coupling_energy: of the couplings between joints, J, (coupling,); None where none is elastic.
        within: whether it is within the bounds of its name.
        swings: whether what is measured still moves, an angle by more than 0.1 deg, a distance by 0.1 % of the size.
        furthest: of the measure of the transition that leads there, what reads furthest from its goal, rad or m; of
            other states the largest reading of the first measure; None where nothing is measured.
        furthest_kind: of that measure.
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
        """Numbers of the state, SI: readings by the name of their measure, all others by names with a dot.

        Absent: energies of what the structure does not have, and those of membranes in a sparse record.
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
        """What is measured, and the energy of its tendons, in the units of tables."""
        told = [f"{name} {reading!r}" for name, reading in self.readings.items()]
        told += [f"tendons {show_value(float(self.tendon_energy.sum()), 'J')}"] if len(self.tendon_energy) else []
        return f"<{self.name} at {show_value(self.time, 's')}: {'; '.join(told) or 'nothing is measured'}>"


@dataclass(frozen=True, kw_only=True)
class TransitionOutcome:
    """What became of a transition, such as folding.

    Attributes:
        strength: of its drive, in the SI unit of `drive_unit`.
        succeeded: whether the goal was reached, and the state held after the release if a release ends in it.
        time: from the start of the stage until the goal was reached, s; None where it failed.
        work: of the motors over the stage, J: the integral of torque over angle.
        largest_force: over the stage, on all points of a displacement together and along it, N; None of other drives.
        held: whether the state held after the release; None where no release ends in the state: nothing is claimed.
        sprung_back: where no release ends in the state but one follows: what the transition's measure reads furthest
            from the goal at the end of the driven stage and at the end of the release, rad or m; else None.
    """

    strength: float
    succeeded: bool
    time: float | None
    work: float
    largest_force: float | None
    held: bool | None = None
    sprung_back: tuple[float, float] | None = None

    def __repr__(self) -> str:
        """Success, time and work."""
        time = "" if self.time is None else f" after {show_value(self.time, 's')}"
        return f"<TransitionOutcome: {'succeeded' if self.succeeded else 'failed'}{time}, {show_value(self.work, 'J')}>"


@dataclass(frozen=True, kw_only=True)
class StageOutcome:
    """How a stage of the protocol went.

    Attributes:
        name: of the stage.
        drive: names of its drives.
        goal: as the protocol has it.
        reached: whether the goal was; None where it was the time, or where nothing is to be trusted.
        time: until the goal was reached, s; how long the stage took where it had none; None where it missed it.
        work: of the motors over the stage, J.
        waited: how long it was at rest without being stepped, s, beside the time; None where it did not wait.
    """

    name: Annotated[str, Written.NEVER]
    drive: Annotated[tuple[str, ...], Written.NEVER]
    goal: str
    reached: bool | None
    time: Seconds | None
    work: Joules
    waited: Annotated[Seconds | None, Written.IF_KNOWN] = None

    @property
    def driven_by(self) -> Annotated[str | tuple[str, ...], Key("drive"), Written.FIRST]:
        """Return the name of the drive, or "none", or the names of several drives."""
        return ("none" if not self.drive else self.drive[0]) if len(self.drive) < 2 else self.drive


@dataclass(frozen=True, kw_only=True)
class Outcome(Displayed):
    """What a run means.

    Attributes:
        ending: what it came to.
        status: that in a few words.
        holds: by name of the state that a transition leads to, whether it was reached and held when released; None
            where the run diverged or is not to be trusted.
        states: by name, all of the structure; None where the protocol did not get there.
        state_names: what to call each, for a state that was missed is called otherwise.
        transitions: by name, all of the structure; None where the protocol has no such stage or did not get there.
        stages: that took place, in order.
        energy_balance: over the whole run.
        name: of the design.
        structure: that ran.
        confirmation: comparison with second runs of the same design; None where there were none.
        advise: finds what to try.
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
        """What became of it, and the states."""
        states = [repr(state) for state in self.states.values() if state is not None]
        return "\n  ".join([f"<Outcome of {self.name}: {self.status}>", *states])

    @cached_property
    def advised(self) -> Advice:
        """What to try, with the values to replace; found when it is wanted, for statics may be asked."""
        return self.advise()

    @property
    def advice(self) -> str:
        """What to try, in a sentence; empty where there is nothing to mend, or nothing is known to help."""
        return self.advised.text

    @property
    def verdict(self) -> Verdict:
        """What the run came to, in a word."""
        return self.ending.verdict


@dataclass(frozen=True, kw_only=True)
class _Way:
    """A transition in a run: the stage that drives it, and the state that was left of it."""

    transition: Transition
    driven: StageEnd | None
    state: State | None
    holds: bool


def measure(run: AnyRun) -> Outcome:
    """Find what a run, or the one in a folder, means.

    A state is taken at the end of the stage that the protocol names it by. Where that did not take place it is taken
    at the end of the stage that was to lead there. It is the mean over the protocol's window; at the end of a driven
    stage that reached its goal, it is the moment at which it did.

    Raises:
        InputError: it is no run, or cannot be read.
    """
    record = as_record(run)
    return held_against(_outcome(record), record.checks, record.design)


def outcome_values(outcome: Outcome) -> dict[str, tuple[float, ...]]:
    """Return the numbers of an outcome by name, SI: times and works of transitions, and the values of states."""
    values: dict[str, tuple[float, ...]] = {}
    for name, made in outcome.transitions.items():
        if made is not None and made.time is not None:
            values |= {f"{name}.time": (made.time,), f"{name}.work": (made.work,)}
    for name, state in outcome.states.items():
        if state is not None:
            values |= {f"{name}.{each}": tuple(numbers.tolist()) for each, numbers in state.values.items()}
    return values


def held_against(outcome: Outcome, checks: Sequence[NumericalCheck], design: Design) -> Outcome:
    """Compare an outcome with second runs of its design.

    Args:
        outcome: of a run by itself.
        checks: second runs; without any, and of a run that says nothing of its structure, the outcome stays.
        design: that ran.

    Returns:
        The outcome with its confirmation. Where the verdicts differ the verdict is "undecided", and what the runs
        disagree on is not known: `holds` is None, and a transition that leads there has no time.
    """
    if not checks or not outcome.verdict.tells:
        return outcome
    values: Values = outcome_values(outcome)
    timestep = float(design.protocol.timestep)
    found = confirm(outcome.ending, values, timestep, checks)
    if found.agree:
        return replace(outcome, confirmation=found)
    ending = undecided(outcome.ending, undecided_text(outcome.status, timestep, outcome.ending, found))
    holds = {
        state: held if all(check.holds.get(state) == held for check in checks) else None
        for state, held in outcome.holds.items()
    }
    leads = {each.name: each.state for each in outcome.structure.transitions}
    return replace(
        outcome,
        ending=ending,
        status=ending_text(ending),
        advise=edge_advice,
        holds=holds,
        state_names={
            state.name: _called(state, outcome.states[state.name], holds) for state in outcome.structure.states
        },
        transitions={
            name: made if made is None or holds[leads[name]] is not None else replace(made, succeeded=False, time=None)
            for name, made in outcome.transitions.items()
        },
        confirmation=found,
    )


def _outcome(record: Record) -> Outcome:
    """What a run means by itself."""
    structure, protocol, balance = record.structure, record.design.protocol, energy_balance(record)
    ways = [_way(record, transition) for transition in structure.transitions]
    missed, unresolved = _missed(record, ways), unresolved_stops(record)
    if record.diverged_at is not None:
        verdict = Verdict.DIVERGED
    elif record.doubt or unresolved or not balance.residual <= protocol.residual_limit:
        verdict = Verdict.UNTRUSTED
    else:
        verdict = _verdict(record.structure, missed)
    if not verdict.tells:
        missed = next((way.driven for way in ways if way.driven is not None), None)
    told = missed or next((way.driven for way in reversed(ways) if way.driven is not None), None)
    way = None if told is None else _way_of(ways, told)
    ending = Ending(
        verdict=verdict,
        transition=None if way is None else way.transition,
        reading=way.state.furthest if verdict.tells and way is not None and way.state is not None else None,
        time=record.diverged_at,
        residual=balance.residual if record.diverged_at is None else None,
        why=record.doubt or unresolved or _why(record, verdict, missed),
    )
    holds = {way.transition.state: way.holds if verdict.tells else None for way in ways}
    led_to = {way.transition.state: way.state for way in ways}
    states = {
        state.name: led_to[state.name] if state.name in led_to else _named_state(record, state)
        for state in structure.states
    }
    return Outcome(
        ending=ending,
        status=ending_text(ending),
        holds=holds,
        states=states,
        state_names={state.name: _called(state, states[state.name], holds) for state in structure.states},
        transitions={way.transition.name: _transition(record, way, holds) for way in ways},
        stages=tuple(_stage(record, end, tells=verdict.tells) for end in record.stages),
        energy_balance=balance,
        name=record.design.name,
        structure=structure,
        advise=partial(run_advice, record, ending),
    )


def early_goal(record: Record, end: StageEnd) -> str:
    """What to say where a driven stage's goal, a bound, holds at its first step; else empty."""
    if (
        end.goal_time is None
        or not stage_drives(end.stage)
        or goal_of(record.structure, end.stage.until).kind != "bounds"
    ):
        return ""
    early = end.goal_time - end.start <= _FIRST_STEP * float(record.design.protocol.timestep)
    return ENDING_TEXTS["not held, early"].format(stage=end.stage.name) if early else ""


def _why(record: Record, verdict: Verdict, missed: StageEnd | None) -> str:
    """Why a stage missed its goal, where the words of its transition would mislead."""
    if missed is None or verdict not in (Verdict.MOVING, Verdict.NOT_HELD):
        return ""
    if missed.stage.wait and missed.goal_time is None:
        limit, wait = show_value(missed.stage.time_limit, "s"), show_duration(missed.stage.wait)
        where = f'in the stage "{missed.stage.name}", where it was to wait {wait}'
        return f"did not come to rest within {limit} (time_limit) {where}"
    if verdict is Verdict.NOT_HELD:
        return early_goal(record, missed)
    if missed.at_goal:
        return ENDING_TEXTS["moving, too short"]
    return ENDING_TEXTS["moving, torque rises"] if missed.at_rest else ""


def _way(record: Record, transition: Transition) -> _Way:
    structure, number = record.structure, transition.stage
    if number is None or number >= len(record.stages):
        return _Way(transition=transition, driven=None, state=None, holds=False)
    driven = record.stages[number]
    names = structure.stage_states
    named = next((place for place in range(number, len(names)) if names[place] == transition.state), number)
    end = record.stages[named] if _sound(record, named) else driven if _sound(record, number) else None
    rest_state = state_of(structure, transition.state)
    state = None if end is None else _state(record, end, transition.state)
    own = goal_of(structure, driven.stage.until)
    asked = _same_goal(own, goal_of(structure, transition.goal))
    reached = driven.goal_time is not None or own.kind != "bounds"
    holds = False
    if state is not None and rest_state is not None:
        # a stage that was not to end at a bound does not say whether it was reached, but what it left does
        kept = goal_of(structure, transition.released if asked else rest_state.goal)
        holds = reached and _within(state.coordinates, kept)
        # what held before the drive did anything is not its doing
        holds = holds and not early_goal(record, driven)
    return _Way(transition=transition, driven=driven, state=state, holds=holds)


def _way_of(ways: list[_Way], end: StageEnd) -> _Way | None:
    """The transition that a stage drives, or whose goal ends it."""
    drives = stage_drives(end.stage)
    for way in ways:
        if way.driven is end:
            return way
    return next((way for way in ways if way.transition.goal == end.stage.until or way.transition.drive in drives), None)


def _missed(record: Record, ways: list[_Way]) -> StageEnd | None:
    """The stage whose goal was missed, or lost when released; None where there is none."""
    for way in ways:
        if way.driven is not None and not way.holds:
            return way.driven
    last = record.stages[-1]
    asked = last.stage.wait or goal_of(record.structure, last.stage.until).kind == "bounds"
    return last if last.goal_time is None and asked else None


def _verdict(structure: Structure, missed: StageEnd | None) -> Verdict:
    """What a run that is to be trusted came to, by the stage whose goal it missed."""
    if missed is None:
        return Verdict.REACHED
    if missed.goal_time is not None:
        return Verdict.NOT_HELD
    # less than all of its torque says nothing of where it sticks
    risen = all(missed.end - missed.start >= drive_of(structure, name).rise for name in stage_drives(missed.stage))
    return Verdict.STUCK if missed.at_rest and risen and not missed.at_goal else Verdict.MOVING


def _named_state(record: Record, state: RestState) -> State | None:
    """A state that no transition leads to, at the end of the stage that is named by it."""
    names = record.structure.stage_states
    number = names.index(state.name) if state.name in names else len(names)
    return _state(record, record.stages[number], state.name) if _sound(record, number) else None


def _called(state: RestState, found: State | None, holds: Mapping[str, bool | None]) -> str:
    if state.name in holds:
        held = holds[state.name]
        return state.unknown if held is None else state.name if held else state.missed
    return state.name if found is None or found.within else state.missed


def _within(coordinates: Array, bounds: StageGoal) -> bool:
    return bool(np.all((coordinates >= bounds.least) & (coordinates <= bounds.most)))


def _same_goal(one: StageGoal, other: StageGoal) -> bool:
    """Whether two goals ask for the same, however they are called."""
    alike = np.array_equal(one.least, other.least) and np.array_equal(one.most, other.most)
    return one.kind == other.kind and alike


def _sound(record: Record, stage: int) -> bool:
    """Whether a stage took place without diverging."""
    return len(record.stages) > stage and (record.diverged_at is None or stage < len(record.stages) - 1)


def _state(record: Record, end: StageEnd, name: str) -> State:
    snapped = bool(stage_drives(end.stage)) and end.goal_time is not None
    # a stage that ends in the middle of the snap is no rest to average over
    start = end.end if snapped else max(end.start, end.end - record.design.protocol.window)
    if end.stage.until == "rest" and end.goal_time is not None:
        start = max(start, end.goal_time)  # before, it moved
    # half a step either way, for times are multiples of the timestep up to rounding
    half = float(record.design.protocol.timestep) / 2
    # as numbers, for a mask is searched through by every series that it is laid on
    window = np.flatnonzero((record.time >= start - half) & (record.time <= end.end + half))
    distances = record.series.get("distance")
    coordinates = goal_coordinates(
        record.structure, record.series["hinge_angle"][window], None if distances is None else distances[window]
    )
    readings = {}
    # what is watched, and what the goals of transitions bound without being watched: hinges by their role
    watched = [*(each.name for each in record.structure.measures), *(t.measure for t in record.structure.transitions)]
    for each in dict.fromkeys(watched):
        values = record.measured(each)[window]
        measure = measure_of(record.structure, each)
        readings[each] = Reading(
            kind="angle" if measure is None else measure.kind,
            mean=values.mean(axis=0),
            low=values.min(axis=0),
            high=values.max(axis=0),
        )
    swung = [readings[each.name] for each in record.structure.measures if each.kind == "angle"]
    far = _STIR_SHARE * record.structure.span
    moved = [readings[each.name] for each in record.structure.measures if each.kind == "distance"]
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
        within=rest_state is not None and _within(mean, goal_of(record.structure, rest_state.goal)),
        swings=any(bool(np.any(each.high - each.low > _STIR)) for each in swung)
        or any(bool(np.any(each.high - each.low > far)) for each in moved),
        furthest=furthest,
        furthest_kind=kind,
    )


def _furthest(
    structure: Structure, state: str, readings: Mapping[str, Reading]
) -> tuple[float | None, Literal["angle", "distance"]]:
    """What reads furthest from the goal of a state, and whether that is an angle."""
    for transition in structure.transitions:
        if transition.state == state and transition.measure in readings:
            mean = readings[transition.measure].mean
            return float(np.max(mean) if transition.furthest == "largest" else np.min(mean)), transition.kind
    for measure in structure.measures:
        return float(np.max(readings[measure.name].mean)), measure.kind
    return None, "angle"


def _transition(record: Record, way: _Way, holds: Mapping[str, bool | None]) -> TransitionOutcome | None:
    end, transition = way.driven, way.transition
    if end is None:
        return None
    succeeded = bool(holds[transition.state])
    drive = drive_of(record.structure, transition.drive)
    released = way.state is not None and way.state.time > end.end
    return TransitionOutcome(
        strength=drive.strength,
        succeeded=succeeded,
        time=end.goal_time - end.start if succeeded and end.goal_time is not None else None,
        work=_work(record, end),
        largest_force=_largest_force(record, drive, end),
        held=holds[transition.state] if released else None,
        sprung_back=None if released else _sprung_back(record, transition),
    )


def _sprung_back(record: Record, transition: Transition) -> tuple[float, float] | None:
    """What a transition's measure reads furthest from its goal before and after a release that ends in no state."""
    names, number = record.structure.stage_states, transition.stage
    after = (number or 0) + 1
    if number is None or not _sound(record, after) or names[after] or stage_drives(record.stages[after].stage):
        return None
    before, later = (_state(record, record.stages[each], transition.state).furthest for each in (number, after))
    return None if before is None or later is None else (before, later)


def _largest_force(record: Record, drive: Drive, end: StageEnd) -> float | None:
    """The largest force on all points that a drive displaces in a stage, N; None where it displaces none."""
    if "motor_force" not in record.series:
        return None
    motors = zip(record.structure.motors, drive.shares, strict=True)
    displaced = [motor.kind == "displacement" and share != 0 for motor, share in motors]
    during = (record.time > end.start) & (record.time <= end.end)
    forces = record.series["motor_force"][during][:, displaced].sum(axis=1)
    return float(max(forces, key=abs)) if any(displaced) and len(forces) else None


def _stage(record: Record, end: StageEnd, *, tells: bool) -> StageOutcome:
    timed = end.stage.until == "time"
    moment = end.end if timed else end.goal_time
    return StageOutcome(
        name=end.stage.name,
        drive=stage_drives(end.stage),
        goal=end.stage.until,
        reached=end.goal_time is not None if tells and not timed else None,
        time=None if moment is None else moment - end.start,
        work=_work(record, end),
        waited=end.waited or None,
    )


def _work(record: Record, end: StageEnd) -> float:
    """Work of the motors over a stage, J."""
    before, after = (int(np.argmin(np.abs(record.time - moment))) for moment in (end.start, end.end))
    work = record.series["motor_work"]
    return sum((float(last - first) for first, last in zip(work[before], work[after], strict=True)), 0.0)
