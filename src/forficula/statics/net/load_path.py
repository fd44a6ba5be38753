"""The path of equilibria of a net under a growing load, through snap-through and snap-back."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal, NamedTuple

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.statics.net.contact.contact_energy import passes_through
from forficula.statics.net.energy import Expansion, expand, expand_at, kept_folds, load_slope, moved_shape
from forficula.statics.net.factor import Factorisation, factored, softest
from forficula.statics.net.load import Load, check_load
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.supports import supported

_CORRECTIONS = 12
_QUICK = 4  # corrections after which the next increment may be longer
_HOME = 1e-7  # last correction, as a share of the increment
_ASTRAY = 0.5  # longest deviation from the tangent, as a share of the increment
_BENT = 0.1  # largest difference of the mean rate of the factor from that of its ends, as a share of the larger one
_SHORTEST = 1e-5  # shortest increment, as a share of the first one
_CORNER = 1e-2  # increment, as a share of the first one, below which a corner is searched for
_ALIGNED = 0.9  # cosine of the tangents before and after a corner
_HALVINGS = 16  # of an increment, to locate an event
_ITERATIONS = 3  # of a vector towards the softest mode
_SAME = 1e-3  # as a share of the increment: two events at this distance are one


@dataclass(frozen=True, kw_only=True, eq=False)
class PathPoint:
    """An equilibrium on a path.

    Attributes:
        shape: shape of the net.
        factor: load factor.
        energy: stored, J.
        index: number of directions in which the energy falls at a constant factor; 0 for a stable equilibrium.
        rising: whether the factor rises along the path.
        corrections: number of corrections of Newton's method.
    """

    shape: NetShape
    factor: float
    energy: float
    index: int
    rising: bool
    corrections: int


@dataclass(frozen=True, kw_only=True, eq=False)
class PathEvent:
    """Point of a path at which the index changes or the load factor has an extremum.

    Attributes:
        kind: "limit", an extremum of the load, from which the net snaps; "bifurcation", where another path crosses.
        after: number of the point before the event.
        point: the equilibrium at the event.
        mode: direction in which stiffness is lost, the largest coordinate 1, (node, 3); at a bifurcation, the direction
            of the other path.
    """

    kind: Literal["limit", "bifurcation"]
    after: int
    point: PathPoint
    mode: Array


@dataclass(frozen=True, kw_only=True, eq=False)
class LoadPath:
    """Equilibria under a load, in the order of the path.

    Attributes:
        load: at a factor of 1.
        points: of the path, including its start.
        events: limits and bifurcations, in order.
        ended: "target", "count" or "stop"; "stuck" if even the shortest increment did not converge.
        pins: coordinates, pairs of node and axis, held to remove rigid-body motions.
    """

    load: Load
    points: tuple[PathPoint, ...]
    events: tuple[PathEvent, ...]
    ended: Literal["target", "count", "stop", "stuck"]
    pins: tuple[tuple[int, int], ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class _PathPoint:
    """A point with the data for the next increment: factorisation, and unit tangent of the path, (node, 3)."""

    point: PathPoint
    parts: Factorisation
    direction: Array
    pace: float  # change of the factor per length along the path


def load_path(
    net: Net,
    start: NetShape,
    load: Load,
    *,
    step: float | None = None,
    increments: int = 100,
    factor: float = 0.0,
    target: float | None = None,
    stop: Callable[[PathPoint], bool] | None = None,
    events: int | None = None,
    locate_events: bool = True,
    rising: bool = True,
    direction: Array | None = None,
    watch: Callable[[PathPoint], None] = lambda _: None,
    overlaps: bool = False,
) -> LoadPath:
    """Follow equilibria by modified generalised displacement control.

    Every increment moves a given length along the tangent, in the direction of the increment before it, and is
    corrected in the plane normal to that tangent (Leon, Lages, de Araujo and Paulino 2014, Mech. Res. Commun. 56,
    123-129; here the length of the predictor, not its factor, is kept, and halved if Newton's method does not
    converge). The index of every point follows from the factorisation of its Hessian.

    Args:
        net: need not be supported if the load moves no rigid body; see `supported`.
        start: an equilibrium at `factor`, or near one.
        load: forces, torques and displacements that act together.
        step: largest displacement of a coordinate in the first increment, m; None for 1/50 of the net's size.
        increments: largest number of increments.
        factor: at the start.
        target: factor that ends the path; the last point is exactly at it. If it is the factor of the start, the path
            ends when it returns to this factor.
        stop: ends the path after the first point for which it returns True.
        events: ends the path after this number of limits and bifurcations; None for any number.
        locate_events: whether to locate limits and bifurcations, which may take longer than the path itself.
        rising: whether the factor rises at first.
        direction: in which the path leaves its start, (node, 3). The mode of a bifurcation, or its opposite, leads
            onto the other path. None for the direction given by the load.
        watch: called with every point before the first event.
        overlaps: whether contact is a stiff spring along the path: its multipliers remain those of the start, and parts
            that touch overlap slightly. Without this, a net with contact is refused.

    Raises:
        InputError: the load does not fit, is zero or would move the net as a rigid body; there is no equilibrium near
            the start; or the net has contact.
    """
    check_load(net, load)
    if net.contact is not None and not overlaps:
        raise InputError("net.contact: need None for a path through unstable equilibria, got a net with contact")
    if not any(np.any(part) for part in (load.forces, load.torques, load.displacements)):
        raise InputError("load: need one that acts, got none")
    net, pins = supported(net, load)
    first = expand(net, start, load, factor) if direction is not None else _settled(net, load, start, factor)
    if first is None:
        raise InputError("start: need a shape at rest under the load at its start, got one that is not")
    current = _station(net, load, first, factor, None, rising, 0)
    if direction is not None:
        current = replace(current, direction=direction / np.linalg.norm(direction), pace=0.0)
    length = (net.size / 50 if step is None else step) / np.abs(current.direction).max()
    longest, points, result = length, [current.point], list[PathEvent]()
    watch(current.point)
    ended: Literal["target", "count", "stop", "stuck"] = "count"
    while len(points) <= increments:
        following = _increment(net, load, current, length)
        if following is None and length <= _CORNER * longest:
            current, following = _pass_kink(net, load, current, length)
        if following is None:
            length /= 2
            if length < _SHORTEST * longest:
                ended = "stuck"
                break
            continue
        branching = direction is not None and len(points) == 1  # the start itself is the bifurcation
        if not branching and length > _CORNER * longest and _bent(current, following, length):
            length /= 2
            continue
        new = list[PathEvent]()
        if locate_events and not branching:
            new = _events_between(net, load, current, following, length, len(points) - 1)
        passed = target is not None and _crosses(current.point.factor, following.point.factor, target)
        if target is not None and passed:
            following = _point_at_factor(net, load, current, following, length, target)
            new = [event for event in new if (event.point.factor - target) * (current.point.factor - target) > 0]
        result += new
        points.append(following.point)
        if not result:
            watch(following.point)
        if passed or (stop is not None and stop(following.point)) or (events is not None and len(result) >= events):
            ended = "target" if passed else "stop"
            break
        current = following
        length = min(2 * length, longest) if following.point.corrections <= _QUICK else length
    return LoadPath(load=load, points=tuple(points), events=tuple(result), ended=ended, pins=pins)


def _bent(current: _PathPoint, following: _PathPoint, length: float) -> bool:
    """Return whether the load factor varied within an increment more than its rates at both ends explain.

    This detects a load that falls and rises again within an increment. On the cubic through both ends with both rates,
    the mean rate differs from the mean of the end rates by an amount that decreases with the square of the increment.
    If the load falls from a limit and rises beyond it again like the cube of the length, the difference is at least a
    sixth of the larger rate.
    """
    mean = (following.point.factor - current.point.factor) / length
    return abs(mean - (current.pace + following.pace) / 2) > _BENT * max(abs(current.pace), abs(following.pace))


def _crosses(before: float, after: float, target: float) -> bool:
    return after == target or (before - target) * (after - target) < 0


def _settled(net: Net, load: Load, start: NetShape, factor: float) -> Expansion | None:
    """Find the equilibrium near a shape at a constant factor; None if there is none."""
    current = expand(net, start, load, factor)
    for _ in range(30):
        step = np.zeros_like(net.nodes)
        step[net.free] = factored(current.free).solve(-current.slope[net.free])
        moved = np.abs(step).max(initial=0.0)
        if not moved <= 0.1 * net.size:
            break
        current = _moved(net, current.shape, step, load, factor)
        if moved <= _HOME * net.size / 100:
            return current
    return None


def _moved(net: Net, shape: NetShape, step: Array, load: Load, factor: float) -> Expansion:
    return expand_at(net, shape.positions + step, shape, load, factor)


def _tangent(net: Net, load: Load, current: Expansion, parts: Factorisation) -> Array:
    """Return the derivative of displacements by the load factor, m, (node, 3)."""
    push = load_slope(net, current.shape, load, current.turning)
    if np.any(load.displacements):
        push = push - (current.curvature @ load.displacements.ravel()).reshape(-1, 3)
    tangent = load.displacements.copy()
    tangent[net.free] += parts.solve(push[net.free])
    return tangent


def _station(
    net: Net, load: Load, current: Expansion, factor: float, before: Array | None, rising: bool, corrections: int
) -> _PathPoint:
    """Return an equilibrium with its tangent, oriented like the tangent before it."""
    parts = factored(current.free)
    tangent = _tangent(net, load, current, parts)
    length = float(np.linalg.norm(tangent))
    if not (np.isfinite(length) and length):
        raise InputError("load: need one that moves the net, got one that does not")
    forwards = rising if before is None else float(np.sum(before * tangent)) > 0
    pace = (1.0 if forwards else -1.0) / length
    point = PathPoint(
        shape=kept_folds(net, current.shape),
        factor=factor,
        energy=current.stored,
        index=parts.index,
        rising=forwards,
        corrections=corrections,
    )
    return _PathPoint(point=point, parts=parts, direction=pace * tangent, pace=pace)


def _increment(net: Net, load: Load, current: _PathPoint, length: float) -> _PathPoint | None:
    """Find the next point of the path at about the given length; None if Newton's method does not converge."""
    factor = current.point.factor + length * current.pace
    guess = _moved(net, current.point.shape, length * current.direction, load, factor)
    corrected = _corrected(net, load, guess, factor, current.direction, length)
    if corrected is None:
        return None
    following, factor, corrections = corrected
    if passes_through(net, current.point.shape.positions, following.shape.positions):
        return None
    return _station(net, load, following, factor, current.direction, True, corrections)


