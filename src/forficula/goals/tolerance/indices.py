"""Sobol indices: which share of a result's variance is whose, with intervals."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray

from forficula.arrays import Flags
from forficula.goals.share_interval import LEVEL

Values = NDArray[np.float64]

# Below this share of the largest value, a scatter is rounding.
_ROUNDING = 1e-12
_RESAMPLES = 999


@dataclass(frozen=True, kw_only=True)
class Indices:
    """Shares of the variance of every result, each (results, groups); NaN of a result that does not vary.

    Attributes:
        results: what they are called.
        groups: what the factors, or groups of them, are called.
        first: what a group decides alone: the share of variance that would go if its values were known.
        first_low: lower ends of the 95 % intervals, as all below.
        first_high: upper ends.
        total: what it decides alone and together with others: the share that would stay if all others were known.
        total_low: lower ends.
        total_high: upper ends.
        leads: share of the resamplings in which each group's index is the largest of those that are compared: the total
            one, or the first-order one where there are no total ones.
        rows: points of each sample that they come from.
    """

    results: tuple[str, ...]
    groups: tuple[str, ...]
    first: Values
    first_low: Values
    first_high: Values
    total: Values
    total_low: Values
    total_high: Values
    leads: Values
    rows: int


def sobol_indices(
    results: Sequence[str],
    groups: Sequence[str],
    at_first: Values,
    at_second: Values,
    at_mixed: Values,
    seed: int,
    compared: int | None = None,
) -> Indices:
    """Estimate first-order and total indices from results at two samples and at mixtures of them.

    First-order indices by Saltelli et al. (2010, doi:10.1016/j.cpc.2009.09.018), total ones by Jansen (1999,
    doi:10.1016/S0010-4655(98)00154-4), as scipy has them; the intervals are percentiles of resampled rows.

    Args:
        results: what the results are called.
        groups: what the factors or groups are called.
        at_first: results at the first sample, (results, rows); rows a power of two.
        at_second: at the second one, alike.
        at_mixed: at the first one with a group's columns of the second, (groups, results, rows).
        seed: of the resampling.
        compared: how many groups, from the first on, are compared with one another in `leads`; all where not given.

    Raises:
        ValueError: a result that is not finite, and which; scipy would give zeros without a word.
    """
    _check_finite(results, at_first, "the first sample")
    _check_finite(results, at_second, "the second sample")
    for group, values in zip(groups, at_mixed, strict=True):
        _check_finite(results, values, f"the points with {group} exchanged")
    rows = at_first.shape[1]
    first, total = _estimates(at_first, at_second, at_mixed)
    picks = np.random.default_rng(seed).integers(rows, size=(_RESAMPLES, rows))
    resampled = np.array([_estimates(at_first[:, pick], at_second[:, pick], at_mixed[:, :, pick]) for pick in picks])
    (first_low, total_low), (first_high, total_high) = np.quantile(
        resampled, [(1 - LEVEL) / 2, (1 + LEVEL) / 2], axis=0
    )
    still = ~_varies(at_first, at_second)
    leads = _leads(resampled[:, 1], compared)
    for values in (first, total, first_low, first_high, total_low, total_high, leads):
        values[still] = np.nan
    return Indices(
        results=tuple(results),
        groups=tuple(groups),
        first=first,
        first_low=first_low,
        first_high=first_high,
        total=total,
        total_low=total_low,
        total_high=total_high,
        leads=leads,
        rows=rows,
    )


def line_indices(
    results: Sequence[str], groups: Sequence[str], points: Values, at_points: Values, seed: int
) -> Indices:
    """Estimate which share of a result's variance a straight line over each factor has, where there is no more time.

    From a plane over all factors at once, by least squares, for columns of few points are correlated; the square
    of each slope less that of its standard error, which is what it is by chance. Of a sum of straight lines it is the
    first-order index. There are no total indices from one sample, and NaN everywhere of fewer rows than twice the
    unknowns of the plane.

    Args:
        results: what the results are called.
        groups: what the factors are called.
        points: one sample, (rows, factors).
        at_points: results, (results, rows).
        seed: of the resampling.

    Raises:
        ValueError: a result that is not finite, and which.
    """
    _check_finite(results, at_points, "the sample")
    rows, factors = points.shape
    unknown = np.full((len(results), factors), np.nan)
    first, low, high, leads = (unknown.copy() for _ in range(4))
    if tells_lines(rows, factors):
        first = _plane_shares(points, at_points)
        picks = np.random.default_rng(seed).integers(rows, size=(_RESAMPLES, rows))
        resampled = np.array([_plane_shares(points[pick], at_points[:, pick]) for pick in picks])
        low, high = np.quantile(resampled, [(1 - LEVEL) / 2, (1 + LEVEL) / 2], axis=0)
        leads = _leads(resampled)
    still = ~_varies(at_points, at_points)
    for values in (first, low, high, leads):
        values[still] = np.nan
    return Indices(
        results=tuple(results),
        groups=tuple(groups),
        first=first,
        first_low=low,
        first_high=high,
        total=unknown,
        total_low=unknown,
        total_high=unknown,
        leads=leads,
        rows=rows,
    )


def _leads(resampled: Values, compared: int | None = None) -> Values:
    """The share of resamplings, (resamplings, results, groups), in which each group has the largest index."""
    leads = np.zeros((resampled.shape[1], resampled.shape[2]))
    largest = np.argmax(resampled[:, :, :compared], axis=2)
    for group in range(leads.shape[1]):
        leads[:, group] = np.mean(largest == group, axis=0)
    return leads


def tells_lines(rows: int, factors: int) -> bool:
    """Whether so many points tell a plane over so many factors from chance."""
    return rows >= 2 * (factors + 1)


def _plane_shares(points: Values, at_points: Values) -> Values:
    """The share of each factor's slope less what it is by chance, (results, factors); 0 where nothing varies."""
    rows, factors = points.shape
    plane = np.column_stack([np.ones(rows), points - np.mean(points, axis=0)])
    inverse = np.linalg.pinv(plane)
    slopes = inverse @ at_points.T
    left = np.sum((at_points.T - plane @ slopes) ** 2, axis=0) / (rows - factors - 1)
    chance = np.outer(np.sum(inverse**2, axis=1), left)
    shares = (slopes**2 - chance)[1:] * np.var(points, axis=0)[:, np.newaxis]
    # of independent factors, which columns of few points are not quite
    variance = np.maximum(np.sum(shares, axis=0), 0.0) + left
    return np.asarray(np.divide(shares, variance, out=np.zeros_like(shares), where=variance > 0).T)


