"""A vein in the flat sheet: where it lies, which way it folds, and where its tendon ends."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from forficula.design import TendonSection
from forficula.structure.parts import Array, Point


@dataclass(frozen=True, kw_only=True, eq=False)
class Vein:
    """Where a vein lies in the flat sheet, and which way it folds.

    Attributes:
        hub_point: its proximal joint, (3,).
        ring_vertex: its distal hinge, (3,).
        tip: its outer end, (3,).
        ring_direction: unit vector of the distal hinge's axis, (3,).
        sense: +1 or -1: the sign of the turn that folds it about its own axis and about the ring crease.
        fixed_base: whether the proximal bar is part of the ground.
    """

    hub_point: Array
    ring_vertex: Array
    tip: Array
    ring_direction: Array
    sense: int
    fixed_base: bool = False

    @cached_property
    def frame(self) -> NDArray[np.float64]:
        """Rotation from the bar's axes (x along the proximal bar, z across the sheet) to the sheet's, (3, 3)."""
        along = (self.ring_vertex - self.hub_point) / np.linalg.norm(self.ring_vertex - self.hub_point)
        across = np.array([0.0, 0.0, 1.0])
        return np.column_stack([along, np.cross(across, along), across])

    def on_proximal_bar(self, point: Array) -> Array:
        """A point of the flat sheet in the axes of the proximal bar, (3,)."""
        return np.asarray(self.frame.T @ (point - self.hub_point))

    def on_distal_bar(self, point: Array) -> Array:
        """A point of the flat sheet in the axes of the distal bar, which are those of the proximal one, (3,)."""
        return np.asarray(self.frame.T @ (point - self.ring_vertex))


def attachments(tendon: TendonSection, index: int, vein: Vein) -> list[Point]:
    """The ends of a vein's tendon, proximal first: on its bars' axes, or off them across the sheet and beside them."""
    ring, tip = vein.on_proximal_bar(vein.ring_vertex), vein.on_distal_bar(vein.tip)
    towards_hub = -ring / np.linalg.norm(ring)
    before = ring + tendon.proximal_attachment * towards_hub
    beyond = tendon.distal_attachment * tip / np.linalg.norm(tip)
    return [
        Point(
            name=f"proximal_attachment{index}",
            role="attachment",
            body=2 * index,
            place=before + _off_the_bar(vein, ring, tendon.proximal_offset, tendon.proximal_aside),
        ),
        Point(
            name=f"distal_attachment{index}",
            role="attachment",
            body=2 * index + 1,
            place=beyond + _off_the_bar(vein, tip, tendon.distal_offset, tendon.distal_aside),
        ),
    ]


def _off_the_bar(vein: Vein, bar: Array, offset: float, aside: float) -> Array:
    """How far a place lies off the axis of a bar, which is given in its own axes from the hub on, (3,).

    An overbend moves the tip along the cross product of the ring direction and the bar, times the vein's sense: out of
    the sheet, towards the side on which offsets count.
    """
    across = np.array([0.0, 0.0, 1.0])
    overbend = vein.sense * np.cross(vein.frame.T @ vein.ring_direction, bar)[2]
    beside = np.cross(across, bar / np.linalg.norm(bar))
    return offset * math.copysign(1.0, overbend) * across + aside * beside
