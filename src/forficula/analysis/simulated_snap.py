"""How one hinge of a simulated structure snaps shut, to be read beside the closed form of one hinge alone."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from forficula.analysis.outcome import measure
from forficula.arrays import Array, Flags
from forficula.design import Design, shortest_sample_interval, stage_drives, with_values
from forficula.dynamics import Record
from forficula.names import ordinal
from forficula.statics import TendonHinge, fold_time, folding_sense, ideal_hinges, tendon_hinge
from forficula.statics.snap import FOLD_START, final_speed
from forficula.structure import Crossing, Structure, Transition, crossing_tendons, goal_of, hinge_bounds, structure_of

_ROWS = 200  # that a fold should have in a record


@dataclass(frozen=True, kw_only=True)
class SimulatedSnap:
    """A fold of one hinge in a run. What did not happen is None.

    Attributes:
        tendon: number of the one that lies across the hinge.
        fold_start: from which times count, rad past straight, or past where the tendon is longest.
        folded_time: from the start to the angle that the protocol calls folded, s.
        fold_time: from the start to the fold limit, s.
        largest_fold: how far it folded, rad past straight.
        peak_speed: the largest mean speed between two rows of the record, while folding, rad/s.
        sample_interval: between the rows, s.
    """

    tendon: int
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
        folded_time: from the start to the angle that the protocol calls folded, s.
        fold_time: from the start to the fold limit, s.
        final_speed: at the fold limit, rad/s.
    """

    folded_time: float | None
    fold_time: float | None
    final_speed: float | None


def inner_tendon(structure: Structure) -> int | None:
    """Number of the tendon that stands for those across one hinge each: the first that has others on either side.

    The first of all where there are fewer than three; None where there are none.
    """
    crossing = crossing_tendons(structure)
    return crossing[1] if len(crossing) > 2 else next(iter(crossing), None)


def hinge_name(structure: Structure, tendon: int) -> str:
    """What sentences call the hinge that a tendon lies across: by its label, with the tendon's in brackets.

    Where both have one label with a number, such as "vein 1", it is the "second hinge".
    """
    hinge, label = structure.hinges[crossed_hinge(structure, tendon)], _label(structure, tendon)
    name, (_, number) = hinge.label or hinge.name, _numbered(structure, tendon)
    if name != label:
        return f"{name} ({label})"
    return name if number is None else f"{ordinal(number)} hinge"


def crossed_hinge(structure: Structure, tendon: int) -> int:
    """Number of the only hinge that a tendon lies across."""
    return _crossing(structure, tendon).hinge


def folding_transition(structure: Structure, hinge: int) -> Transition | None:
    """The first transition whose goal bounds a hinge on the side to which it folds; None where none does."""
    up = folding_sense(structure.hinges[hinge]) < 0
    for transition in structure.transitions:
        least, most = hinge_bounds(structure, goal_of(structure, transition.goal))
        if 0 < (least[hinge] if up else -most[hinge]) < math.inf:
            return transition
    return None


def folded_angle(structure: Structure, hinge: int) -> float | None:
    """How far past straight a hinge counts as folded, rad: what the first transition that folds it asks of it.

    None where no transition does.
    """
    folding = folding_transition(structure, hinge)
    if folding is None:
        return None
    least, most = hinge_bounds(structure, goal_of(structure, folding.goal))
    return float(least[hinge] if folding_sense(structure.hinges[hinge]) < 0 else -most[hinge])


def fold_limit(structure: Structure, hinge: int) -> float:
    """How far past straight a hinge can fold, rad."""
    stops = structure.hinges[hinge]
    return min(stops.upper if folding_sense(stops) < 0 else -stops.lower, math.pi)


def predicted_snap(hinge: TendonHinge, folded_angle: float | None, fold_start: float = FOLD_START) -> PredictedSnap:
    """Predict the fold of a hinge from rest.

    Args:
        hinge: the hinge, folding towards negative angles.
        folded_angle: past straight, that counts as folded, rad; None where none does.
        fold_start: past where the tendon is longest, where it is let go, rad.
    """
    so_far = None if folded_angle is None else replace(hinge, fold_limit=min(folded_angle, hinge.fold_limit))
    return PredictedSnap(
        folded_time=None if so_far is None else fold_time(so_far, fold_start),
        fold_time=fold_time(hinge, fold_start),
        final_speed=final_speed(hinge, fold_start),
    )


def finely_sampled(design: Design) -> Design:
    """The design with rows so close to each other that the snap of one hinge can be timed; the motion is the same."""
    structure = structure_of(design)
    predicted = min((time for each in ideal_hinges(structure) if (time := fold_time(each)) is not None), default=None)
    interval = design.protocol.sample_interval
    if predicted is None or predicted / _ROWS >= interval:
        return design
    wanted = max(predicted / _ROWS, min(shortest_sample_interval(design, len(structure.tendons)), interval))
    return with_values(design, {"protocol.sample_interval": wanted})