def total_effects(at_first: Values, at_mixed: Values, steps: Values) -> Values:
    """Estimate from few rows the variance of a result that has to do with each factor, for screening.

    Half the mean squared change as one factor is exchanged (Jansen 1999) over radial steps (Campolongo, Saltelli &
    Cariboni 2011, doi:10.1016/j.cpc.2010.12.039): unlike a derivative it sees what a factor does only together with
    others. It is divided by what the steps of these rows are by chance off those of many, so that it is exact for a
    linear function.

    Args:
        at_first: a result at the first sample, (rows,).
        at_mixed: with one factor exchanged, (factors, rows).
        steps: of the exchanged factor's share, (factors, rows).

    Returns:
        (factors,), the square of the result's unit.
    """
    # two independent uniform shares are 1/6 apart in the mean of squares
    return np.asarray(np.mean((at_mixed - at_first) ** 2, axis=1) / np.mean(steps**2, axis=1) / 12)


def _estimates(at_first: Values, at_second: Values, at_mixed: Values) -> tuple[Values, Values]:
    """First-order and total indices, (results, groups) each."""
    # a group that changes nothing keeps scipy from dropping the axis of a single one
    padded = np.concatenate([at_mixed, at_first[np.newaxis]])
    found = scipy.stats.sobol_indices(func={"f_A": at_first, "f_B": at_second, "f_AB": padded}, n=at_first.shape[1])
    shape = (len(at_first), len(padded))
    return found.first_order.reshape(shape)[:, :-1], found.total_order.reshape(shape)[:, :-1]


def _check_finite(results: Sequence[str], values: Values, where: str) -> None:
    for result, row in zip(results, values, strict=True):
        if not np.isfinite(row).all():
            place = int(np.flatnonzero(~np.isfinite(row))[0])
            raise ValueError(f"{result}: need finite results, got {row[place]} at point {place} of {where}")


def _varies(at_first: Values, at_second: Values) -> Flags:
    both = np.concatenate([at_first, at_second], axis=1)
    return np.asarray(np.std(both, axis=1) > _ROUNDING * np.max(np.abs(both), axis=1))
