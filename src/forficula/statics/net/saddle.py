"""The saddle between two stable states of a net, and the barriers that it is."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from forficula.statics.net.energy import expand, shape_at
from forficula.statics.net.factor import lowest
from forficula.statics.net.load import Load, no_load
from forficula.statics.net.load_path import LoadPath, load_path
from forficula.statics.net.minimum import NetRest, minimum, stationary
from forficula.statics.net.net import Net
from forficula.statics.net.stable_states import same_shape
from forficula.statics.net.supports import supported

_OFF = 1e-3  # push off the saddle, of the net's size
_STEP = 0.02  # longest one downhill of it, of the net's size


@dataclass(frozen=True, kw_only=True, eq=False)
class Saddle:
    """A stationary point with one way downhill, to either side of it.

    Attributes:
        rest: there, of index 1.
        ends: the stable states downhill of it, that of the start first where it is one of them.
        joins: whether they are the two states asked for.
        path: of loads that led there.
    """

    rest: NetRest
    ends: tuple[NetRest, NetRest]
    joins: bool
    path: LoadPath

    @property
    def barriers(self) -> tuple[float, float]:
        """Energies to climb from either end, J; another saddle may be lower."""
        return self.rest.energy - self.ends[0].energy, self.rest.energy - self.ends[1].energy


def find_saddle(
    net: Net,
    first: NetRest,
    second: NetRest,
    *,
    load: Load | None = None,
    step: float | None = None,
    increments: int = 300,
    tries: int = 6,
    seed: int = 0,
) -> Saddle | None:
    """Follow a load from one state towards the other to where it is none again, then Newton's method on the slope.

    Torques on creases turn with the net, as dead loads do not; they are what rest angles moved to those of the other
    state would do. Tries go to and fro, from the second pair on with random shares of the torques, which leave paths
    that symmetry keeps on a ridge.

    Args:
        net: as for `minimum`.
        first: a stable state.
        second: another one.
        load: that leads from the first towards the second; None for the torques, and where these are none for forces
            towards its places.
        step: as for `load_path`.
        increments: of each path.
        tries: how many paths.
        seed: of the shares.

    Returns:
        The first saddle found that joins the two; one with other ends where there is none such; None for none at all.
    """
    random, other = np.random.default_rng(seed), None
    for number in range(tries):
        here, there = (first, second) if number % 2 == 0 else (second, first)
        towards = _towards(net, here, there) if load is None else load
        if load is not None and number % 2:
            towards = Load(forces=-load.forces, torques=-load.torques, displacements=-load.displacements)
        if number > 1:
            towards = replace(towards, torques=towards.torques * random.uniform(0.0, 2.0, len(towards.torques)))
            towards = replace(towards, forces=towards.forces * random.uniform(0.0, 2.0, towards.forces.shape))
        path = load_path(net, here.shape, towards, step=step, increments=increments, target=0.0)
        if path.ended != "target":
            continue
        found = _saddle_at(net, path, first, second)
        if found is not None and found.joins:
            return found
        other = other or found
    return other


def _towards(net: Net, here: NetRest, there: NetRest) -> Load:
    turned = np.asarray(net.creases.law.stiffness) * (there.shape.angles - here.shape.angles)
    if np.any(turned):
        return replace(no_load(net), torques=turned)
    way = (there.shape.positions - here.shape.positions) / net.size
    return replace(no_load(net), forces=np.where(net.free, way * net.springs.stiffness.max(), 0.0))


def _saddle_at(net: Net, path: LoadPath, first: NetRest, second: NetRest) -> Saddle | None:
    """The saddle beside the end of a path; None where it ends at another stationary point."""
    rest = stationary(net, path.points[-1].shape)
    if not rest.settled or rest.index != 1 or rest.neutral:
        return None
    held, _ = supported(net)
    off = np.zeros_like(net.nodes)
    off[held.free] = lowest(expand(held, rest.shape).free)
    off *= _OFF * net.size / np.abs(off).max()
    sides = [shape_at(net, rest.shape.positions + sign * off, rest.shape.angles) for sign in (1, -1)]
    one, another = (minimum(net, side, longest_step=_STEP * net.size) for side in sides)
    if same_shape(net, another.shape, first.shape) or same_shape(net, one.shape, second.shape):
        one, another = another, one
    joins = same_shape(net, one.shape, first.shape) and same_shape(net, another.shape, second.shape)
    return Saddle(rest=rest, ends=(one, another), joins=joins, path=path)
