"""Snap of one hinge of a simulated structure, to be compared with the closed form of a single hinge."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from forficula.analysis.outcome import measure
from forficula.arrays import Array, Flags
from forficula.design import Design, shortest_sample_interval, stage_drives, with_values
from forficula.dynamics import Record
from forficula.names import ordinal
from forficula.statics import CrossedHinge, EnergyLandscape, fold_time, folding_sense, ideal_hinges
from forficula.statics.tree.snap import FOLD_START
from forficula.structure import Structure, Transition, crossing_tendons, goal_of, hinge_bounds, structure_of

_ROWS = 200  # wanted number of rows of a record during a fold


@dataclass(frozen=True, kw_only=True)
class SimulatedSnap:
    """Fold of one hinge in a run. Values of events that did not happen are None.

    Attributes:
        folded_time: from the start to the angle that the protocol calls folded, s.
        fold_time: from the start to the fold limit, s.
        largest_fold: largest angle past straight, rad.
        peak_speed: largest mean speed between two rows of the record while folding, rad/s.
        sample_interval: time between rows, s.
    """

    folded_time: float | None
    fold_time: float | None
    largest_fold: float
    peak_speed: float | None
    sample_interval: float


def inner_tendon(structure: Structure) -> int | None:
    """Return the number of the tendon that represents all tendons across one hinge: the second of them.

    With fewer than three such tendons it is the first; None if there are none.
    """
    crossing = crossing_tendons(structure)
    return crossing[1] if len(crossing) > 2 else next(iter(crossing), None)


def hinge_name(structure: Structure, tendon: int) -> str:
    """Return the name of the hinge that a tendon crosses: its label, with the tendon's label in brackets.

    If both have the same label with a number, such as "vein 1", the name is "second hinge".
    """
    crossing, label = structure.tendons[tendon].crossing, _label(structure, tendon)
    assert crossing is not None
    hinge, (_, number) = structure.hinges[crossing.hinge], _numbered(structure, tendon)
    name = hinge.label or hinge.name
    if name != label:
        return f"{name} ({label})"
    return name if number is None else f"{ordinal(number)} hinge"


def inner_hinge(landscape: EnergyLandscape, tendon: int | None = None) -> CrossedHinge | None:
    """Return the hinge that a tendon, by default the inner one, lies across; None if there is none."""
    tendon = inner_tendon(landscape.structure) if tendon is None else tendon
    return next((hinge for hinge in landscape.hinges if hinge.tendon == tendon), None)


def folding_transition(structure: Structure, hinge: int) -> Transition | None:
    """Return the first transition whose goal bounds a hinge on its folding side; None if there is none."""
    up = folding_sense(structure.hinges[hinge]) < 0
    for transition in structure.transitions:
        least, most = hinge_bounds(structure, goal_of(structure, transition.goal))
        if 0 < (least[hinge] if up else -most[hinge]) < math.inf:
            return transition
    return None


def folded_angle(structure: Structure, hinge: int) -> float | None:
    """Return the angle past straight at which a hinge counts as folded, rad: the goal of the first folding transition.

    It is None if no transition folds the hinge.
    """
    folding = folding_transition(structure, hinge)
    if folding is None:
        return None
    least, most = hinge_bounds(structure, goal_of(structure, folding.goal))
    return float(least[hinge] if folding_sense(structure.hinges[hinge]) < 0 else -most[hinge])


def fold_limit(structure: Structure, hinge: int) -> float:
    """Return the largest angle past straight to which a hinge can fold, rad."""
    stops = structure.hinges[hinge]
    return min(stops.upper if folding_sense(stops) < 0 else -stops.lower, math.pi)


def finely_sampled(design: Design) -> Design:
    """Return the design with a sample interval short enough to time the snap of one hinge; the motion is the same."""
    structure = structure_of(design)
    predicted = min(
        (time for ideal_hinge in ideal_hinges(structure) if (time := fold_time(ideal_hinge)) is not None), default=None
    )
    interval = design.protocol.sample_interval
    if predicted is None or predicted / _ROWS >= interval:
        return design
    wanted = max(predicted / _ROWS, min(shortest_sample_interval(design, len(structure.tendons)), interval))
    return with_values(design, {"protocol.sample_interval": wanted})


def folding_rows(record: Record, hinge: int) -> Flags:
    """Return which rows of a record come before a drive opens a hinge again, (row,)."""
    return np.asarray(record.time <= opening_time(record, hinge))


def opening_time(record: Record, hinge: int) -> float:
    """Return the start of the first stage that drives another transition than the fold of a hinge, s; inf if none."""
    folding = folding_transition(record.structure, hinge)
    if folding is None:
        return math.inf
    others = {transition.drive for transition in record.structure.transitions} - {folding.drive}
    return min((end.start for end in record.stages if others & {*stage_drives(end.stage)}), default=math.inf)


def simulated_snap(record: Record, crossed: CrossedHinge) -> SimulatedSnap | None:
    """Time the fold of a hinge, from its last passing of the predicted start to its first arrival at the end.

    Only rows before another drive than the folding one are used. The angle is interpolated linearly between rows.

    Args:
        record: of the run.
        crossed: the hinge. Its fold starts a little past the angle at which its tendon is longest, or at the overbend
            stop if that is further.

    Returns:
        None if the run diverged.
    """
    if record.diverged_at is not None:
        return None
    structure, hinge, actual = record.structure, crossed.hinge, crossed.actual
    before = folding_rows(record, hinge)
    angle = record.series["hinge_angle"][before, hinge]
    time, fold = record.time[before], -folding_sense(structure.hinges[hinge]) * angle
    folded, start = folded_angle(structure, hinge), max(actual.fold_start - actual.hinge.top, -actual.hinge.overbend)
    folded_time = None if folded is None else _snap_time(time, fold, start, folded)
    leaves = _passage_times(time, fold, start)
    moving = time >= leaves[0] if len(leaves) else np.zeros(len(time), dtype=bool)
    return SimulatedSnap(
        folded_time=folded_time,
        fold_time=_snap_time(time, fold, start, fold_limit(structure, hinge)),
        largest_fold=float(fold.max()),
        peak_speed=float(np.max(np.diff(fold[moving]) / np.diff(time[moving]))) if moving.sum() > 1 else None,
        sample_interval=float(np.median(np.diff(time))) if len(time) > 1 else 0.0,
    )


def _snap_time(time: Array, fold: Array, start: float, end: float) -> float | None:
    """Return the time from the last passing of the start to the first arrival at the end, s; None without arrival."""
    arrivals = _passage_times(time, fold, end)
    if not len(arrivals) or start >= end:
        return None
    leaves = _passage_times(time, fold, start)
    leaves = leaves[leaves < arrivals[0]]
    return float(arrivals[0] - leaves[-1]) if len(leaves) else None


def _passage_times(time: Array, fold: Array, angle: float) -> Array:
    """Return the times at which a folding hinge passes an angle, s."""
    rows = np.flatnonzero((fold[:-1] < angle) & (fold[1:] >= angle))
    share = (angle - fold[rows]) / (fold[rows + 1] - fold[rows])
    return np.asarray(time[rows] + share * (time[rows + 1] - time[rows]))


def simulation_summary(record: Record, crossed: CrossedHinge | None) -> dict[str, Any]:
    """Return the snap of one hinge in a run, and its prediction, as plain data with units in the keys."""
    structure, outcome = record.structure, measure(record)
    verdict: dict[str, Any] = {"status": outcome.status, "advice": outcome.advice}
    if crossed is None:
        return verdict
    snap, folded = simulated_snap(record, crossed), folded_angle(structure, crossed.hinge)
    word, number = _numbered(structure, crossed.tendon)
    own_name = hinge_name(structure, crossed.tendon).partition(" (")[0].replace(" ", "_")
    return {
        **verdict,
        **({"tendon": structure.tendons[crossed.tendon].name} if number is None else {word: number}),
        "fold_start_deg": math.degrees(FOLD_START),
        "folded_angle_deg": None if folded is None else math.degrees(folded),
        "folded_time_s": None if snap is None else snap.folded_time,
        "fold_time_s": None if snap is None else snap.fold_time,
        "largest_fold_deg": None if snap is None else math.degrees(snap.largest_fold),
        "peak_speed_rad_per_s": None if snap is None else snap.peak_speed,
        "sample_interval_s": None if snap is None else snap.sample_interval,
        "predicted": {
            name: {
                "folded_time_s": None if folded is None else hinge.time_to(folded),
                "fold_time_s": hinge.fold_time,
                "final_speed_rad_per_s": hinge.final_speed,
            }
            for name, hinge in (("ideal_hinge", crossed.ideal), (own_name, crossed.actual))
            if hinge is not None and hinge.spring is None
        },
    }


def _label(structure: Structure, tendon: int) -> str:
    chosen = structure.tendons[tendon]
    return chosen.label or chosen.name


def _numbered(structure: Structure, tendon: int) -> tuple[str, int | None]:
    """Return word and number of a tendon's label, such as "vein" and 1; the number is None for another label."""
    word, _, number = _label(structure, tendon).rpartition(" ")
    return word, int(number) if word and number.isdigit() else None
