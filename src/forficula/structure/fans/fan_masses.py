"""Masses of the membrane, the tendons and the hinges of a fan, as point masses on its bars."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from forficula.arrays import Array
from forficula.design import FanDesign
from forficula.design.places import row_bars
from forficula.pattern.geometry import triangle_areas
from forficula.structure.fans.vein import Vein, panel_lines
from forficula.structure.fans.vein_parts import vein_masses
from forficula.structure.parts import PointMass
from forficula.structure.surroundings import Panel


def fan_masses(design: FanDesign, veins: Sequence[Vein]) -> tuple[PointMass, ...]:
    """Return the point masses that the bars of a fan carry, in the units of its design; none if all are 0."""
    masses = vein_masses(design, veins)
    return (*masses, *_membrane(design, veins)) if design.membrane.density else masses


def _membrane(design: FanDesign, veins: Sequence[Vein]) -> Iterator[PointMass]:
    """Yield the point masses of the panels, strip by strip between two rows of nodes.

    The margin and the nodes at its edge turn with its vein. The nodes on the other side lie on the axis of the next
    vein. A strip beyond a ring fold is carried by the bars beyond it, because the row of the fold lies on the axes of
    the hinges.
    """
    by_area = design.membrane.density * design.membrane.thickness
    for panel in fan_panels(design, veins):
        for body, place, area in triangle_masses(panel.corners, panel.carriers):
            index, bar = divmod(body, veins[0].bars)
            yield PointMass(body=body, place=veins[index].on_bar(bar, place), mass=by_area * area, role="membrane")


def fan_panels(design: FanDesign, veins: Sequence[Vein]) -> Iterator[Panel]:
    """Yield the panels, including margins, as triangles; the width of each is that of the panel, from vein to vein."""
    carriers = row_bars(veins[0].bars - 1, design)
    for panel in range(len(veins) - 1):
        lines = panel_lines(design, veins[panel], veins[panel + 1])
        widths = np.linalg.norm(np.subtract(lines[2], lines[0]), axis=1)
        for row, bar in enumerate(carriers):
            bodies = [veins[panel + side].body(panel + side, bar) for side in (0, 0, 1)]
            for strip in (0, 1):
                corners = np.array([line[at] for line in lines[strip : strip + 2] for at in (row, row + 1)])
                corner_bodies = [bodies[strip]] * 2 + [bodies[strip + 1]] * 2
                for triangle in ([0, 1, 3], [0, 3, 2]):
                    yield Panel(
                        corners=corners[triangle],
                        carriers=[corner_bodies[corner] for corner in triangle],
                        width=float(widths[row : row + 2].mean()),
                    )


def triangle_masses(corners: Array, carriers: Sequence[int]) -> Iterator[tuple[int, Array, float]]:
    """Yield point masses that represent a flat triangle with a mass of 1 per area, whose corners bodies carry.

    If one body carries the triangle, three masses at the midpoints of the sides have the mass, centre and inertia of
    the triangle (they integrate any quadratic: Zienkiewicz and Taylor 2000, table 9.2). If two bodies carry it, the
    entries of the consistent mass matrix, A / 12 (1 + delta), within each body are kept, and those between the bodies
    are moved to the corners of each. The momentum is then exact for any motion. The kinetic energy is exact if the
    triangle does not rotate; otherwise it is larger by 1/24 of the triangle's mass times the squared velocity
    difference, summed over all pairs of a corner of one body and a corner of the other.

    Args:
        corners: positions of the corners, (3, 3).
        carriers: numbers of the bodies that carry the corners.

    Yields:
        The number of a body, a position, (3,), and the mass at this position.
    """
    area = float(triangle_areas(corners))
    for body in dict.fromkeys(carriers):
        carried = [corner for corner, carrier in enumerate(carriers) if carrier == body]
        for index, first in enumerate(carried):
            for second in carried[index + 1 :]:
                yield body, (corners[first] + corners[second]) / 2, area / 3
        if len(carried) < 3:
            # each corner has a third of the area, minus half of the mass on each side to another corner of the body
            for corner in carried:
                yield body, corners[corner], area / 3 - area / 6 * (len(carried) - 1)
