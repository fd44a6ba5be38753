"""Stable equilibria of a net with contact under a load that grows or falls evenly."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import count
from typing import Literal, NamedTuple

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.statics.net.contact.contact_energy import contact_forces, passes_through
from forficula.statics.net.energy import expand, load_slope, moved_shape
from forficula.statics.net.factor import factored, softest
from forficula.statics.net.load import Load
from forficula.statics.net.load_path import LoadPath
from forficula.statics.net.minimum import NetRest, minimum
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.path_events import PathEvent
from forficula.statics.net.path_increment import PathPoint
from forficula.statics.net.supports import supported

_QUICK = 0.5  # of the longest displacement, below which the next step may be longer
_FAR = 2.0  # of the longest displacement, beyond which a step is halved
_HALVINGS = 16  # of an interval, to locate where parts begin to touch
_LARGEST = 0.05  # step of the factor, of the whole range
_DESCENT = 60  # steps of a descent, after which a step of the factor is halved
_AGAIN = 3  # number of successful steps after which a factor is tried again at which no equilibrium was found
_BELOW = 0.98  # of the way to an estimated limit: next factor
_BEYOND = 0.25  # of the way to a factor without equilibrium: nearer limits are bounded from above next
_LOST = 1e-4  # of the factor, without a target: accuracy with which the loss of an equilibrium is located
_SMALLEST = 1e-7  # step of the factor, of the whole range or of the first step, at which an equilibrium counts as lost


def stable_path(
    net: Net,
    start: NetShape,
    load: Load,
    *,
    step: float | None = None,
    increments: int = 100,
    factor: float = 0.0,
    target: float | None = None,
    stop: Callable[[PathPoint], bool] | None = None,
    rising: bool = True,
    watch: Callable[[PathPoint], None] = lambda _: None,
) -> LoadPath:
    """Follow stable equilibria while the load factor grows or falls in steps, up to the first that is lost.

    With contact, the tangent of a path turns where parts begin to touch, and it vanishes where they are blocked. The
    load therefore grows in steps. After each step the net descends to the nearest energy minimum. A step is halved if
    the minimum is far away. If none is found, the factor at which the equilibrium is lost is located.

    Args:
        net: as for `load_path`.
        start: a stable equilibrium at `factor`, or near one.
        load: forces, torques and displacements that act together.
        step: longest displacement of a coordinate in a step, m; None for 1/50 of the net's size.
        increments: largest number of steps.
        factor: at the start.
        target: factor that ends the path; None for none.
        stop: ends the path after the first point for which it returns True.
        rising: whether the factor rises.
        watch: called with every point.

    Raises:
        InputError: there is no stable equilibrium near the start.
    """
    net, pins = supported(net, load)
    longest = net.size / 50 if step is None else step
    first = minimum(net, start, load, factor)
    if not first.stable:
        raise InputError("start: need a shape at rest under the load at its start, got one that is not")
    sign, points = 1.0 if rising else -1.0, [_point(first, factor, rising)]
    watch(points[0])
    paces = [_pace(net, load, first.shape, factor)]
    size = longest / paces[0] if paces[0] else 1.0
    smallest = _SMALLEST * (size if target is None else max(abs(target - factor), 1e-300))
    most = np.inf if target is None else _LARGEST * abs(target - factor)
    size, lost, refused, successes = min(size, most), None, None, 0
    ended: Literal["target", "count", "stop"] = "count"
    while len(points) <= increments:
        before = points[-1]
        accuracy = 2 * (smallest if target is not None else max(smallest, _LOST * abs(before.factor - factor)))
        following = before.factor + sign * size
        if refused is not None and (following - refused) * sign >= 0:
            following = _near_limit(points, paces, refused)
        passed = target is not None and (following - target) * sign >= 0
        following = target if passed and target is not None else following
        rest = _next_rest(net, load, before, following, _FAR * longest)
        moved = np.abs(rest.shape.positions - before.shape.positions).max()
        if not rest.stable or moved > _FAR * longest:
            if abs(following - before.factor) < accuracy:
                lost, ended = rest, "stop"
                break
            size, refused, successes = abs(following - before.factor) / 2, following, 0
            continue
        points.append(_point(rest, following, rising))
        watch(points[-1])
        if passed or (stop is not None and stop(points[-1])):
            ended = "target" if passed else "stop"
            break
        paces.append(_pace(net, load, rest.shape, following))
        size, successes = min(2 * size, most) if moved <= _QUICK * longest else size, successes + 1
        # from further away, an equilibrium may have been out of reach that exists
        refused = None if successes == _AGAIN else refused
    events = () if lost is None else (_event(net, load, points, lost),)
    return LoadPath(load=load, points=tuple(points), events=events, ended=ended, pins=pins)


def stable_point_between(
    net: Net, load: Load, before: PathPoint, after: PathPoint, positions: Array, factor: float
) -> PathPoint | None:
    """Find the stable equilibrium at a factor between those of two points of a path near a guess; None without one.

    Args:
        net: as for `load_path`.
        load: at a factor of 1.
        before: point of a path.
        after: next point of the path.
        positions: guess, between both points, m, (node, 3).
        factor: guess of the load factor.
    """
    net, _ = supported(net, load)
    low, high = sorted((before.factor, after.factor))
    factor = float(np.clip(factor, low, high))
    held = before.shape.positions + (factor - before.factor) * load.displacements
    start = np.where(net.free, positions, held)
    if passes_through(net, before.shape.positions, start):
        start = held
    far = np.abs(after.shape.positions - before.shape.positions).max()
    rest = minimum(net, moved_shape(net, before.shape, start), load, factor)
    if not rest.stable or np.abs(rest.shape.positions - before.shape.positions).max() > _FAR * far:
        return None
    return _point(rest, factor, before.rising)


class Touch(NamedTuple):
    """Equilibrium of a path at which parts touch for the first time.

    Attributes:
        parts: pairs of parts, each by the names of both.
        point: the equilibrium.
    """

    parts: tuple[str, ...]
    point: PathPoint


def first_touches(net: Net, points: Sequence[PathPoint]) -> tuple[Touch, ...]:
    """Return the points of a path at which parts touch for the first time."""
    known, result = set[str](), list[Touch]()
    for point in points:
        parts = tuple(name for name in contact_forces(net, point.shape) if name not in known)
        if parts:
            known.update(parts)
            result.append(Touch(parts, point))
    return tuple(result)


def with_contact_begins(net: Net, load: Load, points: Sequence[PathPoint]) -> list[PathPoint]:
    """Return the points of a path with those added at which parts touch for the first time, by bisection."""
    result, known = list(points[:1]), set(contact_forces(net, points[0].shape))
    for after in points[1:]:
        while new := set(contact_forces(net, after.shape)) - known:
            low, high = result[-1], after
            for _ in range(_HALVINGS):
                positions, factor = (low.shape.positions + high.shape.positions) / 2, (low.factor + high.factor) / 2
                middle = stable_point_between(net, load, low, high, positions, factor)
                if middle is None:
                    break
                touches = new & set(contact_forces(net, middle.shape))
                low, high = (low, middle) if touches else (middle, high)
            known |= new & set(contact_forces(net, high.shape))
            if high is not after:
                result.append(high)
        result.append(after)
    return result


def _next_rest(net: Net, load: Load, before: PathPoint, factor: float, far: float) -> NetRest:
    """Return the energy minimum near a point of the path at another factor; not settled if it is not reached soon."""
    positions = before.shape.positions + (factor - before.factor) * load.displacements
    start = moved_shape(net, before.shape, positions)

    steps = count()

    def is_far(shape: NetShape) -> bool:
        return bool(np.abs(shape.positions - before.shape.positions).max() > far) or next(steps) > _DESCENT

    return minimum(net, start, load, factor, stop=is_far)


def _near_limit(points: Sequence[PathPoint], paces: Sequence[float], refused: float) -> float:
    """Return a factor near the limit that the last two points announce before a refused factor; else the middle.

    At a limit, 1 / pace^2 falls to zero linearly with the factor, because the displacement is proportional to the
    square root of the distance from the limit. The result is just below the limit or, once the limit is near, just
    above it.
    """
    last, room, share = points[-1].factor, refused - points[-1].factor, 0.5
    if len(points) > 1 and 0 < paces[-2] < paces[-1]:
        fall = paces[-1] ** -2 / (paces[-2] ** -2 - paces[-1] ** -2)
        limit = fall * (last - points[-2].factor) / room
        if limit < 1:
            share = _BELOW * limit if limit > _BEYOND else 2 * limit
    return float(last + room * share)


def _pace(net: Net, load: Load, shape: NetShape, factor: float) -> float:
    """Return the largest displacement of a coordinate per factor, m."""
    current = expand(net, shape, load, factor)
    push = load_slope(net, shape, load, current.turning)
    push = push - (current.curvature @ load.displacements.ravel()).reshape(-1, 3)
    rate = load.displacements.copy()
    rate[net.free] += factored(current.free).solve(push[net.free])
    return float(np.abs(rate).max(initial=0.0))


def _point(rest: NetRest, factor: float, rising: bool) -> PathPoint:
    return PathPoint(
        shape=rest.shape, factor=factor, energy=rest.energy, index=rest.index, rising=rising, corrections=rest.steps
    )


def _event(net: Net, load: Load, points: list[PathPoint], lost: NetRest) -> PathEvent:
    """Return the event at the last point of a path, beyond which the equilibrium is lost."""
    last = points[-1]
    mode = np.zeros_like(net.nodes)
    mode[net.free] = softest(expand(net, last.shape, load, last.factor).free, 1)[1][:, 0]
    return PathEvent(
        kind="bifurcation" if lost.settled and lost.index else "limit",
        after=len(points) - 1,
        point=last,
        mode=mode / mode.flat[np.argmax(np.abs(mode))],
    )
