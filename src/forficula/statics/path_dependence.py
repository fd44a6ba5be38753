"""Structures whose rest states depend on how they were folded before; most results of statics exclude them."""

from __future__ import annotations

import math

from forficula.errors import InputError
from forficula.structure import Structure


def path_dependence(structure: Structure) -> str:
    """Return why the rest states of a structure depend on what happened before, as a clause; empty if they do not."""
    yielding = next((hinge for hinge in structure.hinges if math.isfinite(hinge.yield_angle)), None)
    if yielding is None:
        return _wear(structure)
    name = yielding.label or yielding.name
    return f"{name} folds permanently, so that where it rests depends on how it was folded before"


def _wear(structure: Structure) -> str:
    """Return why the moments of a structure depend on what happened before, as a clause; empty without wear."""
    worn = next((hinge for hinge in structure.hinges if hinge.damage is not None), None)
    if worn is None:
        return ""
    return f"{worn.label or worn.name} wears out, so that its moment depends on how often it was folded before"


def refuse_path_dependence(structure: Structure, results: str) -> None:
    """Refuse a structure whose rest states depend on what happened before.

    Args:
        structure: the structure.
        results: results of statics that such a structure lacks, such as "energy landscape".

    Raises:
        InputError: the rest states depend on what happened before.
    """
    if reason := path_dependence(structure):
        follows = "wear" if reason == _wear(structure) else "permanent folds"
        raise InputError(
            f"{structure.name}: has no {results}, because {reason}; runs and quasi-static paths follow {follows}"
        )


def rest_angle_of_nonlinear(structure: Structure) -> str:
    """Return why statics cannot move the rest angles of a structure, as a clause; empty if it can."""
    for motor in structure.motors:
        hinges = [structure.hinges[number] for number in motor.hinges if motor.kind == "rest-angle"]
        bent = next((hinge for hinge in hinges if hinge.quadratic or hinge.cubic), None)
        if bent is not None:
            return f"a drive changes the rest angle of {bent.label or bent.name}, whose moment is nonlinear"
    return ""


def refuse_rest_angles(structure: Structure) -> None:
    """Refuse drives that change rest angles of springs whose moment is not linear.

    Raises:
        InputError: a drive changes such a rest angle.
    """
    if reason := rest_angle_of_nonlinear(structure):
        raise InputError(f"{structure.name}: has no static results, because {reason}; a run follows both")
