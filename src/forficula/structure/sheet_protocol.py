"""What a protocol does with a sheet: its drives, goals, states and transitions, and the words for them."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from forficula.design import SheetDesign, Stage, stage_drives
from forficula.design.protocol import read_goal
from forficula.design.sheet_course import (
    DisplacementDrive,
    ForceDrive,
    RestAngleDrive,
    SheetDrive,
    TorqueDrive,
    places_of,
)
from forficula.design.sheet_creases import creases_of, fold_edges
from forficula.errors import InputError
from forficula.names import listed
from forficula.quantities import as_written
from forficula.structure.course import Drive, Goal, Motor, RestState, Transition, Wording
from forficula.structure.goals import coordinate_count, drive_of, goal_of
from forficula.structure.sheet_measures import hinges_by_edge
from forficula.structure.sheet_nodes import node_of, sheet_nodes
from forficula.structure.structure import Structure
from forficula.structure.tree import built_points

# rad; a crease this near to its target is there
_NO_WAY = 1e-9
# stiffness of what displaces points, by the stiffest bar there, and its damping ratio with the mass of the point alone:
# it lags by less than bars stretch, and shortens the timestep by less than half
_SERVO, _SERVO_DAMPING = 4.0, 0.5
# keys that matter to where plates rest beside those of their tendons
_STATIC_KEYS = ("pattern", "crease", "support", "measure", "protocol.stages", "protocol.gravity")


def with_protocol(structure: Structure, design: SheetDesign) -> Structure:
    """A sheet with the drives, goals, states and transitions of a design's protocol."""
    motors, drives = _driven(structure, design)
    structure = replace(structure, motors=motors, drives=drives, goals=(), states=(), transitions=())
    structure = replace(structure, goals=(_target(structure, design),))
    stages = design.protocol.stages
    goals = [goal_of(structure, stage.until) for stage in stages]
    drives, transitions = _transitions(structure, stages, goals)
    return replace(
        structure,
        drives=drives,
        goals=tuple({goal.name: goal for goal in goals if goal.kind == "bounds"}.values()),
        states=_states(stages, goals, goal_of(structure, "time")),
        stage_states=tuple(stage.state or "" for stage in stages),
        transitions=transitions,
    )


def _transitions(
    structure: Structure, stages: Sequence[Stage], goals: Sequence[Goal]
) -> tuple[tuple[Drive, ...], tuple[Transition, ...]]:
    """The drives, with those of stages that have several, and a transition for each that leads to a state."""
    drives, transitions = list(structure.drives), list[Transition]()
    kinds = {measure.name: measure.kind for measure in structure.measures}
    for number, (stage, goal) in enumerate(zip(stages, goals, strict=True)):
        written, state = read_goal(stage.until), _state_after(stages, number)
        if not stage_drives(stage) or goal.kind != "bounds" or state is None:
            continue
        name = "creases" if written is None else written.name
        drive = _together(structure, stage_drives(stage))
        if all(drive.name != known.name for known in drives):
            drives.append(drive)
        done = " and ".join([*(each.state for each in transitions), state])
        transitions.append(
            Transition(
                name=stage.name,
                drive=drive.name,
                stage=number,
                goal=goal.name,
                state=state,
                released=replace(goal, name=f"still {state}"),
                measure=name,
                kind=kinds.get(name, "angle"),
                furthest="smallest" if written is None or written.relation == ">" else "largest",
                begun=None,
                wording=_wording(state, done),
            )
        )
    return tuple(drives), tuple(transitions)


def _states(stages: Sequence[Stage], goals: Sequence[Goal], bounds: Goal) -> tuple[RestState, ...]:
    """The states that stages end in, each within the goal of the last driven stage, or within bounds before one."""
    states, last = list[RestState](), ""
    for stage, goal in zip(stages, goals, strict=True):
        if stage_drives(stage):
            bounds, last = goal, stage.name
        if stage.state is not None:
            states.append(
                RestState(
                    name=stage.state,
                    bounds=replace(bounds, name=stage.state, kind="bounds"),
                    missed=f"not {stage.state}",
                    unknown=f'after stage "{last or stage.name}"',
                )
            )
    return tuple(states)


