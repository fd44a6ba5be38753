"""Protocols of many structures as arrays, stage by stage and in steps."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import mujoco
import numpy as np
from numpy.typing import ArrayLike, NDArray

from forficula.arrays import Array
from forficula.design import StageSection, stage_drives
from forficula.dynamics.engine.model import Model, joint_ranges
from forficula.structure import StageGoal, drive_of, goal_of, sums_of

Numbers = NDArray[np.int64]
Booleans = NDArray[np.bool_]

# torques of all motors, and the time over which they rise, s
Effort = tuple[tuple[float, ...], float]

# number of relaxation times after which a Maxwell branch has lost 95 % of its force
_RELAXED = 3
# number of steps that no run reaches
NEVER = 10**15
_FAR = np.radians(45.0)  # beyond a stop: a hinge so far beyond its stop has diverged


@dataclass(frozen=True, kw_only=True)
class Watched:
    """Coordinates that some goal bounds, see `forficula.structure.goal_coordinates`.

    Attributes:
        hinges: numbers of the hinges whose angles are needed, (hinge,).
        angles: indices in `hinges` of the angles that are bounded themselves.
        distances: numbers of the bounded distances among the measured ones.
        sums: weight of each of these hinges in each bounded sum, (sum, hinge).
    """

    hinges: Numbers
    angles: Numbers
    distances: Numbers
    sums: Array

    @classmethod
    def of(cls, model: Model, kept: Numbers) -> Watched:
        """Return the coordinates of a structure with these numbers, ascending."""
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


@dataclass(frozen=True, kw_only=True)
class StagePlan:
    """Protocols of structures of one topology; all rows have the stages of the longest protocol and one more.

    Attributes:
        timestep: s, (structure,).
        last: number of the last stage, (structure,).
        lowest: positions far beyond the lower stops of hinges, below which a run has diverged, (structure, position).
        highest: positions far beyond the upper stops, (structure, position).
        rest_speed: speed below which a coordinate is at rest, per unit of time, (structure, dof).
        window: number of steps at rest short of the goal after which a structure is stuck, (structure,).
        least_hold: time for which a goal must hold, as a share of the time to the goal, (structure,).
        watched: coordinates that some goal bounds; only these are evaluated.
        least: lower bounds of these coordinates, (structure, stage, coordinate).
        most: upper bounds of these coordinates, (structure, stage, coordinate).
        ends_at_rest: whether the goal of a stage is rest, (structure, stage).
        has_bounds: whether the goal of a stage consists of bounds, (structure, stage).
        may_stick: whether a drive leads to the goal, (structure, stage).
        hold: number of steps for which the goal must hold, (structure, stage).
        limit: number of steps after which the stage ends, (structure, stage).
        wait: duration of the wait at rest, s, (structure, stage).
        torques: of every drive on all motors, in own senses and the models' units, (structure, stage, drive, motor);
            stages with fewer drives are padded with zero torques.
        rise: duration of the rise, steps, (structure, stage, drive).
        quasi_static: whether statics computes a stage, (structure, stage).
        settled: number of steps at rest after which statics takes over, (structure,).
    """

    timestep: Array
    last: Numbers
    lowest: Array
    highest: Array
    rest_speed: Array
    window: Numbers
    least_hold: Array
    watched: Watched
    least: Array
    most: Array
    ends_at_rest: Booleans
    has_bounds: Booleans
    may_stick: Booleans
    hold: Numbers
    limit: Numbers
    wait: Array
    torques: Array
    rise: Array
    quasi_static: Booleans
    settled: Numbers

    @property
    def risen(self) -> Numbers:
        """Return the number of steps after which all torques of a stage have risen, (structure, stage).

        A quasi-static stage ignores rises.
        """
        rise = np.where(self.quasi_static, 0.0, self.rise.max(axis=2))
        return np.asarray(np.ceil(np.minimum(rise, NEVER)).astype(np.int64))


def stage_plan(models: Sequence[Model]) -> StagePlan:
    """Return the stage plan of models of one topology."""
    protocols = [model.design.protocol for model in models]
    timestep = np.array([float(protocol.timestep) for protocol in protocols])
    last = np.array([len(protocol.stages) for protocol in protocols]) - 1
    length = int(last.max()) + 2
    stages = [[*protocol.stages, *[protocol.stages[-1]] * (length - len(protocol.stages))] for protocol in protocols]

    def of_stages(value: Callable[[StageSection], float | bool]) -> NDArray[Any]:
        return np.array([[value(stage) for stage in row] for row in stages])

    lowest, highest = (np.array(angles) for angles in zip(*map(divergence_bounds, models), strict=True))
    hold, wait = _in_steps(of_stages(lambda stage: stage.hold), timestep), of_stages(lambda stage: stage.wait or 0.0)
    # before every skipped interval, a waiting structure must rest for the averaging window of its states
    windows = _in_steps([[protocol.window] for protocol in protocols], timestep)
    goals = _goals(models, stages)
    return StagePlan(
        timestep=timestep,
        last=last,
        lowest=lowest,
        highest=highest,
        rest_speed=np.array([rest_speeds(model) for model in models]),
        window=_in_steps([[longest_rest(model)] for model in models], timestep)[:, 0],
        least_hold=np.array([protocol.least_hold for protocol in protocols]),
        may_stick=of_stages(lambda stage: bool(stage_drives(stage))) & goals["has_bounds"],
        hold=np.where(wait > 0, np.maximum(hold, windows), hold),
        limit=_in_steps(of_stages(lambda stage: stage.time_limit), timestep),
        wait=wait,
        quasi_static=of_stages(lambda stage: stage.quasi_static),
        settled=windows[:, 0],
        **goals,
        **_drives(models, stages, timestep),
    )


def _goals(models: Sequence[Model], stages: Sequence[Sequence[StageSection]]) -> dict[str, Any]:
    """Return the goals of all stages, by the names of a plan."""
    goals = [[stage_goal(model, stage) for stage in row] for model, row in zip(models, stages, strict=True)]
    least, most = (np.array([[getattr(goal, end) for goal in row] for row in goals]) for end in ("least", "most"))
    kept = np.flatnonzero(np.isfinite(least).any(axis=(0, 1)) | np.isfinite(most).any(axis=(0, 1)))
    return {
        "watched": Watched.of(models[0], kept),
        "least": least[:, :, kept],
        "most": most[:, :, kept],
        "ends_at_rest": np.array([[goal.kind == "rest" for goal in row] for row in goals]),
        "has_bounds": np.array([[goal.kind == "bounds" for goal in row] for row in goals]),
    }


def _drives(models: Sequence[Model], stages: Sequence[Sequence[StageSection]], timestep: Array) -> dict[str, Any]:
    """Return the drives of all stages, by the names of a plan."""
    together = max((len(stage_drives(stage)) for row in stages for stage in row), default=0) or 1
    efforts = [[_efforts(model, stage, together) for stage in row] for model, row in zip(models, stages, strict=True)]
    rise = np.array([[[rise for _, rise in drives] for drives in row] for row in efforts])
    return {
        "torques": np.array([[[torques for torques, _ in drives] for drives in row] for row in efforts]),
        "rise": rise / timestep[:, None, None],
    }


def _in_steps(times: ArrayLike, timestep: Array) -> Numbers:
    # an infinite time would overflow as a number of steps
    longest = NEVER * timestep[:, None]
    return np.asarray(np.rint(np.minimum(times, longest) / timestep[:, None]), dtype=np.int64)


def rest_speeds(model: Model) -> Array:
    """Return speeds below which a structure rests, per unit of time, (dof,); for slides they scale with its size."""
    speed = model.design.protocol.rest_speed / (1 / model.units.time)
    engine, kinds = model.engine, mujoco.mjtJoint
    joint = np.array(engine.dof_jntid)
    kind, place = np.array(engine.jnt_type)[joint], np.arange(engine.nv) - np.array(engine.jnt_dofadr)[joint]
    slides = (kind == kinds.mjJNT_SLIDE) | ((kind == kinds.mjJNT_FREE) & (place < 3))
    return np.where(slides, speed * model.in_units.span, speed)


def longest_rest(model: Model) -> float:
    """Return the time at rest short of the goal after which a structure is stuck, s.

    It includes the relaxation of Maxwell branches, except those whose relaxation time is longer than every stage.
    """
    protocol = model.design.protocol
    longest = max(stage.time_limit for stage in protocol.stages)
    times = [branch.time for tendon in model.structure.tendons for branch in tendon.law.branches]
    times += [branch.time for hinge in model.structure.hinges for branch in hinge.branches]
    return max(protocol.window, _RELAXED * max((time for time in times if time <= longest), default=0.0))


def divergence_bounds(model: Model) -> tuple[Array, Array]:
    """Return positions far beyond the lower and upper stops of hinges, (position,) each, which mark divergence."""
    low, high = joint_ranges(model)
    return low - _FAR, high + _FAR


def stage_torques(model: Model, stage: StageSection) -> tuple[Effort, ...]:
    """Return for every drive of a stage the torques of all motors, in own senses and the model's units, and rise, s."""
    return tuple(
        (drive_of(model.in_units, name).strengths, drive_of(model.structure, name).rise) for name in stage_drives(stage)
    )


def _efforts(model: Model, stage: StageSection, count: int) -> tuple[Effort, ...]:
    """Return the drives of a stage, padded with zero torques to a number of drives."""
    torques = stage_torques(model, stage)
    nothing: Effort = ((0.0,) * len(model.structure.motors), 0.0)
    return (*torques, *[nothing] * (count - len(torques)))


def stage_goal(model: Model, stage: StageSection) -> StageGoal:
    """Return the goal of a stage, in the model's units."""
    return goal_in_units(model, goal_of(model.structure, stage.until))


def goal_in_units(model: Model, goal: StageGoal) -> StageGoal:
    """Return a goal of a structure in its model's units; bounds on distances are converted from SI."""
    hinges = len(model.structure.hinges)
    place = np.arange(len(goal.least)) - hinges
    unit = np.where((place < 0) | (place >= len(model.distances)), 1.0, model.units.length)
    return replace(goal, least=goal.least / unit, most=goal.most / unit)