def _corrected(
    net: Net, load: Load, guess: Expansion, factor: float, direction: Array, length: float
) -> tuple[Expansion, float, int] | None:
    """Find the equilibrium in the plane through a guess that is normal to a direction.

    Returns:
        The equilibrium, its load factor and the number of corrections; None if Newton's method does not converge, or
        leaves the neighbourhood of the guess.
    """
    following = guess
    aside = np.zeros_like(net.nodes)
    for corrections in range(_CORRECTIONS):
        if not np.all(np.isfinite(following.slope)):
            return None
        parts = factored(following.free)
        step = np.zeros_like(net.nodes)
        step[net.free] = parts.solve(-following.slope[net.free])
        tangent = _tangent(net, load, following, parts)
        change = -float(np.sum(direction * step)) / (float(np.sum(direction * tangent)) or np.nan)
        step = step + change * tangent
        aside, moved = aside + step, float(np.linalg.norm(step))
        if not np.linalg.norm(aside) <= _ASTRAY * length:
            return None
        factor += change
        following = _moved(net, following.shape, step, load, factor)
        if moved <= _HOME * length:
            # the energy is infinite beyond the contact of locking panels, where no path leads
            return (following, factor, corrections) if np.isfinite(following.stored) else None
    return None


def intermediate_point(
    net: Net, load: Load, before: PathPoint, after: PathPoint, positions: Array, factor: float
) -> PathPoint | None:
    """Find the equilibrium between two points of a path near a guess; None if Newton's method does not converge.

    Args:
        net: as for `load_path`.
        load: at a factor of 1.
        before: point of a path.
        after: next point of the path.
        positions: guess, between both points, m, (node, 3).
        factor: guess of the load factor.
    """
    net, _ = supported(net, load)
    chord = after.shape.positions - before.shape.positions
    length = float(np.linalg.norm(chord))
    guess = expand_at(net, positions, before.shape, load, factor)
    corrected = _corrected(net, load, guess, factor, chord / length, length)
    if corrected is None:
        return None
    expansion, factor, corrections = corrected
    return PathPoint(
        shape=kept_folds(net, expansion.shape),
        factor=factor,
        energy=expansion.stored,
        index=before.index,
        rising=before.rising,
        corrections=corrections,
    )


