"""Measures of a sheet: fold angles, and distances between places on the sheet."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from forficula.design import SheetDesign
from forficula.design.sheets.sheet_creases import creases_of
from forficula.structure.motors_and_measures import Measure
from forficula.structure.parts import Hinge


def sheet_measures(
    design: SheetDesign,
    hinges: Sequence[Hinge],
    point: Callable[[str, str, tuple[float, ...]], int],
) -> tuple[Measure, ...]:
    """Return the measure of all creases, then those of the design.

    Args:
        design: design of the sheet.
        hinges: hinges of the structure.
        point: function that returns the number of the point at a place, given a name for the point, the place as text
            and the position of "ground".
    """
    edges = hinges_by_edge(hinges)
    every = tuple(sorted(hinge for parts in edges.values() for hinge in parts))
    measures = [Measure(name="creases", kind="angle", hinges=every, signs=(1,) * len(every), label="fold angle")]
    for section in design.measure:
        if section.of is None:
            start, end = (
                point(f"measure_{section.name}_{key}", getattr(section, key), section.ground) for key in ("from", "to")
            )
            measures.append(Measure(name=section.name, kind="distance", points=(start, end), label=section.name))
        else:
            creases = creases_of(design.sheet, section.of, design.crease.group)
            measured = tuple(hinge for edge in creases for hinge in edges[edge])
            # valleys are positive
            signs = tuple(hinges[hinge].sense for hinge in measured)
            measures.append(Measure(name=section.name, kind="angle", hinges=measured, signs=signs, label=section.name))
    return tuple(measures)


def hinges_by_edge(hinges: Sequence[Hinge]) -> dict[int, list[int]]:
    """Return the numbers of the hinges along every crease of a sheet; a split crease has several."""
    numbers: dict[int, list[int]] = {}
    for number, hinge in enumerate(hinges):
        if hinge.edge >= 0:
            numbers.setdefault(hinge.edge, []).append(number)
    return numbers
