"""Steps of structures whose facets, plates and bars may touch."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from mujoco.batch import Batch

from forficula.arrays import Array, Indices
from forficula.dynamics.engine.contact_forces import ContactForces
from forficula.dynamics.stepping.rollout import Rollout, block_memory
from forficula.dynamics.stepping.steps import MOVING, StepContacts


def contact_steps(
    rollout: Rollout,
    contact: ContactForces,
    engine: Batch,
    rows: Indices,
    state: Array,
    controls: Array,
    memory: Mapping[str | int, Array],
    late: Mapping[str, Array],
    contacts: StepContacts,
    block: slice,
) -> None:
    """Take a block of steps of structures whose parts may touch, step by step where they do."""
    drag, begun = state[:, rollout.applied], block.start
    contacts.friction_springs[:, begun] = contact.friction_springs[rows]
    while begun < block.stop:
        position, velocity = rollout.motion(state)
        forces, overlaps, count = contact.forces(rows, position, velocity)
        state[:, rollout.applied] = drag + forces
        count = min(count, block.stop - begun)
        while True:
            steps = slice(begun, begun + count)
            out = {name: block_memory(values, count) for name, values in memory.items()}
            of_late = {name: block_memory(values, count) for name, values in late.items()}
            rollout.steps(engine, rows, state, np.ascontiguousarray(controls[:, steps]), out, of_late)
            ended = out[MOVING][:, -1]
            positions = ended[:, 1 : 1 + position.shape[1]]
            if count == 1 or contact.apart(rows, positions):
                break
            # parts are faster than estimated
            count = max(1, count // 4)
        for name, values in memory.items():
            values[:, steps] = out[name]
        for field, values in late.items():
            values[:, steps] = of_late[field]
        contacts.forces[:, steps], contacts.overlaps[:, steps] = forces[:, None], overlaps[:, None]
        contacts.friction_springs[:, begun + 1 : begun + count + 1] = contact.friction_springs[rows, None]
        state[:, rollout.moving] = ended
        begun += count
    state[:, rollout.applied] = drag
