"""Saddle between two stable states of a net, and its barriers."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from forficula.statics.net.contact.contact_energy import passes_through
from forficula.statics.net.energy import expand, moved_shape
from forficula.statics.net.factor import lowest
from forficula.statics.net.load import Load, no_load
from forficula.statics.net.load_path import LoadPath, load_path
from forficula.statics.net.minimum import NetRest, minimum, stationary
from forficula.statics.net.net import Net
from forficula.statics.net.stable_states import same_shape
from forficula.statics.net.supports import supported

_OFF = 1e-3  # push off the saddle, of the net's size
_STEP = 0.02  # longest step downhill from it, of the net's size


@dataclass(frozen=True, kw_only=True, eq=False)
class Saddle:
    """A stationary point with one unstable direction.

    Attributes:
        rest: the equilibrium, of index 1.
        ends: the stable states downhill from it, the start state first if it is one of them.
        joins: whether they are the two requested states.
        path: load path that led to it.
    """

    rest: NetRest
    ends: tuple[NetRest, NetRest]
    joins: bool
    path: LoadPath

    @property
    def barriers(self) -> tuple[float, float]:
        """Return the energies to climb from either end, J; another saddle may be lower."""
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
    known: list[Saddle] | None = None,
) -> Saddle | None:
    """Follow a load from one state towards the other until it is zero again, then apply Newton's method.

    The load is a set of torques on creases, which turn with the net as dead loads do not. They are equivalent to moving
    the rest angles to those of the other state. Tries alternate between both directions. From the second pair on, the
    torques have random weights, to leave paths that symmetry keeps on a ridge. With contact, parts that touch overlap
    slightly along the path; the saddle at its end is exact.

    Args:
        net: as for `minimum`.
        first: a stable state.
        second: another stable state.
        load: load that leads from the first towards the second state; None for the torques or, if they are all zero,
            for forces towards the positions of the second state.
        step: as for `load_path`.
        increments: of each path.
        tries: number of paths.
        seed: of the random weights.
        known: saddles of the net, whose descents are not computed again; every other saddle found is added.

    Returns:
        The first saddle found that joins both states; otherwise one with other ends; None if no saddle was found.
    """
    random, other = np.random.default_rng(seed), None
    known = [] if known is None else known
    for number in range(tries):
        start, end = (first, second) if number % 2 == 0 else (second, first)
        towards = _load_towards(net, start, end) if load is None else load
        if load is not None and number % 2:
            towards = Load(forces=-load.forces, torques=-load.torques, displacements=-load.displacements)
        if number > 1:
            towards = replace(towards, torques=towards.torques * random.uniform(0.0, 2.0, len(towards.torques)))
            towards = replace(towards, forces=towards.forces * random.uniform(0.0, 2.0, towards.forces.shape))
        path = load_path(
            net,
            start.shape,
            towards,
            step=step,
            increments=increments,
            target=0.0,
            locate_events=False,
            overlaps=True,
        )
        if path.ended != "target":
            continue
        result = _saddle_at(net, path, known)
        if result is None:
            continue
        result = _between(net, result, first, second)
        if result.joins:
            return result
        other = other or result
    return other


def _load_towards(net: Net, start: NetRest, end: NetRest) -> Load:
    turned = np.asarray(net.creases.law.stiffness) * (end.shape.angles - start.shape.angles)
    if np.any(turned):
        return replace(no_load(net), torques=turned)
    direction = (end.shape.positions - start.shape.positions) / net.size
    return replace(no_load(net), forces=np.where(net.free, direction * net.springs.stiffness.max(), 0.0))


def _saddle_at(net: Net, path: LoadPath, known: list[Saddle]) -> Saddle | None:
    """Find the saddle near the end of a path; None if it ends at another kind of stationary point."""
    rest = stationary(net, path.points[-1].shape)
    if not rest.settled or rest.index != 1 or rest.neutral:
        return None
    same = next((saddle for saddle in known if same_shape(net, saddle.rest.shape, rest.shape)), None)
    if same is not None:
        return replace(same, path=path)
    held, _ = supported(net)
    off = np.zeros_like(net.nodes)
    off[held.free] = lowest(expand(held, rest.shape).free)
    off *= _OFF * net.size / np.abs(off).max()
    while any(passes_through(net, rest.shape.positions, rest.shape.positions + sign * off) for sign in (1, -1)):
        off /= 2
    sides = [moved_shape(net, rest.shape, rest.shape.positions + sign * off) for sign in (1, -1)]
    one, another = (minimum(net, side, longest_step=_STEP * net.size) for side in sides)
    known.append(Saddle(rest=rest, ends=(one, another), joins=False, path=path))
    return known[-1]


def _between(net: Net, saddle: Saddle, first: NetRest, second: NetRest) -> Saddle:
    """Return a saddle with the requested start state first, and whether it joins the requested states."""
    one, another = saddle.ends
    if same_shape(net, another.shape, first.shape) or same_shape(net, one.shape, second.shape):
        one, another = another, one
    joins = same_shape(net, one.shape, first.shape) and same_shape(net, another.shape, second.shape)
    return replace(saddle, ends=(one, another), joins=joins)