def _pass_kink(net: Net, load: Load, current: _PathPoint, length: float) -> tuple[_PathPoint, _PathPoint | None]:
    """Pass a kink of a law, such as a tendon that goes slack, at which the tangent turns abruptly."""
    factor = current.point.factor + length * current.pace
    over = _moved(net, current.point.shape, length * current.direction, load, factor)
    tangent = _tangent(net, load, over, factored(over.free))
    for pace in (1 / np.linalg.norm(tangent), -1 / np.linalg.norm(tangent)):
        turned = replace(current, direction=pace * tangent, pace=float(pace))
        following = _increment(net, load, turned, length)
        # the opposite orientation would lead back, or to no equilibrium
        if following is not None and np.sum(following.direction * turned.direction) > _ALIGNED:
            return turned, following
    return current, None


def _events_between(
    net: Net, load: Load, current: _PathPoint, following: _PathPoint, length: float, after: int
) -> list[PathEvent]:
    """Return the events within an increment, in order."""
    brackets = list[_Bracket]()
    limit, indices = following.point.rising != current.point.rising, (current.point.index, following.point.index)
    if limit:
        brackets.append(
            _bracket(
                net,
                load,
                (current, following),
                length,
                passed=lambda station: station.point.rising != current.point.rising,
                measure=lambda station: station.pace,
            )
        )
    # at a limit the index changes as well
    if indices[0] != indices[1] and not any(bracket.indices == indices for bracket in brackets):
        mode = _softest_mode(net, following)
        bracket = _bracket(
            net,
            load,
            (current, following),
            length,
            passed=lambda station: station.point.index != indices[0],
            measure=lambda station: 1 / float(mode @ station.parts.solve(mode)),
        )
        if not any(abs(bracket.place - other.place) <= _SAME * length for other in brackets):
            brackets.append(bracket)
    events = list[tuple[float, PathEvent]]()
    for number, bracket in enumerate(brackets):
        # an increment may not converge exactly where stiffness is lost, but one just short of it does
        point = (bracket.after or (following if bracket.before is current else bracket.before)).point
        mode = np.zeros_like(net.nodes)
        mode[net.free] = softest(expand(net, point.shape, load, point.factor).free, 1)[1][:, 0]
        events.append(
            (
                bracket.place,
                PathEvent(
                    kind="limit" if limit and number == 0 else "bifurcation",
                    after=after,
                    point=point,
                    mode=mode / mode.flat[np.argmax(np.abs(mode))],
                ),
            )
        )
    return [event for _, event in sorted(events, key=lambda entry: entry[0])]


