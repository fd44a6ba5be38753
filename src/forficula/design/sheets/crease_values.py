"""The values of every crease of a design: those of its section or of its groups."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from forficula.design.sheets.sheet_creases import creases_of, fold_edges
from forficula.design.sheets.sheet_sections import NONE

if TYPE_CHECKING:
    from forficula.design.sheets.sheet import SheetDesign
    from forficula.design.sheets.sheet_sections import Crease


def creases_by_edge(design: SheetDesign) -> dict[int, Crease]:
    """Return the values of every crease by the number of its edge; values of the last group with the crease prevail."""
    sheet, groups = design.sheet, design.crease.group
    creases = dict.fromkeys(fold_edges(sheet), design.crease)
    for number, group in enumerate(groups):
        values: dict[str, object] = {
            key: None if value == NONE else value
            for key, value in group
            if key not in ("name", "of") and value is not None
        }
        if group.yield_moment == NONE:
            values["hardening"] = None
        for edge in creases_of(sheet, group.of, groups[:number]):
            creases[edge] = creases[edge].model_copy(update=values)
    return creases


def stops(design: SheetDesign, edge: int, crease: Crease) -> tuple[float, float]:
    """Return the least and the largest angle of a crease in its own sense, rad; infinite without a stop.

    Without limits, a rigid facet folds until it touches its neighbour, and only in the assigned sense. A crease that is
    unassigned or that opens folds in both senses.
    """
    back, fold = math.inf, math.inf
    if design.facet.kind == "rigid":
        both = crease.extension is not None or design.sheet.edges_assignment[edge] == "U"
        back, fold = math.pi if both else 0.0, math.pi
    low = -(back if crease.back_limit is None else crease.back_limit)
    return low, fold if crease.fold_limit is None else crease.fold_limit


def crease_key(design: SheetDesign, edge: int, key: str) -> str:
    """Return the key that sets a value of a crease: that of the last group which has it, or of the section."""
    groups = design.crease.group
    group_keys = (
        f"crease.group.{number}.{key}"
        for number, group in reversed(list(enumerate(groups)))
        if getattr(group, key) is not None and edge in creases_of(design.sheet, group.of, groups[:number])
    )
    return next(group_keys, f"crease.{key}")


def yield_angle(crease: Crease) -> float:
    """Return the angle from rest at which a crease begins to yield, rad; inf if it never yields."""
    if crease.yield_moment is None or not crease.stiffness:
        return math.inf
    return crease.yield_moment / crease.stiffness


def rest_angle(crease: Crease, built: float) -> float:
    """Return the rest angle of a crease's spring, rad, in the crease's own sense."""
    match crease.rest_angle:
        case "flat":
            return 0.0
        case str():
            return built
        case angle:
            return angle
