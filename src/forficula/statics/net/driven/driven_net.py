"""A net under one of its drives, and the path on which the growing drive takes it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.statics.net.contact.stable_path import stable_point_between
from forficula.statics.net.driven.slow_path import SlowPath, slow_path
from forficula.statics.net.load import Load
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.net_of import motor_load, own_angles, point_positions
from forficula.statics.net.path_increment import PathPoint, intermediate_point
from forficula.structure import (
    Drive,
    StageGoal,
    Structure,
    Transition,
    driven_motor,
    goal_coordinates,
    goal_of,
    point_distances,
)

_MOST = 4.0  # largest multiple of a drive's strength if its strength is not sufficient
INCREMENTS = 120  # of each path
_HALVINGS = 20  # of the last interval, to locate the goal
_ARRIVED = 1e-9  # rad or m, distance from the goal
FINE = 0.008  # first increment of equilibria that are drawn through a snap or with a force, of the net's size


@dataclass(frozen=True, kw_only=True, eq=False)
class DrivenNet:
    """A net with one of its drives.

    Attributes:
        structure: the structure.
        drive: the drive; its strength is the load factor 1.
        transition: that the drive makes; None for none.
        free: net of the structure.
        net: the same net, with the coordinates held that the drive displaces.
        load: of the drive.
        goal: of the transition; None for none.
    """

    structure: Structure
    drive: Drive
    transition: Transition | None
    free: Net
    net: Net
    load: Load
    goal: StageGoal | None

    @property
    def name(self) -> str:
        """Return the name of the transition, or of the drive if it makes none."""
        return self.drive.name if self.transition is None else self.transition.name

    @property
    def end(self) -> float:
        """Return the largest load factor."""
        return 1.0 if self.goal is None else _MOST

    @property
    def step(self) -> float | None:
        """Return the first increment of paths, m; short for a displacement, whose force is drawn; None by default."""
        return FINE * self.net.size if prescribes_displacement(self.structure, self.drive) else None

    def short_of_goal(self, shape: NetShape) -> float:
        """Return by how much a shape is outside the goal's bounds, rad or m; <= 0 within them; inf without a goal."""
        return math.inf if self.goal is None else short_of(self.structure, self.net, self.goal, shape)


def driven_net(structure: Structure, free: Net, drive: Drive, transition: Transition | None) -> DrivenNet:
    """Return the net of a structure with one of its drives.

    Args:
        structure: the structure.
        free: net of the structure.
        drive: the drive.
        transition: that the drive makes; None for none.

    Raises:
        InputError: a displacement is not along an axis.
    """
    net = displaced_net(structure, free, drive)
    return DrivenNet(
        structure=structure,
        drive=drive,
        transition=transition,
        free=free,
        net=net,
        load=motor_load(structure, net, drive.strengths),
        goal=None if transition is None else goal_of(structure, transition.goal),
    )


def follow_drive(
    driven: DrivenNet,
    start: NetShape,
    *,
    begin: float = 0.0,
    stop: Callable[[], bool] = lambda: False,
    finish_snaps: bool = False,
    increments: int = INCREMENTS,
    watch: Callable[[NetShape, float, bool], None] = lambda _shape, _factor, _resting: None,
) -> SlowPath:
    """Let the drive of a net grow slowly, to the goal or to the largest load factor.

    Args:
        driven: the net with its drive.
        start: stable at the first factor.
        begin: first factor.
        stop: ends the path if it returns True.
        finish_snaps: whether a snap continues to its rest if it passes the goal.
        increments: of each path.
        watch: as for `slow_path`.
    """

    def at_goal(shape: NetShape) -> bool:
        return stop() or driven.short_of_goal(shape) <= 0

    return slow_path(
        driven.net,
        start,
        driven.load,
        begin=begin,
        end=driven.end,
        step=driven.step,
        increments=increments,
        stop=at_goal,
        stop_snaps=(lambda _: stop()) if finish_snaps else at_goal,
        watch=watch,
    )


def up_to_goal(driven: DrivenNet, points: Sequence[PathPoint]) -> list[PathPoint]:
    """Replace the last point of a path by the one at which the goal is reached (regula falsi with halved weights)."""
    if len(points) < 2:
        return list(points)
    before, after = points[-2:]
    low, high = driven.short_of_goal(before.shape), driven.short_of_goal(after.shape)
    for _ in range(_HALVINGS):
        if not (math.isfinite(low) and low > 0 >= high) or -high <= _ARRIVED:
            break
        share = float(np.clip(low / (low - high), 0.05, 1 - 1e-6))
        positions = (1 - share) * before.shape.positions + share * after.shape.positions
        factor = (1 - share) * before.factor + share * after.factor
        middle = point_between(driven, before, after, positions, factor)
        if middle is None:
            break
        value = driven.short_of_goal(middle.shape)
        if value > 0:
            before, low = middle, value
        else:
            after, high = middle, value
    return [*points[:-1], after]


def point_between(
    driven: DrivenNet, before: PathPoint, after: PathPoint, positions: Array, factor: float
) -> PathPoint | None:
    """Find the equilibrium between two points of a path near a guess; None without one."""
    net, load = driven.net, driven.load
    point = None
    if net.contact is None:
        point = intermediate_point(net, load, before, after, positions, factor)
    # where a crease meets its stop, the forces of rigid parts have a kink
    if net.contact is not None or (point is None and any(net.springs.rigid)):
        point = stable_point_between(net, load, before, after, positions, factor)
    return point


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
    distances = point_distances(structure, point_positions(net, shape))
    return goal_coordinates(structure, own_angles(structure, shape), distances)


def short_of(structure: Structure, net: Net, goal: StageGoal, shape: NetShape) -> float:
    """Return by how much a shape is outside a goal's bounds, rad or m; <= 0 within them."""
    read = goal_values(structure, net, shape)
    return float(max(np.max(goal.least - read, initial=-np.inf), np.max(read - goal.most, initial=-np.inf)))


def prescribes_displacement(structure: Structure, drive: Drive) -> bool:
    """Return whether a drive prescribes displacements of points instead of forces or torques."""
    return driven_motor(structure, drive).kind == "displacement"
