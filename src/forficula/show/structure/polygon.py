"""Flat polygons in space."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from forficula.arrays import Array


def area_vector(corners: Array) -> Array:
    """The normal of a polygon, as long as its area, m^2, (axis,), of its corners, m, (corner, axis)."""
    return np.asarray(sum(np.cross(one, other) for one, other in pairwise([*corners, corners[0]])) / 2)


def is_convex(corners: Array) -> bool:
    """Whether no corner of a polygon, m, (corner, axis), points inwards."""
    normal = area_vector(corners)
    sides = np.roll(corners, -1, axis=0) - corners
    return bool((np.cross(sides, np.roll(sides, -1, axis=0)) @ normal >= 0).all())


def triangles_of(corners: Array) -> list[tuple[int, ...]]:
    """Cut a flat polygon without crossings into pieces of three or four corners, by cutting off ears.

    Args:
        corners: m, (corner, axis).

    Returns:
        Numbers of the corners of each piece, counterclockwise seen from above, or in the order given where it stands
        upright. A convex polygon of four corners is one piece.
    """
    left = list(range(len(corners)))
    normal = area_vector(corners)
    if normal[2] < 0:
        left, normal = left[::-1], -normal
    if len(left) == 4 and is_convex(corners):
        return [tuple(left)]
    pieces: list[tuple[int, ...]] = []
    while len(left) > 3:
        ear = next((place for place in range(len(left)) if _is_ear(corners, left, place, normal)), 0)
        pieces.append((left[ear - 1], left[ear], left[(ear + 1) % len(left)]))
        del left[ear]
    return [*pieces, tuple(left)]


def _is_ear(corners: Array, left: list[int], place: int, normal: Array) -> bool:
    """Whether the triangle at a corner lies inside what is left of a polygon."""
    around = left[place - 1], left[place], left[(place + 1) % len(left)]
    before, here, after = corners[list(around)]
    if np.cross(here - before, after - here) @ normal <= 0:
        return False
    sides = ((before, here), (here, after), (after, before))
    others = [corners[other] for other in left if other not in around]
    return not any(all(np.cross(end - start, other - start) @ normal > 0 for start, end in sides) for other in others)
