"""Drag of a point of a tree of joints."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.statics.drag import LESS, NEAR, STIFF, UPDATES, Drag, DraggedShape, checked_places, drag_text
from forficula.statics.quasi_static_path import QuasiStaticPoint
from forficula.statics.tree.elements import Elements, Expansion, LinePiece, elements, stretched
from forficula.statics.tree.pose import carried_points, moves_of, places_of, pose
from forficula.statics.tree.potential import Ensemble, ensemble, potential, rest, start_angles, torque_scale
from forficula.statics.tree.tree_path import tree_points
from forficula.structure import GROUND, Drive, Structure

_LEAST = 1e-3  # of the structure's torque per square of its span: least stiffness against a pull


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
) -> Drag:
    """Prepare the drag of a point of a tree; see `forficula.statics.survey.start_drag`.

    Raises:
        InputError: no hinge moves the dragged point.
    """
    weights = checked_places(structure, places)
    structures = ensemble([structure])
    tree = structures.sheet.laid.tree
    carriers = [(point.body, point.place) for point in structure.points]
    for membrane in structure.membranes:
        carriers += list(zip(membrane.bodies.tolist(), membrane.places, strict=True))
    bodies = tuple(carriers[place][0] for place in weights)
    if not any(tree.chain(body) for body in bodies if body != GROUND):
        raise InputError("places: need a point that can move, got one that no hinge moves")
    if near is None:
        near = _point(structures, 0.0, rest(structures, start_angles(structures)).position[0], resting=True)
    pulled = _PulledTree(
        structures=structures,
        drive=drive,
        bodies=bodies,
        places=np.array([carriers[place][1] for place in weights]),
        weights=np.array(list(weights.values())),
        spring=0.0,
    )
    pulled = replace(pulled, spring=_spring(pulled, near))
    return Drag(
        structure=structure, places=weights, start=near, pull=lambda near, target: _pulled(pulled, near, target)
    )


def _point(structures: Ensemble, strength: float, angles: Array, *, resting: bool) -> QuasiStaticPoint:
    return tree_points(structures, np.array([strength]), angles[None], np.array([resting], dtype=np.bool_))[0]


def _torques(pulled: _PulledTree, near: QuasiStaticPoint) -> Array:
    return near.strength * np.array(pulled.drive.shares)


def _spring(pulled: _PulledTree, near: QuasiStaticPoint) -> float:
    """Return a stiffness of the pull that is large relative to that of the tree at the dragged point, N/m."""
    structures, angles = pulled.structures, near.coordinates[None]
    least = _LEAST * torque_scale(structures) / structures.structure.span**2
    moves = _point_moves(pulled, angles)
    curvature = potential(structures, angles, _torques(pulled, near))[2][0]
    values, axes = np.linalg.eigh(curvature)
    positive = np.maximum(np.abs(values), 1e-9 * np.abs(values).max(initial=1e-300))
    along = moves @ axes
    softest = 1 / max(float(np.linalg.eigvalsh((along / positive) @ along.T).max()), 1e-300)
    return STIFF * max(softest, least)


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


def _joined(pulled: _PulledTree, aim: Array) -> Elements:
    """Return an element whose side is the vector from the dragged point to an aim, m, (3,)."""
    count = len(pulled.bodies)
    piece = LinePiece(points=tuple(range(count + 1)), sides=np.concatenate([-pulled.weights, [1.0]])[None])
    places = np.concatenate([pulled.places, aim[None]])
    return elements(pulled.structures.sheet.laid.tree, [*pulled.bodies, GROUND], places, [piece])


def _pulled(pulled: _PulledTree, near: QuasiStaticPoint, target: Array) -> DraggedShape:
    """Find the equilibrium near a shape while the point is pulled to a target, as for nets."""
    structures, spring, aim = pulled.structures, pulled.spring, target.copy()
    tree, angles = structures.sheet.laid.tree, near.coordinates[None]
    carried = carried_points(tree, pulled.bodies, pulled.places)

    def law(sides: Array) -> Expansion:
        stiffness = np.broadcast_to(spring * np.eye(3), (len(sides), 1, 1, 3, 3))
        return spring / 2 * np.sum(sides**2, axis=(1, 2, 3)), spring * sides, stiffness

    first, before = None, np.inf
    for _ in range(UPDATES):
        joined = _joined(pulled, aim)
        rested = rest(
            structures,
            angles,
            _torques(pulled, near),
            pull=lambda angles, joined=joined: stretched(joined, angles, [law]),
        )
        angles = rested.position
        position = places_of(carried, pose(tree, angles))[:, 0] @ pulled.weights
        gap = target - position
        away = float(np.linalg.norm(gap))
        result = angles[0], position, spring * (aim - position), bool(rested.rests[0])
        first = first or result
        reached = away <= NEAR * structures.structure.span
        if reached or away > LESS * before:
            break
        aim, before = aim + gap, away
    shape, position, force, stable = result if reached else first
    return DraggedShape(
        point=_point(structures, near.strength, shape, resting=False),
        target=target,
        position=position,
        force=force if reached else np.full(3, np.nan),
        reached=reached,
        stable=stable,
        text=drag_text(structures.structure, force, target - position, reached=reached),
    )
