"""A landscape as plain data with units in its keys, as `landscape.json` has it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from forficula.statics.fold_path import FoldPath, rigid_fold
from forficula.statics.hinge_landscape import HingeLandscape
from forficula.statics.inertial_help import InertialHelp
from forficula.statics.landscape import (
    EnergyLandscape,
    LeastTorque,
    NetSurvey,
    Rest,
    fold_states,
    net_courses,
    net_states,
)
from forficula.statics.net.load_path import PathPoint
from forficula.statics.net.net import Net, Shape
from forficula.statics.net.net_of import places
from forficula.statics.net_course import Course, displaces, gone, reaction
from forficula.statics.net_state import Mobility, NetState, Withstood
from forficula.statics.partial_folds import PartialFold
from forficula.statics.tip_stiffness import TipStiffness
from forficula.structure import Structure, drive_unit, driven_motor

_SUFFIXES = {"N": "N", "N m": "N_m", "rad": "deg", "m": "m", "Pa": "Pa", "m/s^2": "m_per_s2"}


def landscape_summary(landscape: EnergyLandscape) -> dict[str, Any]:
    """A landscape as plain data with units in its keys, as `landscape.json` has it."""
    structure, hinge, path, tips = landscape.structure, landscape.hinge, landscape.fold_path, landscape.tips
    torques = [each for each in landscape.courses if isinstance(each, LeastTorque)]
    return {
        "design": landscape.design.name,
        "hinge": None if hinge is None else _hinge_summary(hinge),
        "tendons": [
            {"tendon": structure.tendons[each.tendon].name, "hinge": structure.hinges[each.hinge].name}
            | _hinge_summary(each.own)
            for each in landscape.hinges
        ],
        "wing": None if path is None else _path_summary(landscape, path),
        "levels_J": None if landscape.levels is None else landscape.levels.tolist(),
        "partial_folds": [_partial_summary(state) for state in landscape.partial_folds],
        "rests": [_rest_summary(rest) for rest in landscape.rests],
        "least_torques_N_m": dict(landscape.least_torques),
        "least_torque_ranges_N_m": {
            each.name: [each.span[0], None if math.isinf(each.span[1]) else each.span[1]]
            for each in torques
            if each.span is not None
        },
        "inertial_help": {each.name: _help_summary(each.inertial_help) for each in torques},
        "tips": None if tips is None else _tips_summary(tips),
        "remarks": list(landscape.remarks),
        **({} if landscape.net is None else {"net": _net_summary(landscape, landscape.net)}),
        "design_hash": landscape.design.hash,
    }


def _rest_summary(rest: Rest) -> dict[str, Any]:
    return {
        "name": rest.name,
        "angles_deg": np.degrees(rest.angles).tolist(),
        "energy_J": rest.energy,
        "stored_J": dict(rest.stored),
        "stable": rest.stable,
        "same_as": rest.same_as or None,
    }


def _help_summary(helped: InertialHelp | None) -> dict[str, float] | None:
    if helped is None:
        return None
    return {"torque_N_m": helped.torque, "released_J": helped.released, "barrier_J": helped.barrier}


def _tips_summary(tips: TipStiffness) -> dict[str, float | None]:
    return {
        "deflection_m": tips.deflection,
        "holding_force_N": tips.holding_force,
        "flat_along_N_per_m": tips.flat_along,
        "flat_against_N_per_m": tips.flat_against,
        "unlocked_along_N_per_m": tips.unlocked_along,
        "unlocked_against_N_per_m": tips.unlocked_against,
    }


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
    states, first = fold_states(landscape), rigid_fold(landscape.structure).start
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


def _net_summary(landscape: EnergyLandscape, survey: NetSurvey) -> dict[str, Any]:
    structure, net, states = landscape.structure, survey.net, net_states(landscape)
    return {
        "search": {
            "seed": survey.search.seed,
            "tries": survey.search.tries,
            "found": len(survey.search.states),
            "failed": survey.search.failed,
        },
        "as_built": _mobility_summary(survey.built),
        "states": [_net_state_summary(structure, net, state) for state in states],
        "saddles": [
            {
                "between": [states[end].name for end in each.ends],
                "energy_J": each.energy,
                "barriers_J": list(each.barriers),
                **({} if each.shape is None else {"positions_m": _points(structure, net, each.shape)}),
            }
            for each in landscape.passes
        ],
        "courses": [_course_summary(structure, net, course) for course in net_courses(landscape)],
    }


def _net_state_summary(structure: Structure, net: Net, state: NetState) -> dict[str, Any]:
    kinds = {measure.name: measure.kind for measure in structure.measures}
    readings = {}
    for name, values in state.readings.items():
        angle = kinds[name] == "angle"
        readings[f"{name}_deg" if angle else f"{name}_m"] = (np.degrees(values) if angle else values).tolist()
    return {
        "name": state.name,
        "energy_J": state.energy,
        "stored_J": dict(state.stored),
        "readings": readings,
        "frequencies_Hz": state.frequencies.tolist(),
        **_mobility_summary(state.mobility),
        "largest_bar_strain": state.strain,
        "largest_stress_Pa": state.stress,
        "largest_tendon_extension": state.extension,
        "withstands": [_withstood_summary(each) for each in state.withstands],
        "panels_pass_through": state.passing,
        "found": state.found,
        "positions_m": _points(structure, net, state.rest.shape),
    }


def _points(structure: Structure, net: Net, shape: Shape) -> Any:
    return places(net, shape)[: len(structure.points)].tolist()


def _mobility_summary(found: Mobility | None) -> dict[str, int | None]:
    return {
        "degrees_of_freedom": None if found is None else found.degrees_of_freedom,
        "self_stresses": None if found is None else found.self_stresses,
    }


def _withstood_summary(each: Withstood) -> dict[str, Any]:
    return {"load": each.load, f"up_to_{_SUFFIXES[each.unit]}": each.value, "lost_by": each.kind}


def _course_summary(structure: Structure, net: Net, course: Course) -> dict[str, Any]:
    unit, size = drive_unit(structure, course.drive), abs(course.drive.strength)
    degrees = float(np.degrees(1.0)) if unit == "rad" else 1.0
    along = "deg" if driven_motor(structure, course.drive).direction is None else "m"

    def path(points: Sequence[PathPoint]) -> dict[str, Any]:
        forces = {}
        if displaces(structure, course.drive):
            forces = {"force_N": [reaction(structure, net, course.drive, point.shape) for point in points]}
        ways = np.array([gone(structure, net, course.drive, point.shape) for point in points])
        return {
            f"drive_{_SUFFIXES[unit]}": [degrees * size * point.factor for point in points],
            f"gone_{along}": (np.degrees(ways) if along == "deg" else ways).tolist(),
            **forces,
            "energy_J": [point.energy for point in points],
            "ways_downhill": [point.index for point in points],
        }

    return {
        "name": course.name,
        "drive": course.drive.name,
        f"least_{_SUFFIXES[unit]}": None if course.least is None else degrees * course.least,
        **({} if course.largest_force is None else {"largest_force_N": course.largest_force}),
        "ended": course.slow.ended,
        "slow": path(course.slow.points),
        "snaps": [
            {
                "kind": snap.kind,
                f"drive_{_SUFFIXES[unit]}": degrees * size * snap.factor,
                "released_J": snap.released,
            }
            for snap in course.slow.snaps
        ],
        "equilibria": None if course.through is None else path(course.through.points),
        "rests_at_J": course.rest.energy,
    }
