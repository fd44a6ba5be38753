"""Forces of stops apart from those of contacts, which the engine adds up: it tells them by sensors."""

from __future__ import annotations

from collections.abc import Mapping

import mujoco
import numpy as np

from forficula.arrays import Array
from forficula.dynamics.model import Model, joint_ranges


def stop_forces(model: Model, position: Array, derived: Mapping[str, Array]) -> Array:
    """Forces of the stops of hinges and of length limits on the joints, (step, dof), in the model's units.

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
            # at most one of its two stops pushes, the nearer one
            nearer = position[:, place] - low[place] < high[place] - position[:, place]
            forces[:, engine.jnt_dofadr[part]] += np.where(nearer, 1, -1) * sensed[:, column]
        else:
            # a length has no lower limit
            entries, dofs = model.levers(int(part))
            forces[:, dofs] -= sensed[:, column, None] * derived["ten_J"][:, entries]
    return forces
