"""What a drive that grows slowly does to a net: where it snaps, when it is at its goal, where it rests when let go."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.statics.net.energy import expand
from forficula.statics.net.load import Load
from forficula.statics.net.load_path import LoadPath, PathPoint, load_path
from forficula.statics.net.minimum import NetRest, minimum
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.net_of import motor_load, own_angles, places
from forficula.statics.net.slow_path import SlowPath, slow_path
from forficula.structure import (
    Drive,
    StageGoal,
    Structure,
    Transition,
    distances_of,
    driven_motor,
    goal_coordinates,
    goal_of,
)

_MOST = 4.0  # of a drive's strength: how far it is followed where that does not suffice
_INCREMENTS = 120
_FINE = 0.008  # first increment of the equilibria through a snap, of the net's size: they are drawn


@dataclass(frozen=True, kw_only=True, eq=False)
class Course:
    """What a slowly growing drive does, from a state in which the net rests.

    Attributes:
        name: of the transition that it makes, or of the drive.
        drive: whose strength is the factor 1.
        load: of that.
        start: where it begins.
        slow: what the net does, up to the goal, or as far as it was followed.
        through: the equilibria on and beyond the first path, stable or not, where it snaps
            and they were asked for; else None.
        least: size of the drive at which the goal is first reached, in its SI unit; None where it never is, or where
            there is no goal.
        largest_force: on all points of a displacement together, up to there, along it, N; None of other drives.
        rest: where it comes to rest when let go at the end.
    """

    name: str
    drive: Drive
    load: Load
    start: NetRest
    slow: SlowPath
    through: LoadPath | None
    least: float | None
    largest_force: float | None
    rest: NetRest


def drive_course(
    structure: Structure,
    net: Net,
    start: NetRest,
    drive: Drive,
    transition: Transition | None,
    *,
    through_snaps: bool = True,
) -> Course:
    """Let a drive grow slowly from a stable state, to the goal of a transition or to its own strength.

    Args:
        structure: that the net is of.
        net: of it.
        start: stable.
        drive: of some strength.
        transition: that it makes; None for none.
        through_snaps: whether to follow the equilibria through its snaps, too, which takes about as long as all else.

    Raises:
        InputError: it would carry the whole away.
    """
    free, net = net, displaced_net(structure, net, drive)
    load = motor_load(structure, net, drive.strengths)
    goal = None if transition is None else goal_of(structure, transition.goal)

    def there(shape: NetShape) -> bool:
        return goal is not None and short_of(structure, net, goal, shape) <= 0

    end = 1.0 if goal is None else _MOST
    # a displacement tells its force all along the way, which is drawn
    step = _FINE * net.size if displaces(structure, drive) else None
    slow = slow_path(net, start.shape, load, end=end, step=step, increments=_INCREMENTS, stop=there)
    last = slow.points[-1] if len(slow.snaps) < len(slow.paths) else None
    shape = slow.snaps[-1].after.shape if last is None else last.shape
    factor = slow.snaps[-1].factor if last is None else last.factor
    through = None
    if slow.snaps and through_snaps:
        through = load_path(net, start.shape, load, target=factor, step=_FINE * net.size, increments=2 * _INCREMENTS)
    reached = None if goal is None else _first_at(structure, net, goal, slow.points)
    if reached is None and slow.ended == "stop":
        reached = factor
    return Course(
        name=drive.name if transition is None else transition.name,
        drive=drive,
        load=load,
        start=start,
        slow=slow,
        through=through,
        least=None if reached is None else reached * abs(drive.strength),
        largest_force=_largest_force(structure, net, drive, slow.points),
        rest=minimum(free, shape),
    )


def _largest_force(structure: Structure, net: Net, drive: Drive, points: Sequence[PathPoint]) -> float | None:
    if not displaces(structure, drive):
        return None
    return max((reaction(structure, net, drive, point.shape) for point in points), key=abs)


def displaced_net(structure: Structure, net: Net, drive: Drive) -> Net:
    """A net of which what a drive displaces is held along its way.

    Raises:
        InputError: a way that is not along an axis.
    """
    held = net.free.copy()
    for motor, share in zip(structure.motors, drive.shares, strict=True):
        if motor.kind != "displacement" or motor.direction is None or not share:
            continue
        axes = np.flatnonzero(motor.direction)
        if len(axes) > 1:
            raise InputError(f"drive.{motor.name}.direction: need x, y or z, for statics holds points along these only")
        held[list(motor.points), axes[0]] = False
    return net if np.array_equal(held, net.free) else replace(net, free=held)


def watched(structure: Structure, net: Net, shape: NetShape) -> Array:
    """What goals are bounds on: angles and distances, rad and m, (coordinate,)."""
    pairs = [list(each.points) for each in distances_of(structure) if each.points is not None]
    distances = [np.linalg.norm(np.diff(places(net, shape)[pair], axis=0)) for pair in pairs]
    return goal_coordinates(structure, own_angles(structure, shape), np.array(distances))


def short_of(structure: Structure, net: Net, goal: StageGoal, shape: NetShape) -> float:
    """By how much a shape is out of a goal's bounds, rad or m; not above 0 within."""
    read = watched(structure, net, shape)
    return float(max(np.max(goal.least - read, initial=-np.inf), np.max(read - goal.most, initial=-np.inf)))


def displaces(structure: Structure, drive: Drive) -> bool:
    """Whether a drive moves points by a way, whatever force that takes."""
    return driven_motor(structure, drive).kind == "displacement"


def gone(structure: Structure, net: Net, drive: Drive, shape: NetShape) -> float:
    """How far a drive has gone on the way that it pushes: m of its points, or rad of its hinges, weighted mean.

    The weights are the shares of its motors, of which those count that are of the kind of the first.
    """
    kind, far, weight = driven_motor(structure, drive).kind, 0.0, 0.0
    for motor, share in zip(structure.motors, drive.shares, strict=True):
        if not share or motor.kind != kind:
            continue
        if motor.direction is not None:
            ways = (net.points @ (shape.positions - net.nodes))[list(motor.points)] @ motor.direction
        else:
            ways = np.sign(motor.gains or [1.0]) * own_angles(structure, shape)[list(motor.hinges)]
        far, weight = far + share * float(ways.sum()), weight + abs(share) * len(ways)
    return float(np.sign(drive.strength or 1.0)) * far / weight


def reaction(structure: Structure, net: Net, drive: Drive, shape: NetShape) -> float:
    """The force that a displacement takes, on all its points together and along it, N.

    What is stored changes by it times the way: it is the slope of the potential by how far the drive has gone.
    """
    slope, force = expand(net, shape).slope, 0.0
    for motor, share in zip(structure.motors, drive.shares, strict=True):
        if share and motor.kind == "displacement" and motor.direction is not None:
            force += share * float(np.sum(slope[list(motor.points)] @ motor.direction))
    return float(np.sign(drive.strength or 1.0)) * force


def _first_at(structure: Structure, net: Net, goal: StageGoal, points: Sequence[PathPoint]) -> float | None:
    """The factor at which a goal is first reached, between two points in proportion; None where it never is."""
    before, beside = None, np.inf
    for point in points:
        out = short_of(structure, net, goal, point.shape)
        if out <= 0:
            if before is None or not np.isfinite(beside) or point.factor <= before.factor:
                return float(point.factor)
            return float(before.factor + (point.factor - before.factor) * beside / (beside - out))
        before, beside = point, out
    return None
