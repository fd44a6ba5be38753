"""Energy of a net, its gradient (slope) and its Hessian (curvature)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from scipy.sparse import bsr_array, csc_array

from forficula.arrays import Array
from forficula.material.law.crease_memory import start_memory, stored_energy
from forficula.material.law.crease_turn import CreaseTurn, memory_after, remembers, turn_expansion
from forficula.statics.net.contact.contact_energy import contact_terms
from forficula.statics.net.factor import Matrix
from forficula.statics.net.fold_angle import (
    CreaseFrames,
    add_curvature,
    angle_gradients,
    corner_shares,
    crease_frames,
    fold_angles,
    side_lengths,
    turned_angles,
)
from forficula.statics.net.layout import Layout, layout_of
from forficula.statics.net.load import Load
from forficula.statics.net.net import Net, NetShape, RigidForces, Triangles

# energy, gradient by side, (3, side), Hessian by pair of sides, (9, pair)
Piece = tuple[float, Array, Array]

_SHORTEST = 1e-12  # of the net's size; a shorter side has no direction


@dataclass(frozen=True, kw_only=True, eq=False)
class Expansion:
    """Second-order expansion of the potential of a net about a shape.

    Attributes:
        shape: point of the expansion.
        stored: stored energy, including that of the weight (0 at the origin), J.
        energy: stored energy minus the work of the load from the shape as built, J.
        slope: gradient of the potential by the nodes' coordinates, N, (node, 3); for held coordinates, the forces that
            supports exert.
        blocks: blocks of the Hessian by all coordinates, N/m, (block, 9).
        free: Hessian by the free coordinates, N/m.
        turning: gradient of the angles by the sides of their creases, 1/m, (3, side, crease).
        layout: of the net.
        pressed: Hessian of the contact by all coordinates, N/m; None if nothing touches.
    """

    shape: NetShape
    stored: float
    energy: float
    slope: Array
    blocks: Array
    free: Matrix
    turning: Array
    layout: Layout
    pressed: Matrix | None = None

    @cached_property
    def curvature(self) -> bsr_array:
        """Return the Hessian by all coordinates, N/m."""
        whole = self.layout.whole(self.blocks)
        return whole if self.pressed is None else bsr_array(whole + self.pressed)


def shape_at(net: Net, positions: Array, near: Array | None = None, turn: CreaseTurn | None = None) -> NetShape:
    """Return the shape of a net with nodes at given positions.

    Args:
        net: the net.
        positions: m, (node, 3).
        near: reference angles, rad, (crease,); None for 0. The angle of a crease is chosen within half a turn of its
            reference.
        turn: of the creases; None for new creases.
    """
    near = np.zeros(len(net.creases.points)) if near is None else near
    return NetShape(positions=positions, angles=fold_angles(sides_of(net, positions)[2], near), turn=turn)


def moved_shape(net: Net, shape: NetShape, positions: Array) -> NetShape:
    """Return the shape of a net that moves from a shape, with memory and contacts, to positions, m."""
    return replace(shape_at(net, positions, shape.angles, shape.turn), pressing=shape.pressing, rigid=shape.rigid)


def remembered(net: Net, shape: NetShape) -> NetShape:
    """Return the shape of a net after a motion in which each crease turned in one sense: with the memory at its end.

    Up to here the motion was computed with the memory at its beginning, and with moments that depend on the angle alone
    (see `crease_turn`).
    """
    if not remembers(net.creases.law):
        return shape
    return replace(shape, turn=CreaseTurn(memory=crease_memory(net, shape), angle=shape.angles))


def crease_memory(net: Net, shape: NetShape) -> Array:
    """Return the memory of the creases at the end of the motion to a shape, (slot, crease)."""
    law = net.creases.law
    return start_memory(law, shape.angles) if shape.turn is None else memory_after(law, shape.angles, shape.turn)


def built_shape(net: Net) -> NetShape:
    """Return the shape as built."""
    return shape_at(net, net.nodes)


def expand(net: Net, shape: NetShape, load: Load | None = None, factor: float = 0.0) -> Expansion:
    """Compute energy, gradient and Hessian of the potential in closed form, for all elements at once.

    Args:
        net: the net with its laws.
        shape: any shape.
        load: acting load; None for none.
        factor: of the load.
    """
    sides = sides_of(net, shape.positions)
    return _expanded(net, shape, sides, crease_frames(sides[2]), load, factor)


def expand_at(net: Net, positions: Array, near: NetShape, load: Load | None = None, factor: float = 0.0) -> Expansion:
    """Compute the expansion about a shape that is given as for `moved_shape`, in less time than both together."""
    sides = sides_of(net, positions)
    frames = crease_frames(sides[2])
    shape = replace(near, positions=positions, angles=turned_angles(frames, near.angles))
    return _expanded(net, shape, sides, frames, load, factor)


def _expanded(
    net: Net,
    shape: NetShape,
    sides: tuple[Array, Array, Array, Array],
    frames: CreaseFrames,
    load: Load | None,
    factor: float,
) -> Expansion:
    layout = layout_of(net)
    springs, tendons, creases, triangles = sides
    torques = None if load is None else factor * load.torques
    shares = corner_shares(creases, frames)
    turning = angle_gradients(frames, shares)
    pieces = [
        _straight(net, springs, tendons, shape.rigid),
        _folds(net, frames, shares, turning, shape, torques),
    ]
    if net.membranes is not None:
        pieces.append(_stretched(net.membranes, triangles))
    stored = sum(piece[0] for piece in pieces)
    forces = layout.on_nodes @ np.concatenate([piece[1] for piece in pieces], axis=1).T
    if net.gravity:
        stored -= float(np.sum(layout.weight * shape.positions))
        forces -= layout.weight
    blocks = layout.gather @ np.concatenate([piece[2] for piece in pieces], axis=1).T
    if net.planes is not None:
        planes, depths = net.planes.planes, net.planes.depths(shape.positions)
        stored += planes.stiffness / 2 * float(np.sum(depths**2))
        forces -= net.planes.weights.T @ (planes.stiffness * depths[:, None] * planes.normals)
        squares = np.einsum("pi,pj->pij", planes.normals, planes.normals).reshape(-1, 9)
        blocks += layout.on_planes @ (planes.stiffness * planes.active(depths)[:, None] * squares)
    energy = stored
    if load is not None:
        forces -= factor * load.forces
        energy = stored - factor * _work(net, shape, load)
    free, pressed = layout.free_part(blocks), None
    if net.contact is not None:
        terms = contact_terms(net.contact, shape.positions, shape.pressing, dense=isinstance(free, np.ndarray))
        energy, forces, pressed = energy + terms.energy, forces + terms.slope, terms.curvature
        if pressed is not None:
            further = pressed[layout.free][:, layout.free]
            free = free + (further if isinstance(further, np.ndarray) else csc_array(further))
    return Expansion(
        shape=shape,
        stored=stored,
        energy=energy,
        slope=forces,
        blocks=blocks,
        free=free,
        turning=turning,
        layout=layout,
        pressed=pressed,
    )


def stored_by_part(net: Net, shape: NetShape, further: Array | float = 0.0) -> tuple[float, Array, float, float, float]:
    """Return energies, J: of bars, of each crease, (crease,), of tendons, of membranes, of weight (0 at the origin).

    Args:
        net: the net with its laws.
        shape: any shape.
        further: changes of the rest angles of valleys, rad, (crease,).
    """
    springs, tendons, _, triangles = sides_of(net, shape.positions)
    return (
        float(net.springs.stiffness @ (side_lengths(springs) - net.springs.rest_length) ** 2) / 2,
        _crease_energies(net, shape, further),
        float(np.sum(net.tendons.law.energy(side_lengths(tendons)))),
        0.0 if net.membranes is None else _stretched(net.membranes, triangles)[0],
        -float(np.sum(layout_of(net).weight * shape.positions)),
    )


def angle_slopes(net: Net, shape: NetShape) -> tuple[Array, Layout]:
    """Return gradients of the creases' angles by their sides, 1/m, (3, side, crease), and the layout of the sides."""
    creases = sides_of(net, shape.positions)[2]
    frames = crease_frames(creases)
    return angle_gradients(frames, corner_shares(creases, frames)), layout_of(net)


