"""The path of equilibria of a net under a growing load, through snap-through and snap-back."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.statics.net.energy import Expansion, expand, load_slope, shape_at
from forficula.statics.net.factor import Factorisation, factored, softest
from forficula.statics.net.load import Load, check_load
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.supports import supported

_CORRECTIONS = 12
_QUICK = 4  # corrections after which the next increment may be longer
_HOME = 1e-7  # last correction, of an increment
_ASTRAY = 0.5  # longest way aside, of an increment
_BENT = 0.1  # largest difference of a factor's mean pace from that of its ends, of the larger of these
_SHORTEST = 1e-5  # increment, of the first one
_CORNER = 1e-2  # increment, of the first one, below which a corner is looked for
_ALIGNED = 0.9  # cosine of the ways before and after it
_HALVINGS = 16  # of an increment, to find where something happens
_SAME = 1e-3  # of an increment: two things so near are one


@dataclass(frozen=True, kw_only=True, eq=False)
class PathPoint:
    """An equilibrium on a path.

    Attributes:
        shape: there.
        factor: times which the load acts.
        energy: stored, J.
        index: how many ways lead downhill at a constant factor: 0 where the load could rest on it.
        rising: whether the factor rises along the path.
        corrections: of Newton's method.
    """

    shape: NetShape
    factor: float
    energy: float
    index: int
    rising: bool
    corrections: int


@dataclass(frozen=True, kw_only=True, eq=False)
class PathEvent:
    """Where the number of ways downhill changes on a path, or the load turns.

    Attributes:
        kind: "limit", an extremum of the load, from which it snaps; "bifurcation", where another path crosses.
        after: number of the point before it.
        point: the equilibrium there.
        mode: the way in which stiffness is lost, the largest coordinate 1, (node, 3); from a bifurcation that way leads
            the other path.
    """

    kind: Literal["limit", "bifurcation"]
    after: int
    point: PathPoint
    mode: Array


@dataclass(frozen=True, kw_only=True, eq=False)
class LoadPath:
    """Equilibria under a load, in the order of the path.

    Attributes:
        load: times the factors of the points.
        points: of the path, its start among them.
        events: limits and bifurcations, in order.
        ended: "target", "count", "stop"; "stuck" where no shorter increment converged.
        pins: coordinates, pairs of node and axis, held to take away motions of the whole.
    """

    load: Load
    points: tuple[PathPoint, ...]
    events: tuple[PathEvent, ...]
    ended: Literal["target", "count", "stop", "stuck"]
    pins: tuple[tuple[int, int], ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class _Station:
    """A point with what the next increment needs: factors, and the way the path goes, of length 1, (node, 3)."""

    point: PathPoint
    parts: Factorisation
    way: Array
    pace: float  # change of the factor by length along the path


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
    rising: bool = True,
    way: Array | None = None,
) -> LoadPath:
    """Follow equilibria by modified generalised displacement control.

    Every increment goes a given length along the tangent, forwards as the increment before it went, and is corrected
    in the plane across that tangent (Leon, Lages, de Araujo and Paulino 2014, Mech. Res. Commun. 56, 123-129;
    here the length of the predictor, not its factor, is kept, and halved where Newton's method does not converge). The
    inertia of every point is that of the factors of its curvature.

    Args:
        net: not held as a whole where nothing acts on that; see `supported`.
        start: an equilibrium at `factor`, or near one.
        load: forces, torques and displacements that act together.
        step: largest displacement of a coordinate in the first increment, m; None for 1/50 of the net's size.
        increments: largest number of them.
        factor: at the start.
        target: ends the path where the factor passes it; the last point is exactly there. It may be that of the start,
            to which the path then comes back.
        stop: ends the path after the first point for which it says so.
        events: ends the path after so many limits and bifurcations; None for any number.
        rising: whether the factor rises at first.
        way: in which the path leaves its start, (node, 3): the mode of a bifurcation, or its opposite, leads from the
            point there onto the other path. None for the way of the load.

    Raises:
        InputError: the load does not fit or is none, or would carry the whole away; no equilibrium near the start.
    """
    check_load(net, load)
    if not any(np.any(each) for each in (load.forces, load.torques, load.displacements)):
        raise InputError("load: need one that acts, got none")
    net, pins = supported(net, load)
    first = expand(net, start, load, factor) if way is not None else _settled(net, load, start, factor)
    if first is None:
        raise InputError("start: need a shape at rest under the load at its start, got one that is not")
    here = _station(net, load, first, factor, None, rising, 0)
    if way is not None:
        here = replace(here, way=way / np.linalg.norm(way), pace=0.0)
    length = (net.size / 50 if step is None else step) / np.abs(here.way).max()
    longest, points, found = length, [here.point], list[PathEvent]()
    ended: Literal["target", "count", "stop", "stuck"] = "count"
    while len(points) <= increments:
        there = _increment(net, load, here, length)
        if there is None and length <= _CORNER * longest:
            here, there = _around_corner(net, load, here, length)
        if there is None:
            length /= 2
            if length < _SHORTEST * longest:
                ended = "stuck"
                break
            continue
        branching = way is not None and len(points) == 1  # where the start is what happens
        if not branching and length > _CORNER * longest and _bent(here, there, length):
            length /= 2
            continue
        new = [] if branching else _events_between(net, load, here, there, length, len(points) - 1)
        passed = target is not None and _passes(here.point.factor, there.point.factor, target)
        if target is not None and passed:
            there = _at(net, load, here, there, length, target)
            new = [event for event in new if (event.point.factor - target) * (here.point.factor - target) > 0]
        found += new
        points.append(there.point)
        if passed or (stop is not None and stop(there.point)) or (events is not None and len(found) >= events):
            ended = "target" if passed else "stop"
            break
        here = there
        length = min(2 * length, longest) if there.point.corrections <= _QUICK else length
    return LoadPath(load=load, points=tuple(points), events=tuple(found), ended=ended, pins=pins)


def _bent(here: _Station, there: _Station, length: float) -> bool:
    """Whether the load did more within an increment than its paces at both ends tell, such as fall and rise again.

    On the cubic that goes through both ends with both paces, the mean pace is that of the ends but for a difference
    which falls with the square of the increment; where the load falls from a limit and has risen beyond it again as
    the cube of the way, that is a sixth of the larger pace at least.
    """
    mean = (there.point.factor - here.point.factor) / length
    return abs(mean - (here.pace + there.pace) / 2) > _BENT * max(abs(here.pace), abs(there.pace))


def _passes(before: float, after: float, target: float) -> bool:
    return after == target or (before - target) * (after - target) < 0


def _settled(net: Net, load: Load, start: NetShape, factor: float) -> Expansion | None:
    """The equilibrium beside a shape at a constant factor; None where there is none near."""
    here = expand(net, start, load, factor)
    for _ in range(30):
        step = np.zeros_like(net.nodes)
        step[net.free] = factored(here.free).solve(-here.slope[net.free])
        moved = np.abs(step).max(initial=0.0)
        if not moved <= 0.1 * net.size:
            break
        here = expand(net, _moved(net, here.shape, step), load, factor)
        if moved <= _HOME * net.size / 100:
            return here
    return None


def _moved(net: Net, shape: NetShape, step: Array) -> NetShape:
    return shape_at(net, shape.positions + step, shape.angles)


def _tangent(net: Net, load: Load, here: Expansion, parts: Factorisation) -> Array:
    """Displacements by the factor, m, (node, 3)."""
    push = load_slope(net, here.shape, load)
    if np.any(load.displacements):
        push = push - (here.curvature @ load.displacements.ravel()).reshape(-1, 3)
    tangent = load.displacements.copy()
    tangent[net.free] += parts.solve(push[net.free])
    return tangent


def _station(
    net: Net, load: Load, here: Expansion, factor: float, before: Array | None, rising: bool, corrections: int
) -> _Station:
    """What an equilibrium says of the path, which goes on as before."""
    parts = factored(here.free)
    tangent = _tangent(net, load, here, parts)
    length = float(np.linalg.norm(tangent))
    if not (np.isfinite(length) and length):
        raise InputError("load: need one that moves the net, got one that does not")
    forwards = rising if before is None else float(np.sum(before * tangent)) > 0
    pace = (1.0 if forwards else -1.0) / length
    point = PathPoint(
        shape=here.shape,
        factor=factor,
        energy=here.stored,
        index=parts.index,
        rising=forwards,
        corrections=corrections,
    )
    return _Station(point=point, parts=parts, way=pace * tangent, pace=pace)


def _increment(net: Net, load: Load, here: _Station, length: float) -> _Station | None:
    """The point of the path about so far on; None where Newton's method does not get there."""
    factor = here.point.factor + length * here.pace
    there = expand(net, _moved(net, here.point.shape, length * here.way), load, factor)
    aside = np.zeros_like(net.nodes)
    for corrections in range(_CORRECTIONS):
        if not np.all(np.isfinite(there.slope)):
            return None
        parts = factored(there.free)
        step = np.zeros_like(net.nodes)
        step[net.free] = parts.solve(-there.slope[net.free])
        tangent = _tangent(net, load, there, parts)
        change = -float(np.sum(here.way * step)) / (float(np.sum(here.way * tangent)) or np.nan)
        step = step + change * tangent
        aside, moved = aside + step, float(np.linalg.norm(step))
        if not np.linalg.norm(aside) <= _ASTRAY * length:
            return None
        factor += change
        there = expand(net, _moved(net, there.shape, step), load, factor)
        if moved <= _HOME * length:
            # beyond contact of panels that lock, where the path does not lead, the energy is infinite
            within = np.isfinite(there.stored)
            return _station(net, load, there, factor, here.way, True, corrections) if within else None
    return None


def _around_corner(net: Net, load: Load, here: _Station, length: float) -> tuple[_Station, _Station | None]:
    """Past a kink of a law, such as a tendon that goes slack: the way turns at once to that of the other side."""
    factor = here.point.factor + length * here.pace
    over = expand(net, _moved(net, here.point.shape, length * here.way), load, factor)
    tangent = _tangent(net, load, over, factored(over.free))
    for pace in (1 / np.linalg.norm(tangent), -1 / np.linalg.norm(tangent)):
        turned = replace(here, way=pace * tangent, pace=float(pace))
        there = _increment(net, load, turned, length)
        # the other orientation would lead back to this side, or to nothing
        if there is not None and np.sum(there.way * turned.way) > _ALIGNED:
            return turned, there
    return here, None


def _events_between(
    net: Net, load: Load, here: _Station, there: _Station, length: float, after: int
) -> list[PathEvent]:
    """What happens within an increment, in order."""
    events = list[tuple[float, PathEvent]]()
    places = list[float]()
    if there.point.rising != here.point.rising:
        places.append(_halved(net, load, here, length, lambda point: point.rising != here.point.rising))
    if there.point.index != here.point.index:
        at = _halved(net, load, here, length, lambda point: point.index != here.point.index)
        if not any(abs(at - place) <= _SAME * length for place in places):
            places.append(at)
    for number, place in enumerate(places):
        # where stiffness is lost no increment may end, but one just short of it does
        short = place - length / 2**_HALVINGS
        point = (_increment(net, load, here, place) or _increment(net, load, here, short) or there).point
        mode = np.zeros_like(net.nodes)
        mode[net.free] = softest(expand(net, point.shape, load, point.factor).free, 1)[1][:, 0]
        limit = number == 0 and there.point.rising != here.point.rising
        events.append(
            (
                place,
                PathEvent(
                    kind="limit" if limit else "bifurcation",
                    after=after,
                    point=point,
                    mode=mode / mode.flat[np.argmax(np.abs(mode))],
                ),
            )
        )
    return [event for _, event in sorted(events, key=lambda each: each[0])]


def _halved(net: Net, load: Load, here: _Station, length: float, passed: Callable[[PathPoint], bool]) -> float:
    """How far on something has happened, by halving the increment."""
    low, high = 0.0, length
    for _ in range(_HALVINGS):
        middle = _increment(net, load, here, (low + high) / 2)
        if middle is not None and not passed(middle.point):
            low = (low + high) / 2
        else:
            high = (low + high) / 2
    return high


def _at(net: Net, load: Load, here: _Station, there: _Station, length: float, factor: float) -> _Station:
    """The point between two at which the factor is a given one."""
    low, high, begin = 0.0, length, here
    for _ in range(_HALVINGS):
        share = (factor - begin.point.factor) / (there.point.factor - begin.point.factor)
        positions = begin.point.shape.positions * (1 - share) + there.point.shape.positions * share
        last = _settled(net, load, shape_at(net, positions, begin.point.shape.angles), factor)
        if last is not None and np.linalg.norm(last.shape.positions - positions) <= high - low:
            return _station(net, load, last, factor, here.way, True, 0)
        middle = _increment(net, load, here, (low + high) / 2)
        if middle is None or (middle.point.factor - factor) * (here.point.factor - factor) <= 0:
            high, there = (low + high) / 2, middle or there
        else:
            low, begin = (low + high) / 2, middle
    return there
