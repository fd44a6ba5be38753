"""Look-up of drives, measures, goals and states by name, and the coordinates that goals bound."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from forficula.arrays import Array
from forficula.design.named_protocol import Drive, RestState, Transition
from forficula.design.protocol import GoalText, StageSection, read_goal, stage_drives
from forficula.design.section import ANGLE, LENGTH
from forficula.errors import InputError
from forficula.names import one_of
from forficula.quantities import as_written, parse_quantity
from forficula.structure.motors_and_measures import Measure, Motor, StageGoal
from forficula.structure.structure import Structure

_UNITS = {"torque": "N m", "force": "N", "displacement": "m", "rest-angle": "rad"}


def drive_of(structure: Structure, name: str) -> Drive:
    """Return the drive with a name.

    Raises:
        InputError: there is no such drive.
    """
    for drive in structure.drives:
        if drive.name == name:
            return drive
    raise InputError(f"drive: need {one_of(['none', *_names(structure.drives)], name)}")


def driven_motor(structure: Structure, drive: Drive) -> Motor:
    """Return the first motor that a drive sets; its kind defines the unit of the drive's strength."""
    driven = (motor for motor, share in zip(structure.motors, drive.shares, strict=True) if share)
    return next(driven, structure.motors[0])


def drive_unit(structure: Structure, drive: Drive) -> str:
    """Return the SI unit of the strength of a drive."""
    return _UNITS[driven_motor(structure, drive).kind]


def transition_of(structure: Structure, name: str) -> Transition | None:
    """Return the transition with the drive of a name, or None."""
    return next((transition for transition in structure.transitions if transition.drive == name), None)


def state_of(structure: Structure, name: str) -> RestState | None:
    """Return the state with a name, or None."""
    return next((state for state in structure.states if state.name == name), None)


def first_state(structure: Structure, names: Sequence[str]) -> str:
    """Return the name of the first of some states to which no transition leads; "" if there is none.

    Args:
        structure: structure with the transitions.
        names: names of states, such as those in which stages end; empty names are ignored.
    """
    led_to = {transition.state for transition in structure.transitions}
    return next((name for name in names if name and name not in led_to), "")


def first_driven_stage(structure: Structure, stages: Sequence[StageSection], transition: Transition) -> int | None:
    """Return the number of the first driven stage on the way to the state of a transition.

    The way begins after the stage that ends in the previous named state, and after the previous transition. The stage
    is that of the transition itself, unless several driven stages lead to the state.

    Args:
        structure: structure with the transition.
        stages: stages of its protocol.
        transition: one of the transitions of the structure.
    """
    if transition.stage is None:
        return None
    ends = [number for number, name in enumerate(structure.stage_states) if name]
    ends += [earlier.goal_stage for earlier in structure.transitions if earlier.goal_stage is not None]
    begins = 1 + max((number for number in ends if number < transition.stage), default=-1)
    return next(number for number in range(begins, transition.stage + 1) if stage_drives(stages[number]))


def measure_of(structure: Structure, name: str) -> Measure | None:
    """Return the measure with a name, or None.

    The name of a role means the angles of all hinges with that role, in their own senses.
    """
    for measure in structure.measures:
        if measure.name == name:
            return measure
    hinges = hinges_of(structure, name)
    if not hinges:
        return None
    return Measure(name=name, kind="angle", hinges=hinges, signs=(1,) * len(hinges), label=f"{name} angle")


def hinges_of(structure: Structure, role: str) -> tuple[int, ...]:
    """Return the numbers of the hinges with a role."""
    return tuple(number for number, hinge in enumerate(structure.hinges) if hinge.role == role)


def goal_of(structure: Structure, text: str) -> StageGoal:
    """Return the goal for a text: "time", "rest", a name, or a bound on a measure or on the hinges of a role.

    Raises:
        InputError: there is no such goal; the message lists the goals.
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
    """Return a bound on a measure as a goal.

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
    """Return the goal that every reading of a measure is within bounds, rad or m."""
    count = coordinate_count(structure)
    low, high = np.full(count, -np.inf), np.full(count, np.inf)
    first = len(structure.hinges)
    if measure.kind == "distance":
        index = first + [distance.name for distance in distances_of(structure)].index(measure.name)
        low[index], high[index] = least, most
    elif measure.together > 1:
        sums = sums_of(structure)
        before = sums[: [summed.name for summed in sums].index(measure.name)]
        first += len(distances_of(structure)) + sum(len(summed.parts) for summed in before)
        low[first : first + len(measure.parts)], high[first : first + len(measure.parts)] = least, most
    else:
        for hinge, sign in zip(measure.hinges, measure.signs, strict=True):
            low[hinge], high[hinge] = (least, most) if sign > 0 else (-most, -least)
    return StageGoal(name=name, kind="bounds", least=low, most=high)


