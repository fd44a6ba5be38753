"""Slowly growing torques: the least torques that bring structures to a goal without inertia."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from forficula.arrays import Array, Flags, Indices
from forficula.errors import InputError
from forficula.statics.tree.ensemble import Ensemble, start_angles
from forficula.statics.tree.equilibrium import Equilibria
from forficula.statics.tree.hinge_landscape import CrossedHinge
from forficula.statics.tree.pose import carried_points, places_of, pose
from forficula.statics.tree.potential import hinge_angles, rest
from forficula.structure import (
    Drive,
    StageGoal,
    Structure,
    Transition,
    distances_of,
    drive_of,
    goal_coordinates,
    goal_of,
    hinge_bounds,
)

# largest torque tried on hinges that tendons cross, as a multiple of the largest opposing moment of a tendon
_MOST_OPENING = 4.0
# takes torque, N m, angles, rad, (hinge,), and whether the structure rests
Watch = Callable[[float, Array, bool], None]

_LEAD_IN = 4  # halvings of the first torque
_ACCURACY = 0.01  # relative accuracy of a least torque
FIRST_STEP = 1e-4  # first and shortest step, as a share of the largest torque tried
_SNAP_STEP = 0.05  # rad, longest step of a snap, in the space of the hinges' angles
_SEED = 30  # of random shifts
_NEAR = 0.1  # rad, largest turn of hinges from step to step without a snap
_LEFT = 0.99 * _NEAR  # turn beyond which a structure has left its neighbourhood, rad
_FAR = 0.55 * _NEAR  # turn of a step beyond which a step of twice the torque would probably leave, rad


@dataclass(frozen=True, kw_only=True)
class TorquePath:
    """Equilibria of one structure under a slowly growing torque, and the snaps between them.

    Attributes:
        torque: size, never decreasing, N m, (step,).
        position: angles, rad, (step, hinge); during a snap, which has several steps at one torque, they are not
            equilibria.
        snaps: numbers of the steps at which a snap begins and ends.
    """

    torque: Array
    position: Array
    snaps: tuple[tuple[int, int], ...]


@dataclass(frozen=True, kw_only=True)
class SlowTransition:
    """Effect of a slowly growing torque on structures.

    Attributes:
        torque: size of the least torque that brings each structure to its goal, N m, (case,); nan if none of the tried
            torques does.
        position: angles under the least torque, or under the largest one tried, rad, (case, hinge).
        paths: path to the goal, by case; empty if paths were not recorded.
        structures: with the memory of the hinges at these angles; None where it does not matter.
    """

    torque: Array
    position: Array
    paths: tuple[TorquePath, ...] = ()
    structures: Ensemble | None = None


def start_state(structures: Ensemble) -> Equilibria:
    """Find where structures rest without torques when released from the start of the protocol."""
    return rest(structures, start_angles(structures))


def state_beyond(structures: Ensemble, transition: Transition) -> Equilibria:
    """Find where structures rest without torques when released from the far end of a transition.

    Hinges that the goal bounds start at their stops on that side; hinges that the drive turns start at the stops to
    which it turns them. First the other hinges come to rest with these held, then all hinges are free.

    If springs between points, creases between flaps or closures couple the joints, not all of them can be at their
    stops. A table may keep hinges from their stops, and a force at points does not determine which stops they reach. In
    these cases the structure is released from where its full drive leads it from its first state.

    Raises:
        InputError: neither goal nor drive determines the end of the transition, or the drive is a displacement
            on coupled joints.
    """
    built = structures.structure
    goal, drive = goal_of(built, transition.goal), drive_of(built, transition.drive)
    if is_led(structures, drive):
        check_drive(built, drive)
        pushed_on = rest(structures, start_state(structures).position, np.array(drive.strengths))
        return rest(structures, pushed_on.position)
    start = np.zeros((structures.cases, structures.size))
    pushed = _by_unit(drive) @ structures.drives
    least, most = (bounds[: structures.size] for bounds in hinge_bounds(built, goal))
    ends = np.full(structures.size, np.nan)
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
            f"{built.name}: the end of {transition.name} is undetermined: need a goal that bounds hinges, or a drive of"
            " hinges with stops"
        )
    start[:, placed] = ends[placed]
    closed = rest(structures, start, fixed=placed.tolist())
    return rest(structures, closed.position)


def is_led(structures: Ensemble, drive: Drive) -> bool:
    """Return whether a structure rests where a drive leads it, and not at the stops to which the drive turns hinges."""
    return structures.coupled or structures.planes is not None or "force" in drive_kinds(structures.structure, drive)


def state_after(structures: Ensemble, transition: Transition, torque: Array, position: Array) -> Equilibria:
    """Find where structures rest without torques after a slowly growing torque: the start of the next transition.

    Structures are released from where the torque brought them. Structures that missed the goal, or that leave the state
    when released, are released from the stops instead, see `state_beyond`. With a slack tendon, hinges can rest
    anywhere in a range, and the next torque can lead along another path from either end of the range.

    If springs between points, creases between flaps or closures couple the joints, if hinges have a memory, if a table
    is under the structure, or if the drive is a force, structures are always released from where the drive brought
    them.

    Args:
        structures: side by side.
        transition: with the state.
        torque: least torque that makes it, N m, (case,); nan if none does.
        position: angles under this torque, rad, (case, hinge).
    """
    led = rest(structures, position)
    if structures.memory is not None or is_led(structures, drive_of(structures.structure, transition.drive)):
        return led
    stays = np.isfinite(torque) & at_goal(structures, led.position, goal_of(structures.structure, transition.released))
    if stays.all():
        return led
    beyond = state_beyond(structures, transition)
    return Equilibria(
        position=np.where(stays[:, None], led.position, beyond.position),
        energy=np.where(stays, led.energy, beyond.energy),
        slope=np.where(stays[:, None], led.slope, beyond.slope),
        stiffness=np.where(stays, led.stiffness, beyond.stiffness),
        rests=np.where(stays, led.rests, beyond.rests),
    )


def at_goal(structures: Ensemble, position: Array, goal: StageGoal) -> Flags:
    """Return whether every hinge and distance is within a goal's bounds, (case,)."""
    built = structures.structure
    read = goal_coordinates(built, hinge_angles(structures, position), _distances(built, structures, position))
    return np.asarray(np.all((read >= goal.least) & (read <= goal.most), axis=1))


