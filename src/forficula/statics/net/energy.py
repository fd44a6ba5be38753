"""Energy of a net, its gradient (slope) and its Hessian (curvature)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import bsr_array, csc_array

from forficula.arrays import Array
from forficula.statics.net.layout import Layout, layout_of
from forficula.statics.net.load import Load
from forficula.statics.net.net import Net, NetShape, Triangles

# energy, gradient by side, Hessian by pair of sides
Piece = tuple[float, Array, Array]

_SHORTEST = 1e-12  # of the net's size; a shorter side has no direction


@dataclass(frozen=True, kw_only=True, eq=False)
class Expansion:
    """Second-order expansion of the potential of a net about a shape.

    Attributes:
        shape: point of the expansion.
        stored: stored energy, including that of the weight (0 at z = 0), J.
        energy: stored energy minus the work of the load from the shape as built, J.
        slope: gradient of the potential by the nodes' coordinates, N, (node, 3); for held coordinates, the forces that
            supports exert.
        curvature: Hessian by all coordinates, N/m.
        free: Hessian by the free coordinates, N/m.
    """

    shape: NetShape
    stored: float
    energy: float
    slope: Array
    curvature: bsr_array
    free: csc_array


def shape_at(net: Net, positions: Array, near: Array | None = None) -> NetShape:
    """Return the shape of a net with nodes at given positions.

    Args:
        net: the net.
        positions: m, (node, 3).
        near: reference angles, rad, (crease,); None for 0. The angle of a crease is chosen within half a turn of its
            reference.
    """
    near = np.zeros(len(net.creases.points)) if near is None else near
    return NetShape(positions=positions, angles=fold_angles(sides_of(net, positions)[2], near))


def built_shape(net: Net) -> NetShape:
    """Return the shape as built."""
    return shape_at(net, net.nodes)


def expand(net: Net, shape: NetShape, load: Load | None = None, factor: float = 0.0) -> Expansion:
    """Compute energy, gradient and sparse Hessian of the potential in closed form, for all elements at once.

    Args:
        net: the net with its laws.
        shape: any shape.
        load: acting load; None for none.
        factor: of the load.
    """
    layout = layout_of(net)
    springs, tendons, creases, triangles = sides_of(net, shape.positions)
    shortest = _SHORTEST * net.size
    pieces = [_bars(net, springs, shortest), _pulls(net, tendons, shortest)]
    torques = None if load is None else factor * load.torques
    pieces.append(_folds(net, creases, shape.angles, torques))
    if net.membranes is not None:
        pieces.append(_stretched(net.membranes, triangles))
    stored = sum(piece[0] for piece in pieces) - float(np.sum(layout.weight * shape.positions))
    slope = layout.on_nodes @ np.concatenate([piece[1].reshape(-1, 3) for piece in pieces]) - layout.weight
    energy = stored
    if load is not None:
        slope = slope - factor * load.forces
        energy = stored - factor * _work(net, shape, load)
    whole = layout.whole(np.concatenate([piece[2].reshape(-1, 3, 3) for piece in pieces]))
    return Expansion(
        shape=shape, stored=stored, energy=energy, slope=slope, curvature=whole, free=layout.free_part(whole)
    )


def stored_by_part(net: Net, shape: NetShape, further: Array | float = 0.0) -> tuple[float, Array, float, float, float]:
    """Return energies, J: of bars, of each crease, (crease,), of tendons, of membranes, of the weight (0 at z = 0).

    Args:
        net: the net with its laws.
        shape: any shape.
        further: changes of the rest angles of valleys, rad, (crease,).
    """
    springs, tendons, _, triangles = sides_of(net, shape.positions)
    shortest = _SHORTEST * net.size
    return (
        _bars(net, springs, shortest)[0],
        np.asarray(net.creases.law.energy(shape.angles, further)),
        _pulls(net, tendons, shortest)[0],
        0.0 if net.membranes is None else _stretched(net.membranes, triangles)[0],
        -float(np.sum(layout_of(net).weight * shape.positions)),
    )


def angle_slopes(net: Net, shape: NetShape) -> tuple[Array, Layout]:
    """Return gradients of the creases' angles by their sides, 1/m, (crease, 3, 3), and the layout of the sides."""
    return fold_angle_slopes(sides_of(net, shape.positions)[2]), layout_of(net)