def distances_of(structure: Structure) -> tuple[Measure, ...]:
    """Return the measures that are distances, in the order of their coordinates in goals."""
    return tuple(measure for measure in structure.measures if measure.points is not None)


def point_distances(structure: Structure, positions: Array) -> Array:
    """Compute the readings of all measures that are distances, m, (..., distance).

    Args:
        structure: structure with its measures.
        positions: of its points, m, (..., point, 3); further ones are ignored.
    """
    ends = [measure.points for measure in distances_of(structure) if measure.points is not None]
    one, other = np.array(ends, dtype=np.int64).reshape(-1, 2).T
    return np.asarray(np.linalg.norm(positions[..., other, :] - positions[..., one, :], axis=-1))


def sums_of(structure: Structure) -> tuple[Measure, ...]:
    """Return the measures whose readings are sums of angles, in the order of their coordinates in goals."""
    return tuple(measure for measure in structure.measures if measure.together > 1)


def coordinate_count(structure: Structure) -> int:
    """Return the number of coordinates of a goal, see `goal_coordinates`."""
    sums = sum(len(measure.parts) for measure in sums_of(structure))
    return len(structure.hinges) + len(distances_of(structure)) + sums


def goal_coordinates(structure: Structure, angles: Array, distances: Array | None = None) -> Array:
    """Compute the coordinates that goals bound, (..., coordinate).

    Args:
        structure: structure with its measures.
        angles: angles of all hinges in their own senses, rad, (..., hinge).
        distances: readings of all measures that are distances, m, (..., distance); None without such measures.
    """
    sums = [read_angles(measure, angles) for measure in sums_of(structure)]
    parts = [angles, *([] if distances is None else [distances]), *sums]
    return np.concatenate(parts, axis=-1) if len(parts) > 1 else angles


def read_angles(measure: Measure, angles: Array) -> Array:
    """Compute the readings of a measure of angles, rad, (..., reading).

    Args:
        measure: measure of angles.
        angles: angles of all hinges in their own senses, rad, (..., hinge).
    """
    turned = np.array(measure.signs) * angles[..., list(measure.hinges)]
    if measure.together == 1:
        return np.asarray(turned)
    return np.asarray(turned.reshape(*turned.shape[:-1], -1, measure.together).sum(axis=-1))


def measure_stops(structure: Structure, measure: Measure) -> list[tuple[float, float]]:
    """Return the range to which stops limit each reading of a measure of angles, rad."""
    signs = dict(zip(measure.hinges, measure.signs, strict=True))
    stops = {number: (structure.hinges[number].lower, structure.hinges[number].upper) for number in measure.hinges}
    ends = {number: sorted(sign * end for end in stops[number]) for number, sign in signs.items()}
    return [(sum(ends[hinge][0] for hinge in part), sum(ends[hinge][1] for hinge in part)) for part in measure.parts]


def hinge_bounds(structure: Structure, goal: StageGoal) -> tuple[Array, Array]:
    """Return the bounds of a goal on each hinge's angle, rad, (hinge,) each; bounds on sums are divided equally."""
    count = len(structure.hinges)
    index, least, most = count + len(distances_of(structure)), goal.least[:count].copy(), goal.most[:count].copy()
    for measure in sums_of(structure):
        for part in measure.parts:
            for hinge in part:
                sign = measure.signs[measure.hinges.index(hinge)]
                ends = sign * goal.least[index] / len(part), sign * goal.most[index] / len(part)
                least[hinge], most[hinge] = max(least[hinge], min(ends)), min(most[hinge], max(ends))
            index += 1
    return least, most


def _names(entries: Sequence[Drive] | Sequence[Measure] | Sequence[StageGoal]) -> list[str]:
    return [entry.name for entry in entries]


def distance_to_goal(coordinates: Array, goal: StageGoal) -> float:
    """Compute the largest distance of a coordinate from its bound, rad or m, >= 0; 0 if the goal is reached.

    Args:
        coordinates: as `goal_coordinates` returns, (coordinate,).
        goal: goal with the bounds.
    """
    above, below = np.isfinite(goal.most), np.isfinite(goal.least)
    short = [*(coordinates - goal.most)[above], *(goal.least - coordinates)[below]]
    return max([0.0, *map(float, short)])
