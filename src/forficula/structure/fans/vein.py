"""A vein in the flat sheet: its position, the sense in which it folds, and the ends of its tendon."""

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
    """A vein in the flat sheet: a chain of bars with a hinge between neighbouring bars.

    Attributes:
        places: positions of the proximal joint, the hinge at every ring fold, and the tip, from the hub outwards, (3,)
            each.
        axes: unit vectors of the hinges at the ring folds, (3,) each.
        sense: +1 or -1, the sign of the turn that folds the vein about its own axis and about the ring creases.
        fixed_base: whether the proximal bar is fixed to the ground.
    """

    places: tuple[Array, ...]
    axes: tuple[Array, ...]
    sense: int
    fixed_base: bool = False

    @property
    def bars(self) -> int:
        """Number of bars, one more than hinges at ring folds."""
        return len(self.axes) + 1

    @cached_property
    def frame(self) -> Array:
        """Rotation from the bars' axes (x along the proximal bar, z normal to the sheet) to the sheet's, (3, 3)."""
        along = (self.places[1] - self.places[0]) / np.linalg.norm(self.places[1] - self.places[0])
        across = np.array([0.0, 0.0, 1.0])
        return np.column_stack([along, np.cross(across, along), across])

    def on_bar(self, bar: int, point: Array) -> Array:
        """Convert a point of the flat sheet to the axes of a bar, from its inner end, (3,); all have parallel axes."""
        return np.asarray(self.frame.T @ (point - self.places[bar]))

    def end(self, bar: int) -> Array:
        """Return the outer end of a bar in its axes, (3,)."""
        return self.on_bar(bar, self.places[bar + 1])

    def axis(self, fold: int) -> Array:
        """Return the unit vector of a hinge at a ring fold in the axes of the bars, (3,)."""
        return np.asarray(self.frame.T @ self.axes[fold])

    def margin_along(self, bar: int) -> Array | None:
        """Return the direction of the margin at the end of a bar, in the flat sheet, (3,); None for "to the next vein".

        At a gusset, the direction is the axis about which the vein folds. With the direction of the ring folds, which
        differs from vein to vein, the corners of the margin would protrude from the folded layer through the next one.
        """
        return self.axes[bar] if self.bars > 2 and bar < len(self.axes) else None

    def body(self, index: int, bar: int) -> int:
        """Return the number of a bar's body for the vein with this index, if all veins have the same number of bars."""
        return self.bars * index + bar


def panel_lines(design: FanDesign, near: Vein, far: Vein) -> list[Array]:
    """Compute lines along a panel: on its vein's axis, at the edge of its margin, on the next axis, (row, 3) each."""
    start, end = (mesh_rows(vein.places, design) for vein in (near, far))
    along: list[Array | None] = [None] * len(start)
    for fold in range(near.bars - 1):
        along[len(design.membrane.proximal_rows) + fold] = near.margin_along(fold)
    rows = zip(start, end, along, strict=True)
    return [start, np.array([margin_edge(first, second, design, direction) for first, second, direction in rows]), end]


def attachments(tendon: TendonSection, index: int, vein: Vein) -> list[Point]:
    """Return the ends of a vein's tendon on the first and the last bar, proximal first.

    The ends lie on the axes of the bars, or are offset normal to the sheet and in the sheet.
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
    """Compute the displacement of an attachment from the axis of a bar, in the bar's axes, (3,).

    An overbend moves the tip out of the sheet along the cross product of the ring direction and the bar, times the
    vein's sense. Offsets are positive towards this side.
    """
    bar, axis = vein.end(number), vein.axis(min(number, len(vein.axes) - 1))
    # cross products written out for the components needed, because numpy.cross would take most of the time
    overbend = vein.sense * (axis[0] * bar[1] - axis[1] * bar[0])
    x, y, _ = bar / np.linalg.norm(bar)
    return offset * math.copysign(1.0, overbend) * np.array([0.0, 0.0, 1.0]) + aside * np.array([0.0 - y, x, 0.0])
