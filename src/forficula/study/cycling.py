"""Behaviour of a structure after many cycles: its protocol is run with the tendons of each cycle."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from forficula.design import AnyDesign, Design, as_design, with_values
from forficula.design.protocol import stage_drives
from forficula.errors import InputError
from forficula.material.law.law_cycle import change_at_cycle, drifts_of, law_at_cycle, stretched_before
from forficula.material.law.material_law import MaterialLaw
from forficula.results import Result, pandas_module
from forficula.statics.path_dependence import refuse_path_dependence
from forficula.statics.slow_margin import least_slow_torques, margin
from forficula.structure import Structure, Transition, built_strains, drive_of, structure_of
from forficula.study.running.evaluate import evaluate, row_key
from forficula.study.running.journal import Row

if TYPE_CHECKING:
    from forficula.results import DataFrame

Progress = Callable[[int, int, dict[str, Any]], None]

_EVERY_COUNT = 20  # all cycles up to this one are run
_BY_DECADE = 10  # number of cycles per decade beyond
_LARGEST_MISS = 0.02  # deviation of a softened spring from its law that needs no remark


@dataclass(frozen=True, kw_only=True)
class CycleRun:
    """One cycle: its tendons and the outcome of its run.

    Attributes:
        cycle: number, from 1.
        measured: whether this cycle was within the tests of the material.
        stiffness: stiffness of the tendons divided by that of the first cycle, without softening: value, 95 %
            confidence interval.
        residual_strain: largest one of the tendons.
        row: outcome of the run, as returned by `outcome_row`.
        margins: by transition, the protocol's torque divided by the least torque that makes the transition when it
            grows slowly, see `least_slow_torques`; None if no torque up to ten times the protocol's does.
    """

    cycle: int
    measured: bool
    stiffness: tuple[float, float, float]
    residual_strain: float
    row: Row
    margins: Mapping[str, float | None]


@dataclass(frozen=True, kw_only=True)
class Cycling(Result):
    """Behaviour of a structure over cycles.

    Attributes:
        design: design at the first cycle.
        runs: in the order of cycles.
        seen: first and last cycle of the material's tests; None if the tests do not report cycles.
        transitions: transitions that the protocol drives.
        verdict: conclusion, in a sentence.
        remarks: notes on the validity of the result, one sentence each.
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
        """Return whether the last transition of the protocol was reached in a cycle."""
        return bool(self.transitions and run.row.get(self.transitions[-1].state))

    @property
    def first_failure(self) -> int | None:
        """The first cycle that did not work after one that did; None if there is none."""
        works = [self.works(run) for run in self.runs]
        later = (index for index in range(1, len(works)) if works[index - 1] and not works[index])
        return next((self.runs[index].cycle for index in later), None)


def cycle_counts(last: int) -> tuple[int, ...]:
    """Return the cycles to run: all up to 20, ten per decade beyond, and the last one.

    Raises:
        InputError: the last one is not >= 1.
    """
    if last < 1:
        raise InputError(f"need a whole number >= 1, got {last}")
    counts = list(range(1, min(last, _EVERY_COUNT) + 1))
    if last > _EVERY_COUNT:
        steps = int(np.ceil(_BY_DECADE * np.log10(last / _EVERY_COUNT)))
        counts += [round(cycle) for cycle in np.geomspace(_EVERY_COUNT, last, steps + 1)[1:-1]] + [last]
    return tuple(sorted(set(counts)))


def why_unchanged(design: Design) -> str:
    """Return a sentence that says why the tendons of a design are the same at every cycle; empty if they change."""
    structure = structure_of(design)
    strained = _strained(structure)
    if not strained:
        return "the design has no tendon.law that says how cycles change its tendons: every cycle is like the first"
    law = _material(structure)
    name = law.name or "the tendons"
    softens = law.softening is not None and max(strained.values()) > law.residual_strain
    if softens or any(drift.kind != "none" for drift in drifts_of(law).values()):
        return ""
    tested = _seen(law)
    if tested is None:
        return (
            f"the law of {name} has no drift, so the effect of cycles on it is unknown: every cycle is like the first"
        )
    return f"the tests of {name}, cycles {tested[0]} to {tested[1]}, show no drift: every cycle is like the first"


