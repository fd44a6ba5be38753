"""The outcome as plain data with units in its keys, as `summary.json` has it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from operator import itemgetter
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from forficula.analysis.branch import Branch, branch_taken
from forficula.analysis.confirmation import Confirmation, StateValues
from forficula.analysis.crossing_panels import PanelCrossing, panel_crossing
from forficula.analysis.groups import Groups, dominance, groups_of
from forficula.analysis.outcome import SPRUNG, Outcome, StageOutcome, State, TransitionOutcome
from forficula.analysis.package import packages, smallest_package
from forficula.analysis.run_warnings import run_warnings
from forficula.analysis.storage import storage_texts, storages
from forficula.analysis.strength import FoldPeak, Peak, fold_peak, strain_peaks
from forficula.dynamics import EnergyBalance, Record
from forficula.structure import Drive, Structure, drive_of, drive_unit, hinge_groups, structure_warnings


@dataclass(frozen=True, kw_only=True)
class _Quantity:
    """A quantity of a state that has a key of its own.

    Attributes:
        name: the key without its unit, such as "tendon_energy".
        unit: "deg", "m" or "J", at the end of the key.
        numbers: computes the quantity from the values of a state, SI; a list for several parts, else one number.
    """

    name: str
    unit: Literal["deg", "m", "J"]
    numbers: Callable[[StateValues], ArrayLike]

    def written(self, numbers: ArrayLike) -> Any:
        """Return numbers of the quantity, SI, in its unit as JSON has them."""
        return (np.degrees(numbers) if self.unit == "deg" else np.asarray(numbers)).tolist()


def summary(record: Record, outcome: Outcome, versions: dict[str, str]) -> dict[str, Any]:
    """The outcome as plain data with units in its keys, as `summary.json` has it.

    What became of a structure's states and transitions stands under their own names, beside `states` and `stages`,
    which every structure has.
    """
    structure = record.structure
    told: dict[str, Any] = {
        "design": record.design.name,
        "status": outcome.status,
        "verdict": outcome.verdict.value,
        "residual": outcome.ending.residual,
        "advice": outcome.advice,
        **({} if outcome.confirmation is None else {"confirmation": _confirmation_summary(outcome.confirmation)}),
    }
    furthest = fold_peak(record)
    last = {
        "largest_strains": {peak.kind: _peak_summary(peak) for peak in strain_peaks(record)},
        **({} if furthest is None else {"furthest_fold": _fold_summary(furthest)}),
        **_branch_summary(branch_taken(record)),
        **_package_summary(record),
        **_storage_summary(record, outcome),
        **_crossing_summary(panel_crossing(record)),
        "energy_balance": _balance_summary(outcome.energy_balance),
        **({"closure_gap_m": float(record.series["closure_gap"][-1])} if "closure_gap" in record.series else {}),
        "groups": groups_summary(groups_of(structure, record.design.protocol.timestep)),
        "diverged_at_s": record.diverged_at,
        "warnings": [*structure_warnings(record.design, structure), *run_warnings(record)],
        "design_hash": record.design.hash,
        "versions": versions,
    }
    states = {
        name: None if state is None else _state_summary(structure, state) | _uncertain_state(outcome, state)
        for name, state in outcome.states.items()
    }
    stages: dict[str, Any] = {}
    for stage in outcome.stages:
        # a name that was there before gets a number
        again = sum(name == stage.name or name.startswith(f"{stage.name} (") for name in stages)
        stages[f"{stage.name} ({again + 1})" if again else stage.name] = _stage_summary(stage)
    transitions = {
        each.name: _transition_summary(outcome.transitions[each.name], structure, drive_of(structure, each.drive))
        | _uncertain(outcome, each.name, {"time": "s", "work": "J"})
        for each in structure.transitions
    }
    own = {**outcome.holds, "states": states, **transitions, "stages": stages}
    return {**told, **{name: value for name, value in own.items() if name not in {**told, **last}}, **last}


def _confirmation_summary(found: Confirmation) -> dict[str, Any]:
    """What second runs of the design say of the verdict and of the numbers."""
    return {
        "confirmed": found.agree,
        "checks": [
            {"name": check.name, "timestep_s": check.timestep, "verdict": check.verdict, "status": check.status}
            for check in found.checks
        ],
        "unsettled": list(found.unsettled),
    }


def _uncertain(outcome: Outcome, name: str, units: dict[str, str]) -> dict[str, float]:
    """Numerical uncertainties of the values of a transition, in keys of their units; none where they are not known."""
    found = outcome.confirmation
    sure = {} if found is None else {value: found.of(f"{name}.{value}") for value in units}
    return {f"{value}_uncertainty_{units[value]}": half for value, half in sure.items() if half is not None}


def _uncertain_state(outcome: Outcome, state: State) -> dict[str, Any]:
    """Numerical uncertainties of all quantities of a state, in keys of their units; none where they are not known."""
    told: dict[str, Any] = {}
    if outcome.confirmation is None:
        return told
    for quantity in (*_readings(outcome.structure), *_energies(outcome.structure, state)):
        halves = outcome.confirmation.of_state(state.name, quantity.numbers)
        if halves is not None:
            told[f"{quantity.name}_uncertainty_{quantity.unit}"] = quantity.written(halves)
    return told


def _readings(structure: Structure) -> list[_Quantity]:
    """Return the measured values of a state."""
    return [
        _Quantity(name=each.name, unit="deg" if each.kind == "angle" else "m", numbers=itemgetter(each.name))
        for each in structure.measures
    ]


def _energies(structure: Structure, state: State) -> Iterator[_Quantity]:
    """Yield the energies of hinges, springs and couplings, lengths and energies of tendons, and that of membranes."""
    for kind in SPRUNG:
        if f"{kind}.energy" not in state.values:
            continue
        yield _Quantity(name=f"{kind}_energy", unit="J", numbers=itemgetter(f"{kind}.energy"))
        groups = hinge_groups(structure) if kind == "hinge" else {}
        for group, hinges in groups.items():
            if group != "hinges":
                yield _Quantity(name=f"{group.replace(' ', '_')}_energy", unit="J", numbers=partial(_summed, hinges))
    yield _Quantity(name="tendon_length", unit="m", numbers=itemgetter("tendon.length"))
    yield _Quantity(name="tendon_energy", unit="J", numbers=itemgetter("tendon.energy"))
    yield _Quantity(name="membrane_energy", unit="J", numbers=lambda values: values["membrane.energy"][0])


def _summed(hinges: Sequence[int], values: StateValues) -> float:
    return float(values["hinge.energy"][list(hinges)].sum())


def _state_summary(structure: Structure, state: State) -> dict[str, Any]:
    told: dict[str, Any] = {"time_s": state.time}
    ends = {kind: {name: getattr(each, kind) for name, each in state.readings.items()} for kind in ("low", "high")}
    for quantity in _readings(structure):
        told[f"{quantity.name}_{quantity.unit}"] = quantity.written(quantity.numbers(state.values))
        for kind, values in ends.items():
            told[f"{quantity.name}_{kind}_{quantity.unit}"] = quantity.written(quantity.numbers(values))
    # a sparse record does not have the energy of membranes
    values = {"membrane.energy": np.array([state.membrane_energy]), **state.values}
    for quantity in _energies(structure, state):
        told[f"{quantity.name}_{quantity.unit}"] = quantity.written(quantity.numbers(values))
    return told


def drive_entry(structure: Structure, drive: Drive) -> tuple[str, float]:
    """How strong a drive is, with a key that ends in the unit: torque_N_m, force_N, displacement_m, rest_angle_deg."""
    unit = drive_unit(structure, drive)
    key = {"N m": "torque_N_m", "N": "force_N", "m": "displacement_m", "rad": "rest_angle_deg"}[unit]
    return key, float(np.degrees(drive.strength)) if unit == "rad" else drive.strength


def _transition_summary(found: TransitionOutcome | None, structure: Structure, drive: Drive) -> dict[str, Any]:
    """A transition; one that was not tried has the drive that it would have had, and nothing else."""
    told = dict([drive_entry(structure, drive)])
    if found is None:
        return {**told, "succeeded": False, "time_s": None, "work_J": None}
    forces = {} if found.largest_force is None else {"largest_force_N": found.largest_force}
    return {**told, "succeeded": found.succeeded, "time_s": found.time, "work_J": found.work, **forces}


def _package_summary(record: Record) -> dict[str, Any]:
    """The room that the smallest state takes, and that of every state."""
    found, smallest = packages(record), smallest_package(record)
    if smallest is None:
        return {}
    told = {
        name: {
            "height_m": each.height,
            "width_m": each.width,
            "length_m": each.length,
            "area_m2": each.area,
            "area_ratio": each.area_ratio,
        }
        for name, (_, each) in found.items()
    }
    return {"package": {"state": smallest[0], **told[smallest[0]], "states": told}}


def _crossing_summary(found: PanelCrossing | None) -> dict[str, Any]:
    """How far panels pass through each other, deepest."""
    if found is None:
        return {}
    return {"crossing": {"depth_m": found.depth, "panels": list(found.names), "time_s": found.time}}


def _branch_summary(branch: Branch | None) -> dict[str, Any]:
    if branch is None:
        return {}
    counts = {"as_assigned": branch.as_assigned, "against": branch.against, "flat": branch.flat}
    return {"branch": {**counts, "decided_by": list(branch.decided_by) or ["rounding alone"]}}


def _peak_summary(peak: Peak) -> dict[str, Any]:
    stress = {} if peak.stress is None else {"stress_Pa": peak.stress}
    if peak.withstood is not None:
        stress["strength_Pa"] = peak.withstood
    return {"strain": peak.strain, **stress, "part": peak.part, "time_s": peak.time}


def _fold_summary(furthest: FoldPeak) -> dict[str, Any]:
    return {"angle_deg": float(np.degrees(furthest.angle)), "crease": furthest.crease, "time_s": furthest.time}


def _stage_summary(stage: StageOutcome) -> dict[str, Any]:
    return {
        "drive": "none" if not stage.drive else stage.drive[0] if len(stage.drive) == 1 else list(stage.drive),
        "goal": stage.goal,
        "reached": stage.reached,
        "time_s": stage.time,
        "work_J": stage.work,
        **({"waited_s": stage.waited} if stage.waited else {}),
    }


def _storage_summary(record: Record, outcome: Outcome) -> dict[str, Any]:
    """What waits did to the tendons; nothing where nothing waited."""
    found = [
        {
            "stage": each.name,
            "state": each.state or None,
            "wait_s": each.time,
            "pull_before_N": None if each.pulls is None else each.pulls[0].tolist(),
            "pull_after_N": None if each.pulls is None else each.pulls[-1].tolist(),
            "pull_lost": each.weakened,
            "branch_damping_J": each.lost,
            "membrane_energy_J": each.membrane,
        }
        for each in storages(record)
    ]
    return {"storage": {"waits": found, "in_words": storage_texts(record, outcome)}} if found else {}


def groups_summary(groups: Groups | None) -> dict[str, Any] | None:
    """The groups by their names, beside what they are measured by and what dominates; None where there are none."""
    if groups is None:
        return None
    scale = groups.scale
    return {
        "measured_by": {
            "part": scale.name,
            "moment_N_m": scale.moment,
            "inertia_kg_m2": scale.inertia,
            "time_s": scale.time,
        },
        **{group.name: group.value for group in groups.every},
        "in_words": dominance(groups),
    }


def _balance_summary(balance: EnergyBalance) -> dict[str, float]:
    sometimes = {
        "contacts_J": balance.contacts,
        "friction_J": balance.friction,
        "branch_energy_change_J": balance.branches,
        "branch_damping_J": balance.branch_damping,
        "yielding_J": balance.yielding,
        "letting_go_J": balance.letting_go,
        "hinge_energy_change_J": balance.hinges,
        "spring_energy_change_J": balance.springs,
        "coupling_energy_change_J": balance.couplings,
        "closures_J": balance.closures,
        "drag_J": balance.drag,
    }
    return {
        "residual": balance.residual,
        "work_J": balance.work,
        "tendon_energy_change_J": balance.tendon,
        "membrane_energy_change_J": balance.membrane,
        "kinetic_energy_change_J": balance.kinetic,
        "gravitational_energy_change_J": balance.gravitational,
        "hinge_damping_J": balance.hinge_damping,
        "elastic_damping_J": balance.elastic_damping,
        "stops_J": balance.stops,
        "missing_J": balance.missing,
        **{name: value for name, value in sometimes.items() if value is not None},
    }
