"""The protocol of a design applied to a structure: motors and drives on hinges and points, goals for measures."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from forficula.design import Design, SheetDesign, stage_drives
from forficula.design.named_protocol import Action, Drive, NamedProtocol
from forficula.errors import InputError
from forficula.quantities import as_written
from forficula.structure.goals import coordinate_count, drive_of, goal_of
from forficula.structure.motors_and_measures import Motor, StageGoal
from forficula.structure.sheets.sheet_measures import hinges_by_edge
from forficula.structure.sheets.sheet_nodes import node_of, sheet_nodes
from forficula.structure.structure import Structure
from forficula.structure.tree import built_points

# rad, largest change of a rest angle that counts as none
_NO_CHANGE = 1e-9
# stiffness of the servo that displaces a point, relative to the stiffest bar at the point, and its damping ratio with
# the mass of the point: the servo lags by less than bars stretch, and shortens the timestep by less than half
_SERVO, _SERVO_DAMPING = 4.0, 0.5


def with_protocol(structure: Structure, design: Design) -> Structure:
    """Return a structure with the drives, goals, states and transitions of a design.

    Args:
        structure: structure of the design, or of a design that differs in the protocol only.
        design: design with the protocol.

    Raises:
        InputError: drives that the structure cannot combine, or a force on a vertex that a support holds.
    """
    named = design.named_protocol
    motors, drives = _driven(structure, design, named)
    structure = replace(
        structure,
        motors=motors,
        drives=drives,
        goals=(),
        states=named.states,
        stage_states=named.stage_states,
        transitions=named.transitions,
    )
    goals = (
        _target(structure, named) if name == "target" else replace(goal_of(structure, text), name=name)
        for name, text in named.goals.items()
    )
    return replace(structure, drives=(*drives, *drives_together(structure, design)), goals=tuple(goals))


def _driven(structure: Structure, design: Design, named: NamedProtocol) -> tuple[tuple[Motor, ...], tuple[Drive, ...]]:
    """Return motors and drives: hinges with the same torques share a motor, every other action has its own."""
    motors, moved = torque_motors(structure, named.drives)
    strengths = [drive.strength for drive in named.drives]
    for number, drive in enumerate(named.drives):
        for action in drive.actions:
            if action.kind == "torque":
                continue
            if action.to_targets:
                motor, strengths[number] = _to_targets(structure, action, named.targets)
            elif action.kind == "rest-angle":
                motor = Motor(name=action.motor, kind="rest-angle", hinges=tuple(_hinges(structure, action)))
            else:
                motor = _at_places(structure, design, number, action)
            motors.append(motor)
            moved.append({number: action.share})
    return tuple(motors), tuple(
        replace(drive, shares=tuple(shares.get(number, 0.0) for shares in moved), strength=strengths[number])
        for number, drive in enumerate(named.drives)
    )


def torque_motors(structure: Structure, drives: Sequence[Drive]) -> tuple[list[Motor], list[dict[int, float]]]:
    """Return the motors of torques and, for every motor, the shares of drives by their numbers."""
    torques = [
        (number, action, _hinges(structure, action))
        for number, drive in enumerate(drives)
        for action in drive.actions
        if action.kind == "torque"
    ]
    on_hinge: dict[int, tuple[int, ...]] = {}
    for index, (_, _, hinges) in enumerate(torques):
        for hinge in hinges:
            on_hinge[hinge] = (*on_hinge.get(hinge, ()), index)
    shared: dict[tuple[int, ...], list[int]] = {}
    for hinge in sorted(on_hinge):
        shared.setdefault(on_hinge[hinge], []).append(hinge)
    # motors of creases are in the order of the creases, motors of named hinges in the order of the actions
    order = sorted(shared, key=lambda indices: indices[0] if torques[indices[0]][1].hinges else 0)
    motors: list[Motor] = []
    for indices in order:
        hinges = shared[indices]
        whole = [action.motor for _, action, driven in (torques[index] for index in indices) if driven == hinges]
        motors.append(
            Motor(
                name=whole[0] if whole else ", ".join(structure.hinges[hinge].name for hinge in hinges),
                hinges=tuple(hinges),
                gains=_parts_of_creases(structure, hinges),
                no_load_speed=_no_load_speed({torques[index][0]: torques[index][1] for index in indices}),
            )
        )
    return motors, [{torques[index][0]: torques[index][1].share for index in indices} for indices in order]


def _hinges(structure: Structure, action: Action) -> list[int]:
    """Return the numbers of the hinges of an action, in ascending order."""
    edges, names = set(action.edges), set(action.hinges)
    return [
        number
        for number, hinge in enumerate(structure.hinges)
        if hinge.edge in edges or hinge.role in names or hinge.name in names
    ]


def _no_load_speed(actions: Mapping[int, Action]) -> float:
    """Return the no-load speed of actions on the same hinges, given by the numbers of their drives."""
    speeds = {action.no_load_speed: number for number, action in actions.items()}
    if len(speeds) > 1:
        one, other = sorted(speeds.values())
        raise InputError(
            f"drive.{other}.no_load_speed: need that of drive.{one}, which acts on the same creases, got another"
        )
    return next(iter(speeds))


def _parts_of_creases(structure: Structure, hinges: Sequence[int]) -> tuple[float, ...]:
    """Return the share of each hinge in the length of its crease; empty where every crease is one hinge."""
    numbers = hinges_by_edge(structure.hinges)
    if all(len(numbers.get(structure.hinges[hinge].edge, ())) < 2 for hinge in hinges):
        return ()
    ends = built_points(structure)[[(structure.hinges[hinge].flaps or ())[:2] for hinge in hinges]]
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    edges = np.array([structure.hinges[hinge].edge for hinge in hinges])
    return tuple(float(length / lengths[edges == edge].sum()) for edge, length in zip(edges, lengths, strict=True))


def _to_targets(structure: Structure, action: Action, targets: Mapping[int, float]) -> tuple[Motor, float]:
    """Return the motor that changes rest angles to their targets, and the largest of the changes, rad."""
    angles, hinges = _target_angles(structure, targets), _hinges(structure, action)
    changes = {hinge: angles[hinge] - structure.hinges[hinge].rest_angle for hinge in hinges if hinge in angles}
    motor = Motor(name=action.motor, kind="rest-angle", hinges=tuple(changes))
    largest = max(map(abs, changes.values()), default=0.0)
    if largest <= _NO_CHANGE:
        return motor, 0.0
    return replace(motor, gains=tuple(change / largest for change in changes.values())), largest


def _at_places(structure: Structure, design: Design, number: int, action: Action) -> Motor:
    """Return the motor of a force or a displacement of the drive with a number."""
    direction = np.array(action.direction, dtype=np.float64)
    if isinstance(design, SheetDesign) and not structure.plates:
        # a node and its point have the same number
        nodes = sheet_nodes(design)
        points = tuple(node_of(design.sheet, nodes, text) for text in action.places)
        for point, text in zip(points, action.places, strict=True):
            if not any(direction[axis] for axis in structure.bodies[point].slides):
                raise InputError(
                    f"drive.{number}.of: need a vertex that is free along drive.{number}.direction, got"
                    f" {as_written(text)}, which a support holds"
                )
    else:
        named = {point.name: number for number, point in enumerate(structure.points)}
        points = tuple(named[force_point_name(action.motor, place)] for place in range(len(action.places)))
    direction /= np.linalg.norm(direction)
    motor = Motor(name=action.motor, kind=action.kind, points=points, direction=direction)
    if action.kind == "force":
        return motor
    stiffness = _SERVO * _stiffest(structure, points)
    masses = [structure.bodies[structure.points[point].body].mass for point in points]
    damping = tuple(2 * _SERVO_DAMPING * math.sqrt(stiffness * mass) for mass in masses)
    return replace(motor, stiffness=stiffness, damping=damping)


def _stiffest(structure: Structure, points: Sequence[int]) -> float:
    """Return the largest stiffness at some points, N/m: of bars, or Young's modulus times thickness of membranes."""
    bars = [spring.stiffness for spring in structure.springs if set(spring.points) & set(points)]
    laws = [membrane.law for membrane in structure.membranes]
    return max([*bars, *(law.youngs_modulus * law.thickness for law in laws)])


