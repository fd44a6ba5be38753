"""Quantities of a design from statics and parts, without simulation, by name."""

from __future__ import annotations

from collections.abc import Collection

from forficula.analysis.package import flat_package
from forficula.design import Design
from forficula.goals.outcome_quantity import Source
from forficula.statics.path_dependence import refuse_path_dependence
from forficula.statics.survey import slow_drives
from forficula.statics.tree.ensemble import ensemble
from forficula.statics.tree.equilibrium import barrier_between
from forficula.statics.tree.fold_path import fold_path
from forficula.statics.tree.hinge_landscape import crossed_hinges
from forficula.structure import Structure, mass_of, structure_of

# points of a hinge's and of a fold's curves; their ends, maxima and peaks are exact or interpolated by cubics
_HINGE_POINTS, _FOLD_POINTS = 31, 41

Values = dict[str, float | None]


def static_values(design: Design, sources: Collection[Source]) -> Values:
    """Return quantities of a design by name, SI, from sources that need no simulation.

    Args:
        design: the design.
        sources: some of "parts", "sheet", "hinges", "fold" and "slow".

    Returns:
        None for a value that does not exist, such as the barrier without a second stable state.

    Raises:
        InputError: the design cannot be built, or a crease folds permanently and a source depends on rest states.
    """
    structure, values = structure_of(design), Values()
    if "parts" in sources:
        values["mass"] = _mass(structure)
    if "sheet" in sources and structure.appearance.pattern is not None:
        folded = flat_package(structure)
        values["folding_ratio"] = None if folded is None else folded.folding_ratio
        values["folded_height"] = None if folded is None else folded.height
    if "hinges" in sources or "fold" in sources:
        refuse_path_dependence(structure, "barriers and holding torques")
    if "hinges" in sources:
        values |= _hinges(structure)
    if "fold" in sources and structure.rigid_fold is not None:
        values |= _fold(structure)
    if "slow" in sources:
        for name, drive in slow_drives(structure).items():
            values |= {f"slow_{name}": drive.least, f"slow_{name}_force": drive.largest_force}
    return values


def _mass(structure: Structure) -> float:
    """Return the mass of all bodies, kg: bars, plates and what they carry, and the mass of points."""
    points = sum(body.mass for body in structure.bodies)
    return points + sum(mass_of(structure, number)[0] for number in range(len(structure.bodies)))


def _hinges(structure: Structure) -> Values:
    """Return the weakest and the most resistant values among hinges that a tendon crosses, each hinge alone."""
    landscapes = [hinge.actual for hinge in crossed_hinges(structure, _HINGE_POINTS)]
    barriers = [hinge.barrier for hinge in landscapes if hinge.barrier is not None]
    torques = [hinge.holding_torque for hinge in landscapes if hinge.holding_torque is not None]
    peaks = [hinge.peak_opening.torque for hinge in landscapes if hinge.peak_opening is not None]
    complete = bool(landscapes) and len(barriers) == len(torques) == len(landscapes)
    return {
        "hinge_barrier": min(barriers) if complete else None,
        "hinge_holding_torque": min(torques) if complete else None,
        "hinge_opening_torque": max(peaks, default=None),
    }


def _fold(structure: Structure) -> Values:
    """Return barriers along the fold between first and last stable state, and the holding torque of the first."""
    path = fold_path(ensemble([structure]), _FOLD_POINTS)
    stable = [state for state in path.states if state.stable]
    if len(stable) < 2 or stable[0].coordinate == stable[-1].coordinate:
        return {"barrier": None, "opening_barrier": None, "holding_torque": None}
    return {
        "barrier": barrier_between(path.states, stable[0], stable[-1]),
        "opening_barrier": barrier_between(path.states, stable[-1], stable[0]),
        "holding_torque": stable[0].press * 2 / path.turns if stable[0].kind == "stop" else None,
    }
