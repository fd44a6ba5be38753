"""Drives, measures, goals and states by their names."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from forficula.design.part import ANGLE, LENGTH
from forficula.design.protocol import GoalText, read_goal
from forficula.errors import InputError
from forficula.names import one_of
from forficula.quantities import as_written, parse_quantity
from forficula.structure.course import Drive, Goal, Measure, Motor, RestState, Transition
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


def goal_of(structure: Structure, text: str) -> Goal:
    """The goal of a name, or as it is written: "time", "rest", or a bound on a measure or on the hinges of a role.

    Raises:
        InputError: there is none, and which there are.
    """
    count = len(structure.hinges) + len(distances_of(structure))
    free = {"least": np.full(count, -np.inf), "most": np.full(count, np.inf)}
    if text in ("time", "rest"):
        return Goal(name=text, kind="rest" if text == "rest" else "time", **free)
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


def bounds_on(structure: Structure, measure: Measure, name: str, written: GoalText) -> Goal:
    """A bound on a measure as a goal.

    Raises:
        InputError: the value has another unit.
    """
    unit = ANGLE if measure.kind == "angle" else LENGTH
    try:
        value = parse_quantity(written.value, unit)
    except InputError as error:
        raise InputError(f"until: {as_written(name)}: {error}") from None
    distances = distances_of(structure)
    count = len(structure.hinges) + len(distances)
    least, most = np.full(count, -np.inf), np.full(count, np.inf)
    if measure.kind == "distance":
        place = len(structure.hinges) + [each.name for each in distances].index(measure.name)
        (least if written.relation == ">" else most)[place] = value
    for hinge, sign in zip(measure.hinges, measure.signs, strict=True):
        rises = (written.relation == ">") == (sign > 0)
        (least if rises else most)[hinge] = sign * value
    return Goal(name=name, kind="bounds", least=least, most=most)


def distances_of(structure: Structure) -> tuple[Measure, ...]:
    """The measures that are distances, in the order of their coordinates in goals."""
    return tuple(measure for measure in structure.measures if measure.points is not None)


def _names(parts: Sequence[Drive] | Sequence[Measure] | Sequence[Goal]) -> list[str]:
    return [part.name for part in parts]
