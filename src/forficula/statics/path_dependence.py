"""Structures whose rest states depend on how they were folded before; most results of statics exclude them."""

from __future__ import annotations

import math

from forficula.errors import InputError
from forficula.structure import Structure


def path_dependence(structure: Structure) -> str:
    """Return why the rest states of a structure depend on what happened before, as a clause; empty if they do not."""
    yielding = next((hinge for hinge in structure.hinges if math.isfinite(hinge.yield_angle)), None)
    if yielding is None:
        return ""
    name = yielding.label or yielding.name
    return f"{name} folds permanently, so that where it rests depends on how it was folded before"


def refuse_path_dependence(structure: Structure, results: str) -> None:
    """Refuse a structure whose rest states depend on what happened before, or on a table.

    Args:
        structure: the structure.
        results: results of statics that such a structure lacks, such as "energy landscape".

    Raises:
        InputError: the rest states depend on what happened before, or the structure has a table.
    """
    refuse_table(structure, results)
    if reason := path_dependence(structure):
        raise InputError(f"{structure.name}: has no {results}, because {reason}; a run follows permanent folds")


def refuse_table(structure: Structure, results: str) -> None:
    """Refuse a structure that a table may support, which statics ignores.

    Args:
        structure: the structure.
        results: results of statics that such a structure lacks, such as "energy landscape".

    Raises:
        InputError: the structure has a table.
    """
    if structure.table is not None:
        raise InputError(
            f"{structure.name}: has no {results}, because statics ignores the table; a run includes it, and"
            ' table = "none" leaves it out'
        )
