"""Passage of structures through some steps: when goals, rest and divergence end a stage.

`Steps.passage` evaluates it for steps of the processor with the functions of this module. For steps that stay on a
graphics processor `dynamics/gpu` evaluates the same there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from forficula.arrays import Array, Flags, Indices
from forficula.dynamics.stepping.folds import Folds

if TYPE_CHECKING:
    from forficula.dynamics.stepping.stage_plan import Watched
    from forficula.dynamics.stepping.steps import Steps


@dataclass(frozen=True, kw_only=True)
class Conditions:
    """What ends the present stages of structures; arrays begin with the structure, and steps count from the start.

    Attributes:
        folds: of each structure.
        senses: of the hinges, (row, hinge).
        watched: coordinates that some goal bounds.
        distances: index of the tendon that measures each distance, (distance,).
        lowest: positions below which a run has diverged, (row, position).
        highest: positions above which a run has diverged, (row, position).
        rest_speed: speed below which a coordinate is at rest, (row, dof).
        least: lower bounds of the watched coordinates, (row, coordinate).
        most: upper bounds of the watched coordinates, (row, coordinate).
        has_bounds: whether the goal consists of bounds, (row,).
        ends_at_rest: whether the goal is rest, (row,).
        may_stick: whether a drive leads to the goal, (row,).
        hold: number of steps for which the goal must hold, (row,).
        least_hold: the same as a share of the steps to the goal, (row,).
        window: number of steps at rest short of the goal after which a structure is stuck, (row,).
        settled: number of steps at rest after which statics continues a quasi-static stage, (row,).
        taken: number of steps so far, (row,).
        start: step from which the steps to the goal count, (row,).
        risen: step after which the torques have risen, (row,); a quasi-static stage ignores rises.
        limit: step at which the stage ends at the latest, (row,).
        goal_since: step since which the goal has held, or -1, (row,).
        rest_since: step since which the structure has rested, or -1, (row,).
        settling: whether the structure moves in a quasi-static stage, (row,).
        snapping: whether that motion follows a lost equilibrium, so that it may meet the goal, (row,).
    """

    folds: Sequence[Folds]
    senses: Array
    watched: Watched
    distances: Indices
    lowest: Array
    highest: Array
    rest_speed: Array
    least: Array
    most: Array
    has_bounds: Flags
    ends_at_rest: Flags
    may_stick: Flags
    hold: Indices
    least_hold: Array
    window: Indices
    settled: Indices
    taken: Indices
    start: Indices
    risen: Indices
    limit: Indices
    goal_since: Indices
    rest_since: Indices
    settling: Flags
    snapping: Flags


@dataclass(frozen=True, kw_only=True)
class Passage:
    """Passage of structures through some steps, (row,) each.

    Attributes:
        sound: number of steps before the numbers diverged.
        end: number of steps up to the end of the stage; one more than all steps if it does not end.
        carried_goal: step since which the goal has held after the last step, or -1.
        carried_rest: step since which the structure has rested after the last step, or -1.
        goal_since: step since which the goal has held, at the end of the stage.
        held: whether the goal has held for long enough at the end of the stage, or the structure has settled.
        arrived: whether the goal has held for long enough at the end of the stage, if the goal counts.
        resting: whether the structure rests at the end of the stage.
        reached: whether the goal is met at the end of the stage, even for a short time.
        met: whether the goal was met after any step that counts, even for a short time.
    """

    sound: Indices
    end: Indices
    carried_goal: Indices
    carried_rest: Indices
    goal_since: Indices
    held: Flags
    arrived: Flags
    resting: Flags
    reached: Flags
    met: Flags


def passage_of(steps: Steps, conditions: Conditions) -> Passage:
    """Return the passage of structures through steps."""
    position, velocity = steps.position, steps.velocity
    count = position.shape[1]
    sound = _count_finite_steps(steps.before[:, 0], steps.time, position, velocity)
    beyond = ((position < conditions.lowest[:, None]) | (position > conditions.highest[:, None])).any(axis=2)
    sound = np.minimum(sound, _first(np.asarray(beyond), count))
    number = conditions.taken[:, None] + np.arange(1, count + 1)
    resting = np.all(np.abs(velocity) <= conditions.rest_speed[:, None], axis=2)
    reached = _reached(steps, conditions, number, resting)
    goal_since = _holds_since(reached, number, conditions.goal_since)
    rest_since = _holds_since(resting, number, conditions.rest_since)
    held = _goal_held(conditions, number, reached, goal_since)
    stuck = resting & _short(conditions, number, reached, rest_since)
    settling, arrived = conditions.settling, held
    if settling.any():
        settled = resting & (number - rest_since >= conditions.settled[:, None])
        # the motion that follows a lost equilibrium may meet the goal, the motion before statics begins may not
        arrived = held & conditions.snapping[:, None]
        held, stuck = np.where(settling[:, None], settled | arrived, held), stuck & ~settling[:, None]
    end = _first(held | stuck | (number >= conditions.limit[:, None]), count) + 1
    last = np.minimum(end, count) - 1

    def at_end(values: NDArray[Any]) -> NDArray[Any]:
        return np.asarray(values[np.arange(len(last)), last])

    return Passage(
        sound=sound,
        end=end,
        carried_goal=np.where(reached[:, -1], goal_since[:, -1], -1),
        carried_rest=np.where(resting[:, -1], rest_since[:, -1], -1),
        goal_since=at_end(goal_since),
        held=at_end(held),
        arrived=at_end(arrived),
        resting=at_end(resting),
        reached=at_end(reached),
        met=np.asarray((reached & (np.arange(count) < np.minimum(end, sound)[:, None])).any(axis=1)),
    )


def _goal_held(conditions: Conditions, number: Indices, reached: Flags, goal_since: Indices) -> Flags:
    """Return whether each structure has been at its goal for the required time after each step, (row, step).

    A goal that is met only for an instant may be a bounce.
    """
    taken_to_goal = (goal_since - conditions.start[:, None]) * conditions.has_bounds[:, None]
    hold = np.maximum(conditions.hold[:, None], conditions.least_hold[:, None] * taken_to_goal)
    return np.asarray(reached & (number - goal_since >= hold))


def _short(conditions: Conditions, number: Indices, reached: Flags, rest_since: Indices) -> Flags:
    """Return whether a resting structure has rested short of its goal for too long after each step, (row, step).

    The time counts from the moment at which its torques have risen.
    """
    since = np.maximum(rest_since, conditions.risen[:, None])
    return np.asarray(~reached & conditions.may_stick[:, None] & (number - since >= conditions.window[:, None]))


def _reached(steps: Steps, conditions: Conditions, number: Indices, resting: Flags) -> Flags:
    """Return whether the goal of each structure's stage is met after each step, (row, step).

    Rest counts as a goal after a step with the full torques, because a structure is at rest before its torques rise.
    """
    watched, angles = conditions.watched, conditions.watched.hinges
    if steps.angles is None:
        # the positions of bodies that move freely come before those of joints
        joints = conditions.folds[0].joints[angles]
        values = conditions.senses[:, None, angles] * steps.position[:, :, joints]
    else:
        taken = np.arange(1, resting.shape[1] + 1)
        values = np.array(
            [
                steps.angles_of(folds, place, steps.position[place], taken, angles)
                for place, folds in enumerate(conditions.folds)
            ]
        )
    parts = [values[:, :, watched.angles]]
    if len(watched.distances):
        # lengths are those before the step, so a distance counts one step late
        parts.append(steps.derived["ten_length"][:, :, conditions.distances[watched.distances]])
    if len(watched.sums):
        parts.append(values @ watched.sums.T)
    coordinates = np.concatenate(parts, axis=2)
    within = np.all((coordinates >= conditions.least[:, None]) & (coordinates <= conditions.most[:, None]), axis=2)
    at_rest = conditions.ends_at_rest[:, None] & resting & (number > conditions.risen[:, None])
    return np.where(conditions.has_bounds[:, None], within, at_rest)


def _first(holds: Flags, count: int) -> Indices:
    """Return the first step at which a condition holds, by structure; `count` if it never holds."""
    return np.where(holds.any(axis=1), holds.argmax(axis=1), count)


def _holds_since(holds: Flags, number: Indices, carried: Indices) -> Indices:
    """Return for each step the number of the step since which a condition has held without a break, (row, step).

    Args:
        holds: whether the condition holds after each step, (row, step).
        number: of each step, (row, step).
        carried: step since which it held before, (row,), or -1 if it did not.
    """
    broken = np.maximum.accumulate(np.where(holds, -1, number), axis=1)
    before = np.where(carried >= 0, carried, number[:, 0])
    return np.where(broken < 0, before[:, None], broken + 1)


def _count_finite_steps(before: Array, time: Array, position: Array, velocity: Array) -> Indices:
    """Return the number of steps before the numbers of each structure diverged, (row,); the engine then stops its time.

    Args:
        before: time before the first step, (row,).
        time: after each step, (row, step).
        position: after each step, (row, step, dof).
        velocity: after each step, (row, step, dof).
    """
    sound = np.full(len(time), position.shape[1])
    # check only the last step first: non-finite numbers stay non-finite, and a stopped time stays constant
    previous = time[:, -2] if time.shape[1] > 1 else before
    broken = np.flatnonzero(~_finite_steps(previous, time[:, -1:], position[:, -1:], velocity[:, -1:])[:, 0])
    sound[broken] = _finite_steps(before[broken], time[broken], position[broken], velocity[broken]).argmin(axis=1)
    return sound


def _finite_steps(before: Array, time: Array, position: Array, velocity: Array) -> Flags:
    """Return whether each step has finite numbers and an increased time, (row, step)."""
    finite = np.isfinite(position).all(axis=2) & np.isfinite(velocity).all(axis=2)
    return np.asarray(finite & (np.diff(time, axis=1, prepend=before[:, None]) > 0))
