"""Start states of structures in the engine: positions, angles and permanent folds of creases, and yielded parts."""

from __future__ import annotations

from collections.abc import Sequence

import mujoco
import numpy as np
from mujoco.batch import Batch

from forficula.arrays import Array
from forficula.dynamics.engine.model import Model
from forficula.dynamics.stepping.folds import start_of
from forficula.material.law.crease_memory import start_memory


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
    return start_of(model.engine, model.structure, model.folds)


def start_creases(model: Model) -> Array:
    """Return the start angles of followed creases, rad, (crease,)."""
    return np.array([model.structure.hinges[number].start for number in model.followed_hinges])


def start_crease_memory(model: Model) -> Array:
    """Return the memory of followed creases at the start, (slot, crease): some start beyond their yield angle."""
    start = start_creases(model)
    return np.zeros((1, len(start))) if model.creases is None else start_memory(model.creases.law, start)


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
