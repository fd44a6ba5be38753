"""The landscape of a net as plain data with units in its keys, as `landscape.json` has it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from forficula.statics.net.load_path import PathPoint
from forficula.statics.net.net import Shape
from forficula.statics.net.net_of import places
from forficula.statics.net_course import Course, displaces, gone, reaction
from forficula.statics.net_landscape import NetLandscape
from forficula.statics.net_state import Mobility, NetState, Withstood
from forficula.structure import Structure, drive_unit, driven_motor

_SUFFIXES = {"N": "N", "N m": "N_m", "rad": "deg", "m": "m", "Pa": "Pa", "m/s^2": "m_per_s2"}


def net_summary(structure: Structure, net: NetLandscape) -> dict[str, Any]:
    """The landscape of a net as plain data with units in its keys."""
    return {
        "search": {
            "seed": net.search.seed,
            "tries": net.search.tries,
            "found": len(net.search.states),
            "failed": net.search.failed,
        },
        "as_built": _mobility(net.built),
        "states": [_state(structure, net, state) for state in net.states],
        "saddles": [
            {
                "between": [net.states[end].name for end in each.ends],
                "energy_J": each.saddle.rest.energy,
                "barriers_J": list(each.barriers),
                "positions_m": _points(structure, net, each.saddle.rest.shape),
            }
            for each in net.passes
        ],
        "courses": [_course(structure, net, course) for course in net.courses],
    }


def _state(structure: Structure, net: NetLandscape, state: NetState) -> dict[str, Any]:
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
        **_mobility(state.mobility),
        "largest_bar_strain": state.strain,
        "largest_stress_Pa": state.stress,
        "largest_tendon_extension": state.extension,
        "withstands": [_withstood(each) for each in state.withstands],
        "panels_pass_through": state.passing,
        "found": state.found,
        "positions_m": _points(structure, net, state.rest.shape),
    }


def _points(structure: Structure, net: NetLandscape, shape: Shape) -> Any:
    return places(net.net, shape)[: len(structure.points)].tolist()


def _mobility(found: Mobility | None) -> dict[str, int | None]:
    return {
        "degrees_of_freedom": None if found is None else found.degrees_of_freedom,
        "self_stresses": None if found is None else found.self_stresses,
    }


def _withstood(each: Withstood) -> dict[str, Any]:
    return {"load": each.load, f"up_to_{_SUFFIXES[each.unit]}": each.value, "lost_by": each.kind}


def _course(structure: Structure, net: NetLandscape, course: Course) -> dict[str, Any]:
    unit, size = drive_unit(structure, course.drive), abs(course.drive.strength)
    degrees = float(np.degrees(1.0)) if unit == "rad" else 1.0
    along = "deg" if driven_motor(structure, course.drive).direction is None else "m"

    def path(points: Sequence[PathPoint]) -> dict[str, Any]:
        forces = {}
        if displaces(structure, course.drive):
            forces = {"force_N": [reaction(structure, net.net, course.drive, point.shape) for point in points]}
        ways = np.array([gone(structure, net.net, course.drive, point.shape) for point in points])
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
