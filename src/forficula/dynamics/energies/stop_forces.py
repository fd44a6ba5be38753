"""Forces of stops, separated from those of contacts by sensors, and torques of dry friction."""

from __future__ import annotations

from collections.abc import Mapping

import mujoco
import numpy as np

from forficula.arrays import Array
from forficula.dynamics.engine.model import Model, joint_ranges

# share of the friction by which the engine's solver and this computation may differ
_ROUNDING = 1e-6


def stop_forces(model: Model, position: Array, derived: Mapping[str, Array]) -> Array:
    """Compute the forces of hinge stops and length limits on the joints, (step, dof), in the model's units.

    Args:
        model: with contacts.
        position: before each step, (step, position).
        derived: sensordata and ten_J before each step.
    """
    engine, sensed = model.engine, derived["sensordata"]
    forces = np.zeros((len(position), engine.nv))
    low, high = joint_ranges(model)
    for column, (kind, part) in enumerate(zip(engine.sensor_type, engine.sensor_objid, strict=True)):
        if kind == mujoco.mjtSensor.mjSENS_JOINTLIMITFRC:
            place = engine.jnt_qposadr[part]
            # only the nearer one of both stops can push
            nearer = position[:, place] - low[place] < high[place] - position[:, place]
            forces[:, engine.jnt_dofadr[part]] += np.where(nearer, 1, -1) * sensed[:, column]
        else:
            # a length has no lower limit
            entries, dofs = model.levers(int(part))
            forces[:, dofs] -= sensed[:, column, None] * derived["ten_J"][:, entries]
    return forces


def friction_torques(model: Model, velocity: Array, acceleration: Array, constraints: Array) -> Array:
    """Compute the torques of dry friction on joints, (step, dof), in the model's units.

    The engine's friction is a damper that decelerates a joint within a time constant and whose torque is at most that
    of the friction: f = clip(-(a + b v) / R, -F, F) with b = 2 / (d T) and R = (1 - d) / d times the joint's mobility
    (MuJoCo's manual, "Computation", friction loss). Because the engine reports only the sum of all constraints, the
    torque is computed again from the acceleration.

    Args:
        model: in which some joints have friction.
        velocity: before each step, (step, dof).
        acceleration: at the start of each step, constraints included, (step, dof).
        constraints: sum of the torques of friction and of all other constraints, (step, dof).
    """
    engine = model.engine
    impedance = engine.dof_solimp[:, 0]
    rate = 2 / (engine.dof_solimp[:, 1] * np.maximum(engine.dof_solref[:, 0], 2 * model.timestep))
    yielding = (1 - impedance) / impedance * engine.dof_invweight0
    largest = np.asarray(engine.dof_frictionloss)
    torques = np.zeros_like(velocity)
    rough = largest > 0
    torques[:, rough] = np.clip(
        -(acceleration[:, rough] + rate[rough] * velocity[:, rough]) / yielding[rough], -largest[rough], largest[rough]
    )
    # if only friction acts, the engine's sum is the friction without the rounding of this computation
    alone = np.abs(constraints - torques) <= _ROUNDING * largest
    return np.where(alone & rough, constraints, torques)
