"""The path of equilibria of a net under a growing load, through snap-through and snap-back."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.statics.net.energy import expand
from forficula.statics.net.load import Load, check_load
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.path_events import PathEvent, events_between
from forficula.statics.net.path_increment import (
    PathPoint,
    PathStation,
    increment,
    pass_kink,
    settled,
    station_at_factor,
    station_of,
)
from forficula.statics.net.supports import supported

_QUICK = 4  # corrections after which the next increment may be longer
_BENT = 0.1  # largest difference of the mean rate of the factor from that of its ends, as a share of the larger one
_SHORTEST = 1e-5  # shortest increment, as a share of the first one
_CORNER = 1e-2  # increment, as a share of the first one, below which a corner is searched for


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
    first = expand(net, start, load, factor) if direction is not None else settled(net, load, start, factor)
    if first is None:
        raise InputError("start: need a shape at rest under the load at its start, got one that is not")
    current = station_of(net, load, first, factor, None, rising, 0)
    if direction is not None:
        current = replace(current, direction=direction / np.linalg.norm(direction), pace=0.0)
    length = (net.size / 50 if step is None else step) / np.abs(current.direction).max()
    longest, points, result = length, [current.point], list[PathEvent]()
    watch(current.point)
    ended: Literal["target", "count", "stop", "stuck"] = "count"
    while len(points) <= increments:
        following = increment(net, load, current, length)
        if following is None and length <= _CORNER * longest:
            current, following = pass_kink(net, load, current, length)
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
            new = events_between(net, load, current, following, length, len(points) - 1)
        passed = target is not None and _crosses(current.point.factor, following.point.factor, target)
        if target is not None and passed:
            following = station_at_factor(net, load, current, following, length, target)
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


def _bent(current: PathStation, following: PathStation, length: float) -> bool:
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