def load_slope(net: Net, shape: NetShape, load: Load) -> Array:
    """Return the forces on the nodes from forces and torques of a load in a shape, N, (node, 3)."""
    if not load.torques.any():
        return load.forces + 0.0  # the sum has no negative zeros
    slopes, layout = angle_slopes(net, shape)
    springs, tendons, creases, _ = layout.counts
    sides = np.zeros((layout.sides.shape[0], 3))
    begin = springs + tendons
    sides[begin : begin + 3 * creases] = (load.torques[:, None, None] * slopes).reshape(-1, 3)
    return np.asarray(layout.on_nodes @ sides + load.forces)


def sides_of(net: Net, positions: Array) -> tuple[Array, Array, Array, Array]:
    """Return sides of springs and tendons, m, (side, 3), of creases, (crease, 3, 3), triangles, (triangle, 2, 3)."""
    layout = layout_of(net)
    springs, tendons, creases, _ = layout.counts
    sides = layout.sides @ positions
    bent = springs + tendons
    flat = bent + 3 * creases
    return (
        sides[:springs],
        sides[springs:bent],
        sides[bent:flat].reshape(-1, 3, 3),
        sides[flat:].reshape(-1, 2, 3),
    )


def _work(net: Net, shape: NetShape, load: Load) -> float:
    return float(np.sum(load.forces * (shape.positions - net.nodes)) + load.torques @ shape.angles)


def _length(sides: Array) -> Array:
    return np.asarray(np.linalg.norm(sides, axis=-1))


def _bars(net: Net, sides: Array, shortest: float) -> Piece:
    stiffness, rest_length = net.springs.stiffness, net.springs.rest_length
    apart = _length(sides)
    length, rise = np.maximum(apart, shortest), apart - rest_length
    # the Hessian of a pull F at a length L along n is F' n n^T + F / L (1 - n n^T)
    per_length = np.where(rest_length > 0, stiffness * rise / length, stiffness)
    blocks = _stretch_hessian(sides / length[:, None], stiffness, per_length)
    return float(stiffness @ rise**2) / 2, per_length[:, None] * sides, blocks


def _pulls(net: Net, sides: Array, shortest: float) -> Piece:
    length = _length(sides)
    energy, force, stiffness = net.tendons.law.expansion(length)
    known = np.maximum(length, shortest)
    per_length = force / known
    return (
        float(np.sum(energy)),
        per_length[:, None] * sides,
        _stretch_hessian(sides / known[:, None], stiffness, per_length),
    )


def _stretch_hessian(unit: Array, stiffness: Array, per_length: Array) -> Array:
    outer = unit[:, :, None] * unit[:, None, :]
    return np.asarray((stiffness - per_length)[:, None, None] * outer + per_length[:, None, None] * np.eye(3))


def _folds(net: Net, sides: Array, angles: Array, torques: Array | None) -> Piece:
    law = net.creases.law
    slope, curvature = fold_angle_derivatives(sides)
    moment, stiffness = law.moment_and_slope(angles)
    acting = moment if torques is None else moment - torques
    blocks = acting[:, None, None, None, None] * curvature
    rising = stiffness[:, None, None] * slope
    blocks += rising[:, :, None, :, None] * slope[:, None, :, None, :]
    return float(np.sum(law.energy(angles))), acting[:, None, None] * slope, blocks


def membrane_stresses(net: Net, shape: NetShape) -> Array:
    """Compute principal second Piola-Kirchhoff stresses of the membranes, the larger first, Pa, (triangle, 2)."""
    if net.membranes is None:
        return np.zeros((0, 2))
    plane, area = _flat(net.membranes.built)
    stress = _membrane_stress(net.membranes, sides_of(net, shape.positions)[3], plane, area)[3]
    volume = (area * net.membranes.thickness)[:, None]
    return np.asarray(np.linalg.eigvalsh(stress)[:, ::-1] / volume)


