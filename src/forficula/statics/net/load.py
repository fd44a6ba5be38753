"""What acts on a net."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.pattern.geometry import triangle_normals
from forficula.statics.net.net import Net, NetShape


@dataclass(frozen=True, kw_only=True, eq=False)
class Load:
    """What acts on a net, times a factor.

    Attributes:
        forces: on nodes, that keep their directions, N, (node, 3).
        torques: on creases, positive where they fold valleys, N m, (crease,). Turning all rest angles by some angle is
            the torque stiffness x angle.
        displacements: of the held coordinates, m, (node, 3); 0 where free.
    """

    forces: Array
    torques: Array
    displacements: Array


def no_load(net: Net) -> Load:
    """Nothing acts; a start for `dataclasses.replace`."""
    return Load(
        forces=np.zeros_like(net.nodes),
        torques=np.zeros(len(net.creases.points)),
        displacements=np.zeros_like(net.nodes),
    )


def check_load(net: Net, load: Load) -> None:
    """Refuse a load that does not fit.

    Raises:
        InputError: shapes that differ, or displacements of coordinates that no support holds.
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
    """Forces on points, N, (point, 3), that keep their directions."""
    return replace(no_load(net), forces=net.points[points].T @ forces)


def crease_torques(net: Net, creases: Indices, torques: Array | float) -> Load:
    """Torques on creases, N m, positive where they fold valleys."""
    load = no_load(net)
    load.torques[creases] = torques
    return load


def held_displacements(net: Net, displacements: Array) -> Load:
    """Motion of supports, m, (node, 3), 0 where free: what is to be moved is to be held."""
    return replace(no_load(net), displacements=displacements)


def pressure(net: Net, shape: NetShape, triangles: Indices) -> Load:
    """A pressure of 1 Pa on the right-hand backs of triangles: it pushes them along their normals.

    Args:
        net: what is pressed.
        shape: in which areas and normals are taken; the forces keep them.
        triangles: points at their corners, counterclockwise seen from where it pushes them to, (triangle, 3).
    """
    each = triangle_normals((net.points @ shape.positions)[triangles]) / 6
    return point_forces(net, triangles.ravel(), np.repeat(each, 3, axis=0))


def acceleration(net: Net, direction: Array) -> Load:
    """What an acceleration of all supports, m/s^2, (3,), does to the masses on them."""
    return replace(no_load(net), forces=-np.outer(np.asarray(net.mass_matrix.sum(axis=1)).ravel(), direction))
