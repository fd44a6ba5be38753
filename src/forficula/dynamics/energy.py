"""Energies of states, and work done between them, from what the engine recorded step by step."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from forficula.dynamics.membrane import membrane_energy
from forficula.dynamics.model import WingModel
from forficula.dynamics.tendons import tendon_energy

Array = NDArray[np.float64]


def step_work(wing: WingModel, velocities: Array, forces: Mapping[str, Array]) -> dict[str, Array]:
    """Work done in each step, J.

    A step of semi-implicit Euler changes the kinetic energy by force times timestep times the mean of the velocities
    before and after it, exactly where the inertia is constant; with the later velocity alone the account would be out
    by force times the change of velocity, first order in the timestep.

    Args:
        wing: the model.
        velocities: before the first step and after each, (step + 1, dof), in the model's units.
        forces: generalised forces during each step, (step, dof), by MuJoCo's names: qfrc_actuator, qfrc_damper,
            qfrc_constraint.

    Returns:
        Arrays (step,) for the names ending in "_work" of `record.VARIABLES`.
    """
    mean = (velocities[:-1] + velocities[1:]) / 2
    travel = mean * float(wing.in_units.protocol.timestep)
    hinge_damping = np.array(wing.engine.dof_damping).reshape(wing.engine.nv, -1)[:, 0]
    # the engine takes hinge damping implicitly, at the velocity after the step
    implicit = -hinge_damping * velocities[1:]
    explicit = forces["qfrc_damper"] + hinge_damping * velocities[:-1]
    distal = np.isin(np.arange(wing.engine.nv), wing.joints[:, 3])
    by_name = {
        "proximal_work": forces["qfrc_actuator"] * ~distal,
        "distal_work": forces["qfrc_actuator"] * distal,
        "hinge_damping_work": implicit,
        "elastic_damping_work": explicit,
        "stop_work": forces["qfrc_constraint"],
    }
    return {name: wing.units.energy * np.sum(force * travel, axis=-1) for name, force in by_name.items()}


def state_series(wing: WingModel, positions: Array, derived: Mapping[str, Array]) -> dict[str, Array]:
    """What the record says of states, SI.

    Args:
        wing: the model.
        positions: (state, dof), in the model's units.
        derived: of the same states, by MuJoCo's names, in the model's units: energy, ten_length, flexvert_xpos, xpos,
            xipos, site_xpos.

    Returns:
        Arrays (state, ...) for the names of `record.VARIABLES` that are neither power nor work.
    """
    units, law = wing.units, wing.in_units.tendon
    # a hinge that a fixed base lacks has index -1 and reads the 0 at the end
    joints = np.concatenate([positions, np.zeros((len(positions), 1))], axis=1)[:, wing.joints]
    sweep, lift, turn, fold = np.moveaxis(joints, -1, 0)
    length = derived["ten_length"][:, wing.tendons]
    places = derived["xpos"][:, wing.bodies]
    tips = derived["site_xpos"][:, wing.tips]
    height = np.sum(wing.engine.body_mass * derived["xipos"][..., 2], axis=-1)
    return {
        "sweep_angle": sweep,
        "lift_angle": lift,
        "turn_angle": wing.senses * turn,
        "distal_angle": wing.senses * fold,
        "tendon_length": units.length * length,
        "tendon_energy": units.energy * tendon_energy(length, law.stiffness, law.rest_length),
        "membrane_energy": units.energy * membrane_energy(derived["flexvert_xpos"], wing.membrane, wing.in_units),
        "kinetic_energy": units.energy * derived["energy"][:, 1],
        "gravitational_energy": units.energy * wing.in_units.protocol.gravity * height,
        "vein_position": units.length * np.concatenate([places, tips[:, :, None]], axis=2),
        "membrane_position": units.length * derived["flexvert_xpos"],
    }