def _membrane_stress(
    membranes: Triangles, sides: Array, shape: Array, area: Array
) -> tuple[Array, Array, Array, Array]:
    """Return stiffness, N m, deformation gradient, (triangle, 3, 2), strain and stress x volume, (triangle, 2, 2)."""
    modulus, ratio = np.broadcast_arrays(membranes.youngs_modulus, membranes.poisson_ratio, np.empty(len(area)))[:2]
    stiff = (modulus / (1 - ratio**2) * area * membranes.thickness)[:, None, None]
    ratio = ratio[:, None, None]
    gradient = np.einsum("tsx,tsm->txm", sides, shape)
    strain = (np.einsum("txm,txn->tmn", gradient, gradient) - np.eye(2)) / 2
    trace = np.trace(strain, axis1=1, axis2=2)[:, None, None]
    return stiff, gradient, strain, stiff * ((1 - ratio) * strain + ratio * trace * np.eye(2))


def _stretched(membranes: Triangles, sides: Array) -> Piece:
    """Return the piece of triangles of a St Venant-Kirchhoff material (e.g. Bonet and Wood 2008, section 6.5)."""
    shape, area = _flat(membranes.built)
    stiff, gradient, strain, stress = _membrane_stress(membranes, sides, shape, area)
    ratio = np.broadcast_to(membranes.poisson_ratio, len(area))[:, None, None]
    energy = float(np.sum(stress * strain)) / 2
    slope = np.einsum("txm,tmn,tsn->tsx", gradient, stress, shape)
    # Hessian by sides: material part from the change of stress with strain, geometric part from the stress
    turned = np.einsum("txm,tsm->tsx", gradient, shape)
    inner = np.einsum("tsm,trm->tsr", shape, shape)
    outer = np.einsum("txm,tym->txy", gradient, gradient)
    linear = (1 - ratio[..., None, None]) / 2 * (
        np.einsum("tsy,trx->tsrxy", turned, turned) + inner[:, :, :, None, None] * outer[:, None, None]
    ) + ratio[..., None, None] * np.einsum("tsx,try->tsrxy", turned, turned)
    geometric = np.einsum("tsm,tmn,trn->tsr", shape, stress, shape)[..., None, None] * np.eye(3)
    return energy, slope, stiff[..., None, None] * linear + geometric


def _flat(built: Array) -> tuple[Array, Array]:
    """Return the matrices that turn sides into deformation gradients, 1/m, (triangle, side, 2), and areas, m^2."""
    first, second = built[:, 1] - built[:, 0], built[:, 2] - built[:, 0]
    normal = np.cross(first, second)
    doubled = np.linalg.norm(normal, axis=1)
    length = np.linalg.norm(first, axis=1)
    along = np.einsum("ti,ti->t", first, second) / length
    # the inverse of ((length, along), (0, doubled / length)), whose columns are the sides in their plane
    shape = np.zeros((len(built), 2, 2))
    shape[:, 0, 0] = 1 / length
    shape[:, 0, 1] = -along / doubled
    shape[:, 1, 1] = length / doubled
    return shape, doubled / 2


def fold_angles(sides: Array, near: Array) -> Array:
    """Compute fold angles: 0 flat, valleys positive, without a jump at +-pi.

    Args:
        sides: vectors from tail to head, from the tail to the left corner, and to the right corner, m, (crease, 3, 3):
            side by side. For an open crease, the first is the mean of the vectors of its two panels.
        near: reference angles, rad, (crease,): each result is within pi of its reference.

    Returns:
        Angles, rad, (crease,).
    """
    along, left, right = np.moveaxis(sides, 1, 0)
    left_normal, right_normal = _cross(along, left), _cross(along, right)
    sine = _dot(along, _cross(left_normal, right_normal)) / np.linalg.norm(along, axis=1)
    angles = np.arctan2(sine, -_dot(left_normal, right_normal))
    return np.asarray(angles + 2 * np.pi * np.round((near - angles) / (2 * np.pi)))


