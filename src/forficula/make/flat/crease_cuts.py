"""Creases as dashed cuts: a perforation, or a lattice whose strips between staggered cuts twist."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Indices
from forficula.design import MakeSection
from forficula.make.flat.regions import spans_within

# a shortened cut at the end of a crease is omitted below this fraction of a whole cut
_SHORTEST = 1 / 3
_ROUNDING = 1e-9  # rounding error of a number of cuts


@dataclass(frozen=True, kw_only=True, eq=False)
class CreaseLine:
    """A crease of a flat sheet, with the neighbouring lines at its ends.

    Attributes:
        tail: m, (2,).
        head: m, (2,).
        beside: angles to the next creases or cuts at the tail and at the head, rad: for each end first to the left of
            the line from tail to head, then to the right; inf if there is none.
        beyond: distance by which it may continue beyond its tail and its head, through a margin, m.
    """

    tail: Array
    head: Array
    beside: tuple[tuple[float, float], tuple[float, float]]
    beyond: tuple[float, float] = (0.0, 0.0)

    @property
    def length(self) -> float:
        """Distance from tail to head, m."""
        return float(np.linalg.norm(self.head - self.tail))

    @property
    def along(self) -> Array:
        """Unit vector from tail to head, (2,)."""
        return np.asarray((self.head - self.tail) / self.length)


def crease_cuts(crease: CreaseLine, make: MakeSection, sides: Array) -> list[Array]:
    """Return the cuts of a crease in the style of its design, with the length of the gaps that they leave.

    A perforation is a row of whole cuts with bridges between them, centred on the crease, so that both ends stay
    bridged. A lattice has several rows, every second row shifted by half a cut and half a bridge (lamina emergent
    torsion: Jacobsen, Chen, Howell and Magleby 2009, Mechanism and Machine Theory 44, 2098), with shortened cuts at the
    ends. Cuts keep half a bridge and half a kerf away from the bisector to the next crease at either end, so that the
    cuts of neighbouring creases leave a bridge between them and never cross.

    Args:
        crease: the crease.
        make: how the sheet is made; with a style other than a score.
        sides: sides of the region in which cuts are allowed, m, (side, 2, 2).

    Returns:
        The ends of every cut, m, (2, 2) each; empty if the crease is too short.
    """
    across = np.array([-crease.along[1], crease.along[0]])
    cuts: list[Array] = []
    for row, offset in enumerate(row_offsets(make)):
        start = crease.tail + offset * across
        least, most = _between_bisectors(crease, offset, (make.crease_bridge + make.kerf) / 2)
        for low, high in spans_within(sides, start, crease.along, least, most):
            if high <= 0 or low >= crease.length:
                continue
            if make.crease_style == "perforation":
                dashes = whole_dashes(low, high, make.crease_cut, make.crease_bridge)
            else:
                shift = crease.length / 2 + (row % 2) * (make.crease_cut + make.crease_bridge) / 2
                dashes = clipped_dashes(low, high, make.crease_cut, make.crease_bridge, shift)
            cuts += [start + np.outer(ends, crease.along) for ends in dashes]
    return cuts


def row_offsets(make: MakeSection) -> list[float]:
    """Return the offsets of the rows of cuts to the left of their crease, m."""
    rows = make.lattice_rows if make.crease_style == "lattice" else 1
    return [(row - (rows - 1) / 2) * make.lattice_pitch for row in range(rows)]


def crease_width(make: MakeSection) -> float:
    """Return the distance between the first and the last row of a crease, m; 0 for a score or a perforation."""
    return row_offsets(make)[-1] - row_offsets(make)[0]


def whole_dashes(low: float, high: float, cut: float, bridge: float) -> list[tuple[float, float]]:
    """Return as many whole cuts with bridges between them as fit, centred in the available length, m."""
    count = math.floor((high - low + bridge) / (cut + bridge) + _ROUNDING)
    first = (low + high - count * (cut + bridge) + bridge) / 2
    return [(first + k * (cut + bridge), first + k * (cut + bridge) + cut) for k in range(count)]


def clipped_dashes(low: float, high: float, cut: float, bridge: float, middle: float) -> list[tuple[float, float]]:
    """Return cuts with bridges between them, clipped at the ends, m; one cut is centred at `middle`."""
    period = cut + bridge
    first, last = math.floor((low - middle) / period), math.ceil((high - middle) / period)
    cuts = [(middle + k * period - cut / 2, middle + k * period + cut / 2) for k in range(first, last + 1)]
    inside = [(max(start, low), min(end, high)) for start, end in cuts]
    return [(start, end) for start, end in inside if end - start >= _SHORTEST * cut]


def _between_bisectors(crease: CreaseLine, offset: float, apart: float) -> tuple[float, float]:
    """Return the allowed start and end of a row, from the tail, m, at a distance from the bisectors, m.

    A point (s, y) of the row is at the distance s sin(a / 2) - abs(y) cos(a / 2) from the bisector to a crease at the
    angle a on its side of the line.
    """
    reach = []
    for (left, right), beyond in zip(crease.beside, crease.beyond, strict=True):
        near, far = (left, right) if offset >= 0 else (right, left)
        if beyond and math.isinf(left):
            reach.append(-beyond)
            continue
        least = apart
        for angle, height in ((near, abs(offset)), (far, -abs(offset))):
            if angle < math.pi:
                least = max(least, (apart + height * math.cos(angle / 2)) / math.sin(angle / 2))
        reach.append(least)
    return reach[0], crease.length - reach[1]


def crease_lines(
    points: Array, edges: Indices, chosen: Sequence[int], others: Sequence[int]
) -> Mapping[int, CreaseLine]:
    """Return the creases of a flat sheet with the angles between them.

    Args:
        points: points of its vertices, m, (vertex, 2).
        edges: two vertices each, (edge, 2).
        chosen: indices of the edges that are creases.
        others: indices of edges that are cut; they count as neighbours, too.

    Returns:
        By index of the edge.
    """
    at: dict[int, list[tuple[float, int]]] = {}
    for edge in (*chosen, *others):
        for tail, head in (edges[edge], edges[edge][::-1]):
            x, y = points[head] - points[tail]
            at.setdefault(int(tail), []).append((math.atan2(y, x), edge))
    lines = {}
    for edge in chosen:
        ends = []
        for tail in edges[edge].tolist():
            own_angle = next(angle for angle, other in at[tail] if other == edge)
            away = [(angle - own_angle) % (2 * math.pi) for angle, other in at[tail] if other != edge]
            left, right = min(away, default=math.inf), 2 * math.pi - max(away, default=-math.inf)
            # seen from tail to head, left and right are exchanged at the head
            ends.append((left, right) if tail == edges[edge][0] else (right, left))
        lines[edge] = CreaseLine(tail=points[edges[edge][0]], head=points[edges[edge][1]], beside=(ends[0], ends[1]))
    return lines
