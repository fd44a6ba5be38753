"""Closure of the panels around one vertex, for any number of creases and any sum of sectors."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from forficula.arrays import Array
from forficula.errors import InputError

_REACHABLE = 1e-12  # rounding allowed in the squared sine or cosine of half a fold angle


def vertex_freedoms(creases: int) -> int:
    """Return how many fold angles of a vertex are free: its creases minus the three equations of `vertex_walk`.

    This holds if the creases do not all lie in one plane (Belcastro and Hull 2002; Tachi 2009); in the flat state there
    are only two equations at first order.

    Returns:
        creases - 3, 0 for three creases or fewer.
    """
    return max(creases - 3, 0)


def vertex_walk(sectors: ArrayLike, fold_angles: ArrayLike) -> tuple[Array, Array]:
    """Multiply the rotations once around vertices: by every fold angle about its crease and by every sector.

    The panels meet if the product of all Rx(fold angle) Rz(sector) is the identity (Kawasaki 1989; Belcastro and Hull
    2002). This holds for any vertex, also one with an angle deficit.

    Args:
        sectors: sector angles, rad, shape (..., degree); number i lies between creases i and i + 1.
        fold_angles: fold angles, rad, shape (..., degree).

    Returns:
        The product, shape (..., 3, 3), and the direction of every crease, shape (..., degree, 3). Where the product is
        the identity, small changes of the fold angles rotate it by the sum of direction times change over the creases.

    Raises:
        InputError: the shapes differ, or a vertex has no crease.
    """
    turns, folds = np.asarray(sectors, dtype=np.float64), np.asarray(fold_angles, dtype=np.float64)
    if turns.ndim < 1 or turns.shape != folds.shape or turns.shape[-1] == 0:
        raise InputError(f"fold_angles: need one for each sector, got shapes {folds.shape} and {turns.shape}")
    product = np.broadcast_to(np.eye(3), (*turns.shape[:-1], 3, 3))
    creases = np.empty((*turns.shape, 3))
    for place in range(turns.shape[-1]):
        creases[..., place, :] = product[..., :, 0]
        product = product @ _rotations(folds[..., place], 0) @ _rotations(turns[..., place], 2)
    return product, creases


def _rotations(angles: Array, axis: int) -> Array:
    """Return the rotations about a coordinate axis, shape (..., 3, 3)."""
    one, other = (axis + 1) % 3, (axis + 2) % 3
    turns = np.zeros((*angles.shape, 3, 3))
    turns[..., axis, axis] = 1.0
    turns[..., one, one] = turns[..., other, other] = np.cos(angles)
    turns[..., other, one] = np.sin(angles)
    turns[..., one, other] = -turns[..., other, one]
    return turns


def degree4_closure(sectors: ArrayLike, fold_angle: ArrayLike) -> Array:
    """Compute the fold angles of a vertex of four creases from one of them, as for a spherical four-bar linkage.

    The panels on both sides of creases 2 and 4 span the same angle between these creases, which gives the size of fold
    angle 3 (spherical law of cosines; Huffman 1976; Izmestiev 2017). The code uses half angles, which are exact at 0
    and 180 deg. The panel angles that add up to folds 2 and 4 are those of the spherical triangles on both sides
    (Napier's analogies).

    Args:
        sectors: angles between creases 1 and 2, 2 and 3, 3 and 4, 4 and 1, rad, shape (4,), with any sum.
        fold_angle: fold angle of crease 1, from -pi to pi, rad, any shape.

    Returns:
        Fold angles of creases 1 to 4 in both solutions, rad, shape (2, 4, ...): first the one in which crease 3 is a
        valley, then the one in which it is a mountain. nan where the panels do not close. Where creases 2 and 4 are in
        line or coincide and the others do not fold, folds 2 and 4 are not unique; the result is one pair that closes.

    Raises:
        InputError: not four sectors between 0 and 180 deg, or a fold angle outside -180 to 180 deg.
    """
    turns, first = np.asarray(sectors, dtype=np.float64), np.asarray(fold_angle, dtype=np.float64)
    if turns.shape != (4,) or not ((turns > 0) & (turns < math.pi)).all():
        shown = ", ".join(f"{angle:.6g}" for angle in np.degrees(turns).ravel().tolist())
        raise InputError(f"sectors: need four, each > 0 deg and < 180 deg, got {shown} deg")
    inside = np.abs(first) <= math.pi
    if not inside.all():
        worst = float(first[~inside].flat[0])
        raise InputError(f"fold_angle: need -180 to 180 deg, got {math.degrees(worst):.6g} deg")
    third = _opposite(turns, first)
    solutions = []
    for opposite in (third, -third):
        near, far = _panel_angles(turns[0], turns[3], first), _panel_angles(turns[1], turns[2], opposite)
        second, fourth = (_wrapped(math.pi - one - other) for one, other in zip(near, far, strict=True))
        solutions.append(np.stack([first, second, opposite, fourth]))
    return np.stack(solutions)


def _opposite(sectors: Array, fold: Array) -> Array:
    """Return the size of the fold angle of the opposite crease, rad; nan where the panels do not close."""
    one, two, three, four = sectors.tolist()
    near, far = math.sin(one) * math.sin(four), math.sin(two) * math.sin(three)
    excess = math.sin((one + two + three + four) / 2) * math.sin((two + three - one - four) / 2)
    skew = math.sin((two - three + one - four) / 2) * math.sin((one - four - two + three) / 2)
    sine = (near * np.sin(fold / 2) ** 2 + excess) / far
    cosine = (near * np.cos(fold / 2) ** 2 + skew) / far
    reached = (sine >= -_REACHABLE) & (cosine >= -_REACHABLE)
    size = 2 * np.arctan2(np.sqrt(np.maximum(sine, 0)), np.sqrt(np.maximum(cosine, 0)))
    return np.where(reached, size, np.nan)


def _panel_angles(left: float, right: float, fold: Array) -> tuple[Array, Array]:
    """Return the angles, rad, between two panels and the arc across them, at the far ends of the left and right panel.

    They are angles of the spherical triangle whose sides are the sectors and whose angle between them is 180 deg minus
    the fold angle.
    """
    sine, cosine = np.sin(fold / 2), np.cos(fold / 2)
    mean = np.arctan2(math.cos((left - right) / 2) * sine, math.cos((left + right) / 2) * cosine)
    half = np.arctan2(math.sin((right - left) / 2) * sine, math.sin((left + right) / 2) * cosine)
    return mean + half, mean - half


def _wrapped(angles: Array) -> Array:
    """Return the same angles in the range -pi to pi."""
    return np.asarray(np.remainder(angles + math.pi, 2 * math.pi) - math.pi)
