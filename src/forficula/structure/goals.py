"""Drives, measures, goals and states by their names."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from forficula.arrays import Array
from forficula.design.named_protocol import Drive, RestState, Transition
from forficula.design.protocol import GoalText, read_goal
from forficula.design.section import ANGLE, LENGTH
from forficula.errors import InputError
from forficula.names import one_of
from forficula.quantities import as_written, parse_quantity
from forficula.structure.course import Measure, Motor, StageGoal
from forficula.structure.structure import Structure

_UNITS = {"torque": "N m", "force": "N", "displacement": "m", "rest-angle": "rad"}


def drive_of(structure: Structure, name: str) -> Drive:
    """The drive of a name.

    Raises:
        InputError: there is none.
    """
    for drive in structure.drives:
        if drive.name == name:
            return drive
    raise InputError(f"drive: need {one_of(['none', *_names(structure.drives)], name)}")


def driven_motor(structure: Structure, drive: Drive) -> Motor:
    """The first motor that a drive sets: of several kinds that act together, it is as strong as that."""
    set_ = (motor for motor, share in zip(structure.motors, drive.shares, strict=True) if share)
    return next(set_, structure.motors[0])


def drive_unit(structure: Structure, drive: Drive) -> str:
    """The SI unit of how strong a drive is."""
    return _UNITS[driven_motor(structure, drive).kind]


def transition_of(structure: Structure, name: str) -> Transition | None:
    """The transition that a drive of a name makes, or None."""
    return next((each for each in structure.transitions if each.drive == name), None)


def state_of(structure: Structure, name: str) -> RestState | None:
    """The state of a name, or None."""
    return next((state for state in structure.states if state.name == name), None)


def first_state(structure: Structure, names: Sequence[str]) -> str:
    """The first of some states that no transition leads to, by its name; "" where there is none.

    Args:
        structure: whose transitions count.
        names: of states, such as those that stages end in; empty ones do not count.
    """
    led_to = {transition.state for transition in structure.transitions}
    return next((name for name in names if name and name not in led_to), "")


def measure_of(structure: Structure, name: str) -> Measure | None:
    """The measure of a name; the name of a role measures all hinges of that role, in their own senses. None if none."""
    for measure in structure.measures:
        if measure.name == name:
            return measure
    hinges = hinges_of(structure, name)
    if not hinges:
        return None
    return Measure(name=name, kind="angle", hinges=hinges, signs=(1,) * len(hinges), label=f"{name} angle")


def hinges_of(structure: Structure, role: str) -> tuple[int, ...]:
    """Numbers of the hinges of a role."""
    return tuple(number for number, hinge in enumerate(structure.hinges) if hinge.role == role)


def goal_of(structure: Structure, text: str) -> StageGoal:
    """The goal of a name, or as it is written: "time", "rest", or a bound on a measure or on the hinges of a role.

    Raises:
        InputError: there is none, and which there are.
    """
    count = coordinate_count(structure)
    free = {"least": np.full(count, -np.inf), "most": np.full(count, np.inf)}
    if text in ("time", "rest"):
        return StageGoal(name=text, kind="rest" if text == "rest" else "time", **free)
    for goal in structure.goals:
        if goal.name == text:
            return goal
    written = read_goal(text)
    known = dict.fromkeys([*_names(structure.measures), *(hinge.role for hinge in structure.hinges)])
    measure = None if written is None else measure_of(structure, written.name)
    if written is None or measure is None:
        got = text if written is None else written.name
        named = ["time", "rest", *_names(structure.goals)]
        bounds = [f"a bound on one of {', '.join(known)}"] if known else []
        raise InputError(f"until: need {one_of(named, got, bounds, list(known))}")
    return bounds_on(structure, measure, text, written)


def bounds_on(structure: Structure, measure: Measure, name: str, written: GoalText) -> StageGoal:
    """A bound on a measure as a goal.

    Raises:
        InputError: the value has another unit.
    """
    unit = ANGLE if measure.kind == "angle" else LENGTH
    try:
        value = parse_quantity(written.value, unit)
    except InputError as error:
        raise InputError(f"until: {as_written(name)}: {error}") from None
    least, most = (value, math.inf) if written.relation == ">" else (-math.inf, value)
    return bounded(structure, measure, name, least=least, most=most)


def bounded(
    structure: Structure, measure: Measure, name: str, *, least: float = -math.inf, most: float = math.inf
) -> StageGoal:
    """The goal that every reading of a measure is within bounds, rad or m."""
    count = coordinate_count(structure)
    low, high = np.full(count, -np.inf), np.full(count, np.inf)
    first = len(structure.hinges)
    if measure.kind == "distance":
        place = first + [each.name for each in distances_of(structure)].index(measure.name)
        low[place], high[place] = least, most
    elif measure.together > 1:
        sums = sums_of(structure)
        before = sums[: [each.name for each in sums].index(measure.name)]
        first += len(distances_of(structure)) + sum(len(each.parts) for each in before)
        low[first : first + len(measure.parts)], high[first : first + len(measure.parts)] = least, most
    else:
        for hinge, sign in zip(measure.hinges, measure.signs, strict=True):
            low[hinge], high[hinge] = (least, most) if sign > 0 else (-most, -least)
    return StageGoal(name=name, kind="bounds", least=low, most=high)


def distances_of(structure: Structure) -> tuple[Measure, ...]:
    """The measures that are distances, in the order of their coordinates in goals."""
    return tuple(measure for measure in structure.measures if measure.points is not None)


def sums_of(structure: Structure) -> tuple[Measure, ...]:
    """The measures whose readings are sums of angles, in the order of their coordinates in goals."""
    return tuple(measure for measure in structure.measures if measure.together > 1)


def coordinate_count(structure: Structure) -> int:
    """How many coordinates a goal has, see `goal_coordinates`."""
    sums = sum(len(measure.parts) for measure in sums_of(structure))
    return len(structure.hinges) + len(distances_of(structure)) + sums


def goal_coordinates(structure: Structure, angles: Array, distances: Array | None = None) -> Array:
    """What goals are bounds on, (..., coordinate).

    Args:
        structure: with its measures.
        angles: of all hinges in their own senses, rad, (..., hinge).
        distances: of all measures that are distances, m, (..., distance); None where there are none.
    """
    sums = [read_angles(measure, angles) for measure in sums_of(structure)]
    parts = [angles, *([] if distances is None else [distances]), *sums]
    return np.concatenate(parts, axis=-1) if len(parts) > 1 else angles


def read_angles(measure: Measure, angles: Array) -> Array:
    """What a measure of angles reads, rad, (..., reading), of all hinges' angles in their own senses, (..., hinge)."""
    turned = np.array(measure.signs) * angles[..., list(measure.hinges)]
    if measure.together == 1:
        return np.asarray(turned)
    return np.asarray(turned.reshape(*turned.shape[:-1], -1, measure.together).sum(axis=-1))


