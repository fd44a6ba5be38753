"""Planes that points of a structure do not leave: the table under spheres of its parts, and supports of single points.

Both solvers replace these constraints by stiff springs. A structure sinks into a table by a millionth of its size, and
its angles, forces and energies deviate by similar shares from those on a rigid table.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Flags
from forficula.structure import GROUND, Structure, built_points, mass_of, refuse_below_table, touching_points

# depth to which a structure sinks into a table under its weight, its springs or its drives, as a share of its size
SUNK = 1e-6
_QUARTER = np.pi / 2  # rad, turn of a hinge whose spring presses on the table


@dataclass(frozen=True, kw_only=True, eq=False)
class Planes:
    """Planes, each with the point of a body that stays above it or on it.

    Attributes:
        bodies: numbers of the bodies that carry the points, (plane,).
        places: of the points in the axes of these bodies, m, (plane, 3).
        names: of these bodies, (plane,).
        normals: unit vectors, (plane, 3).
        least: distance of each plane from the origin along its normal, plus the radius of a sphere at the point, m,
            (plane,).
        fixed: whether a point stays on its plane, as at a support, instead of above it, as on a table, (plane,).
        stiffness: of the springs that keep the points, N/m.
    """

    bodies: tuple[int, ...]
    places: Array
    names: tuple[str, ...]
    normals: Array
    least: Array
    fixed: Flags
    stiffness: float

    def depths(self, positions: Array) -> Array:
        """Return how far points are below their planes, m; 0 above a plane on which they need not stay.

        Args:
            positions: of the points, m, (..., plane, 3).
        """
        below = self.least - np.einsum("...pi,pi->...p", positions, self.normals)
        return np.asarray(np.where(self.fixed, below, np.maximum(below, 0.0)))

    def active(self, depths: Array) -> Flags:
        """Return which planes hold their points at some depths, m, (..., plane)."""
        return np.asarray(self.fixed | (depths > 0))

    def table_forces(self, depths: Array) -> dict[str, float]:
        """Return the force between each body that touches a table and the table, N, by the names of both.

        Args:
            depths: of the points, m, (plane,).
        """
        result: dict[str, float] = {}
        forces = np.where(self.fixed, 0.0, self.stiffness * depths)
        for name, force in zip(self.names, forces.tolist(), strict=True):
            if force > 0:
                result[f"{name} and table"] = result.get(f"{name} and table", 0.0) + force
        return result

    def refuse_start(self, structure: Structure, positions: Array) -> None:
        """Refuse a structure that starts below its table, with points at positions, m, (plane, 3).

        Raises:
            InputError: a part is below the table; the message gives the largest height.
        """
        above = ~self.fixed
        if above.any():
            assert structure.table is not None
            gaps = np.einsum("pi,pi->p", positions, self.normals) - self.least
            refuse_below_table(structure, float(gaps[above].min()) + structure.table.height)


def planes_of(structure: Structure, moving: Collection[int] | None = None) -> Planes | None:
    """Return the planes of a structure with a table or with supports of points; None if no plane holds any point.

    Args:
        structure: the structure.
        moving: numbers of the bodies whose points count; None for all bodies.
    """
    up, built = -np.array(structure.down), built_points(structure)
    rows = [
        (point.body, point.place, up, structure.table.height + point.radius, False)
        for point in (touching_points(structure) if structure.table is not None else ())
        if structure.table is not None
    ]
    for hold in structure.holds:
        point = structure.points[hold.point]
        rows.append((point.body, point.place, hold.axis, float(built[hold.point] @ hold.axis), True))
    rows = [row for row in rows if row[0] != GROUND and (moving is None or row[0] in moving)]
    if not rows:
        return None
    bodies, places, normals, least, fixed = zip(*rows, strict=True)
    return Planes(
        bodies=bodies,
        places=np.array(places),
        names=tuple(structure.bodies[body].label for body in bodies),
        normals=np.array(normals),
        least=np.array(least),
        fixed=np.array(fixed, dtype=np.bool_),
        stiffness=_pressing_force(structure) / (SUNK * structure.span),
    )


def _pressing_force(structure: Structure) -> float:
    """Return the order of magnitude of the largest force with which a structure presses on a table, N.

    Hinges and tendons press with their energy divided by the size of the structure.
    """
    bodies = range(len(structure.bodies))
    mass = sum(body.mass for body in structure.bodies) + sum(mass_of(structure, number)[0] for number in bodies)
    stored = sum(hinge.stiffness for hinge in structure.hinges) * _QUARTER**2 / 2
    stored += sum(float(tendon.law.elastic.energy(tendon.longest)) for tendon in structure.tendons)
    drives = [
        sum(
            abs(strength) * (len(motor.points) if motor.kind == "force" else 1 / structure.span)
            for strength, motor in zip(drive.strengths, structure.motors, strict=True)
            if motor.kind in ("torque", "force")
        )
        for drive in structure.drives
    ]
    return max(abs(structure.gravity) * mass, stored / structure.span, *drives, 0.0) or 1.0


def table_friction_remarks(structure: Structure) -> tuple[str, ...]:
    """Return a remark on the friction of a table, which statics ignores; none without friction."""
    if structure.table is None or not structure.table.friction:
        return ()
    return (
        f"statics ignores friction on the table (table.friction = {structure.table.friction:g}), which holds the"
        f" {structure.appearance.whole} in further shapes",
    )
