"""The only place where time advances: any number of wings through their protocols, in the engine, on all cores."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import mujoco
import numpy as np
from mujoco.batch import Batch

from forficula.design import Design
from forficula.dynamics.course import Chunk, Course
from forficula.dynamics.model import WingModel, compile_wing
from forficula.dynamics.record import Record
from forficula.dynamics.timestep import with_timestep

Progress = Callable[[str, float, float], None]

# Steps between two looks at the goals. Every step is looked at and the overshoot is taken back, so that no number
# depends on it.
_CHUNK = 50
# all that the next step depends on: time, positions and velocities first
_STATE = mujoco.mjtState.mjSTATE_INTEGRATION.value
_FORCES = ("qfrc_actuator", "qfrc_damper", "qfrc_constraint")
_DERIVED = ("energy", "ten_length", "flexvert_xpos", "xpos", "xipos", "site_xpos", *_FORCES)


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


def simulate(wings: Sequence[WingModel], threads: int = 0, progress: Progress | None = None) -> list[Record]:
    """Take wings of one topology through their protocols, side by side.

    Args:
        wings: compiled models with the same numbers of veins and membrane nodes.
        threads: 0 for one a core; the numbers do not depend on it.
        progress: as in `run`, of the first wing that is still moving.

    Returns:
        A record for every wing, in their order.
    """
    # MuJoCo would write its warnings to a file in the current folder; the record tells of a diverged wing
    mujoco.set_mju_user_warning(_ignore)
    engine = wings[0].engine
    batch = Batch(engine, len(wings), threads)
    batch.set_models([wing.engine for wing in wings])
    courses = [Course(wing) for wing in wings]
    batch.bind("qpos")[:] = [course.start_position() for course in courses]
    while moving := [row for row, course in enumerate(courses) if not course.ended]:
        batch.bind("ctrl")[moving] = [courses[row].controls() for row in moving]
        before = batch.state[moving]
        recorded = batch.rollout(_CHUNK, record=(_STATE, *_DERIVED), ids=moving)
        states = np.concatenate([before[:, None], recorded[_STATE]], axis=1)
        for place, row in enumerate(moving):
            time, position, velocity = np.split(
                states[place][:, : 1 + engine.nq + engine.nv], [1, 1 + engine.nq], axis=1
            )
            derived = {name: recorded[name][place] for name in _DERIVED}
            taken = courses[row].follow(Chunk(time=time[:, 0], position=position, velocity=velocity, derived=derived))
            batch.state[row] = states[place, taken]
        if progress is not None and not courses[moving[0]].ended:
            progress(*courses[moving[0]].progress())
    last = {name: batch.bind(name) for name in _DERIVED}
    batch.forward()
    return [
        course.record(batch.bind("qpos")[row], {name: last[name][row] for name in _DERIVED})
        for row, course in enumerate(courses)
    ]


def _ignore(message: str) -> None:
    """Take a warning of MuJoCo and leave it."""
