"""Course of a net under a slowly growing drive: snaps, the drive at its goal, and the resting shape after release."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from forficula.statics.net.contact.stable_path import Touch, first_touches
from forficula.statics.net.driven.driven_net import (
    FINE,
    INCREMENTS,
    driven_net,
    follow_drive,
    prescribes_displacement,
    short_of,
    up_to_goal,
)
from forficula.statics.net.driven.slow_path import SlowPath
from forficula.statics.net.energy import expand, moved_shape
from forficula.statics.net.factor import softest
from forficula.statics.net.load import Load
from forficula.statics.net.load_path import LoadPath, load_path
from forficula.statics.net.minimum import NetRest, minimum
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.net_of import own_angles
from forficula.statics.net.path_increment import PathPoint
from forficula.statics.net.supports import supported
from forficula.structure import (
    Drive,
    StageGoal,
    Structure,
    Transition,
    driven_motor,
)

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
        through: the equilibria on and beyond the first path, stable or not; None if the net does not snap, if they
            were not requested, or with contact.
        least: size of the drive at which the goal is first reached, in its SI unit; None if it is never reached, or
            without a goal.
        largest_force: largest total force along a displacement up to the goal, N; None for other drives.
        rest: where the net comes to rest when released at the end.
        touches: points of the slow path at which parts touch for the first time.
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
    touches: tuple[Touch, ...] = ()


def released(net: Net, built: NetShape) -> tuple[NetRest, tuple[str, ...]]:
    """Return the rest states of a net after its release, pushed off unstable equilibria, and a remark on the pushes."""
    rest, off = minimum(net, built, between_nodes=True), 0
    while rest.settled and rest.index and off < _RIDGES:
        held, _ = supported(net)
        mode = np.zeros_like(net.nodes)
        mode[held.free] = softest(expand(held, rest.shape).free, 1)[1][:, 0]
        mode *= _OFF * net.size / mode.flat[np.argmax(np.abs(mode))]
        pushed = [moved_shape(net, rest.shape, rest.shape.positions + sign * mode) for sign in (1, -1)]
        sides = [minimum(net, shape, between_nodes=True) for shape in pushed]
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
    driven = driven_net(structure, net, drive, transition)
    free, net, load, goal = net, driven.net, driven.load, driven.goal
    slow = follow_drive(driven, start.shape)
    if any(net.springs.rigid) and slow.ended == "stop" and len(slow.snaps) < len(slow.paths):
        # between the last two points creases may meet stops
        end = replace(slow.paths[-1], points=tuple(up_to_goal(driven, slow.paths[-1].points)))
        slow = replace(slow, paths=(*slow.paths[:-1], end))
    last = slow.points[-1] if len(slow.snaps) < len(slow.paths) else None
    shape = slow.snaps[-1].after.shape if last is None else last.shape
    factor = slow.snaps[-1].factor if last is None else last.factor
    through = None
    if slow.snaps and through_snaps and net.contact is None:
        through = load_path(
            net,
            start.shape,
            load,
            target=factor,
            step=FINE * net.size,
            increments=2 * INCREMENTS,
            locate_events=False,
        )
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
        touches=first_touches(net, slow.points),
    )


def _largest_force(structure: Structure, net: Net, drive: Drive, points: Sequence[PathPoint]) -> float | None:
    if not prescribes_displacement(structure, drive):
        return None
    return max((reaction(structure, net, drive, point.shape) for point in points), key=abs)


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
