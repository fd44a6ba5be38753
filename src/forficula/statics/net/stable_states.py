"""Seeded search for the stable states of a net."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array
from forficula.statics.net.contact.contact_energy import passes_through
from forficula.statics.net.energy import expand, moved_shape
from forficula.statics.net.factor import softest
from forficula.statics.net.minimum import NetRest, minimum
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.supports import loose_motions, supported

_SOFT = 12  # number of modes that a push combines
_PUSH = (0.05, 0.6)  # range of the largest displacement, of the net's size
_FOLD = 1.5  # largest multiple of its angle, of either sign, to which a crease is folded temporarily
_STIFFER = 2.0  # largest power of ten by which creases are stiffer during that folding
_SAME = 1e-4  # of the net's size
_EQUAL = 1e-9  # difference of energies, divided by the largest energy, of states of equal energy
_SAME_ANGLE = 0.1  # rad; distinguishes states with panels on opposite sides of each other


@dataclass(frozen=True, kw_only=True, eq=False)
class StableStates:
    """Result of a search for stable states; there may be more states.

    Attributes:
        states: by rising energy.
        counts: how often the search reached each state, (state,).
        tries: number of pushes, besides the starts.
        failed: number of tries and starts that ended in no stable state.
        seed: of the pushes.
    """

    states: tuple[NetRest, ...]
    counts: tuple[int, ...]
    tries: int
    failed: int
    seed: int


def find_stable_states(net: Net, starts: Sequence[NetShape], *, tries: int = 40, seed: int = 0) -> StableStates:
    """Search for stable states by descending from given shapes, then from pushed copies of the states found.

    Two kinds of pushes alternate: a random combination of the softest modes, with larger shares of softer modes; and a
    temporary rest with stiffer creases, whose rest angles are the present angles times random numbers. With contact, a
    push is halved until no parts pass through each other.

    Args:
        net: as for `minimum`.
        starts: one or more shapes.
        tries: number of pushes.
        seed: of the random numbers.
    """
    random = np.random.default_rng(seed)
    states, counts, failed, last = list[NetRest](), list[int](), 0, starts[0]
    for number in range(len(starts) + tries):
        if number < len(starts):
            begin = starts[number]
        else:
            origin = states[random.integers(len(states))].shape if states else last
            folds = len(net.creases.points) and (number - len(starts)) % 2
            begin = _folded(net, origin, random) if folds else _random_push(net, origin, random)
        rest = minimum(net, begin)
        if not rest.stable:
            failed, last = failed + 1, rest.shape
            continue
        known = [same_shape(net, rest.shape, state.shape) for state in states]
        if any(known):
            counts[known.index(True)] += 1
        else:
            states.append(rest)
            counts.append(1)
    order = by_energy([state.energy for state in states])
    return StableStates(
        states=tuple(states[number] for number in order),
        counts=tuple(counts[number] for number in order),
        tries=tries,
        failed=failed,
        seed=seed,
    )


def by_energy(energies: Sequence[float]) -> list[int]:
    """Return the numbers of states by rising energy; states of equal energy, as mirror images, keep their order."""
    order = sorted(range(len(energies)), key=lambda number: energies[number])
    close = _EQUAL * max((abs(energy) for energy in energies), default=0.0)
    ranks, rank = dict[int, int](), 0
    for place, number in enumerate(order):
        rank += energies[number] - energies[order[max(place - 1, 0)]] > close
        ranks[number] = rank
    return sorted(order, key=lambda number: (ranks[number], number))


def same_shape(net: Net, one: NetShape, other: NetShape) -> bool:
    """Return whether two shapes are equal; for a net without supports and weight, up to a rigid-body motion."""
    places = one.positions
    if not net.gravity and loose_motions(net).shape[2] == 6:
        places = _aligned(places, other.positions)
    apart = np.abs(places - other.positions).max()
    turned = np.abs(one.angles - other.angles).max(initial=0.0)
    return bool(apart <= _SAME * net.size and turned <= _SAME_ANGLE)


def _aligned(places: Array, others: Array) -> Array:
    """Return positions after the rigid-body motion with the least sum of squared distances (Kabsch 1976)."""
    centred, target = places - places.mean(axis=0), others - others.mean(axis=0)
    left, _, right = np.linalg.svd(centred.T @ target)
    proper = np.diag((1.0, 1.0, np.sign(np.linalg.det(left @ right))))
    return np.asarray(centred @ left @ proper @ right + others.mean(axis=0))


def _random_push(net: Net, shape: NetShape, random: np.random.Generator) -> NetShape:
    held, _ = supported(net)
    curvature = expand(held, shape).free
    stiffness, modes = softest(curvature, _SOFT)
    # equal mean energies of all modes, as in thermal motion
    shares = random.standard_normal(len(stiffness)) / np.sqrt(np.abs(stiffness) + 1e-9 * np.abs(stiffness).max())
    push = np.zeros_like(net.nodes)
    push[held.free] = modes @ shares
    push *= random.uniform(*_PUSH) * net.size / np.abs(push).max()
    while passes_through(net, shape.positions, shape.positions + push):
        push /= 2
    return moved_shape(net, shape, shape.positions + push)


def _folded(net: Net, shape: NetShape, random: np.random.Generator) -> NetShape:
    law = replace(
        net.creases.law,
        rest_angle=shape.angles * random.uniform(-_FOLD, _FOLD, len(shape.angles)),
        stiffness=net.creases.law.stiffness * 10 ** random.uniform(0.0, _STIFFER),
    )
    return minimum(replace(net, creases=replace(net.creases, law=law)), shape).shape
