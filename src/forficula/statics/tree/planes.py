"""Energy of the springs that keep points of a tree above or on planes, with its derivatives by the hinges' angles."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array
from forficula.statics.planes import Planes, planes_of
from forficula.statics.tree.elements import Expansion
from forficula.statics.tree.pose import Carried, Pose, Tree, carried_points, moves_of, places_of, pose, pulled
from forficula.structure import Structure

_SOFTER = 1e-3  # stiffness of the springs on the way to an equilibrium, divided by that at rest


@dataclass(frozen=True, kw_only=True)
class TreePlanes:
    """Planes of a tree: its table, and supports of its points.

    Attributes:
        tree: of bodies.
        planes: with the points of bodies that move.
        points: the same points.
    """

    tree: Tree
    planes: Planes
    points: Carried

    @property
    def softened(self) -> TreePlanes:
        """Return the planes with softer springs, with which the search for an equilibrium begins."""
        return replace(self, planes=replace(self.planes, stiffness=_SOFTER * self.planes.stiffness))


def tree_planes(structure: Structure, tree: Tree) -> TreePlanes | None:
    """Return the planes of a tree; None without any.

    Raises:
        InputError: a part starts below the table.
    """
    moving = {number for number in range(len(structure.bodies)) if tree.chain(number)}
    planes = planes_of(structure, moving)
    if planes is None:
        return None
    result = TreePlanes(tree=tree, planes=planes, points=carried_points(tree, planes.bodies, planes.places))
    start = np.array([[hinge.start for hinge in structure.hinges[: tree.size]]])
    planes.refuse_start(structure, _positions(result, pose(tree, start))[0])
    return result


def _positions(planes: TreePlanes, at: Pose) -> Array:
    """Return the positions of the points, m, (case, plane, 3)."""
    return places_of(planes.points, at).transpose(1, 2, 0)


def plane_energy(planes: TreePlanes, angles: Array, at: Pose | None = None) -> Expansion:
    """Compute the energy of the springs of planes; it vanishes as these are made stiffer.

    Args:
        planes: of the tree.
        angles: of all hinges, in their own senses, rad, (case, hinge).
        at: pose of the tree at these angles; computed by default.

    Returns:
        Energy, J, (case,); gradient, N m, (case, hinge), and Hessian, N m/rad, (case, hinge, hinge), by the angles.
    """
    tree, size, stiffness = planes.tree, planes.tree.size, planes.planes.stiffness
    at = pose(tree, angles) if at is None else at
    places = places_of(planes.points, at)
    depths = planes.planes.depths(places.transpose(1, 2, 0))
    if not depths.any() and not planes.planes.fixed.any():
        return np.zeros(len(angles)), np.zeros((len(angles), size)), np.zeros((len(angles), size, size))
    push = -stiffness * depths
    normals = planes.planes.normals.T
    slope, curvature = pulled(tree, planes.points, at, places, normals[:, None] * push)
    points, hinges = planes.points.pairs
    rises = np.zeros((len(angles), depths.shape[1], size))
    moves = moves_of(planes.points, at, places)
    rises[:, points, hinges] = np.einsum("icq,iq->cq", moves, normals[:, points])
    rises *= planes.planes.active(depths)[:, :, None]
    curvature += stiffness * (rises.transpose(0, 2, 1) @ rises)
    return stiffness / 2 * np.sum(depths**2, axis=1), slope, curvature


def table_forces(planes: TreePlanes | None, angles: Array) -> list[dict[str, float]]:
    """Return the force between each body that touches a table and the table, N, by the names of both, (case,).

    Args:
        planes: of the tree; None for none.
        angles: of all hinges, in their own senses, rad, (case, hinge), at equilibrium.
    """
    if planes is None:
        return [{} for _ in angles]
    depths = planes.planes.depths(_positions(planes, pose(planes.tree, angles)))
    return [planes.planes.table_forces(row) for row in depths]
