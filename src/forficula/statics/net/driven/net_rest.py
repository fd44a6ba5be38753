"""Equilibria of a net under a load that grows evenly, for a quasi-static stage of a run.

Nodes are at sliding points, or four of them at each plate. Maxwell branches of creases follow the time of the stage.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from forficula.arrays import Array, Flags
from forficula.errors import InputError
from forficula.material.law.crease_turn import CreaseTurn, turn_losses
from forficula.statics.net.driven.driven_net import goal_values
from forficula.statics.net.energy import expand, moved_shape, shape_at
from forficula.statics.net.load import Load
from forficula.statics.net.minimum import minimum
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.net_of import (
    memory_in_senses,
    motor_load,
    net_of,
    own_angles,
    own_memory,
    point_positions,
    valley_angles,
    valley_law,
)
from forficula.statics.net.plate_nodes import plate_nodes, posed_nodes
from forficula.statics.net.rigid_forces import is_exact
from forficula.statics.rest_path import CreaseLosses, crease_losses, rest_path
from forficula.structure import (
    GROUND,
    GrowingLoad,
    RestPath,
    RestShape,
    Structure,
    crease_law,
    distance_to_goal,
)
from forficula.structure.tree import built_frames

_NEAR = 0.02  # of the net's size: largest displacement between two neighbouring equilibria


def net_rest_path(structure: Structure, start: RestShape, load: GrowingLoad) -> RestPath:
    """Follow the equilibria of a net under a growing load; see `forficula.statics.rest_path.rest_path`."""
    system = _LoadedNet(structure, load)
    return rest_path(system, system.state(start), load)


class _NetState(NamedTuple):
    """A shape of a net, and the share of the load at which the motion to this shape began.

    The motion to an equilibrium has ended, so that the share is that of the equilibrium.
    """

    share: float
    shape: NetShape


class _LoadedNet:
    """A net under a load."""

    def __init__(self, structure: Structure, load: GrowingLoad) -> None:
        self._structure, self._load = structure, load
        net = net_of(structure)
        held = net.free.copy()
        for motor, setting in zip(structure.motors, load.after, strict=True):
            if motor.kind != "displacement" or motor.direction is None or not setting:
                continue
            axes = np.flatnonzero(motor.direction)
            if len(axes) > 1:
                raise InputError(
                    f"drive.{motor.name}.direction: need x, y or z in a quasi-static stage, because statics holds"
                    " points along these only"
                )
            held[list(motor.points), axes[0]] = False
        creases = replace(net.creases, law=valley_law(structure))
        self._net: Net = replace(net, free=held, creases=creases)
        self._displaced = net.free & ~held
        # number of the first of the four nodes of each body
        self._first = plate_nodes(structure).first if structure.plates else ()
        self._built = built_frames(structure)
        count = len(structure.hinges)
        self._gains = np.zeros((len(structure.motors), count))
        for number, motor in enumerate(structure.motors):
            np.add.at(self._gains[number], list(motor.hinges), motor.gains or np.ones(len(motor.hinges)))
        self._law = crease_law(structure, np.arange(count), rigid_stops=True)

    @property
    def relaxes(self) -> bool:
        return self._net.creases.law.relaxes

    @property
    def prescribes(self) -> Flags:
        return np.array([motor.kind in ("displacement", "rest-angle") for motor in self._structure.motors])

    def state(self, start: RestShape) -> _NetState:
        """Return the state of a shape."""
        positions = start.points
        if self._structure.plates:
            positions = posed_nodes(self._structure, self._net.nodes, self._first, start.origins, start.frames)
        angles, turn = valley_angles(self._structure, start.angles), None
        if start.memory is not None:
            turn = CreaseTurn(memory=memory_in_senses(self._structure, start.memory), angle=angles)
        return _NetState(self._load.begin, shape_at(self._net, positions, angles, turn))

    def rest(self, share: float, near: _NetState) -> _NetState | None:
        load, before = self._motor_load(self._load.settings(share)), near.shape
        if before.turn is not None:
            time = (share - near.share) * self._load.duration
            before = replace(before, turn=replace(before.turn, time=time))
        positions = before.positions
        if self._displaced.any():
            moved = self._motor_load(self._load.settings(share) - self._load.before).displacements
            positions = np.where(self._displaced, self._load.built_on + moved, positions)
        start = moved_shape(self._net, before, positions)

        def is_far(shape: NetShape) -> bool:
            return bool(np.abs(shape.positions - before.positions).max() > _NEAR * self._net.size)

        rest = minimum(self._net, start, load, 1.0, stop=is_far)
        usable = rest.stable and is_exact(self._net, rest.shape) and not is_far(rest.shape)
        return _NetState(share, rest.shape) if usable else None

    def _motor_load(self, settings: Array) -> Load:
        return motor_load(self._structure, self._net, tuple(settings.tolist()))

    def creep(self, _share: float, _start: _NetState) -> None:
        """Return no creep: dampers between nodes are not a part of the net."""
        return

    def crease_losses(self, before: _NetState, after: _NetState) -> CreaseLosses:
        law, turn = self._net.creases.law, before.shape.turn
        if turn is None:
            return {}
        time = (after.share - before.share) * self._load.duration
        return crease_losses([law], turn_losses(law, after.shape.angles, replace(turn, time=time)))

    def middle(self, one: _NetState, other: _NetState) -> _NetState:
        # the motion begins with the memory of the first state
        positions = (one.shape.positions + other.shape.positions) / 2
        return _NetState(one.share, moved_shape(self._net, one.shape, positions))

    def conjugates(self, share: float, state: _NetState) -> Array:
        structure, settings, shape = self._structure, self._load.settings(share), state.shape
        angles = own_angles(structure, shape)
        slope = expand(self._net, shape, self._motor_load(settings), 1.0).slope
        further = np.where([motor.kind == "rest-angle" for motor in structure.motors], settings, 0.0) @ self._gains
        moments = np.asarray(self._law.rest_moment(angles, further))
        moved = self._net.points @ (shape.positions - self._net.nodes)
        values = np.zeros(len(structure.motors))
        for number, motor in enumerate(structure.motors):
            if motor.kind == "torque":
                values[number] = self._gains[number] @ angles
            elif motor.kind == "rest-angle":
                values[number] = -self._gains[number] @ moments
            elif motor.direction is not None:
                vectors = slope if motor.kind == "displacement" else moved
                values[number] = np.sum(vectors[list(motor.points)] @ motor.direction)
        return values

    def short_of_goal(self, state: _NetState) -> float:
        if self._load.goal.kind != "bounds":
            return np.inf
        return distance_to_goal(goal_values(self._structure, self._net, state.shape), self._load.goal)

    def shape(self, state: _NetState) -> RestShape:
        structure, shape, (origins, frames) = self._structure, state.shape, self._built
        origins, frames = origins.copy(), frames.copy()
        for body, first in enumerate(self._first):
            built, moved = (places[first : first + 4] for places in (self._net.nodes, shape.positions))
            # bars between the nodes are stretched slightly
            turn = _nearest_rotation((moved[1:] - moved[0]).T @ np.linalg.inv((built[1:] - built[0]).T))
            origins[body] = moved[0] + turn @ (origins[body] - built[0])
            frames[body] = turn @ frames[body]
        points = point_positions(self._net, shape)[: len(structure.points)]
        for number, point in enumerate(() if self._first else structure.points):
            if point.body != GROUND:
                origins[point.body] = points[number]
        return RestShape(
            angles=own_angles(structure, shape),
            points=points,
            origins=origins,
            frames=frames,
            memory=own_memory(structure, shape),
        )


def _nearest_rotation(matrix: Array) -> Array:
    """Return the rotation nearest to a matrix, (3, 3)."""
    left, _, right = np.linalg.svd(matrix)
    return np.asarray(left @ np.diag([1.0, 1.0, np.linalg.det(left @ right)]) @ right)
