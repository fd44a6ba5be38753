"""The load that a stable state of a net does not withstand."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.statics.net.energy import expand, shape_at
from forficula.statics.net.load import Load, crease_torques
from forficula.statics.net.load_path import LoadPath, PathPoint, load_path
from forficula.statics.net.minimum import NetRest, minimum
from forficula.statics.net.net import Net

_BEYOND = 1e-3


@dataclass(frozen=True, kw_only=True, eq=False)
class Collapse:
    """Where a load that grows carries a state away.

    Attributes:
        kind: "limit", past which there is no equilibrium near by; "bifurcation", past which the one on the path holds
            no longer; "none" where it held as far as the path went.
        factor: times which the load acts there; for "none" the largest reached.
        point: the equilibrium there.
        mode: the way in which stiffness is lost, the largest coordinate 1, (node, 3); 0 for "none".
        path: there.
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
    """The first limit or bifurcation under a load that grows in proportion.

    Args:
        net: as for `load_path`.
        state: stable, without the load.
        load: that grows from nothing.
        most: factor that is enough; None for no end.
        stop: as for `load_path`.
        step: as for `load_path`.
        increments: largest number of them.

    Raises:
        InputError: the state is not stable, or what `load_path` refuses.
    """
    if not state.stable:
        raise InputError(f"state: need a stable one, got one with {state.index} ways downhill")
    path = load_path(net, state.shape, load, step=step, increments=increments, target=most, stop=stop, events=1)
    if path.events:
        event = path.events[0]
        return Collapse(kind=event.kind, factor=event.point.factor, point=event.point, mode=event.mode, path=path)
    last = path.points[-1]
    return Collapse(kind="none", factor=last.factor, point=last, mode=np.zeros_like(net.nodes), path=path)


def snapped(net: Net, lost: Collapse) -> NetRest:
    """Where it goes from a limit or a bifurcation, under a load a thousandth larger.

    Of the two senses of the mode the one that ends lower; what it comes to without the load is `minimum` from there.
    It is not settled where nothing holds that load.

    Args:
        net: as for `collapse`.
        lost: what it said.

    Raises:
        InputError: it did not collapse.
    """
    if lost.kind == "none":
        raise InputError("lost: need a state that collapses, got one that held")
    load, factor, here = lost.path.load, lost.factor * (1 + _BEYOND), lost.point.shape
    ends = []
    for sense in (1, -1):
        aside = sense * _BEYOND * net.size * lost.mode + (factor - lost.factor) * load.displacements
        beside = shape_at(net, here.positions + aside, here.angles)
        rest = minimum(net, beside, load, factor, longest_step=net.size / 50)
        ends.append((expand(net, rest.shape, load, factor).energy, rest))
    return min(ends, key=lambda each: each[0])[1]


def holding_torque(
    net: Net, state: NetRest, crease: int, *, sense: int = 1, step: float | None = None, increments: int = 300
) -> Collapse:
    """The torque on one crease, N m as the factor, at which a stable state is lost.

    Args:
        net: as for `load_path`.
        state: stable.
        crease: its number.
        sense: 1 where the torque folds a valley, -1 a mountain.
        step: as for `load_path`.
        increments: largest number of them.

    Raises:
        InputError: as for `collapse`.
    """
    load = crease_torques(net, np.array([crease]), float(sense))
    return collapse(net, state, load, step=step, increments=increments)
