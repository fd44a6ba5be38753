"""The energy of a structure's weight, with its slopes and curvatures by the hinges' angles."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.statics.elements import Expansion
from forficula.statics.pose import Carried, Tree, carried_points, places_of, pose, pulled
from forficula.structure import Structure, mass_of


@dataclass(frozen=True, kw_only=True)
class Weight:
    """Weights at the centres of mass of the bodies that move.

    Attributes:
        tree: of bodies.
        centres: of mass.
        forces: weights along -z, N, (centre,).
    """

    tree: Tree
    centres: Carried
    forces: Array


def weight_of(structure: Structure, tree: Tree) -> Weight | None:
    """What a structure weighs; None where there is no gravity, or nothing that has a mass moves."""
    moving = [number for number in range(len(structure.bodies)) if tree.chain(number)] if structure.gravity else []
    masses = {number: mass_of(structure, number) for number in moving}
    solid = [number for number, (mass, _, _) in masses.items() if mass]
    if not solid:
        return None
    return Weight(
        tree=tree,
        centres=carried_points(tree, solid, np.array([masses[number][1] for number in solid])),
        forces=structure.gravity * np.array([masses[number][0] for number in solid]),
    )


def weight_energy(weight: Weight, angles: Array) -> Expansion:
    """Energy of the weight, 0 where all centres are at z = 0.

    Args:
        weight: of the bodies.
        angles: of all hinges, in their own senses, rad, (case, hinge).

    Returns:
        J, (case,); by the angles, N m, (case, hinge), and N m/rad, (case, hinge, hinge).
    """
    at = pose(weight.tree, angles)
    places = places_of(weight.centres, at)
    forces = np.zeros_like(places)
    forces[2] = weight.forces
    return places[2] @ weight.forces, *pulled(weight.tree, weight.centres, at, places, forces)
