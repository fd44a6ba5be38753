"""Sobol indices: fractions of a result's variance that factors explain, with confidence intervals."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray

from forficula.arrays import Flags
from forficula.goals.binomial_interval import LEVEL

Values = NDArray[np.float64]

# A scatter below this fraction of the largest value is rounding.
_ROUNDING = 1e-12
_RESAMPLES = 999


@dataclass(frozen=True, kw_only=True)
class Indices:
    """Fractions of the variance of every result, each (results, groups); NaN for a result that does not vary.

    Attributes:
        results: names of the results.
        groups: names of the factors or groups of factors.
        first: first-order index: fraction of the variance that would vanish if the group's values were known.
        first_low: lower ends of the 95 % intervals, as all below.
        first_high: upper ends.
        total: total index, including interactions: fraction that would remain if all other values were known.
        total_low: lower ends.
        total_high: upper ends.
        leads: fraction of the resamplings in which each group's index is the largest of the compared ones. The total
            index is used, or the first-order one if there is no total one.
        rows: points of each sample from which the indices were computed.
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

    First-order indices are computed by Saltelli et al. (2010, doi:10.1016/j.cpc.2009.09.018), total ones by Jansen
    (1999, doi:10.1016/S0010-4655(98)00154-4), with scipy. The intervals are percentiles of resampled rows.

    Args:
        results: names of the results.
        groups: names of the factors or groups.
        at_first: results at the first sample, (results, rows); the number of rows is a power of two.
        at_second: results at the second sample, same shape.
        at_mixed: results at the first sample with a group's columns of the second, (groups, results, rows).
        seed: seed of the resampling.
        compared: `leads` compares the first groups, up to this number; by default all.

    Raises:
        ValueError: a result that is not finite, for which scipy would silently return zeros.
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
    constant = ~_varies(at_first, at_second)
    leads = _leads(resampled[:, 1], compared)
    for values in (first, total, first_low, first_high, total_low, total_high, leads):
        values[constant] = np.nan
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
    """Estimate from one sample the fraction of a result's variance that a linear function of each factor explains.

    All factors are fitted at once by least squares, because the columns of few points are correlated. The square of
    each slope is reduced by that of its standard error, its expected value by chance. For a sum of linear functions the
    result is the first-order index. A single sample gives no total indices. All indices are NaN if there are fewer rows
    than twice the number of unknowns.

    Args:
        results: names of the results.
        groups: names of the factors.
        points: one sample, (rows, factors).
        at_points: results, (results, rows).
        seed: seed of the resampling.

    Raises:
        ValueError: a result that is not finite.
    """
    _check_finite(results, at_points, "the sample")
    rows, factors = points.shape
    unknown = np.full((len(results), factors), np.nan)
    first, low, high, leads = (unknown.copy() for _ in range(4))
    if enough_for_linear_fit(rows, factors):
        first = _plane_shares(points, at_points)
        picks = np.random.default_rng(seed).integers(rows, size=(_RESAMPLES, rows))
        resampled = np.array([_plane_shares(points[pick], at_points[:, pick]) for pick in picks])
        low, high = np.quantile(resampled, [(1 - LEVEL) / 2, (1 + LEVEL) / 2], axis=0)
        leads = _leads(resampled)
    constant = ~_varies(at_points, at_points)
    for values in (first, low, high, leads):
        values[constant] = np.nan
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
    """Return the fraction of resamplings, (resamplings, results, groups), in which each group has the largest index."""
    leads = np.zeros((resampled.shape[1], resampled.shape[2]))
    largest = np.argmax(resampled[:, :, :compared], axis=2)
    for group in range(leads.shape[1]):
        leads[:, group] = np.mean(largest == group, axis=0)
    return leads


def enough_for_linear_fit(rows: int, factors: int) -> bool:
    """Return whether there are enough points to fit a linear function of this number of factors."""
    return rows >= 2 * (factors + 1)


def _plane_shares(points: Values, at_points: Values) -> Values:
    """Return the variance explained by each slope minus that by chance, (results, factors); 0 if nothing varies."""
    rows, factors = points.shape
    plane = np.column_stack([np.ones(rows), points - np.mean(points, axis=0)])
    inverse = np.linalg.pinv(plane)
    slopes = inverse @ at_points.T
    left = np.sum((at_points.T - plane @ slopes) ** 2, axis=0) / (rows - factors - 1)
    chance = np.outer(np.sum(inverse**2, axis=1), left)
    shares = (slopes**2 - chance)[1:] * np.var(points, axis=0)[:, np.newaxis]
    # for independent factors; the columns of few points are not quite independent
    variance = np.maximum(np.sum(shares, axis=0), 0.0) + left
    return np.asarray(np.divide(shares, variance, out=np.zeros_like(shares), where=variance > 0).T)


def total_effects(at_first: Values, at_mixed: Values, steps: Values) -> Values:
    """Estimate from few rows the variance of a result that involves each factor, for screening.

    The estimate is half the mean squared change when one factor is exchanged (Jansen 1999), over radial steps
    (Campolongo, Saltelli & Cariboni 2011, doi:10.1016/j.cpc.2010.12.039). Unlike a derivative, it includes
    interactions. It is divided by the ratio of the mean squared steps of these rows to their expected value, so it is
    exact for a linear function.

    Args:
        at_first: a result at the first sample, (rows,).
        at_mixed: the result with one factor exchanged, (factors, rows).
        steps: change of the exchanged coordinate in the unit cube, (factors, rows).

    Returns:
        (factors,), the square of the result's unit.
    """
    # the mean squared difference of two independent uniform numbers is 1/6
    return np.asarray(np.mean((at_mixed - at_first) ** 2, axis=1) / np.mean(steps**2, axis=1) / 12)


def _estimates(at_first: Values, at_second: Values, at_mixed: Values) -> tuple[Values, Values]:
    """Return first-order and total indices, (results, groups) each."""
    # one more group without effect, because scipy drops the axis of a single group
    padded = np.concatenate([at_mixed, at_first[np.newaxis]])
    scipy_indices = scipy.stats.sobol_indices(
        func={"f_A": at_first, "f_B": at_second, "f_AB": padded}, n=at_first.shape[1]
    )
    shape = (len(at_first), len(padded))
    return scipy_indices.first_order.reshape(shape)[:, :-1], scipy_indices.total_order.reshape(shape)[:, :-1]


def _check_finite(results: Sequence[str], values: Values, where: str) -> None:
    for result, row in zip(results, values, strict=True):
        if not np.isfinite(row).all():
            index = int(np.flatnonzero(~np.isfinite(row))[0])
            raise ValueError(f"{result}: need finite results, got {row[index]} at point {index} of {where}")


def _varies(at_first: Values, at_second: Values) -> Flags:
    both = np.concatenate([at_first, at_second], axis=1)
    return np.asarray(np.std(both, axis=1) > _ROUNDING * np.max(np.abs(both), axis=1))
