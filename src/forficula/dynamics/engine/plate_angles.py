"""Angle between two plates as a function of their directions, with derivatives in closed form for any pose."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from forficula.arrays import Array
from forficula.pattern.geometry import cross, dot

# products of a direction of the left plate and one of the right plate: 0 is the normal, 1 is perpendicular to normal
# and crease, 2 is along the crease; the angle depends on all products but the third
PRODUCTS = ((0, 0), (1, 0), (2, 0), (0, 1), (2, 2))


class PlateAngles(NamedTuple):
    """Angles between plates with their derivatives, coordinates first.

    Attributes:
        angles: rad, (...).
        values: of `PRODUCTS`, (5, ...).
        slopes: derivatives of the angle by these products, (5, ...).
        turning: derivative of the angle by a turn of the right plate relative to the left one, (3, ...).
    """

    angles: Array
    values: Array
    slopes: Array
    turning: Array


def plate_angles(corners: Array) -> PlateAngles:
    """Compute the angles of `flap_angles` with their derivatives.

    With the normals m and n of the left and the right plate, the sides s = m x e and t = n x f, and the directions e
    and f of the crease on both, the angle is atan2(y, m . n) with y = (s . n - m . t) / sqrt(2 + 2 e . f). A product
    d . d' of directions changes by w . (d' x d) as the right plate turns by w relative to the left one.

    Args:
        corners: of the flaps, (..., 6, 3).
    """
    tail, head, left, right_tail, right_head, right = np.moveaxis(corners, (-2, -1), (0, 1))
    on_left = plate_directions(head - tail, cross(head - tail, left - tail))
    on_right = plate_directions(right_head - right_tail, cross(right - right_tail, right_head - right_tail))
    values = np.stack([dot(on_left[one], on_right[two]) for one, two in PRODUCTS])
    upright, side, _, opposite, along = values
    square = 2 + 2 * along
    sine = (side - opposite) / np.sqrt(square)
    by_sine, by_cosine = (part / (sine**2 + upright**2) for part in (upright, -sine))
    unit = by_sine / np.sqrt(square)
    slopes = np.stack([by_cosine, unit, np.zeros_like(unit), -unit, -by_sine * sine / square])
    turns = np.stack([cross(on_right[two], on_left[one]) for one, two in PRODUCTS])
    turning = np.einsum("p...,px...->x...", slopes, turns)
    return PlateAngles(np.arctan2(sine, upright), values, slopes, turning)


def plate_directions(along: Array, normal: Array) -> tuple[Array, Array, Array]:
    """Return unit vectors: the normal, perpendicular to normal and crease, along the crease; coordinates first."""
    along, normal = (vector / np.sqrt(dot(vector, vector)) for vector in (along, normal))
    return normal, cross(normal, along), along
