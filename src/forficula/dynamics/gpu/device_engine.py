"""Engine that steps many structures side by side on a device, in single precision."""

from __future__ import annotations

import copy
from collections.abc import Mapping, Sequence
from typing import Any

import mujoco
import numpy as np
import warp as wp
from numpy.typing import NDArray

from forficula.arrays import Array, Indices
from forficula.dynamics.engine.model import Model
from forficula.dynamics.gpu import kernels
from forficula.dynamics.gpu.device import device_name, varying_fields, warp_engine
from forficula.dynamics.gpu.device_steps import DeviceSteps, DeviceValues
from forficula.errors import InputError

# the parts of a state that a step changes, in the engine's order, by the names of its data
_PARTS = {
    "time": mujoco.mjtState.mjSTATE_TIME,
    "qpos": mujoco.mjtState.mjSTATE_QPOS,
    "qvel": mujoco.mjtState.mjSTATE_QVEL,
    "act": mujoco.mjtState.mjSTATE_ACT,
    "qacc_warmstart": mujoco.mjtState.mjSTATE_WARMSTART,
    "plastic": mujoco.mjtState.mjSTATE_PLASTIC,
}
# largest number of degrees of freedom for which the engine has dense matrices on a device
_DENSE = 60
_FLOAT = 4  # bytes