def design_at_cycle(design: Design, cycle: int) -> Design:
    """Return a design with the tendons of a cycle.

    The drift of the law is evaluated at this cycle. From the second cycle on, a law that softens has been stretched as
    in the built shape. The run of every cycle begins with rested tendons.

    Args:
        design: design with a law for its tendons.
        cycle: number of the cycle, from 1.
    """
    laws = _laws_at(structure_of(design), cycle)
    return with_values(design, {f"{key}.law": law for key, (law, _) in laws.items()})


def run_cycles(design: AnyDesign, last: int, progress: Progress | None = None) -> Cycling:
    """Run the protocol of a structure with its tendons as they are at each of many cycles. The runs are independent.

    Args:
        design: a design whose tendons change with cycles.
        last: last cycle; for the others see `cycle_counts`.
        progress: called with the number of completed runs, the largest possible number, and the row of the last run.

    Raises:
        InputError: the tendons do not change, the protocol drives no transition, or the last cycle is not >= 1.
    """
    design = as_design(design)
    check_cycles(design, last)
    if reason := why_unchanged(design):
        raise InputError(f"cycles: {reason}")
    structure, counts = structure_of(design), cycle_counts(last)
    law = _material(structure)
    designs = [design_at_cycle(design, cycle) for cycle in counts]
    distinct = {row_key(cycled): cycled for cycled in designs}
    rows: dict[str, Row] = {}
    for row in evaluate(list(distinct.values())):
        rows[str(row["key"])] = row
        if progress is not None:
            progress(len(rows), len(distinct), row)
    by_transition = [torques.tolist() for torques in least_slow_torques(list(distinct.values()))]
    least = dict(zip(distinct, zip(*by_transition, strict=True), strict=True))
    cycling = Cycling(
        design=design,
        runs=tuple(
            _run_at(law, cycle, cycled, rows[row_key(cycled)], least[row_key(cycled)])
            for cycle, cycled in zip(counts, designs, strict=True)
        ),
        seen=_seen(law),
        transitions=driven_transitions(structure),
        verdict="",
        remarks=tuple(_remarks(structure, counts)),
    )
    has_friction = any(hinge.friction for hinge in structure.hinges)
    friction_remark = (
        ("the least slow torques, and the margins over them, ignore the dry friction of hinges",)
        if has_friction
        else ()
    )
    remarks = (*cycling.remarks, *friction_remark, *_unsettled(cycling), *_beside_statics(cycling))
    return replace(cycling, verdict=_verdict(cycling), remarks=remarks)


def check_cycles(design: Design, last: int) -> None:
    """Reject a design that cannot be cycled, before runs that take a while.

    Raises:
        InputError: the protocol drives no transition, the last cycle is not >= 1, tendons have several materials, or a
            crease folds permanently.
    """
    cycle_counts(last)
    structure = structure_of(design)
    refuse_path_dependence(structure, "least slow torques")
    if _strained(structure):
        _material(structure)
    if not driven_transitions(structure):
        drives = " or ".join(f'"{drive.name}"' for drive in structure.drives[:1])
        driven = [stage.until for stage in design.protocol.stages if stage_drives(stage)]
        if driven:
            raise InputError(
                'need a driven stage that ends at a goal, such as until = "creases > 90 deg", and leads to a state,'
                f' got until = "{driven[0]}"'
            )
        raise InputError(f"need a stage with drive = {drives} in protocol.stages, got none")


def driven_transitions(structure: Structure) -> tuple[Transition, ...]:
    """Return the transitions that a structure's protocol drives."""
    return tuple(transition for transition in structure.transitions if transition.stage is not None)


