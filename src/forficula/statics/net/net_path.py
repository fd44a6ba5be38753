"""Quasi-static path of a net under one of its drives."""

from __future__ import annotations

import numpy as np

from forficula.arrays import Array
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.net_course import (
    MOST,
    displaced_net,
    drive_course,
    prescribes_displacement,
    reaction,
    released,
    short_of,
)
from forficula.statics.net.net_of import motor_load, net_of, own_angles, point_positions, start_shape, valley_angles
from forficula.statics.net.net_state import stored_parts
from forficula.statics.net.slow_path import Snap, SlowPath, slow_path
from forficula.statics.quasi_static_path import (
    NumberedEvent,
    QuasiStaticPath,
    QuasiStaticPoint,
    last_event,
    path_of,
    rest_changes,
)
from forficula.structure import Drive, Structure, Transition, drive_of, goal_of

_INCREMENTS = 120


def net_path(structure: Structure, drive: Drive, transition: Transition | None) -> QuasiStaticPath:
    """Follow a net under a slowly growing drive; see `forficula.statics.survey.quasi_static_path`."""
    free = net_of(structure)
    start, remarks = released(free, start_shape(structure, free))
    for before in structure.transitions:
        if before is transition or transition is None:
            break
        start = drive_course(structure, free, start, drive_of(structure, before.drive), before).rest
    name = drive.name if transition is None else transition.name
    net = displaced_net(structure, free, drive)
    load = motor_load(structure, net, drive.strengths)
    goal = None if transition is None else goal_of(structure, transition.goal)

    def at_goal(shape: NetShape) -> bool:
        return goal is not None and short_of(structure, net, goal, shape) <= 0

    end = 1.0 if goal is None else MOST
    slow = slow_path(net, start.shape, load, end=end, increments=_INCREMENTS, stop=at_goal, finish_snaps=True)
    points, events = _points(structure, net, drive, slow)
    reached = slow.ended == ("target" if goal is None else "stop")
    events.append(last_event(points, reached=reached))
    return path_of(structure, name, drive, points, events, reached=reached, remarks=remarks)


def _points(
    structure: Structure, net: Net, drive: Drive, slow: SlowPath
) -> tuple[list[QuasiStaticPoint], list[NumberedEvent]]:
    """Return the points of consecutive paths and of the snaps between them, and the snaps as events."""
    points, events = list[QuasiStaticPoint](), list[NumberedEvent]()
    for number, path in enumerate(slow.paths):
        points += [net_point(structure, net, drive, point.shape, point.factor) for point in path.points]
        if number >= len(slow.snaps):
            continue
        snap, first = slow.snaps[number], len(points) - 1
        points += [net_point(structure, net, drive, shape, snap.factor, resting=False) for shape in snap.descent]
        if number == len(slow.paths) - 1:
            points.append(net_point(structure, net, drive, snap.after.shape, snap.factor))
            events.append(_event(drive, snap, first, len(points) - 1))
        else:
            events.append(_event(drive, snap, first, len(points)))
    return points, events


def _event(drive: Drive, snap: Snap, first: int, last: int) -> NumberedEvent:
    """Return a snap, or a turn into another path, as an event."""
    branch = snap.kind == "branch"
    return NumberedEvent(
        kind="branch" if branch else "snap",
        first=first,
        last=last,
        strength=snap.factor * drive.strength,
        released=0.0 if branch else float(snap.released),
    )


def net_point(
    structure: Structure, net: Net, drive: Drive, shape: NetShape, factor: float, *, resting: bool = True
) -> QuasiStaticPoint:
    """Return a shape of a net as a point of a quasi-static path.

    Args:
        structure: the structure.
        net: net of the structure, with the coordinates held that the drive displaces.
        drive: the drive.
        shape: shape of the net.
        factor: load factor.
        resting: whether the net is at rest in this shape.
    """
    strength = factor * drive.strength
    force = reaction(structure, net, drive, shape) if prescribes_displacement(structure, drive) else 0.0
    return QuasiStaticPoint(
        strength=strength,
        resting=resting,
        angles=own_angles(structure, shape),
        positions=place_positions(structure, net, shape),
        coordinates=shape.positions.ravel(),
        energy=stored_parts(structure, net, shape, valley_angles(structure, strength * rest_changes(structure, drive))),
        force=force,
    )


def place_positions(structure: Structure, net: Net, shape: NetShape) -> Array:
    """Return the positions of a structure's points, then of the nodes of its membranes, m, (place, 3)."""
    points = point_positions(net, shape)[: len(structure.points)]
    at = {point.body: number for number, point in enumerate(structure.points)}
    nodes = [at[body] for membrane in structure.membranes for body in membrane.bodies.tolist()]
    return np.concatenate([points, points[nodes]])
