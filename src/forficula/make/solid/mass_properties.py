"""Mass, centre and inertia of solids, from their surface triangles."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.make.part import Part
from forficula.make.solid.mesh import MILLIMETRES, Mesh, mesh_of


@dataclass(frozen=True, kw_only=True, eq=False)
class MassProperties:
    """Mass properties of a solid, or of several that move together.

    Attributes:
        mass: kg.
        centre: centre of mass, m, (3,).
        inertia: about the centre, kg m^2, (3, 3).
    """

    mass: float
    centre: Array
    inertia: Array

    def about(self, axis: Array, origin: Array) -> float:
        """Return the inertia, kg m^2, about an axis, a unit vector, through a point, m, (3,) (Huygens and Steiner)."""
        away = np.cross(axis, self.centre - origin)
        return float(axis @ self.inertia @ axis + self.mass * away @ away)


def mesh_properties(mesh: Mesh, density: float) -> MassProperties:
    """Return mass, centre and inertia of the volume that triangles enclose, exact up to rounding.

    By the divergence theorem they are sums over the tetrahedra that triangles form with any point, here the mean of the
    points: for corners a, b, c the volume is V = a . (b x c) / 6, the first moment V (a + b + c) / 4, and the second
    V / 20 ((a + b + c) (a + b + c)' + a a' + b b' + c c').

    Args:
        mesh: closed, its triangles counterclockwise seen from outside.
        density: kg/m^3.
    """
    middle = mesh.points.mean(axis=0)
    corners = (mesh.points - middle)[mesh.triangles] / MILLIMETRES
    volumes = np.sum(corners[:, 0] * np.cross(corners[:, 1], corners[:, 2]), axis=1) / 6
    total, sums = float(volumes.sum()), corners.sum(axis=1)
    first = volumes @ sums / 4
    second = np.einsum("t,ti,tj->ij", volumes / 20, sums, sums)
    second += np.einsum("t,tki,tkj->ij", volumes / 20, corners, corners)
    mean = first / total
    spread = second - total * np.outer(mean, mean)
    return MassProperties(
        mass=density * total,
        centre=middle / MILLIMETRES + mean,
        inertia=density * (np.trace(spread) * np.eye(3) - spread),
    )


def parts_properties(parts: Sequence[Part]) -> MassProperties:
    """Return mass, centre and inertia of parts together, in their built positions.

    Raises:
        InputError: no parts, or a material whose sources give no density.
    """
    solids = []
    for part in parts:
        if part.stock.density is None:
            raise InputError(
                f"{part.name}: needs a density for its mass, but the sources of {part.stock.name} give none; give its"
                ' material a fact "density"'
            )
        solids.append(mesh_properties(mesh_of(part.shape), part.stock.density))
    if not solids:
        raise InputError("need one part or more, got none")
    mass = sum(solid.mass for solid in solids)
    centre = np.sum([solid.mass * solid.centre for solid in solids], axis=0) / mass
    inertia = np.zeros((3, 3))
    for solid in solids:
        away = solid.centre - centre
        inertia += solid.inertia + solid.mass * (away @ away * np.eye(3) - np.outer(away, away))
    return MassProperties(mass=mass, centre=centre, inertia=inertia)
