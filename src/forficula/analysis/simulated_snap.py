"""How one hinge of a simulated wing snaps shut, to be read beside the closed form of one hinge alone."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from forficula.analysis.outcome import measure
from forficula.design import Design, shortest_sample_interval, stage_drives, with_values
from forficula.dynamics import Record
from forficula.names import ordinal
from forficula.statics import TendonHinge, fold_time, ideal_hinge, tendon_hinges
from forficula.statics.snap import FOLD_START, final_speed
from forficula.structure import Structure, goal_of, structure_of

Array = NDArray[np.float64]

INNER_VEIN = 1  # the first with a panel on either side
_ROWS = 200  # that a fold should have in a record


@dataclass(frozen=True, kw_only=True)
class SimulatedSnap:
    """A fold of one hinge in a run. What did not happen is None.

    Attributes:
        vein: whose hinge.
        fold_start: from which times count, rad past straight.
        folded_time: from the start to the protocol's folded angle, s.
        fold_time: from the start to the fold limit, s.
        largest_fold: how far it folded, rad past straight.
        peak_speed: the largest mean speed between two rows of the record, while folding, rad/s.
        sample_interval: between the rows, s.
    """

    vein: int
    fold_start: float
    folded_time: float | None
    fold_time: float | None
    largest_fold: float
    peak_speed: float | None
    sample_interval: float


@dataclass(frozen=True, kw_only=True)
class PredictedSnap:
    """A fold of one hinge alone, without damping, let go at rest. What does not happen is None.

    Attributes:
        folded_time: from the start to the protocol's folded angle, s.
        fold_time: from the start to the fold limit, s.
        final_speed: at the fold limit, rad/s.
    """

    folded_time: float | None
    fold_time: float | None
    final_speed: float | None


def predicted_snap(hinge: TendonHinge, folded_angle: float, fold_start: float = FOLD_START) -> PredictedSnap:
    """Predict the fold of a hinge from rest.

    Args:
        hinge: the hinge.
        folded_angle: past straight, that counts as folded, rad.
        fold_start: past straight, where it is let go, rad.
    """
    so_far = replace(hinge, fold_limit=min(folded_angle, hinge.fold_limit))
    return PredictedSnap(
        folded_time=fold_time(so_far, fold_start),
        fold_time=fold_time(hinge, fold_start),
        final_speed=final_speed(hinge, fold_start),
    )


def finely_sampled(design: Design) -> Design:
    """The design with rows so close to each other that the snap of one hinge can be timed; the motion is the same."""
    structure, interval = structure_of(design), design.protocol.sample_interval
    hinge = ideal_hinge(structure)
    predicted = None if hinge is None else fold_time(hinge)
    if predicted is None or predicted / _ROWS >= interval:
        return design
    wanted = max(predicted / _ROWS, min(shortest_sample_interval(design, len(structure.tendons)), interval))
    return with_values(design, {"protocol.sample_interval": wanted})


def simulated_snap(record: Record, vein: int = INNER_VEIN, fold_start: float = FOLD_START) -> SimulatedSnap | None:
    """Time the fold of a hinge, from where it last passes `fold_start` to where it first arrives.

    Looks at all before the stage of a second transition; between rows the angle is taken as straight.

    Args:
        record: of a structure whose first transition folds it.
        vein: number of the hinge, among those that one tendon lies across.
        fold_start: past straight, rad.

    Returns:
        None where the run diverged.
    """
    if record.diverged_at is not None:
        return None
    structure, hinge = record.structure, _crossed(record.structure)[vein]
    later = {each.drive for each in structure.transitions[1:]}
    opening = [end.start for end in record.stages if later.intersection(stage_drives(end.stage))]
    before = record.time <= min(opening, default=math.inf)
    time, fold = record.time[before], -record.series["hinge_angle"][before, hinge]
    ends = (_folded_angle(structure, vein), -structure.hinges[hinge].lower)
    arrivals = [_snap_time(time, fold, fold_start, end) for end in ends]
    leaves = _passes(time, fold, fold_start)
    moving = time >= leaves[0] if len(leaves) else np.zeros(len(time), dtype=bool)
    return SimulatedSnap(
        vein=vein,
        fold_start=fold_start,
        folded_time=arrivals[0],
        fold_time=arrivals[1],
        largest_fold=float(fold.max()),
        peak_speed=float(np.max(np.diff(fold[moving]) / np.diff(time[moving]))) if moving.sum() > 1 else None,
        sample_interval=float(np.median(np.diff(time))) if len(time) > 1 else 0.0,
    )


def _crossed(structure: Structure) -> list[int]:
    """Numbers of the hinges that one tendon each lies across, by tendon."""
    return [tendon.crossing.hinge for tendon in structure.tendons if tendon.crossing is not None]


def _folded_angle(structure: Structure, vein: int) -> float:
    """How far past straight such a hinge must fold for the first transition, rad."""
    return -float(goal_of(structure, structure.transitions[0].goal).most[_crossed(structure)[vein]])


def _snap_time(time: Array, fold: Array, start: float, end: float) -> float | None:
    """From the last passing of the start before the first arrival at the end, s; None where there is none."""
    arrivals = _passes(time, fold, end)
    if not len(arrivals) or start >= end:
        return None
    leaves = _passes(time, fold, start)
    leaves = leaves[leaves < arrivals[0]]
    return float(arrivals[0] - leaves[-1]) if len(leaves) else None


def _passes(time: Array, fold: Array, angle: float) -> Array:
    """When a folding hinge passes an angle, s."""
    rows = np.flatnonzero((fold[:-1] < angle) & (fold[1:] >= angle))
    share = (angle - fold[rows]) / (fold[rows + 1] - fold[rows])
    return np.asarray(time[rows] + share * (time[rows + 1] - time[rows]))


def simulation_summary(record: Record, vein: int = INNER_VEIN) -> dict[str, Any]:
    """What a run says of the snap of one vein's hinge, beside its prediction, as plain data with units in its keys."""
    structure, outcome, snap = record.structure, measure(record), simulated_snap(record, vein)
    folded_angle = _folded_angle(structure, vein)
    hinges = {"ideal_hinge": ideal_hinge(structure), f"{ordinal(vein)}_hinge": tendon_hinges(structure)[vein]}
    return {
        "status": outcome.status,
        "advice": outcome.advice,
        "vein": vein,
        "fold_start_deg": math.degrees(FOLD_START),
        "folded_angle_deg": math.degrees(folded_angle),
        "folded_time_s": None if snap is None else snap.folded_time,
        "fold_time_s": None if snap is None else snap.fold_time,
        "largest_fold_deg": None if snap is None else math.degrees(snap.largest_fold),
        "peak_speed_rad_per_s": None if snap is None else snap.peak_speed,
        "sample_interval_s": None if snap is None else snap.sample_interval,
        "predicted": {
            name: {
                "folded_time_s": predicted.folded_time,
                "fold_time_s": predicted.fold_time,
                "final_speed_rad_per_s": predicted.final_speed,
            }
            for name, hinge in hinges.items()
            if hinge is not None
            for predicted in [predicted_snap(hinge, folded_angle)]
        },
    }
