"""Drag of a point of a tree of joints."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.statics.drag import (
    STIFF,
    DraggedPoint,
    DraggedShape,
    Held,
    approach,
    checked_places,
    dragged_shape,
    least_force,
)
from forficula.statics.quasi_static_path import QuasiStaticPoint
from forficula.statics.tree.elements import Expansion, LinePiece, elements, stretched
from forficula.statics.tree.ensemble import Ensemble, ensemble, start_angles, torque_scale
from forficula.statics.tree.planes import table_forces
from forficula.statics.tree.pose import carried_points, moves_of, places_of, pose
from forficula.statics.tree.potential import potential, rest
from forficula.statics.tree.tree_path import place_carriers, tree_points
from forficula.structure import GROUND, Drive, Structure

_LEAST = 1.0  # of the structure's torque per square of its span: least stiffness against a pull
_AT_STOP = 1e-9  # rad


@dataclass(frozen=True, kw_only=True, eq=False)
class _PulledTree:
    """A tree with a point that is dragged.

    Attributes:
        structures: the tree as the only case.
        drive: the drive.
        bodies: that carry the places, whose mean is the dragged point, (place,).
        places: in the axes of these bodies, m, (place, 3).
        weights: of the places, (place,).
        spring: stiffness of the pull, N/m.
    """

    structures: Ensemble
    drive: Drive
    bodies: tuple[int, ...]
    places: Array
    weights: Array
    spring: float


def tree_drag(
    structure: Structure, drive: Drive, places: int | Mapping[int, float], near: QuasiStaticPoint | None
) -> DraggedPoint:
    """Prepare the drag of a point of a tree; see `forficula.statics.survey.start_drag`.

    Raises:
        InputError: no hinge moves the dragged point.
    """
    weights = checked_places(structure, places)
    structures = ensemble([structure])
    tree = structures.sheet.laid.tree
    numbers = list(weights)
    carriers, positions = place_carriers(structure)
    bodies = tuple(carriers[numbers].tolist())
    if not any(tree.chain(body) for body in bodies if body != GROUND):
        raise InputError("places: need a point that can move, got one that no hinge moves")
    if near is None:
        structures = structures.new(start_angles(structures))
        near = _point(structures, drive, 0.0, rest(structures, start_angles(structures)).position[0], resting=True)
    structures = _from(structures, near)
    pulled = _PulledTree(
        structures=structures,
        drive=drive,
        bodies=bodies,
        places=positions[numbers],
        weights=np.array(list(weights.values())),
        spring=0.0,
    )
    pulled = replace(pulled, spring=_spring(pulled, near))
    return DraggedPoint(
        structure=structure, places=weights, start=near, pull=lambda near, target: _pulled(pulled, near, target)
    )


def _point(structures: Ensemble, drive: Drive, strength: float, angles: Array, *, resting: bool) -> QuasiStaticPoint:
    memory = structures.turned(angles[None]).memory
    rests = np.array([resting], dtype=np.bool_)
    return tree_points(structures, drive, np.array([strength]), angles[None], rests, memory)[0]


def _from(structures: Ensemble, near: QuasiStaticPoint) -> Ensemble:
    """Return the tree with the memory of its hinges in a shape."""
    memory = None if near.memory is None else near.memory[:, None]
    return structures.beginning(memory, near.coordinates[None])


def _torques(pulled: _PulledTree, near: QuasiStaticPoint) -> Array:
    return near.strength * np.array(pulled.drive.shares)


def _spring(pulled: _PulledTree, near: QuasiStaticPoint) -> float:
    """Return a stiffness of the pull that is large relative to that of the tree at the dragged point, N/m."""
    structures = pulled.structures
    least = _LEAST * torque_scale(structures) / structures.structure.span**2
    compliance = _compliance(pulled, near.coordinates[None], _torques(pulled, near))
    softest = float(np.linalg.eigvalsh(compliance).max())
    return STIFF * max(least, 1 / softest if softest > 0 else 0.0)


def _compliance(pulled: _PulledTree, angles: Array, torques: Array) -> Array:
    """Return the compliance of a tree at the dragged point, m/N, (3, 3), without hinges that press on their stops."""
    structures = pulled.structures
    moves = _point_moves(pulled, angles)
    ties = structures.ties
    curvature = potential(structures, angles, torques)[2][0]
    loose = (angles[0] > structures.lower + _AT_STOP) & (angles[0] < structures.upper - _AT_STOP)
    if ties is not None:
        moves, curvature = moves @ ties.spread, ties.spread.T @ curvature @ ties.spread
    else:
        moves, curvature = moves[:, loose], curvature[np.ix_(loose, loose)]
    if not len(curvature):
        return np.zeros((3, 3))
    values, axes = np.linalg.eigh(curvature)
    positive = np.maximum(np.abs(values), 1e-9 * np.abs(values).max(initial=1e-300))
    along = moves @ axes
    return np.asarray((along / positive) @ along.T)


def _point_moves(pulled: _PulledTree, angles: Array) -> Array:
    """Return the derivatives of the dragged point by the hinges' angles, m/rad, (3, hinge)."""
    tree = pulled.structures.sheet.laid.tree
    carried = carried_points(tree, pulled.bodies, pulled.places)
    at = pose(tree, angles)
    by_pair = moves_of(carried, at, places_of(carried, at))[:, 0]
    moves = np.zeros((3, pulled.structures.size))
    points, hinges = carried.pairs
    np.add.at(moves.T, hinges, (pulled.weights[points] * by_pair).T)
    return moves


def _held(pulled: _PulledTree, angles: Array, aim: Array, torques: Array) -> Held[Array]:
    """Find the equilibrium near angles, (hinge,), while the spring ends at an aim, m, (3,)."""
    structures, count = pulled.structures, len(pulled.bodies)
    tree = structures.sheet.laid.tree
    # its side is the vector from the dragged point to the aim
    piece = LinePiece(points=tuple(range(count + 1)), sides=np.concatenate([-pulled.weights, [1.0]])[None])
    joined = elements(tree, [*pulled.bodies, GROUND], np.concatenate([pulled.places, aim[None]]), [piece])

    def law(sides: Array) -> Expansion:
        stiffness = np.broadcast_to(pulled.spring * np.eye(3), (len(sides), 1, 1, 3, 3))
        return pulled.spring / 2 * np.sum(sides**2, axis=(1, 2, 3)), pulled.spring * sides, stiffness

    rested = rest(structures, angles[None], torques, pull=lambda angles: stretched(joined, angles, [law]))
    carried = carried_points(tree, pulled.bodies, pulled.places)
    position = places_of(carried, pose(tree, rested.position))[:, 0] @ pulled.weights
    return Held(
        shape=rested.position[0],
        position=position,
        force=pulled.spring * (aim - position),
        stable=bool(rested.rests[0]),
    )


def _pulled(pulled: _PulledTree, near: QuasiStaticPoint, target: Array) -> DraggedShape:
    """Find the equilibrium near a shape while the point is pulled to a target."""
    pulled = replace(pulled, structures=_from(pulled.structures, near))
    structure, torques = pulled.structures.structure, _torques(pulled, near)
    held, reached = approach(
        lambda angles, aim: _held(pulled, angles, aim, torques), near.coordinates, target, structure.span
    )
    if not reached:
        held = held._replace(force=least_force(held.force, _compliance(pulled, held.shape[None], torques)))
    point = _point(pulled.structures, pulled.drive, near.strength, held.shape, resting=False)
    point = replace(point, contacts=table_forces(pulled.structures.planes, held.shape[None])[0])
    return dragged_shape(structure, point, target, held, reached=reached)