def force_point_name(drive: str, number: int) -> str:
    """Return the name of the point of a plate at which a drive pushes, by the number of its place."""
    return f"drive_{drive}_{number}"


def _target_angles(structure: Structure, targets: Mapping[int, float]) -> dict[int, float]:
    """Return the targets of creases in their own senses, rad, by the numbers of their hinges."""
    numbers = hinges_by_edge(structure.hinges)
    angles = {hinge: angle for edge, angle in targets.items() for hinge in numbers[edge]}
    return {hinge: structure.hinges[hinge].sense * angle for hinge, angle in angles.items()}


def _target(structure: Structure, named: NamedProtocol) -> StageGoal:
    """Return the goal that every crease is near its target."""
    count = coordinate_count(structure)
    least, most = np.full(count, -np.inf), np.full(count, np.inf)
    for hinge, angle in _target_angles(structure, named.targets).items():
        least[hinge], most[hinge] = angle - named.arrival, angle + named.arrival
    return StageGoal(name="target", kind="bounds", least=least, most=most)


def drives_together(structure: Structure, design: Design) -> list[Drive]:
    """Return one drive for the drives of every stage that has several and leads to a state."""
    known, stages = [drive.name for drive in structure.drives], design.protocol.stages
    return [
        _in_proportion(structure, stage_drives(stages[transition.stage]))
        for transition in {transition.drive: transition for transition in structure.transitions}.values()
        if transition.drive not in known and transition.stage is not None
    ]


def _in_proportion(structure: Structure, names: Sequence[str]) -> Drive:
    """Return one drive for several drives that increase in proportion.

    Its strength and key are those of the first drive whose strength is not 0.
    """
    drives = [drive_of(structure, name) for name in names]
    lead = next((drive for drive in drives if drive.strength), drives[0])
    others = [drive for drive in drives if drive is not lead]
    torques = [sum(strengths) for strengths in zip(*(drive.strengths for drive in drives), strict=True)]
    return replace(
        lead,
        name=" and ".join(names),
        shares=tuple(torque / lead.strength if lead.strength else 0.0 for torque in torques),
        rise=max(drive.rise for drive in drives),
        where=f"{lead.where}, with {' and '.join(drive.name for drive in others)} in proportion",
    )
