"""What is unknown of a design, and what is believed of it before anything is observed: points of a unit cube."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy import stats

from forficula.design import key_quantity
from forficula.errors import InputError
from forficula.goals.latin_points import latin_points
from forficula.quantities import parse_quantity
from forficula.study.factors import Factor

Array = NDArray[np.float64]

# a share of 0 or 1 of a normal distribution is infinitely far out
_LEAST_SHARE = 1e-6
# digits of a drawn value: as many as anyone reads, and few enough that its text is short
_DIGITS = 6


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
    return {prior.key: _value_at(prior, float(share)) for prior, share in zip(priors, shares, strict=True)}


def shares_of(priors: Sequence[Factor], values: Sequence[object]) -> Array:
    """Where values lie in the unit cube, (unknowns,): the inverse of `values_at`.

    Args:
        priors: the unknowns.
        values: as a design file has them; one that is not among those of an unknown with values is refused.
    """
    return np.array([_share_of(prior, value) for prior, value in zip(priors, values, strict=True)])


def _value_at(prior: Factor, share: float) -> object:
    if prior.distribution is None:
        return prior.values[min(int(share * len(prior.values)), len(prior.values) - 1)]
    shares = np.clip([share], _LEAST_SHARE, 1 - _LEAST_SHARE)
    drawn = float(prior.distribution.quantiles(shares)[0])
    quantity = key_quantity(prior.key, prior.model)
    if quantity is None:
        return float(f"{drawn:.{_DIGITS}g}")
    display = quantity.unit.display
    return f"{drawn / parse_quantity(f'1 {display}', quantity.unit):.{_DIGITS}g} {display}"


def _share_of(prior: Factor, value: object) -> float:
    if prior.distribution is None:
        if value not in prior.values:
            raise InputError(f"{prior.key}: need one of {', '.join(map(str, prior.values))}, got {value}")
        return (prior.values.index(value) + 0.5) / len(prior.values)
    quantity = key_quantity(prior.key, prior.model)
    number = parse_quantity(value, quantity.unit) if quantity is not None else float(str(value))
    name, first, second = prior.distribution.name, prior.distribution.first, prior.distribution.second
    match name:
        case "normal":
            share = stats.norm.cdf(number, first, second)
        case "log-uniform":
            share = math.log(number / first) / math.log(second / first)
        case _:
            share = (number - first) / (second - first)
    return float(share)
