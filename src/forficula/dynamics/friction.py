"""Dry friction of joints in the engine, and the torques with which it acts."""

from __future__ import annotations

import numpy as np

from forficula.arrays import Array
from forficula.dynamics.model import Model

# share of the friction by which the engine's solver and this computation may differ
_ROUNDING = 1e-6


def friction_torques(model: Model, velocity: Array, acceleration: Array, constraints: Array) -> Array:
    """Compute the torques of dry friction on joints, (step, dof), in the model's units.

    The engine's friction is a damper that decelerates a joint within a time constant and whose torque is at most that
    of the friction: f = clip(-(a + b v) / R, -F, F) with b = 2 / (d T) and R = (1 - d) / d by the joint's mobility
    (MuJoCo's manual, "Computation", friction loss). The engine reports the sum of all constraints only, therefore the
    torque is computed again from the acceleration, of which it is a function.

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
    # where nothing but friction acts, the sum is the friction without the rounding of this computation
    alone = np.abs(constraints - torques) <= _ROUNDING * largest
    return np.where(alone & rough, constraints, torques)
