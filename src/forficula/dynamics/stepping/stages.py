"""Where each of many structures is in its protocol: what drives it, and when its stage ends."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce

import numpy as np

from forficula.arrays import Array
from forficula.dynamics.engine.model import Model
from forficula.dynamics.record import StageEnd
from forficula.dynamics.stepping.stage_plan import Booleans, Numbers, stage_plan, stage_torques
from forficula.dynamics.stepping.steps import Steps

_AT_ONCE = 1e-9  # steps


class StageTracker:
    """Structures of one topology on their ways through their protocols.

    Attributes:
        ended: whether each structure is done, (structure,).
        steps: that each structure has taken, (structure,).
        stage: number of the stage that each structure is in, (structure,).
        stage_start: step at which it began, (structure,).
        ends: the stages that each structure has been through.
        diverged_at: when each structure diverged, s, or None.
    """

    def __init__(self, models: Sequence[Model]) -> None:
        self._models = models
        self._plan = stage_plan(models)
        self._risen = self._plan.risen
        self._folds = [model.folds for model in models]
        self._senses = np.array([folds.senses for folds in self._folds])
        # creases take what drives them block by block
        self._block = models[0].followed
        self._distances = models[0].distances
        self._followed, self._holds = models[0].motors, models[0].holds
        self._brakes = np.flatnonzero(models[0].brakes >= 0)
        self._braking = models[0].brakes[self._brakes]
        self._ways = np.array([model.ways for model in models])
        # where each was when its stage began
        self._begun = np.zeros((len(models), models[0].engine.nq))
        count = len(models)
        self.ended = np.zeros(count, dtype=bool)
        self.steps: Numbers = np.zeros(count, dtype=np.int64)
        self.stage: Numbers = np.zeros(count, dtype=np.int64)
        self.stage_start: Numbers = np.zeros(count, dtype=np.int64)
        self.ends: list[list[StageEnd]] = [[] for _ in models]
        self.diverged_at: list[float | None] = [None] * count
        # the step since which the stage's goal has held and it has rested, or -1
        self._goal_since: Numbers = np.full(count, -1, dtype=np.int64)
        self._rest_since: Numbers = np.full(count, -1, dtype=np.int64)
        # what it has waited in all, and what before its stage, s; since when it may rest, and when it first did, steps
        self.waited = np.zeros(count)
        self._waited_before = np.zeros(count)
        self._limit_start: Numbers = np.zeros(count, dtype=np.int64)
        self._rested: Numbers = np.full(count, -1, dtype=np.int64)
        # those that rest and are to wait
        self.waiting: list[int] = []
        # whether it missed a goal or blew up, so that the rest of its protocol makes no sense
        self._stopped = np.zeros(count, dtype=bool)

    def torques(self, rows: Numbers, count: int) -> Array:
        """Torques of the motors in the next steps of these structures, (row, step, motor), in their models' units.

        In the hinges' own senses; each that of the step's middle.
        """
        passed = (self.steps - self.stage_start)[rows, None] + self._block * (np.arange(count) // self._block + 0.5)
        rises, torques = self._plan.rise[rows, self.stage[rows]], self._plan.torques[rows, self.stage[rows]]
        total = []
        for drive in range(rises.shape[1]):
            share = np.minimum(passed / np.maximum(rises[:, drive, None], _AT_ONCE), 1.0)
            total.append(share[:, :, None] * torques[:, drive, None])
        return np.asarray(reduce(np.add, total))

    def last_torques(self, row: int) -> Array:
        """Torques at the end of the last stage that a structure was in, (motor,), as of `torques`."""
        end, model = self.ends[row][-1], self._models[row]
        total = np.zeros(len(model.structure.motors))
        for torques, rise in stage_torques(model, end.stage):
            total += (min((end.end - end.start) / rise, 1.0) if rise else 1.0) * np.array(torques)
        return total

    def controls(self, rows: Numbers, torques: Array) -> Array:
        """What the engine's controls are in each step of these structures for these torques, (row, step, control)."""
        none = np.zeros((*torques.shape[:2], 1))
        # a control that follows no motor has index -1 and reads the 0 at the end
        controls = np.concatenate([torques, none], axis=2)[:, :, self._followed]
        controls[:, :, self._brakes] = np.abs(torques[:, :, self._braking])
        holds = np.flatnonzero(self._holds >= 0)
        if len(holds):
            on = np.any(self._plan.torques[rows, self.stage[rows]][:, :, self._holds[holds]], axis=1)
            begun = np.einsum("rcd,rd->rc", self._ways[rows][:, holds], self._begun[rows])
            controls[:, :, holds] = on[:, None]
            controls[:, :, holds - 1] += (on * begun)[:, None]
        return controls

    def follow(self, rows: Numbers, steps: Steps) -> Numbers:
        """Take note of some steps of these structures, up to the end of the stage of each.

        Args:
            rows: which structures.
            steps: of these, in their models' units.

        Returns:
            How many of the steps count, (row,); the others belong to another stage, with other torques.
        """
        position, velocity = steps.position, steps.velocity
        count = position.shape[1]
        sound = _sound_steps(steps.before[:, 0], steps.time, position, velocity)
        beyond = ((position < self._plan.lowest[rows, None]) | (position > self._plan.highest[rows, None])).any(axis=2)
        sound = np.minimum(sound, _first(np.asarray(beyond), count))
        stage = self.stage[rows]
        number = self.steps[rows, None] + np.arange(1, count + 1)
        resting = np.all(np.abs(velocity) <= self._plan.rest_speed[rows, None], axis=2)
        reached = self._reached(rows, steps, resting)
        goal_since = _since(reached, number, self._goal_since[rows])
        rest_since = _since(resting, number, self._rest_since[rows])
        held = self._held(rows, number, reached, goal_since)
        stuck = resting & self._short(rows, number, reached, rest_since)
        over = held | stuck | (number - self._limit_start[rows, None] >= self._plan.limit[rows, stage][:, None])
        end = _first(over, count) + 1
        taken = np.minimum(np.minimum(end, sound), count)
        self.steps[rows] += taken
        self._goal_since[rows] = np.where(reached[:, -1], goal_since[:, -1], -1)
        self._rest_since[rows] = np.where(resting[:, -1], rest_since[:, -1], -1)
        for place in np.flatnonzero((end <= count) | (sound < count)):
            if sound[place] < min(end[place], count):
                row = int(rows[place])
                self.diverged_at[row] = float((self.steps[row] + 1) * self._plan.timestep[row])
                self._end_stage(row, None, at_rest=False, at_goal=False)
                self.ended[row] = self._stopped[row] = True
            elif end[place] <= count:
                last = end[place] - 1
                self._begun[int(rows[place])] = position[place, last]
                goal_step = int(goal_since[place, last]) if held[place, last] else None
                self._leave(int(rows[place]), goal_step, resting[place, last], reached[place, last])
        return np.asarray(taken)

    def _held(self, rows: Numbers, number: Numbers, reached: Booleans, goal_since: Numbers) -> Booleans:
        """Whether each structure has been at its goal for as long as is asked after each step, (row, step).

        What is met for an instant only may be a bounce.
        """
        stage = self.stage[rows]
        taken_to_goal = (goal_since - self.stage_start[rows, None]) * self._plan.has_bounds[rows, stage][:, None]
        hold = np.maximum(self._plan.hold[rows, stage][:, None], self._plan.least_hold[rows, None] * taken_to_goal)
        return np.asarray(reached & (number - goal_since >= hold))

    def _short(self, rows: Numbers, number: Numbers, reached: Booleans, rest_since: Numbers) -> Booleans:
        """Whether one that rests after each step does so short of its goal for too long, (row, step).

        It stays there, once its torques have risen.
        """
        stage = self.stage[rows]
        short = ~reached & self._plan.may_stick[rows, stage][:, None]
        since = np.maximum(rest_since, (self.stage_start[rows] + self._risen[rows, stage])[:, None])
        return np.asarray(short & (number - since >= self._plan.window[rows, None]))

    def _leave(self, row: int, goal_step: int | None, at_rest: bool, at_goal: bool) -> None:
        """End the stage of a structure, or let it wait first."""
        if goal_step is None or not self._plan.wait[row, self.stage[row]] > 0:
            self._end_stage(row, goal_step, at_rest=bool(at_rest), at_goal=bool(at_goal))
            return
        self._rested[row] = self._rested[row] if self._rested[row] >= 0 else self.steps[row]
        self._limit_start[row] = self.steps[row]
        self._goal_since[row] = self._rest_since[row] = -1
        self.waiting.append(row)

    def left_to_wait(self, row: int) -> tuple[float, float]:
        """What a structure that rests has yet to wait in its stage, and for how long it is stepped at least, s."""
        timestep, stage = self._plan.timestep[row], self.stage[row]
        passed = timestep * (self.steps[row] - self._rested[row]) + self.waited[row] - self._waited_before[row]
        left = self._plan.wait[row, stage] - passed
        return float(left) if left > timestep / 2 else 0.0, float(self._plan.hold[row, stage] * timestep)

    def end_wait(self, row: int) -> None:
        """End the stage of a structure that has waited, and rests."""
        self._end_stage(row, int(self.steps[row] - self._plan.hold[row, self.stage[row]]), at_rest=True, at_goal=True)

    def follow_leader(self, row: int, leader: int) -> None:
        """Put a structure where another one is, which has gone the same way so far."""
        for values in (
            self.waited,
            self._waited_before,
            self._limit_start,
            self._rested,
            self.steps,
            self.stage,
            self.stage_start,
            self._goal_since,
            self._rest_since,
            self._stopped,
            self._begun,
        ):
            values[row] = values[leader]
        self.ends[row] = list(self.ends[leader])
        self.diverged_at[row] = self.diverged_at[leader]
        self.ended[row] = self._stopped[row] or self.stage[row] > self._plan.last[row]

    def progress(self, row: int) -> tuple[str, float, float]:
        """Name of a structure's stage, the time so far and the longest its protocol can take, s."""
        stages = self._models[row].design.protocol.stages[self.stage[row] :]
        start = float(self.stage_start[row] * self._plan.timestep[row])
        passed = float(self.steps[row] * self._plan.timestep[row])
        return stages[0].name, passed, start + sum(stage.time_limit for stage in stages)

    def _reached(self, rows: Numbers, steps: Steps, resting: Booleans) -> Booleans:
        """Whether the goal of each structure's stage holds after each step, (row, step)."""
        stage, angles = self.stage[rows], self._plan.watched.hinges
        if steps.angles is None:
            watched = self._senses[rows][:, None, angles] * steps.position[:, :, angles]
        else:
            number = np.arange(1, resting.shape[1] + 1)
            watched = np.array(
                [
                    steps.angles_of(self._folds[row], place, steps.position[place], number, angles)
                    for place, row in enumerate(rows.tolist())
                ]
            )
        parts = [watched[:, :, self._plan.watched.angles]]
        if len(self._plan.watched.distances):
            # lengths are those before the step: a distance counts one step late
            parts.append(steps.derived["ten_length"][:, :, self._distances[self._plan.watched.distances]])
        if len(self._plan.watched.sums):
            parts.append(watched @ self._plan.watched.sums.T)
        watched = np.concatenate(parts, axis=2)
        least, most = self._plan.least[rows, stage][:, None], self._plan.most[rows, stage][:, None]
        within = np.all((watched >= least) & (watched <= most), axis=2)
        bounded, at_rest = (each[rows, stage][:, None] for each in (self._plan.has_bounds, self._plan.ends_at_rest))
        return np.where(bounded, within, at_rest & resting)

    def _end_stage(self, row: int, goal_step: int | None, *, at_rest: bool, at_goal: bool) -> None:
        stage = self._models[row].design.protocol.stages[self.stage[row]]
        goes_on = not self._plan.has_bounds[row, self.stage[row]] and not self._plan.wait[row, self.stage[row]] > 0
        timestep = float(self._plan.timestep[row])
        self.ends[row].append(
            StageEnd(
                stage=stage,
                start=int(self.stage_start[row]) * timestep,
                end=int(self.steps[row]) * timestep,
                goal_time=None if goal_step is None else goal_step * timestep,
                at_rest=at_rest,
                at_goal=at_goal,
                waited=float(self.waited[row] - self._waited_before[row]),
            )
        )
        self._waited_before[row] = self.waited[row]
        self._stopped[row] = goal_step is None and not goes_on
        self.ended[row] = self._stopped[row] or self.stage[row] == self._plan.last[row]
        self.stage[row] += 1
        self.stage_start[row] = self._limit_start[row] = self.steps[row]
        self._goal_since[row] = self._rest_since[row] = self._rested[row] = -1


