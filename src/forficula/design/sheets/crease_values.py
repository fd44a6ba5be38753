"""What every crease of a design has: the values of its section, or of its groups."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from forficula.design.sheets.sheet_creases import creases_of, fold_edges

if TYPE_CHECKING:
    from forficula.design.sheets.sheet import SheetDesign
    from forficula.design.sheets.sheet_parts import Crease


def creases_by_edge(design: SheetDesign) -> dict[int, Crease]:
    """The properties of every crease, those of its last group where that gives them, by the number of its edge."""
    sheet, groups = design.sheet, design.crease.group
    creases = dict.fromkeys(fold_edges(sheet), design.crease)
    for number, group in enumerate(groups):
        given = {key: value for key, value in group if key not in ("name", "of") and value is not None}
        for edge in creases_of(sheet, group.of, groups[:number]):
            creases[edge] = creases[edge].model_copy(update=given)
    return creases


def stops(design: SheetDesign, edge: int, crease: Crease) -> tuple[float, float]:
    """The least and the largest angle of a crease in its own sense, rad; infinite where nothing stops it.

    A rigid facet that no limit is given for folds onto its neighbour and, but at a crease that is not assigned, not the
    other way. A crease that opens folds both ways.
    """
    back, fold = math.inf, math.inf
    if design.facet.kind == "rigid":
        both = crease.extension is not None or design.sheet.edges_assignment[edge] == "U"
        back, fold = math.pi if both else 0.0, math.pi
    low = -(back if crease.back_limit is None else crease.back_limit)
    return low, fold if crease.fold_limit is None else crease.fold_limit


def crease_key(design: SheetDesign, edge: int, key: str) -> str:
    """Where a crease has a value from: the last group that gives it, or the section."""
    groups = design.crease.group
    given = (
        f"crease.group.{number}.{key}"
        for number, group in reversed(list(enumerate(groups)))
        if getattr(group, key) is not None and edge in creases_of(design.sheet, group.of, groups[:number])
    )
    return next(given, f"crease.{key}")


def rest_angle(crease: Crease, built: float) -> float:
    """Where a crease's spring rests, rad, in its own sense: an angle, flat, or as built."""
    match crease.rest_angle:
        case "flat":
            return 0.0
        case str():
            return built
        case angle:
            return angle
