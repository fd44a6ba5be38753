"""Where each of many wings is in its protocol: what drives it, and when its stage ends."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from forficula.design import Stage
from forficula.dynamics.model import WingModel
from forficula.dynamics.record import StageEnd

Array = NDArray[np.float64]
Steps = NDArray[np.int64]

# relaxation times after which a Maxwell branch has lost 95 % of its force
_RELAXED = 3
# steps, more than any run takes
NEVER = 10**15
_GOALS = ("time", "rest", "folded", "opened")
_AT_ONCE = 1e-9  # steps
_FAR = np.radians(10.0)  # beyond a stop


class Fleet:
    """Wings of one topology on their ways through their protocols.

    Attributes:
        ended: whether each wing is done, (wing,).
        steps: that each wing has taken, (wing,).
        stage: number of the stage that each wing is in, (wing,).
        stage_start: step at which it began, (wing,).
        ends: the stages that each wing has been through.
        diverged_at: when each wing diverged, s, or None.
    """

    def __init__(self, wings: Sequence[WingModel]) -> None:
        self._wings = wings
        self._timestep = np.array([float(wing.design.protocol.timestep) for wing in wings])
        self._senses = np.array([wing.senses for wing in wings])
        self._folds = wings[0].joints[:, 3]
        protocols = [wing.design.protocol for wing in wings]
        self._folded_angle = np.array([protocol.folded_angle for protocol in protocols])
        self._opened_angle = np.array([protocol.opened_angle for protocol in protocols])
        self._least_hold = np.array([protocol.least_hold for protocol in protocols])
        self._lowest, self._highest = (np.array(each) for each in zip(*map(_far_beyond, wings), strict=True))
        self._rest_speed = np.array([wing.in_units.protocol.rest_speed for wing in wings])
        self._last = np.array([len(protocol.stages) for protocol in protocols]) - 1
        # every row as long as the longest and one more, where a wing is when it has ended
        length = int(self._last.max()) + 2
        stages = [
            [*protocol.stages, *[protocol.stages[-1]] * (length - len(protocol.stages))] for protocol in protocols
        ]
        self._goal = np.array([[_GOALS.index(stage.until) for stage in row] for row in stages])
        self._hold = self._in_steps([[stage.hold for stage in row] for row in stages])
        self._limit = self._in_steps([[stage.time_limit for stage in row] for row in stages])
        self._window = self._in_steps([[_longest_rest(wing)] for wing in wings])[:, 0]
        self._is_state = np.array([[stage.until in ("folded", "opened") for stage in row] for row in stages])
        self._may_stick = np.array(
            [[stage.drive != "none" and stage.until in ("folded", "opened") for stage in row] for row in stages]
        )
        self._torques = np.array(
            [[stage_torques(wing, stage) for stage in row] for wing, row in zip(wings, stages, strict=True)]
        )
        self._rise = np.array([protocol.rise for protocol in protocols]) / self._timestep
        self._motors = np.array([_motors(wing) for wing in wings])
        count = len(wings)
        self.ended = np.zeros(count, dtype=bool)
        self.steps: Steps = np.zeros(count, dtype=np.int64)
        self.stage: Steps = np.zeros(count, dtype=np.int64)
        self.stage_start: Steps = np.zeros(count, dtype=np.int64)
        self.ends: list[list[StageEnd]] = [[] for _ in wings]
        self.diverged_at: list[float | None] = [None] * count
        # the step since which the stage's goal has held and the wing has rested, or -1
        self._goal_since: Steps = np.full(count, -1, dtype=np.int64)
        self._rest_since: Steps = np.full(count, -1, dtype=np.int64)
        # whether the wing missed a goal or blew up, so that the rest of its protocol makes no sense
        self._stopped = np.zeros(count, dtype=bool)

    def torques(self, rows: Steps, count: int) -> Array:
        """Torques in the next steps of these wings, (row, step, 2), in their models' units.

        On every proximal turn axis and on every distal hinge, in the veins' own senses; each that of the step's middle.
        """
        passed = (self.steps - self.stage_start)[rows, None] + np.arange(count) + 0.5
        share = np.minimum(passed / np.maximum(self._rise[rows, None], _AT_ONCE), 1.0)
        return np.asarray(share[:, :, None] * self._torques[rows, self.stage[rows]][:, None])

    def last_torques(self, row: int) -> Array:
        """Torques at the end of the last stage that a wing was in, (2,), as of `torques`."""
        end = self.ends[row][-1]
        rise = self._wings[row].design.protocol.rise
        share = min((end.end - end.start) / rise, 1.0) if rise else 1.0
        return share * np.array(stage_torques(self._wings[row], end.stage))

    def controls(self, rows: Steps, torques: Array) -> Array:
        """What the motors of these wings are told in each step for these torques, (row, step, motor)."""
        return np.asarray(torques @ self._motors[rows])

    def follow(self, rows: Steps, before: Array, time: Array, position: Array, velocity: Array) -> Steps:
        """Take note of some steps of these wings, up to the end of the stage of each.

        Args:
            rows: which wings.
            before: time before the first step, (row,).
            time: after each step, (row, step).
            position: likewise, (row, step, dof).
            velocity: likewise, (row, step, dof).

        Returns:
            How many of the steps count, (row,); the others belong to another stage, with other torques.
        """
        count = position.shape[1]
        sound = _sound_steps(before, time, position, velocity)
        beyond = ((position < self._lowest[rows, None]) | (position > self._highest[rows, None])).any(axis=2)
        sound = np.minimum(sound, _first(np.asarray(beyond), count))
        stage = self.stage[rows]
        number = self.steps[rows, None] + np.arange(1, count + 1)
        resting = np.all(np.abs(velocity) <= self._rest_speed[rows, None, None], axis=2)
        reached = self._reached(rows, position, resting)
        goal_since = _since(reached, number, self._goal_since[rows])
        rest_since = _since(resting, number, self._rest_since[rows])
        # what is met for an instant only may be a bounce
        taken_to_goal = (goal_since - self.stage_start[rows, None]) * self._is_state[rows, stage][:, None]
        hold = np.maximum(self._hold[rows, stage][:, None], self._least_hold[rows, None] * taken_to_goal)
        held = reached & (number - goal_since >= hold)
        # a wing that rests short of its goal, torques and all, stays there
        short = ~reached & self._may_stick[rows, stage][:, None]
        stuck = resting & short & (number - rest_since >= self._window[rows, None])
        over = held | stuck | (number - self.stage_start[rows, None] >= self._limit[rows, stage][:, None])
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
                goal_step = int(goal_since[place, last]) if held[place, last] else None
                at_rest, at_goal = bool(resting[place, last]), bool(reached[place, last])
                self._end_stage(int(rows[place]), goal_step, at_rest=at_rest, at_goal=at_goal)
        return np.asarray(taken)

    def follow_leader(self, row: int, leader: int) -> None:
        """Put a wing where another one is, which has gone the same way so far."""
        for values in (self.steps, self.stage, self.stage_start, self._goal_since, self._rest_since, self._stopped):
            values[row] = values[leader]
        self.ends[row] = list(self.ends[leader])
        self.diverged_at[row] = self.diverged_at[leader]
        self.ended[row] = self._stopped[row] or self.stage[row] > self._last[row]

    def progress(self, row: int) -> tuple[str, float, float]:
        """Name of a wing's stage, the time so far and the longest its protocol can take, s."""
        stages = self._wings[row].design.protocol.stages[self.stage[row] :]
        start = float(self.stage_start[row] * self._timestep[row])
        passed = float(self.steps[row] * self._timestep[row])
        return stages[0].name, passed, start + sum(stage.time_limit for stage in stages)

    def _in_steps(self, times: list[list[float]]) -> Steps:
        # a time that is never over would overflow as a number of steps
        longest = NEVER * self._timestep[:, None]
        return np.asarray(np.rint(np.minimum(times, longest) / self._timestep[:, None]), dtype=np.int64)

    def _reached(self, rows: Steps, position: Array, resting: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """Whether the goal of each wing's stage holds after each step, (row, step)."""
        distal = self._senses[rows, None] * position[:, :, self._folds]
        goal = self._goal[rows, self.stage[rows]][:, None]
        folded = np.all(distal <= -self._folded_angle[rows, None, None], axis=2)
        opened = np.all(distal >= self._opened_angle[rows, None, None], axis=2)
        return np.select(
            [goal == _GOALS.index(name) for name in ("rest", "folded", "opened")], [resting, folded, opened], False
        )

    def _end_stage(self, row: int, goal_step: int | None, *, at_rest: bool, at_goal: bool) -> None:
        stage = self._wings[row].design.protocol.stages[self.stage[row]]
        timestep = float(self._timestep[row])
        self.ends[row].append(
            StageEnd(
                stage=stage,
                start=int(self.stage_start[row]) * timestep,
                end=int(self.steps[row]) * timestep,
                goal_time=None if goal_step is None else goal_step * timestep,
                at_rest=at_rest,
                at_goal=at_goal,
            )
        )
        self._stopped[row] = goal_step is None and stage.until in ("folded", "opened")
        self.ended[row] = self._stopped[row] or self.stage[row] == self._last[row]
        self.stage[row] += 1
        self.stage_start[row] = self.steps[row]
        self._goal_since[row] = self._rest_since[row] = -1


def _longest_rest(wing: WingModel) -> float:
    """How long a wing may rest short of its goal before it is stuck, s: until its branches have relaxed, too."""
    law = wing.design.tendon.law
    times = [branch.time for branch in law.branches] if law else []
    return max(wing.design.protocol.window, _RELAXED * max(times, default=0.0))


def _far_beyond(wing: WingModel) -> tuple[Array, Array]:
    """Positions far beyond the stops of a wing's hinges, (dof,) each, which no sound run comes to."""
    limited = np.array(wing.engine.jnt_limited, dtype=bool)
    low, high = np.where(limited[:, None], wing.engine.jnt_range, (-np.inf, np.inf)).T
    return low - _FAR, high + _FAR


def _first(holds: NDArray[np.bool_], count: int) -> Steps:
    """By wing, the first step at which something holds; so many where it does at none."""
    return np.where(holds.any(axis=1), holds.argmax(axis=1), count)


def _motors(wing: WingModel) -> Array:
    """Which motors follow the torque on proximal axes and which that on distal ones, as 0 and 1, (2, motor)."""
    follows = np.zeros((2, wing.engine.nu))
    for torque, motors in zip(follows, wing.motors.T, strict=True):
        torque[motors[motors >= 0]] = 1.0
    return follows


def stage_torques(wing: WingModel, stage: Stage) -> tuple[float, float]:
    """Torque of a stage on proximal and on distal axes, in the veins' own senses and the model's units."""
    protocol = wing.in_units.protocol
    return {
        "none": (0.0, 0.0),
        "fold": (protocol.fold_torque, 0.0),
        "unfold": (-protocol.unfold_torque, protocol.unfold_torque),
    }[stage.drive]


def _since(holds: NDArray[np.bool_], number: Steps, carried: Steps) -> Steps:
    """By step, the number of the step since which a condition has held without a break, (row, step).

    Args:
        holds: whether it holds after each step, (row, step).
        number: of each step, (row, step).
        carried: since when it held before, (row,), or -1 where it did not.
    """
    broken = np.maximum.accumulate(np.where(holds, -1, number), axis=1)
    before = np.where(carried >= 0, carried, number[:, 0])
    return np.where(broken < 0, before[:, None], broken + 1)


def _sound_steps(before: Array, time: Array, position: Array, velocity: Array) -> Steps:
    """How many steps each wing took before its numbers blew up, (row,); the engine then stops its clock.

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
