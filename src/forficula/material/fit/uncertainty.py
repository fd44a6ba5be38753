"""How well data determine the values of a fit."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import scipy

from forficula.arrays import Array, Indices

_FEWEST_SPECIMENS = 3  # from which their scatter says something
_NAMED = 0.3  # of the largest part of the direction that the data leave open


def effective_points(residual: Array, specimen: Indices) -> float:
    """How many independent points a residual is worth.

    Neighbouring residuals of a tensile test are alike, so counting every row would make intervals far too narrow. The
    count is divided by the integrated autocorrelation time 1 + 2 sum rho, with rho the mean over specimens. The sum
    ends where rho first falls to 0 (after Geyer 1992, doi 10.1214/ss/1177011137): summed further, a misfit that
    returns with every cycle would cancel itself and pass for noise.

    Args:
        residual: shape (points,).
        specimen: index of the specimen of each point, shape (points,), in order.

    Returns:
        Between 1 and the number of points.
    """
    pieces = [residual[specimen == index] for index in np.unique(specimen)]
    longest = max(len(piece) for piece in pieces)
    covariance = np.zeros(longest)
    for piece in pieces:
        spectrum = np.fft.rfft(piece, 2 * len(piece))
        covariance[: len(piece)] += np.fft.irfft(np.abs(spectrum) ** 2)[: len(piece)]
    if covariance[0] == 0:
        return float(len(residual))
    crossings = np.flatnonzero(covariance <= 0)
    last = crossings[0] if len(crossings) else longest
    time = 2 * float(np.sum(covariance[:last])) / covariance[0] - 1
    return float(len(residual) / np.clip(time, 1.0, len(residual)))


def undetermined(sensitivity: Array, keys: Sequence[str], limit: float) -> tuple[str, ...]:
    """The values that data do not determine.

    Args:
        sensitivity: derivatives of the fitted points, shape (points, values).
        keys: of the values; the baseline's may be left out at the end.
        limit: largest ratio of the singular values of the sensitivity with columns of length 1.

    Returns:
        Keys whose own column is 0, or else those that make up the direction that the data leave open.
    """
    norms = np.linalg.norm(sensitivity, axis=0)
    idle = [key for key, norm in zip(keys, norms, strict=False) if norm == 0]
    if idle or np.any(norms == 0):
        return tuple(idle) or tuple(keys)
    unit = sensitivity / norms
    # of the normal matrix: its values are squares, and rise
    squares, directions = np.linalg.eigh(unit.T @ unit)
    if squares[-1] <= limit**2 * squares[0]:
        return ()
    parts = np.abs(directions[:, 0])
    return tuple(key for key, part in zip(keys, parts, strict=False) if part > _NAMED * parts.max()) or tuple(keys)


def half_widths(sensitivity: Array, residual: Array, specimen: Indices) -> Array:
    """Half of the 95 % confidence intervals of the values of a least-squares fit.

    From the sensitivity, with the variance of the residual spread over its `effective_points`. With three or more
    specimens also from their scatter (the covariance robust to clusters, one for each specimen, with Student's t for
    their number less 1; Cameron and Miller 2015, doi 10.3368/jhr.50.2.317); the wider one holds.

    Args:
        sensitivity: derivatives of the fitted points, shape (points, values).
        residual: shape (points,).
        specimen: index of the specimen of each point, shape (points,), in order.

    Returns:
        Shape (values,), in the values' units.
    """
    count = sensitivity.shape[1]
    norms = np.linalg.norm(sensitivity, axis=0)
    unit = sensitivity / norms
    inverse = np.linalg.inv(unit.T @ unit)
    effective = effective_points(residual, specimen)
    freedom = max(effective - count, 1.0)
    # mean square by freedom, and by as many more points as are alike
    variance = float(residual @ residual) / freedom
    widths = scipy.special.stdtrit(freedom, 0.975) * np.sqrt(variance * np.diag(inverse))
    specimens = np.unique(specimen)
    if len(specimens) >= _FEWEST_SPECIMENS:
        scores = np.array([unit[specimen == index].T @ residual[specimen == index] for index in specimens])
        few = len(specimens) / (len(specimens) - 1)
        scatter = few * np.diag(inverse @ scores.T @ scores @ inverse)
        widths = np.maximum(
            widths, scipy.special.stdtrit(len(specimens) - 1, 0.975) * np.sqrt(np.maximum(scatter, 0.0))
        )
    return np.asarray(widths / norms)


def mean_half_width(values: Array) -> float:
    """Half of the 95 % confidence interval of the mean of a population, by Student's t.

    Args:
        values: of a sample, shape (specimens,).

    Returns:
        In the values' unit; 0 where one specimen tells nothing of others.
    """
    count = len(values)
    if count == 1:
        return 0.0
    return float(scipy.special.stdtrit(count - 1, 0.975) * np.std(values, ddof=1) / np.sqrt(count))
