"""Collapse of a stable state of a net: the load that the state no longer withstands."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.statics.net.contact.stable_path import stable_path
from forficula.statics.net.energy import expand, moved_shape
from forficula.statics.net.load import Load, crease_torques
from forficula.statics.net.load_path import LoadPath, load_path
from forficula.statics.net.minimum import NetRest, minimum
from forficula.statics.net.net import Net
from forficula.statics.net.path_increment import PathPoint

_BEYOND = 1e-3


@dataclass(frozen=True, kw_only=True, eq=False)
class Collapse:
    """Loss of a state under a growing load.

    Attributes:
        kind: "limit", beyond which there is no equilibrium nearby; "bifurcation", beyond which the equilibrium on the
            path is unstable; "none" if the state held along the whole path.
        factor: load factor at the loss; for "none" the largest one reached.
        point: the equilibrium at that factor.
        mode: direction in which stiffness is lost, the largest coordinate 1, (node, 3); 0 for "none".
        path: equilibria up to that point.
    """

    kind: Literal["limit", "bifurcation", "none"]
    factor: float
    point: PathPoint
    mode: Array
    path: LoadPath


def collapse(
    net: Net,
    state: NetRest,
    load: Load,
    *,
    most: float | None = None,
    stop: Callable[[PathPoint], bool] | None = None,
    step: float | None = None,
    increments: int = 300,
) -> Collapse:
    """Find the first limit or bifurcation under a load that grows in proportion.

    Args:
        net: as for `load_path`.
        state: stable, without the load.
        load: grows from zero.
        most: largest factor; None for no limit.
        stop: as for `load_path`.
        step: as for `load_path`.
        increments: largest number of increments.

    Raises:
        InputError: the state is not stable, or `load_path` rejects the load.
    """
    if not state.stable:
        raise InputError(f"state: need a stable one, got one with {state.index} ways downhill")
    if net.contact is None:
        path = load_path(net, state.shape, load, step=step, increments=increments, target=most, stop=stop, events=1)
    else:
        path = stable_path(net, state.shape, load, step=step, increments=increments, target=most, stop=stop)
    if path.events:
        event = path.events[0]
        return Collapse(kind=event.kind, factor=event.point.factor, point=event.point, mode=event.mode, path=path)
    last = path.points[-1]
    return Collapse(kind="none", factor=last.factor, point=last, mode=np.zeros_like(net.nodes), path=path)


def state_after_collapse(net: Net, lost: Collapse) -> NetRest:
    """Find where a net rests after a limit or a bifurcation, under a load that is larger by a thousandth.

    Of the two directions of the mode, the one that ends at a lower energy is taken. Use `minimum` from the result to
    find the resting shape without the load. The result is not settled if no state withstands that load.

    Args:
        net: as for `collapse`.
        lost: result of `collapse`.

    Raises:
        InputError: the state did not collapse.
    """
    if lost.kind == "none":
        raise InputError("lost: need a state that collapses, got one that held")
    load, factor, shape = lost.path.load, lost.factor * (1 + _BEYOND), lost.point.shape
    ends = []
    for sense in (1, -1):
        aside = sense * _BEYOND * net.size * lost.mode + (factor - lost.factor) * load.displacements
        pushed = moved_shape(net, shape, shape.positions + aside)
        rest = minimum(net, pushed, load, factor, longest_step=net.size / 50)
        ends.append((expand(net, rest.shape, load, factor).energy, rest))
    return min(ends, key=lambda end: end[0])[1]


def holding_torque(
    net: Net, state: NetRest, crease: int, *, sense: int = 1, step: float | None = None, increments: int = 300
) -> Collapse:
    """Find the torque on one crease at which a stable state is lost; the factor of the result is the torque in N m.

    Args:
        net: as for `load_path`.
        state: stable.
        crease: its number.
        sense: 1 for a torque that folds a valley, -1 for a mountain.
        step: as for `load_path`.
        increments: largest number of increments.

    Raises:
        InputError: as for `collapse`.
    """
    load = crease_torques(net, np.array([crease]), float(sense))
    return collapse(net, state, load, step=step, increments=increments)
