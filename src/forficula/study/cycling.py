"""A structure after many cycles: through its protocol with its tendons as they are at each of them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from forficula.design import AnyDesign, Design, as_design, with_values
from forficula.errors import InputError
from forficula.material.law.law_cycle import change_at_cycle, drifts_of, law_at_cycle, stretched_before
from forficula.material.law.material_law import MaterialLaw
from forficula.results import Result, pandas_module
from forficula.statics.slow_margin import least_slow_torques, margin
from forficula.structure import Structure, Transition, built_strains, drive_of, structure_of
from forficula.study.running.evaluate import evaluate, row_key
from forficula.study.running.journal import Row

if TYPE_CHECKING:
    from forficula.results import DataFrame

Progress = Callable[[int, int, dict[str, Any]], None]

_EVERY_COUNT = 20
_BY_DECADE = 10  # counts beyond
_LARGEST_MISS = 0.02  # of a softened spring, that goes without saying


@dataclass(frozen=True, kw_only=True)
class CycleRun:
    """One cycle: what its tendons are, and what became of the structure.

    Attributes:
        cycle: number, from 1 on.
        measured: whether the tests of the material saw this cycle.
        stiffness: of the tendons by that of the first cycle, but for softening: value, 95 % confidence interval.
        residual_strain: of the tendons, the largest.
        row: outcome of the run, as `outcome_row` has it.
        margins: by transition, the protocol's torque by the least that makes it when it grows slowly, see
            `least_slow_torques`; None where none up to ten times it does.
    """

    cycle: int
    measured: bool
    stiffness: tuple[float, float, float]
    residual_strain: float
    row: Row
    margins: Mapping[str, float | None]


@dataclass(frozen=True, kw_only=True)
class Cycling(Result):
    """A structure over cycles.

    Attributes:
        design: at the first cycle.
        runs: in the order of cycles.
        seen: first and last cycle that the tests of the material saw; None where they do not tell.
        transitions: that the protocol drives.
        verdict: in a sentence.
        remarks: what a person should know, one sentence each.
    """

    design: Design
    runs: tuple[CycleRun, ...]
    seen: tuple[int, int] | None
    transitions: tuple[Transition, ...]
    verdict: str
    remarks: tuple[str, ...]

    def __repr__(self) -> str:
        """Design and verdict."""
        return f"<Cycling of {self.design.name}: {self.verdict}>"

    def to_dataframe(self) -> DataFrame:
        """Return the cycles as a pandas table: stiffness by that of the first, residual strain, outcome, margins."""
        pandas = pandas_module()

        rows = [
            {
                "stiffness": run.stiffness[0],
                "residual_strain": run.residual_strain,
                **{name: value for name, value in run.row.items() if name != "key"},
                **{f"{name}_margin": value for name, value in run.margins.items()},
            }
            for run in self.runs
        ]
        return pandas.DataFrame(rows, index=pandas.Index([run.cycle for run in self.runs], name="cycle"))

    def works(self, run: CycleRun) -> bool:
        """Whether a cycle did what the protocol asks for: its last transition."""
        return bool(self.transitions and run.row.get(self.transitions[-1].state))

    @property
    def first_failure(self) -> int | None:
        """The first cycle that did not work, after one that did; None where there is none."""
        works = [self.works(run) for run in self.runs]
        later = (index for index in range(1, len(works)) if works[index - 1] and not works[index])
        return next((self.runs[index].cycle for index in later), None)


def cycle_counts(last: int) -> tuple[int, ...]:
    """The cycles to look at: each up to 20, and ten a decade beyond, the last one among them.

    Raises:
        InputError: the last is not >= 1.
    """
    if last < 1:
        raise InputError(f"need a whole number >= 1, got {last}")
    counts = list(range(1, min(last, _EVERY_COUNT) + 1))
    if last > _EVERY_COUNT:
        steps = int(np.ceil(_BY_DECADE * np.log10(last / _EVERY_COUNT)))
        counts += [round(each) for each in np.geomspace(_EVERY_COUNT, last, steps + 1)[1:-1]] + [last]
    return tuple(sorted(set(counts)))


def why_unchanged(design: Design) -> str:
    """Why the tendons of a design are the same at every cycle, in a sentence; empty where they change."""
    structure = structure_of(design)
    strained = _strained(structure)
    if not strained:
        return "the design has no tendon.law, so nothing tells how cycles change its tendons: every cycle is the first"
    law = _material(structure)
    name = law.name or "the tendons"
    softens = law.softening is not None and max(strained.values()) > law.residual_strain
    if softens or any(drift.kind != "none" for drift in drifts_of(law).values()):
        return ""
    seen = _seen(law)
    if seen is None:
        return f"the law of {name} has no drift, so nothing tells how cycles change it: every cycle is the first"
    return f"the tests of {name}, cycles {seen[0]} to {seen[1]}, show no drift: every cycle is the first"


def design_at_cycle(design: Design, cycle: int) -> Design:
    """A design with its tendons as they are at a cycle.

    The drift of the law is taken to that cycle. A law that softens is, from the second cycle on, what it is after the
    stretch of the built shape. Every cycle is a run of its own that begins with rested tendons.

    Args:
        design: whose tendons have a law.
        cycle: from 1 on.
    """
    laws = _laws_at(structure_of(design), cycle)
    return with_values(design, {f"{key}.law": law for key, (law, _) in laws.items()})


def run_cycles(design: AnyDesign, last: int, progress: Progress | None = None) -> Cycling:
    """Take a structure through its protocol with its tendons as they are at each of many cycles, side by side.

    Args:
        design: whose tendons change.
        last: cycle to look at; which others, see `cycle_counts`.
        progress: called with the runs done, the most that there can be, and the last one's row.

    Raises:
        InputError: the tendons do not change, the protocol drives no transition, or the last is not >= 1.
    """
    design = as_design(design)
    check_cycles(design, last)
    if reason := why_unchanged(design):
        raise InputError(f"cycles: {reason}")
    structure, counts = structure_of(design), cycle_counts(last)
    law = _material(structure)
    designs = [design_at_cycle(design, cycle) for cycle in counts]
    distinct = {row_key(each): each for each in designs}
    rows: dict[str, Row] = {}
    for row in evaluate(list(distinct.values())):
        rows[str(row["key"])] = row
        if progress is not None:
            progress(len(rows), len(distinct), row)
    by_transition = [each.tolist() for each in least_slow_torques(list(distinct.values()))]
    least = dict(zip(distinct, zip(*by_transition, strict=True), strict=True))
    cycling = Cycling(
        design=design,
        runs=tuple(
            _run_at(law, cycle, each, rows[row_key(each)], least[row_key(each)])
            for cycle, each in zip(counts, designs, strict=True)
        ),
        seen=_seen(law),
        transitions=driven_transitions(structure),
        verdict="",
        remarks=tuple(_remarks(structure, counts)),
    )
    rough = any(hinge.friction for hinge in structure.hinges)
    left_out = (
        ("the least slow torques, and the margins over them, leave out the dry friction of hinges",) if rough else ()
    )
    remarks = (*cycling.remarks, *left_out, *_unsettled(cycling), *_beside_statics(cycling))
    return replace(cycling, verdict=_verdict(cycling), remarks=remarks)


def check_cycles(design: Design, last: int) -> None:
    """Refuse what cannot be cycled, before a run that takes a while.

    Raises:
        InputError: the protocol drives no transition, the last cycle is not >= 1, or tendons are of several materials.
    """
    cycle_counts(last)
    structure = structure_of(design)
    if _strained(structure):
        _material(structure)
    if not driven_transitions(structure):
        drives = " or ".join(f'"{drive.name}"' for drive in structure.drives[:1])
        raise InputError(f"need a stage with drive = {drives} in protocol.stages, got none")


def driven_transitions(structure: Structure) -> tuple[Transition, ...]:
    """The transitions that a structure's protocol drives."""
    return tuple(each for each in structure.transitions if each.stage is not None)


