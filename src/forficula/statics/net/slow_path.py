"""What a net does while a load grows or falls slowly: along stable equilibria, and over snaps to the next ones."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from forficula.statics.net.energy import expand, shape_at
from forficula.statics.net.load import Load
from forficula.statics.net.load_path import LoadPath, PathEvent, PathPoint, load_path
from forficula.statics.net.minimum import NetRest, minimum
from forficula.statics.net.net import Net, NetShape

_MOST_SNAPS = 12
_BEYOND = 1e-4  # of the factor: how far past a limit the load is when it lands
_PUSH = 1e-3  # of the net's size, along the mode in which a bifurcation loses its stiffness
_STEP = 0.03  # longest one on the way, of the net's size
_NEAR = 1e-2  # of the net's size: what moves less has not snapped


@dataclass(frozen=True, kw_only=True, eq=False)
class Snap:
    """Where a net leaves one path for another at a constant load.

    Attributes:
        kind: "limit", from which it snaps for there is no equilibrium beyond; "bifurcation", from which it snaps to
            somewhere else; "branch", where it turns into another path that begins there.
        factor: of the load at which it leaves.
        before: equilibrium that it leaves.
        after: where it lands, or is told to stop on the way.
        released: what it loses of its potential on the way, J: what shakes it.
    """

    kind: Literal["limit", "bifurcation", "branch"]
    factor: float
    before: NetShape
    after: NetRest
    released: float


@dataclass(frozen=True, kw_only=True, eq=False)
class SlowPath:
    """Paths, one after another, with a snap between each and the next.

    Attributes:
        paths: each up to its first limit or bifurcation.
        snaps: one fewer, or as many where it lands nowhere stable.
        ended: "target"; "stop" where it was told to; "lost" where it found no equilibrium to go on from.
    """

    paths: tuple[LoadPath, ...]
    snaps: tuple[Snap, ...]
    ended: Literal["target", "stop", "lost"]

    @property
    def points(self) -> tuple[PathPoint, ...]:
        """Of all paths, in order."""
        return tuple(point for path in self.paths for point in path.points)


def slow_path(
    net: Net,
    start: NetShape,
    load: Load,
    *,
    begin: float = 0.0,
    end: float = 1.0,
    step: float | None = None,
    increments: int = 100,
    stop: Callable[[NetShape], bool] | None = None,
) -> SlowPath:
    """Let a load grow or fall so slowly that the net always rests, but where it snaps.

    It lands where it comes to rest downhill from where it lost its equilibrium: what it keeps of the energy that a snap
    sets free is left out, and may carry it further in motion.

    Args:
        net: as for `load_path`.
        start: a stable equilibrium at `begin`.
        load: times the factor.
        begin: factor.
        end: factor.
        step: as for `load_path`.
        increments: of each path.
        stop: ends it at the first shape for which it says so, on a path or on the way of a snap.

    Raises:
        InputError: as for `load_path`.
    """

    def told(shape: NetShape) -> bool:
        return stop is not None and stop(shape)

    paths, snaps, factor = list[LoadPath](), list[Snap](), begin
    ended: Literal["target", "stop", "lost"] = "lost"
    while len(snaps) <= _MOST_SNAPS:
        path = load_path(
            net,
            start,
            load,
            step=step,
            increments=increments,
            factor=factor,
            target=end,
            stop=None if stop is None else (lambda point: told(point.shape)),
            events=1,
            rising=end > begin,
        )
        there = told(path.points[-1].shape)
        path = path if there or not path.events else _up_to(path)
        paths.append(path)
        if there or not path.events:
            ended = "stop" if there else "target" if path.ended == "target" else "lost"
            break
        limit = path.events[0].point.factor
        factor = limit + _BEYOND * float(np.sign(end - begin)) * max(abs(limit - begin), _BEYOND * abs(end - begin))
        snaps.append(_snap(net, path.events[0], load, factor, told))
        if told(snaps[-1].after.shape):
            ended = "stop"
            break
        if not snaps[-1].after.stable or (end - factor) * (end - begin) <= 0:
            break
        start = snaps[-1].after.shape
    return SlowPath(paths=tuple(paths), snaps=tuple(snaps), ended=ended)


def _up_to(path: LoadPath) -> LoadPath:
    """A path that ends at its first event."""
    event = path.events[0]
    points = (*path.points[: event.after + 1], event.point)
    return LoadPath(load=path.load, points=points, events=path.events[:1], ended=path.ended, pins=path.pins)


def _snap(net: Net, event: PathEvent, load: Load, factor: float, stop: Callable[[NetShape], bool]) -> Snap:
    """Where a net lands that a limit or a bifurcation throws off its path; of two ways the one further down."""
    beyond = (factor - event.point.factor) * load.displacements
    before = shape_at(net, event.point.shape.positions + beyond, event.point.shape.angles)
    landed = list[tuple[float, NetRest]]()
    for sign in (1.0, -1.0) if event.kind == "bifurcation" else (0.0,):
        pushed = shape_at(net, before.positions + sign * _PUSH * net.size * event.mode, before.angles)
        rest = minimum(net, pushed, load, factor, longest_step=_STEP * net.size, stop=stop)
        landed.append((expand(net, rest.shape, load, factor).energy, rest))
    energy, after = min(landed, key=lambda each: each[0])
    moved = np.abs(after.shape.positions - before.positions).max()
    near = event.kind == "bifurcation" and moved < _NEAR * net.size
    return Snap(
        kind="branch" if near else event.kind,
        factor=event.point.factor,
        before=event.point.shape,
        after=after,
        released=expand(net, before, load, factor).energy - energy,
    )
