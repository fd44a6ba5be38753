"""Path of a net under a slowly growing or falling load: stable equilibria, and snaps from one to the next."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Literal

import numpy as np

from forficula.statics.net.contact.stable_path import stable_path, with_contact_begins
from forficula.statics.net.energy import expand, moved_shape
from forficula.statics.net.load import Load
from forficula.statics.net.load_path import LoadPath, load_path
from forficula.statics.net.minimum import NetRest, minimum
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.path_events import PathEvent
from forficula.statics.net.path_increment import PathPoint

_MOST_SNAPS = 12
_BEYOND = 1e-4  # share of the factor by which the load exceeds a limit after the snap
_PUSH = 1e-3  # of the net's size, along the mode in which a bifurcation loses its stiffness
_STEP = 0.03  # longest step during a snap, of the net's size
_NEAR = 1e-2  # of the net's size: a smaller motion is not a snap


@dataclass(frozen=True, kw_only=True, eq=False)
class Snap:
    """Jump of a net from one path to another at a constant load.

    Attributes:
        kind: "limit", beyond which there is no equilibrium; "bifurcation", at which the net snaps to a distant state;
            "branch", at which it turns into another path that begins at this point.
        factor: load factor of the snap.
        before: equilibrium before the snap.
        after: equilibrium after the snap, or the shape at which `stop` ended it.
        released: potential energy that the snap releases, J.
        descent: shapes between `before` and `after`, in the order of a motion with equal dampers and without inertia.
    """

    kind: Literal["limit", "bifurcation", "branch"]
    factor: float
    before: NetShape
    after: NetRest
    released: float
    descent: tuple[NetShape, ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class SlowPath:
    """Consecutive paths with snaps between them.

    Attributes:
        paths: each up to its first limit or bifurcation.
        snaps: one fewer than the paths, or the same number if the last snap ended in no stable state.
        ended: "target"; "stop" if `stop` ended it; "lost" if there was no equilibrium to continue from.
    """

    paths: tuple[LoadPath, ...]
    snaps: tuple[Snap, ...]
    ended: Literal["target", "stop", "lost"]

    @property
    def points(self) -> tuple[PathPoint, ...]:
        """Return the points of all paths, in order."""
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
    stop_snaps: Callable[[NetShape], bool] | None = None,
    watch: Callable[[NetShape, float, bool], None] = lambda _shape, _factor, _resting: None,
) -> SlowPath:
    """Follow a net under a load that grows or falls so slowly that the net is at rest except during snaps.

    A snap ends where the net comes to rest downhill from its lost equilibrium. The kinetic energy of the snap is
    ignored; in a real motion, it may carry the net further.

    Args:
        net: as for `load_path`.
        start: a stable equilibrium at `begin`.
        load: at a factor of 1.
        begin: first factor.
        end: last factor.
        step: as for `load_path`.
        increments: of each path.
        stop: ends the path at the first shape for which it returns True, on a path or during a snap.
        stop_snaps: ends a snap, and the path, at the first shape of the snap for which it returns True; None for
            `stop`.
        watch: called with shape, factor, and whether the net rests, at every point of paths and of snaps at a limit.

    Raises:
        InputError: as for `load_path`.
    """

    def stops(shape: NetShape) -> bool:
        return stop is not None and stop(shape)

    paths, snaps, factor = list[LoadPath](), list[Snap](), begin
    ended: Literal["target", "stop", "lost"] = "lost"
    while len(snaps) <= _MOST_SNAPS:
        follow = partial(load_path, events=1) if net.contact is None else stable_path
        path = follow(
            net,
            start,
            load,
            step=step,
            increments=increments,
            factor=factor,
            target=end,
            stop=None if stop is None else (lambda point: stops(point.shape)),
            rising=end > begin,
            watch=lambda point: watch(point.shape, point.factor, True),
        )
        stopped = stops(path.points[-1].shape)
        path = path if stopped or not path.events else _up_to_event(path)
        if net.contact is not None:
            path = replace(path, points=tuple(with_contact_begins(net, load, path.points)))
        paths.append(path)
        if stopped or not path.events:
            ended = "stop" if stopped else "target" if path.ended == "target" else "lost"
            break
        limit = path.events[0].point.factor
        factor = limit + _BEYOND * float(np.sign(end - begin)) * max(abs(limit - begin), _BEYOND * abs(end - begin))
        snaps.append(_snap(net, path.events[0], load, factor, stop_snaps or stops, watch))
        if stops(snaps[-1].after.shape):
            ended = "stop"
            break
        if not snaps[-1].after.stable or (end - factor) * (end - begin) <= 0:
            break
        start = snaps[-1].after.shape
    return SlowPath(paths=tuple(paths), snaps=tuple(snaps), ended=ended)


def _up_to_event(path: LoadPath) -> LoadPath:
    """Return a path up to its first event."""
    event = path.events[0]
    points = (*path.points[: event.after + 1], event.point)
    return LoadPath(load=path.load, points=points, events=path.events[:1], ended=path.ended, pins=path.pins)


def _snap(
    net: Net,
    event: PathEvent,
    load: Load,
    factor: float,
    stop: Callable[[NetShape], bool],
    watch: Callable[[NetShape, float, bool], None],
) -> Snap:
    """Return the snap at a limit or a bifurcation; of two directions, the one that ends at lower energy."""
    beyond = (factor - event.point.factor) * load.displacements
    before = moved_shape(net, event.point.shape, event.point.shape.positions + beyond)
    landed = list[tuple[float, NetRest, list[NetShape]]]()
    for sign in (1.0, -1.0) if event.kind == "bifurcation" else (0.0,):
        pushed = moved_shape(net, before, before.positions + sign * _PUSH * net.size * event.mode)
        descent = list[NetShape]()

        def follow(shape: NetShape, descent: list[NetShape] = descent) -> bool:
            descent.append(shape)
            if event.kind == "limit":
                watch(shape, event.point.factor, False)
            return stop(shape)

        rest = minimum(net, pushed, load, factor, longest_step=_STEP * net.size, stop=follow)
        # with the energy that creases dissipate during the snap
        end = replace(rest.shape, turn=pushed.turn)
        landed.append((expand(net, end, load, factor).energy, rest, descent))
    energy, after, descent = min(landed, key=lambda landing: landing[0])
    moved = np.abs(after.shape.positions - before.positions).max()
    near = event.kind == "bifurcation" and moved < _NEAR * net.size
    return Snap(
        kind="branch" if near else event.kind,
        factor=event.point.factor,
        before=event.point.shape,
        after=after,
        released=expand(net, before, load, factor).energy - energy,
        descent=tuple(descent),
    )