def _strained(structure: Structure) -> dict[str, float]:
    """Return the largest built strain of the tendons under each key of the design that has a law."""
    strained: dict[str, float] = {}
    for tendon, strain in zip(structure.tendons, built_strains(structure).tolist(), strict=True):
        if tendon.material is not None:
            strained[tendon.key] = max(strain, strained.get(tendon.key, strain))
    return strained


def _material(structure: Structure) -> MaterialLaw:
    """Return the common material of the tendons.

    Raises:
        InputError: no material, or several.
    """
    materials = dict.fromkeys(tendon.material for tendon in structure.tendons if tendon.material is not None)
    if not materials:
        raise InputError(f"{structure.name}: has no tendon.law")
    first, *others = materials
    if others:
        names = ", ".join(material.name or "one without a name" for material in materials)
        raise InputError(f"cycles: need tendons of one material, got {names}")
    return first


def _laws_at(structure: Structure, cycle: int) -> dict[str, tuple[MaterialLaw, float]]:
    """Return laws at a cycle by the key of their tendons, with the misfit of softened springs / peak stress."""
    law = law_at_cycle(_material(structure), cycle)
    laws = {}
    for key, strain in _strained(structure).items():
        peak = min(strain - law.residual_strain, law.yield_strain or np.inf)
        laws[key] = stretched_before(law, peak) if cycle > 1 and peak > 0 else (law, 0.0)
    return laws


def _run_at(law: MaterialLaw, cycle: int, design: Design, row: Row, least: Sequence[float]) -> CycleRun:
    """Return the result of a cycle: its tendons, its design and its outcome."""
    tested, drift = _seen(law), law.stiffness_drift
    structure = structure_of(design)
    residual_strains = [tendon.material.residual_strain for tendon in structure.tendons if tendon.material is not None]
    return CycleRun(
        cycle=cycle,
        measured=tested is not None and tested[0] <= cycle <= tested[1],
        stiffness=(1.0, 1.0, 1.0) if drift is None else change_at_cycle(drift, cycle),
        residual_strain=max(residual_strains, default=0.0),
        row=row,
        margins={
            transition.name: margin(abs(drive_of(structure, transition.drive).strength), torque)
            for transition, torque in zip(structure.transitions, least, strict=True)
        },
    )


def _seen(law: MaterialLaw) -> tuple[int, int] | None:
    """Return the first and last cycle that the tests of all drifts contain."""
    drifts = drifts_of(law).values()
    return (max(drift.seen[0] for drift in drifts), min(drift.seen[1] for drift in drifts)) if drifts else None


def _remarks(structure: Structure, counts: Sequence[int]) -> Iterator[str]:
    last, law = counts[-1], _material(structure)
    tested = _seen(law)
    if tested is None:
        yield "the tests do not report drift of the material: only its softening after cycle 1 is modelled"
    else:
        if tested[0] > 1:
            untested = "cycle 1 is" if tested[0] == 2 else f"cycles 1 to {tested[0] - 1} are"
            yield f"{untested} assumed to be like cycle {tested[0]}, the first tested one"
        if last > tested[1]:
            yield f"cycles beyond {tested[1]} are extrapolated: the tests contain cycles {tested[0]} to {tested[1]}"
    drift = law.stiffness_drift
    if drift is not None and drift.kind != "none":
        middle, low, high = change_at_cycle(drift, last)
        yield f"at cycle {last} the tendons are {middle:.3g} times as stiff ({low:.3g} to {high:.3g}) as at cycle 1"
    drift = law.residual_strain_drift
    if drift is not None and drift.kind != "none":
        middle, low, high = (100 * share for share in change_at_cycle(drift, last))
        yield (
            f"at cycle {last} their residual strain is larger by {middle:.3g} % of their length"
            f" ({low:.3g} to {high:.3g} %)"
        )
    if law.branches:
        whole = structure.appearance.whole
        yield f"every cycle begins with tendons at rest, whose Maxwell branches have relaxed in the flat {whole}"
    if last > _EVERY_COUNT:
        yield f"beyond cycle {_EVERY_COUNT} only these cycles are run: {', '.join(map(str, counts[_EVERY_COUNT:]))}"
    checked_cycles = {counts[-1], counts[min(1, len(counts) - 1)]}
    missed = max(share for cycle in checked_cycles for _, share in _laws_at(structure, cycle).values())
    if missed > _LARGEST_MISS:
        yield (
            "the softened spring is a polynomial that deviates from the law by up to"
            f" {missed:.0%} of its largest stress"
        )