def _first(holds: Booleans, count: int) -> Numbers:
    """By structure, the first step at which something holds; so many where it does at none."""
    return np.where(holds.any(axis=1), holds.argmax(axis=1), count)


def _since(holds: Booleans, number: Numbers, carried: Numbers) -> Numbers:
    """By step, the number of the step since which a condition has held without a break, (row, step).

    Args:
        holds: whether it holds after each step, (row, step).
        number: of each step, (row, step).
        carried: since when it held before, (row,), or -1 where it did not.
    """
    broken = np.maximum.accumulate(np.where(holds, -1, number), axis=1)
    before = np.where(carried >= 0, carried, number[:, 0])
    return np.where(broken < 0, before[:, None], broken + 1)


def _sound_steps(before: Array, time: Array, position: Array, velocity: Array) -> Numbers:
    """How many steps each structure took before its numbers blew up, (row,); the engine then stops its clock.

    Args:
        before: time before the first step, (row,).
        time: after each step, (row, step).
        position: after each step, (row, step, dof).
        velocity: likewise.
    """
    sound = np.full(len(time), position.shape[1])
    # the last step tells: numbers that are not finite stay so, and a clock that has stopped stands
    previous = time[:, -2] if time.shape[1] > 1 else before
    broken = np.flatnonzero(~_sound(previous, time[:, -1:], position[:, -1:], velocity[:, -1:])[:, 0])
    sound[broken] = _sound(before[broken], time[broken], position[broken], velocity[broken]).argmin(axis=1)
    return sound


def _sound(before: Array, time: Array, position: Array, velocity: Array) -> Booleans:
    """Whether each step left finite numbers and the clock ran, (row, step)."""
    finite = np.isfinite(position).all(axis=2) & np.isfinite(velocity).all(axis=2)
    return np.asarray(finite & (np.diff(time, axis=1, prepend=before[:, None]) > 0))
