"""A vein in the flat sheet: where it lies, which way it folds, and where its tendon ends."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from forficula.arrays import Array
from forficula.design import FanDesign, TendonSection
from forficula.design.places import margin_edge, mesh_rows
from forficula.structure.parts import Point


@dataclass(frozen=True, kw_only=True, eq=False)
class Vein:
    """Where a vein lies in the flat sheet, and which way it folds: a chain of bars with a hinge between two of them.

    Attributes:
        places: its proximal joint, its hinge at every ring fold, and its tip, from the hub outwards, (3,) each.
        axes: unit vectors of the hinges at the ring folds, (3,) each.
        sense: +1 or -1: the sign of the turn that folds it about its own axis and about the ring creases.
        fixed_base: whether the proximal bar is part of the ground.
    """

    places: tuple[Array, ...]
    axes: tuple[Array, ...]
    sense: int
    fixed_base: bool = False

    @property
    def bars(self) -> int:
        """How many bars it has, one more than hinges at ring folds."""
        return len(self.axes) + 1

    @cached_property
    def frame(self) -> Array:
        """Rotation from the bars' axes (x along the proximal bar, z across the sheet) to the sheet's, (3, 3)."""
        along = (self.places[1] - self.places[0]) / np.linalg.norm(self.places[1] - self.places[0])
        across = np.array([0.0, 0.0, 1.0])
        return np.column_stack([along, np.cross(across, along), across])

    def on_bar(self, bar: int, point: Array) -> Array:
        """A point of the flat sheet in the axes of a bar, from its inner end, which are those of the first, (3,)."""
        return np.asarray(self.frame.T @ (point - self.places[bar]))

    def end(self, bar: int) -> Array:
        """Where a bar ends, in its axes, (3,)."""
        return self.on_bar(bar, self.places[bar + 1])

    def axis(self, fold: int) -> Array:
        """Unit vector of a hinge at a ring fold, in the axes of the bars, (3,)."""
        return np.asarray(self.frame.T @ self.axes[fold])

    def margin_along(self, bar: int) -> Array | None:
        """Along what a margin lies where a bar ends, in the flat sheet, (3,); None where that is to the next vein.

        At a gusset that is what its vein folds about: were it to lean with the ring folds, which tilt from vein to
        vein, its corners would stand out of the folded layer, through the next one.
        """
        return self.axes[bar] if self.bars > 2 and bar < len(self.axes) else None

    def body(self, index: int, bar: int) -> int:
        """Number of the body that a bar is, of the vein with this number among veins of as many bars."""
        return self.bars * index + bar


def panel_lines(design: FanDesign, near: Vein, far: Vein) -> list[Array]:
    """Along a panel, row by row: the axis of its vein, the edge of the margin on it, the axis of the next, (row, 3)."""
    here, there = (mesh_rows(vein.places, design) for vein in (near, far))
    along: list[Array | None] = [None] * len(here)
    for fold in range(near.bars - 1):
        along[len(design.membrane.proximal_rows) + fold] = near.margin_along(fold)
    rows = zip(here, there, along, strict=True)
    return [here, np.array([margin_edge(first, second, design, way) for first, second, way in rows]), there]


def attachments(tendon: TendonSection, index: int, vein: Vein) -> list[Point]:
    """The ends of a vein's tendon, proximal first: on its bars' axes, or off them across the sheet and beside them.

    From the first bar to the last, across all ring folds between them.
    """
    last = vein.bars - 1
    ring, tip = vein.end(0), vein.end(last)
    towards_hub = -ring / np.linalg.norm(ring)
    before = ring + tendon.proximal_attachment * towards_hub
    beyond = tendon.distal_attachment * tip / np.linalg.norm(tip)
    return [
        Point(
            name=f"proximal_attachment{index}",
            role="attachment",
            body=vein.body(index, 0),
            place=before + _off_the_bar(vein, 0, tendon.proximal_offset, tendon.proximal_aside),
        ),
        Point(
            name=f"distal_attachment{index}",
            role="attachment",
            body=vein.body(index, last),
            place=beyond + _off_the_bar(vein, last, tendon.distal_offset, tendon.distal_aside),
        ),
    ]


def _off_the_bar(vein: Vein, number: int, offset: float, aside: float) -> Array:
    """How far a place lies off the axis of a bar, in its axes, (3,).

    An overbend moves the tip along the cross product of the ring direction and the bar, times the vein's sense: out of
    the sheet, towards the side on which offsets count.
    """
    bar, axis = vein.end(number), vein.axis(min(number, len(vein.axes) - 1))
    # cross products with one row, or with the upright, because numpy.cross would take most of the time
    overbend = vein.sense * (axis[0] * bar[1] - axis[1] * bar[0])
    x, y, _ = bar / np.linalg.norm(bar)
    return offset * math.copysign(1.0, overbend) * np.array([0.0, 0.0, 1.0]) + aside * np.array([0.0 - y, x, 0.0])
