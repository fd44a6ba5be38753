"""A landscape as plain data with units in its keys, as `landscape.json` has it."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from forficula.statics.fold_path import FoldPath, rigid_fold
from forficula.statics.hinge_landscape import HingeLandscape
from forficula.statics.landscape import EnergyLandscape, stable_states
from forficula.statics.net_summary import net_summary
from forficula.statics.partial_folds import PartialFold
from forficula.structure import Structure


def landscape_summary(landscape: EnergyLandscape) -> dict[str, Any]:
    """A landscape as plain data with units in its keys, as `landscape.json` has it."""
    hinge, tips = landscape.hinge, landscape.tips
    return {
        "design": landscape.design.name,
        "hinge": None if hinge is None else _hinge_summary(hinge),
        "tendons": [
            {"tendon": tendon, "hinge": hinge} | _hinge_summary(surveyed)
            for (tendon, hinge), surveyed in zip(_crossed(landscape.structure), landscape.tendons, strict=True)
        ],
        "wing": None if landscape.fold_path is None else _path_summary(landscape, landscape.fold_path),
        "levels_J": None if landscape.levels is None else landscape.levels.tolist(),
        "partial_folds": [_partial_summary(state) for state in landscape.partial_folds],
        "rests": [
            {
                "name": state.name,
                "angles_deg": np.degrees(state.angles).tolist(),
                "energy_J": state.energy,
                "stored_J": dict(state.stored),
                "stable": state.stable,
                "same_as": state.same_as or None,
            }
            for state in landscape.rests
        ],
        "least_torques_N_m": dict(landscape.least_torques),
        "least_torque_ranges_N_m": {
            name: [low, None if math.isinf(high) else high]
            for name, (low, high) in landscape.least_torque_ranges.items()
        },
        "inertial_help": {
            name: None
            if each is None
            else {"torque_N_m": each.torque, "released_J": each.released, "barrier_J": each.barrier}
            for name, each in landscape.inertial_help.items()
        },
        "tips": None
        if tips is None
        else {
            "deflection_m": tips.deflection,
            "holding_force_N": tips.holding_force,
            "flat_along_N_per_m": tips.flat_along,
            "flat_against_N_per_m": tips.flat_against,
            "unlocked_along_N_per_m": tips.unlocked_along,
            "unlocked_against_N_per_m": tips.unlocked_against,
        },
        "remarks": list(landscape.remarks),
        **({} if landscape.net is None else {"net": net_summary(landscape.structure, landscape.net)}),
        "design_hash": landscape.design.hash,
    }


def _crossed(structure: Structure) -> list[tuple[str, str]]:
    """Names of the tendons that lie across one hinge, and of their hinges."""
    return [
        (tendon.name, structure.hinges[tendon.crossing.hinge].name)
        for tendon in structure.tendons
        if tendon.crossing is not None
    ]


def _hinge_summary(hinge: HingeLandscape) -> dict[str, Any]:
    """A hinge with its angles and moments in its own sense."""

    def degrees(angle: ArrayLike) -> Any:
        # 0 keeps its sign
        return np.degrees(angle) if hinge.sense > 0 else 0.0 - np.degrees(angle)

    peak = hinge.peak_opening
    sprung = hinge.spring is not None
    return {
        "angle_deg": degrees(hinge.angle).tolist(),
        "energy_J": hinge.energy.tolist(),
        "moment_N_m": (hinge.sense * hinge.moment).tolist(),
        **({"spring_energy_J": hinge.spring_energy.tolist()} if sprung else {}),
        **({"spring_moment_N_m": (hinge.sense * hinge.spring_moment).tolist()} if sprung else {}),
        "stable_states": [
            {
                "kind": state.kind,
                "angle_deg": float(degrees(state.angle)),
                "far_angle_deg": float(degrees(state.far_angle)),
                "energy_J": state.energy,
                "holding_torque_N_m": state.holding_torque,
            }
            for state in hinge.states
        ],
        "barrier_J": hinge.barrier,
        "barrier_angle_deg": None if hinge.barrier_angle is None else float(degrees(hinge.barrier_angle)),
        "holding_torque_N_m": hinge.holding_torque,
        "peak_opening_torque_N_m": None if peak is None else peak.torque,
        "peak_opening_angle_deg": None if peak is None else float(degrees(peak.angle)),
        "slack_angle_deg": None if hinge.slack_angle is None else float(degrees(hinge.slack_angle)),
        "time_scale_s": hinge.time_scale,
        "growth_rate_per_s": hinge.growth_rate,
        "fold_start_deg": float(np.degrees(hinge.fold_start)),
        "fold_time_s": hinge.fold_time,
        "final_speed_rad_per_s": hinge.final_speed,
        "inertia_kg_m2": hinge.hinge.inertia,
        "remarks": list(hinge.remarks),
    }


def _path_summary(landscape: EnergyLandscape, path: FoldPath) -> dict[str, Any]:
    states, first = stable_states(landscape), rigid_fold(landscape.structure).start
    climbs = [state for state in path.states if not state.stable]
    return {
        "pleat_angle_deg": np.degrees(path.pleat_angle).tolist(),
        "ring_angle_deg": np.degrees(path.ring_angle).tolist(),
        "energy_J": path.energy.tolist(),
        "tendon_energy_J": path.tendon_energy.tolist(),
        "membrane_energy_J": path.sheet_energy.tolist(),
        "moment_N_m": path.moment.tolist(),
        "stable_states": [
            {
                "name": state.name,
                "kind": state.kind,
                "pleat_angle_deg": float(np.degrees(state.pleat_angle)),
                "far_pleat_angle_deg": float(np.degrees(state.far_pleat_angle)),
                "ring_angle_deg": float(np.degrees(state.ring_angle)),
                "energy_J": state.energy,
                "holding_torque_N_m": state.holding_torque,
            }
            for state in states
        ],
        "saddles": [
            {"pleat_angle_deg": float(np.degrees(state.coordinate)), "energy_J": state.energy} for state in climbs
        ],
        "barrier_J": landscape.fold_barrier,
        "single_hinge_barriers_J": [None if math.isnan(each) else each for each in landscape.hinge_barriers.tolist()]
        if landscape.rests[0].within
        else None,
        "opening_barrier_J": landscape.unfold_barrier,
        "holding_torque_N_m": next((state.holding_torque for state in states if state.name == first), None),
        "path_fold_torque_N_m": path.fold_torque,
        "path_unfold_torque_N_m": path.unfold_torque,
        **{f"least_{name}_torque_N_m": torque for name, torque in landscape.least_torques.items()},
    }


def _partial_summary(state: PartialFold) -> dict[str, Any]:
    return {
        "folded": list(state.folded),
        "stable": state.stable,
        "stays_folded": list(state.stays_folded),
        "distal_angle_deg": np.degrees(state.angles).tolist(),
        "energy_J": state.energy,
        "tendon_energy_J": state.tendon_energy,
        "membrane_energy_J": state.sheet_energy,
        "independent_energy_J": state.independent_energy,
    }
