"""Drag of a point of a net."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from scipy.sparse import block_array, csr_array, hstack

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.material.law.crease_turn import CreaseTurn
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
from forficula.statics.net.contact.contact_energy import contact_forces
from forficula.statics.net.driven.driven_net import DrivenNet, driven_net
from forficula.statics.net.driven.net_course import released
from forficula.statics.net.driven.net_point import net_point
from forficula.statics.net.energy import expand, shape_at
from forficula.statics.net.factor import factored
from forficula.statics.net.load import Load
from forficula.statics.net.minimum import minimum
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.net_of import memory_in_senses, net_of, place_points, start_shape, valley_angles
from forficula.statics.net.net_state import STRAINED, strength
from forficula.statics.net.supports import supported
from forficula.statics.quasi_static_path import QuasiStaticPoint
from forficula.structure import Drive, Structure, Transition

# stiffness of the pull, relative to the stiffest part: a target out of reach hardly stretches the structure
_SOFT = 0.1
_RELAXATIONS = 3
_LEAST = 1e-9  # of the stiffest part: stiffness of a structure that a point of it can move without force


@dataclass(frozen=True, kw_only=True, eq=False)
class _PulledNet:
    """A net whose last node is the target of a drag, which a spring joins to the dragged point.

    Attributes:
        driven: net with its drive.
        net: net with the target.
        load: of the drive, on this net.
        weights: of the nodes without the target, whose mean is the dragged point, (node,).
        spring: stiffness of the spring, N/m.
    """

    driven: DrivenNet
    supported: Net
    net: Net
    load: Load
    weights: Array
    spring: float


def net_drag(
    structure: Structure,
    drive: Drive,
    transition: Transition | None,
    places: int | Mapping[int, float],
    near: QuasiStaticPoint | None,
) -> DraggedPoint:
    """Prepare the drag of a point of a net; see `forficula.statics.survey.start_drag`."""
    weights = checked_places(structure, places)
    driven = driven_net(structure, net_of(structure), drive, transition)
    start = near or net_point(driven, released(driven.free, start_shape(structure, driven.free))[0].shape, 0.0)
    pulled = _pulled_net(driven, weights, start)
    return DraggedPoint(
        structure=structure,
        places=weights,
        start=start,
        pull=lambda near, target: _pulled(pulled, near, target),
    )


def _pulled_net(driven: DrivenNet, places: Mapping[int, float], start: QuasiStaticPoint) -> _PulledNet:
    """Return a net with the target of a drag.

    Raises:
        InputError: supports hold the dragged point.
    """
    structure, (net, _) = driven.structure, supported(driven.net, driven.load)
    points = place_points(structure)
    weights = np.zeros(len(net.nodes))
    for place, weight in places.items():
        weights += weight * net.points[[points[place]]].toarray()[0]
    if not net.free[weights != 0].any():
        raise InputError("places: need a point that can move, got one that supports hold")
    shape = _shape(driven, net, start)
    compliance, stiffest = _compliance(driven, net, weights, shape, _factor(driven, start))
    softest = 1 / float(np.abs(np.linalg.eigvalsh(compliance)).max())
    spring = min(STIFF * softest, _SOFT * stiffest)
    joined = csr_array(
        block_array(
            [[net.points, None], [csr_array(weights[None]), None], [None, csr_array(np.ones((1, 1)))]], format="csr"
        )
    )
    dragged = net.points.shape[0]
    masses = block_array([[net.mass_matrix, None], [None, csr_array((1, 1))]], format="csr")
    extended = replace(
        net,
        nodes=np.concatenate([net.nodes, np.zeros((1, 3)) + net.nodes.mean(axis=0)]),
        free=np.concatenate([net.free, np.zeros((1, 3), dtype=np.bool_)]),
        points=joined,
        masses=csr_array(masses),
        springs=replace(
            net.springs,
            points=np.concatenate([net.springs.points, [[dragged, dragged + 1]]]),
            stiffness=np.concatenate([net.springs.stiffness, [spring]]),
            rest_length=np.concatenate([net.springs.rest_length, [0.0]]),
        ),
    )
    if net.contact is not None:
        corners = csr_array(hstack([net.contact.points, csr_array((net.contact.points.shape[0], 1))]))
        extended = replace(extended, contact=replace(net.contact, points=corners))
    none = np.zeros((1, 3))
    load = Load(
        forces=np.concatenate([driven.load.forces, none]),
        torques=driven.load.torques,
        displacements=np.concatenate([driven.load.displacements, none]),
    )
    return _PulledNet(driven=driven, supported=net, net=extended, load=load, weights=weights, spring=spring)


def _compliance(driven: DrivenNet, net: Net, weights: Array, shape: NetShape, factor: float) -> tuple[Array, float]:
    """Return the compliance of a net at the dragged point, m/N, (3, 3), and its largest stiffness, N/m."""
    stiffness = expand(net, shape, driven.load, factor).free
    stiffest = float(stiffness.diagonal().max())
    pulls = np.zeros((net.nodes.size, 3))
    for axis in range(3):
        pulls[axis::3, axis] = weights
    pulls = pulls[net.free.ravel()]
    compliance = pulls.T @ factored(stiffness, _LEAST * stiffest).solve(pulls)
    return (compliance + compliance.T) / 2, stiffest


def _factor(driven: DrivenNet, near: QuasiStaticPoint) -> float:
    return near.strength / driven.drive.strength if driven.drive.strength else 0.0


def _shape(driven: DrivenNet, net: Net, near: QuasiStaticPoint) -> NetShape:
    """Return the shape of a net at a point of a path."""
    positions = net.nodes + near.coordinates.reshape(-1, 3)
    angles, turn = valley_angles(driven.structure, near.angles), None
    if near.memory is not None:
        turn = CreaseTurn(memory=memory_in_senses(driven.structure, near.memory), angle=angles)
    return shape_at(net, positions, angles, turn)


def _held(pulled: _PulledNet, shape: NetShape, aim: Array, factor: float) -> Held[NetShape]:
    """Find the equilibrium near a shape while the spring ends at an aim, m, (3,).

    The memory of the creases in the returned shape is that at the beginning of the move.
    """
    start = replace(shape, positions=np.concatenate([shape.positions, aim[None]]))
    rest = minimum(pulled.net, start, pulled.load, factor)
    position = pulled.weights @ rest.shape.positions[:-1]
    return Held(
        shape=replace(rest.shape, positions=rest.shape.positions[:-1], turn=shape.turn),
        position=position,
        force=pulled.spring * (aim - position),
        stable=rest.stable,
    )


def _pulled(pulled: _PulledNet, near: QuasiStaticPoint, target: Array) -> DraggedShape:
    """Find the equilibrium near a shape while the point is pulled to a target.

    Bars that are strained by more than 5 % tear. If the target is out of reach, the spring finally ends where the point
    is, which relaxes the parts along which the net hardly yields.
    """
    driven, factor = pulled.driven, _factor(pulled.driven, near)

    def torn(shape: NetShape) -> bool:
        return bool(np.abs(strength(driven.net, shape).strains).max(initial=0.0) > STRAINED)

    held, reached = approach(
        lambda shape, aim: _held(pulled, shape, aim, factor),
        _shape(driven, driven.net, near),
        target,
        driven.structure.span,
        torn,
    )
    if not reached:
        for _ in range(_RELAXATIONS):
            held = _held(pulled, held.shape, held.position, factor)
        compliance = _compliance(driven, pulled.supported, pulled.weights, held.shape, factor)[0]
        held = held._replace(force=least_force(held.force, compliance))
    contacts = contact_forces(driven.net, held.shape)
    point = replace(net_point(driven, held.shape, factor, resting=False), contacts=contacts)
    return dragged_shape(driven.structure, point, target, held, reached=reached)
