"""What is unknown of a design, and what is believed of it before anything is observed: points of a unit cube."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from forficula.arrays import Array
from forficula.goals.latin_points import latin_points
from forficula.goals.value_at import choice_at, written
from forficula.study.factors import Factor

# a share of 0 or 1 of a normal distribution is infinitely far out
_LEAST_SHARE = 1e-6


def prior_shares(priors: Sequence[Factor], count: int, seed: int) -> Array:
    """Draw points of the unit cube with a side for each unknown, (count, unknowns), whose counts have intervals.

    The first points of a longer draw with the same seed are those of a shorter one; see `latin_points`.

    Args:
        priors: the unknowns.
        count: how many points.
        seed: of the draw.
    """
    return latin_points(len(priors), 2 ** math.ceil(math.log2(max(count, 1))), seed)[:count]


def values_at(priors: Sequence[Factor], shares: Sequence[float] | Array) -> dict[str, object]:
    """The values of all unknowns at a point of the unit cube, by key, as a design file has them.

    Args:
        priors: the unknowns; of those with values, each is as likely as the others.
        shares: of the draws of each unknown that lie below, (unknowns,).
    """
    return {prior.key: value_at(prior, float(share)) for prior, share in zip(priors, shares, strict=True)}


def value_at(prior: Factor, share: float) -> object:
    """The value of an unknown at a share of its prior, as a design file has it."""
    if prior.distribution is None:
        return choice_at(prior.values, share)
    shares = np.clip([share], _LEAST_SHARE, 1 - _LEAST_SHARE)
    return written(float(prior.distribution.quantiles(shares)[0]), prior.unit)
