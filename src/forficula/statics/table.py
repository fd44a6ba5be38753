"""Table under a structure in statics: stiffness of the springs that push spheres back, names of forces, and remarks.

Both solvers replace the constraint that no sphere is below the table by a spring that only pushes. The structure sinks
by a millionth of its size, and its angles, forces and energies deviate by similar shares from those on a rigid table.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from forficula.structure import Structure, mass_of

# depth to which a structure sinks into a table under its weight, its springs or its drives, as a share of its size
SUNK = 1e-6
_QUARTER = np.pi / 2  # rad, turn of a hinge whose spring presses on the table


def table_stiffness(structure: Structure) -> float:
    """Return the stiffness of the spring between a sphere and a table, N/m."""
    return _pressing_force(structure) / (SUNK * structure.span)


def _pressing_force(structure: Structure) -> float:
    """Return the order of magnitude of the largest force with which a structure presses on its table, N.

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


def forces_by_body(names: Sequence[str], forces: Sequence[float]) -> dict[str, float]:
    """Return the force between each body that touches a table and the table, N, by the names of both.

    Args:
        names: of the bodies that carry spheres, (sphere,).
        forces: on the spheres, N, (sphere,).
    """
    result: dict[str, float] = {}
    for name, force in zip(names, forces, strict=True):
        if force > 0:
            result[f"{name} and table"] = result.get(f"{name} and table", 0.0) + force
    return result


def table_friction_remarks(structure: Structure) -> tuple[str, ...]:
    """Return a remark on the friction of a table, which statics ignores; none without friction."""
    if structure.table is None or not structure.table.friction:
        return ()
    return (
        f"statics ignores friction on the table (table.friction = {structure.table.friction:g}), which holds the"
        f" {structure.appearance.whole} in further shapes",
    )
