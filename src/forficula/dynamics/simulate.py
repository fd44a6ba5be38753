"""The only place where time advances: any number of wings through their protocols, in the engine, on all cores."""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager

import mujoco
import numpy as np
from mujoco.batch import Batch
from numpy.typing import NDArray

from forficula.design import Design
from forficula.dynamics.fleet import Fleet
from forficula.dynamics.model import WingModel, compile_wing
from forficula.dynamics.record import Record
from forficula.dynamics.recorder import Chunk, Recorder
from forficula.dynamics.sharing import followers, successors
from forficula.dynamics.timestep import with_timestep

Array = NDArray[np.float64]
Progress = Callable[[str, float, float], None]

# Steps between two looks at the goals. Every step is looked at and the overshoot is taken back, so that no number
# depends on it.
_CHUNK = 100
# all that the next step depends on, and of that what a step changes: time, positions and velocities first
_STATE = mujoco.mjtState.mjSTATE_INTEGRATION.value
_MOVING = _STATE & ~mujoco.mjtState.mjSTATE_USER.value
_DERIVED = (
    "ten_length",
    "energy",
    "flexvert_xpos",
    "xpos",
    "xipos",
    "site_xpos",
    "qfrc_damper",
    "qfrc_constraint",
)


def run(design: Design, progress: Progress | None = None) -> Record:
    """Take one wing through its protocol.

    Args:
        design: what to build and what to do with it.
        progress: called now and then with the stage's name, the time so far and the longest it can take, s.

    Returns:
        What happened, sampled at the protocol's interval.

    Raises:
        InputError: the wing cannot be built.
    """
    ((_, record),) = simulate_each([compile_wing(with_timestep(design))], progress=progress)
    return record


def simulate(wings: Sequence[WingModel], threads: int = 0, sparse: bool = False) -> list[Record]:
    """Take wings of one topology through their protocols, side by side.

    Args:
        wings: compiled models with the same numbers of veins and membrane nodes.
        threads: 0 for one a core; the numbers do not depend on it.
        sparse: keep only what states and transitions need: no rows but those at the ends of stages, no energies but
            the tendons'. What is kept has the same bits, and many wings take half the time.

    Returns:
        A record for every wing, in their order.
    """
    records = dict(simulate_each(wings, threads, sparse))
    return [records[row] for row in range(len(wings))]


def simulate_each(
    wings: Sequence[WingModel],
    threads: int = 0,
    sparse: bool = False,
    progress: Progress | None = None,
    enough: Callable[[Record], bool] | None = None,
) -> Iterator[tuple[int, Record]]:
    """Do as `simulate` does, and hand on every wing's number and record as soon as it is done.

    Wings with the same engine model and the same first stages go through those together: that is one wing, until their
    torques part.

    Args:
        wings: as in `simulate`.
        threads: as in `simulate`.
        sparse: as in `simulate`.
        progress: called now and then with a stage's name, the time so far and the longest it can take, s.
        enough: wings that only their unfold torques tell apart then run one after another, in their order, until this
            is true of a record; the rest of them never run. All run if not given.
    """
    if not wings:
        return
    batch = Batch(wings[0].engine, len(wings), threads)
    batch.set_models(_without_energy(wings) if sparse else [wing.engine for wing in wings])
    batch.bind("qpos")[:] = [_start_position(wing) for wing in wings]
    names = _DERIVED[:1] if sparse else _DERIVED
    last = {name: batch.bind(name) for name in names}
    fleet, recorders = Fleet(wings), [Recorder(wing, sparse) for wing in wings]
    following = {} if enough is None else successors(wings)
    held = set(following.values())
    waiting = followers(wings, held)
    columns = _moving_columns(batch.model)
    moving = np.array([row not in waiting and row not in held for row in range(len(wings))])
    while moving.any():
        rows = np.flatnonzero(moving & ~fleet.ended)
        if len(rows):
            _advance(batch, fleet, recorders, rows, names, columns)
        for row, (leader, stages) in list(waiting.items()):
            if moving[leader] and (fleet.stage[leader] >= stages or fleet.ended[leader]):
                batch.state[row] = batch.state[leader]
                fleet.follow_leader(row, leader)
                recorders[row] = recorders[leader].fork(wings[row])
                moving[row] = row not in held
                del waiting[row]
        if progress is not None and len(rows) and not fleet.ended[rows[0]]:
            progress(*fleet.progress(rows[0]))
        done = np.flatnonzero(moving & fleet.ended)
        moving[done] = False
        with _quiet():
            batch.forward(ids=done)
        for row in done.tolist():
            state = batch.bind("qpos")[row], batch.bind("qvel")[row], {name: last[name][row] for name in names}
            record = recorders[row].record(fleet.steps[row], *state, tuple(fleet.ends[row]), fleet.diverged_at[row])
            yield row, record
            if enough is not None and row in following and not enough(record):
                held.remove(following[row])
                moving[following[row]] = following[row] not in waiting


