"""Energy of the weight of the bodies of a tree, with its derivatives by the angles of the hinges."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.statics.tree.elements import Expansion
from forficula.statics.tree.pose import Carried, Pose, Tree, carried_points, places_of, pose, pulled
from forficula.structure import Structure, mass_of


@dataclass(frozen=True, kw_only=True)
class Weight:
    """Weights at the centres of mass of the bodies that move.

    Attributes:
        tree: of bodies.
        centres: of mass.
        forces: weights, N, (centre,).
        down: unit vector along them, (3,).
    """

    tree: Tree
    centres: Carried
    forces: Array
    down: Array


def weight_of(structure: Structure, tree: Tree) -> Weight | None:
    """Return the weight of a structure; None without gravity, or if no part with mass moves."""
    moving = [number for number in range(len(structure.bodies)) if tree.chain(number)] if structure.gravity else []
    masses = {number: mass_of(structure, number) for number in moving}
    solid = [number for number, (mass, _, _) in masses.items() if mass]
    if not solid:
        return None
    return Weight(
        tree=tree,
        centres=carried_points(tree, solid, np.array([masses[number][1] for number in solid])),
        forces=structure.gravity * np.array([masses[number][0] for number in solid]),
        down=np.array(structure.down),
    )


def weight_energy(weight: Weight, angles: Array, at: Pose | None = None) -> Expansion:
    """Compute the energy of the weight, 0 if all centres are at the height of the origin.

    Args:
        weight: of the bodies.
        angles: of all hinges, in their own senses, rad, (case, hinge).
        at: pose of the tree at these angles; computed by default.

    Returns:
        Energy, J, (case,); gradient, N m, (case, hinge), and Hessian, N m/rad, (case, hinge, hinge), by the angles.
    """
    at = pose(weight.tree, angles) if at is None else at
    places = places_of(weight.centres, at)
    up = -weight.down
    forces = np.multiply.outer(up, np.broadcast_to(weight.forces, places.shape[1:]))
    return np.tensordot(up, places, 1) @ weight.forces, *pulled(weight.tree, weight.centres, at, places, forces)
