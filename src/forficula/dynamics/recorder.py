"""What is kept of one wing's way: rows at the sample interval, and the work done between them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.dynamics.energy import damping_work, state_series, torque_power, torque_work
from forficula.dynamics.fleet import NEVER, stage_torques
from forficula.dynamics.model import WingModel
from forficula.dynamics.record import Record, StageEnd
from forficula.dynamics.stepper import Steps

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Chunk:
    """Some steps of many wings, of each within one stage.

    Attributes:
        steps: of all wings, in their models' units.
        stage: number of each wing's stage, (wing,).
        first: number of the step that each wing starts with, (wing,).
        begins: whether the stage begins with it, (wing,).
        taken: how many of each wing's steps count, (wing,).
    """

    steps: Steps
    stage: NDArray[np.int64]
    first: NDArray[np.int64]
    begins: NDArray[np.bool_]
    taken: NDArray[np.int64]


@dataclass(frozen=True, kw_only=True)
class _Rows:
    """States that are kept, (row, ...), in the model's units, and what damping and stops did until then, J."""

    number: NDArray[np.int64]
    position: Array
    velocity: Array
    next_velocity: Array
    derived: Mapping[str, Array]
    taken: Mapping[str, Array]


# some of them, where copies would take long
_Part = tuple[_Rows, slice]


class Recorder:
    """Keeps what a record needs of one wing's way."""

    def __init__(self, wing: WingModel, sparse: bool) -> None:
        """Start with nothing kept; sparse, only what the states at the ends of stages need will be."""
        self.wing = wing
        self._sparse = sparse
        protocol = wing.design.protocol
        self._timestep = float(protocol.timestep)  # s
        longest = NEVER * self._timestep
        self._window = round(min(protocol.window, longest) / self._timestep)
        self.interval = max(1, round(min(protocol.sample_interval, longest) / self._timestep))  # steps
        # number of each stage so far, and its rows from the first on, in parts
        self._stages: list[tuple[int, list[_Part]]] = []
        self._taken: dict[str, float] = {}

    def fork(self, wing: WingModel) -> Recorder:
        """A recorder of another wing that has gone the same way so far."""
        other = Recorder(wing, self._sparse)
        other._stages = [(number, [*parts]) for number, parts in self._stages]
        other._taken = dict(self._taken)
        return other

    def account(self, velocity: Array, forces: Mapping[str, Array], activation: Array) -> dict[str, Array]:
        """Add up what damping and stops do in some steps, J, and say what it is before each of them, (step,), by name.

        Args:
            velocity: before the first step and after each, (step + 1, dof), in the model's units.
            forces: generalised forces during each step, (step, dof), by MuJoCo's names.
            activation: before the first step and after each, (step + 1, activation), in the model's units.
        """
        taken: dict[str, Array] = {}
        for name, each in damping_work(self.wing, velocity, forces, activation).items():
            # one sum from the start on: it does not depend on where chunks end
            total = np.cumsum(np.concatenate([[self._taken.get(name, 0.0)], each]))
            self._taken[name] = float(total[-1])
            taken[name] = total[:-1]
        return taken

    def add(self, rows: _Rows, mine: slice, chunk: Chunk, place: int) -> None:
        """Keep some rows, of one wing of the chunk; the first one is its stage's first if the stage begins there."""
        if chunk.begins[place]:
            if self._stages:
                self._close_stage()
            first = slice(mine.start, mine.start + 1)
            self._stages.append((int(chunk.stage[place]), [_joined([(rows, first)])]))
            mine = slice(first.stop, mine.stop)
        parts = self._stages[-1][1]
        if mine.start < mine.stop:
            parts.append((rows, mine))
        if self._sparse:
            oldest = chunk.first[place] + chunk.taken[place] - self._window
            while len(parts) > 2 and parts[2][0].number[parts[2][1].start] <= oldest:
                del parts[1]

    def record(
        self,
        step: int,
        position: Array,
        velocity: Array,
        derived: Mapping[str, Array],
        stages: tuple[StageEnd, ...],
        diverged_at: float | None,
    ) -> Record:
        """The record, its last row being the state that the wing ended in after `step` steps."""
        last = _Rows(
            number=np.array([step]),
            position=position[None],
            velocity=velocity[None],
            next_velocity=velocity[None],
            derived={name: values[None] for name, values in derived.items()},
            taken={name: np.array([total]) for name, total in self._taken.items()},
        )
        self._stages[-1][1].append((last, slice(None)))
        self._close_stage()
        rows, _ = _joined([part for _, parts in self._stages for part in parts])
        return Record(
            design=self.wing.design,
            time=np.asarray(rows.number * self._timestep),
            series={**state_series(self.wing, rows.position, rows.derived), **self._torque_series(), **rows.taken},
            stages=stages,
            triangles=self.wing.membrane.triangles,
            diverged_at=diverged_at,
        )

    def _close_stage(self) -> None:
        """Copy the stage's rows together, so that they do not hold the chunks of all wings in memory."""
        parts = self._stages[-1][1]
        parts[:] = [_joined(parts)]

    def _torque_series(self) -> dict[str, Array]:
        """Work of the torques since the start, J, and their power, W, in every row of stages that are closed."""
        given = {"proximal_work": 0.0, "distal_work": 0.0}
        series: list[dict[str, Array]] = []
        stages = [(number, rows) for number, ((rows, _),) in self._stages]
        begins = [(rows.position[:1], rows.velocity[:1]) for _, rows in stages]
        for (number, rows), begin, following in zip(stages, begins, [*begins[1:], None], strict=True):
            torques = stage_torques(self.wing, self.wing.design.protocol.stages[number])
            start = begin[0][0], begin[1][0]
            work = torque_work(self.wing, torques, start, (rows.position, rows.velocity))
            power = torque_power(self.wing, torques, (rows.velocity + rows.next_velocity) / 2)
            series.append({name: given[name] + done for name, done in work.items()} | power)
            if following is not None:
                done = torque_work(self.wing, torques, start, following)
                given = {name: given[name] + float(done[name][0]) for name in given}
        return {name: np.concatenate([each[name] for each in series]) for name in series[0]}


