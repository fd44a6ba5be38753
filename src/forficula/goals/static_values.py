"""What statics and the parts say of a design, without any simulation: quantities by name, None where there is none."""

from __future__ import annotations

from collections.abc import Collection

from forficula.design import Design
from forficula.goals.outcome_quantity import Source
from forficula.statics.survey import slow_drives
from forficula.statics.tree.equilibrium import barrier_between
from forficula.statics.tree.fold_path import fold_path
from forficula.statics.tree.hinge_landscape import crossed_hinges
from forficula.statics.tree.potential import ensemble
from forficula.structure import Structure, mass_of, structure_of

# of a hinge's curves and of a fold's: their ends, tops and peaks are exact or interpolated by cubics
_HINGE_POINTS, _FOLD_POINTS = 31, 41

Values = dict[str, float | None]


def static_values(design: Design, sources: Collection[Source]) -> Values:
    """Quantities of a design by name, SI, of some sources that need no simulation.

    Args:
        design: of which.
        sources: of "parts", "hinges", "fold" and "slow".

    Returns:
        None where there is no such value, as of the barrier of what has no second stable state.

    Raises:
        InputError: the design cannot be built.
    """
    structure, values = structure_of(design), Values()
    if "parts" in sources:
        values["mass"] = _mass(structure)
    if "hinges" in sources:
        values |= _hinges(structure)
    if "fold" in sources and structure.rigid_fold is not None:
        values |= _fold(structure)
    if "slow" in sources:
        for name, drive in slow_drives(structure).items():
            values |= {f"slow_{name}": drive.least, f"slow_{name}_force": drive.largest_force}
    return values


def _mass(structure: Structure) -> float:
    """Of all bodies, kg: of bars, plates and what they carry, and of bodies that are points, their own."""
    own = sum(body.mass for body in structure.bodies)
    return own + sum(mass_of(structure, number)[0] for number in range(len(structure.bodies)))


def _hinges(structure: Structure) -> Values:
    """Of every hinge that a tendon crosses, alone: what is weakest, and what opposes most."""
    own = [each.own for each in crossed_hinges(structure, _HINGE_POINTS)]
    barriers = [each.barrier for each in own if each.barrier is not None]
    torques = [each.holding_torque for each in own if each.holding_torque is not None]
    peaks = [each.peak_opening.torque for each in own if each.peak_opening is not None]
    whole = bool(own) and len(barriers) == len(torques) == len(own)
    return {
        "hinge_barrier": min(barriers) if whole else None,
        "hinge_holding_torque": min(torques) if whole else None,
        "hinge_opening_torque": max(peaks, default=None),
    }


def _fold(structure: Structure) -> Values:
    """Barriers along the fold between its first and its last stable state, and what holds the first."""
    path = fold_path(ensemble([structure]), _FOLD_POINTS)
    stable = [state for state in path.states if state.stable]
    if len(stable) < 2 or stable[0].coordinate == stable[-1].coordinate:
        return {"barrier": None, "opening_barrier": None, "holding_torque": None}
    return {
        "barrier": barrier_between(path.states, stable[0], stable[-1]),
        "opening_barrier": barrier_between(path.states, stable[-1], stable[0]),
        "holding_torque": stable[0].press * 2 / path.turns if stable[0].kind == "stop" else None,
    }