def _distances(structure: Structure, structures: Ensemble, position: Array) -> Array:
    """Return the measured distances, m, (case, distance)."""
    ends = [measure.points for measure in distances_of(structure) if measure.points is not None]
    if not ends:
        return np.zeros((len(position), 0))
    tree, points = structures.sheet.laid.tree, [structure.points[number] for pair in ends for number in pair]
    carried = carried_points(tree, [point.body for point in points], np.array([point.place for point in points]))
    places = places_of(carried, pose(tree, position))
    return np.asarray(np.linalg.norm(places[:, :, 1::2] - places[:, :, ::2], axis=0))


def check_drive(structure: Structure, drive: Drive) -> None:
    """Check that a drive sets no displacement of points.

    Raises:
        InputError: the drive is a displacement.
    """
    if "displacement" in drive_kinds(structure, drive):
        raise InputError(
            f"{structure.name}: need a drive of torques, forces or rest angles, because the statics of bodies on joints"
            f' in a tree cannot follow another one, got the displacement "{drive.name}"; a run can follow it'
        )


def drive_kinds(structure: Structure, drive: Drive) -> set[str]:
    """Return the kinds of the motors that a drive sets."""
    return {motor.kind for motor, share in zip(structure.motors, drive.shares, strict=True) if share}


def withstood_torques(
    structures: Ensemble, start: Array, transition: Transition, most: float, kicks: ArrayLike
) -> Array:
    """Return the size of a slowly growing drive at which structures leave the goal that they are at; inf for none.

    Args:
        structures: side by side.
        start: angles at rest, rad, (case, hinge), at the transition's goal.
        transition: with its drive and goal.
        most: size of the largest drive tried, in its SI unit.
        kicks: as for `least_slow_torque`.
    """
    built = structures.structure
    goal, drive = goal_of(built, transition.goal), drive_of(built, transition.drive)
    slow = least_slow_torque(structures, start, None, most, drive, recorded=True, kicks=kicks)
    sizes = list[float]()
    for path in slow.paths:
        left = ~at_goal(structures, path.position, goal)
        for first, last in path.snaps:
            left[first + 1 : last] = False
        sizes.append(float(path.torque[left.argmax()]) if left.any() else np.inf)
    return np.array(sizes)


