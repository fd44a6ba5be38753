"""What is kept of one wing's way: rows at the sample interval, and the work done between them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from forficula.dynamics.energy import damping_work, state_series, torque_power, torque_work
from forficula.dynamics.fleet import stage_torques
from forficula.dynamics.model import WingModel
from forficula.dynamics.record import Record, StageEnd

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Chunk:
    """Some steps of one wing within one stage, in its model's units.

    Attributes:
        stage: number of the stage.
        first: number of the step that the first row comes before.
        begins: whether the stage begins with it.
        position: before the first step and after each, (step + 1, dof).
        velocity: likewise, (step + 1, dof).
        derived: MuJoCo's fields of the state before each step, (step, ...).
    """

    stage: int
    first: int
    begins: bool
    position: Array
    velocity: Array
    derived: Mapping[str, Array]


@dataclass(frozen=True, kw_only=True)
class _Rows:
    """States that are kept, (row, ...), in the model's units, and what damping and stops did until then, J."""

    number: NDArray[np.int64]
    position: Array
    velocity: Array
    next_velocity: Array
    derived: Mapping[str, Array]
    taken: Mapping[str, Array]


@dataclass(frozen=True, kw_only=True)
class _StageRows:
    """The rows of a stage, and the state that it began with."""

    number: int
    position: Array
    velocity: Array
    rows: list[_Rows] = field(default_factory=list)


class Recorder:
    """Keeps what a record needs of one wing's way."""

    def __init__(self, wing: WingModel, sparse: bool) -> None:
        """Start with nothing kept; sparse, only what the states at the ends of stages need will be."""
        self.wing = wing
        self._sparse = sparse
        protocol = wing.design.protocol
        self._timestep = float(protocol.timestep)  # s
        self._window = round(protocol.window / self._timestep)
        self._interval = max(1, round(protocol.sample_interval / self._timestep))
        self._stages: list[_StageRows] = []
        self._taken: dict[str, float] = {}

    def fork(self, wing: WingModel) -> Recorder:
        """A recorder of another wing that has gone the same way so far."""
        other = Recorder(wing, self._sparse)
        other._stages = [replace(stage, rows=[*stage.rows]) for stage in self._stages]
        other._taken = dict(self._taken)
        return other

    def keep(self, chunk: Chunk) -> None:
        """Account for a chunk's steps and keep the states at the sample interval and at the stage's start."""
        steps = len(chunk.position) - 1
        if not steps:
            return
        taken: dict[str, Array] = {}
        for name, each in damping_work(self.wing, chunk.velocity, chunk.derived).items():
            # one sum from the start on: it does not depend on where chunks end
            total = np.cumsum(np.concatenate([[self._taken.get(name, 0.0)], each]))
            self._taken[name] = float(total[-1])
            taken[name] = total[:-1]
        on_time = -chunk.first % self._interval
        if chunk.begins:
            first = _StageRows(number=chunk.stage, position=chunk.position[0], velocity=chunk.velocity[0])
            first.rows.append(_rows(chunk, taken, slice(0, 1)))
            self._stages.append(first)
            on_time = on_time or self._interval
        rows = self._stages[-1].rows
        if on_time < steps:
            rows.append(_rows(chunk, taken, slice(on_time, steps, self._interval)))
        if self._sparse:
            oldest = chunk.first + steps - self._window
            while len(rows) > 2 and rows[2].number[0] <= oldest:
                del rows[1]

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
        self._stages[-1].rows.append(last)
        rows = [each for stage in self._stages for each in stage.rows]
        series = {
            **state_series(
                self.wing,
                np.concatenate([each.position for each in rows]),
                {name: np.concatenate([each.derived[name] for each in rows]) for name in derived},
            ),
            **self._torque_series(),
            **{name: np.concatenate([each.taken[name] for each in rows]) for name in self._taken},
        }
        return Record(
            design=self.wing.design,
            time=np.concatenate([each.number for each in rows]) * self._timestep,
            series=series,
            stages=stages,
            triangles=self.wing.membrane.triangles,
            diverged_at=diverged_at,
        )

    def _torque_series(self) -> dict[str, Array]:
        """Work of the torques since the start, J, and their power, W, in every row."""
        given = {"proximal_work": 0.0, "distal_work": 0.0}
        parts: list[dict[str, Array]] = []
        for stage, following in zip(self._stages, [*self._stages[1:], None], strict=True):
            torques = stage_torques(self.wing, self.wing.design.protocol.stages[stage.number])
            start = stage.position, stage.velocity
            position = np.concatenate([each.position for each in stage.rows])
            velocity = np.concatenate([each.velocity for each in stage.rows])
            after = np.concatenate([each.next_velocity for each in stage.rows])
            work = torque_work(self.wing, torques, start, (position, velocity))
            power = torque_power(self.wing, torques, (velocity + after) / 2)
            parts.append({name: given[name] + done for name, done in work.items()} | power)
            if following is not None:
                ended = following.position[None], following.velocity[None]
                done = torque_work(self.wing, torques, start, ended)
                given = {name: given[name] + float(done[name][0]) for name in given}
        return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


def _rows(chunk: Chunk, taken: Mapping[str, Array], kept: slice) -> _Rows:
    return _Rows(
        number=chunk.first + np.arange(len(chunk.position) - 1)[kept],
        position=chunk.position[:-1][kept].copy(),
        velocity=chunk.velocity[:-1][kept].copy(),
        next_velocity=chunk.velocity[1:][kept].copy(),
        derived={name: values[kept].copy() for name, values in chunk.derived.items()},
        taken={name: values[kept] for name, values in taken.items()},
    )
