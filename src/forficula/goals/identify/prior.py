"""Priors of unknown values: points of the unit cube and the values at them."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from forficula.arrays import Array
from forficula.goals.latin_points import latin_points
from forficula.goals.value_at import choice_at, design_file_value
from forficula.study.factors import Factor

# 0 and 1 would give infinite values of a normal distribution
_LEAST_SHARE = 1e-6


def prior_shares(priors: Sequence[Factor], count: int, seed: int) -> Array:
    """Draw points of the unit cube with one side per unknown, (count, unknowns), such that counts have valid intervals.

    The first points of a longer draw with the same seed are those of a shorter one; see `latin_points`.

    Args:
        priors: the unknowns.
        count: number of points.
        seed: seed of the draw.
    """
    return latin_points(len(priors), 2 ** math.ceil(math.log2(max(count, 1))), seed)[:count]


def values_at(priors: Sequence[Factor], shares: Sequence[float] | Array) -> dict[str, object]:
    """Return the values of all unknowns at a point of the unit cube, by key, as in a design file.

    Args:
        priors: the unknowns; choices are equally likely.
        shares: cumulative probability of each unknown, (unknowns,).
    """
    return {prior.key: value_at(prior, float(share)) for prior, share in zip(priors, shares, strict=True)}


def value_at(prior: Factor, share: float) -> object:
    """Return the value of an unknown at a cumulative probability of its prior, as in a design file."""
    if prior.distribution is None:
        return choice_at(prior.values, share)
    shares = np.clip([share], _LEAST_SHARE, 1 - _LEAST_SHARE)
    return design_file_value(float(prior.distribution.quantiles(shares)[0]), prior.unit)
