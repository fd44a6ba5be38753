"""How the panels around one vertex meet: any number of creases, sectors adding up to 360 deg or not."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from forficula.arrays import Array
from forficula.errors import InputError

_REACHABLE = 1e-12  # rounding allowed in the squared sine or cosine of half a fold angle


def vertex_freedoms(creases: int) -> int:
    """How many fold angles of a vertex may be chosen: its creases less the three equations of `vertex_walk`.

    True wherever the creases do not all lie in one plane (Belcastro and Hull 2002; Tachi 2009); in the flat state the
    equations are only two at first order.

    Returns:
        creases - 3, none of three creases or fewer.
    """
    return max(creases - 3, 0)


def vertex_walk(sectors: ArrayLike, fold_angles: ArrayLike) -> tuple[Array, Array]:
    """Walk once around vertices, turning by every fold angle about its crease and by every sector in its panel.

    The panels meet where the walk leads back to its start: the product of all Rx(fold angle) Rz(sector) is then the
    identity (Kawasaki 1989; Belcastro and Hull 2002), for any vertex, one with an angle deficit too.

    Args:
        sectors: rad, shape (..., degree); number i lies between creases i and i + 1.
        fold_angles: rad, shape (..., degree).

    Returns:
        The product, shape (..., 3, 3), and the direction of every crease as the walk comes to it, shape (..., degree,
        3). Where the product is the identity, a small change of the fold angles turns it by the sum of the directions,
        each times its change.

    Raises:
        InputError: shapes that differ, or none of a vertex.
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
    """Turns about a coordinate axis, shape (..., 3, 3)."""
    one, other = (axis + 1) % 3, (axis + 2) % 3
    turns = np.zeros((*angles.shape, 3, 3))
    turns[..., axis, axis] = 1.0
    turns[..., one, one] = turns[..., other, other] = np.cos(angles)
    turns[..., other, one] = np.sin(angles)
    turns[..., one, other] = -turns[..., other, one]
    return turns


def degree4_closure(sectors: ArrayLike, fold_angle: ArrayLike) -> Array:
    """Fold any vertex of four creases by one of them: a spherical linkage of four bars.

    The panels on either side of creases 2 and 4 span the same angle between these, which gives the size of fold angle 3
    (spherical law of cosines; Huffman 1976; Izmestiev 2017), here with half angles, which keep all digits at 0 and 180
    deg. The panel angles that make up folds 2 and 4 are those of the spherical triangles on either side (Napier's
    analogies).

    Args:
        sectors: between creases 1 and 2, 2 and 3, 3 and 4, 4 and 1, rad, shape (4,), adding up to 360 deg or not.
        fold_angle: of crease 1, from -pi to pi, rad, any shape.

    Returns:
        rad, shape (2, 4, ...): of both ways to fold, the fold angles of creases 1 to 4; first the way in which crease 3
        is a valley, then that in which it is a mountain. nan where the panels do not reach around. Where creases 2 and
        4 are in line or fall together and the others lie still, folds 2 and 4 are free: one choice that closes.

    Raises:
        InputError: not four sectors of more than 0 and less than 180 deg, or a fold angle outside -180 to 180 deg.
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
    ways = []
    for opposite in (third, -third):
        near, far = _panel_angles(turns[0], turns[3], first), _panel_angles(turns[1], turns[2], opposite)
        second, fourth = (_wrapped(math.pi - one - other) for one, other in zip(near, far, strict=True))
        ways.append(np.stack([first, second, opposite, fourth]))
    return np.stack(ways)


def _opposite(sectors: Array, fold: Array) -> Array:
    """Size of the fold angle opposite to a given one, rad, nan out of reach."""
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
    """Angles, rad, between two panels and the arc that spans them, at the far side of the left one and of the right.

    Of the triangle whose sides are the sectors and whose angle between them is 180 deg less the fold angle.
    """
    sine, cosine = np.sin(fold / 2), np.cos(fold / 2)
    mean = np.arctan2(math.cos((left - right) / 2) * sine, math.cos((left + right) / 2) * cosine)
    half = np.arctan2(math.sin((right - left) / 2) * sine, math.sin((left + right) / 2) * cosine)
    return mean + half, mean - half


def _wrapped(angles: Array) -> Array:
    """The same angles from -pi to pi."""
    return np.asarray(np.remainder(angles + math.pi, 2 * math.pi) - math.pi)