def _strained(structure: Structure) -> dict[str, float]:
    """The largest strain, as built, of the tendons of each key of the design under which there is a law."""
    strained: dict[str, float] = {}
    for tendon, strain in zip(structure.tendons, built_strains(structure).tolist(), strict=True):
        if tendon.material is not None:
            strained[tendon.key] = max(strain, strained.get(tendon.key, strain))
    return strained


def _material(structure: Structure) -> MaterialLaw:
    """The material of the tendons that are of one.

    Raises:
        InputError: there is none, or there are several.
    """
    given = dict.fromkeys(tendon.material for tendon in structure.tendons if tendon.material is not None)
    if not given:
        raise InputError(f"{structure.name}: has no tendon.law")
    first, *others = given
    if others:
        names = ", ".join(each.name or "one without a name" for each in given)
        raise InputError(f"cycles: need tendons of one material, whose tests saw the same cycles, got {names}")
    return first


def _laws_at(structure: Structure, cycle: int) -> dict[str, tuple[MaterialLaw, float]]:
    """Laws at a cycle by the key of their tendons, and what their softened springs miss, shares of the peak stress."""
    law = law_at_cycle(_material(structure), cycle)
    laws = {}
    for key, strain in _strained(structure).items():
        peak = min(strain - law.residual_strain, law.yield_strain or np.inf)
        laws[key] = stretched_before(law, peak) if cycle > 1 and peak > 0 else (law, 0.0)
    return laws


