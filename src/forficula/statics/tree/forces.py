"""Forces at points of a tree, set by motors: their potential by the angles of the hinges."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.statics.tree.elements import Expansion
from forficula.statics.tree.pose import Carried, Tree, carried_points, places_of, pose, pulled
from forficula.structure import Structure


@dataclass(frozen=True, kw_only=True)
class PointForces:
    """Points that motors push along fixed directions.

    Attributes:
        tree: of bodies.
        points: that are pushed, one motor after another.
        directions: weights with which settings of motors add up to forces on points, (motor, 3 x point).
    """

    tree: Tree
    points: Carried
    directions: Array


def point_forces_of(structure: Structure, tree: Tree) -> PointForces | None:
    """Return the forces that motors exert at points of a structure; None without such motors."""
    pushed = [
        (number, structure.points[point], motor.direction)
        for number, motor in enumerate(structure.motors)
        if motor.kind == "force"
        for point in motor.points
    ]
    if not pushed:
        return None
    directions = np.zeros((len(structure.motors), 3, len(pushed)))
    for place, (number, _, direction) in enumerate(pushed):
        assert direction is not None  # a force has a direction
        directions[number, :, place] = direction
    return PointForces(
        tree=tree,
        points=carried_points(
            tree, [point.body for _, point, _ in pushed], np.array([point.place for _, point, _ in pushed])
        ),
        directions=directions.reshape(len(structure.motors), -1),
    )


def force_energy(forces: PointForces, angles: Array, settings: Array) -> Expansion:
    """Compute the potential of the forces, which is 0 if all pushed points are at the origin.

    Args:
        forces: on points.
        angles: of all hinges, in their own senses, rad, (case, hinge).
        settings: of every motor, N, (case, motor).

    Returns:
        Energy, J, (case,); gradient, N m, (case, hinge), and Hessian, N m/rad, (case, hinge, hinge), by the angles.
    """
    at = pose(forces.tree, angles)
    places = places_of(forces.points, at)
    pulls = -(settings @ forces.directions).reshape(len(angles), 3, -1).transpose(1, 0, 2)
    return np.sum(pulls * places, axis=(0, 2)), *pulled(forces.tree, forces.points, at, places, pulls)
