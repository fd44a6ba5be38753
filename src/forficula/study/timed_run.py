"""A run's times, to a fraction of a step: when its goals were reached."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from forficula.analysis import Verdict, measure
from forficula.dynamics import Record, StageEnd

Array = NDArray[np.float64]


class Kind(NamedTuple):
    """What must not change with a timestep."""

    folded: bool
    opened: bool
    diverged: bool
    untrusted: bool


@dataclass(frozen=True, kw_only=True)
class TimedRun:
    """What is kept of a run.

    Attributes:
        status: in a few words.
        verdict: in a word.
        outcome: what must not change.
        fold_time: from the start of folding until the slowest hinge crosses the folded angle, s; nan where it did not.
        unfold_time: likewise until the last hinge has opened for good, s.
        fold_start: when folding began, s; nan where it did not.
        unfold_start: when unfolding began, s; nan where it did not.
        times: of the rows, s, (row,).
        hinge: number of the distal hinge that is followed, from 0.
        angle: of that hinge, folding negative, rad, (row,).
    """

    status: str
    verdict: Verdict
    outcome: Kind
    fold_time: float
    unfold_time: float
    fold_start: float
    unfold_start: float
    times: Array
    hinge: int
    angle: Array


def timed_run(record: Record, hinge: int | None = None) -> TimedRun:
    """Time a run's transitions.

    Args:
        record: with every step, or nearly so.
        hinge: number of the distal hinge to follow, from 0; the last if not given, or where there are fewer.
    """
    outcome, protocol = measure(record), record.design.protocol
    angle = record.series["distal_angle"]
    # both fall through 0 when the goal is reached
    to_fold, to_open = angle.max(axis=1) + protocol.folded_angle, protocol.opened_angle - angle.min(axis=1)
    last = angle.shape[1] - 1
    followed = last if hinge is None else min(hinge, last)
    starts = {end.stage.drive: end for end in record.stages}
    return TimedRun(
        status=outcome.status,
        verdict=outcome.verdict,
        outcome=Kind(
            bool(outcome.folded),
            bool(outcome.opened),
            record.diverged_at is not None,
            outcome.verdict is Verdict.UNTRUSTED,
        ),
        fold_time=_crossing(record, starts.get("fold"), to_fold) if outcome.folded else math.nan,
        unfold_time=_crossing(record, starts.get("unfold"), to_open) if outcome.opened else math.nan,
        fold_start=starts["fold"].start if "fold" in starts else math.nan,
        unfold_start=starts["unfold"].start if "unfold" in starts else math.nan,
        times=record.time,
        hinge=followed,
        angle=angle[:, followed].copy(),
    )


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
