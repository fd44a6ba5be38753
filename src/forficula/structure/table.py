"""The table under a structure, and the points at which the structure touches it."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.design import Design
from forficula.design.section import LENGTH
from forficula.errors import InputError
from forficula.quantities import show_quantity
from forficula.structure.parts import GROUND
from forficula.structure.structure import Structure
from forficula.structure.surroundings import Stops, Table

# overlap at the start that counts as rounding, as a share of the structure's size
_ROUNDING = 1e-6


@dataclass(frozen=True, kw_only=True, eq=False)
class TouchingPoint:
    """A sphere of a structure that cannot pass through the table.

    The spheres at the corners of plates and facets, at the ends of bars and at the nodes of membranes have half of the
    thickness as radius. The lowest point of a flat plate or a straight bar is that of one of its spheres.

    Attributes:
        body: number of the body that carries the sphere.
        place: centre in the axes of the body, m, (3,).
        radius: m; 0 for a part without a thickness.
    """

    body: int
    place: Array
    radius: float


def table_of(design: Design) -> Table | None:
    """Return the table of a design, in its units; None without a table."""
    section = design.table
    if section is None:
        return None
    return Table(
        height=section.height,
        friction=section.friction,
        stops=Stops(time_constant=section.time_constant, damping_ratio=section.damping_ratio),
    )


def touching_points(structure: Structure) -> tuple[TouchingPoint, ...]:
    """Return the spheres of a structure that may touch a table; of several at one position, the largest."""
    largest: dict[tuple[int, tuple[float, ...]], float] = {}
    for body, place, radius in _spheres(structure):
        key = body, tuple(np.asarray(place, dtype=np.float64).tolist())
        if body != GROUND:
            largest[key] = max(radius, largest.get(key, 0.0))
    return tuple(
        TouchingPoint(body=body, place=np.array(place), radius=radius) for (body, place), radius in largest.items()
    )


def refuse_below_table(structure: Structure, lowest: float, unit: float = 1.0) -> None:
    """Refuse a structure that starts below its table.

    Args:
        structure: with a table, in any unit of length.
        lowest: height of the lowest sphere at the start, in this unit.
        unit: of length, m.

    Raises:
        InputError: a part is below the table; the message gives the largest height.
    """
    assert structure.table is not None
    if lowest >= structure.table.height - _ROUNDING * structure.span:
        return
    most, chosen = (show_quantity(unit * height, LENGTH, 6) for height in (lowest, structure.table.height))
    raise InputError(
        f"{structure.name}: table.height: the structure starts below the table: need <= {most}, the height of its"
        f" lowest part, got {chosen}"
    )


def _spheres(structure: Structure) -> Iterator[tuple[int, Array, float]]:
    for bar in structure.bars:
        yield bar.body, np.zeros(3), bar.diameter / 2
        yield bar.body, bar.end, bar.diameter / 2
    # the corners of solids lie on their surfaces
    panels = [
        (tuple(sorted({*itertools.chain(*plate.solids)})), 0.0) if plate.solids else (plate.points, plate.thickness)
        for plate in structure.plates
    ]
    panels += [((*facet.points, *facet.inside), facet.thickness) for facet in structure.facets]
    for numbers, thickness in panels:
        for number in numbers:
            yield structure.points[number].body, structure.points[number].place, thickness / 2
    for membrane in structure.membranes:
        for body, place in zip(membrane.bodies.tolist(), membrane.places, strict=True):
            yield body, place, membrane.law.thickness / 2
