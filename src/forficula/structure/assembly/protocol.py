"""The protocol of an assembly applied to its structure: motors, drives, measures and goals of all parts by name."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from forficula.design.assembly.assembly import AssemblyDesign
from forficula.design.named_protocol import Drive
from forficula.design.protocol import read_goal
from forficula.design.section import ANGULAR_SPEED
from forficula.errors import InputError
from forficula.names import listed, one_of
from forficula.quantities import show_quantity
from forficula.structure.assembly.joined_part import JoinedPart
from forficula.structure.goals import coordinate_count, goal_of
from forficula.structure.motors_and_measures import Measure, Motor, StageGoal
from forficula.structure.parts import GROUND
from forficula.structure.protocol import drives_together, torque_motors
from forficula.structure.structure import Structure
from forficula.structure.tree import moving_body


def with_assembly_protocol(structure: Structure, design: AssemblyDesign, parts: Sequence[JoinedPart]) -> Structure:
    """Return a structure with the measures, drives, goals, states and transitions of an assembly.

    Args:
        structure: structure of the assembly without a protocol.
        design: design of the assembly.
        parts: the parts of the assembly.

    Raises:
        InputError: a drive on hinges or points that the structure does not have, or that a part drives already.
    """
    named = design.named_protocol
    added = [drive for drive in named.drives if drive.name in [section.name for section in design.drive]]
    of_parts = [_motor(part, motor) for part in parts for motor in part.structure.motors]
    added_motors, added_shares = _added_motors(structure, added)
    motors, shared = _shared_motors(structure, of_parts, added_motors)
    drives = [
        replace(drive, shares=(*drive.shares, *[0.0] * (len(motors) - len(drive.shares))))
        for drive in _part_drives(parts, named.drives)
    ]
    for number, drive in enumerate(added):
        shares = [0.0] * len(motors)
        for motor, by_drive in zip(shared, added_shares, strict=True):
            shares[motor] += by_drive.get(number, 0.0)
        drives.append(replace(drive, shares=tuple(shares)))
    structure = replace(
        structure,
        motors=motors,
        drives=tuple(drives),
        measures=tuple(_measure(part, measure) for part in parts for measure in part.structure.measures),
        goals=(),
        states=named.states,
        stage_states=named.stage_states,
        transitions=named.transitions,
    )
    goals = (
        replace(goal_of(structure, text), name=name)
        if read_goal(text) is not None
        else _part_goal(structure, parts, name)
        for name, text in named.goals.items()
    )
    structure = replace(structure, goals=tuple(goals))
    return replace(structure, drives=(*drives, *drives_together(structure, design)))


def _motor(part: JoinedPart, motor: Motor) -> Motor:
    """Return a motor of a part with the numbers of the assembly."""
    direction, turn = motor.direction, part.motion.rotation
    if direction is not None and not np.array_equal(turn, np.eye(3)):
        direction = turn @ direction
    return replace(
        motor,
        name=part.full_name(motor.name),
        hinges=tuple(part.hinges[hinge] for hinge in motor.hinges),
        points=part.point_numbers(motor.points),
        direction=direction,
    )


def _part_drives(parts: Sequence[JoinedPart], named: Sequence[Drive]) -> list[Drive]:
    """Return the drives of the parts, with shares for the motors of all parts before and in each part."""
    by_name = {drive.name: drive for drive in named}
    drives: list[Drive] = []
    before = 0
    for part in parts:
        for drive in part.structure.drives:
            named_drive = by_name.get(part.full_name(drive.name))
            if named_drive is not None:
                shares = (*[0.0] * before, *drive.shares)
                drives.append(replace(named_drive, shares=shares, strength=drive.strength))
        before += len(part.structure.motors)
    return drives


def _added_motors(structure: Structure, drives: Sequence[Drive]) -> tuple[list[Motor], list[dict[int, float]]]:
    """Return the motors of drives of the assembly and, for every motor, the shares of these drives by their numbers."""
    names = {name for hinge in structure.hinges for name in (hinge.name, hinge.role)}
    points = {point.name.replace(" ", ""): number for number, point in enumerate(structure.points)}
    for drive in drives:
        for action in drive.actions:
            known = points if action.kind == "force" else names
            written = [place.replace(" ", "") for place in action.places] or action.hinges
            for name in written:
                if name not in known:
                    raise InputError(f"drive.{drive.name}.of: need {one_of(sorted(known), name)}")
                if action.kind == "force" and moving_body(structure, structure.points[points[name]].body) == GROUND:
                    raise InputError(
                        f"drive.{drive.name}.of: need points that move, got {name}, which is fixed to the ground"
                    )
    motors, shares = torque_motors(structure, drives)
    for number, drive in enumerate(drives):
        for action in drive.actions:
            if action.kind == "force":
                direction = np.array(action.direction, dtype=np.float64)
                pushed = tuple(points[place.replace(" ", "")] for place in action.places)
                unit = direction / np.linalg.norm(direction)
                motors.append(Motor(name=drive.name, kind="force", points=pushed, direction=unit))
                shares.append({number: 1.0})
    return motors, shares


def _shared_motors(
    structure: Structure, of_parts: Sequence[Motor], added: Sequence[Motor]
) -> tuple[tuple[Motor, ...], list[int]]:
    """Return the motors of the parts and of the assembly, and the number of the motor for each one of the assembly.

    A hinge has one motor of torques: a torque of the assembly on the hinges of a motor of a part uses that motor.

    Raises:
        InputError: a torque on some of the hinges of a motor of a part, but not on all, or with another no-load speed.
    """
    motors, numbers = list(of_parts), list[int]()
    torques = {number: motor for number, motor in enumerate(of_parts) if motor.kind == "torque"}
    for motor in added:
        hinges = set(motor.hinges)
        same = next((number for number, other in torques.items() if hinges and set(other.hinges) == hinges), None)
        if same is None:
            _check_apart(structure, motor, list(torques.values()))
            motors.append(motor)
        elif motor.no_load_speed != of_parts[same].no_load_speed:
            raise InputError(
                f"drive.{motor.name}.no_load_speed: need that of the motor {of_parts[same].name} of a part, which acts"
                f" on the same hinges, {_speed(of_parts[same])}, got {_speed(motor)}"
            )
        numbers.append(len(motors) - 1 if same is None else same)
    return tuple(motors), numbers


def _check_apart(structure: Structure, motor: Motor, others: Sequence[Motor]) -> None:
    """Refuse a motor on some of the hinges of another motor."""
    for other in others:
        if common := sorted(set(motor.hinges) & set(other.hinges)):
            driven = listed(structure.hinges[hinge].name for hinge in other.hinges)
            raise InputError(
                f"drive.{motor.name}.of: need all hinges of the motor {other.name} of a part, {driven}, or none of"
                f" them, got {structure.hinges[common[0]].name} among others"
            )


def _speed(motor: Motor) -> str:
    """Return the no-load speed of a motor as text."""
    return show_quantity(motor.no_load_speed, ANGULAR_SPEED) if math.isfinite(motor.no_load_speed) else "none"


def _measure(part: JoinedPart, measure: Measure) -> Measure:
    """Return a measure of a part with the numbers of the assembly."""
    one, other = measure.points or (0, 0)
    return replace(
        measure,
        name=part.full_name(measure.name),
        hinges=tuple(part.hinges[hinge] for hinge in measure.hinges),
        points=None if measure.points is None else (part.first_point + one, part.first_point + other),
        label=f"{part.name}: {measure.label or measure.name}",
    )


def _part_goal(structure: Structure, parts: Sequence[JoinedPart], name: str) -> StageGoal:
    """Return a goal of a part that is no bound on one measure, such as that every crease is at its target."""
    part_name, _, goal_name = name.partition(".")
    part = next(part for part in parts if part.name == part_name)
    goal = next(goal for goal in part.structure.goals if goal.name == goal_name)
    least, most = (np.full(coordinate_count(structure), sign * np.inf) for sign in (-1.0, 1.0))
    for hinge, number in enumerate(part.hinges):
        least[number], most[number] = goal.least[hinge], goal.most[hinge]
    return StageGoal(name=name, kind=goal.kind, least=least, most=most)
