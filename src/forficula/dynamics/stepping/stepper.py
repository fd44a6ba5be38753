"""Stepping of structures side by side in the engine: torques are the input, steps the output."""

from __future__ import annotations

import itertools
from collections import deque
from collections.abc import Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from queue import SimpleQueue
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np
from mujoco.batch import Batch

from forficula.arrays import Array, Indices
from forficula.cores import usable_cores
from forficula.dynamics.energies.crease_moments import Past
from forficula.dynamics.engine.contact import has_engine_contact
from forficula.dynamics.engine.contact_forces import ContactForces
from forficula.dynamics.engine.crease_rows import without_jump
from forficula.dynamics.engine.drag import KINEMATICS, stacked_drag
from forficula.dynamics.engine.followed_creases import FollowedCreases, followed_creases, followed_engine
from forficula.dynamics.engine.model import Model
from forficula.dynamics.engine.warnings import quiet
from forficula.dynamics.stepping.contact_steps import contact_steps
from forficula.dynamics.stepping.rollout import Rollout, block_memory, branch_slices
from forficula.dynamics.stepping.start_states import start_crease_memory, start_creases, start_states
from forficula.dynamics.stepping.steps import MEMORY, MOVING, STATE, EngineState, StepContacts, Steps
from forficula.structure.contact.touching_parts import has_touching_facets

if TYPE_CHECKING:
    from forficula.dynamics.gpu.device_engine import DeviceEngine

# fields for the states of a sparse record and of others, and further fields for the works
_OF_SPARSE = ("ten_length",)
_OF_STATES = ("ten_length", "energy", "flexvert_xpos", "xpos", "xipos", "site_xpos")
_OF_ACCOUNT = ("qfrc_damper", "qfrc_constraint")
_OF_LETTING_GO = ("ten_velocity", "ten_J")
_OF_CONTACT = ("sensordata", "ten_J")
# least number of structures with creases or drag per worker: Python, which runs in one worker at a time, takes hardly
# longer for this number than for one, and much longer than the engine
_TOGETHER = 8


@dataclass(frozen=True, kw_only=True)
class Pending:
    """Steps in progress; each of several workers has a part of the structures."""

    parts: Sequence[Future[None]]
    steps: Steps

    def result(self) -> Steps:
        """Wait for the steps and return them."""
        for part in self.parts:
            part.result()
        return self.steps