def _driven(structure: Structure, design: SheetDesign) -> tuple[tuple[Motor, ...], tuple[Drive, ...]]:
    """Motors and drives: creases that the same torques act on share a motor, all other drives have their own."""
    numbers = hinges_by_edge(structure.hinges)
    acting: list[set[int]] = []
    for drive in design.drive:
        edges = () if places_of(drive) else creases_of(design.sheet, str(drive.of), design.crease.group)
        acting.append({hinge for edge in edges for hinge in numbers[edge]})
    motors, moved = _torques(structure, design, acting)
    strengths: list[float] = []
    for number, drive in enumerate(design.drive):
        strength: float | None = getattr(drive, drive.strength_key)
        if isinstance(drive, ForceDrive | DisplacementDrive):
            motors.append(_at_places(structure, design, number, drive))
        elif isinstance(drive, RestAngleDrive):
            motor, largest = _rest_angles(structure, design, drive, sorted(acting[number]))
            motors.append(motor)
            strength = largest if strength is None else strength
        if not isinstance(drive, TorqueDrive):
            moved.append((number,))
        strengths.append(strength or 0.0)
    rises = [design.protocol.rise if drive.rise is None else drive.rise for drive in design.drive]
    return tuple(motors), tuple(
        Drive(
            name=drive.name,
            shares=tuple(1.0 if number in drives else 0.0 for drives in moved),
            rise=rises[number],
            key=f"drive.{drive.name}.{drive.strength_key}",
            strength=strengths[number],
            where=_where(drive),
        )
        for number, drive in enumerate(design.drive)
    )


def _torques(
    structure: Structure, design: SheetDesign, acting: Sequence[set[int]]
) -> tuple[list[Motor], list[tuple[int, ...]]]:
    """The motors of torques, and the numbers of the drives that each follows."""
    turning = [number for number, drive in enumerate(design.drive) if isinstance(drive, TorqueDrive)]
    shared: dict[tuple[int, ...], list[int]] = {}
    for hinge in range(len(structure.hinges)):
        drives = tuple(number for number in turning if hinge in acting[number])
        if drives:
            shared.setdefault(drives, []).append(hinge)
    motors = []
    for drives, hinges in shared.items():
        whole = [str(design.drive[number].of) for number in drives if acting[number] == set(hinges)]
        name = whole[0] if whole else ", ".join(structure.hinges[hinge].name for hinge in hinges)
        motors.append(
            Motor(
                name=name,
                hinges=tuple(hinges),
                gains=_parts_of_creases(structure, hinges),
                no_load_speed=_no_load_speed(design, drives),
            )
        )
    return motors, list(shared)


def _no_load_speed(design: SheetDesign, drives: Sequence[int]) -> float:
    """That of drives which act on the same creases."""
    torques = {number: drive for number, drive in enumerate(design.drive) if isinstance(drive, TorqueDrive)}
    speeds = {torques[number].no_load_speed: number for number in drives}
    if len(speeds) > 1:
        one, other = sorted(speeds.values())
        raise InputError(
            f"drive.{other}.no_load_speed: need that of drive.{one}, which acts on the same creases, got another"
        )
    return next(iter(speeds)) or math.inf


def _parts_of_creases(structure: Structure, hinges: Sequence[int]) -> tuple[float, ...]:
    """The share of each hinge in the length of its crease; none where every crease is whole."""
    numbers = hinges_by_edge(structure.hinges)
    if all(len(numbers[structure.hinges[hinge].edge]) == 1 for hinge in hinges):
        return ()
    ends = built_points(structure)[[(structure.hinges[hinge].flaps or ())[:2] for hinge in hinges]]
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    edges = np.array([structure.hinges[hinge].edge for hinge in hinges])
    return tuple(float(length / lengths[edges == edge].sum()) for edge, length in zip(edges, lengths, strict=True))


def _at_places(structure: Structure, design: SheetDesign, number: int, drive: ForceDrive | DisplacementDrive) -> Motor:
    """The motor of nodes, which have the numbers of their points, or of a force at places on plates."""
    nodes = None if structure.plates else sheet_nodes(design)
    named = {point.name: number for number, point in enumerate(structure.points)}
    direction = np.array(drive.direction, dtype=np.float64)
    points = tuple(
        named[pushed_name(drive, place)] if nodes is None else node_of(design.sheet, nodes, text)
        for place, text in enumerate(places_of(drive))
    )
    for point, text in zip(points, places_of(drive), strict=True) if nodes is not None else ():
        if not any(direction[axis] for axis in structure.bodies[point].slides):
            raise InputError(
                f"drive.{number}.of: need a vertex that is free along drive.{number}.direction, got {as_written(text)},"
                " which a support holds"
            )
    direction /= np.linalg.norm(direction)
    if isinstance(drive, ForceDrive):
        return Motor(name=drive.name, kind="force", points=points, direction=direction)
    stiffness = _SERVO * _stiffest(structure, points)
    masses = [structure.bodies[structure.points[point].body].mass for point in points]
    return Motor(
        name=drive.name,
        kind="displacement",
        points=points,
        direction=direction,
        stiffness=stiffness,
        damping=tuple(2 * _SERVO_DAMPING * math.sqrt(stiffness * mass) for mass in masses),
    )


