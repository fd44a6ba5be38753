"""Screening: which factors get indices of their own, because they act significantly alone or in interactions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.arrays import Flags, Indices
from forficula.goals.binomial_interval import LEVEL

Values = NDArray[np.float64]

# number of cosines over a factor that are tried, and the numbers of cosines that one part may have
_COSINES, _PARTS = 4, (1, 2, 4)
_PERMUTATIONS = 199
# smallest number of rows per coefficient of the regression
_ROWS_PER_COEFFICIENT = 4
# one in this many kept factors is chosen by the change of the margin when it alone is exchanged
_RESERVED = 4
_MAP_AXES = 2


@dataclass(frozen=True, kw_only=True)
class Screening:
    """Result of the screening, from few rows.

    Attributes:
        shares: fraction of the margin's variance that each factor alone explains, (factors,); may be below 0 by chance.
        resolved: which of these are significant: with a probability of 95 %, no factor without effect is among them.
        effects: fraction of the variance that involves each factor, including interactions, from fewer rows.
        kept: indices of the factors that get indices of their own.
    """

    shares: Values
    resolved: Flags
    effects: Values
    kept: tuple[int, ...]


def screening(points: Values, values: Values, effects: Values, kept: int, seed: int) -> Screening:
    """Choose the factors that get indices of their own.

    First come those that are significant alone by `deciding_factors` from all rows, then those with the next largest
    fractions. Few rows of exchanged factors cannot rank these: for a margin with a step, most of the effect estimated
    from eight rows is chance. But such rows detect factors that act only in interactions. Therefore a quarter of the
    kept factors are the remaining ones with the largest effects.

    Args:
        points: independent rows in the unit cube, (rows, factors).
        values: values of the margin, (rows,).
        effects: see `Screening`, (factors,).
        kept: largest number of factors.
        seed: seed of the permutations.
    """
    shares, resolved = deciding_factors(points, values, seed)
    by_share = np.argsort(-shares, kind="stable").tolist()
    # what changes the margin in no row where it is exchanged needs no rows of its own, unless it decides beyond chance
    alone = [factor for factor in by_share if resolved[factor]]
    alone += [factor for factor in by_share if not resolved[factor] and effects[factor] > 0]
    chosen = alone[: kept - kept // _RESERVED]
    others = [factor for factor in np.argsort(-effects, kind="stable").tolist() if factor not in chosen]
    wanted = max(int(np.sum(effects[others] > 0)), _MAP_AXES - len(chosen))
    chosen += others[: min(wanted, kept - len(chosen))]
    return Screening(shares=shares, resolved=resolved, effects=effects, kept=tuple(chosen))


def deciding_factors(points: Values, values: Values, seed: int) -> tuple[Values, Flags]:
    """Find the factors that significantly explain a fraction of a result's variance alone.

    The method is forward selection among cosines over each factor, with which the first-order index of Plischke (2010,
    doi:10.1016/j.ress.2009.11.005) is estimated from given points. Factors are added one after another: the one with
    the largest statistic, as long as it exceeds the 95 % quantile of the largest statistics of permuted residuals
    (Westfall and Young 1993). Variance that earlier factors explain is no longer noise, so weaker factors can be found.

    Args:
        points: independent rows in the unit cube, (rows, factors).
        values: values of the result, (rows,).
        seed: seed of the permutations.

    Returns:
        Fractions of the variance, (factors,), and whether each is significant, (factors,).
    """
    rows, factors = points.shape
    generator = np.random.default_rng(seed)
    left = values - np.mean(values)
    total = float(left @ left)
    shares, resolved = np.zeros(factors), np.zeros(factors, dtype=bool)
    if total <= 0 or rows < _ROWS_PER_COEFFICIENT * 2:
        return shares, resolved
    known, open_ = np.full((rows, 1), rows**-0.5), list(range(factors))
    cosines = np.cos(np.pi * points[:, :, np.newaxis] * np.arange(1, _COSINES + 1))
    while open_:
        bases = _bases(cosines[:, open_], known)
        scale = float(left @ left) / (rows - known.shape[1])
        sizes, parts = _largest_parts(bases, left, scale)
        shares[open_] = _share(bases, left, scale, parts) / total
        permuted = generator.permuted(np.tile(left, (_PERMUTATIONS, 1)), axis=1).T
        chance = np.max(_largest_parts(bases, permuted, scale)[0], axis=0)
        best = int(np.argmax(sizes))
        if scale <= 0 or sizes[best] <= np.quantile(chance, LEVEL):
            break
        if known.shape[1] + parts[best] > rows / _ROWS_PER_COEFFICIENT:
            break
        basis = bases[best][:, : parts[best]]
        left = left - basis @ (basis.T @ left)
        known = np.column_stack([known, basis])
        resolved[open_.pop(best)] = True
    return shares, resolved


def _bases(cosines: Values, known: Values) -> Values:
    """Return an orthonormal basis of each factor's cosines, orthogonal to `known`, (factors, rows, cosines)."""
    columns = np.moveaxis(cosines, 1, 0)
    return np.linalg.qr(columns - known @ (known.T @ columns))[0]


def _largest_parts(bases: Values, left: Values, scale: float) -> tuple[Values, Indices]:
    """Return the largest standardised part of the residual that a factor's first cosines explain, and their number.

    Args:
        bases: bases of the factors.
        left: residual, (rows,) or (rows, permutations).
        scale: variance of the residual.

    Returns:
        (factors,), or (factors, permutations), both.
    """
    squares = np.cumsum(np.tensordot(bases, left, axes=(1, 0)) ** 2, axis=1) / (scale or 1.0)
    parts = np.array(_PARTS)
    sizes = np.stack([(squares[:, part - 1] - part) / np.sqrt(2 * part) for part in _PARTS])
    return np.max(sizes, axis=0), parts[np.argmax(sizes, axis=0)]


def _share(bases: Values, left: Values, scale: float, parts: Sequence[int] | Indices) -> Values:
    """Return the sum of squares that each factor's first cosines explain, minus its value by chance, (factors,)."""
    squares = np.cumsum(np.tensordot(bases, left, axes=(1, 0)) ** 2, axis=1)
    return np.array([squares[factor, part - 1] - part * scale for factor, part in enumerate(parts)])