def _unsettled(cycling: Cycling) -> Iterator[str]:
    """Yield a remark if cycles that work and cycles that fail alternate."""
    works = [cycling.works(run) for run in cycling.runs]
    turns = [index for index in range(1, len(works)) if works[index] != works[index - 1]]
    if len(turns) > 1:
        first, last = (cycling.runs[index].cycle for index in (turns[0], turns[-1]))
        yield (
            f"between cycles {first} and {last} success alternates: it depends on how the hinges swing on arrival,"
            " which the timestep changes, too"
        )


def _beside_statics(cycling: Cycling) -> Iterator[str]:
    """Yield remarks on margins that contradict the simulation."""
    for index, transition in enumerate(cycling.transitions):
        name, goal = transition.name, transition.state
        margins = [run.margins[name] for run in cycling.runs if run.row.get(goal)]
        if any(value is None or value < 1 for value in margins):
            yield (
                f"at some cycles the {name} torque would be too small if it grew slowly: the transition succeeds by"
                " inertia"
            )
        before = cycling.transitions[index - 1].state if index else None
        failed = [run for run in cycling.runs if not run.row.get(goal) and (before is None or run.row.get(before))]
        if any((run.margins[name] or 0) > 1 for run in failed):
            yield (
                f"at some cycles the {name} torque fails although a slowly growing one succeeds: it acts at once and"
                " leads to another state, or its stage is too short"
            )


def _verdict(cycling: Cycling) -> str:
    """Return a sentence: whether the structure works after the last cycle, and otherwise at which cycles it works."""
    first, last = cycling.transitions[0], cycling.transitions[-1]
    began = [bool(run.row.get(first.state)) for run in cycling.runs]
    verbs = [transition.wording.does for transition in cycling.transitions]
    if first is not last and any(began) and not any(run.row.get(last.state) for run in cycling.runs):
        return f"{verbs[-1]} at none of the {_cycles(cycling.runs[-1].cycle)}; {_history(cycling, began, verbs[0])}"
    return _history(cycling, [cycling.works(run) for run in cycling.runs], " and ".join(verbs))


def _history(cycling: Cycling, works: Sequence[bool], goal: str) -> str:
    """Return a text that states at which cycles a goal is reached."""
    runs, last = cycling.runs, cycling.runs[-1].cycle
    if all(works):
        return f"still {goal} after {_cycles(last)}"
    if not any(works):
        return f"{goal} at none of the {_cycles(last)}: {runs[0].row['status']}"
    begins = works.index(True)
    if all(works[begins:]):
        return f"{goal} only from cycle {runs[begins].cycle} on; before: {runs[0].row['status']}"
    ends = begins + list(works[begins:]).index(False)
    again = "; some later cycles do" if any(works[ends:]) else ""
    start = "" if begins == 0 else f" from cycle {runs[begins].cycle} on,"
    failed = f"at cycle {runs[ends].cycle}: {runs[ends].row['status']}"
    return f"{goal}{start} up to cycle {runs[ends - 1].cycle}; {failed}{again}"


def _cycles(count: int) -> str:
    return "1 cycle" if count == 1 else f"{count} cycles"
