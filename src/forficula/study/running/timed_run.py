"""A run's times, to a fraction of a step: when its goals were reached."""

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
    """What must not change with a timestep."""

    holds: tuple[bool, ...]
    diverged: bool
    untrusted: bool


@dataclass(frozen=True, kw_only=True)
class TimedRun:
    """What is kept of a run.

    Attributes:
        status: in a few words.
        word: that without its numbers.
        verdict: on it.
        outcome: what must not change.
        transition_times: by transition, from the start of its stage until the last of what its goal bounds crosses its
            bound for good, s; nan where it did not.
        starts: by transition, when its stage began, s; nan where it did not.
        times: of the rows, s, (row,).
        hinge: number of the hinge that is followed, among those of the first measure, from 0.
        angle: what that measure reads of it, rad, (row,).
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
    """Time a run's transitions.

    Args:
        record: with every step, or nearly so.
        hinge: number of the hinge to follow, among those of the first measure, from 0; the last if not given, or where
            there are fewer.
    """
    outcome, structure = measure(record), record.structure
    angle = record.measured(structure.measures[0].name)
    last = angle.shape[1] - 1
    followed = last if hinge is None else min(hinge, last)
    ends = {
        each.name: record.stages[each.stage]
        for each in structure.transitions
        if each.stage is not None and each.stage < len(record.stages)
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
            each.name: _crossing(record, ends.get(each.name), _distance(record, each))
            if outcome.holds[each.state]
            else math.nan
            for each in structure.transitions
        },
        starts={each.name: ends[each.name].start if each.name in ends else math.nan for each in structure.transitions},
        times=record.time,
        hinge=followed,
        angle=angle[:, followed].copy(),
    )


def _distance(record: Record, transition: Transition) -> Array:
    """How far the furthest of what a goal bounds is from its bound, (row,), <= 0 where the goal is reached."""
    goal = goal_of(record.structure, transition.goal)
    angles = goal_coordinates(record.structure, record.series["hinge_angle"], record.series.get("distance"))
    above, below = np.isfinite(goal.most), np.isfinite(goal.least)
    distances: Array = np.max([*(angles - goal.most).T[above], *(goal.least - angles).T[below]], axis=0)
    return distances


def _crossing(record: Record, end: StageEnd | None, distance: Array) -> float:
    """Time from the start of a stage until its goal was reached, s, between the two steps about it.

    The goal's own time is a multiple of the step: that alone would make an error of order 1, whatever the integrator's.
    Semi-implicit Euler's velocity is constant over a step, so that its angles do go straight in between.

    Args:
        record: with every step, or nearly so.
        end: the stage.
        distance: from the goal, (row,), <= 0 where reached.
    """
    if end is None or end.goal_time is None:
        return math.nan
    timestep = float(record.design.protocol.timestep)
    # half a step, for times are multiples of it up to rounding
    after = int(np.searchsorted(record.time, end.goal_time - timestep / 2))
    left, right = distance[after - 1], distance[after]
    share = left / (left - right) if left > 0 >= right else float(right > 0)
    moment = record.time[after - 1] + share * (record.time[after] - record.time[after - 1])
    return float(np.clip(moment, end.goal_time - timestep, end.goal_time)) - end.start
