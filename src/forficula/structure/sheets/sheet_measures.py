"""What is watched of a sheet: fold angles, and distances between places on it."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from forficula.design import SheetDesign
from forficula.design.sheets.sheet_creases import creases_of
from forficula.structure.course import Measure
from forficula.structure.parts import Hinge


def sheet_measures(
    design: SheetDesign,
    hinges: Sequence[Hinge],
    point: Callable[[str, str, tuple[float, ...]], int],
) -> tuple[Measure, ...]:
    """The measures of a design, after that of all its creases.

    Args:
        design: of the sheet.
        hinges: that were built.
        point: number of the point at a place, by what to call it, the place as text, and where "ground" is.
    """
    edges = hinges_by_edge(hinges)
    every = tuple(sorted(hinge for parts in edges.values() for hinge in parts))
    measures = [Measure(name="creases", kind="angle", hinges=every, signs=(1,) * len(every), label="fold angle")]
    for watched in design.measure:
        if watched.of is None:
            start, end = (
                point(f"measure_{watched.name}_{key}", getattr(watched, key), watched.ground) for key in ("from", "to")
            )
            measures.append(Measure(name=watched.name, kind="distance", points=(start, end), label=watched.name))
        else:
            creases = creases_of(design.sheet, watched.of, design.crease.group)
            turned = tuple(hinge for edge in creases for hinge in edges[edge])
            # a valley counts as positive
            signs = tuple(hinges[hinge].sense for hinge in turned)
            measures.append(Measure(name=watched.name, kind="angle", hinges=turned, signs=signs, label=watched.name))
    return tuple(measures)


def hinges_by_edge(hinges: Sequence[Hinge]) -> dict[int, list[int]]:
    """Numbers of the hinges along every crease of a sheet, of which it has several where it is split."""
    found: dict[int, list[int]] = {}
    for number, hinge in enumerate(hinges):
        if hinge.edge >= 0:
            found.setdefault(hinge.edge, []).append(number)
    return found