def slow_transition(structures: Ensemble, start: Array, transition: Transition, torques: ArrayLike) -> SlowTransition:
    """Increase a transition's torque in steps, let the structures rest at each step, and find when they reach the goal.

    A torque that is applied at once may lead to another state than a growing one, because it selects which weakly held
    hinges turn. If it acts on hinges that no tendon crosses, smaller torques are therefore applied before the first.

    Args:
        structures: side by side.
        start: angles at rest without torques, rad, (case, hinge).
        transition: with its drive and goal.
        torques: rising sizes, N m, (step,); the sign is that of the drive.
    """
    goal, drive = goal_of(structures.structure, transition.goal), drive_of(structures.structure, transition.drive)
    check_drive(structures.structure, drive)
    position, least = start.copy(), np.full(len(start), np.nan)
    steps = np.asarray(torques, dtype=np.float64)
    before = [] if crosses(structures, drive) else steps[0] / 2.0 ** np.arange(_LEAD_IN, 0, -1)
    for torque in [*before, *steps]:
        left = np.flatnonzero(np.isnan(least))
        if not len(left):
            break
        position[left] = _pushed_rest(structures, left, position[left], drive, np.full(len(left), torque))
        least[left[at_goal(structures, position[left], goal)]] = max(torque, steps[0])
    return SlowTransition(torque=least, position=position)


def crosses(structures: Ensemble, drive: Drive) -> bool:
    """Return whether a drive acts on a hinge that a tendon lies across."""
    return bool((structures.crossings @ (np.array(drive.shares) @ structures.drives)).any())


def largest_torque(structures: Ensemble, transition: Transition, hinges: Sequence[CrossedHinge]) -> float:
    """Return the largest torque tried for a transition, N m: the drive's, or more if tendons cross its hinges.

    Args:
        structures: side by side.
        transition: with its drive.
        hinges: every hinge that one tendon lies across.
    """
    drive = drive_of(structures.structure, transition.drive)
    strength = abs(drive.strength)
    if not crosses(structures, drive):
        return strength
    peaks = [hinge.actual.peak_opening.torque for hinge in hinges if hinge.actual.peak_opening is not None]
    return max(_MOST_OPENING * max(peaks, default=0.0), strength)


def least_slow_torque(
    structures: Ensemble,
    start: Array,
    transition: Transition | None,
    most: ArrayLike,
    drive: Drive | None = None,
    *,
    begin: float = 0.0,
    recorded: bool = False,
    kicks: ArrayLike = 0.0,
    watch: Watch = lambda _torque, _position, _resting: None,
    stop: Callable[[], bool] = lambda: False,
) -> SlowTransition:
    """Find the least slowly growing torque that brings each structure to a transition's goal, to 1 %.

    The torque is the largest limit torque along the path of stable equilibria from the start to the goal. A structure
    leaves its neighbourhood if a hinge turns by 0.1 rad on the way to rest. A step of the torque is halved if the
    structure would leave or reach its goal, and doubled if the hinges turn less than half as far. If it leaves after a
    step of 1 % of the torque as well, the equilibrium has become unstable and the structure snaps: it follows the
    steepest descent of the energy, like a motion with equal dampers and without inertia, to the next equilibrium, from
    which the torque grows further. The first step is 1e-4 of the largest torque, and no shorter steps are tried.
    Hinges with memory turn in one sense during each step, and during each snap.

    Args:
        structures: side by side.
        start: angles at rest under the first torque, rad, (case, hinge).
        transition: with its goal, and its drive if none is given; None for a drive without a goal.
        most: size of the largest torque tried, N m, one or by case.
        drive: of the torque, with its sign; needed without a transition.
        begin: size of the first torque, N m.
        recorded: whether to keep the paths.
        kicks: standard deviation of random shifts of hinges at the start of a snap, rad, one or by case. If paths
            separate because of them, the torque depends on small differences.
        watch: called with every step of recorded paths: torque, angles, (hinge,), and whether the structure rests.
        stop: ends the paths if it returns True.

    Raises:
        InputError: the drive is a displacement.
    """
    goal = None if transition is None else goal_of(structures.structure, transition.goal)

    def arrives(angles: Array) -> Flags:
        return np.zeros(len(angles), dtype=np.bool_) if goal is None else at_goal(structures, angles, goal)

    record, random = _PathRecord(start, begin, watch) if recorded else None, np.random.default_rng(_SEED)
    kicks = np.broadcast_to(np.asarray(kicks, dtype=np.float64), (len(start),))
    if drive is None:
        assert transition is not None
        drive = drive_of(structures.structure, transition.drive)
    check_drive(structures.structure, drive)
    most = np.broadcast_to(np.asarray(most, dtype=np.float64), (len(start),))
    position, torque, step = start.copy(), np.full(len(start), begin), FIRST_STEP * most
    least = np.where(arrives(start), begin, np.nan)
    while True:
        left = np.flatnonzero(np.isnan(least) & (torque < most))
        if not len(left) or stop():
            paths = () if record is None else record.paths()
            return SlowTransition(torque=least, position=position, paths=paths, structures=structures)
        tried = np.minimum(torque[left] + step[left], most[left])
        result = _pushed_rest(structures, left, position[left], drive, tried, within=_NEAR)
        turned = _turned(result, position[left])
        leaves = turned > _LEFT
        fine = step[left] <= np.maximum(_ACCURACY * tried, FIRST_STEP * most[left])
        snaps = leaves & fine
        if snaps.any():
            snapping = left[snaps]
            begins = position[snapping]
            if kicks.any():
                shift = random.standard_normal(start.shape)[snapping] * kicks[snapping, None]
                begins = np.clip(begins + shift, structures.lower, structures.upper)
            for case, snap_torque, path in _snapped(structures, snapping, begins, drive, tried[snaps], watch):
                result[left == case] = path[-1]
                if record is not None:
                    record.add_snap(case, snap_torque, path)
        reached = arrives(result)
        kept = snaps | ~(leaves | reached & ~fine)
        torque[left[kept]], position[left[kept]] = tried[kept], result[kept]
        structures = structures.turned(position)
        if record is not None:
            for row in np.flatnonzero(kept & ~snaps).tolist():
                record.add(int(left[row]), tried[row], result[row])
        arrived = kept & reached
        least[left[arrived]] = tried[arrived]
        step[left] *= np.where(snaps | kept & (turned > _FAR), 1.0, np.where(kept, 2.0, 0.5))


