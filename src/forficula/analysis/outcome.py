"""Outcome of a run: states, energies, work, times, verdict and the energy balance."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from typing import TYPE_CHECKING, Annotated

from forficula.analysis.advice import NOTHING, Advice, edge_advice, run_advice
from forficula.analysis.confirmation import Confirmation, Values, confirm, undecided, undecided_text
from forficula.analysis.resolution import unresolved_stops
from forficula.analysis.states import State, named_state
from forficula.analysis.transition_runs import (
    TransitionOutcome,
    TransitionRun,
    early_goal,
    has_bounds,
    motor_work,
    transition_outcome,
    transition_run,
)
from forficula.analysis.verdict import ENDING_TEXTS, Ending, Verdict, ending_text
from forficula.design import Design, stage_drives
from forficula.displayed import Displayed
from forficula.dynamics import AnyRun, EnergyBalance, NumericalCheck, Record, StageEnd, as_record, energy_balance
from forficula.quantities import show_duration, show_value
from forficula.results import pandas_module
from forficula.serial import Joules, Key, Seconds, Written
from forficula.structure import (
    RestState,
    Structure,
    drive_of,
)

if TYPE_CHECKING:
    from forficula.results import Series


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
    runs = [transition_run(record, transition) for transition in structure.transitions]
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
        state.name: led_to[state.name] if state.name in led_to else named_state(record, state)
        for state in structure.states
    }
    return Outcome(
        ending=ending,
        status=ending_text(ending),
        holds=holds,
        states=states,
        state_names={state.name: _rest_name(state, states[state.name], holds) for state in structure.states},
        transitions={run.transition.name: transition_outcome(record, run, holds) for run in runs},
        stages=tuple(_stage(record, end, conclusive=verdict.conclusive) for end in record.stages),
        energy_balance=balance,
        name=record.design.name,
        structure=structure,
        advise=partial(run_advice, record, ending),
    )


def _reason_text(record: Record, verdict: Verdict, missed: StageEnd | None, run: TransitionRun | None) -> str:
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


def _transition_run_of(runs: list[TransitionRun], end: StageEnd) -> TransitionRun | None:
    """Return the transition that a stage drives, or whose goal ends the stage."""
    drives = stage_drives(end.stage)
    for run in runs:
        if end in (run.driven, run.ended, run.missed):
            return run
    return next((run for run in runs if run.transition.goal == end.stage.until or run.transition.drive in drives), None)


def _missed(record: Record, runs: list[TransitionRun]) -> StageEnd | None:
    """Return the first stage whose goal was missed or lost when released; None if there is none."""
    for run in runs:
        if run.driven is not None and not run.holds:
            return run.missed or run.ended or run.driven
    last = record.stages[-1]
    has_goal = last.stage.wait or has_bounds(record, last)
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


def _rest_name(state: RestState, resting: State | None, holds: Mapping[str, bool | None]) -> str:
    if state.name in holds:
        held = holds[state.name]
        return state.unknown if held is None else state.name if held else state.missed
    return state.name if resting is None or resting.within else state.missed


def _stage(record: Record, end: StageEnd, *, conclusive: bool) -> StageOutcome:
    timed = end.stage.until == "time"
    moment = end.end if timed else end.goal_time
    return StageOutcome(
        name=end.stage.name,
        drive=stage_drives(end.stage),
        goal=end.stage.until,
        reached=end.goal_time is not None if conclusive and not timed else None,
        time=None if moment is None else moment - end.start,
        work=motor_work(record, end.start, end.end),
        waited=end.waited or None,
        motion=end.stage.motion,
        share=end.share,
        lost=end.lost if end.stage.quasi_static else None,
    )