def fold_angle_derivatives(sides: Array) -> tuple[Array, Array]:
    """Compute gradient and Hessian of fold angles by their sides.

    With e along the crease, u to a corner at the height h above it, n the unit normal of its panel and t = n x e / |e|,
    the gradient by u is n / h. The gradients by e follow from invariance under rotation and sliding (Bridson, Marino
    and Fedkiw 2003, doi 10.2312/SCA03/028-036; Hessian as in Tamstorf and Grinspun 2013,
    doi 10.1016/j.gmod.2013.07.001, here by sides instead of corners). No angle is singular.

    Args:
        sides: as for `fold_angles`, (crease, 3, 3).

    Returns:
        Gradient by side, 1/m, (crease, 3, 3), and Hessian by pairs of sides, then by their coordinates, 1/m^2,
        (crease, 3, 3, 3, 3).
    """
    count = len(sides)
    slope = np.zeros_like(sides)
    curvature = np.zeros((count, 3, 3, 3, 3))
    length = np.linalg.norm(sides[:, 0], axis=1)
    along = sides[:, 0] / length[:, None]
    # all left corners, then all right corners, which have opposite signs
    corner, twice, length = np.concatenate([sides[:, 1], sides[:, 2]]), np.tile(along, (2, 1)), np.tile(length, 2)
    normal = _cross(twice, corner)
    height = np.linalg.norm(normal, axis=1)
    normal = normal / height[:, None]
    across = _cross(normal, twice)
    share = _dot(corner, twice) / length
    mixed = _outer_product(normal, across)
    mixed = mixed + np.swapaxes(mixed, 1, 2)
    lifted = _outer_product(twice, normal)
    bent = -mixed / (height**2)[:, None, None]
    tilted = -share[:, None, None] * bent - lifted / (length * height)[:, None, None]
    by_corner, by_along = normal / height[:, None], (share / height)[:, None] * normal
    both = (lifted + np.swapaxes(lifted, 1, 2)) * (share / (height * length))[:, None, None]
    twisted = (share**2)[:, None, None] * bent + both - mixed / (2 * length**2)[:, None, None]
    for side, sign, rows in ((1, 1.0, slice(None, count)), (2, -1.0, slice(count, None))):
        slope[:, side] = sign * by_corner[rows]
        slope[:, 0] -= sign * by_along[rows]
        curvature[:, side, side] = sign * bent[rows]
        curvature[:, side, 0] = sign * tilted[rows]
        curvature[:, 0, side] = sign * np.swapaxes(tilted[rows], 1, 2)
        curvature[:, 0, 0] += sign * twisted[rows]
    return slope, curvature


def fold_angle_slopes(sides: Array) -> Array:
    """Compute the gradient of fold angles by their sides, 1/m, (crease, 3, 3), as `fold_angle_derivatives` does."""
    slope, length = np.zeros_like(sides), np.linalg.norm(sides[:, 0], axis=1)
    along = sides[:, 0] / length[:, None]
    for side, sign in ((1, 1.0), (2, -1.0)):
        normal = _cross(along, sides[:, side])
        by_corner = sign * normal / _dot(normal, normal)[:, None]
        slope[:, side] = by_corner
        slope[:, 0] -= (_dot(sides[:, side], along) / length)[:, None] * by_corner
    return slope


def _dot(a: Array, b: Array) -> Array:
    return np.asarray(np.einsum("ni,ni->n", a, b))


def _outer_product(a: Array, b: Array) -> Array:
    return a[:, :, None] * b[:, None, :]


def _cross(a: Array, b: Array) -> Array:
    (ax, ay, az), (bx, by, bz) = a.T, b.T
    crossed = np.empty((len(a), 3))
    crossed[:, 0], crossed[:, 1], crossed[:, 2] = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
    return crossed
