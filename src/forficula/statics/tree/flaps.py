"""Creases between flaps of bodies in a tree: their angles and energy by the angles of the joints.

A flap is a triangle that one body carries, so the angle of a crease depends on the directions of both bodies only. With
the unit normals m and n of the left and the right flap, the unit vectors e and f along the crease on both, and the
sides s = m x e and t = n x f, the angle is atan2(y, m . n) with y = (s . n - m . t) / sqrt(2 + 2 e . f). It is the
angle of `forficula.structure.flap_angles`.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.material.law.crease_law import CreaseLaw
from forficula.material.law.crease_turn import CreaseTurn, turn_expansion
from forficula.statics.tree.elements import Elements, Expansion, LinePiece, elements, stretched
from forficula.statics.tree.pose import Pose, Span, Tree, places_of, pose
from forficula.structure import Hinge, Structure, crease_law, crease_numbers

# sides of a piece: normal, across the crease and along it, of the left flap, then of the right one
_M, _S, _E, _N, _T, _F = (slice(3 * side, 3 * side + 3) for side in range(6))
_SIDES = np.kron(np.eye(2), np.concatenate([-np.ones((3, 1)), np.eye(3)], axis=1))
_UNIT = np.eye(3)
# number of the product (m . n, s . n - m . t, e . f), its factors, and its sign
_BILINEAR = ((0, _M, _N, 1.0), (1, _S, _N, 1.0), (1, _M, _T, -1.0), (2, _E, _F, 1.0))


@dataclass(frozen=True, kw_only=True)
class Flaps:
    """Creases between flaps of a structure.

    Attributes:
        laid: a piece of six directions for each crease.
        senses: of the creases, (crease,).
        middles: angles in the own senses in the middle between both stops, or 0 without two stops, rad, (crease,). The
            angle of a crease is within half a turn of its middle.
        law: of the springs, in the own senses; its numbers are (crease,).
    """

    laid: Elements
    senses: Array
    middles: Array
    law: CreaseLaw

    @property
    def sprung(self) -> bool:
        """Return whether a crease has a spring or a compliant stop."""
        return bool(np.any(self.law.stiffness) or np.any(self.law.stop_stiffness))


def flaps_of(structure: Structure, tree: Tree) -> Flaps | None:
    """Return the creases between flaps of a structure; None if there are none.

    Raises:
        InputError: several bodies carry a flap.
    """
    numbers = crease_numbers(structure)
    if not len(numbers):
        return None
    creases = [structure.hinges[number] for number in numbers]
    bodies, places = list[int](), list[Array]()
    for crease in creases:
        for first in (0, 3):
            body, directions = _directions(structure, crease, first)
            bodies += [body] * 4
            places += [np.zeros(3), *directions]
    pieces = [LinePiece(points=tuple(range(8 * place, 8 * place + 8)), sides=_SIDES) for place in range(len(creases))]
    return Flaps(
        laid=elements(tree, bodies, np.array(places), pieces),
        senses=np.array([float(crease.sense) for crease in creases]),
        middles=np.array(
            [
                (crease.lower + crease.upper) / 2 if np.isfinite([crease.lower, crease.upper]).all() else 0.0
                for crease in creases
            ]
        ),
        law=crease_law(structure, numbers, rigid_stops=True),
    )


def _directions(structure: Structure, crease: Hinge, first: int) -> tuple[int, Array]:
    """Return the body of a flap, and its normal and the directions across and along the crease, (3, 3)."""
    assert crease.flaps is not None
    points = [structure.points[number] for number in crease.flaps[first : first + 3]]
    carriers = {point.body for point in points}
    if len(carriers) > 1:
        raise InputError(f"{structure.name}: need a crease whose flaps are on one body each, got {crease.name}")
    tail, head, corner = (point.place for point in points)
    along = (head - tail) / np.linalg.norm(head - tail)
    normal = np.cross(along, corner - tail) * (1.0 if first == 0 else -1.0)
    normal /= np.linalg.norm(normal)
    return carriers.pop(), np.array([normal, np.cross(normal, along), along])


def crease_angles(flaps: Flaps, angles: Array) -> Array:
    """Compute the angles of the creases in their own senses, rad, (case, crease).

    Args:
        flaps: of the structure.
        angles: of all joints, in their own senses, rad, (case, joint).
    """
    tree, carried = flaps.laid.tree, flaps.laid.carried
    places = np.moveaxis(places_of(carried, pose(tree, angles)), 0, -1).reshape(len(angles), -1, 8, 3)
    return _unwrapped(flaps.senses * _angle((_SIDES @ places).reshape(*places.shape[:2], 18)), flaps.middles)


def folded_energy(flaps: Flaps, angles: Array, further: Array) -> Array:
    """Compute the energy of the creases' springs, J, (case,).

    Args:
        flaps: of the structure.
        angles: of all joints, in their own senses, rad, (case, joint).
        further: changes of the rest angles, rad, (case, crease).
    """
    return np.asarray(flaps.law.energy(crease_angles(flaps, angles), further).sum(axis=1))


def crease_energy(
    flaps: Flaps, angles: Array, torques: Array | None = None, at: Pose | None = None, turn: CreaseTurn | None = None
) -> Expansion:
    """Compute the energy of the creases' springs, minus the work of torques on the creases.

    Args:
        flaps: of the structure.
        angles: of all joints, in their own senses, rad, (case, joint).
        torques: on the creases in their own senses, N m, (case, crease); None for none.
        at: pose of the tree at these angles; computed by default.
        turn: of the creases, (case, crease); None for creases without memory.

    Returns:
        Energy, J, (case,); gradient, N m, (case, joint), and Hessian, N m/rad, (case, joint, joint), by the angles.
    """
    acting = np.zeros((len(angles), len(flaps.senses))) if torques is None else torques
    laws = [partial(_folded, flaps, group.pieces, acting, turn) for group in flaps.laid.groups]
    return stretched(flaps.laid, angles, laws, at)


def _folded(flaps: Flaps, pieces: Span, torques: Array, turn: CreaseTurn | None, sides: Array) -> Expansion:
    """Compute the energy of some creases from their directions, (case, crease, 6, 3)."""
    senses, law = flaps.senses[pieces], flaps.law.some(np.arange(len(flaps.senses))[pieces])
    angle, slope, curvature = _angle_expansion(sides.reshape(*sides.shape[:2], 18))
    folded = _unwrapped(senses * angle, flaps.middles[pieces])
    if turn is not None:
        turn = replace(turn, memory=turn.memory[:, :, pieces], angle=turn.angle[:, pieces])
        stored, moment, stiffness = turn_expansion(law, folded, turn)
    else:
        stored, (moment, stiffness) = law.energy(folded), law.moment_and_slope(folded)
    acting = torques[:, pieces]
    energy = np.sum(stored - acting * folded, axis=1)
    along = senses * (moment - acting)
    hessian = stiffness[..., None, None] * slope[..., :, None] * slope[..., None, :]
    hessian += along[..., None, None] * curvature
    return energy, (along[..., None] * slope).reshape(sides.shape), hessian[:, :, None]


def _unwrapped(angle: Array, middle: Array) -> Array:
    """Return angles within half a turn of their middles, rad."""
    return np.asarray(angle - 2 * np.pi * np.round((angle - middle) / (2 * np.pi)))


def _products(sides: Array) -> tuple[Array, Array, Array]:
    """Return m . n, s . n - m . t and e . f of directions, (..., 18), each (...)."""

    def product(one: slice, other: slice) -> Array:
        return np.asarray(np.einsum("...i,...i", sides[..., one], sides[..., other]))

    return product(_M, _N), product(_S, _N) - product(_M, _T), product(_E, _F)


def _angle(sides: Array) -> Array:
    upright, across, along = _products(sides)
    return np.asarray(np.arctan2(across / np.sqrt(2 + 2 * along), upright))


def _angle_expansion(sides: Array) -> Expansion:
    """Compute angles between flaps, rad, (...), with gradient, (..., 18), and Hessian by their directions, (..., 18).

    The angle depends on three products of directions, whose Hessians are constant.
    """
    c, y, z = _products(sides)
    square = 2 + 2 * z
    root = np.sqrt(square)
    s = y / root
    both = s**2 + c**2
    by_c, by_s = -s / both, c / both
    cc, cs = 2 * s * c / both**2, (s**2 - c**2) / both**2
    s_y, s_z = 1 / root, -s / square
    first = (by_c, by_s * s_y, by_s * s_z)
    second = (
        (cc, cs * s_y, cs * s_z),
        (cs * s_y, -cc * s_y**2, -cc * s_y * s_z - by_s / (square * root)),
        (cs * s_z, -cc * s_y * s_z - by_s / (square * root), -cc * s_z**2 + 3 * by_s * s / square**2),
    )
    slopes = np.zeros((3, *sides.shape))
    for product, one, other, sign in _BILINEAR:
        slopes[product][..., one] += sign * sides[..., other]
        slopes[product][..., other] += sign * sides[..., one]
    slope = sum(first[product][..., None] * slopes[product] for product in range(3))
    curvature = np.zeros((*sides.shape, 18))
    for product, one, other, sign in _BILINEAR:
        block = sign * first[product][..., None, None] * _UNIT
        curvature[..., one, other] += block
        curvature[..., other, one] += block
    for factors, rising in zip(second, slopes, strict=True):
        for factor, other_rising in zip(factors, slopes, strict=True):
            curvature += factor[..., None, None] * rising[..., :, None] * other_rising[..., None, :]
    return np.arctan2(s, c), np.asarray(slope), curvature