class DeviceEngine:
    """Models and data of structures on a device.

    The first world is the first structure that still moves, and so on: worlds change when a structure is done.
    """

    def __init__(
        self, models: Sequence[Model], engines: Sequence[mujoco.MjModel], names: Sequence[str], chunk: int
    ) -> None:
        """Put the models on the device.

        Args:
            models: of structures that share what cannot differ on a device, see `device.batch_key`.
            engines: the engine's models of these structures.
            names: derived fields to keep for every step.
            chunk: number of steps at a time.

        Raises:
            InputError: MuJoCo Warp rejects the models, or there is no such device.
        """
        device = models[0].design.protocol.device
        assert device is not None
        self._warp, self._chunk = warp_engine(), chunk
        self._device = wp.get_device(device_name(device))
        self._engine = engine = copy.copy(engines[0])
        # nothing on a device resets a structure that diverged, but MuJoCo Warp refuses the request not to
        engine.opt.disableflags &= ~int(mujoco.mjtDisableBit.mjDSBL_AUTORESET)
        engine.opt.jacobian = mujoco.mjtJacobian.mjJAC_DENSE if engine.nv <= _DENSE else mujoco.mjtJacobian.mjJAC_SPARSE
        self._worlds = len(models)
        self._varying = _varying(engines)
        sizes = dict.fromkeys(self._varying, self._worlds)
        with wp.ScopedDevice(self._device):
            try:
                self._model = self._warp.put_model(engine, batch_sizes=sizes)
            except (NotImplementedError, ValueError) as error:
                reason = " ".join(str(error).split())
                raise InputError(
                    f"{models[0].design.name}: protocol.device: MuJoCo Warp rejects it: {reason}"
                ) from None
            timesteps = np.array([model.timestep for model in models], dtype=np.float32)
            self._timesteps, self._model.opt.timestep = timesteps, wp.array(timesteps, dtype=float)
            # number of the step within the chunk, which graphs read from the device
            self._step = wp.zeros(1, dtype=int)
            self._controls = wp.zeros((chunk, self._worlds, engine.nu), dtype=float)
            data = mujoco.MjData(engine)
            self._shapes = {name: getattr(data, name).shape for name in names}
            self._kept = {name: self._memory(int(np.prod(shape))) for name, shape in self._shapes.items()}
            self._columns = {name: mujoco.mj_stateSize(engine, part.value) for name, part in _PARTS.items()}
            self._states = self._memory(sum(self._columns.values()))
        self._placed: Indices | None = None
        # data and graph of one step, by number of worlds
        self._steps: dict[int, tuple[Any, Any]] = {}

    def start(self, rows: Indices, before: Array, controls: Array, about: Mapping[str, Any]) -> DeviceSteps:
        """Step some structures from their states, (row, number), with the controls of each step.

        Args:
            rows: numbers of the structures.
            before: the parts of their states that a step changes, (row, number).
            controls: of the engine, (row, step, control).
            about: further fields of the steps.
        """
        count, worlds = len(rows), self._world_count(len(rows))
        # further worlds repeat the last structure
        worlds_of = np.append(np.arange(count), np.full(worlds - count, count - 1))
        with wp.ScopedDevice(self._device):
            self._place(rows[worlds_of])
            data, graph = self._of_worlds(worlds)
            first = 0
            for name, size in self._columns.items():
                if size:
                    values = before[worlds_of, first : first + size].astype(np.float32)
                    field = getattr(data, name)
                    field.assign(values.reshape(field.shape))
                    first += size
            of_steps = np.zeros(self._controls.shape, dtype=np.float32)
            of_steps[:, :worlds] = controls[worlds_of].swapaxes(0, 1)
            self._controls.assign(of_steps)
            self._step.zero_()
            for _ in range(self._chunk):
                wp.capture_launch(graph)
        after: Any = DeviceValues(self._states, count, (self._states.shape[2],))
        derived: Any = {name: DeviceValues(kept, count, self._shapes[name]) for name, kept in self._kept.items()}
        return DeviceSteps(before=before, after=after, derived=derived, **about)

    def _memory(self, size: int) -> Any:
        """Reserve memory for numbers of every step of every structure."""
        return wp.zeros((self._chunk, self._worlds, size), dtype=float)

    def _world_count(self, rows: int) -> int:
        """Return the number of worlds to step for a number of structures: a power of two, so that graphs are few."""
        return min(1 << (rows - 1).bit_length(), self._worlds)

    def _place(self, rows: Indices) -> None:
        """Set the numbers of the models in the first worlds to those of some structures."""
        if self._placed is not None and np.array_equal(rows, self._placed):
            return
        self._placed = rows
        for name, values in self._varying.items():
            field = getattr(self._model, name)[: len(rows)]
            # elements of the device's arrays may be vectors
            field.assign(values[rows].reshape(field.numpy().shape))
        self._model.opt.timestep[: len(rows)].assign(self._timesteps[rows])

    def _of_worlds(self, worlds: int) -> tuple[Any, Any]:
        """Return the data of a number of worlds, and one step of them as a graph of kernels.

        Calling the hundred kernels of a step from Python would take 15 ms, hundreds of times as long as a graph takes.
        """
        if worlds not in self._steps:
            most = _most_constraints(self._engine)
            data = self._warp.make_data(self._engine, nworld=worlds, nconmax=1, njmax=most)
            self._step.zero_()  # the memory ends with the chunk
            self._take_step(data)  # compiles the kernels, which is not possible while a graph is recorded
            with wp.ScopedCapture() as capture:
                self._take_step(data)
            self._steps[worlds] = data, capture.graph
        return self._steps[worlds]

    def _take_step(self, data: Any) -> None:
        worlds, controls = data.nworld, self._controls.shape[2]
        if controls:
            wp.launch(
                kernels.set_controls, (worlds, controls), inputs=[self._step, self._controls], outputs=[data.ctrl]
            )
        self._warp.step(self._model, data)
        for name, kept in self._kept.items():
            self._keep(getattr(data, name), 0, kept)
        first = 0
        for name, size in self._columns.items():
            self._keep(getattr(data, name), first, self._states)
            first += size
        wp.launch(kernels.next_step, 1, inputs=[self._step])

    def _keep(self, field: Any, first: int, kept: Any) -> None:
        # elements may be vectors
        worlds, size = len(field), int(np.prod(field.shape[1:])) * wp.types.type_size_in_bytes(field.dtype) // _FLOAT
        if size:
            numbers = wp.array(ptr=field.ptr, dtype=float, shape=(worlds, size), device=field.device)
            wp.launch(kernels.keep_values, (worlds, size), inputs=[self._step, numbers, first], outputs=[kept])


def _varying(engines: Sequence[mujoco.MjModel]) -> dict[str, NDArray[np.float32]]:
    """Return the numbers that differ between models, (model, ...), by the engine's names."""
    distinct = list({id(engine): engine for engine in engines}.values())
    if len(distinct) == 1:
        return {}
    number = {id(engine): place for place, engine in enumerate(distinct)}
    places = [number[id(engine)] for engine in engines]
    varying = {}
    for name in varying_fields():
        values = np.array([getattr(engine, name) for engine in distinct])
        if values.size and (values != values[:1]).any():
            varying[name] = values[places].astype(np.float32)
    return varying


def _most_constraints(engine: mujoco.MjModel) -> int:
    """Return the largest number of constraints that can act at once without contacts."""
    limits = 2 * int(np.sum(engine.jnt_limited)) + 2 * int(np.sum(engine.tendon_limited))
    dry = int(np.count_nonzero(engine.dof_frictionloss)) + int(np.count_nonzero(engine.tendon_frictionloss))
    return max(limits + dry + 6 * int(engine.neq), 1)