def _run_at(law: MaterialLaw, cycle: int, design: Design, row: Row, least: Sequence[float]) -> CycleRun:
    """A cycle of tendons that had a law at the first, its design and what became of it."""
    seen, drift = _seen(law), law.stiffness_drift
    structure = structure_of(design)
    sets = [each.material.residual_strain for each in structure.tendons if each.material is not None]
    return CycleRun(
        cycle=cycle,
        measured=seen is not None and seen[0] <= cycle <= seen[1],
        stiffness=(1.0, 1.0, 1.0) if drift is None else change_at_cycle(drift, cycle),
        residual_strain=max(sets, default=0.0),
        row=row,
        margins={
            each.name: margin(abs(drive_of(structure, each.drive).strength), torque)
            for each, torque in zip(structure.transitions, least, strict=True)
        },
    )


def _seen(law: MaterialLaw) -> tuple[int, int] | None:
    """First and last cycle that all drifts have seen."""
    drifts = drifts_of(law).values()
    return (max(each.seen[0] for each in drifts), min(each.seen[1] for each in drifts)) if drifts else None


def _remarks(structure: Structure, counts: Sequence[int]) -> Iterator[str]:
    last, law = counts[-1], _material(structure)
    seen = _seen(law)
    if seen is None:
        yield "the tests do not tell whether the material drifts: all that changes is its softening after cycle 1"
    else:
        if seen[0] > 1:
            unseen = "cycle 1 is" if seen[0] == 2 else f"cycles 1 to {seen[0] - 1} are"
            yield f"{unseen} taken to be like cycle {seen[0]}, the first that the tests tell of"
        if last > seen[1]:
            yield f"cycles beyond {seen[1]} are extrapolated: the tests saw cycles {seen[0]} to {seen[1]}"
    drift = law.stiffness_drift
    if drift is not None and drift.kind != "none":
        middle, low, high = change_at_cycle(drift, last)
        yield f"at cycle {last} the tendons are {middle:.3g} times as stiff ({low:.3g} to {high:.3g}) as at cycle 1"
    drift = law.residual_strain_drift
    if drift is not None and drift.kind != "none":
        middle, low, high = (100 * each for each in change_at_cycle(drift, last))
        yield f"at cycle {last} their set is longer by {middle:.3g} % of their length ({low:.3g} to {high:.3g} %)"
    if law.branches:
        whole = structure.appearance.whole
        yield f"every cycle begins with tendons at rest: their Maxwell branches have relaxed in the flat {whole}"
    if last > _EVERY_COUNT:
        yield f"beyond cycle {_EVERY_COUNT} only every few are run: {', '.join(map(str, counts[_EVERY_COUNT:]))}"
    told = {counts[-1], counts[min(1, len(counts) - 1)]}
    missed = max(share for cycle in told for _, share in _laws_at(structure, cycle).values())
    if missed > _LARGEST_MISS:
        yield f"the softened spring is a polynomial that misses the law by up to {missed:.0%} of its largest stress"


