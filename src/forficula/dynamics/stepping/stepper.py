"""Structures side by side in the engine: torques go in, steps come out."""

from __future__ import annotations

import copy
import itertools
import threading
from collections import deque
from collections.abc import Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from queue import SimpleQueue

import mujoco
import numpy as np
from mujoco.batch import Batch

from forficula.arrays import Array, Indices
from forficula.dynamics.energies.creases import engine_rows
from forficula.dynamics.engine.crease_rows import CreaseRows, crease_rows, without_jump
from forficula.dynamics.engine.drag import KINEMATICS, stacked_drag
from forficula.dynamics.engine.model import Model
from forficula.dynamics.engine.plate_creases import PlateRows, plate_rows
from forficula.dynamics.stepping.steps import EngineState, Steps

# all that the next step depends on, and of that what a step changes: time, positions and velocities first
_STATE = mujoco.mjtState.mjSTATE_INTEGRATION.value
_MOVING = _STATE & ~mujoco.mjtState.mjSTATE_USER.value
_CONTROL = mujoco.mjtState.mjSTATE_CTRL.value
# what states are read from, of a sparse record and of others, and what the account of the work needs besides
_OF_SPARSE = ("ten_length",)
_OF_STATES = ("ten_length", "energy", "flexvert_xpos", "xpos", "xipos", "site_xpos")
_OF_ACCOUNT = ("qfrc_damper", "qfrc_constraint")
_OF_LETTING_GO = ("ten_velocity", "ten_J")
_OF_CONTACT = ("sensordata", "ten_J")
# structures with creases or drag that a worker takes at least: Python, which one worker runs at a time, takes hardly
# longer for so many of them than for one, and much longer than the engine does
_TOGETHER = 8


@dataclass(frozen=True, kw_only=True)
class Pending:
    """Steps that are being made, by several workers a part of the structures each."""

    parts: Sequence[Future[None]]
    steps: Steps

    def result(self) -> Steps:
        """Wait for them."""
        for part in self.parts:
            part.result()
        return self.steps


