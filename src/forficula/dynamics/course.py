"""One wing's way through its protocol: which stage it is in, what that asks for, and what has been done so far."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.design import Stage
from forficula.dynamics.energy import state_series, step_work
from forficula.dynamics.model import WingModel
from forficula.dynamics.record import Record, StageEnd, build_record

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Chunk:
    """Some steps of one wing, in its model's units.

    Attributes:
        time: before the first step and after each, (step + 1,).
        position: likewise, (step + 1, dof).
        velocity: likewise, (step + 1, dof).
        derived: MuJoCo's fields of the state before each step, (step, ...).
    """

    time: Array
    position: Array
    velocity: Array
    derived: Mapping[str, Array]


class Course:
    """A wing on its way; `simulate` moves it, this follows."""

    def __init__(self, wing: WingModel) -> None:
        self.wing = wing
        self.protocol = wing.design.protocol
        self.timestep = float(self.protocol.timestep)  # s
        self.sample_steps = max(1, round(self.protocol.sample_interval / self.timestep))
        self.ended = False
        self.diverged_at: float | None = None
        self.ends: list[StageEnd] = []
        self._steps = 0
        self._stage_start = 0
        self._goal_since: int | None = None  # the step since which the stage's goal has held
        self._work: dict[str, float] = {}
        self._samples: list[dict[str, Array]] = []

    @property
    def stage(self) -> Stage:
        """The stage that is on, or the last one."""
        return self.protocol.stages[min(len(self.ends), len(self.protocol.stages) - 1)]

    def progress(self) -> tuple[str, float, float]:
        """The stage's name, the time so far and the longest the protocol can take, s."""
        left = sum(stage.time_limit for stage in self.protocol.stages[len(self.ends) :])
        passed = self._steps * self.timestep
        return self.stage.name, passed, passed + left - (self._steps - self._stage_start) * self.timestep

    def start_position(self) -> Array:
        """Joint angles at the start: flat, the distal hinges bent into the overbend."""
        position = np.zeros(self.wing.engine.nq)
        position[self.wing.joints[:, 3]] = self.wing.senses * self.protocol.initial_overbend
        return position

    def controls(self) -> Array:
        """Torques of the stage, in the order of the motors and in the model's units."""
        protocol = self.wing.in_units.protocol
        on_proximal, on_distal = {
            "none": (0.0, 0.0),
            "fold": (protocol.fold_torque, 0.0),
            "unfold": (-protocol.unfold_torque, protocol.unfold_torque),
        }[self.stage.drive]
        torques = np.zeros(self.wing.engine.nu)
        turn, fold = self.wing.motors.T
        torques[turn[turn >= 0]] = on_proximal
        torques[fold] = on_distal
        return torques

    def follow(self, chunk: Chunk) -> int:
        """Account for the steps of a chunk up to the end of the stage, and return how many count."""
        state = np.concatenate([chunk.position, chunk.velocity], axis=1)[1:]
        # the engine stops the clock of a wing that blows up
        sound = int(np.argmin(np.append(np.all(np.isfinite(state), axis=1) & (np.diff(chunk.time) > 0), False)))
        taken, goal_step = self._stage_end(chunk, sound)
        steps = sound if taken is None else taken
        self._account(chunk, steps)
        self._steps += steps
        if taken is not None:
            self._end_stage(goal_step)
        elif steps < len(chunk.time) - 1:
            self.diverged_at = (self._steps + 1) * self.timestep
            self._end_stage(None)
            self.ended = True
        return steps

    def record(self, position: Array, derived: Mapping[str, Array]) -> Record:
        """The record, its last row being the state that the wing ended in."""
        state = {name: values[None] for name, values in derived.items()}
        self._sample(
            position[None],
            state,
            np.array([self._steps]),
            {name: np.array([work]) for name, work in self._work.items()},
            {},
        )
        series = {name: np.concatenate([sample[name] for sample in self._samples]) for name in self._samples[0]}
        return build_record(
            self.wing.design,
            series.pop("time"),
            series,
            tuple(self.ends),
            self.wing.membrane.triangles,
            self.diverged_at,
        )

    def _stage_end(self, chunk: Chunk, sound: int) -> tuple[int | None, int | None]:
        """How many steps of the chunk the stage still takes (None: all), and the step at which its goal was reached."""
        hold = round(self.stage.hold / self.timestep)
        for step, reached in enumerate(self._goal(chunk)[:sound], start=1):
            now = self._steps + step
            self._goal_since = (self._goal_since if self._goal_since is not None else now) if reached else None
            if self._goal_since is not None and now - self._goal_since >= hold:
                return step, self._goal_since
            if now - self._stage_start >= round(self.stage.time_limit / self.timestep):
                return step, None
        return None, None

    def _goal(self, chunk: Chunk) -> NDArray[np.bool_]:
        """Whether the goal of the stage holds after each step, (step,)."""
        distal = self.wing.senses * chunk.position[1:, self.wing.joints[:, 3]]
        match self.stage.until:
            case "folded":
                there = distal <= -self.protocol.folded_angle
            case "opened":
                there = distal >= self.protocol.opened_angle
            case "rest":
                there = np.abs(chunk.velocity[1:]) <= self.wing.in_units.protocol.rest_speed
            case _:
                there = np.zeros(distal.shape, dtype=bool)
        return np.asarray(np.all(there, axis=1))

    def _end_stage(self, goal_step: int | None) -> None:
        stage = self.stage
        self.ends.append(
            StageEnd(
                stage=stage,
                start=self._stage_start * self.timestep,
                end=self._steps * self.timestep,
                goal_time=None if goal_step is None else goal_step * self.timestep,
            )
        )
        self._stage_start, self._goal_since = self._steps, None
        failed = goal_step is None and stage.until in ("folded", "opened")
        self.ended = failed or len(self.ends) == len(self.protocol.stages)

    def _account(self, chunk: Chunk, steps: int) -> None:
        """Add up the work of the first steps of a chunk and sample the states before them."""
        if not steps:
            return
        derived = {name: values[:steps] for name, values in chunk.derived.items()}
        work = step_work(self.wing, chunk.velocity[: steps + 1], derived)
        since_start = {
            name: self._work.get(name, 0.0) + np.concatenate([[0.0], np.cumsum(each)]) for name, each in work.items()
        }
        self._work = {name: float(total[-1]) for name, total in since_start.items()}
        numbers = self._steps + np.arange(steps)
        kept = (numbers % self.sample_steps == 0) | (numbers == self._stage_start)
        self._sample(
            chunk.position[:steps][kept],
            {name: values[kept] for name, values in derived.items()},
            numbers[kept],
            {name: total[:-1][kept] for name, total in since_start.items()},
            {name: each[kept] / self.timestep for name, each in work.items()},
        )

    def _sample(
        self,
        position: Array,
        derived: Mapping[str, Array],
        steps: NDArray[np.int64],
        work: Mapping[str, Array],
        power: Mapping[str, Array],
    ) -> None:
        nothing = np.zeros(len(steps))
        self._samples.append(
            {
                "time": np.asarray(steps * self.timestep, dtype=np.float64),
                **state_series(self.wing, position, derived),
                **work,
                "proximal_power": power.get("proximal_work", nothing),
                "distal_power": power.get("distal_work", nothing),
            }
        )
