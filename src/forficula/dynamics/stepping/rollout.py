"""Steps of structures in the engine, from given states and controls."""

from __future__ import annotations

import copy
from collections.abc import Mapping, Sequence

import mujoco
import numpy as np
from mujoco.batch import Batch

from forficula.arrays import Array, Indices
from forficula.dynamics.engine.model import Model
from forficula.dynamics.engine.warnings import quiet
from forficula.dynamics.stepping.steps import MOVING, STATE

_CONTROL = mujoco.mjtState.mjSTATE_CTRL.value


class Rollout:
    """Structures of one topology in the engine; it loads their states and steps them.

    Attributes:
        models: the engine's models, (structure,).
        moving: indices of the changing part of a state.
        control: indices of the controls in a state.
        applied: indices of the generalised forces that Python applies, in a state.
    """

    def __init__(self, models: Sequence[Model], sparse: bool) -> None:
        """Prepare models of structures.

        Args:
            models: compiled, of one topology.
            sparse: compute no energies.
        """
        self.models = _engine_models(models, sparse)
        engine = models[0].engine
        self.moving, self.control = _columns(engine, MOVING), _columns(engine, _CONTROL)
        self.applied = _columns(engine, mujoco.mjtState.mjSTATE_QFRC_APPLIED.value)
        self._positions, self._dof = int(engine.nq), int(engine.nv)

    def steps(
        self,
        engine: Batch,
        rows: Indices,
        state: Array,
        controls: Array,
        memory: Mapping[str | int, Array],
        late: Mapping[str, Array],
    ) -> None:
        """Step structures from their states, (row, number), once for each of their controls."""
        first: dict[str, Array] = {}
        if late:
            driven = state.copy()
            driven[:, self.control] = controls[:, 0]
            first = self.fields(engine, rows, driven, list(late), mujoco.mjtStage.mjSTAGE_ACC)
        self._load(engine, rows, state)
        out: dict[str | int | mujoco.mjtState, Array] = {**memory}
        with quiet:
            engine.rollout(
                controls.shape[1],
                control=controls,
                control_spec=_CONTROL,
                record=tuple(out),
                ids=None if len(rows) == engine.nsim else np.arange(len(rows)),
                out=out,
            )
        for name, values in late.items():
            # the engine's fields are those of the last of its four stages, close to the state after the step
            values[:] = memory[name]
            memory[name][:, 0], memory[name][:, 1:] = first[name], values[:, :-1]

    def fields(
        self, engine: Batch, rows: Indices, state: Array, names: Sequence[str], stage: mujoco.mjtStage
    ) -> dict[str, Array]:
        """Compute derived fields of structures in some states, up to a stage of the engine, (row, ...)."""
        self._load(engine, rows, state)
        # the engine fills only fields that were bound before
        bound = {name: engine.bind(name) for name in names}
        with quiet:
            engine.forward(np.arange(len(rows)), stage.value)
        return {name: field[: len(rows)].copy() for name, field in bound.items()}

    def motion(self, state: Array) -> tuple[Array, Array]:
        """Return positions and velocities in some states, (row, position) and (row, velocity)."""
        moving = state[:, self.moving][:, 1:]
        return moving[:, : self._positions], moving[:, self._positions : self._positions + self._dof]

    def _load(self, engine: Batch, rows: Indices, state: Array) -> None:
        """Load structures in some states, (row, number), into an engine."""
        every = [*range(len(rows)), *[0] * (engine.nsim - len(rows))]
        engine.set_models([self.models[rows[place]] for place in every])
        engine.state[: len(rows)] = state


def block_memory(memory: Array, steps: int) -> Array:
    """Allocate memory for a block of steps, shaped like that for a chunk, (row, step, ...)."""
    return np.empty((len(memory), steps, *memory.shape[2:]), dtype=memory.dtype)


def branch_slices(engine: mujoco.MjModel) -> dict[str, slice]:
    """Return the slices of branches and of yielding tendons in the changing part of a state, by MuJoCo's names."""
    state = mujoco.mjtState
    before = state.mjSTATE_TIME.value | state.mjSTATE_QPOS.value | state.mjSTATE_QVEL.value
    first, size = mujoco.mj_stateSize(engine, before), mujoco.mj_stateSize(engine, MOVING)
    places = {"act": slice(first, first + engine.na), "plastic": slice(size - engine.nplastic, size)}
    return {name: place for name, place in places.items() if place.start < place.stop}


def _engine_models(models: Sequence[Model], sparse: bool) -> list[mujoco.MjModel]:
    """Return the engine's models: without energy if it is not recorded, and a copy for each structure with creases."""
    engines = _without_energy(models) if sparse else [model.engine for model in models]
    return [
        engine if model.creases is None else copy.copy(engine) for engine, model in zip(engines, models, strict=True)
    ]


def _columns(engine: mujoco.MjModel, part: int) -> Indices:
    """Return the indices of a part of a state."""
    every = np.arange(mujoco.mj_stateSize(engine, STATE), dtype=np.float64)
    indices = np.empty(mujoco.mj_stateSize(engine, part))
    mujoco.mj_extractState(engine, every, STATE, indices, part)
    return indices.astype(np.int64)


def _without_energy(models: Sequence[Model]) -> list[mujoco.MjModel]:
    """Return engine models that do not compute the energy of every step; nothing else depends on it."""
    bare = {id(model.engine): copy.copy(model.engine) for model in models}
    for engine in bare.values():
        engine.opt.enableflags &= ~int(mujoco.mjtEnableBit.mjENBL_ENERGY)
    return [bare[id(model.engine)] for model in models]
