"""Quasi-static path of bodies on joints in a tree under one of its drives."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from forficula.arrays import Array, Flags, Indices
from forficula.kept_frames import kept_frames
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
from forficula.statics.quasi_static_path import QuasiStaticPath, QuasiStaticPoint, rest_changes
from forficula.statics.tree.ensemble import Ensemble, ensemble, start_angles
from forficula.statics.tree.hinge_landscape import crossed_hinges
from forficula.statics.tree.hinge_memory import HingeMemory
from forficula.statics.tree.planes import table_forces
from forficula.statics.tree.pose import carried_points, places_of, pose, tree_of
from forficula.statics.tree.potential import hinge_angles, potential, rest, stored_energy
from forficula.statics.tree.quasi_static import (
    SlowTransition,
    TorquePath,
    at_goal,
    largest_torque,
    least_slow_torque,
    start_state,
    state_after,
)
from forficula.statics.tree_remarks import yield_remarks
from forficula.structure import Drive, Structure, Transition, goal_of

_MOST_POINTS = 2000  # of a path
_SWEEPS = 6  # halvings of the interval between two steps
_BESIDE = 0.01  # rad, by which a step may be outside the angles of its neighbours
_STILL = 1e-12  # of the span: distance along the path of two steps in the same shape


@dataclass(frozen=True, kw_only=True, eq=False)
class _DrivenTree:
    """A tree with one of its drives.

    Attributes:
        structures: the tree as the only case.
        drive: the drive.
        transition: that the drive makes; None for none.
        sign: of the drive.
        most: largest torque tried, N m.
    """

    structures: Ensemble
    drive: Drive
    transition: Transition | None
    sign: float
    most: float

    @property
    def torques(self) -> Array:
        """Return the torques of all motors per size of the drive, (motor,)."""
        return self.sign * np.array(self.drive.shares)


def tree_path(
    structure: Structure,
    drive: Drive,
    transition: Transition | None,
    *,
    error: float,
    near: QuasiStaticPoint | None = None,
    follow: Callable[[QuasiStaticPath], bool] | None = None,
) -> QuasiStaticPath:
    """Follow a tree under a slowly growing drive; see `forficula.statics.survey.quasi_static_path`."""
    driven, start = _start(structure, drive, transition)
    if driven.structures.memory is not None:
        near = None  # the path depends on what happened before this shape
    name = drive.name if transition is None else transition.name
    near_rest = None if near is None else _near_rest(driven, near)
    growing = GrowingPath(structure, name, drive, follow, continued=near_rest is not None)
    if near is not None and near_rest is not None:
        _followed(driven, near_rest, growing, begin=abs(near.strength))
        growing.hold()
    slow = _followed(driven, start, growing)
    # one half for the steps of the path, one half for steps that are left out
    bound = error * structure.span / 2
    path = slow.paths[0] if growing.stopped else _refined(driven, slow.paths[0], bound)
    points, events, missed = _points(driven, path, bound)
    reached = bool(np.isfinite(slow.torque[0])) if transition is not None else path.torque[-1] >= driven.most
    reached = reached and not growing.stopped
    events.append(last_event(points, reached=reached))
    remark = f'no slowly growing drive up to its full strength reaches the goal of "{name}"'
    return path_of(
        structure,
        name,
        drive,
        points,
        events,
        reached=reached,
        complete=not growing.stopped,
        error=missed / structure.span,
        at=None if near_rest is None else nearest_point(points, place_positions(structure, near_rest[None])[0]),
        remarks=(
            *(() if reached or growing.stopped else (remark,)),
            *yield_remarks(driven.structures, name, slow.paths[0], driven.torques),
        ),
    )


def _start(structure: Structure, drive: Drive, transition: Transition | None) -> tuple[_DrivenTree, Array]:
    """Return a tree with its drive, and the angles at which it rests before the transition, rad, (hinge,)."""
    structures, sign = ensemble([structure]), -1.0 if drive.strength < 0 else 1.0
    structures = structures.new(start_angles(structures))
    before, hinges = start_state(structures), crossed_hinges(structure)
    structures = structures.turned(before.position)
    for earlier in structure.transitions if transition is not None else ():
        most = largest_torque(structures, earlier, hinges)
        if earlier is transition:
            break
        slow = least_slow_torque(structures, before.position, earlier, most)
        structures = slow.structures or structures
        before = state_after(structures, earlier, slow.torque, slow.position)
        structures = structures.turned(before.position)
    else:
        most = abs(drive.strength)
    driven = _DrivenTree(structures=structures, drive=drive, transition=transition, sign=sign, most=most)
    return driven, before.position[0]


def _followed(driven: _DrivenTree, start: Array, growing: GrowingPath, begin: float = 0.0) -> SlowTransition:
    """Follow the path from angles at rest, rad, (hinge,), onwards."""
    at = driven.structures

    def watch(torque: float, angles: Array, resting: bool) -> None:
        nonlocal at
        now = at.turned(angles[None])
        # the motions to all steps of a snap begin before the snap
        at = now if resting else at
        strength, rests = np.array([driven.sign * torque]), np.array([resting], dtype=np.bool_)
        growing.add(lambda: tree_points(now, driven.drive, strength, angles[None], rests, now.memory)[0])

    return least_slow_torque(
        driven.structures,
        start[None],
        driven.transition,
        driven.most,
        driven.drive,
        begin=begin,
        recorded=True,
        watch=watch,
        stop=lambda: growing.stopped,
    )


def _near_rest(driven: _DrivenTree, near: QuasiStaticPoint) -> Array | None:
    """Return the angles that are reached downhill from a shape of another path, at the same strength of the drive.

    It is None if the shape has other parts, if there is no such equilibrium, or if it is already at the goal.
    """
    structures = driven.structures
    if near.coordinates.size != structures.size or near.strength * driven.sign < 0:
        return None
    rested = rest(structures, near.coordinates[None], abs(near.strength) * driven.torques)
    if not rested.rests[0] or abs(near.strength) >= driven.most:
        return None
    if driven.transition is not None:
        goal = goal_of(structures.structure, driven.transition.goal)
        if at_goal(structures, rested.position, goal)[0]:
            return None
    return np.asarray(rested.position[0])


def _snapping(path: TorquePath) -> Flags:
    """Return which intervals between steps of a path belong to snaps, (interval,)."""
    snapping = np.zeros(len(path.torque) - 1, dtype=np.bool_)
    for first, last in path.snaps:
        snapping[first:last] = True
    return snapping


def _along(structures: Ensemble, path: TorquePath) -> Array | None:
    """Return the memory of the hinges along a path of the only case, (slot, step, hinge); None without memory.

    The motions to all steps of a snap begin with the memory before the snap.
    """
    if structures.memory is None:
        return None
    begins, before, values = dict[int, int](), structures.memory, list[Array]()
    for first, last in path.snaps:
        begins |= dict.fromkeys(range(first + 1, last + 1), first)
    for step, at in enumerate(path.position):
        reached = before.turned(at[None])
        values.append(reached.values[:, 0])
        # the last step of a snap is followed by motions from there
        before = before if step in begins and step + 1 in begins and begins[step + 1] == begins[step] else reached
    return np.stack(values, axis=1)


def _refined(driven: _DrivenTree, path: TorquePath, bound: float) -> TorquePath:
    """Add a step in the middle of every interval whose error exceeds a bound, m, or in which parts touch or part.

    Snaps have no such intervals.
    """
    structures = driven.structures
    for _ in range(_SWEEPS):
        errors = interval_errors(place_positions(structures.structure, path.position))
        coarse = (errors > bound) | _touch_changes(driven, path)
        rows = np.flatnonzero(coarse & ~_snapping(path) & (np.diff(path.torque) > 0))
        if not len(rows):
            break
        torque = (path.torque[rows] + path.torque[rows + 1]) / 2
        middle = (path.position[rows] + path.position[rows + 1]) / 2
        memory = _along(structures, path)
        repeated = structures.repeated(len(rows))
        between = repeated.beginning(None if memory is None else memory[:, rows], path.position[rows])
        rested = rest(between, middle, torque[:, None] * driven.torques)
        # a shape outside the interval belongs to another path
        low, high = (bounds(path.position[rows], path.position[rows + 1]) for bounds in (np.minimum, np.maximum))
        inside = np.all((rested.position >= low - _BESIDE) & (rested.position <= high + _BESIDE), axis=1)
        rows, torque, position = rows[inside], torque[inside], rested.position[inside]
        if not len(rows):
            break
        shift = np.searchsorted(rows, np.arange(len(path.torque)))
        path = TorquePath(
            torque=np.insert(path.torque, rows + 1, torque),
            position=np.insert(path.position, rows + 1, position, axis=0),
            snaps=tuple((int(first + shift[first]), int(last + shift[last])) for first, last in path.snaps),
        )
    return path


def _touch_changes(driven: _DrivenTree, path: TorquePath) -> Flags:
    """Return in which intervals between steps of a path a body begins or ceases to touch the table, (interval,)."""
    touching = [set(forces) for forces in table_forces(driven.structures.planes, path.position)]
    return np.array([before != after for before, after in pairwise(touching)], dtype=np.bool_)


def _points(
    driven: _DrivenTree, path: TorquePath, bound: float
) -> tuple[list[QuasiStaticPoint], list[NumberedEvent], float]:
    """Return points between which linear interpolation follows a path, its snaps, and the error of interpolation, m.

    Args:
        driven: the tree with its drive.
        path: of the tree.
        bound: largest error of leaving out steps of the path, m.
    """
    resting = np.ones(len(path.torque), dtype=np.bool_)
    for first, last in path.snaps:
        resting[first + 1 : last] = False
    span = driven.structures.structure.span
    positions = place_positions(driven.structures.structure, path.position)
    # steps that move nothing keep their order
    time = lengths_along(positions) + _STILL * span * np.arange(len(positions))
    changed = np.flatnonzero(_touch_changes(driven, path) & ~_snapping(path)).tolist()
    touched = {row for change in changed for row in (change, change + 1)}
    ends = sorted({0, len(resting) - 1, *touched, *(end for snap in path.snaps for end in snap)})
    kept = kept_frames(time, positions, time[ends], most=_MOST_POINTS, tolerance=bound)
    numbers = {row: number for number, row in enumerate(kept.tolist())}
    memory = _along(driven.structures, path)
    points = tree_points(
        driven.structures,
        driven.drive,
        driven.sign * path.torque[kept],
        path.position[kept],
        resting[kept],
        None if memory is None else driven.structures.beginning(memory[:, kept], path.position[kept]).memory,
    )
    events = contact_events(points)
    for first, last in path.snaps:
        torque = float(path.torque[last])
        start = [first, first]
        repeated = driven.structures.repeated(2)
        both = repeated.beginning(None if memory is None else memory[:, start], path.position[start])
        energy = potential(both, path.position[[first, last]], torque * driven.torques)[0]
        events.append(
            NumberedEvent(
                kind="snap",
                first=numbers[first],
                last=numbers[last],
                strength=driven.sign * torque,
                released=float(energy[0] - energy[1]),
            )
        )
    return points, events, bound + float(interval_errors(positions)[~_snapping(path)].max(initial=0.0))


def tree_points(
    structures: Ensemble,
    drive: Drive,
    strength: Array,
    angles: Array,
    resting: Flags,
    memory: HingeMemory | None = None,
) -> list[QuasiStaticPoint]:
    """Return shapes of a tree as points of a quasi-static path.

    Args:
        structures: the tree as the only case.
        drive: the drive.
        strength: of the drive, in its SI unit, with its sign, (point,).
        angles: of all joints, rad, (point, joint).
        resting: whether the tree is at rest, (point,).
        memory: of the hinges at all points; None if no hinge remembers anything.
    """
    further = strength[:, None] * rest_changes(structures.structure, drive)
    energy = stored_energy(structures.repeated(len(strength)), angles, further, memory)
    contacts = table_forces(structures.planes, angles)
    positions, every = place_positions(structures.structure, angles), hinge_angles(structures, angles)
    return [
        QuasiStaticPoint(
            strength=float(strength[number]),
            resting=bool(resting[number]),
            angles=every[number],
            positions=positions[number],
            coordinates=angles[number],
            energy={part: float(values[number]) for part, values in energy.items()},
            memory=None if memory is None else memory.values[:, number],
            contacts=contacts[number] if resting[number] else {},
        )
        for number in range(len(strength))
    ]


def place_positions(structure: Structure, angles: Array) -> Array:
    """Return the positions of a structure's points, then of the nodes of its membranes, m, (case, place, 3).

    Args:
        structure: a tree.
        angles: of all joints, in their own senses, rad, (case, joint); angles of creases may follow and are ignored.
    """
    tree = tree_of(structure)
    carried = carried_points(tree, *place_carriers(structure))
    return np.moveaxis(places_of(carried, pose(tree, angles)), 0, -1)


def place_carriers(structure: Structure) -> tuple[Indices, Array]:
    """Return the bodies that carry the places, (place,), and the places in the axes of these bodies, m, (place, 3)."""
    bodies = [np.array([point.body for point in structure.points], dtype=np.int64)]
    places = [np.array([point.place for point in structure.points]).reshape(-1, 3)]
    for membrane in structure.membranes:
        bodies.append(membrane.bodies)
        places.append(membrane.places)
    return np.concatenate(bodies), np.concatenate(places)