def folding_rows(record: Record, hinge: int) -> Flags:
    """Which rows of a record come before anything opens a hinge again, (row,)."""
    return np.asarray(record.time <= opening_time(record, hinge))


def opening_time(record: Record, hinge: int) -> float:
    """When the first stage begins whose drive makes another transition than that which folds a hinge, s; else inf."""
    folding = folding_transition(record.structure, hinge)
    if folding is None:
        return math.inf
    others = {each.drive for each in record.structure.transitions} - {folding.drive}
    return min((end.start for end in record.stages if others & {*stage_drives(end.stage)}), default=math.inf)


def simulated_snap(record: Record, tendon: int | None = None, fold_start: float = FOLD_START) -> SimulatedSnap | None:
    """Time the fold of a hinge, from where it last passes `fold_start` to where it first arrives.

    Looks at all before another drive than the one that folds it; between rows the angle is taken as straight.

    Args:
        record: what happened.
        tendon: number of the tendon that lies across the hinge; an inner one if not given.
        fold_start: past where the tendon is longest, rad; at the overbend stop where that is farther.

    Returns:
        None where the run diverged, or no tendon lies across one hinge.
    """
    structure = record.structure
    tendon = inner_tendon(structure) if tendon is None else tendon
    if record.diverged_at is not None or tendon is None:
        return None
    hinge = crossed_hinge(structure, tendon)
    before = folding_rows(record, hinge)
    angle = record.series["hinge_angle"][before, hinge]
    time, fold = record.time[before], -folding_sense(structure.hinges[hinge]) * angle
    folded, start = folded_angle(structure, hinge), _start(structure, tendon, fold_start)
    folded_time = None if folded is None else _snap_time(time, fold, start, folded)
    leaves = _passes(time, fold, start)
    moving = time >= leaves[0] if len(leaves) else np.zeros(len(time), dtype=bool)
    return SimulatedSnap(
        tendon=tendon,
        fold_start=fold_start,
        folded_time=folded_time,
        fold_time=_snap_time(time, fold, start, fold_limit(structure, hinge)),
        largest_fold=float(fold.max()),
        peak_speed=float(np.max(np.diff(fold[moving]) / np.diff(time[moving]))) if moving.sum() > 1 else None,
        sample_interval=float(np.median(np.diff(time))) if len(time) > 1 else 0.0,
    )


def _start(structure: Structure, tendon: int, fold_start: float) -> float:
    """How far past straight the fold of a tendon's hinge counts from, rad."""
    own = _true_hinge(structure, tendon)
    return max(fold_start - own.top, -own.overbend)


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


def simulation_summary(record: Record, tendon: int | None = None) -> dict[str, Any]:
    """What a run says of the snap of one hinge, beside its prediction, as plain data with units in its keys."""
    structure, outcome = record.structure, measure(record)
    tendon = inner_tendon(structure) if tendon is None else tendon
    told: dict[str, Any] = {"status": outcome.status, "advice": outcome.advice}
    if tendon is None:
        return told
    snap, hinge = simulated_snap(record, tendon), crossed_hinge(structure, tendon)
    folded = folded_angle(structure, hinge)
    hinges = {} if structure.hinges[hinge].stiffness else _predictable(structure, tendon)
    word, number = _numbered(structure, tendon)
    return {
        **told,
        **({"tendon": structure.tendons[tendon].name} if number is None else {word: number}),
        "fold_start_deg": math.degrees(FOLD_START),
        "folded_angle_deg": None if folded is None else math.degrees(folded),
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
            for name, each in hinges.items()
            for predicted in [predicted_snap(each, folded)]
        },
    }


def _predictable(structure: Structure, tendon: int) -> dict[str, TendonHinge]:
    """The ideal hinge of a tendon, where it has one, and its true one, by name."""
    chosen, hinges = structure.tendons[tendon], {}
    if chosen.ideal is not None:
        hinges["ideal_hinge"] = tendon_hinge(structure, chosen, chosen.ideal)
    name = hinge_name(structure, tendon).partition(" (")[0].replace(" ", "_")
    return {**hinges, name: _true_hinge(structure, tendon)}


def _true_hinge(structure: Structure, tendon: int) -> TendonHinge:
    """The hinge that a tendon lies across, about its own axis."""
    return tendon_hinge(structure, structure.tendons[tendon], _crossing(structure, tendon))


def _crossing(structure: Structure, tendon: int) -> Crossing:
    crossing = structure.tendons[tendon].crossing
    assert crossing is not None
    return crossing


def _label(structure: Structure, tendon: int) -> str:
    chosen = structure.tendons[tendon]
    return chosen.label or chosen.name


def _numbered(structure: Structure, tendon: int) -> tuple[str, int | None]:
    """The word and the number that a tendon is called by, such as "vein" and 1; None where it has another name."""
    word, _, number = _label(structure, tendon).rpartition(" ")
    return word, int(number) if word and number.isdigit() else None