def load_slope(net: Net, shape: NetShape, load: Load, turning: Array | None = None) -> Array:
    """Return the forces on the nodes from forces and torques of a load in a shape, N, (node, 3).

    Args:
        net: the net.
        shape: any shape.
        load: forces and torques.
        turning: gradient of the angles in the shape, from an expansion; None to compute it.
    """
    if not load.torques.any():
        return load.forces + 0.0  # the sum has no negative zeros
    layout = layout_of(net)
    turning = angle_slopes(net, shape)[0] if turning is None else turning
    springs, tendons, creases, _ = layout.counts
    sides = np.zeros((3, layout.sides.shape[0]))
    begin = springs + tendons
    sides[:, begin : begin + 3 * creases] = (load.torques * turning).reshape(3, -1)
    return np.asarray(layout.on_nodes @ sides.T + load.forces)


def sides_of(net: Net, positions: Array) -> tuple[Array, Array, Array, Array]:
    """Return sides of springs and tendons, (3, side), of creases, (3, side, crease), of triangles, (3, side), m."""
    layout = layout_of(net)
    springs, tendons, creases, _ = layout.counts
    sides = np.ascontiguousarray((layout.sides @ positions).T)
    bent = springs + tendons
    flat = bent + 3 * creases
    return sides[:, :springs], sides[:, springs:bent], sides[:, bent:flat].reshape(3, 3, -1), sides[:, flat:]


