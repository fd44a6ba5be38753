"""Energy of a table under the bodies of a tree, with its derivatives by the angles of the hinges, and its forces."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array
from forficula.statics.table import forces_by_body, table_stiffness
from forficula.statics.tree.elements import Expansion
from forficula.statics.tree.pose import Carried, Pose, Tree, carried_points, moves_of, places_of, pose, pulled
from forficula.structure import Structure, refuse_below_table, touching_points

_SOFTER = 1e-3  # stiffness of the springs of a table on the way to an equilibrium, divided by that at rest


@dataclass(frozen=True, kw_only=True)
class TreeTable:
    """A table under a tree: a stiff spring pushes each sphere back that sinks into it.

    Attributes:
        tree: of bodies.
        spheres: centres of the spheres of the bodies that move.
        names: of the bodies that carry them, (sphere,).
        least: height of each centre above the origin at which its sphere touches the table, m, (sphere,).
        up: unit vector against gravity, (3,).
        stiffness: of the spring of a sphere, N/m.
    """

    tree: Tree
    spheres: Carried
    names: tuple[str, ...]
    least: Array
    up: Array
    stiffness: float

    @property
    def softened(self) -> TreeTable:
        """Return the table with softer springs, for the way to an equilibrium."""
        return replace(self, stiffness=_SOFTER * self.stiffness)


def tree_table(structure: Structure, tree: Tree) -> TreeTable | None:
    """Return the table under a tree; None without a table, or if no part that moves has a thickness or corners.

    Raises:
        InputError: a part starts below the table.
    """
    if structure.table is None:
        return None
    points = [point for point in touching_points(structure) if tree.chain(point.body)]
    if not points:
        return None
    radii = np.array([point.radius for point in points])
    table = TreeTable(
        tree=tree,
        spheres=carried_points(tree, [point.body for point in points], np.array([point.place for point in points])),
        names=tuple(structure.bodies[point.body].label for point in points),
        least=structure.table.height + radii,
        up=-np.array(structure.down),
        stiffness=table_stiffness(structure),
    )
    start = np.array([[hinge.start for hinge in structure.hinges[: tree.size]]])
    heights = table.up @ places_of(table.spheres, pose(tree, start))[:, 0] - radii
    refuse_below_table(structure, float(heights.min()))
    return table


def table_energy(table: TreeTable, angles: Array, at: Pose | None = None) -> Expansion:
    """Compute the energy of the springs of a table; it vanishes as these are made stiffer.

    Args:
        table: under the bodies.
        angles: of all hinges, in their own senses, rad, (case, hinge).
        at: pose of the tree at these angles; computed by default.

    Returns:
        Energy, J, (case,); gradient, N m, (case, hinge), and Hessian, N m/rad, (case, hinge, hinge), by the angles.
    """
    at = pose(table.tree, angles) if at is None else at
    places = places_of(table.spheres, at)
    sunk = np.maximum(table.least - np.tensordot(table.up, places, 1), 0.0)
    size = table.tree.size
    if not sunk.any():
        return np.zeros(len(angles)), np.zeros((len(angles), size)), np.zeros((len(angles), size, size))
    push = -table.stiffness * sunk
    slope, curvature = pulled(table.tree, table.spheres, at, places, np.multiply.outer(table.up, push))
    points, hinges = table.spheres.pairs
    rises = np.zeros((len(angles), len(table.least), size))
    rises[:, points, hinges] = np.tensordot(table.up, moves_of(table.spheres, at, places), 1)
    rises *= (sunk > 0)[:, :, None]
    curvature += table.stiffness * (rises.transpose(0, 2, 1) @ rises)
    return table.stiffness / 2 * np.sum(sunk**2, axis=1), slope, curvature


def table_forces(table: TreeTable | None, angles: Array) -> list[dict[str, float]]:
    """Return the force between each body that touches the table and the table, N, by the names of both, (case,).

    Args:
        table: under the bodies; None for none.
        angles: of all hinges, in their own senses, rad, (case, hinge), at equilibrium.
    """
    if table is None:
        return [{} for _ in angles]
    places = places_of(table.spheres, pose(table.tree, angles))
    forces = table.stiffness * np.maximum(table.least - np.tensordot(table.up, places, 1), 0.0)
    return [forces_by_body(table.names, row) for row in forces.tolist()]