def measure_stops(structure: Structure, measure: Measure) -> list[tuple[float, float]]:
    """Between which readings of a measure of angles the stops keep it, rad, for every reading."""
    signs = dict(zip(measure.hinges, measure.signs, strict=True))
    stops = {number: (structure.hinges[number].lower, structure.hinges[number].upper) for number in measure.hinges}
    ends = {number: sorted(sign * end for end in stops[number]) for number, sign in signs.items()}
    return [(sum(ends[each][0] for each in part), sum(ends[each][1] for each in part)) for part in measure.parts]


def hinge_bounds(structure: Structure, goal: StageGoal) -> tuple[Array, Array]:
    """Bounds of a goal on the angle of each hinge, rad, (hinge,) each; those on a sum are shared evenly."""
    count = len(structure.hinges)
    place, least, most = count + len(distances_of(structure)), goal.least[:count].copy(), goal.most[:count].copy()
    for measure in sums_of(structure):
        for part in measure.parts:
            for hinge in part:
                sign = measure.signs[measure.hinges.index(hinge)]
                ends = sign * goal.least[place] / len(part), sign * goal.most[place] / len(part)
                least[hinge], most[hinge] = max(least[hinge], min(ends)), min(most[hinge], max(ends))
            place += 1
    return least, most


def _names(parts: Sequence[Drive] | Sequence[Measure] | Sequence[StageGoal]) -> list[str]:
    return [part.name for part in parts]


def short_of(coordinates: Array, goal: StageGoal) -> float:
    """How far the furthest of what a goal bounds is from its bound, rad or m, >= 0.

    Args:
        coordinates: as of `goal_coordinates`, (coordinate,).
        goal: with its bounds.
    """
    above, below = np.isfinite(goal.most), np.isfinite(goal.least)
    short = [*(coordinates - goal.most)[above], *(goal.least - coordinates)[below]]
    return max([0.0, *map(float, short)])
