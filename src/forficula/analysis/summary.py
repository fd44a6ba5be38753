"""The outcome as plain data with units in its keys, as `summary.json` has it."""

from __future__ import annotations

from typing import Any

import numpy as np

from forficula.analysis.outcome import Outcome, State, Transition
from forficula.analysis.run_warnings import run_warnings
from forficula.design import design_warnings
from forficula.dynamics import EnergyBalance, Record


def summary(record: Record, outcome: Outcome, versions: dict[str, str]) -> dict[str, Any]:
    """The outcome as plain data with units in its keys, as `summary.json` has it."""
    states = {"flat": outcome.flat, "folded": outcome.folded_state, "opened": outcome.opened_state}
    return {
        "design": record.design.name,
        "status": outcome.status,
        "verdict": outcome.verdict.value,
        "residual": outcome.ending.residual,
        "advice": outcome.advice,
        "folded": outcome.folded,
        "opened": outcome.opened,
        "states": {name: None if state is None else _state_summary(state) for name, state in states.items()},
        "fold": _transition_summary(outcome.fold, record.design.protocol.fold_torque),
        "unfold": _transition_summary(outcome.unfold, record.design.protocol.unfold_torque),
        "energy_balance": _balance_summary(outcome.energy_balance),
        "diverged_at_s": record.diverged_at,
        "warnings": [*design_warnings(record.design), *run_warnings(record)],
        "design_hash": record.design.hash,
        "versions": versions,
    }


def _state_summary(state: State) -> dict[str, Any]:
    return {
        "time_s": state.time,
        "distal_angle_deg": np.degrees(state.distal_angle).tolist(),
        "distal_angle_low_deg": np.degrees(state.distal_angle_low).tolist(),
        "distal_angle_high_deg": np.degrees(state.distal_angle_high).tolist(),
        "tendon_length_m": state.tendon_length.tolist(),
        "tendon_energy_J": state.tendon_energy.tolist(),
        "membrane_energy_J": state.membrane_energy,
    }


def _transition_summary(transition: Transition | None, torque: float) -> dict[str, Any]:
    """A transition; one that was not tried has the torque that it would have had, and nothing else."""
    if transition is None:
        return {"torque_N_m": torque, "succeeded": False, "time_s": None, "work_J": None}
    return {
        "torque_N_m": transition.torque,
        "succeeded": transition.succeeded,
        "time_s": transition.time,
        "work_J": transition.work,
    }


def _balance_summary(balance: EnergyBalance) -> dict[str, float]:
    of_law = {
        "branch_energy_change_J": balance.branches,
        "branch_damping_J": balance.branch_damping,
        "yielding_J": balance.yielding,
        "letting_go_J": balance.letting_go,
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
        **{name: value for name, value in of_law.items() if value is not None},
    }
