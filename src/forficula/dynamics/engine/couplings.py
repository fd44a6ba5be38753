"""Couplings between joints in the engine: springs on the difference of two angles, and rigid ties."""

from __future__ import annotations

import mujoco
import numpy as np

from forficula.arrays import Array
from forficula.structure import Coupling, Structure, coupling_rows

# as hard as closures; the angle over which it hardens is MuJoCo's default, which is small compared with any turn
_IMPEDANCE = (0.999, 0.999, 1e-3, 0.5, 2.0)


def add_couplings(spec: mujoco.MjSpec, structure: Structure, timestep: float) -> None:
    """Add the couplings of a structure, in the model's units.

    An elastic coupling is a tendon whose length is its twist (MuJoCo manual, tendon/fixed). A rigid one is a constraint
    (equality/joint), which does no work except for errors of the integration.
    """
    for coupling in structure.couplings:
        if coupling.rigid:
            _add_rigid(spec, coupling, structure, timestep)
        else:
            _add_spring(spec, coupling, structure)


def coupling_energies(structure: Structure, angles: Array) -> Array:
    """Return energies of couplings, 0 for rigid ones, (..., coupling), for angles in own senses, rad, (..., hinge)."""
    built = np.array([hinge.built for hinge in structure.hinges])
    stiffness = np.array([0.0 if coupling.rigid else coupling.stiffness for coupling in structure.couplings])
    return np.asarray(stiffness / 2 * ((angles - built) @ coupling_rows(structure).T) ** 2)


def _add_spring(spec: mujoco.MjSpec, coupling: Coupling, structure: Structure) -> None:
    first, second = (structure.hinges[number] for number in coupling.hinges)
    twist = spec.add_tendon(name=coupling.name)
    twist.wrap_joint(first.name, -coupling.ratio * first.sense)
    twist.wrap_joint(second.name, float(second.sense))
    untwisted = second.built - coupling.ratio * first.built
    twist.stiffness = [coupling.stiffness, 0.0, 0.0]
    twist.springlength = [untwisted, untwisted]


def _add_rigid(spec: mujoco.MjSpec, coupling: Coupling, structure: Structure, timestep: float) -> None:
    first, second = (structure.hinges[number] for number in coupling.hinges)
    tie = spec.add_equality(
        name=coupling.name,
        type=mujoco.mjtEq.mjEQ_JOINT,
        objtype=mujoco.mjtObj.mjOBJ_JOINT,
        name1=second.name,
        name2=first.name,
        solref=[2 * timestep, 1.0],
        solimp=_IMPEDANCE,
    )
    # turns from the built shape are proportional
    data = np.zeros_like(np.asarray(tie.data))
    data[1] = second.sense * coupling.ratio * first.sense
    tie.data = data