def _advance(
    batch: Batch,
    fleet: Fleet,
    recorders: Sequence[Recorder],
    rows: NDArray[np.int64],
    names: Sequence[str],
    columns: NDArray[np.int64],
) -> None:
    """Take some wings a chunk further, none beyond the end of its stage."""
    engine = batch.model
    batch.bind("ctrl")[rows] = fleet.controls(rows)
    before = batch.state[np.ix_(rows, columns)]
    with _quiet():
        recorded = batch.rollout(_CHUNK, record=(_MOVING, *names), ids=rows)
    states = np.concatenate([before[:, None], recorded[_MOVING]], axis=1)
    first, stage, begins = fleet.steps[rows], fleet.stage[rows], fleet.steps[rows] == fleet.stage_start[rows]
    time, position, velocity = np.split(states[:, :, : 1 + engine.nq + engine.nv], [1, 1 + engine.nq], axis=2)
    taken = fleet.follow(rows, time[:, :, 0], position, velocity)
    batch.state[np.ix_(rows, columns)] = states[np.arange(len(rows)), taken]
    for place, row in enumerate(rows):
        steps = taken[place]
        recorders[row].keep(
            Chunk(
                stage=stage[place],
                first=first[place],
                begins=begins[place],
                position=position[place, : steps + 1],
                velocity=velocity[place, : steps + 1],
                derived={name: recorded[name][place, :steps] for name in names},
            )
        )


def _moving_columns(engine: mujoco.MjModel) -> NDArray[np.int64]:
    """Where in a state what a step changes lies."""
    every = np.arange(mujoco.mj_stateSize(engine, _STATE), dtype=np.float64)
    moving = np.empty(mujoco.mj_stateSize(engine, _MOVING))
    mujoco.mj_extractState(engine, every, _STATE, moving, _MOVING)
    return moving.astype(np.int64)


def _without_energy(wings: Sequence[WingModel]) -> list[mujoco.MjModel]:
    """Engine models that leave out the energy of every step; nothing else depends on it."""
    models = {id(wing.engine): copy.copy(wing.engine) for wing in wings}
    for model in models.values():
        model.opt.enableflags &= ~int(mujoco.mjtEnableBit.mjENBL_ENERGY)
    return [models[id(wing.engine)] for wing in wings]


def _start_position(wing: WingModel) -> Array:
    """Joint angles at the start: flat, the distal hinges bent into the overbend."""
    position = np.zeros(wing.engine.nq)
    position[wing.joints[:, 3]] = wing.senses * wing.design.protocol.initial_overbend
    return position


@contextmanager
def _quiet() -> Iterator[None]:
    """Keep MuJoCo from writing its warnings to a file in the current folder; the record tells of a diverged wing."""
    before = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(_ignore)
    try:
        yield
    finally:
        mujoco.set_mju_user_warning(before)


def _ignore(message: str) -> None:
    """Take a warning of MuJoCo and leave it."""
