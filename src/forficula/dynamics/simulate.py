"""The only place where time advances: any number of wings through their protocols, in the engine, on all cores."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import mujoco
import numpy as np
from mujoco.batch import Batch
from numpy.typing import NDArray

from forficula.design import Design
from forficula.dynamics.fleet import Fleet
from forficula.dynamics.model import WingModel, compile_wing
from forficula.dynamics.record import Record
from forficula.dynamics.recorder import Chunk, Recorder
from forficula.dynamics.timestep import with_timestep

Array = NDArray[np.float64]
Progress = Callable[[str, float, float], None]

# Steps between two looks at the goals. Every step is looked at and the overshoot is taken back, so that no number
# depends on it.
_CHUNK = 50
# all that the next step depends on: time, positions and velocities first
_STATE = mujoco.mjtState.mjSTATE_INTEGRATION.value
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
    return simulate([compile_wing(with_timestep(design))], progress=progress)[0]


def simulate(
    wings: Sequence[WingModel], threads: int = 0, progress: Progress | None = None, sparse: bool = False
) -> list[Record]:
    """Take wings of one topology through their protocols, side by side.

    Args:
        wings: compiled models with the same numbers of veins and membrane nodes.
        threads: 0 for one a core; the numbers do not depend on it.
        progress: as in `run`, of the first wing that is still moving.
        sparse: keep only what states and transitions need: no rows but those at the ends of stages, no energies but
            the tendons'. What is kept has the same bits, and many wings take half the time.

    Returns:
        A record for every wing, in their order.
    """
    # MuJoCo would write its warnings to a file in the current folder; the record tells of a diverged wing
    mujoco.set_mju_user_warning(_ignore)
    engine = wings[0].engine
    batch = Batch(engine, len(wings), threads)
    batch.set_models([wing.engine for wing in wings])
    batch.bind("qpos")[:] = [_start_position(wing) for wing in wings]
    names = _DERIVED[:1] if sparse else _DERIVED
    fleet, recorders = Fleet(wings), [Recorder(wing, sparse) for wing in wings]
    while len(rows := np.flatnonzero(~fleet.ended)):
        batch.bind("ctrl")[rows] = fleet.controls(rows)
        before = batch.state[rows]
        recorded = batch.rollout(_CHUNK, record=(_STATE, *names), ids=rows)
        states = np.concatenate([before[:, None], recorded[_STATE]], axis=1)
        first, stage, begins = fleet.steps[rows], fleet.stage[rows], fleet.steps[rows] == fleet.stage_start[rows]
        time, position, velocity = np.split(states[:, :, : 1 + engine.nq + engine.nv], [1, 1 + engine.nq], axis=2)
        taken = fleet.follow(rows, time[:, :, 0], position, velocity)
        batch.state[rows] = states[np.arange(len(rows)), taken]
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
        if progress is not None and not fleet.ended[rows[0]]:
            progress(*fleet.progress(rows[0]))
    last = {name: batch.bind(name) for name in names}
    batch.forward()
    return [
        recorder.record(
            fleet.steps[row],
            batch.bind("qpos")[row],
            batch.bind("qvel")[row],
            {name: last[name][row] for name in names},
            tuple(fleet.ends[row]),
            fleet.diverged_at[row],
        )
        for row, recorder in enumerate(recorders)
    ]


def _start_position(wing: WingModel) -> Array:
    """Joint angles at the start: flat, the distal hinges bent into the overbend."""
    position = np.zeros(wing.engine.nq)
    position[wing.joints[:, 3]] = wing.senses * wing.design.protocol.initial_overbend
    return position


def _ignore(message: str) -> None:
    """Take a warning of MuJoCo and leave it."""
