"""Samples that are placed, not drawn: near those that come nearest to facts that no sample has met together."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np

from forficula.arrays import Array, Flags

Target = tuple[int, ...]

# of a target: those from which steps are taken, and those whose differences are the steps (Storn and Price 1997)
_STARTS, _NEAREST = 3, 10
# by how much of a difference at least and at most, and how many of a sample's shares change at once
_STEPS, _CHANGED = (0.1, 0.9), 0.6
# added to every step, so that what the nearest have in common can still change
_NOISE = 0.02


def open_targets(met: Flags) -> list[Target]:
    """What no sample has met so far: all facts together, every fact, and every pair of facts that are met apart.

    Where every fact and every pair that is met apart is met, every three of which any two are.

    Args:
        met: whether each sample met each fact, (samples, facts).

    Returns:
        Numbers of the facts, those of the most facts first.
    """
    count = met.shape[1]
    single = [(fact,) for fact in range(count) if not met[:, fact].any()]
    pairs = [
        (one, other)
        for one, other in itertools.combinations(range(count), 2)
        if met[:, one].any() and met[:, other].any() and not (met[:, one] & met[:, other]).any()
    ]
    triples = [
        three
        for three in itertools.combinations(range(count), 3)
        if not (single or pairs)
        and all(met[:, two].all(axis=1).any() for two in itertools.combinations(three, 2))
        and not met[:, three].all(axis=1).any()
    ]
    everything = [] if met.all(axis=1).any() else [tuple(range(count))]
    return list(dict.fromkeys([*everything, *single, *pairs, *triples]))


def misses(excess: Array, target: Target) -> Array:
    """How far each sample is from meeting the facts of a target together, (samples,), 0 where it does.

    Args:
        excess: by how much each sample misses each fact beyond its tolerance, in units of the fact's scale,
            (samples, facts); not a number of a sample that could not run.
        target: numbers of facts.

    Returns:
        The sum over the facts of x / (1 + x), so that one that is missed by far does not hide the others; infinite
        where a sample could not run.
    """
    each = excess[:, target]
    return np.where(np.isnan(each).any(axis=1), np.inf, (each / (1 + each)).sum(axis=1))


def directed_shares(shares: Array, excess: Array, targets: Sequence[Target], count: int, seed: Sequence[int]) -> Array:
    """Place samples, each by differential evolution among those nearest to one of the targets in turn.

    Args:
        shares: of the samples so far, in the unit cube, (samples, unknowns).
        excess: as of `misses`.
        targets: in turn, from the first on.
        count: how many to place.
        seed: of the random numbers.

    Returns:
        Points of the unit cube, (count, unknowns).
    """
    generator = np.random.default_rng(list(seed))
    placed = []
    for number in range(count):
        order = np.argsort(misses(excess, targets[number % len(targets)]), kind="stable")
        start = shares[order[generator.integers(min(_STARTS, len(order)))]]
        one, other = shares[generator.permutation(order[:_NEAREST])[[0, -1]]]
        step = generator.uniform(*_STEPS) * (one - other) + _NOISE * generator.standard_normal(shares.shape[1])
        changed = np.asarray(generator.random(shares.shape[1]) < _CHANGED)
        changed[generator.integers(shares.shape[1])] = True
        placed.append(_reflected(start + np.where(changed, step, 0.0)))
    return np.array(placed)


def _reflected(point: Array) -> Array:
    """A point of the cube: what is beyond a side comes back from it."""
    folded = np.abs(np.mod(point + 1.0, 2.0) - 1.0)
    return np.clip(folded, 0.0, np.nextafter(1.0, 0.0))
