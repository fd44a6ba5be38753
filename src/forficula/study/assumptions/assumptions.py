"""A design with one modelling assumption changed at a time: what each does to the verdict, times and works."""

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
from forficula.study.running.runs import half_step, run_each, with_checks

if TYPE_CHECKING:
    from xarray import Dataset

    from forficula.results import DataFrame

# a run that says nothing of the structure is repeated at a timestep shorter by this factor, twice at most
_SHORTER, _REPEATS = 4, 2
# the assumptions of the computation itself, whose runs confirm that of the design
_CHECKS = {"timestep": HALF_STEP, "start": OTHER_START}


class Effect(StrEnum):
    """What a changed assumption changes in a result."""

    VERDICT = "verdict"  # another verdict
    NUMBERS = "numbers"  # a time or a work differs by more than 2 % and by more than its numerical uncertainty
    NOTHING = "nothing"
    UNKNOWN = "unknown"  # the run diverged, is unreliable or undecided, or cannot be built


@dataclass(frozen=True, kw_only=True)
class TransitionName:
    """What a transition of a structure is called.

    Attributes:
        name: of its own, such as "fold".
        time: what its time is called, such as "fold time".
        noun: what it is called itself, such as "folding" in "work of folding".
    """

    name: str
    time: str
    noun: str


