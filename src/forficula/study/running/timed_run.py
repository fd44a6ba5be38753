"""Times at which a run reaches its goals, interpolated within a timestep."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from forficula.analysis import Verdict, ending_word, measure
from forficula.arrays import Array
from forficula.dynamics import Record, StageEnd
from forficula.structure import Transition, goal_coordinates, goal_of


class RunKind(NamedTuple):
    """Properties of a run that must not change with the timestep."""

    holds: tuple[bool, ...]
    diverged: bool
    untrusted: bool


@dataclass(frozen=True, kw_only=True)
class TimedRun:
    """Part of a run that a convergence study keeps.

    Attributes:
        status: in a few words.
        word: status without its numbers.
        verdict: verdict of the run.
        outcome: properties that must not change.
        transition_times: by transition, time from the start of its stage until all that its goal bounds has crossed the
            bound for the last time, s; nan if the transition failed.
        starts: by transition, start time of its stage, s; nan if it did not start.
        times: times of the rows, s, (row,).
        hinge: index of the displayed hinge among those of the first measure, from 0.
        angle: reading of this measure at the hinge, rad, (row,).
    """

    status: str
    word: str
    verdict: Verdict
    outcome: RunKind
    transition_times: Mapping[str, float]
    starts: Mapping[str, float]
    times: Array
    hinge: int
    angle: Array


def timed_run(record: Record, hinge: int | None = None) -> TimedRun:
    """Compute the times of a run's transitions.

    Args:
        record: record with every step, or nearly every step.
        hinge: index of the hinge to display, among those of the first measure, from 0. By default, or if there are
            fewer hinges, the last one.
    """
    outcome, structure = measure(record), record.structure
    angle = record.measured(structure.measures[0].name)
    last = angle.shape[1] - 1
    followed = last if hinge is None else min(hinge, last)
    ends = {
        transition.name: record.stages[transition.stage]
        for transition in structure.transitions
        if transition.stage is not None and transition.stage < len(record.stages)
    }
    return TimedRun(
        status=outcome.status,
        word=ending_word(outcome.ending),
        verdict=outcome.verdict,
        outcome=RunKind(
            tuple(bool(holds) for holds in outcome.holds.values()),
            record.diverged_at is not None,
            outcome.verdict is Verdict.UNTRUSTED,
        ),
        transition_times={
            transition.name: _crossing(record, ends.get(transition.name), _distance(record, transition))
            if outcome.holds[transition.state]
            else math.nan
            for transition in structure.transitions
        },
        starts={
            transition.name: ends[transition.name].start if transition.name in ends else math.nan
            for transition in structure.transitions
        },
        times=record.time,
        hinge=followed,
        angle=angle[:, followed].copy(),
    )


def _distance(record: Record, transition: Transition) -> Array:
    """Return the largest distance from a goal's bounds, (row,); <= 0 if the goal is reached."""
    goal = goal_of(record.structure, transition.goal)
    angles = goal_coordinates(record.structure, record.series["hinge_angle"], record.series.get("distance"))
    above, below = np.isfinite(goal.most), np.isfinite(goal.least)
    distances: Array = np.max([*(angles - goal.most).T[above], *(goal.least - angles).T[below]], axis=0)
    return distances


def _crossing(record: Record, end: StageEnd | None, distance: Array) -> float:
    """Return the time from the start of a stage until its goal was reached, s, interpolated between two steps.

    The recorded goal time is a multiple of the step, which alone would cause an error of order 1. Linear interpolation
    is exact enough, because the velocity of semi-implicit Euler is constant over a step.

    Args:
        record: record with every step, or nearly every step.
        end: end of the stage.
        distance: distance from the goal, (row,), <= 0 if reached.
    """
    if end is None or end.goal_time is None:
        return math.nan
    timestep = float(record.design.protocol.timestep)
    # minus half a step, because times are multiples of the step up to rounding
    after = int(np.searchsorted(record.time, end.goal_time - timestep / 2))
    left, right = distance[after - 1], distance[after]
    share = left / (left - right) if left > 0 >= right else float(right > 0)
    moment = record.time[after - 1] + share * (record.time[after] - record.time[after - 1])
    return float(np.clip(moment, end.goal_time - timestep, end.goal_time)) - end.start
