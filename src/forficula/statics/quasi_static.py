"""How structures give way to slowly growing torques: the least ones that take them to a goal, without any inertia."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from forficula.errors import InputError
from forficula.statics.equilibrium import Equilibria
from forficula.statics.pose import carried_points, places_of, pose
from forficula.statics.potential import Ensemble, rest, start_angles
from forficula.structure import (
    Drive,
    Goal,
    Structure,
    Transition,
    distances_of,
    drive_of,
    goal_coordinates,
    goal_of,
    hinge_bounds,
)

Array = NDArray[np.float64]

_LEAD_IN = 4  # halvings of the first torque
_ACCURACY = 0.01  # of a least torque
_FIRST_STEP = 1e-4  # of the largest torque tried, which no step is shorter than
_NEAR = 0.3  # rad, by which hinges turn at most without a snap from step to step


@dataclass(frozen=True, kw_only=True)
class SlowTransition:
    """What a slowly growing torque does to structures.

    Attributes:
        torque: size of the least that brings each to its goal, N m, nan where none of those tried does, (case,).
        position: angles under the least torque, or under the largest one tried, rad, (case, hinge).
    """

    torque: Array
    position: Array


def start_state(structures: Ensemble) -> Equilibria:
    """Where structures rest without torques when let go from where the protocol starts them."""
    return rest(structures, start_angles(structures))


def state_beyond(structures: Ensemble, transition: Transition) -> Equilibria:
    """Where structures rest without torques when let go from where a transition leads, as far as stops allow.

    Hinges that its goal bounds start at their stops on that side, hinges that its drive turns at the stops that it
    turns them to. With these held, the others go to where they rest, and then all do.

    Raises:
        InputError: neither goal nor drive says where that is.
    """
    built = structures.structure
    goal, drive = goal_of(built, transition.goal), drive_of(built, transition.drive)
    start = np.zeros((structures.cases, structures.size))
    pushed = _by_unit(drive) @ structures.drives
    (least, most), ends = hinge_bounds(built, goal), np.full(structures.size, np.nan)
    for towards, stops in ((pushed < 0, structures.lower), (pushed > 0, structures.upper)):
        ends[towards] = stops[towards]
    for bounded, bounds, stops in (
        (np.isfinite(most), most, structures.lower),
        (np.isfinite(least), least, structures.upper),
    ):
        ends[bounded] = np.where(np.isfinite(stops), stops, bounds)[bounded]
    placed = np.flatnonzero(np.isfinite(ends))
    if not len(placed):
        raise InputError(
            f"{built.name}: nothing says where {transition.name} leads: need a goal that bounds hinges, or a drive of"
            " hinges with stops"
        )
    start[:, placed] = ends[placed]
    closed = rest(structures, start, fixed=placed.tolist())
    return rest(structures, closed.position)


def at_goal(structures: Ensemble, position: Array, goal: Goal) -> NDArray[np.bool_]:
    """Whether every hinge and distance is within a goal's bounds, (case,)."""
    built = structures.structure
    read = goal_coordinates(built, position, _distances(built, structures, position))
    return np.asarray(np.all((read >= goal.least) & (read <= goal.most), axis=1))


def _distances(structure: Structure, structures: Ensemble, position: Array) -> Array:
    """Distances that are measured, m, (case, distance)."""
    ends = [measure.points for measure in distances_of(structure) if measure.points is not None]
    if not ends:
        return np.zeros((len(position), 0))
    tree, points = structures.sheet.laid.tree, [structure.points[number] for pair in ends for number in pair]
    carried = carried_points(tree, [point.body for point in points], np.array([point.place for point in points]))
    places = places_of(carried, pose(tree, position))
    return np.asarray(np.linalg.norm(places[:, :, 1::2] - places[:, :, ::2], axis=0))


