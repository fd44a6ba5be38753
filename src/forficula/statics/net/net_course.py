"""Course of a net under a slowly growing drive: snaps, the drive at its goal, and the resting shape after release."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.statics.net.energy import expand, shape_at
from forficula.statics.net.factor import softest
from forficula.statics.net.load import Load
from forficula.statics.net.load_path import LoadPath, PathPoint, load_path
from forficula.statics.net.minimum import NetRest, minimum
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.net_of import motor_load, own_angles, point_positions
from forficula.statics.net.slow_path import SlowPath, slow_path
from forficula.statics.net.supports import supported
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

MOST = 4.0  # largest multiple of a drive's strength if its strength is not sufficient
_INCREMENTS = 120
_FINE = 0.008  # first increment of the equilibria through a snap, of the net's size; short because they are drawn


_OFF = 1e-3  # of the net's size: a push off an unstable equilibrium
_RIDGES = 8  # largest number of such pushes


@dataclass(frozen=True, kw_only=True, eq=False)
class Course:
    """Effect of a slowly growing drive on a net that starts at rest.

    Attributes:
        name: of the transition that the drive makes, or of the drive.
        drive: its strength is the load factor 1.
        load: of the drive.
        start: equilibrium at the start.
        slow: path of the net, up to the goal or as far as it was followed.
        through: the equilibria on and beyond the first path, stable or not; None if the net does not snap, or if they
            were not requested.
        least: size of the drive at which the goal is first reached, in its SI unit; None if it is never reached, or
            without a goal.
        largest_force: largest total force along a displacement up to the goal, N; None for other drives.
        rest: where the net comes to rest when released at the end.
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


def released(net: Net, built: NetShape) -> tuple[NetRest, tuple[str, ...]]:
    """Return the rest states of a net after its release, pushed off unstable equilibria, and a remark on the pushes."""
    rest, off = minimum(net, built), 0
    while rest.settled and rest.index and off < _RIDGES:
        held, _ = supported(net)
        mode = np.zeros_like(net.nodes)
        mode[held.free] = softest(expand(held, rest.shape).free, 1)[1][:, 0]
        mode *= _OFF * net.size / mode.flat[np.argmax(np.abs(mode))]
        sides = [minimum(net, shape_at(net, rest.shape.positions + sign * mode, rest.shape.angles)) for sign in (1, -1)]
        rest, off = min(sides, key=lambda side: side.energy), off + 1
    if not off:
        return rest, ()
    return rest, (
        "released as built, it comes to an unstable equilibrium, from which it can move to several states; the state"
        " taken here is the one of lower energy on both sides of its softest mode or, if the energies are equal, the"
        " one in the direction of the mode's largest coordinate",
    )


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
        structure: the structure.
        net: net of the structure.
        start: stable.
        drive: with a strength other than 0.
        transition: that the drive makes; None for none.
        through_snaps: whether to follow the equilibria through its snaps as well, which doubles the time.

    Raises:
        InputError: the drive would move the net as a rigid body.
    """
    free, net = net, displaced_net(structure, net, drive)
    load = motor_load(structure, net, drive.strengths)
    goal = None if transition is None else goal_of(structure, transition.goal)

    def at_goal(shape: NetShape) -> bool:
        return goal is not None and short_of(structure, net, goal, shape) <= 0

    end = 1.0 if goal is None else MOST
    # the force of a displacement is drawn along the whole path, which needs short steps
    step = _FINE * net.size if prescribes_displacement(structure, drive) else None
    slow = slow_path(net, start.shape, load, end=end, step=step, increments=_INCREMENTS, stop=at_goal)
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
    if not prescribes_displacement(structure, drive):
        return None
    return max((reaction(structure, net, drive, point.shape) for point in points), key=abs)


def displaced_net(structure: Structure, net: Net, drive: Drive) -> Net:
    """Return a net in which the coordinates that a drive displaces are held.

    Raises:
        InputError: the displacement is not along an axis.
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


def goal_values(structure: Structure, net: Net, shape: NetShape) -> Array:
    """Return the coordinates that goals bound: angles and distances, rad and m, (coordinate,)."""
    pairs = [list(distance.points) for distance in distances_of(structure) if distance.points is not None]
    distances = [np.linalg.norm(np.diff(point_positions(net, shape)[pair], axis=0)) for pair in pairs]
    return goal_coordinates(structure, own_angles(structure, shape), np.array(distances))


def short_of(structure: Structure, net: Net, goal: StageGoal, shape: NetShape) -> float:
    """Return by how much a shape is outside a goal's bounds, rad or m; <= 0 within them."""
    read = goal_values(structure, net, shape)
    return float(max(np.max(goal.least - read, initial=-np.inf), np.max(read - goal.most, initial=-np.inf)))


def prescribes_displacement(structure: Structure, drive: Drive) -> bool:
    """Return whether a drive prescribes displacements of points instead of forces or torques."""
    return driven_motor(structure, drive).kind == "displacement"


def drive_displacement(structure: Structure, net: Net, drive: Drive, shape: NetShape) -> float:
    """Return the displacement along a drive: weighted mean over its points, m, or its hinges, rad.

    The weights are the shares of its motors. Only motors of the same kind as the first one count.
    """
    kind, far, weight = driven_motor(structure, drive).kind, 0.0, 0.0
    for motor, share in zip(structure.motors, drive.shares, strict=True):
        if not share or motor.kind != kind:
            continue
        if motor.direction is not None:
            travels = (net.points @ (shape.positions - net.nodes))[list(motor.points)] @ motor.direction
        else:
            travels = np.sign(motor.gains or [1.0]) * own_angles(structure, shape)[list(motor.hinges)]
        far, weight = far + share * float(travels.sum()), weight + abs(share) * len(travels)
    return float(np.sign(drive.strength or 1.0)) * far / weight


def reaction(structure: Structure, net: Net, drive: Drive, shape: NetShape) -> float:
    """Compute the force of a displacement on all its points, in its direction, N.

    It is the derivative of the potential by the displacement of the drive.
    """
    slope, force = expand(net, shape).slope, 0.0
    for motor, share in zip(structure.motors, drive.shares, strict=True):
        if share and motor.kind == "displacement" and motor.direction is not None:
            force += share * float(np.sum(slope[list(motor.points)] @ motor.direction))
    return float(np.sign(drive.strength or 1.0)) * force


def _first_at(structure: Structure, net: Net, goal: StageGoal, points: Sequence[PathPoint]) -> float | None:
    """Return the factor at which a goal is first reached, interpolated between points; None if it is never reached."""
    before, missing = None, np.inf
    for point in points:
        out = short_of(structure, net, goal, point.shape)
        if out <= 0:
            if before is None or not np.isfinite(missing) or point.factor <= before.factor:
                return float(point.factor)
            return float(before.factor + (point.factor - before.factor) * missing / (missing - out))
        before, missing = point, out
    return None
