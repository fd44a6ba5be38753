"""Start states of structures in the engine: positions, angles and permanent folds of creases, and yielded parts."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import mujoco
import numpy as np
from mujoco.batch import Batch

from forficula.arrays import Array

if TYPE_CHECKING:
    from forficula.dynamics.engine.model import Model


def start_states(models: Sequence[Model]) -> Array:
    """Return the start states of structures, (structure, number)."""
    batch = Batch(models[0].engine, len(models), 1)
    batch.set_models([model.engine for model in models])
    batch.bind("qpos")[:] = [start_position(model) for model in models]
    if batch.model.nplastic:
        batch.bind("plastic")[:] = [_start_creep(model) for model in models]
    return np.array(batch.state)


def start_position(model: Model) -> Array:
    """Return the positions at the start; sliding bodies start in the built shape."""
    position = np.array(model.engine.qpos0)
    for hinge, place in zip(model.structure.hinges, model.folds.joints.tolist(), strict=True):
        if place >= 0:
            position[place] = hinge.sense * hinge.start + 0.0  # -0 would be another bit
    return position


def start_creases(model: Model) -> Array:
    """Return the start angles of creases, rad, (crease,)."""
    return np.array([model.structure.hinges[number].start for number in model.folds.creases])


def start_folds(model: Model) -> Array:
    """Return the permanent folds of creases at the start, rad, (crease,): some start beyond their yield angle."""
    start = start_creases(model)
    unfolded = np.zeros_like(start)
    return unfolded if model.creases is None else model.creases.law.next_set(start, 0.0, unfolded)


def _start_creep(model: Model) -> Array:
    """Return the plastic state at the start: a tendon or joint that the start stretches too far has already yielded."""
    engine = model.engine
    data = mujoco.MjData(engine)
    data.qpos[:] = start_position(model)
    mujoco.mj_forward(engine, data)
    plastic = np.asarray(data.plastic.copy())
    for tendon, place, creep in zip(model.in_units.tendons, model.tendons, model.creep, strict=True):
        if tendon.law.yield_extension is not None:
            plastic[creep] = max(tendon.law.rest_length, data.ten_length[place] - tendon.law.yield_extension)
    for hinge, creep in zip(model.in_units.hinges, model.hinge_creep, strict=True):
        if creep >= 0:
            turned = hinge.start - hinge.rest_angle
            beyond = turned - max(-hinge.yield_angle, min(turned, hinge.yield_angle))
            plastic[creep] = hinge.sense * (hinge.rest_angle + beyond)
    return plastic