def _work(net: Net, shape: NetShape, load: Load) -> float:
    return float(np.sum(load.forces * (shape.positions - net.nodes)) + load.torques @ shape.angles)


def _straight(net: Net, springs: Array, tendons: Array, rigid: RigidForces | None) -> Piece:
    """Return the piece of bars and tendons."""
    shortest = _SHORTEST * net.size
    stiffness, rest_length = net.springs.tightened(rigid), net.springs.rest_length
    apart = side_lengths(springs)
    length, rise = np.maximum(apart, shortest), apart - rest_length
    pull = stiffness * rise
    energy = float(pull @ rise) / 2
    if rigid is not None:
        bars, pins = net.springs.rigid_parts
        energy += float(rigid.bars @ rise[bars]) + float(np.sum(rigid.pins * springs[:, pins]))
        pull[bars] += rigid.bars
    per_length = np.where(rest_length > 0, pull / length, stiffness)
    sides = springs
    if tendons.shape[1]:
        span = side_lengths(tendons)
        energies, force, slope = net.tendons.law.expansion(span)
        energy += float(np.sum(energies))
        known = np.maximum(span, shortest)
        sides = np.concatenate((springs, tendons), axis=1)
        length, stiffness = np.concatenate((length, known)), np.concatenate((stiffness, slope))
        per_length = np.concatenate((per_length, force / known))
    # the Hessian of a pull F at a length L along n is F' n n^T + F / L (1 - n n^T)
    unit = sides / length
    blocks = np.empty((3, 3, len(length)))
    np.multiply(unit[:, None], (stiffness - per_length) * unit, out=blocks)
    blocks.reshape(9, -1)[::4] += per_length
    forces = per_length * sides
    if rigid is not None:
        forces[:, net.springs.rigid_parts[1]] += rigid.pins
    return energy, forces, blocks.reshape(9, -1)


def _crease_energies(net: Net, shape: NetShape, further: Array | float) -> Array:
    """Return the stored energy of each crease, J, (crease,). It excludes dissipated energy."""
    law = net.creases.law
    if not remembers(law):
        return np.asarray(law.energy(shape.angles, further))
    return stored_energy(law, shape.angles, further, crease_memory(net, shape))


def _folds(
    net: Net, frames: CreaseFrames, shares: Array, slope: Array, shape: NetShape, torques: Array | None
) -> Piece:
    angles = shape.angles
    law = net.creases.law
    energy, moment, stiffness = turn_expansion(law, angles, shape.turn) if remembers(law) else law.expansion(angles)
    acting = moment if torques is None else moment - torques
    blocks = np.empty((3, 3, 3, 3, len(angles)))
    np.multiply((stiffness * slope)[:, None, :, None], slope[None, :, None, :], out=blocks)
    add_curvature(blocks, frames, shares, slope, acting)
    return float(np.sum(energy)), (acting * slope).reshape(3, -1), blocks.reshape(9, -1)


def membrane_stresses(net: Net, shape: NetShape) -> Array:
    """Compute principal second Piola-Kirchhoff stresses of the membranes, the larger first, Pa, (triangle, 2)."""
    if net.membranes is None:
        return np.zeros((0, 2))
    plane, area = _flat(net.membranes.built)
    stress = _membrane_stress(net.membranes, _by_triangle(sides_of(net, shape.positions)[3]), plane, area)[3]
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
    stiff, gradient, strain, stress = _membrane_stress(membranes, _by_triangle(sides), shape, area)
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
    blocks = stiff[..., None, None] * linear + geometric
    return energy, slope.reshape(-1, 3).T, blocks.reshape(-1, 9).T


def _by_triangle(sides: Array) -> Array:
    """Return sides of triangles, (3, 2 x triangle), triangle by triangle, (triangle, 2, 3)."""
    return sides.T.reshape(-1, 2, 3)


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