def _stiffest(structure: Structure, points: Sequence[int]) -> float:
    """Stiffness of the stiffest bar at some points, N/m; of membranes Young's modulus times thickness."""
    bars = [spring.stiffness for spring in structure.springs if set(spring.points) & set(points)]
    return max([*bars, *(each.law.youngs_modulus * each.law.thickness for each in structure.membranes)])


def pushed_name(drive: SheetDrive, number: int) -> str:
    """What the point of a plate is called at which a force acts, by the number of its place."""
    return f"drive_{drive.name}_{number}"


def _rest_angles(
    structure: Structure, design: SheetDesign, drive: RestAngleDrive, hinges: Sequence[int]
) -> tuple[Motor, float]:
    """The motor of springs that rest further on, and the furthest of those that go on to their targets."""
    if drive.to is None:
        return Motor(name=drive.name, kind="rest-angle", hinges=tuple(hinges)), 0.0
    targets = target_angles(structure, design)
    ways = {hinge: targets[hinge] - structure.hinges[hinge].rest_angle for hinge in hinges if hinge in targets}
    furthest = max(map(abs, ways.values()), default=0.0)
    if furthest <= _NO_WAY:
        return Motor(name=drive.name, kind="rest-angle", hinges=tuple(ways)), 0.0
    gains = tuple(way / furthest for way in ways.values())
    return Motor(name=drive.name, kind="rest-angle", hinges=tuple(ways), gains=gains), furthest


def target_angles(structure: Structure, design: SheetDesign) -> dict[int, float]:
    """Where creases are to fold to, in their own senses, rad, by the numbers of their hinges."""
    numbers, angles = hinges_by_edge(structure.hinges), design.sheet.edges_fold_angle
    found = {hinge: float(angles[edge]) for edge in fold_edges(design.sheet) for hinge in numbers[edge]}
    return {hinge: structure.hinges[hinge].sense * angle for hinge, angle in found.items() if not math.isnan(angle)}


def _target(structure: Structure, design: SheetDesign) -> Goal:
    """The goal that every crease is where it is to fold to."""
    count = coordinate_count(structure)
    least, most = np.full(count, -np.inf), np.full(count, np.inf)
    for hinge, angle in target_angles(structure, design).items():
        least[hinge], most[hinge] = angle - design.protocol.arrival, angle + design.protocol.arrival
    return Goal(name="target", kind="bounds", least=least, most=most)


def _where(drive: SheetDrive) -> str:
    """What a drive acts on, as sentences say it."""
    if not isinstance(drive.of, str):
        return f"on {listed(drive.of)}"
    return f"on {drive.of}" if re.match(r"(crease|vertex) \d", drive.of) else f"on the {drive.of}"


def _together(structure: Structure, names: Sequence[str]) -> Drive:
    """The drives of a stage as one, which grow in proportion: of several, that of the first with the others' shares.

    One of no strength is no measure of the others: the first that has some is.
    """
    drives = [drive_of(structure, name) for name in names]
    lead = next((drive for drive in drives if drive.strength), drives[0])
    others = [drive for drive in drives if drive is not lead]
    if not others:
        return lead
    torques = [sum(each) for each in zip(*(drive.strengths for drive in drives), strict=True)]
    return replace(
        lead,
        name=" and ".join(names),
        shares=tuple(torque / lead.strength if lead.strength else 0.0 for torque in torques),
        rise=max(drive.rise for drive in drives),
        where=f"{lead.where}, with {' and '.join(drive.name for drive in others)} in proportion",
    )


def _state_after(stages: Sequence[Stage], number: int) -> str | None:
    """The state that a driven stage leads to: its own, or that of the release which follows."""
    stage = stages[number]
    if stage.state is not None or number + 1 == len(stages) or stage_drives(stages[number + 1]):
        return stage.state
    return stages[number + 1].state


def _wording(state: str, done: str) -> Wording:
    """How sentences speak of the way to a state."""
    return Wording(
        done=done,
        verb=f"get {state}",
        doing=f"getting {state}",
        stays=state,
        time=f"time to get {state}",
        noun=f"getting {state}",
        did=f"got {state}",
    )


def drive_keys(design: SheetDesign) -> tuple[str, ...]:
    """Keys of the values that say how strong the drives are."""
    return tuple(f"drive.{drive.name}.{drive.strength_key}" for drive in design.drive)


def static_keys(design: SheetDesign) -> tuple[str, ...]:
    """Keys of what matters to where the plates rest, but for their tendons."""
    # without gravity they rest where they rest, however heavy they are
    return (*_STATIC_KEYS, "facet") if design.protocol.gravity else _STATIC_KEYS
