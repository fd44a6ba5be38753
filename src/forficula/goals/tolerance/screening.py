"""Which of many factors get indices of their own: those that decide beyond chance, and those that act with others."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.arrays import Flags, Indices
from forficula.goals.share_interval import LEVEL

Values = NDArray[np.float64]

# how many cosines over a factor are tried, and of how many at least is one factor's part
_COSINES, _PARTS = 4, (1, 2, 4)
_PERMUTATIONS = 199
# rows for each coefficient of the regression at least
_ROWS_PER_COEFFICIENT = 4
# of the factors that are kept one in so many is one that changes the margin most when it alone is exchanged
_RESERVED = 4
_MAP_AXES = 2


@dataclass(frozen=True, kw_only=True)
class Screening:
    """What few rows say of every factor.

    Attributes:
        shares: of the margin's variance that each factor decides alone, (factors,), below 0 by chance.
        resolved: which of these exceed chance: in all no more than one in twenty times one does that decides nothing.
        effects: share of the variance that has to do with each factor, alone and with others, from fewer rows.
        kept: numbers of the factors that get indices of their own.
    """

    shares: Values
    resolved: Flags
    effects: Values
    kept: tuple[int, ...]


def screening(points: Values, values: Values, effects: Values, kept: int, seed: int) -> Screening:
    """Choose the factors that get indices of their own.

    First those that decide something alone beyond chance, by `deciding_factors` from all rows, then those whose shares
    come next. Few rows of exchanged factors do not rank these: of a margin with a step, most of what eight rows say of
    a factor is chance. But they see factors that act only together with others: a quarter of the factors that are kept
    are those of the others with the largest effects.

    Args:
        points: independent rows in the unit cube, (rows, factors).
        values: of the margin, (rows,).
        effects: as of `Screening`, (factors,).
        kept: how many factors at most.
        seed: of the permutations.
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
    """Find which factors decide a share of a result's variance alone, beyond chance.

    Forward selection among cosines over each factor, by which the first-order index of Plischke (2010,
    doi:10.1016/j.ress.2009.11.005) is estimated from given points. One factor after another is added: that with the
    largest statistic, as long as it exceeds 95 of 100 of the largest ones of permuted residuals (Westfall and Young
    1993). What the factors so far explain is noise no more, so that weaker ones are found.

    Args:
        points: independent rows in the unit cube, (rows, factors).
        values: of the result, (rows,).
        seed: of the permutations.

    Returns:
        Shares of the variance, (factors,), and which of them exceed chance, (factors,).
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
    """An orthonormal basis of each factor's cosines beside what is known, (factors, rows, cosines)."""
    columns = np.moveaxis(cosines, 1, 0)
    return np.linalg.qr(columns - known @ (known.T @ columns))[0]


def _largest_parts(bases: Values, left: Values, scale: float) -> tuple[Values, Indices]:
    """The largest standardised part of what is left that a factor's first cosines explain, and of how many of them.

    Args:
        bases: of the factors.
        left: (rows,), or (rows, permutations).
        scale: its variance.

    Returns:
        (factors,), or (factors, permutations), both.
    """
    squares = np.cumsum(np.tensordot(bases, left, axes=(1, 0)) ** 2, axis=1) / (scale or 1.0)
    parts = np.array(_PARTS)
    sizes = np.stack([(squares[:, part - 1] - part) / np.sqrt(2 * part) for part in _PARTS])
    return np.max(sizes, axis=0), parts[np.argmax(sizes, axis=0)]


def _share(bases: Values, left: Values, scale: float, parts: Sequence[int] | Indices) -> Values:
    """The sum of squares that each factor's first cosines explain, less what they do by chance, (factors,)."""
    squares = np.cumsum(np.tensordot(bases, left, axes=(1, 0)) ** 2, axis=1)
    return np.array([squares[factor, part - 1] - part * scale for factor, part in enumerate(parts)])