@dataclass(frozen=True, kw_only=True)
class AssumptionRun:
    """A run of a design with one assumption changed, or of the design itself.

    Attributes:
        name: of the assumption; "as designed" for the design itself.
        label: what is assumed, such as "drives rise over 0.2 s".
        meaning: what the design assumes, and what is assumed instead, in a sentence.
        timestep: of the run, s.
        verdict: what the run came to; undecided where a run at half the timestep has another verdict.
        goal: name of the transition that the verdict is about, or "none".
        word: what the run came to, without its numbers.
        status: what the run came to, in a few words.
        times: by transition, from the start of its stage until its goal was reached, s; None where it failed.
        works: by transition, of the motors over the stage, J; None where the protocol did not get there.
        effect: of the change.
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
    """What each modelling assumption of a design does to its result.

    Attributes:
        design: whose assumptions are changed.
        transitions: of its structure, in the order of the protocol.
        own: the run of the design itself.
        runs: with one assumption changed each, in the order of `ASSUMPTIONS`.
        left_out: why an assumption does not apply, by its name.
        uncertainty: numerical uncertainty of times, s, and works, J, of the design itself, by name as in "fold.time";
            from half the timestep and another start.
        versions: of forficula and of the packages that computed the runs, by name.
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
        """Which assumptions decide the result, in a sentence without its full stop."""
        unknown = sum(run.effect is Effect.UNKNOWN for run in self.runs)
        tried = counted(len(self.runs), "changed assumption")
        rest = f"; {unknown} of {len(self.runs)} changes have no reliable result" if unknown else ""
        if not self.own.verdict.tells:
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

        Dimensions are `run`, the design itself first, and `transition`. Variables are `label`, `effect`, `verdict`,
        `status` and `timestep` (run,), and `time` and `work` (run, transition), SI, nan where there is none.
        """
        import xarray

        runs, names = (self.own, *self.runs), [each.name for each in self.transitions]
        words = {
            name: ("run", [str(getattr(run, name)) for run in runs])
            for name in ("label", "effect", "verdict", "status")
        }
        times, works = (
            [[_or_nan(values[each]) for each in names] for values in every]
            for every in ([run.times for run in runs], [run.works for run in runs])
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
    """Run a design with one modelling assumption changed at a time, all of them side by side.

    A run takes the timestep of the design, or a shorter one where the change makes the structure stiffer. A run that
    says nothing of the structure is repeated at a quarter of its timestep, twice at most. A change of the verdict is
    confirmed at half the timestep.

    Args:
        design: whose assumptions are changed; a timestep "auto" is found first.
        assumptions: to change.
        progress: called now and then with the runs done and the stage, the time of the stage and the longest it can
            take, s.

    Raises:
        InputError: the design cannot be built.
    """
    counting = _Counting(progress)
    stepped = counting.stepped(design)
    variants: dict[str, tuple[Assumption, Variant]] = {}
    left_out: dict[str, str] = {}
    for assumption in assumptions:
        found = variant_of(assumption, stepped)
        try:
            if isinstance(found, Variant) and assumption.name not in _CHECKS:
                found = replace(found, design=_resolving(found.design, stepped))
        except InputError as error:
            found = str(error)
        if isinstance(found, Variant):
            variants[assumption.name] = (assumption, found)
        else:
            left_out[assumption.name] = found
    records = counting.run({"": stepped} | {name: variant.design for name, (_, variant) in variants.items()})
    own = records.pop("")
    if isinstance(own, InputError):
        raise own
    checks = {check: records[name] for name, check in _CHECKS.items() if name in records}
    outcome = measure(with_checks(own, checks))
    left_out |= {name: str(each) for name, each in records.items() if isinstance(each, InputError)}
    outcomes = _reliable({name: each for name, each in records.items() if isinstance(each, Record)}, counting)
    confirmed = _confirmed(outcomes, outcome, counting)
    first = _run("as designed", "as designed", "The design itself.", outcome, own)
    sure = {} if outcome.confirmation is None else outcome.confirmation.uncertainty
    uncertainty = {name: each[0] for name, each in sure.items() if name.endswith((".time", ".work"))}
    runs = []
    for name, (assumption, variant) in variants.items():
        if name in confirmed:
            run = _run(name, variant.label, assumption.meaning, *confirmed[name])
            runs.append(replace(run, effect=effect_of(run, first, uncertainty)))
    return Assumptions(
        design=design,
        transitions=_names(own.structure),
        own=first,
        runs=tuple(runs),
        left_out={each.name: left_out[each.name] for each in assumptions if each.name in left_out},
        uncertainty=uncertainty,
        versions=versions(),
    )


def effect_of(run: AssumptionRun, own: AssumptionRun, uncertainty: Mapping[str, float]) -> Effect:
    """Return what a changed assumption does, beside the numerical uncertainty of the design's own run.

    Args:
        run: with the change.
        own: of the design itself.
        uncertainty: see `Assumptions`.
    """
    if not (run.verdict.tells and own.verdict.tells):
        return Effect.UNKNOWN
    if (run.verdict, run.goal) != (own.verdict, own.goal):
        return Effect.VERDICT
    for kind, values, others in (("time", run.times, own.times), ("work", run.works, own.works)):
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
    """Run batches of designs and count the runs for a progress."""

    def __init__(self, progress: Progress | None) -> None:
        self._progress, self._done, self._needed = progress, 0, 0

    def stepped(self, design: Design) -> Design:
        """Return the design with the timestep that a run of it takes."""
        if design.protocol.timestep != "auto":
            return design
        record = self.run({"": design})[""]
        if isinstance(record, InputError):
            raise record
        return design.model_copy(update={"protocol": record.design.protocol})

    def run(self, designs: Mapping[str, Design]) -> dict[str, Record | InputError]:
        """Run designs side by side, by name, and keep of each record only what an outcome needs."""
        self._needed += len(designs)
        names, records = list(designs), {}
        telling = None if self._progress is None else self._told
        for number, record in run_each(list(designs.values()), sparse=True, progress=telling):
            records[names[number]] = record
            self._done += 1
        return records

    def _told(self, stage: str, time: float, longest: float) -> None:
        if self._progress is not None:
            self._progress(f"{self._done} of {self._needed} runs, {stage}", time, longest)


def _resolving(changed: Design, design: Design) -> Design:
    """The changed design with a timestep that is shorter by as much as its estimate is, where that is too long."""
    own = float(design.protocol.timestep)
    estimates = [
        float(with_timestep(put(each, "protocol.timestep", "auto")).protocol.timestep) for each in (changed, design)
    ]
    if estimates[0] >= own:
        return changed
    return put(changed, "protocol.timestep", own * min(1.0, estimates[0] / estimates[1]))


def _reliable(records: dict[str, Record], counting: _Counting) -> dict[str, tuple[Outcome, Record]]:
    """Outcomes and records by name; those that say nothing are repeated at shorter timesteps."""
    outcomes = {name: (measure(record), record) for name, record in records.items()}
    for _ in range(_REPEATS):
        silent = {name: record for name, (outcome, record) in outcomes.items() if not outcome.verdict.tells}
        shorter = {
            name: put(record.design, "protocol.timestep", float(record.design.protocol.timestep) / _SHORTER)
            for name, record in silent.items()
            if name not in _CHECKS
        }
        again = counting.run(shorter) if shorter else {}
        outcomes |= {name: (measure(each), each) for name, each in again.items() if isinstance(each, Record)}
    return outcomes


def _confirmed(
    outcomes: Mapping[str, tuple[Outcome, Record]], own: Outcome, counting: _Counting
) -> dict[str, tuple[Outcome, Record]]:
    """The same, where the verdict is another one held against a run at half the timestep."""
    if not own.verdict.tells:
        return dict(outcomes)
    ending = (own.verdict, own.ending.goal)
    halves = {
        name: half_step(record.design)
        for name, (outcome, record) in outcomes.items()
        if name not in _CHECKS and outcome.verdict.tells and (outcome.verdict, outcome.ending.goal) != ending
    }
    checked = dict(outcomes)
    for name, half in (counting.run(halves) if halves else {}).items():
        record = with_checks(outcomes[name][1], {HALF_STEP: half})
        checked[name] = (measure(record), record)
    return checked


def _run(name: str, label: str, meaning: str, outcome: Outcome, record: Record) -> AssumptionRun:
    made = {each.name: outcome.transitions[each.name] for each in record.structure.transitions}
    return AssumptionRun(
        name=name,
        label=label,
        meaning=meaning,
        timestep=float(record.design.protocol.timestep),
        verdict=outcome.verdict,
        goal=outcome.ending.goal,
        word=ending_word(outcome.ending),
        status=outcome.status,
        times={each: None if found is None else found.time for each, found in made.items()},
        works={each: _finite(None if found is None else found.work) for each, found in made.items()},
    )


def _names(structure: Structure) -> tuple[TransitionName, ...]:
    return tuple(
        TransitionName(name=each.name, time=each.wording.time, noun=each.wording.noun) for each in structure.transitions
    )