def _unsettled(cycling: Cycling) -> Iterator[str]:
    """What it means where cycles that work and cycles that do not take turns."""
    works = [cycling.works(run) for run in cycling.runs]
    turns = [index for index in range(1, len(works)) if works[index] != works[index - 1]]
    if len(turns) > 1:
        first, last = (cycling.runs[index].cycle for index in (turns[0], turns[-1]))
        yield (
            f"from cycle {first} to {last} it is on an edge: what decides is how its hinges swing when they arrive,"
            " which the timestep alters, too"
        )


def _beside_statics(cycling: Cycling) -> Iterator[str]:
    """What a margin means where the simulation says something else."""
    for place, transition in enumerate(cycling.transitions):
        name, goal = transition.name, transition.state
        margins = [run.margins[name] for run in cycling.runs if run.row.get(goal)]
        if any(each is None or each < 1 for each in margins):
            yield f"its {name} torque, grown slowly, is too small at some cycles: there it is inertia that carries it"
        before = cycling.transitions[place - 1].state if place else None
        left = [run for run in cycling.runs if not run.row.get(goal) and (before is None or run.row.get(before))]
        if any((run.margins[name] or 0) > 1 for run in left):
            yield (
                f"at some cycles its {name} torque fails where a slow one succeeds: it comes at once and leads"
                " elsewhere, or its stage is too short"
            )


def _verdict(cycling: Cycling) -> str:
    """Whether it still works after the last cycle, and up to which or from which on where it does not."""
    first, last = cycling.transitions[0], cycling.transitions[-1]
    began = [bool(run.row.get(first.state)) for run in cycling.runs]
    verbs = [each.wording.does for each in cycling.transitions]
    if first is not last and any(began) and not any(run.row.get(last.state) for run in cycling.runs):
        return f"{verbs[-1]} at none of the {_cycles(cycling.runs[-1].cycle)}; {_course(cycling, began, verbs[0])}"
    return _course(cycling, [cycling.works(run) for run in cycling.runs], " and ".join(verbs))


def _course(cycling: Cycling, works: Sequence[bool], goal: str) -> str:
    """At which cycles it does something, in words."""
    runs, last = cycling.runs, cycling.runs[-1].cycle
    if all(works):
        return f"still {goal} after {_cycles(last)}"
    if not any(works):
        return f"{goal} at none of the {_cycles(last)}: {runs[0].row['status']}"
    begins = works.index(True)
    if all(works[begins:]):
        return f"{goal} only from cycle {runs[begins].cycle} on, before: {runs[0].row['status']}"
    ends = begins + list(works[begins:]).index(False)
    again = "; some later cycles do" if any(works[ends:]) else ""
    start = "" if begins == 0 else f" from cycle {runs[begins].cycle} on,"
    failed = f"at cycle {runs[ends].cycle}: {runs[ends].row['status']}"
    return f"{goal}{start} up to cycle {runs[ends - 1].cycle}; {failed}{again}"


def _cycles(count: int) -> str:
    return "1 cycle" if count == 1 else f"{count} cycles"
