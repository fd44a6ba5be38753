"""The energy of a structure's weight, with its slopes and curvatures by the hinges' angles."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.statics.elements import Expansion
from forficula.statics.pose import Carried, Tree, carried_points, places_of, pose, pulled
from forficula.structure import Structure, body_masses

Array = NDArray[np.float64]


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
    solid = [
        (number, mass)
        for number, mass in enumerate(body_masses(structure))
        if structure.gravity and mass is not None and tree.chain(number)
    ]
    if not solid:
        return None
    return Weight(
        tree=tree,
        centres=carried_points(tree, [number for number, _ in solid], np.array([mass.centre for _, mass in solid])),
        forces=structure.gravity * np.array([mass.mass for _, mass in solid]),
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
