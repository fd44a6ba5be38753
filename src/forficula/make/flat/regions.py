"""Areas of a sheet: polygons with holes, in millimetres, in which the library that unites and offsets them is exact."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from manifold3d import CrossSection, FillRule, JoinType, OpType

from forficula.arrays import Array

# a manifold3d.CrossSection, which has no types; it rounds coordinates to 1e-8 of its unit
Region = Any

MILLIMETRES = 1e3
# corners are sharp up to this multiple of the offset, and flat beyond
_SHARPEST = 4.0
_ROUND = 64  # sides of a circle
_STRAIGHT = 1e-6  # mm, a corner this close to a straight line is removed


def region_of(loops: Iterable[Array]) -> Region:
    """Return the union of polygons.

    Args:
        loops: corners, m, (corner, 2) each; counterclockwise loops are filled, clockwise loops within them are holes.
    """
    return CrossSection([MILLIMETRES * loop for loop in loops], FillRule.Positive).simplify(_STRAIGHT)


def disc(place: Array, diameter: float) -> Array:
    """Return a circle as its circumscribed polygon, m, (corner, 2)."""
    angles = 2 * math.pi * np.arange(_ROUND) / _ROUND
    radius = diameter / 2 / math.cos(math.pi / _ROUND)
    return place + radius * np.column_stack([np.cos(angles), np.sin(angles)])


def loops_of(region: Region) -> list[Array]:
    """Return the outlines of a region, counterclockwise, and those of its holes, clockwise, m, (corner, 2) each.

    Each begins at its corner of smallest x, then y, and they are sorted by these corners. The same region gives the
    same list.
    """
    loops = []
    for loop in region.simplify(_STRAIGHT).to_polygons():
        first = min(range(len(loop)), key=lambda corner: tuple(loop[corner]))
        loops.append(np.roll(np.asarray(loop, dtype=np.float64), -first, axis=0) / MILLIMETRES)
    return sorted(loops, key=lambda loop: (loop_area(loop) < 0, *loop[0]))


def loop_area(loop: Array) -> float:
    """Return the area of a polygon, m^2, negative if it is clockwise (shoelace formula)."""
    x, y = loop.T
    return float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2)


def grown(region: Region, distance: float) -> Region:
    """Offset the outlines of a region outwards by a distance, m, which makes holes smaller; inwards if negative.

    Convex corners stay sharp, up to 4 times the distance.
    """
    if distance == 0:
        return region
    return region.offset(MILLIMETRES * distance, JoinType.Miter, _SHARPEST).simplify(_STRAIGHT)


def rounded(region: Region, distance: float) -> Region:
    """Offset a region by a distance, m, with round corners; erode it if negative."""
    if distance == 0:
        return region
    return region.offset(MILLIMETRES * distance, JoinType.Round, 2.0, _ROUND // 2).simplify(_STRAIGHT)


def united(regions: Sequence[Region]) -> Region:
    """Return the union of regions."""
    return CrossSection.batch_boolean(list(regions), OpType.Add) if regions else CrossSection()


def is_empty(region: Region) -> bool:
    """Return whether a region is empty."""
    return bool(region.is_empty())


def area_of(region: Region) -> float:
    """Return the area of a region, m^2."""
    return float(region.area()) / MILLIMETRES**2


def pieces_of(region: Region) -> list[Region]:
    """Return the connected parts of a region."""
    return list(region.decompose())


def sides_of(region: Region) -> Array:
    """Return the sides of all outlines and holes, m, (side, 2 ends, 2)."""
    loops = [np.stack([loop, np.roll(loop, -1, axis=0)], axis=1) for loop in loops_of(region)]
    return np.concatenate(loops) if loops else np.zeros((0, 2, 2))


def spans_within(sides: Array, start: Array, along: Array, least: float, most: float) -> list[tuple[float, float]]:
    """Return the intervals of a straight line within a region.

    Args:
        sides: sides of the region, m, (side, 2, 2).
        start: a point on the line, m, (2,).
        along: unit vector, (2,).
        least: beginning of the line, from `start`, m.
        most: end of the line, m.

    Returns:
        Beginnings and ends of the intervals, from `start`, m, rising.
    """
    away = sides - start
    beside = away[..., 1] * along[0] - away[..., 0] * along[1]
    # a corner on the line belongs to only one of its two sides
    crossed = away[(beside[:, 0] <= 0) != (beside[:, 1] <= 0)]
    height = beside[(beside[:, 0] <= 0) != (beside[:, 1] <= 0)]
    share = height[:, 0] / (height[:, 0] - height[:, 1])
    crossings = np.sort((crossed[:, 0] + share[:, None] * (crossed[:, 1] - crossed[:, 0])) @ along)
    spans = [(max(low, least), min(high, most)) for low, high in zip(crossings[::2], crossings[1::2], strict=True)]
    return [(float(low), float(high)) for low, high in spans if high > low]
