"""How the angle between two plates depends on their directions: slopes in closed form, wherever the plates are."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from forficula.arrays import Array
from forficula.pattern.geometry import cross, dot

# products of a direction of the left plate and one of the right: normals 0, what is square to them and to the crease 1,
# along the crease 2; the angle depends on all but the third
PRODUCTS = ((0, 0), (1, 0), (2, 0), (0, 1), (2, 2))


class PlateAngles(NamedTuple):
    """The angles between plates, and what they depend on, coordinates first.

    Attributes:
        angles: rad, (...).
        values: of `PRODUCTS`, (5, ...).
        slopes: of the angle by these, (5, ...).
        turning: of the angle by a turn of the right plate against the left one, (3, ...).
    """

    angles: Array
    values: Array
    slopes: Array
    turning: Array


def plate_angles(corners: Array) -> PlateAngles:
    """Take apart the angles of `flap_angles`.

    With the normals m and n of the left and the right plate, the sides s = m x e and t = n x f, and the directions e
    and f of the crease on both, the angle is atan2(y, m . n) with y = (s . n - m . t) / sqrt(2 + 2 e . f): a product d
    . d' of directions grows by w . (d' x d) as the right plate turns by w against the left one.

    Args:
        corners: of the flaps, (..., 6, 3).
    """
    tail, head, left, right_tail, right_head, right = np.moveaxis(corners, (-2, -1), (0, 1))
    own = plate_directions(head - tail, cross(head - tail, left - tail))
    other = plate_directions(right_head - right_tail, cross(right - right_tail, right_head - right_tail))
    values = np.stack([dot(own[one], other[two]) for one, two in PRODUCTS])
    upright, side, _, opposite, along = values
    square = 2 + 2 * along
    sine = (side - opposite) / np.sqrt(square)
    by_sine, by_cosine = (each / (sine**2 + upright**2) for each in (upright, -sine))
    unit = by_sine / np.sqrt(square)
    slopes = np.stack([by_cosine, unit, np.zeros_like(unit), -unit, -by_sine * sine / square])
    turns = np.stack([cross(other[two], own[one]) for one, two in PRODUCTS])
    turning = np.einsum("p...,px...->x...", slopes, turns)
    return PlateAngles(np.arctan2(sine, upright), values, slopes, turning)


def plate_directions(along: Array, normal: Array) -> tuple[Array, Array, Array]:
    """Normal, what is square to it and to the crease, and along the crease, unit vectors, coordinates first."""
    along, normal = (each / np.sqrt(dot(each, each)) for each in (along, normal))
    return normal, cross(normal, along), along