def _softest_mode(net: Net, station: _PathPoint) -> Array:
    """Return about the direction of free coordinates that is the softest at a point, by inverse iteration."""
    mode = np.random.default_rng(0).standard_normal(np.count_nonzero(net.free))
    for _ in range(_ITERATIONS):
        mode = station.parts.solve(mode)
        mode = mode / np.linalg.norm(mode)
    return mode


class _Bracket(NamedTuple):
    """Short part of an increment that contains an event.

    Attributes:
        before: point just before the event.
        after: point just after the event; None if no increment converges there.
        place: length at which the event has passed.
    """

    before: _PathPoint
    after: _PathPoint | None
    place: float

    @property
    def indices(self) -> tuple[int, int] | None:
        """Return the indices before and after the event; None if no increment converges after the event."""
        return None if self.after is None else (self.before.point.index, self.after.point.index)


def _bracket(
    net: Net,
    load: Load,
    ends: tuple[_PathPoint, _PathPoint],
    length: float,
    *,
    passed: Callable[[_PathPoint], bool],
    measure: Callable[[_PathPoint], float],
) -> _Bracket:
    """Locate an event within an increment, on a grid of 2^`_HALVINGS` equal parts.

    The method is regula falsi with halved weights (Dowell and Jarratt 1971, doi 10.1007/BF01934364). Every third step
    halves the bracket, which converges for any function. If an increment does not converge, halving starts again.

    Args:
        net: supported.
        load: at a factor of 1.
        ends: points before and after the increment.
        length: of the increment.
        passed: whether a point is beyond the event.
        measure: number whose sign changes at the event without a jump.
    """
    whole = 2**_HALVINGS
    stations: dict[int, _PathPoint | None] = {0: ends[0], whole: ends[1]}
    low, high, last, number, interpolates = 0, whole, 0, 0, True
    below, above = abs(measure(ends[0])), abs(measure(ends[1]))
    while high - low > 1:
        middle = (low + high) // 2
        if interpolates and number % 3 < 2 and 0 < below + above < np.inf:
            zero = low + (high - low) * below / (below + above)
            # rounded away from the nearer end, so that both ends approach the zero
            zero = math.ceil(zero) if zero < middle else math.floor(zero)
            middle = min(max(zero, low + 1), high - 1)
        number += 1
        if middle not in stations:
            stations[middle] = _increment(net, load, ends[0], length * middle / whole)
        station = stations[middle]
        if station is None and interpolates:
            low, high, interpolates = 0, whole, False
        elif station is None or passed(station):
            below = below / 2 if last > 0 else below
            high, last, above = middle, 1, math.inf if station is None else abs(measure(station))
        else:
            above = above / 2 if last < 0 else above
            low, last, below = middle, -1, abs(measure(station))
    before = stations[low]
    assert before is not None
    return _Bracket(before=before, after=stations[high], place=length * high / whole)


def _point_at_factor(
    net: Net, load: Load, current: _PathPoint, following: _PathPoint, length: float, factor: float
) -> _PathPoint:
    """Find the point between two others at a given factor."""
    low, high, begin = 0.0, length, current
    for _ in range(_HALVINGS):
        share = (factor - begin.point.factor) / (following.point.factor - begin.point.factor)
        positions = begin.point.shape.positions * (1 - share) + following.point.shape.positions * share
        last = _settled(net, load, moved_shape(net, begin.point.shape, positions), factor)
        if last is not None and np.linalg.norm(last.shape.positions - positions) <= high - low:
            return _station(net, load, last, factor, current.direction, True, 0)
        middle = _increment(net, load, current, (low + high) / 2)
        if middle is None or (middle.point.factor - factor) * (current.point.factor - factor) <= 0:
            high, following = (low + high) / 2, middle or following
        else:
            low, begin = (low + high) / 2, middle
    return following