class Stepper:
    """Structures of one topology in the engine, each in its own state; workers step them in the background.

    Every worker has an engine of one thread: none waits for another, as the threads of one engine do after each part.
    """

    def __init__(self, models: Sequence[Model], threads: int, sparse: bool, chunk: int) -> None:
        """Put the structures where they start.

        Args:
            models: compiled, with the same numbers of hinges, tendons and membrane nodes.
            threads: 0 for one a core.
            sparse: of the derived fields that states are read from, leave out all but the tendons' lengths.
            chunk: steps to take at a time.
        """
        self._structures, self._chunk = models, chunk
        self._models = _own_models(models, sparse)
        self._explicit = models[0].explicit
        model = models[0].engine
        self._state = _start_states(models)
        self._moving, self._control = _columns(model, _MOVING), _columns(model, _CONTROL)
        self._inner = _inner(model)
        self._activation = self._moving[self._inner.get("act", slice(0, 0))]
        self._kept = _OF_SPARSE if sparse else _OF_STATES
        self._names = (*self._kept, *_OF_ACCOUNT, *(_OF_LETTING_GO if models[0].lets_go.any() else ()))
        if models[0].structure.contact is not None:
            self._names = tuple(dict.fromkeys((*self._names, *_OF_CONTACT)))
        if any(hinge.friction for model in models for hinge in model.structure.hinges):
            self._names = (*self._names, "qacc")
        if models[0].ways.any():
            self._names = (*self._names, "actuator_force")
        drags = [each.drag for each in models if each.drag is not None]
        self._drag = stacked_drag(drags) if drags else None
        self._applied = _columns(model, mujoco.mjtState.mjSTATE_QFRC_APPLIED.value)
        if drags:
            self._names = (*self._names, "qfrc_applied")
        # the same memory again and again: fresh memory costs as much time as looking at it
        self._memory = deque([_memory(models, self._names, chunk, len(self._moving)) for _ in range(2)])
        # where the creases of each were last, without jumps
        self._angles = np.array([_start_creases(each) for each in models])
        self._creases = crease_rows(models) if models[0].folds.placement is None else plate_rows(models)
        # what the engine's models have of them, to be written to
        self._bends = [] if self._creases is None else [engine_rows(each) for each in self._models]
        self._blocks = deque(
            [np.empty((len(models), chunk // models[0].followed, len(self._angles[0]))) for _ in range(2)]
        )
        self.threads = int(Batch(model, len(models), threads).nthread)
        # structures that a worker takes at least, if there are so many
        self.together = 1 if self._creases is None and self._drag is None else _TOGETHER
        self._engines: SimpleQueue[Batch] = SimpleQueue()
        # that one worker has at a time; where some are done, it may be more than at the start
        most = max(min(len(models), self.together), -(-len(models) // self.threads))
        for _ in range(self.threads):
            self._engines.put(Batch(model, most, 1))
        self._workers = ThreadPoolExecutor(max_workers=self.threads)
        self._data = mujoco.MjData(model)

    def start(self, rows: Indices, controls: Array, efforts: Array) -> Pending:
        """Set out to take these structures a chunk of steps further.

        Others can be started before that is done, but the third steps overwrite the first.

        Args:
            rows: which.
            controls: of the engine in each step, (row, step, control).
            efforts: of all motors in each step, in the models' units, (row, step, motor), for creases.
        """
        # for `state`: what drives a structure in its last state drove it in the last step, too
        self._state[np.ix_(rows, self._control)] = controls[:, -1]
        self._memory.rotate()
        self._blocks.rotate()
        mine = {name: each[: len(rows)] for name, each in self._memory[0].items()}
        angles = None if self._structures[0].creases is None else self._blocks[0][: len(rows)]
        bounds = np.linspace(0, len(rows), self._parts(len(rows)) + 1).astype(int).tolist()
        parts = [slice(*pair) for pair in itertools.pairwise(bounds)]
        late = {name: np.empty_like(mine[name]) for name in self._names} if self._explicit else None
        steps = Steps(
            positions=self._structures[0].engine.nq,
            dof=self._structures[0].engine.nv,
            inner=self._inner,
            before=self._state[np.ix_(rows, self._moving)],
            after=mine[_MOVING],
            derived={name: mine[name] for name in self._names},
            kept=self._kept,
            late=late,
            angles=angles,
            followed=self._structures[0].followed,
        )
        return Pending(
            parts=[
                self._workers.submit(
                    self._step,
                    rows[part],
                    controls[part],
                    efforts[part],
                    {name: each[part] for name, each in mine.items()},
                    {name: each[part] for name, each in (late or {}).items()},
                    None if angles is None else angles[part],
                )
                for part in parts
            ],
            steps=steps,
        )

    def take_back(self, rows: Indices, steps: Steps, taken: Indices) -> None:
        """Put these structures where they were after as many of their last steps as count, (row,)."""
        self._state[np.ix_(rows, self._moving)] = steps.states(np.arange(len(rows)), taken)
        if steps.angles is not None:
            for place, (row, step) in enumerate(zip(rows.tolist(), taken.tolist(), strict=True)):
                near = steps.angles[place, min(step // steps.followed, steps.angles.shape[1] - 1)]
                folds = self._structures[row].folds
                position = self._state[row, self._moving][1 : 1 + steps.positions]
                self._angles[row] = without_jump(folds.angles(position)[folds.creases], near)

    def follow_leader(self, row: int, leader: int) -> None:
        """Put a structure where another one is."""
        self._state[row] = self._state[leader]
        self._angles[row] = self._angles[leader]

    def state(self, row: int) -> EngineState:
        """What a structure is in."""
        # structures of one topology have data of one size: making it anew takes as long as many steps
        engine, data = self._structures[row].engine, self._data
        mujoco.mj_resetData(engine, data)
        mujoco.mj_setState(engine, data, self._state[row], _STATE)
        with _quiet:
            mujoco.mj_forward(engine, data)
        derived = {name: getattr(data, name).copy() for name in (*_OF_STATES, *self._inner)}
        folds = self._structures[row].folds
        angle = folds.angles(data.qpos)
        angle[folds.creases] = without_jump(angle[folds.creases], self._angles[row])
        return EngineState(position=data.qpos.copy(), velocity=data.qvel.copy(), angle=angle, derived=derived)

    def lengths(self, row: int) -> Array:
        """Lengths of the engine's tendons in a structure, (tendon,)."""
        return np.asarray(self.state(row).derived["ten_length"])

    def activation(self, row: int) -> Array:
        """Forces of the Maxwell branches of a structure, pushing positive, (activation,)."""
        return np.asarray(self._state[row, self._activation])

    def set_activation(self, row: int, forces: Array) -> None:
        """Put other forces in their place."""
        self._state[row, self._activation] = forces

    def close(self) -> None:
        """Wait for the steps that are being made, and make no more."""
        self._workers.shutdown(cancel_futures=True)

    def _parts(self, rows: int) -> int:
        """How many workers share so many structures."""
        return min(-(-rows // self.together), self.threads)

    def _roll(
        self,
        engine: Batch,
        rows: Indices,
        state: Array,
        controls: Array,
        memory: Mapping[str | int, Array],
        late: Mapping[str, Array],
    ) -> None:
        """Take structures as many steps further from their states, (row, number), as they have controls."""
        first: dict[str, Array] = {}
        if late:
            driven = state.copy()
            driven[:, self._control] = controls[:, 0]
            first = self._fields(engine, rows, driven, self._names, mujoco.mjtStage.mjSTAGE_ACC)
        self._put(engine, rows, state)
        out: dict[str | int | mujoco.mjtState, Array] = {**memory}
        with _quiet:
            engine.rollout(
                controls.shape[1],
                control=controls,
                control_spec=_CONTROL,
                record=tuple(out),
                ids=None if len(rows) == engine.nsim else np.arange(len(rows)),
                out=out,
            )
        for name, each in late.items():
            # the engine leaves what the last of its four stages saw, next to the state after the step
            each[:] = memory[name]
            memory[name][:, 0], memory[name][:, 1:] = first[name], each[:, :-1]

    def _fields(
        self, engine: Batch, rows: Indices, state: Array, names: Sequence[str], stage: mujoco.mjtStage
    ) -> dict[str, Array]:
        """Derived fields of structures in some states, up to a stage of the engine's, (row, ...)."""
        self._put(engine, rows, state)
        # the engine fills what was bound before
        bound = {name: engine.bind(name) for name in names}
        with _quiet:
            engine.forward(np.arange(len(rows)), stage.value)
        return {name: each[: len(rows)].copy() for name, each in bound.items()}

    def _put(self, engine: Batch, rows: Indices, state: Array) -> None:
        """Put structures into an engine, in some states, (row, number)."""
        every = [*range(len(rows)), *[0] * (engine.nsim - len(rows))]
        engine.set_models([self._models[rows[place]] for place in every])
        engine.state[: len(rows)] = state

    def _step(
        self,
        rows: Indices,
        controls: Array,
        efforts: Array,
        memory: Mapping[str | int, Array],
        late: Mapping[str, Array],
        angles: Array | None,
    ) -> None:
        """Take some structures a chunk of steps further; what comes of it goes to memory.

        Where there are creases or drag, block by block: in each they have what they have at its start.
        """
        engine, state = self._engines.get(), self._state[rows]
        try:
            if angles is None and self._drag is None:
                self._roll(engine, rows, state, controls, memory, late)
                return
            followed = self._structures[0].followed
            creases = None if self._creases is None else self._creases.some(rows)
            own = {name: _block(each, followed) for name, each in memory.items()}
            of_late = {name: _block(each, followed) for name, each in late.items()}
            blocks = controls.shape[1] // followed
            means = efforts.reshape(len(rows), blocks, followed, -1).mean(axis=2)
            for block in range(blocks):
                steps = slice(block * followed, (block + 1) * followed)
                with np.errstate(all="ignore"):  # of what blows up, whose later steps do not count
                    if angles is not None and creases is not None:
                        near = self._angles[rows] if block == 0 else angles[:, block - 1]
                        angles[:, block] = self._set_creases(rows, creases, state, near, means[:, block])
                    if self._drag is not None:
                        self._set_drag(engine, rows, state)
                self._roll(engine, rows, state, np.ascontiguousarray(controls[:, steps]), own, of_late)
                for name, each in memory.items():
                    each[:, steps] = own[name]
                for field, each in late.items():
                    each[:, steps] = of_late[field]
                state[:, self._moving] = own[_MOVING][:, -1]
            self._state[rows] = state
        finally:
            self._engines.put(engine)

    def _set_drag(self, engine: Batch, rows: Indices, state: Array) -> None:
        """Give structures in some states, (row, number), the drag that they have where they are and as they move."""
        assert self._drag is not None
        _, velocity = self._motion(state)
        fields = self._fields(engine, rows, state, KINEMATICS, mujoco.mjtStage.mjSTAGE_POS)
        state[:, self._applied] = self._drag.forces(rows, fields, velocity)

    def _motion(self, state: Array) -> tuple[Array, Array]:
        """Positions and velocities in some states, (row, position) and (row, velocity)."""
        engine, moving = self._structures[0].engine, state[:, self._moving][:, 1:]
        return moving[:, : engine.nq], moving[:, engine.nq : engine.nq + engine.nv]

    def _set_creases(
        self, rows: Indices, creases: CreaseRows | PlateRows, state: Array, near: Array, efforts: Array
    ) -> Array:
        """Give the creases of structures what they have in some states; their angles, without jumps, (row, crease)."""
        position, velocity = self._motion(state)
        angles, values = creases.follow(position, velocity, near, efforts)
        for row, own in zip(rows.tolist(), values, strict=True):
            self._bends[row][creases.rows] = own
        return angles


def energy_of(model: Model, moving: Array) -> float:
    """Energy of springs, weight and motion, in the model's units, in what `Steps.after` has of a state."""
    data = mujoco.MjData(model.engine)
    mujoco.mj_setState(model.engine, data, moving, _MOVING)
    with _quiet:
        mujoco.mj_forward(model.engine, data)
    # the engine counts the weight of what floats, too
    floats = model.engine.body_mass * model.engine.body_gravcomp
    return float(data.energy.sum() + floats @ (data.xipos @ model.engine.opt.gravity))


def _own_models(models: Sequence[Model], sparse: bool) -> list[mujoco.MjModel]:
    """What the engine runs: models without energy if it is not looked at, of its own for each that has creases."""
    engines = _without_energy(models) if sparse else [model.engine for model in models]
    return [
        engine if model.creases is None else copy.copy(engine) for engine, model in zip(engines, models, strict=True)
    ]


def _start_creases(model: Model) -> Array:
    """Angles of the creases of the built shape, which start there, rad, (crease,)."""
    return np.array([model.structure.hinges[number].start for number in model.folds.creases])


def _memory(models: Sequence[Model], names: Sequence[str], chunk: int, moving: int) -> dict[str | int, Array]:
    """Room for a chunk of steps of all structures, by what is recorded."""
    data = mujoco.MjData(models[0].engine)
    shapes = {_MOVING: (moving,), **{name: getattr(data, name).shape for name in names}}
    return {name: np.empty((len(models), chunk, *shape)) for name, shape in shapes.items()}


def _block(memory: Array, steps: int) -> Array:
    """Room for a block of steps of what has room for more, (row, step, ...)."""
    return np.empty((len(memory), steps, *memory.shape[2:]))


def _columns(engine: mujoco.MjModel, part: int) -> Indices:
    """Where in a state a part of it lies."""
    every = np.arange(mujoco.mj_stateSize(engine, _STATE), dtype=np.float64)
    mine = np.empty(mujoco.mj_stateSize(engine, part))
    mujoco.mj_extractState(engine, every, _STATE, mine, part)
    return mine.astype(np.int64)


def _inner(engine: mujoco.MjModel) -> dict[str, slice]:
    """Where in what a step changes the numbers of branches and of tendons that yield lie, by MuJoCo's names."""
    state = mujoco.mjtState
    before = state.mjSTATE_TIME.value | state.mjSTATE_QPOS.value | state.mjSTATE_QVEL.value
    first, size = mujoco.mj_stateSize(engine, before), mujoco.mj_stateSize(engine, _MOVING)
    places = {"act": slice(first, first + engine.na), "plastic": slice(size - engine.nplastic, size)}
    return {name: place for name, place in places.items() if place.start < place.stop}


def _without_energy(models: Sequence[Model]) -> list[mujoco.MjModel]:
    """Engine models that leave out the energy of every step; nothing else depends on it."""
    bare = {id(model.engine): copy.copy(model.engine) for model in models}
    for engine in bare.values():
        engine.opt.enableflags &= ~int(mujoco.mjtEnableBit.mjENBL_ENERGY)
    return [bare[id(model.engine)] for model in models]


def _start_states(models: Sequence[Model]) -> Array:
    """What the structures start in, (structure, number)."""
    batch = Batch(models[0].engine, len(models), 1)
    batch.set_models([model.engine for model in models])
    batch.bind("qpos")[:] = [start_position(model) for model in models]
    if batch.model.nplastic:
        batch.bind("plastic")[:] = [_start_creep(model) for model in models]
    return np.array(batch.state)


def start_position(model: Model) -> Array:
    """Positions at the start; what slides starts where it is built."""
    position = np.array(model.engine.qpos0)
    for hinge, place in zip(model.structure.hinges, model.folds.joints.tolist(), strict=True):
        if place >= 0:
            position[place] = hinge.sense * hinge.start + 0.0  # -0 would be another bit
    return position


def _start_creep(model: Model) -> Array:
    """Plastic state at the start: a tendon that the start stretches too far has yielded when it was put there."""
    engine = model.engine
    data = mujoco.MjData(engine)
    data.qpos[:] = start_position(model)
    mujoco.mj_forward(engine, data)
    plastic = np.asarray(data.plastic.copy())
    for tendon, place, creep in zip(model.in_units.tendons, model.tendons, model.creep, strict=True):
        if tendon.law.yield_extension is not None:
            plastic[creep] = max(tendon.law.rest_length, data.ten_length[place] - tendon.law.yield_extension)
    return plastic


class _Quiet:
    """Keeps MuJoCo from writing its warnings to a file in the current folder; the record tells of what diverged.

    MuJoCo has one place for who takes its warnings: the first to ask for quiet sets it, the last one sets it back.
    """

    def __init__(self) -> None:
        self._lock, self._users, self._before = threading.Lock(), 0, None

    def __enter__(self) -> None:
        with self._lock:
            if not self._users:
                self._before = mujoco.get_mju_user_warning()
                mujoco.set_mju_user_warning(_ignore)
            self._users += 1

    def __exit__(self, *error: object) -> None:
        with self._lock:
            self._users -= 1
            if not self._users:
                mujoco.set_mju_user_warning(self._before)


def _ignore(message: str) -> None:
    """Take a warning of MuJoCo and leave it."""


_quiet = _Quiet()