def slow_transition(structures: Ensemble, start: Array, transition: Transition, torques: ArrayLike) -> SlowTransition:
    """Let a transition's torque grow from step to step, wait for rest at each, and see when it gets to its goal.

    A torque that comes at once may lead elsewhere than one that grows: it chooses which hinges turn where hardly
    anything holds them. So where it acts on hinges that no tendon crosses, smaller ones come before the first.

    Args:
        structures: side by side.
        start: angles at rest without torques, rad, (case, hinge).
        transition: whose drive and goal.
        torques: sizes, rising, N m, (step,); the sign is that of the drive's.
    """
    goal, drive = goal_of(structures.structure, transition.goal), drive_of(structures.structure, transition.drive)
    position, least = start.copy(), np.full(len(start), np.nan)
    steps = np.asarray(torques, dtype=np.float64)
    before = [] if crosses(structures, drive) else steps[0] / 2.0 ** np.arange(_LEAD_IN, 0, -1)
    for torque in [*before, *steps]:
        left = np.flatnonzero(np.isnan(least))
        if not len(left):
            break
        position[left] = _pushed(structures, left, position[left], drive, np.full(len(left), torque))
        least[left[at_goal(structures, position[left], goal)]] = max(torque, steps[0])
    return SlowTransition(torque=least, position=position)


def crosses(structures: Ensemble, drive: Drive) -> bool:
    """Whether a drive acts on a hinge that a tendon lies across."""
    return bool((structures.crossings @ (np.array(drive.shares) @ structures.drives)).any())


def least_slow_torque(
    structures: Ensemble, start: Array, transition: Transition, most: ArrayLike, drive: Drive | None = None
) -> SlowTransition:
    """Find the least slowly growing torque that brings each structure to a transition's goal, to 1 % of it.

    A step of the torque under which it would leave its surroundings, or get to its goal, is halved. Where it leaves
    after a step of 1 % of the torque, too, it snaps: it is let go to where it rests, and the torque grows on from
    there. The first step is 1e-4 of the largest torque, and no shorter ones are tried.

    Args:
        structures: side by side.
        start: angles at rest without torques, rad, (case, hinge).
        transition: whose goal, and whose drive where none is given.
        most: size of the largest torque tried, N m, one or by case.
        drive: of the torque, whose sign it has.
    """
    goal = goal_of(structures.structure, transition.goal)
    drive = drive or drive_of(structures.structure, transition.drive)
    most = np.broadcast_to(np.asarray(most, dtype=np.float64), (len(start),))
    position, torque, step = start.copy(), np.zeros(len(start)), _FIRST_STEP * most
    least = np.where(at_goal(structures, start, goal), 0.0, np.nan)
    while True:
        left = np.flatnonzero(np.isnan(least) & (torque < most))
        if not len(left):
            return SlowTransition(torque=least, position=position)
        tried = np.minimum(torque[left] + step[left], most[left])
        found = _pushed(structures, left, position[left], drive, tried, within=_NEAR)
        leaves = np.abs(found - position[left]).max(axis=1) > 0.99 * _NEAR
        fine = step[left] <= np.maximum(_ACCURACY * tried, _FIRST_STEP * most[left])
        snaps = leaves & fine
        if snaps.any():
            found[snaps] = _pushed(structures, left[snaps], found[snaps], drive, tried[snaps])
        there = at_goal(structures, found, goal)
        kept = snaps | ~(leaves | there & ~fine)
        torque[left[kept]], position[left[kept]] = tried[kept], found[kept]
        arrived = kept & there
        least[left[arrived]] = tried[arrived]
        step[left] *= np.where(snaps, 1.0, np.where(kept, 2.0, 0.5))


def _pushed(
    structures: Ensemble,
    cases: NDArray[np.int64],
    start: Array,
    drive: Drive,
    torque: Array,
    within: float = np.inf,
) -> Array:
    """Angles at which some structures rest under a torque, no farther away than that."""
    torques = torque[:, None] * _by_unit(drive)
    return rest(structures.only(cases), start, torques, within=within).position


def _by_unit(drive: Drive) -> Array:
    """Torques of all motors by the size of a drive's, (motor,)."""
    return np.array(drive.shares) * (-1.0 if drive.strength < 0 else 1.0)
