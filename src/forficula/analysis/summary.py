"""The outcome of a run in the form of `summary.json`."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from operator import itemgetter
from typing import Annotated, Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from forficula.analysis.branch import Branch, branch_taken
from forficula.analysis.confirmation import Confirmation, StateValues
from forficula.analysis.contact_overlap import ContactOverlap, contact_overlap
from forficula.analysis.crossing_panels import PanelCrossing, panel_crossing
from forficula.analysis.groups import Groups, groups_of
from forficula.analysis.outcome import Outcome, StageOutcome
from forficula.analysis.package import Package, packages, smallest_package
from forficula.analysis.precision import precision_of
from forficula.analysis.run_warnings import run_warnings
from forficula.analysis.states import SPRUNG, State
from forficula.analysis.storage import Storage, storage_texts, storages
from forficula.analysis.strength import FoldPeak, Peak, WornCrease, fold_peak, permanent_fold, strain_peaks, worn_crease
from forficula.analysis.verdict import Verdict
from forficula.arrays import Array
from forficula.dynamics import EnergyBalance, Record
from forficula.quantities import Unit
from forficula.serial import Joules, Metres, Newtons, Seconds, WithUnit, Written, plain
from forficula.structure import (
    Drive,
    Structure,
    Transition,
    drive_of,
    drive_unit,
    hinge_groups,
    structure_warnings,
)

_STRENGTHS = {"N m": "torque", "N": "force", "m": "displacement", "rad": "rest_angle"}


@dataclass(frozen=True, kw_only=True)
class StateSummary:
    """A state: the mean over the last part of a stage.

    Attributes:
        time: end of the stage, s.
        tendon_length: of every tendon, m.
        tendon_energy: of every tendon, J.
        membrane_energy: J.
        others: readings of measures, each with the lowest and the highest; energies of springs, if the structure has
            any; and, in runs with second runs, the numerical uncertainty of every quantity.
    """

    time: Seconds
    others: Annotated[Mapping[str, WithUnit], Written.BESIDE]
    tendon_length: Annotated[Array, Unit("m")]
    tendon_energy: Annotated[Array, Unit("J")]
    membrane_energy: Joules


@dataclass(frozen=True, kw_only=True)
class TransitionSummary:
    """A transition, such as folding. A transition that was not tried has only its drive.

    Attributes:
        drive: strength of the drive: a torque, a force, a displacement or a rest angle.
        succeeded: whether the goal was reached, and the state held after the release if a release ends in it.
        time: from the start of the stage until the goal was reached, s; null where it failed.
        work: of the motors over the stage, J.
        largest_force: over the stage, N, of displacements.
        time_uncertainty: numerical uncertainty, s.
        work_uncertainty: numerical uncertainty, J.
    """

    drive: Annotated[Mapping[str, WithUnit], Written.BESIDE]
    succeeded: bool
    time: Seconds | None = None
    work: Joules | None = None
    largest_force: Annotated[Newtons | None, Written.IF_KNOWN] = None
    time_uncertainty: Annotated[Seconds | None, Written.IF_KNOWN] = None
    work_uncertainty: Annotated[Joules | None, Written.IF_KNOWN] = None


@dataclass(frozen=True, kw_only=True)
class PackageSummary:
    """Packaged size of the smallest state, and of every state.

    Attributes:
        state: name of the smallest state.
        smallest: packaged size of the smallest state.
        states: packaged sizes by the names of the states.
    """

    state: str
    smallest: Annotated[Package, Written.BESIDE]
    states: Mapping[str, Package]


@dataclass(frozen=True, kw_only=True)
class StorageSummary:
    """Effect of waiting times on the tendons.

    Attributes:
        waits: stages that waited.
        in_words: a sentence or two for each.
    """

    waits: tuple[Storage, ...]
    in_words: list[str]


@dataclass(frozen=True, kw_only=True)
class Summary:
    """The outcome of a run. The summary also has a key for each state and each transition, which is its name.

    Attributes:
        design: name of the design.
        status: the outcome in a few words.
        verdict: the outcome in a word.
        residual: largest share of the exchanged energy that is missing in the balance.
        advice: what to change, in a sentence; empty if nothing is known to help.
        precision: of the arithmetic, if it is not double.
        confirmation: comparison with second runs.
        holds: by name of a state, whether it was reached and held when released.
        states: by name; null for a state that the protocol did not get to.
        transitions: by name.
        stages: by name, in order.
        largest_strains: by kind of parts.
        furthest_fold: the crease with the largest fold angle.
        permanent_fold: the crease with the largest permanent fold at the end.
        worn_crease: the crease that has lost most of its moment to wear at the end.
        branch: branch that a sheet followed out of its flat state.
        package: packaged sizes of the states.
        storage: effect of waiting times on the tendons.
        crossing: how far panels pass through each other.
        contact_overlap: how far facets, plates and bars that touch overlap.
        energy_balance: over the whole run.
        closure_gap: gap of the loops of bodies at the end, m.
        groups: dimensionless groups; null without an elastic part that folds.
        diverged_at: when the run diverged, s.
        warnings: warnings, one sentence each.
        design_hash: hash of all values of the design.
        key: of the run among those of a study.
        versions: of the packages that computed the run.
    """

    design: str
    status: str
    verdict: Verdict
    residual: float | None
    advice: str
    precision: Annotated[Literal["single"] | None, Written.IF_KNOWN]
    confirmation: Annotated[Confirmation | None, Written.IF_KNOWN]
    holds: Annotated[Mapping[str, bool | None], Written.BESIDE]
    states: Mapping[str, StateSummary | None]
    transitions: Annotated[Mapping[str, TransitionSummary], Written.BESIDE]
    stages: Mapping[str, StageOutcome]
    largest_strains: Mapping[str, Peak]
    furthest_fold: Annotated[FoldPeak | None, Written.IF_KNOWN]
    permanent_fold: Annotated[FoldPeak | None, Written.IF_KNOWN]
    worn_crease: Annotated[WornCrease | None, Written.IF_KNOWN]
    branch: Annotated[Branch | None, Written.IF_KNOWN]
    package: Annotated[PackageSummary | None, Written.IF_KNOWN]
    storage: Annotated[StorageSummary | None, Written.IF_KNOWN]
    crossing: Annotated[PanelCrossing | None, Written.IF_KNOWN]
    contact_overlap: Annotated[ContactOverlap | None, Written.IF_KNOWN]
    energy_balance: EnergyBalance
    closure_gap: Annotated[Metres | None, Written.IF_KNOWN]
    groups: Groups | None
    diverged_at: Seconds | None
    warnings: list[str]
    design_hash: str
    key: Annotated[str | None, Written.IF_KNOWN] = None
    versions: dict[str, str]


def summary(record: Record, outcome: Outcome, versions: dict[str, str], key: str | None = None) -> dict[str, Any]:
    """Return the outcome of a run as plain data in the form of `summary.json`.

    Args:
        record: of the run.
        outcome: of the run.
        versions: of the packages that computed it.
        key: of the run among those of a study.
    """
    structure, smallest = record.structure, smallest_package(record)
    rooms = {name: room for name, (_, room) in packages(record).items()}
    waits = storages(record)
    gaps = record.series.get("closure_gap")
    content = Summary(
        design=record.design.name,
        status=outcome.status,
        verdict=outcome.verdict,
        residual=outcome.ending.residual,
        advice=outcome.advice,
        precision="single" if precision_of(record.design) == "single" else None,
        confirmation=outcome.confirmation,
        holds=outcome.holds,
        states={
            name: None if state is None else _state(structure, state, outcome.confirmation)
            for name, state in outcome.states.items()
        },
        transitions={
            transition.name: _transition(structure, transition, outcome) for transition in structure.transitions
        },
        stages=_named(outcome.stages),
        largest_strains={peak.kind: peak for peak in strain_peaks(record)},
        furthest_fold=fold_peak(record),
        permanent_fold=permanent_fold(record),
        worn_crease=worn_crease(record),
        branch=branch_taken(record),
        package=smallest and PackageSummary(state=smallest[0], smallest=smallest[2], states=rooms),
        storage=StorageSummary(waits=waits, in_words=storage_texts(record, outcome)) if waits else None,
        crossing=panel_crossing(record),
        contact_overlap=contact_overlap(record),
        energy_balance=outcome.energy_balance,
        closure_gap=None if gaps is None else float(gaps[-1]),
        groups=groups_of(structure, record.design.protocol.timestep),
        diverged_at=record.diverged_at,
        warnings=[*structure_warnings(record.design, structure), *run_warnings(record)],
        design_hash=record.design.hash,
        key=key,
        versions=versions,
    )
    written: dict[str, Any] = plain(content)
    return written


def drive_strength(structure: Structure, drive: Drive) -> dict[str, WithUnit]:
    """Return the strength of a drive by its kind: a torque, force, displacement or rest angle."""
    unit = drive_unit(structure, drive)
    return {_STRENGTHS[unit]: WithUnit(drive.strength, unit)}


def _named(stages: Sequence[StageOutcome]) -> dict[str, StageOutcome]:
    """Return stages by their names. A name that occurs again gets a number."""
    named: dict[str, StageOutcome] = {}
    for stage in stages:
        again = sum(name == stage.name or name.startswith(f"{stage.name} (") for name in named)
        named[f"{stage.name} ({again + 1})" if again else stage.name] = stage
    return named


def _transition(structure: Structure, transition: Transition, outcome: Outcome) -> TransitionSummary:
    drive, result = (
        drive_strength(structure, drive_of(structure, transition.drive)),
        outcome.transitions[transition.name],
    )
    sure = outcome.confirmation
    halves = [None if sure is None else sure.of(f"{transition.name}.{value}") for value in ("time", "work")]
    return TransitionSummary(
        drive=drive,
        succeeded=result is not None and result.succeeded,
        time=None if result is None else result.time,
        work=None if result is None else result.work,
        largest_force=None if result is None else result.largest_force,
        time_uncertainty=halves[0],
        work_uncertainty=halves[1],
    )


@dataclass(frozen=True, kw_only=True)
class _StateNumbers:
    """A quantity of a state with its own key.

    Attributes:
        name: the key without its unit, such as "tendon_energy".
        unit: SI.
        numbers: computes the quantity from the values of a state, SI; a list for several parts, else one number.
    """

    name: str
    unit: Literal["rad", "m", "J"]
    numbers: Callable[[StateValues], ArrayLike]


def _state(structure: Structure, state: State, confirmation: Confirmation | None) -> StateSummary:
    readings, energies = _readings(structure), list(_energies(structure, state))
    others: dict[str, WithUnit] = {}
    for quantity in readings:
        others[quantity.name] = WithUnit(quantity.numbers(state.values), quantity.unit)
        for end in ("low", "high"):
            ends = {name: getattr(reading, end) for name, reading in state.readings.items()}
            others[f"{quantity.name}_{end}"] = WithUnit(quantity.numbers(ends), quantity.unit)
    # a sparse record does not have the energy of membranes
    values = {"membrane.energy": np.array([state.membrane_energy]), **state.values}
    others |= {energy.name: WithUnit(energy.numbers(values), energy.unit) for energy in energies}
    for quantity in (*readings, *energies):
        halves = None if confirmation is None else confirmation.of_state(state.name, quantity.numbers)
        if halves is not None:
            others[f"{quantity.name}_uncertainty"] = WithUnit(halves, quantity.unit)
    return StateSummary(
        time=state.time,
        others=others,
        tendon_length=state.tendon_length,
        tendon_energy=state.tendon_energy,
        membrane_energy=state.membrane_energy,
    )


def _readings(structure: Structure) -> list[_StateNumbers]:
    """Return the measured values of a state."""
    return [
        _StateNumbers(
            name=measure.name, unit="rad" if measure.kind == "angle" else "m", numbers=itemgetter(measure.name)
        )
        for measure in structure.measures
    ]


def _energies(structure: Structure, state: State) -> Iterator[_StateNumbers]:
    """Yield the energies of hinges, springs and couplings, lengths and energies of tendons, and that of membranes."""
    for kind in SPRUNG:
        if f"{kind}.energy" not in state.values:
            continue
        yield _StateNumbers(name=f"{kind}_energy", unit="J", numbers=itemgetter(f"{kind}.energy"))
        groups = hinge_groups(structure) if kind == "hinge" else {}
        for group, hinges in groups.items():
            if group != "hinges":
                yield _StateNumbers(
                    name=f"{group.replace(' ', '_')}_energy", unit="J", numbers=partial(_hinge_energy, hinges)
                )
    yield _StateNumbers(name="tendon_length", unit="m", numbers=itemgetter("tendon.length"))
    yield _StateNumbers(name="tendon_energy", unit="J", numbers=itemgetter("tendon.energy"))
    yield _StateNumbers(name="membrane_energy", unit="J", numbers=lambda values: values["membrane.energy"][0])


def _hinge_energy(hinges: Sequence[int], values: StateValues) -> float:
    return float(values["hinge.energy"][list(hinges)].sum())
