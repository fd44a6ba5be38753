"""Equilibria of a net under a load that grows evenly, for a quasi-static stage of a run.

Nodes are at sliding points, or four of them at each plate.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from forficula.arrays import Array, Flags
from forficula.errors import InputError
from forficula.statics.net.driven.driven_net import goal_values
from forficula.statics.net.energy import expand, moved_shape, shape_at
from forficula.statics.net.load import Load
from forficula.statics.net.minimum import minimum
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.net_of import motor_load, net_of, own_angles, own_sets, point_positions, valley_angles
from forficula.statics.net.plate_nodes import plate_nodes, posed_nodes
from forficula.statics.rest_path import rest_path
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


class _LoadedNet:
    """A net under a load; its states are the shapes of the net."""

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
        self._net: Net = replace(net, free=held)
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
    def prescribes(self) -> Flags:
        return np.array([motor.kind in ("displacement", "rest-angle") for motor in self._structure.motors])

    def state(self, start: RestShape) -> NetShape:
        """Return the state of a shape."""
        positions = start.points
        if self._structure.plates:
            positions = posed_nodes(self._structure, self._net.nodes, self._first, start.origins, start.frames)
        sets = None if start.sets is None else valley_angles(self._structure, start.sets)
        return shape_at(self._net, positions, valley_angles(self._structure, start.angles), sets)

    def rest(self, share: float, near: NetShape) -> NetShape | None:
        load = self._motor_load(self._load.settings(share))
        positions = near.positions
        if self._displaced.any():
            moved = self._motor_load(self._load.settings(share) - self._load.before).displacements
            positions = np.where(self._displaced, self._load.built_on + moved, positions)
        start = moved_shape(self._net, near, positions)

        def is_far(shape: NetShape) -> bool:
            return bool(np.abs(shape.positions - near.positions).max() > _NEAR * self._net.size)

        rest = minimum(self._net, start, load, 1.0, stop=is_far)
        return rest.shape if rest.stable and not is_far(rest.shape) else None

    def _motor_load(self, settings: Array) -> Load:
        return motor_load(self._structure, self._net, tuple(settings.tolist()))

    def creep(self, _share: float, _start: NetShape) -> None:
        """Return no creep: dampers between nodes are not a part of the net."""
        return

    def yield_loss(self, before: NetShape, after: NetShape) -> float:
        law = self._net.creases.law
        if not law.yields:
            return 0.0
        sets = [np.zeros_like(shape.angles) if shape.sets is None else shape.sets for shape in (before, after)]
        return float(law.yield_loss(sets[1] - sets[0]).sum())

    def middle(self, one: NetShape, other: NetShape) -> NetShape:
        return moved_shape(self._net, one, (one.positions + other.positions) / 2)

    def conjugates(self, share: float, state: NetShape) -> Array:
        structure, settings = self._structure, self._load.settings(share)
        angles = own_angles(structure, state)
        slope = expand(self._net, state, self._motor_load(settings), 1.0).slope
        further = np.where([motor.kind == "rest-angle" for motor in structure.motors], settings, 0.0) @ self._gains
        moments = np.asarray(self._law.rest_moment(angles, further))
        moved = self._net.points @ (state.positions - self._net.nodes)
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

    def short_of_goal(self, state: NetShape) -> float:
        if self._load.goal.kind != "bounds":
            return np.inf
        return distance_to_goal(goal_values(self._structure, self._net, state), self._load.goal)

    def shape(self, state: NetShape) -> RestShape:
        structure, (origins, frames) = self._structure, self._built
        origins, frames = origins.copy(), frames.copy()
        for body, first in enumerate(self._first):
            built, moved = (places[first : first + 4] for places in (self._net.nodes, state.positions))
            # bars between the nodes are stretched slightly
            turn = _nearest_rotation((moved[1:] - moved[0]).T @ np.linalg.inv((built[1:] - built[0]).T))
            origins[body] = moved[0] + turn @ (origins[body] - built[0])
            frames[body] = turn @ frames[body]
        points = point_positions(self._net, state)[: len(structure.points)]
        for number, point in enumerate(() if self._first else structure.points):
            if point.body != GROUND:
                origins[point.body] = points[number]
        return RestShape(
            angles=own_angles(structure, state),
            points=points,
            origins=origins,
            frames=frames,
            sets=own_sets(structure, state),
        )


def _nearest_rotation(matrix: Array) -> Array:
    """Return the rotation nearest to a matrix, (3, 3)."""
    left, _, right = np.linalg.svd(matrix)
    return np.asarray(left @ np.diag([1.0, 1.0, np.linalg.det(left @ right)]) @ right)
