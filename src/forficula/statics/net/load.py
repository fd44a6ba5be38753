"""Loads on a net: forces, torques and displacements of supports."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.pattern.geometry import triangle_normals
from forficula.statics.net.net import Net, NetShape


@dataclass(frozen=True, kw_only=True, eq=False)
class Load:
    """Load on a net at a load factor of 1.

    Attributes:
        forces: on nodes, with fixed directions, N, (node, 3).
        torques: on creases, positive if they fold valleys, N m, (crease,). A change of rest angles is equivalent to the
            torque stiffness x angle.
        displacements: of the held coordinates, m, (node, 3); 0 for free ones.
    """

    forces: Array
    torques: Array
    displacements: Array


def no_load(net: Net) -> Load:
    """Return a load of zero, to be changed by `dataclasses.replace`."""
    return Load(
        forces=np.zeros_like(net.nodes),
        torques=np.zeros(len(net.creases.points)),
        displacements=np.zeros_like(net.nodes),
    )


def same_load(one: Load, other: Load) -> bool:
    """Return whether two loads on the same net are equal."""
    pairs = ((one.forces, other.forces), (one.torques, other.torques), (one.displacements, other.displacements))
    return all(np.array_equal(*pair) for pair in pairs)


def check_load(net: Net, load: Load) -> None:
    """Reject a load that does not fit a net.

    Raises:
        InputError: shapes differ, or coordinates without support are displaced.
    """
    shape = net.nodes.shape
    for name, got, need in (
        ("forces", load.forces.shape, shape),
        ("torques", load.torques.shape, (len(net.creases.points),)),
        ("displacements", load.displacements.shape, shape),
    ):
        if got != need:
            raise InputError(f"load.{name}: need an array of shape {need}, got {got}")
    if np.any(load.displacements[net.free]):
        node = int(np.argwhere((load.displacements != 0) & net.free)[0, 0])
        raise InputError(
            f"load.displacements: need 0 where no support holds, got {load.displacements[node]} m at node {node}"
        )


def point_forces(net: Net, points: Indices, forces: Array) -> Load:
    """Return a load of forces on points, N, (point, 3), with fixed directions."""
    return replace(no_load(net), forces=net.points[points].T @ forces)


def crease_torques(net: Net, creases: Indices, torques: Array | float) -> Load:
    """Return a load of torques on creases, N m, positive if they fold valleys."""
    load = no_load(net)
    load.torques[creases] = torques
    return load


def held_displacements(net: Net, displacements: Array) -> Load:
    """Return a load of displaced supports, m, (node, 3); only held coordinates can be displaced."""
    return replace(no_load(net), displacements=displacements)


def pressure(net: Net, shape: NetShape, triangles: Indices) -> Load:
    """Return a pressure of 1 Pa on the backs of triangles, which pushes them along their right-hand normals.

    Args:
        net: the net.
        shape: shape that defines areas and normals; the forces do not follow later rotations.
        triangles: points at their corners, counterclockwise seen from their fronts, (triangle, 3).
    """
    forces = triangle_normals((net.points @ shape.positions)[triangles]) / 6
    return point_forces(net, triangles.ravel(), np.repeat(forces, 3, axis=0))


def acceleration(net: Net, direction: Array) -> Load:
    """Return the inertial forces on all masses under an acceleration of all supports, m/s^2, (3,)."""
    return replace(no_load(net), forces=-np.outer(np.asarray(net.mass_matrix.sum(axis=1)).ravel(), direction))
