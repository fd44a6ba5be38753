"""Quasi-static path of a net under one of its drives."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.kept_frames import kept_frames
from forficula.material.law.crease_turn import remembers
from forficula.statics.growing_path import (
    GrowingPath,
    NumberedEvent,
    contact_events,
    interval_errors,
    last_event,
    lengths_along,
    nearest_point,
    path_of,
)
from forficula.statics.net.driven.driven_net import DrivenNet, driven_net, follow_drive, point_between, up_to_goal
from forficula.statics.net.driven.net_course import drive_course, released
from forficula.statics.net.driven.net_point import net_point, place_positions
from forficula.statics.net.driven.slow_path import SlowPath, Snap
from forficula.statics.net.energy import shape_at
from forficula.statics.net.load_path import load_path
from forficula.statics.net.minimum import NetRest, minimum
from forficula.statics.net.net import NetShape
from forficula.statics.net.net_of import (
    net_of,
    start_shape,
    valley_angles,
)
from forficula.statics.net.path_increment import PathPoint
from forficula.statics.net.rigid_forces import loop_remarks, lost_reason
from forficula.statics.quasi_static_path import QuasiStaticPath, QuasiStaticPoint
from forficula.structure import Drive, Structure, Transition, drive_of

_INCREMENTS = 500  # of each path
_SWEEPS = 6  # halvings of the interval between two points
_SAME = 1e-3  # of the net's size: distance of two shapes that count as one
_MOST_POINTS = 1000  # of a snap
_LOOSE = "a part can move without any force: a crease has no spring, or a support is missing"


def net_path(
    structure: Structure,
    drive: Drive,
    transition: Transition | None,
    *,
    error: float,
    near: QuasiStaticPoint | None = None,
    follow: Callable[[QuasiStaticPath], bool] | None = None,
) -> QuasiStaticPath:
    """Follow a net under a slowly growing drive; see `forficula.statics.survey.quasi_static_path`."""
    if not any(drive.strengths):
        raise InputError(f'{structure.name}: need a drive "{drive.name}" with a strength other than 0, got 0')
    driven = driven_net(structure, net_of(structure), drive, transition)
    start, remarks = _start(driven)
    if not start.stable:
        points = [net_point(driven, start.shape, 0.0)]
        lost = [last_event(points, reached=False)]
        return path_of(structure, driven.name, drive, points, lost, reached=False, remarks=(*remarks, _LOOSE))
    if remembers(driven.net.creases.law) or driven.net.contact is not None:
        # the path depends on what happened before this shape, or may not lead back to the start
        near = None
    near_rest = None if near is None else _near_rest(driven, near)
    growing = GrowingPath(structure, driven.name, drive, follow, continued=near_rest is not None)
    slow = None if near is None or near_rest is None else _continued(driven, start, near, near_rest, growing)
    if slow is None:
        slow = _followed(driven, start.shape, growing)
    stretches = _Stretches(driven, slow)
    bound = error * structure.span
    for _ in range(_SWEEPS):
        if growing.stopped or not stretches.refine(bound, growing):
            break
        points = stretches.points(bound)[0]
        growing.show(points, at=_nearest(driven, points, near_rest))
    points, events = stretches.points(bound)
    events += contact_events(points)
    reached = slow.ended == ("target" if driven.goal is None else "stop") and not growing.stopped
    events.append(last_event(points, reached=reached))
    if reached and not points[-1].resting:
        points += _release(driven, slow.snaps[-1].after.shape, bound)
    return path_of(
        structure,
        driven.name,
        drive,
        points,
        events,
        reached=reached,
        complete=not growing.stopped,
        error=stretches.error() / structure.span,
        at=_nearest(driven, points, near_rest),
        remarks=(*remarks, *_path_remarks(driven, slow, stretches.shapes, events, reached=reached)),
    )


def _start(driven: DrivenNet) -> tuple[NetRest, tuple[str, ...]]:
    """Return where a net rests before the transition, and a remark on unstable equilibria on the way."""
    structure, free = driven.structure, driven.free
    start, remarks = released(free, start_shape(structure, free))
    for before in structure.transitions:
        if before is driven.transition or driven.transition is None or not start.stable:
            break
        drive = drive_of(structure, before.drive)
        start = drive_course(structure, free, start, drive, before, through_snaps=False).rest
    return start, remarks


def _followed(driven: DrivenNet, start: NetShape, growing: GrowingPath, begin: float = 0.0) -> SlowPath:
    """Follow the path from a shape at rest onwards.

    A snap continues to its rest. If it does not come to rest within the goal that it passes, it ends where it
    reaches the goal.
    """

    def watch(shape: NetShape, factor: float, resting: bool) -> None:
        growing.add(lambda: net_point(driven, shape, factor, resting=resting))

    slow = follow_drive(
        driven,
        start,
        begin=begin,
        stop=lambda: growing.stopped,
        finish_snaps=True,
        increments=_INCREMENTS,
        watch=watch,
    )
    passed = (driven.short_of_goal(shape) <= 0 for snap in slow.snaps for shape in snap.descent)
    rests = len(slow.snaps) < len(slow.paths) or slow.snaps[-1].after.settled
    if (slow.ended == "stop" and rests) or growing.stopped or not any(passed):
        return slow
    return follow_drive(driven, start, begin=begin, increments=_INCREMENTS)


def _near_rest(driven: DrivenNet, near: QuasiStaticPoint) -> NetRest | None:
    """Return the equilibrium that is reached downhill from a shape of another path, at the same strength of the drive.

    It is None if the shape has other parts, if there is no such equilibrium, or if it is already at the goal.
    """
    net, drive = driven.net, driven.drive
    if near.coordinates.size != net.nodes.size or len(near.angles) != len(driven.structure.hinges):
        return None
    factor = near.strength / drive.strength
    held = net.nodes + factor * driven.load.displacements
    positions = np.where(net.free, net.nodes + near.coordinates.reshape(-1, 3), held)
    shape = shape_at(net, positions, valley_angles(driven.structure, near.angles))
    rest = minimum(net, shape, driven.load, factor)
    return rest if rest.stable and driven.short_of_goal(rest.shape) > 0 else None


def _continued(
    driven: DrivenNet, start: NetRest, near: QuasiStaticPoint, rest: NetRest, growing: GrowingPath
) -> SlowPath | None:
    """Follow the path from an equilibrium onwards to its end, then back to its start.

    It is None if the way back meets an event or ends elsewhere, because the path to the start is then another one.
    """
    factor = near.strength / driven.drive.strength
    onwards = _followed(driven, rest.shape, growing, begin=factor)
    growing.hold()
    if growing.stopped or factor <= 0:
        return onwards if growing.stopped else None
    back = load_path(
        driven.net,
        rest.shape,
        driven.load,
        step=driven.step,
        increments=_INCREMENTS,
        factor=factor,
        target=0.0,
        events=1,
        rising=False,
        stop=lambda _: growing.stopped,
        watch=lambda point: growing.add(lambda: net_point(driven, point.shape, point.factor)),
    )
    if growing.stopped:
        return onwards
    apart = np.abs(back.points[-1].shape.positions - start.shape.positions).max()
    if back.ended != "target" or back.events or apart > _SAME * driven.net.size:
        return None
    before = tuple(replace(point, rising=True) for point in back.points[:0:-1])
    first = replace(onwards.paths[0], points=(*before, *onwards.paths[0].points))
    return replace(onwards, paths=(first, *onwards.paths[1:]))


def _release(driven: DrivenNet, shape: NetShape, bound: float) -> list[QuasiStaticPoint]:
    """Return the shapes that a net takes on its descent to rest after its drive is switched off.

    Args:
        driven: the net with its drive.
        shape: when the drive is released.
        bound: largest error of linear interpolation, m.
    """
    shapes = list[NetShape]()

    def watch(shape: NetShape) -> bool:
        shapes.append(shape)
        return False

    rest = minimum(driven.free, shape, stop=watch)
    kept = [*kept_shapes([shape, *shapes, rest.shape], bound), rest.shape]
    return [net_point(driven, shape, 0.0, resting=number == len(kept) - 1) for number, shape in enumerate(kept)]


def kept_shapes(shapes: Sequence[NetShape], bound: float) -> list[NetShape]:
    """Return the shapes between the first and the last one that linear interpolation needs.

    Args:
        shapes: in the order of a motion.
        bound: largest error of linear interpolation, m.
    """
    positions = np.array([shape.positions for shape in shapes])
    time = lengths_along(positions)
    rows = np.flatnonzero(np.diff(time, prepend=-1.0) > 0)
    kept = kept_frames(time[rows], positions[rows], (), most=_MOST_POINTS, tolerance=bound)
    return [shapes[row] for row in rows[kept[1:-1]].tolist()]


def _nearest(driven: DrivenNet, points: Sequence[QuasiStaticPoint], rest: NetRest | None) -> int | None:
    """Return the number of the point that is nearest to an equilibrium; None without one."""
    return None if rest is None else nearest_point(points, place_positions(driven.structure, driven.net, rest.shape))


class _Stretches:
    """Stretches of equilibria between the snaps of a path, to which points are added."""

    def __init__(self, driven: DrivenNet, slow: SlowPath) -> None:
        self._driven, self._slow = driven, slow
        self._stretches = [list(path.points) for path in slow.paths]
        self._known = dict[int, tuple[NetShape, QuasiStaticPoint]]()
        self._skipped = set[tuple[int, int]]()
        if slow.ended == "stop" and driven.goal is not None and len(slow.snaps) < len(slow.paths):
            self._stretches[-1] = up_to_goal(driven, self._stretches[-1])

    def refine(self, bound: float, growing: GrowingPath) -> bool:
        """Add a point in the middle of every interval whose error exceeds a bound, m; return whether any was added."""
        added = False
        for number, points in enumerate(self._stretches):
            errors, result = interval_errors(_positions(points)), points[:1]
            for place, (before, after) in enumerate(pairwise(points)):
                ends = (id(before), id(after))
                if errors[place] > bound and ends not in self._skipped and not growing.stopped:
                    middle = self._middle(points, place)
                    if middle is None:
                        self._skipped.add(ends)
                    else:
                        result.append(middle)
                        added = True
                result.append(after)
            self._stretches[number] = result
        return added

    def _middle(self, points: Sequence[PathPoint], place: int) -> PathPoint | None:
        """Find the equilibrium in the middle of an interval, from the cubic through its neighbours."""
        if self._driven.net.contact is not None:
            # where parts begin to touch, the path has a kink
            before, after = points[place : place + 2]
            positions = (before.shape.positions + after.shape.positions) / 2
            return point_between(self._driven, before, after, positions, (before.factor + after.factor) / 2)
        first = max(0, min(place - 1, len(points) - 4))
        near = points[first : first + 4]
        shapes = _positions(near)
        along = lengths_along(shapes)
        at = (along[place - first] + along[place - first + 1]) / 2
        nodes = along[:, None] - along[None, :] + np.eye(len(near))
        others = np.where(np.eye(len(near)), 1.0, at - along[None, :])
        weights = np.prod(others / nodes, axis=1)
        factor = float(weights @ [point.factor for point in near])
        positions = np.tensordot(weights, shapes, axes=1)
        driven, (before, after) = self._driven, points[place : place + 2]
        return point_between(driven, before, after, positions, factor)

    @property
    def shapes(self) -> list[NetShape]:
        """Return the shapes at rest."""
        return [point.shape for points in self._stretches for point in points]

    def error(self) -> float:
        """Return the largest estimated error of linear interpolation between equilibria, m."""
        return max(float(interval_errors(_positions(points)).max(initial=0.0)) for points in self._stretches)

    def points(self, bound: float) -> tuple[list[QuasiStaticPoint], list[NumberedEvent]]:
        """Return all points, and the snaps between stretches as events.

        Args:
            bound: largest error of linear interpolation within a snap, m.
        """
        points, events, drive = list[QuasiStaticPoint](), list[NumberedEvent](), self._driven.drive
        for number, stretch in enumerate(self._stretches):
            points += [self._point(point.shape, point.factor) for point in stretch]
            if number >= len(self._slow.snaps):
                continue
            snap, first = self._slow.snaps[number], len(points) - 1
            points += self._descent(snap, bound)
            if number == len(self._stretches) - 1:
                points.append(self._point(snap.after.shape, snap.factor, resting=snap.after.settled))
            last = len(points) - (number == len(self._stretches) - 1)
            events.append(_event(drive, snap, first, last))
        return points, events

    def _descent(self, snap: Snap, bound: float) -> list[QuasiStaticPoint]:
        """Return the shapes of a snap between which linear interpolation is accurate."""
        kept = kept_shapes([snap.before, *snap.descent, snap.after.shape], bound)
        return [self._point(shape, snap.factor, resting=False) for shape in kept]

    def _point(self, shape: NetShape, factor: float, *, resting: bool = True) -> QuasiStaticPoint:
        if id(shape) not in self._known:
            self._known[id(shape)] = shape, net_point(self._driven, shape, factor, resting=resting)
        return self._known[id(shape)][1]


def _positions(points: Sequence[PathPoint]) -> Array:
    """Return the positions of nodes at points of a path, m, (point, node, 3)."""
    return np.array([point.shape.positions for point in points])


def _event(drive: Drive, snap: Snap, first: int, last: int) -> NumberedEvent:
    """Return a snap, or a turn into another path, as an event."""
    branch = snap.kind == "branch"
    return NumberedEvent(
        kind="branch" if branch else "snap",
        first=first,
        last=last,
        strength=float(snap.factor * drive.strength),
        released=0.0 if branch else float(snap.released),
    )


def _path_remarks(
    driven: DrivenNet, slow: SlowPath, shapes: Sequence[NetShape], events: Sequence[NumberedEvent], *, reached: bool
) -> tuple[str, ...]:
    """Return sentences on unreliable parts of a path."""
    remarks = list[str]()
    if any(snap.kind != "limit" for snap in slow.snaps):
        remarks.append(
            f'under "{driven.name}" the path branches, and imperfections decide which branch a structure takes; the'
            " branch of lower energy is shown"
        )
    if reached and slow.snaps and len(slow.snaps) == len(slow.paths) and not slow.snaps[-1].after.settled:
        remarks.append(
            f'under "{driven.name}" a snap passes the goal and does not come to rest within it; the drive is released'
            " there, as in a run"
        )
    if not reached and events[-1].kind == "lost":
        reason = "was followed only as far as shown" if slow.ended == "lost" else "ends before its goal"
        remarks.append(f'the path under "{driven.name}" {reason}{lost_reason(driven.net)}')
    resting = [*shapes, *(snap.after.shape for snap in slow.snaps)]
    remarks += loop_remarks(driven.net, f'on the path under "{driven.name}"', resting)
    return tuple(remarks)
