"""The stable states of a net that a seeded search finds."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array
from forficula.statics.net.energy import expand, shape_at
from forficula.statics.net.factor import softest
from forficula.statics.net.minimum import NetRest, minimum
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.supports import loose_motions, supported

_SOFT = 12  # modes of which a push is made
_PUSH = (0.05, 0.6)  # largest displacement, of the net's size
_FOLD = 1.5  # largest share of its angle, of either sign, to which a crease is folded for a while
_STIFFER = 2.0  # powers of ten by which creases are stiffer for that while, at most
_SAME = 1e-4  # of the net's size
_SAME_ANGLE = 0.1  # rad; panels on the other side of one another are another state


@dataclass(frozen=True, kw_only=True, eq=False)
class StableStates:
    """What a search found: there may be more.

    Attributes:
        states: by rising energy.
        counts: how often the search came to each, (state,).
        tries: pushes made, beside the starts.
        failed: tries and starts that came to rest in no stable state.
        seed: of the pushes.
    """

    states: tuple[NetRest, ...]
    counts: tuple[int, ...]
    tries: int
    failed: int
    seed: int


def find_stable_states(net: Net, starts: Sequence[NetShape], *, tries: int = 40, seed: int = 0) -> StableStates:
    """Go downhill from given shapes, then again and again from pushes of what was found.

    A push is, by turns, a random combination of the softest modes, softer ones further, and a while with other and
    stiffer creases, whose rest angles are the angles there times random numbers.

    Args:
        net: as for `minimum`.
        starts: one or more.
        tries: how many pushes.
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
            begin = _folded(net, origin, random) if folds else _pushed(net, origin, random)
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
    order = sorted(range(len(states)), key=lambda each: states[each].energy)
    return StableStates(
        states=tuple(states[each] for each in order),
        counts=tuple(counts[each] for each in order),
        tries=tries,
        failed=failed,
        seed=seed,
    )


def same_shape(net: Net, one: NetShape, other: NetShape) -> bool:
    """Whether two shapes are the same; of a net without supports or weight, up to a motion of the whole."""
    places = one.positions
    if not net.gravity and loose_motions(net).shape[2] == 6:
        places = _laid_on(places, other.positions)
    apart = np.abs(places - other.positions).max()
    turned = np.abs(one.angles - other.angles).max(initial=0.0)
    return bool(apart <= _SAME * net.size and turned <= _SAME_ANGLE)


def _laid_on(places: Array, others: Array) -> Array:
    """The same moved as a whole to where the sum of squared distances is least (Kabsch 1976)."""
    centred, target = places - places.mean(axis=0), others - others.mean(axis=0)
    left, _, right = np.linalg.svd(centred.T @ target)
    proper = np.diag((1.0, 1.0, np.sign(np.linalg.det(left @ right))))
    return np.asarray(centred @ left @ proper @ right + others.mean(axis=0))


def _pushed(net: Net, shape: NetShape, random: np.random.Generator) -> NetShape:
    held, _ = supported(net)
    curvature = expand(held, shape).free
    stiffness, modes = softest(curvature, _SOFT)
    # of the same energy on average, as heat gives them
    shares = random.standard_normal(len(stiffness)) / np.sqrt(np.abs(stiffness) + 1e-9 * np.abs(stiffness).max())
    push = np.zeros_like(net.nodes)
    push[held.free] = modes @ shares
    push *= random.uniform(*_PUSH) * net.size / np.abs(push).max()
    return shape_at(net, shape.positions + push, shape.angles)


def _folded(net: Net, shape: NetShape, random: np.random.Generator) -> NetShape:
    law = replace(
        net.creases.law,
        rest_angle=shape.angles * random.uniform(-_FOLD, _FOLD, len(shape.angles)),
        stiffness=net.creases.law.stiffness * 10 ** random.uniform(0.0, _STIFFER),
    )
    return minimum(replace(net, creases=replace(net.creases, law=law)), shape).shape