class _PathRecord:
    """Paths of structures while they are followed."""

    def __init__(self, start: Array, torque: float, watch: Watch) -> None:
        self._steps: list[list[tuple[float, Array]]] = [[(torque, position.copy())] for position in start]
        self._snaps: list[list[tuple[int, int]]] = [[] for _ in start]
        self._watch = watch
        for position in start:
            watch(torque, position.copy(), True)

    def add(self, case: int, torque: float, position: Array) -> None:
        self._steps[case].append((float(torque), position.copy()))
        self._watch(float(torque), position.copy(), True)

    def add_snap(self, case: int, torque: float, positions: Sequence[Array]) -> None:
        before = len(self._steps[case]) - 1
        self._steps[case] += [(float(torque), position.copy()) for position in positions]
        self._watch(float(torque), positions[-1].copy(), True)
        self._snaps[case].append((before, len(self._steps[case]) - 1))

    def paths(self) -> tuple[TorquePath, ...]:
        return tuple(
            TorquePath(
                torque=np.array([torque for torque, _ in steps]),
                position=np.array([position for _, position in steps]),
                snaps=tuple(snaps),
            )
            for steps, snaps in zip(self._steps, self._snaps, strict=True)
        )


def _snapped(
    structures: Ensemble, cases: Indices, start: Array, drive: Drive, torque: Array, watch: Watch
) -> list[tuple[int, float, list[Array]]]:
    """Return number, torque and path to rest, rad, (hinge,) each, of structures that snap under a torque.

    Steps within a ball, not a box, are those of implicit Euler down the slope. The shorter they are, the closer the
    path is to the steepest descent; longer steps can end elsewhere.
    """
    paths: list[list[Array]] = [[] for _ in cases]

    def follow(moving: Indices, position: Array) -> None:
        for row in moving.tolist():
            paths[row].append(position[row].copy())
            watch(float(torque[row]), paths[row][-1], False)

    torques = torque[:, None] * _by_unit(drive)
    ends = rest(structures.only(cases), start, torques, longest_step=_SNAP_STEP, follow=follow).position
    return [
        (int(case), float(size), [*path, end]) for case, size, path, end in zip(cases, torque, paths, ends, strict=True)
    ]


def _pushed_rest(
    structures: Ensemble,
    cases: Indices,
    start: Array,
    drive: Drive,
    torque: Array,
    within: float | None = None,
) -> Array:
    """Return the angles at which some structures rest under a torque, within a largest turn of each hinge."""

    def left(angles: Array, rows: Indices) -> Flags:
        return np.asarray(_turned(angles, start[rows]) > _LEFT)

    torques = torque[:, None] * _by_unit(drive)
    enough = None if within is None else left
    limit = np.inf if within is None else within
    return rest(structures.only(cases), start, torques, within=limit, enough=enough).position


def _turned(angles: Array, start: Array) -> Array:
    """Return the largest turn of a hinge from where it started, rad, (case,)."""
    return np.asarray(np.abs(angles - start).max(axis=1))


def _by_unit(drive: Drive) -> Array:
    """Return the torques of all motors per size of a drive, (motor,)."""
    return np.array(drive.shares) * (-1.0 if drive.strength < 0 else 1.0)
