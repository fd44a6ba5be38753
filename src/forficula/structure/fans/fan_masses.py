"""What the bars of a fan carry beside themselves: its membrane, its tendons and its hinges, as masses at places."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from forficula.arrays import Array
from forficula.design import FanDesign
from forficula.design.places import row_bars
from forficula.pattern.geometry import triangle_areas
from forficula.structure.fans.vein import Vein, panel_lines
from forficula.structure.fans.vein_parts import vein_masses
from forficula.structure.parts import Panel, PointMass


def fan_masses(design: FanDesign, veins: Sequence[Vein]) -> tuple[PointMass, ...]:
    """The masses that the bars of a fan carry, in the units of its design; none where all of them are 0."""
    masses = vein_masses(design, veins)
    return (*masses, *_membrane(design, veins)) if design.membrane.density else masses


def _membrane(design: FanDesign, veins: Sequence[Vein]) -> Iterator[PointMass]:
    """The mass of the panels, strip by strip between two rows of their nodes.

    The margin turns with its vein, and so do the nodes at its edge; those on the other side are on the axis of the next
    vein. From one ring fold on all are those of the bars beyond it, for its row lies on the axes of the hinges.
    """
    by_area = design.membrane.density * design.membrane.thickness
    for panel in fan_panels(design, veins):
        for body, place, area in triangle_masses(panel.corners, panel.carriers):
            index, bar = divmod(body, veins[0].bars)
            yield PointMass(body=body, place=veins[index].on_bar(bar, place), mass=by_area * area, role="membrane")


def fan_panels(design: FanDesign, veins: Sequence[Vein]) -> Iterator[Panel]:
    """The panels in triangles, margins and all, each as wide as the panel is where it lies, from vein to vein."""
    carriers = row_bars(veins[0].bars - 1, design)
    for panel in range(len(veins) - 1):
        lines = panel_lines(design, veins[panel], veins[panel + 1])
        widths = np.linalg.norm(np.subtract(lines[2], lines[0]), axis=1)
        for row, bar in enumerate(carriers):
            bodies = [veins[panel + side].body(panel + side, bar) for side in (0, 0, 1)]
            for strip in (0, 1):
                corners = np.array([line[at] for line in lines[strip : strip + 2] for at in (row, row + 1)])
                on = [bodies[strip]] * 2 + [bodies[strip + 1]] * 2
                for three in ([0, 1, 3], [0, 3, 2]):
                    yield Panel(
                        corners=corners[three],
                        carriers=[on[corner] for corner in three],
                        width=float(widths[row : row + 2].mean()),
                    )


def triangle_masses(corners: Array, carriers: Sequence[int]) -> Iterator[tuple[int, Array, float]]:
    """Masses at places that move as a flat triangle does whose corners bodies carry, of a mass of 1 by area.

    A triangle that one body carries is three masses at the middles of its sides, which have its mass, centre and
    inertia (they integrate any quadratic: Zienkiewicz and Taylor 2000, table 9.2). Where two bodies carry it, what its
    consistent mass matrix, A / 12 (1 + delta), has within a body is kept, and what it has between the two is taken to
    the corners of each: momentum is right in any motion, and the kinetic energy that of the triangle where it does not
    turn; else it is larger, by 1/24 of the triangle's mass times the square of the difference of the velocities of
    every corner of one body and every corner of the other.

    Args:
        corners: (3, 3).
        carriers: numbers of their bodies.

    Yields:
        The number of a body, a place, (3,), and the mass there.
    """
    area = float(triangle_areas(corners))
    for body in dict.fromkeys(carriers):
        own = [corner for corner, carrier in enumerate(carriers) if carrier == body]
        for place, first in enumerate(own):
            for second in own[place + 1 :]:
                yield body, (corners[first] + corners[second]) / 2, area / 3
        if len(own) < 3:
            # of each corner a third of the area, less its half of every side to another corner of the body
            for corner in own:
                yield body, corners[corner], area / 3 - area / 6 * (len(own) - 1)