def keep(recorders: Sequence[Recorder], chunk: Chunk) -> None:
    """Keep the states of a chunk's wings at their sample intervals and where stages begin."""
    steps, step = chunk.steps, np.arange(chunk.steps.after.shape[1])
    number = chunk.first[:, None] + step
    interval = np.array([recorder.interval for recorder in recorders])
    kept = (number % interval[:, None] == 0) | (chunk.begins[:, None] & (step == 0))
    # where a stage begins, its wing is somewhere even if its first step blows up
    counted = np.maximum(chunk.taken, chunk.begins)
    kept &= step < counted[:, None]
    # for all wings at once: a few calls do the work of thousands
    wing, before = np.nonzero(kept)
    position, velocity = np.split(steps.states(wing, before, slice(1, 1 + 2 * steps.dof)), 2, axis=1)
    speeds = slice(1 + steps.dof, 1 + 2 * steps.dof)
    inner = {name: steps.states(wing, before, place) for name, place in steps.inner.items()}
    rows = _Rows(
        number=number[wing, before],
        position=position,
        velocity=velocity,
        next_velocity=steps.states(wing, np.minimum(before + 1, chunk.taken[wing]), speeds),
        derived={name: values[wing, before] for name, values in steps.derived.items()} | inner,
        taken={name: values[wing, before] for name, values in _damping(recorders, chunk).items()},
    )
    bounds = [0, *np.cumsum(kept.sum(axis=1)).tolist()]
    for place in np.flatnonzero(counted).tolist():
        recorders[place].add(rows, slice(bounds[place], bounds[place + 1]), chunk, place)


def _damping(recorders: Sequence[Recorder], chunk: Chunk) -> dict[str, Array]:
    """By name, what damping and stops did until before each step that counts, J, (wing, step); empty without forces."""
    steps = chunk.steps
    if "qfrc_damper" not in steps.derived:
        return {}
    done: dict[str, Array] = {}
    for place, (recorder, count) in enumerate(zip(recorders, chunk.taken, strict=True)):
        velocity = np.concatenate([steps.velocity_before[place, None], steps.velocity[place, :count]])
        forces = {name: values[place, :count] for name, values in steps.derived.items()}
        for name, values in recorder.account(velocity, forces, steps.activation(place, count)).items():
            done.setdefault(name, np.zeros(steps.after.shape[:2]))[place, :count] = values
    return done


def _joined(parts: Sequence[_Part]) -> _Part:
    """Rows one after another, in memory of their own."""
    first, _ = parts[0]
    rows = _Rows(
        number=np.concatenate([rows.number[mine] for rows, mine in parts]),
        position=np.concatenate([rows.position[mine] for rows, mine in parts]),
        velocity=np.concatenate([rows.velocity[mine] for rows, mine in parts]),
        next_velocity=np.concatenate([rows.next_velocity[mine] for rows, mine in parts]),
        derived={name: np.concatenate([rows.derived[name][mine] for rows, mine in parts]) for name in first.derived},
        taken={name: np.concatenate([rows.taken[name][mine] for rows, mine in parts]) for name in first.taken},
    )
    return rows, slice(None)