class Stepper:
    """Structures of one topology in the engine, each in its own state; workers step them in the background.

    Every worker has an engine with one thread, so that no worker waits for another, as threads of one engine do.
    """

    def __init__(self, models: Sequence[Model], threads: int, sparse: bool, chunk: int) -> None:
        """Put the structures into their start states.

        Args:
            models: compiled, with the same numbers of hinges, tendons and membrane nodes.
            threads: number of threads; 0 for one per core.
            sparse: record only the tendons' lengths of the fields for states.
            chunk: number of steps at a time.
        """
        self._structures, self._chunk = models, chunk
        self._rollout = Rollout(models, sparse)
        self._explicit = models[0].explicit
        model = models[0].engine
        self._state = start_states(models)
        self._moving = self._rollout.moving
        self._branch_slices = branch_slices(model)
        self._activation = self._moving[self._branch_slices.get("act", slice(0, 0))]
        self._kept = _OF_SPARSE if sparse else _OF_STATES
        self._names = (*self._kept, *_OF_ACCOUNT, *(_OF_LETTING_GO if models[0].lets_go.any() else ()))
        if has_engine_contact(models[0].structure):
            more = ("ncon",) if self._explicit else _OF_CONTACT
            self._names = tuple(dict.fromkeys((*self._names, *more)))
        if any(hinge.friction and not hinge.flaps for model in models for hinge in model.structure.hinges):
            self._names = (*self._names, "qacc")
        self._names += ("actuator_force",) if models[0].jacobian.any() else ()
        drags = [model.drag for model in models if model.drag is not None]
        self._drag = stacked_drag(drags) if drags else None
        self._names += ("qfrc_applied",) if drags else ()
        # last angles of creases, without jumps
        self._angles = np.array([start_creases(model) for model in models])
        # memory of creases, (slot, structure, crease)
        self._past = np.stack([start_crease_memory(model) for model in models], axis=1)
        self._contact = ContactForces(models) if has_touching_facets(models[0].structure) else None
        self._data = mujoco.MjData(model)
        self._device = _device_engine(models, self._rollout.models, self._names, chunk)
        if self._device is not None:
            # a device steps all structures at once
            self.threads, self.together = 1, len(models)
            return
        # memory is reused, because fresh memory costs as much time as reading it
        self._memory = deque([_memory(models, self._names, chunk, len(self._moving)) for _ in range(2)])
        self._creases = followed_creases(models)
        # writable numbers of the engine's models
        self._followed = [] if self._creases is None else [followed_engine(model) for model in self._rollout.models]
        # durations of blocks of steps with constant numbers of creases, (structure, 1)
        self._block_times = np.array([[model.followed * model.timestep] for model in models])
        # angles and memory of creases at the start of each block
        slots, blocks = 1 + len(self._past), chunk // models[0].followed
        self._blocks = deque([np.empty((slots, len(models), blocks, len(self._angles[0]))) for _ in range(2)])
        steps = chunk if self._contact else 0
        self._contacts = deque([StepContacts.allocated(len(models), steps, model.nv) for _ in range(2)])
        self.threads = int(Batch(model, len(models), threads or usable_cores()).nthread)
        # least number of structures per worker, if there are enough
        self.together = 1 if not self._in_python else _TOGETHER
        self._engines: SimpleQueue[Batch] = SimpleQueue()
        # largest number of structures per worker; it can exceed that at the start when some structures are done
        most = max(min(len(models), self.together), -(-len(models) // self.threads))
        for _ in range(self.threads):
            self._engines.put(Batch(model, most, 1))
        self._workers = ThreadPoolExecutor(max_workers=self.threads)

    def start(self, rows: Indices, controls: Array, efforts: Array) -> Pending:
        """Start a chunk of steps of some structures in the background.

        Another chunk can be started before this one is done, but the third chunk overwrites the first.

        Args:
            rows: numbers of the structures.
            controls: of the engine in each step, (row, step, control).
            efforts: settings of all motors in each step, in the models' units, (row, step, motor), for creases.
        """
        # for `state`: the controls in the last state are those of the last step
        self._state[np.ix_(rows, self._rollout.control)] = controls[:, -1]
        if self._device is not None:
            before = self._state[np.ix_(rows, self._moving)]
            return Pending(parts=(), steps=self._device.start(rows, before, controls, self._about()))
        self._memory.rotate()
        self._blocks.rotate()
        self._contacts.rotate()
        contacts = None if self._contact is None else self._contacts[0].some(slice(len(rows)))
        fields = {name: field[: len(rows)] for name, field in self._memory[0].items()}
        followed = None if self._structures[0].creases is None else self._blocks[0][:, : len(rows)]
        bounds = np.linspace(0, len(rows), self._parts(len(rows)) + 1).astype(int).tolist()
        parts = [slice(*pair) for pair in itertools.pairwise(bounds)]
        late = {name: np.empty_like(fields[name]) for name in self._names} if self._explicit else None
        steps = Steps(
            **self._about(),
            before=self._state[np.ix_(rows, self._moving)],
            after=fields[MOVING],
            derived={name: fields[name] for name in self._names},
            late=late,
            angles=None if followed is None else followed[0],
            memory=None if followed is None else followed[1:],
            memory_before=self._past[:, rows],
            followed=self._structures[0].followed,
            contact=contacts,
        )
        return Pending(
            parts=[
                self._workers.submit(
                    self._step,
                    rows[part],
                    controls[part],
                    efforts[part],
                    {name: field[part] for name, field in fields.items()},
                    {name: field[part] for name, field in (late or {}).items()},
                    None if followed is None else followed[:, part],
                    None if contacts is None else contacts.some(part),
                )
                for part in parts
            ],
            steps=steps,
        )

    def take_back(self, rows: Indices, steps: Steps, taken: Indices) -> None:
        """Put structures into their states after the steps that count, (row,)."""
        self._state[np.ix_(rows, self._moving)] = steps.states(np.arange(len(rows)), taken)
        if self._contact is not None and steps.contact is not None:
            self._contact.friction_springs[rows] = steps.contact.friction_springs[np.arange(len(rows)), taken]
        if steps.angles is not None:
            for place, (row, step) in enumerate(zip(rows.tolist(), taken.tolist(), strict=True)):
                block = min(step // steps.followed, steps.angles.shape[1] - 1)
                model, near = self._structures[row], steps.angles[place, block]
                position = self._state[row, self._moving][1 : 1 + steps.positions]
                self._angles[row] = without_jump(model.folds.angles(position)[model.followed_hinges], near)
                self._past[:, row] = steps.memory_at(model, place, np.array([step]), self._angles[row][None])[:, 0]

    def follow_leader(self, row: int, leader: int) -> None:
        """Copy the state of another structure."""
        self._state[row] = self._state[leader]
        self._angles[row], self._past[:, row] = self._angles[leader], self._past[:, leader]
        if self._contact is not None:
            self._contact.friction_springs[row] = self._contact.friction_springs[leader]

    def state(self, row: int) -> EngineState:
        """Return the state of a structure."""
        # data are reused, because structures of one topology have data of the same size and creation is slow
        engine, data = self._structures[row].engine, self._data
        mujoco.mj_resetData(engine, data)
        mujoco.mj_setState(engine, data, self._state[row], STATE)
        with quiet:
            mujoco.mj_forward(engine, data)
        derived = {name: getattr(data, name).copy() for name in (*_OF_STATES, "xmat", *self._branch_slices)}
        derived[MEMORY] = self._past[:, row].copy()
        followed = self._structures[row].followed_hinges
        angle = self._structures[row].folds.angles(data.qpos)
        angle[followed] = without_jump(angle[followed], self._angles[row])
        return EngineState(position=data.qpos.copy(), velocity=data.qvel.copy(), angle=angle, derived=derived)

    def overlap(self, row: int) -> float:
        """Return the largest overlap of parts in the state of a structure that has ended, as a share of the thickness.

        Parts that passed through each other in the last step, after which no forces are computed, overlap by 1 or more.
        """
        if self._contact is None:
            return 0.0
        rows = np.array([row])
        _, overlaps, _ = self._contact.forces(rows, *self._rollout.motion(self._state[rows]))
        return float(overlaps[0])

    def place(self, row: int, position: Array, memory: Array | None = None) -> EngineState:
        """Put a structure at rest into a position, (position,), with a memory of its hinges; return its state.

        Args:
            row: number of the structure.
            position: of its joints and of bodies that slide or turn freely.
            memory: of all hinges, SI, (slot, hinge), which stays as it is by default.
        """
        changed = self._state[row, self._moving]
        if memory is not None:
            model, sets = self._structures[row], memory[0]
            self._past[:, row] = memory[:, model.followed_hinges]
            self._past[2:, row] /= model.units.energy
            yielding = model.hinge_creep >= 0
            if yielding.any():
                rests = np.array([hinge.rest_angle for hinge in model.structure.hinges])
                plastic = changed[self._branch_slices["plastic"]]
                plastic[model.hinge_creep[yielding]] = (model.folds.senses * (rests + sets))[yielding]
                changed[self._branch_slices["plastic"]] = plastic
        engine = self._structures[row].engine
        changed[1 : 1 + engine.nq], changed[1 + engine.nq : 1 + engine.nq + engine.nv] = position, 0.0
        self._state[row, self._moving] = changed
        state = self.state(row)
        self._angles[row] = state.angle[self._structures[row].followed_hinges]
        return state

    def lengths(self, row: int) -> Array:
        """Return the lengths of the engine's tendons in a structure, (tendon,)."""
        return np.asarray(self.state(row).derived["ten_length"])

    def activation(self, row: int) -> Array:
        """Return the forces of the Maxwell branches of a structure, pushing positive, (activation,)."""
        return np.asarray(self._state[row, self._activation])

    def set_activation(self, row: int, forces: Array) -> None:
        """Set the forces of the Maxwell branches of a structure."""
        self._state[row, self._activation] = forces

    def creases(self, row: int) -> tuple[Array, Array]:
        """Return the angles of the followed creases of a structure, (crease,), and their memory, (slot, crease)."""
        return self._angles[row].copy(), self._past[:, row].copy()

    def set_branch_moments(self, row: int, moments: Array) -> None:
        """Set the moments of the Maxwell branches of the creases of a structure, (branch, crease)."""
        self._past[2:, row] = moments

    def close(self) -> None:
        """Wait for the steps in progress and start no others."""
        if self._device is None:
            self._workers.shutdown(cancel_futures=True)

    def _about(self) -> dict[str, Any]:
        """Return the fields that all steps of the structures have."""
        engine = self._structures[0].engine
        return {"positions": engine.nq, "dof": engine.nv, "inner": self._branch_slices, "kept": self._kept}

    def _parts(self, rows: int) -> int:
        """Return the number of workers for a number of structures."""
        return min(-(-rows // self.together), self.threads)

    def _step(
        self,
        rows: Indices,
        controls: Array,
        efforts: Array,
        memory: Mapping[str | int, Array],
        late: Mapping[str, Array],
        followed: Array | None,
        contacts: StepContacts | None,
    ) -> None:
        """Take a chunk of steps of some structures and write the results to memory.

        With creases or drag, steps are taken block by block; rows of creases and drag are constant in a block.
        """
        engine, state = self._engines.get(), self._state[rows]
        try:
            if not self._in_python:
                self._rollout.steps(engine, rows, state, controls, memory, late)
                return
            length = self._structures[0].followed
            creases = None if self._creases is None else self._creases.some(rows)
            in_block = {name: block_memory(values, length) for name, values in memory.items()}
            of_late = {name: block_memory(values, length) for name, values in late.items()}
            blocks = controls.shape[1] // length
            means = efforts.reshape(len(rows), blocks, length, -1).mean(axis=2)
            for block in range(blocks):
                steps = slice(block * length, (block + 1) * length)
                with np.errstate(all="ignore"):  # diverging structures, whose later steps do not count
                    if followed is not None and creases is not None:
                        before = followed[:, :, block - 1]
                        if block == 0:
                            before = np.concatenate([self._angles[None, rows], self._past[:, rows]])
                        angles, past = self._set_creases(rows, creases, state, before, means[:, block], block > 0)
                        followed[0, :, block], followed[1:, :, block] = angles, past
                    if self._drag is not None:
                        self._set_drag(engine, rows, state)
                if contacts is not None and self._contact is not None:
                    contact_steps(
                        self._rollout, self._contact, engine, rows, state, controls, memory, late, contacts, steps
                    )
                    continue
                self._rollout.steps(engine, rows, state, np.ascontiguousarray(controls[:, steps]), in_block, of_late)
                for name, values in memory.items():
                    values[:, steps] = in_block[name]
                for field, values in late.items():
                    values[:, steps] = of_late[field]
                state[:, self._moving] = in_block[MOVING][:, -1]
            self._state[rows] = state
        finally:
            self._engines.put(engine)

    @property
    def _in_python(self) -> bool:
        """Whether Python computes forces between steps."""
        return self._creases is not None or self._drag is not None or self._contact is not None

    def _set_drag(self, engine: Batch, rows: Indices, state: Array) -> None:
        """Set the drag of structures for their positions and velocities in some states, (row, number)."""
        assert self._drag is not None
        _, velocity = self._rollout.motion(state)
        fields = self._rollout.fields(engine, rows, state, KINEMATICS, mujoco.mjtStage.mjSTAGE_POS)
        state[:, self._rollout.applied] = self._drag.forces(rows, fields, velocity)

    def _set_creases(
        self,
        rows: Indices,
        creases: FollowedCreases,
        state: Array,
        before: Array,
        efforts: Array,
        later: bool,
    ) -> tuple[Array, Array]:
        """Set the numbers of creases of structures in some states; return their angles and memory.

        The angles and memory before are those of the same states, or of states a block earlier if `later` is true.
        """
        position, velocity = self._rollout.motion(state)
        block = self._block_times[rows]
        past = Past(angles=before[0], memory=before[1:], elapsed=block * later, block=block)
        return creases.update([self._followed[row] for row in rows.tolist()], position, velocity, efforts, past)


def _device_engine(
    models: Sequence[Model], engines: Sequence[mujoco.MjModel], names: Sequence[str], chunk: int
) -> DeviceEngine | None:
    """Return the engine on the device of the structures; None for the processor."""
    if models[0].design.protocol.device is None:
        return None
    from forficula.dynamics.gpu.device_engine import DeviceEngine

    return DeviceEngine(models, engines, names, chunk)


def _memory(models: Sequence[Model], names: Sequence[str], chunk: int, moving: int) -> dict[str | int, Array]:
    """Allocate memory for a chunk of steps of all structures, by recorded field."""
    data = mujoco.MjData(models[0].engine)
    fields = {MOVING: np.empty(moving), **{name: np.asarray(getattr(data, name)) for name in names}}
    # numbers of contacts have the engine's type
    types = {name: np.int32 if field.dtype.kind == "i" else np.float64 for name, field in fields.items()}
    return {name: np.empty((len(models), chunk, *field.shape), dtype=types[name]) for name, field in fields.items()}
