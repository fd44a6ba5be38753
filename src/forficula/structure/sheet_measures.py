"""What is watched of a sheet: fold angles, and distances between places on it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from forficula.design import SheetDesign
from forficula.design.sheet_creases import creases_of
from forficula.structure.course import Measure
from forficula.structure.parts import Hinge


def sheet_measures(
    design: SheetDesign,
    hinges: Sequence[Hinge],
    edges: Mapping[int, int],
    point: Callable[[str, str, tuple[float, ...]], int],
) -> tuple[Measure, ...]:
    """The measures of a design, after that of all its creases.

    Args:
        design: of the sheet.
        hinges: that were built.
        edges: numbers of the creases' hinges by the numbers of their edges.
        point: number of the point at a place, by what to call it, the place as text, and where "ground" is.
    """
    every = tuple(sorted(edges.values()))
    measures = [Measure(name="creases", kind="angle", hinges=every, signs=(1,) * len(every), label="fold angle")]
    for watched in design.measure:
        if watched.of is None:
            start, end = (
                point(f"measure_{watched.name}_{key}", getattr(watched, key), watched.ground) for key in ("from", "to")
            )
            measures.append(Measure(name=watched.name, kind="distance", points=(start, end), label=watched.name))
        else:
            turned = tuple(edges[edge] for edge in creases_of(design.sheet, watched.of, design.crease.group))
            # a valley counts as positive
            signs = tuple(hinges[hinge].sense for hinge in turned)
            measures.append(Measure(name=watched.name, kind="angle", hinges=turned, signs=signs, label=watched.name))
    return tuple(measures)
