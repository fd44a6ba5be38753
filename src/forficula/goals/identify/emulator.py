"""Kriging emulator: prediction of a fact's quantity at values that were not run, with standard errors."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np
import scipy

from forficula.arrays import Array

# Hyperparameters come from grids, not from a gradient method, so that every machine chooses the same ones despite
# different rounding. Lengths are in sides of the unit cube, noise is a fraction of the variance.
_LENGTHS = (0.1, 0.2, 0.4, 0.8, 1.6, 3.2, 6.4)
_NOISES = (1e-6, 1e-4, 1e-2, 0.1, 0.5)
_START_LENGTH, _START_NOISE = 0.8, 1e-2
# largest number of sweeps over the grids, and the relative gain below which they end
_SWEEPS, _SETTLED = 3, 1e-6
# keeps matrices of columns without scatter, and variances after an exact fit, away from zero
_RIDGE, _LEAST_VARIANCE = 1e-10, 1e-12
# minimum number of samples per coefficient of the trend
_LEAST_PER_COEFFICIENT = 2
# fraction of leave-one-out errors that the predicted interval must contain; otherwise it is widened
_CHECKED_SHARE = 0.9


@dataclass(frozen=True, kw_only=True)
class Emulator:
    """Universal kriging with a linear trend and a Matern 5/2 correlation (Rasmussen and Williams 2006, chapters 2, 5).

    Attributes:
        points: samples in the unit cube, (samples, unknowns).
        lengths: correlation lengths, (unknowns,), sides of the cube.
        noise: variance of unexplained scatter, as a fraction of `variance`.
        trend: coefficients of 1 and each unknown, (1 + unknowns,).
        weights: weights of the samples' correlations in the mean, (samples,).
        factor: Cholesky factor of the correlations, (samples, samples), lower.
        whitened: basis of the trend, solved by the factor, (samples, 1 + unknowns).
        trend_factor: Cholesky factor of the trend's information, lower.
        variance: variance of the residual of the trend, scaled to the leave-one-out errors.
        freedom: degrees of freedom of the variance.
    """

    points: Array
    lengths: Array
    noise: float
    trend: Array
    weights: Array
    factor: Array
    whitened: Array
    trend_factor: Array
    variance: float
    freedom: int

    def predict(self, points: Array) -> tuple[Array, Array]:
        """Return mean and standard error of the quantity at points of the unit cube, (points,) both.

        Args:
            points: (points, unknowns).
        """
        across = _correlation(points, self.points, self.lengths)
        basis = _basis(points)
        mean = basis @ self.trend + across @ self.weights
        explained = scipy.linalg.solve_triangular(self.factor, across.T, lower=True)
        open_trend = scipy.linalg.solve_triangular(self.trend_factor, basis.T - self.whitened.T @ explained, lower=True)
        share = 1 + self.noise - np.sum(explained**2, axis=0) + np.sum(open_trend**2, axis=0)
        return mean, np.sqrt(self.variance * np.maximum(share, self.noise))


def least_samples(unknowns: int) -> int:
    """Return the minimum number of samples for an emulator."""
    return _LEAST_PER_COEFFICIENT * (unknowns + 1) + 2


def fit_emulator(points: Array, values: Array) -> Emulator | None:
    """Fit an emulator to a quantity of samples, by maximum likelihood on a grid of hyperparameters.

    The standard errors are widened if less than nine tenths of the samples lie within their 90 % interval in
    leave-one-out predictions (Dubrule 1983, doi:10.1007/BF01036250).

    Args:
        points: in the unit cube, (samples, unknowns).
        values: values of the quantity, (samples,), finite.

    Returns:
        The emulator; None with fewer than `least_samples`.
    """
    count, unknowns = points.shape
    if count < least_samples(unknowns):
        return None
    scale = float(np.std(values)) or 1.0
    lengths, noise = _likeliest(points, values / scale)
    best = _regression(points, values / scale, _squared(points), lengths, noise)
    weights = scipy.linalg.solve_triangular(best.factor.T, best.left, lower=False)
    errors = weights / np.sqrt(_precision(best) * best.variance)
    freedom = count - unknowns - 1
    widening = np.quantile(np.abs(errors), _CHECKED_SHARE) / scipy.stats.t.ppf((1 + _CHECKED_SHARE) / 2, freedom)
    return Emulator(
        points=points,
        lengths=lengths,
        noise=noise,
        trend=best.trend * scale,
        weights=weights * scale,
        factor=best.factor,
        whitened=best.whitened,
        trend_factor=best.trend_factor,
        variance=best.variance * scale**2 * max(float(widening), 1.0) ** 2,
        freedom=freedom,
    )


def _likeliest(points: Array, values: Array) -> tuple[Array, float]:
    """Return lengths and noise of the largest restricted likelihood, by coordinate search on their grids."""
    unknowns = points.shape[1]
    squared = _squared(points)
    lengths, noise = np.full(unknowns, _START_LENGTH), _START_NOISE
    best = _likelihood(_regression(points, values, squared, lengths, noise))
    for _ in range(_SWEEPS):
        before = best
        for axis, length in itertools.product(range(unknowns), _LENGTHS):
            tried = lengths.copy()
            tried[axis] = length
            if length != lengths[axis]:
                likelihood = _likelihood(_regression(points, values, squared, tried, noise))
                best, lengths = (likelihood, tried) if likelihood > best else (best, lengths)
        for other in _NOISES:
            if other != noise:
                likelihood = _likelihood(_regression(points, values, squared, lengths, other))
                best, noise = (likelihood, other) if likelihood > best else (best, noise)
        if best - before < _SETTLED * abs(before):
            break
    return lengths, noise


@dataclass(frozen=True, kw_only=True)
class _Regression:
    """A trend fitted by generalised least squares.

    Attributes:
        factor: Cholesky factor of the correlations, lower.
        whitened: basis of the trend, solved by the factor, (samples, coefficients).
        trend_factor: Cholesky factor of the trend's information, lower.
        trend: coefficients.
        left: residuals, solved by the factor, (samples,).
        variance: variance of the residuals.
    """

    factor: Array
    whitened: Array
    trend_factor: Array
    trend: Array
    left: Array
    variance: float


def _regression(points: Array, values: Array, squared: Array, lengths: Array, noise: float) -> _Regression:
    correlation = _matern(np.sqrt(squared @ lengths**-2.0)) + noise * np.eye(len(points))
    factor = scipy.linalg.cholesky(correlation, lower=True)
    solved = scipy.linalg.solve_triangular(factor, np.column_stack([_basis(points), values]), lower=True)
    whitened, target = solved[:, :-1], solved[:, -1]
    trend_factor = scipy.linalg.cholesky(whitened.T @ whitened + _RIDGE * np.eye(whitened.shape[1]), lower=True)
    trend = scipy.linalg.cho_solve((trend_factor, True), whitened.T @ target)
    left = target - whitened @ trend
    variance = max(float(left @ left) / (len(values) - whitened.shape[1]), _LEAST_VARIANCE)
    return _Regression(
        factor=factor, whitened=whitened, trend_factor=trend_factor, trend=trend, left=left, variance=variance
    )


def _likelihood(fitted: _Regression) -> float:
    """Return the logarithm of the restricted likelihood up to a constant."""
    count, coefficients = fitted.whitened.shape
    spread = np.sum(np.log(np.diag(fitted.factor))) + np.sum(np.log(np.diag(fitted.trend_factor)))
    return float(-0.5 * (count - coefficients) * np.log(fitted.variance) - spread)


def _precision(fitted: _Regression) -> Array:
    """Return the inverse variance of each sample's leave-one-out prediction, in units of the variance, (samples,)."""
    inverse = scipy.linalg.solve_triangular(fitted.factor, np.eye(len(fitted.factor)), lower=True)
    trend = scipy.linalg.solve_triangular(fitted.trend_factor, fitted.whitened.T @ inverse, lower=True)
    return np.asarray(np.maximum(np.sum(inverse**2, axis=0) - np.sum(trend**2, axis=0), _LEAST_VARIANCE))


def _squared(points: Array) -> Array:
    """Return squared distances along each side, (samples, samples, unknowns)."""
    return np.asarray((points[:, np.newaxis] - points) ** 2)


def _basis(points: Array) -> Array:
    return np.column_stack([np.ones(len(points)), points - 0.5])


def _correlation(one: Array, other: Array, lengths: Array) -> Array:
    return _matern(scipy.spatial.distance.cdist(one / lengths, other / lengths))


def _matern(distance: Array) -> Array:
    far = np.sqrt(5.0) * distance
    return np.asarray((1 + far + far**2 / 3) * np.exp(-far))
