"""The values of every crease of a design: those of its section or of its groups."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from forficula.design.section import SMALL_LENGTH
from forficula.design.sheets.crease_law_section import CreaseLawSection
from forficula.design.sheets.crease_sections import Crease, CreaseGroup, group_values, named_laws_of, with_law
from forficula.design.sheets.sheet_creases import creases_of, fold_edges
from forficula.names import listed
from forficula.quantities import show_quantity

if TYPE_CHECKING:
    from forficula.design.sheets.sheet import SheetDesign

# angles of a crease that two parallel folds share
_ANGLES = ("rest_angle", "start", "fold_limit", "back_limit", "lock_angle")
_SAME_THICKNESS = 0.01  # largest relative difference of thicknesses that count as equal


def creases_by_edge(design: SheetDesign) -> dict[int, Crease]:
    """Return the values of every crease by the number of its edge; values of the last group with the crease prevail.

    Values that a law gives are filled in, and `law` is the form of the spring. Each of two parallel folds of a split
    fold has half the angles of the fold.
    """
    sheet, groups = design.sheet, design.crease.group
    creases = dict.fromkeys(fold_edges(sheet), with_law(design.crease))
    for number, group in enumerate(groups):
        values = group_values(group)
        for edge in creases_of(sheet, group.of, groups[:number]):
            creases[edge] = creases[edge].model_copy(update=values)
    for edge in creases:
        if (share := float(sheet.edges_share[edge])) != 1:
            creases[edge] = _part_of(creases[edge], share)
    return creases


def _part_of(crease: Crease, share: float) -> Crease:
    """Return the values of one of several parallel folds that replace a crease: its angles are parts of those."""
    values = {key: getattr(crease, key) for key in _ANGLES}
    return crease.model_copy(update={key: share * at for key, at in values.items() if isinstance(at, float)})


def stops(design: SheetDesign, edge: int, crease: Crease) -> tuple[float, float]:
    """Return the least and the largest angle of a crease in its own sense, rad; infinite without a stop.

    Without limits, a rigid facet folds until it touches its neighbour, and only in the assigned sense. A crease that is
    unassigned or that opens folds in both senses.
    """
    back, fold = math.inf, math.inf
    if design.facet.kind == "rigid":
        both = crease.extension is not None or design.sheet.edges_assignment[edge] == "U"
        most = math.pi * float(design.sheet.edges_share[edge])
        back, fold = most if both else 0.0, most
    low = -(back if crease.back_limit is None else crease.back_limit)
    return low, fold if crease.fold_limit is None else crease.fold_limit


def crease_key(design: SheetDesign, edge: int, key: str) -> str:
    """Return the key that sets a value of a crease: that of the last group which has it, or of the section.

    If a law gives the value, it is the key of the value in the law.
    """
    groups = design.crease.group
    sections: list[tuple[str, CreaseGroup | Crease]] = [
        (f"crease.group.{number}", group)
        for number, group in reversed(list(enumerate(groups)))
        if edge in creases_of(design.sheet, group.of, groups[:number])
    ]
    for name, section in (*sections, ("crease", design.crease)):
        if getattr(section, key) is not None:
            return f"{name}.{key}"
        if isinstance(section.law, CreaseLawSection) and getattr(section.law, key, None) is not None:
            return f"{name}.law.{key}"
    return f"crease.{key}"


def law_sentences(crease: Crease, thickness: float | None) -> tuple[str, ...]:
    """Return sentences about laws of creases with chosen values, or for a sheet of another thickness.

    Args:
        crease: section of the creases.
        thickness: thickness of the sheet, m.
    """
    sentences = list[str]()
    for key, law in named_laws_of(crease).items():
        section = crease if key == "crease.law" else crease.group[int(key.split(".")[2])]
        chosen = [name for name in law.chosen if getattr(section, name, None) is None]
        if chosen:
            verb = "is" if len(chosen) == 1 else "are"
            sentences.append(f'{key} "{law.name}": {listed(chosen)} {verb} chosen, not measured ({law.source})')
        if law.thickness is not None and not math.isclose(law.thickness, thickness or 0.0, rel_tol=_SAME_THICKNESS):
            sentences.append(
                f'{key} "{law.name}" applies to a sheet of {show_quantity(law.thickness, SMALL_LENGTH)}, but'
                f" facet.thickness is {show_quantity(thickness or 0.0, SMALL_LENGTH)}; its values are not scaled:"
                f" change facet.thickness, or give the values for this sheet, such as {key}.stiffness"
            )
    return tuple(sentences)


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
        case None | str():
            return built
        case angle:
            return angle
