"""Where each of many structures is in its protocol: what drives it, and when its stage ends."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import reduce

import mujoco
import numpy as np
from numpy.typing import NDArray

from forficula.design import Stage, stage_drives
from forficula.dynamics.model import Model, joint_ranges
from forficula.dynamics.record import StageEnd
from forficula.dynamics.steps import Steps
from forficula.structure import Goal, drive_of, goal_of, sums_of

Array = NDArray[np.float64]
Numbers = NDArray[np.int64]

# torques on all motors, and the time over which they rise, s
Effort = tuple[tuple[float, ...], float]

# relaxation times after which a Maxwell branch has lost 95 % of its force
_RELAXED = 3
# steps, more than any run takes
NEVER = 10**15
_AT_ONCE = 1e-9  # steps
_FAR = np.radians(10.0)  # beyond a stop


@dataclass(frozen=True, kw_only=True)
class _Watched:
    """The coordinates that some goal bounds, see `forficula.structure.goal_coordinates`.

    Attributes:
        hinges: numbers of those whose angles it takes, (hinge,).
        angles: places among these of the angles that are bounded themselves.
        distances: numbers of the distances, among those that are measured.
        sums: by what each of these hinges counts in each sum, (sum, hinge).
    """

    hinges: Numbers
    angles: Numbers
    distances: Numbers
    sums: Array

    @classmethod
    def of(cls, model: Model, kept: Numbers) -> _Watched:
        """Those of a structure with these numbers, rising."""
        structure = model.structure
        turns, apart = len(structure.hinges), len(model.distances)
        rows = [
            np.bincount(part, weights=[measure.signs[measure.hinges.index(hinge)] for hinge in part], minlength=turns)
            for measure in sums_of(structure)
            for part in measure.parts
        ]
        sums: Array = np.array(rows, dtype=np.float64).reshape(-1, turns)[kept[kept >= turns + apart] - turns - apart]
        angles = kept[kept < turns]
        hinges = np.union1d(angles, np.flatnonzero(sums.any(axis=0)))
        return cls(
            hinges=hinges,
            angles=np.searchsorted(hinges, angles),
            distances=kept[(kept >= turns) & (kept < turns + apart)] - turns,
            sums=sums[:, hinges],
        )


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
        self._timestep = np.array([float(model.design.protocol.timestep) for model in models])
        self._folds = [model.folds for model in models]
        self._senses = np.array([folds.senses for folds in self._folds])
        # creases take what drives them block by block
        self._block = models[0].followed
        self._distances = models[0].distances
        protocols = [model.design.protocol for model in models]
        self._least_hold = np.array([protocol.least_hold for protocol in protocols])
        self._lowest, self._highest = (np.array(each) for each in zip(*map(far_beyond, models), strict=True))
        # speeds by unit of time
        self._rest_speed = np.array([rest_speeds(model) for model in models])
        self._last = np.array([len(protocol.stages) for protocol in protocols]) - 1
        # every row as long as the longest and one more, where a structure is when it has ended
        length = int(self._last.max()) + 2
        stages = [
            [*protocol.stages, *[protocol.stages[-1]] * (length - len(protocol.stages))] for protocol in protocols
        ]
        goals = [[stage_goal(model, stage) for stage in row] for model, row in zip(models, stages, strict=True)]
        least, most = (np.array([[getattr(goal, end) for goal in row] for row in goals]) for end in ("least", "most"))
        # only what some goal bounds is looked at
        kept = np.flatnonzero(np.isfinite(least).any(axis=(0, 1)) | np.isfinite(most).any(axis=(0, 1)))
        self._least, self._most = least[:, :, kept], most[:, :, kept]
        self._watched = _Watched.of(models[0], kept)
        self._ends_at_rest = np.array([[goal.kind == "rest" for goal in row] for row in goals])
        self._has_bounds = np.array([[goal.kind == "bounds" for goal in row] for row in goals])
        self._hold = self._in_steps([[stage.hold for stage in row] for row in stages])
        self._limit = self._in_steps([[stage.time_limit for stage in row] for row in stages])
        self._wait = np.array([[stage.wait or 0.0 for stage in row] for row in stages])
        # a structure that waits rests for as long before every leap as its states are averaged over
        windows = self._in_steps([[protocol.window] for protocol in protocols])
        self._hold = np.where(self._wait > 0, np.maximum(self._hold, windows), self._hold)
        self._window = self._in_steps([[longest_rest(model)] for model in models])[:, 0]
        driven = np.array([[bool(stage_drives(stage)) for stage in row] for row in stages])
        self._may_stick = driven & self._has_bounds
        # the drives of every stage, of as many as the stage with the most; the others push with nothing
        together = max((len(stage_drives(stage)) for row in stages for stage in row), default=0) or 1
        efforts = [
            [_efforts(model, stage, together) for stage in row] for model, row in zip(models, stages, strict=True)
        ]
        self._torques = np.array([[[torques for torques, _ in drives] for drives in row] for row in efforts])
        self._rise = np.array([[[rise for _, rise in drives] for drives in row] for row in efforts])
        self._rise = self._rise / self._timestep[:, None, None]
        self._risen = np.ceil(self._rise.max(axis=2)).astype(np.int64)
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
        rises, torques = self._rise[rows, self.stage[rows]], self._torques[rows, self.stage[rows]]
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
            on = np.any(self._torques[rows, self.stage[rows]][:, :, self._holds[holds]], axis=1)
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
        beyond = ((position < self._lowest[rows, None]) | (position > self._highest[rows, None])).any(axis=2)
        sound = np.minimum(sound, _first(np.asarray(beyond), count))
        stage = self.stage[rows]
        number = self.steps[rows, None] + np.arange(1, count + 1)
        resting = np.all(np.abs(velocity) <= self._rest_speed[rows, None], axis=2)
        reached = self._reached(rows, steps, resting)
        goal_since = _since(reached, number, self._goal_since[rows])
        rest_since = _since(resting, number, self._rest_since[rows])
        # what is met for an instant only may be a bounce
        taken_to_goal = (goal_since - self.stage_start[rows, None]) * self._has_bounds[rows, stage][:, None]
        hold = np.maximum(self._hold[rows, stage][:, None], self._least_hold[rows, None] * taken_to_goal)
        held = reached & (number - goal_since >= hold)
        # a structure that rests short of its goal stays there, once its torques have risen
        short = ~reached & self._may_stick[rows, stage][:, None]
        rest_since = np.maximum(rest_since, (self.stage_start[rows] + self._risen[rows, stage])[:, None])
        stuck = resting & short & (number - rest_since >= self._window[rows, None])
        over = held | stuck | (number - self._limit_start[rows, None] >= self._limit[rows, stage][:, None])
        end = _first(over, count) + 1
        taken = np.minimum(np.minimum(end, sound), count)
        self.steps[rows] += taken
        self._goal_since[rows] = np.where(reached[:, -1], goal_since[:, -1], -1)
        self._rest_since[rows] = np.where(resting[:, -1], rest_since[:, -1], -1)
        for place in np.flatnonzero((end <= count) | (sound < count)):
            if sound[place] < min(end[place], count):
                row = int(rows[place])
                self.diverged_at[row] = float((self.steps[row] + 1) * self._timestep[row])
                self._end_stage(row, None, at_rest=False, at_goal=False)
                self.ended[row] = self._stopped[row] = True
            elif end[place] <= count:
                last = end[place] - 1
                row = int(rows[place])
                goal_step = int(goal_since[place, last]) if held[place, last] else None
                self._begun[row] = position[place, last]
                if goal_step is not None and self._wait[row, self.stage[row]] > 0:
                    self._rested[row] = self._rested[row] if self._rested[row] >= 0 else self.steps[row]
                    self._limit_start[row] = self.steps[row]
                    self._goal_since[row] = self._rest_since[row] = -1
                    self.waiting.append(row)
                    continue
                at_rest, at_goal = bool(resting[place, last]), bool(reached[place, last])
                self._end_stage(row, goal_step, at_rest=at_rest, at_goal=at_goal)
        return np.asarray(taken)

    def left_to_wait(self, row: int) -> tuple[float, float]:
        """What a structure that rests has yet to wait in its stage, and for how long it is stepped at least, s."""
        timestep, stage = self._timestep[row], self.stage[row]
        passed = timestep * (self.steps[row] - self._rested[row]) + self.waited[row] - self._waited_before[row]
        left = self._wait[row, stage] - passed
        return float(left) if left > timestep / 2 else 0.0, float(self._hold[row, stage] * timestep)

    def end_wait(self, row: int) -> None:
        """End the stage of a structure that has waited, and rests."""
        self._end_stage(row, int(self.steps[row] - self._hold[row, self.stage[row]]), at_rest=True, at_goal=True)

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
        self.ended[row] = self._stopped[row] or self.stage[row] > self._last[row]

    def progress(self, row: int) -> tuple[str, float, float]:
        """Name of a structure's stage, the time so far and the longest its protocol can take, s."""
        stages = self._models[row].design.protocol.stages[self.stage[row] :]
        start = float(self.stage_start[row] * self._timestep[row])
        passed = float(self.steps[row] * self._timestep[row])
        return stages[0].name, passed, start + sum(stage.time_limit for stage in stages)

    def _in_steps(self, times: list[list[float]]) -> Numbers:
        # a time that is never over would overflow as a number of steps
        longest = NEVER * self._timestep[:, None]
        return np.asarray(np.rint(np.minimum(times, longest) / self._timestep[:, None]), dtype=np.int64)

    def _reached(self, rows: Numbers, steps: Steps, resting: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """Whether the goal of each structure's stage holds after each step, (row, step)."""
        stage, angles = self.stage[rows], self._watched.hinges
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
        parts = [watched[:, :, self._watched.angles]]
        if len(self._watched.distances):
            # lengths are those before the step: a distance counts one step late
            parts.append(steps.derived["ten_length"][:, :, self._distances[self._watched.distances]])
        if len(self._watched.sums):
            parts.append(watched @ self._watched.sums.T)
        watched = np.concatenate(parts, axis=2)
        least, most = self._least[rows, stage][:, None], self._most[rows, stage][:, None]
        within = np.all((watched >= least) & (watched <= most), axis=2)
        bounded, at_rest = (each[rows, stage][:, None] for each in (self._has_bounds, self._ends_at_rest))
        return np.where(bounded, within, at_rest & resting)

    def _end_stage(self, row: int, goal_step: int | None, *, at_rest: bool, at_goal: bool) -> None:
        stage = self._models[row].design.protocol.stages[self.stage[row]]
        goes_on = not self._has_bounds[row, self.stage[row]] and not self._wait[row, self.stage[row]] > 0
        timestep = float(self._timestep[row])
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
        self.ended[row] = self._stopped[row] or self.stage[row] == self._last[row]
        self.stage[row] += 1
        self.stage_start[row] = self._limit_start[row] = self.steps[row]
        self._goal_since[row] = self._rest_since[row] = self._rested[row] = -1


def rest_speeds(model: Model) -> Array:
    """Below which a structure rests, by unit of time, (dof,): of turns as it is, of slides by the structure's size."""
    speed = model.design.protocol.rest_speed / (1 / model.units.time)
    engine, kinds = model.engine, mujoco.mjtJoint
    joint = np.array(engine.dof_jntid)
    kind, place = np.array(engine.jnt_type)[joint], np.arange(engine.nv) - np.array(engine.jnt_dofadr)[joint]
    slides = (kind == kinds.mjJNT_SLIDE) | ((kind == kinds.mjJNT_FREE) & (place < 3))
    return np.where(slides, speed * model.in_units.span, speed)


def longest_rest(model: Model) -> float:
    """How long a structure may rest short of its goal before it is stuck, s: until its branches have relaxed, too.

    Those that take longer than any stage do nothing in one.
    """
    protocol = model.design.protocol
    longest = max(stage.time_limit for stage in protocol.stages)
    times = [branch.time for tendon in model.structure.tendons for branch in tendon.law.branches]
    return max(protocol.window, _RELAXED * max((time for time in times if time <= longest), default=0.0))


def far_beyond(model: Model) -> tuple[Array, Array]:
    """Positions far beyond the stops of hinges, (position,) each, which no sound run comes to."""
    low, high = joint_ranges(model)
    return low - _FAR, high + _FAR


def _first(holds: NDArray[np.bool_], count: int) -> Numbers:
    """By structure, the first step at which something holds; so many where it does at none."""
    return np.where(holds.any(axis=1), holds.argmax(axis=1), count)


def stage_torques(model: Model, stage: Stage) -> tuple[Effort, ...]:
    """Of every drive of a stage the torques on all motors, in own senses and the model's units, and the rise, s."""
    return tuple(
        (drive_of(model.in_units, name).strengths, drive_of(model.structure, name).rise) for name in stage_drives(stage)
    )


def _efforts(model: Model, stage: Stage, count: int) -> tuple[Effort, ...]:
    """So many drives of a stage, those that it lacks without torques."""
    own = stage_torques(model, stage)
    nothing: Effort = ((0.0,) * len(model.structure.motors), 0.0)
    return (*own, *[nothing] * (count - len(own)))


def stage_goal(model: Model, stage: Stage) -> Goal:
    """The goal of a stage, in the model's units."""
    return goal_in_units(model, goal_of(model.structure, stage.until))


def goal_in_units(model: Model, goal: Goal) -> Goal:
    """A goal of a structure in its model's units: what is written of a distance is SI."""
    hinges = len(model.structure.hinges)
    place = np.arange(len(goal.least)) - hinges
    unit = np.where((place < 0) | (place >= len(model.distances)), 1.0, model.units.length)
    return replace(goal, least=goal.least / unit, most=goal.most / unit)


def _since(holds: NDArray[np.bool_], number: Numbers, carried: Numbers) -> Numbers:
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


def _sound(before: Array, time: Array, position: Array, velocity: Array) -> NDArray[np.bool_]:
    """Whether each step left finite numbers and the clock ran, (row, step)."""
    finite = np.isfinite(position).all(axis=2) & np.isfinite(velocity).all(axis=2)
    return np.asarray(finite & (np.diff(time, axis=1, prepend=before[:, None]) > 0))
