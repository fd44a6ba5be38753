"""Sensitivity of a result to modelling assumptions, changed one at a time: effect on verdict, times and works."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import TYPE_CHECKING, Annotated

from forficula.analysis import Outcome, Verdict, measure
from forficula.analysis.confirmation import HALF_STEP, OTHER_START, SETTLED_WITHIN
from forficula.analysis.verdict import ending_word
from forficula.design import Design, design_text, put
from forficula.design.design import DesignIdentity
from forficula.dynamics import Record, versions, with_timestep
from forficula.dynamics.stepping.simulate import Progress
from forficula.errors import InputError
from forficula.names import counted
from forficula.results import Result
from forficula.serial import Joules, Key, Seconds, WithUnit, Written
from forficula.structure import Structure
from forficula.study.assumptions.modelling_assumptions import ASSUMPTIONS, Assumption, Variant, variant_of
from forficula.study.running.numerical_settings import finds_settings
from forficula.study.running.runs import run_each
from forficula.study.running.second_runs import half_step, with_checks

if TYPE_CHECKING:
    from xarray import Dataset

    from forficula.results import DataFrame

# a run without a conclusive verdict is repeated at a timestep shorter by this factor, at most twice
_SHORTER, _REPEATS = 4, 2
# assumptions of the computation itself; the runs that change them also confirm the run of the design
_CHECKS = {"timestep": HALF_STEP, "start": OTHER_START}


class Effect(StrEnum):
    """Effect of a changed assumption on a result."""

    VERDICT = "verdict"  # another verdict
    NUMBERS = "numbers"  # a time or a work differs by more than 2 % and by more than its numerical uncertainty
    NOTHING = "nothing"
    UNKNOWN = "unknown"  # the run diverged, is unreliable or undecided, or cannot be built


@dataclass(frozen=True, kw_only=True)
class TransitionName:
    """Names of a transition of a structure.

    Attributes:
        name: name of the transition, such as "fold".
        time: name of its time, such as "fold time".
        noun: noun for the process, such as "folding" in "work of folding".
    """

    name: str
    time: str
    noun: str


@dataclass(frozen=True, kw_only=True)
class AssumptionRun:
    """A run of a design with one assumption changed, or of the design itself.

    Attributes:
        name: name of the assumption; "as designed" for the design itself.
        label: the changed assumption, such as "drives rise over 0.2 s".
        meaning: the assumption of the design and the changed assumption, in a sentence.
        timestep: timestep of the run, s.
        verdict: verdict of the run; undecided if a run at half the timestep has another verdict.
        goal: name of the transition that the verdict is about, or "none".
        word: outcome without its numbers.
        status: outcome in a few words.
        times: by transition, from the start of its stage until its goal was reached, s; None if it failed.
        works: by transition, work of the motors over the stage, J; None if the protocol did not reach the stage.
        effect: effect of the change.
    """

    name: str
    label: str
    meaning: str
    effect: Effect = Effect.NOTHING
    timestep: Seconds
    verdict: Verdict
    goal: str
    word: str
    status: str
    times: Annotated[Mapping[str, Seconds | None], Key("time")]
    works: Annotated[Mapping[str, Joules | None], Key("work")]


@dataclass(frozen=True, kw_only=True)
class Assumptions(Result):
    """Effect of each modelling assumption on the result of a design.

    Attributes:
        design: the design whose assumptions are changed.
        transitions: transitions of its structure, in the order of the protocol.
        own: run of the unchanged design.
        runs: runs with one changed assumption each, in the order of `ASSUMPTIONS`.
        left_out: why an assumption does not apply, by its name.
        uncertainty: numerical uncertainty of times (s) and works (J) of the unchanged design, by name as in
            "fold.time"; from runs at half the timestep and from another start.
        versions: versions of forficula and of the packages that computed the runs, by name.
    """

    design: Annotated[Design, Written.NEVER]
    transitions: tuple[TransitionName, ...]
    own: AssumptionRun
    runs: tuple[AssumptionRun, ...]
    left_out: Mapping[str, str]
    uncertainty: Annotated[Mapping[str, float], Written.NEVER]
    versions: Mapping[str, str]

    def __repr__(self) -> str:
        """Design and verdict."""
        return f"<Assumptions of {self.design.name}: {self.verdict}>"

    @property
    def identity(self) -> Annotated[DesignIdentity, Written.BESIDE, Written.FIRST]:
        """Name and hash of the design."""
        return self.design.identity

    @property
    def quantities(self) -> Annotated[Mapping[str, WithUnit], Key("uncertainty")]:
        """The uncertainties with their units."""
        units = {"time": "s", "work": "J"}
        return {name: WithUnit(half, units[name.rpartition(".")[2]]) for name, half in self.uncertainty.items()}

    @property
    def design_file(self) -> Annotated[str, Written.ALWAYS]:
        """The file of the design."""
        return design_text(self.design)

    @property
    def deciding(self) -> tuple[AssumptionRun, ...]:
        """The runs whose changed assumption changes the verdict."""
        return tuple(run for run in self.runs if run.effect is Effect.VERDICT)

    @property
    def verdict(self) -> Annotated[str, Written.FIRST]:
        """Sentence, without its full stop, that states which assumptions decide the result."""
        unknown = sum(run.effect is Effect.UNKNOWN for run in self.runs)
        tried = counted(len(self.runs), "changed assumption")
        rest = f"; {unknown} of {len(self.runs)} changes have no reliable result" if unknown else ""
        if not self.own.verdict.conclusive:
            return f"{self.own.status}, so no assumption can be compared with this result"
        if not self.deciding:
            return f"{self.own.word}; none of {tried} changes the verdict{rest}"
        changes = ", ".join(f"{run.label} ({run.word})" for run in self.deciding)
        verb = "changes" if len(self.deciding) == 1 else "change"
        return f"{self.own.word}; {len(self.deciding)} of {tried} {verb} the verdict: {changes}{rest}"

    def to_dataframe(self) -> DataFrame:
        """Return the runs as a pandas table: label, effect, verdict, status, and times, s, and works, J."""
        table = self.to_xarray()
        numbers = {
            f"{transition}_{name}_{unit}": table[name].sel(transition=transition).values
            for name, unit in (("time", "s"), ("work", "J"))
            for transition in table["transition"].values.tolist()
        }
        return table.drop_dims("transition").to_dataframe().assign(**numbers)

    def to_xarray(self) -> Dataset:
        """Return the table as a dataset.

        Dimensions are `run` (the unchanged design first) and `transition`. Variables are `label`, `effect`, `verdict`,
        `status` and `timestep` (run,), and `time` and `work` (run, transition), SI, nan if missing.
        """
        import xarray

        runs, names = (self.own, *self.runs), [transition.name for transition in self.transitions]
        words = {
            name: ("run", [str(getattr(run, name)) for run in runs])
            for name in ("label", "effect", "verdict", "status")
        }
        times, works = (
            [[_or_nan(values[name]) for name in names] for values in by_run]
            for by_run in ([run.times for run in runs], [run.works for run in runs])
        )
        numbers = {
            "time": (("run", "transition"), times, {"unit": "s"}),
            "work": (("run", "transition"), works, {"unit": "J"}),
        }
        steps = {"timestep": ("run", [run.timestep for run in runs], {"unit": "s"})}
        coordinates = {"run": [run.name for run in runs], "transition": names}
        return xarray.Dataset(
            words | steps | numbers,
            coordinates,
            {"design": self.design.name, "design_hash": self.design.hash, "says": self.verdict},
        )


def _finite(value: float | None) -> float | None:
    return value if value is not None and math.isfinite(value) else None


def _or_nan(value: float | None) -> float:
    return math.nan if value is None else value


def run_assumptions(
    design: Design,
    *,
    assumptions: Sequence[Assumption] = ASSUMPTIONS,
    progress: Progress | None = None,
) -> Assumptions:
    """Run a design with one modelling assumption changed at a time. All runs are done side by side.

    A run has the timestep of the design, or a shorter one if the change makes the structure stiffer. A run without a
    conclusive verdict is repeated at a quarter of its timestep, at most twice. A change of the verdict is confirmed at
    half the timestep.

    Args:
        design: the design whose assumptions are changed. A timestep "auto" is determined first.
        assumptions: assumptions to change.
        progress: called now and then with the number of completed runs and the stage, the time of the stage and its
            time limit, s.

    Raises:
        InputError: the design cannot be built.
    """
    counting = _Counting(progress)
    stepped = counting.stepped(design)
    variants: dict[str, tuple[Assumption, Variant]] = {}
    left_out: dict[str, str] = {}
    for assumption in assumptions:
        variant = variant_of(assumption, stepped)
        try:
            if isinstance(variant, Variant) and assumption.name not in _CHECKS:
                variant = replace(variant, design=_resolving(variant.design, stepped))
        except InputError as error:
            variant = str(error)
        if isinstance(variant, Variant):
            variants[assumption.name] = (assumption, variant)
        else:
            left_out[assumption.name] = variant
    records = counting.run({"": stepped} | {name: variant.design for name, (_, variant) in variants.items()})
    record = records.pop("")
    if isinstance(record, InputError):
        raise record
    checks = {check: records[name] for name, check in _CHECKS.items() if name in records}
    outcome = measure(with_checks(record, checks))
    left_out |= {name: str(changed) for name, changed in records.items() if isinstance(changed, InputError)}
    outcomes = _reliable({name: changed for name, changed in records.items() if isinstance(changed, Record)}, counting)
    confirmed = _confirmed(outcomes, outcome, counting)
    first = _run("as designed", "as designed", "The design itself.", outcome, record)
    uncertainties = {} if outcome.confirmation is None else outcome.confirmation.uncertainty
    uncertainty = {name: half[0] for name, half in uncertainties.items() if name.endswith((".time", ".work"))}
    runs = []
    for name, (assumption, variant) in variants.items():
        if name in confirmed:
            run = _run(name, variant.label, assumption.meaning, *confirmed[name])
            runs.append(replace(run, effect=effect_of(run, first, uncertainty)))
    return Assumptions(
        design=design,
        transitions=_names(record.structure),
        own=first,
        runs=tuple(runs),
        left_out={
            assumption.name: left_out[assumption.name] for assumption in assumptions if assumption.name in left_out
        },
        uncertainty=uncertainty,
        versions=versions(),
    )


def effect_of(run: AssumptionRun, as_designed: AssumptionRun, uncertainty: Mapping[str, float]) -> Effect:
    """Return the effect of a changed assumption, given the numerical uncertainty of the unchanged design's run.

    Args:
        run: run with the change.
        as_designed: run of the unchanged design.
        uncertainty: see `Assumptions`.
    """
    if not (run.verdict.conclusive and as_designed.verdict.conclusive):
        return Effect.UNKNOWN
    if (run.verdict, run.goal) != (as_designed.verdict, as_designed.goal):
        return Effect.VERDICT
    for kind, values, others in (("time", run.times, as_designed.times), ("work", run.works, as_designed.works)):
        for name, value in values.items():
            other = others[name]
            if value is None or other is None:
                if value is not other:
                    return Effect.NUMBERS
                continue
            if abs(value - other) > max(SETTLED_WITHIN * abs(other), uncertainty.get(f"{name}.{kind}", 0.0)):
                return Effect.NUMBERS
    return Effect.NOTHING


class _Counting:
    """Run batches of designs and count the runs for the progress callback."""

    def __init__(self, progress: Progress | None) -> None:
        self._progress, self._done, self._needed = progress, 0, 0

    def stepped(self, design: Design) -> Design:
        """Return the design with the timestep and the time constant of contact that its run uses."""
        if not finds_settings(design):
            return design
        record = self.run({"": design})[""]
        if isinstance(record, InputError):
            raise record
        return record.design

    def run(self, designs: Mapping[str, Design]) -> dict[str, Record | InputError]:
        """Run designs side by side, by name, and keep only the part of each record that an outcome needs."""
        self._needed += len(designs)
        names, records = list(designs), {}
        callback = None if self._progress is None else self._report
        for number, record in run_each(list(designs.values()), sparse=True, progress=callback):
            records[names[number]] = record
            self._done += 1
        return records

    def _report(self, stage: str, time: float, longest: float) -> None:
        if self._progress is not None:
            self._progress(f"{self._done} of {self._needed} runs, {stage}", time, longest)


def _resolving(changed: Design, design: Design) -> Design:
    """Return the changed design with a shorter timestep if its estimated timestep is shorter than the design's.

    The timestep is reduced by the ratio of the two estimates.
    """
    timestep = float(design.protocol.timestep)
    estimates = [
        float(with_timestep(put(estimated, "protocol.timestep", "auto")).protocol.timestep)
        for estimated in (changed, design)
    ]
    if estimates[0] >= timestep:
        return changed
    return put(changed, "protocol.timestep", timestep * min(1.0, estimates[0] / estimates[1]))


def _reliable(records: dict[str, Record], counting: _Counting) -> dict[str, tuple[Outcome, Record]]:
    """Return outcomes and records by name. Runs without a conclusive verdict are repeated at shorter timesteps."""
    outcomes = {name: (measure(record), record) for name, record in records.items()}
    for _ in range(_REPEATS):
        inconclusive = {name: record for name, (outcome, record) in outcomes.items() if not outcome.verdict.conclusive}
        shorter = {
            name: put(record.design, "protocol.timestep", float(record.design.protocol.timestep) / _SHORTER)
            for name, record in inconclusive.items()
            if name not in _CHECKS
        }
        repeated = counting.run(shorter) if shorter else {}
        outcomes |= {name: (measure(record), record) for name, record in repeated.items() if isinstance(record, Record)}
    return outcomes


def _confirmed(
    outcomes: Mapping[str, tuple[Outcome, Record]], as_designed: Outcome, counting: _Counting
) -> dict[str, tuple[Outcome, Record]]:
    """Return the same outcomes, with changed verdicts checked by a run at half the timestep."""
    if not as_designed.verdict.conclusive:
        return dict(outcomes)
    ending = (as_designed.verdict, as_designed.ending.goal)
    halves = {
        name: half_step(record.design)
        for name, (outcome, record) in outcomes.items()
        if name not in _CHECKS and outcome.verdict.conclusive and (outcome.verdict, outcome.ending.goal) != ending
    }
    checked = dict(outcomes)
    for name, half in (counting.run(halves) if halves else {}).items():
        record = with_checks(outcomes[name][1], {HALF_STEP: half})
        checked[name] = (measure(record), record)
    return checked


def _run(name: str, label: str, meaning: str, outcome: Outcome, record: Record) -> AssumptionRun:
    transitions = {transition.name: outcome.transitions[transition.name] for transition in record.structure.transitions}
    return AssumptionRun(
        name=name,
        label=label,
        meaning=meaning,
        timestep=float(record.design.protocol.timestep),
        verdict=outcome.verdict,
        goal=outcome.ending.goal,
        word=ending_word(outcome.ending),
        status=outcome.status,
        times={name: None if transition is None else transition.time for name, transition in transitions.items()},
        works={
            name: _finite(None if transition is None else transition.work) for name, transition in transitions.items()
        },
    )


def _names(structure: Structure) -> tuple[TransitionName, ...]:
    return tuple(
        TransitionName(name=transition.name, time=transition.wording.time, noun=transition.wording.noun)
        for transition in structure.transitions
    )
