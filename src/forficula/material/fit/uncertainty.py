"""Uncertainty of the values of a fit: confidence intervals, and values that the data do not determine."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import scipy

from forficula.arrays import Array, Indices

_FEWEST_SPECIMENS = 3  # least number of specimens whose scatter is used
_NAMED = 0.3  # least component of a named value in the undetermined direction, as a share of the largest component


def effective_points(residual: Array, specimen: Indices) -> float:
    """Compute the effective number of independent points of a residual.

    Neighbouring residuals of a tensile test are correlated, so counting every row would make intervals far too narrow.
    The number of points is divided by the integrated autocorrelation time 1 + 2 sum rho, with rho averaged over
    specimens. The sum ends where rho first falls to 0 (after Geyer 1992, doi 10.1214/ss/1177011137); with more terms, a
    misfit that recurs in every cycle would cancel out and look like noise.

    Args:
        residual: shape (points,).
        specimen: index of the specimen of each point, shape (points,), in order.

    Returns:
        A number between 1 and the number of points.
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
    """Return the keys of values that the data do not determine.

    Args:
        sensitivity: derivatives of the fitted points, shape (points, values).
        keys: keys of the values; those of the baseline, at the end, may be left out.
        limit: largest allowed ratio of the singular values of the sensitivity with columns of length 1.

    Returns:
        Keys whose column is 0, or else the keys with large components in the undetermined direction.
    """
    norms = np.linalg.norm(sensitivity, axis=0)
    idle = [key for key, norm in zip(keys, norms, strict=False) if norm == 0]
    if idle or np.any(norms == 0):
        return tuple(idle) or tuple(keys)
    unit = sensitivity / norms
    # eigenvalues of the normal matrix are the squares of the singular values, in ascending order
    squares, directions = np.linalg.eigh(unit.T @ unit)
    if squares[-1] <= limit**2 * squares[0]:
        return ()
    components = np.abs(directions[:, 0])
    least = _NAMED * components.max()
    return tuple(key for key, part in zip(keys, components, strict=False) if part > least) or tuple(keys)


def half_widths(sensitivity: Array, residual: Array, specimen: Indices) -> Array:
    """Compute half of the 95 % confidence intervals of the values of a least-squares fit.

    The interval follows from the sensitivity, with the variance of the residual for its `effective_points`. With three
    or more specimens, a second interval follows from their scatter (cluster-robust covariance with one cluster for each
    specimen and Student's t for their number minus 1; Cameron and Miller 2015, doi 10.3368/jhr.50.2.317). The wider
    interval is returned.

    Args:
        sensitivity: derivatives of the fitted points, shape (points, values).
        residual: shape (points,).
        specimen: index of the specimen of each point, shape (points,), in order.

    Returns:
        Half-widths, shape (values,), in the values' units.
    """
    count = sensitivity.shape[1]
    norms = np.linalg.norm(sensitivity, axis=0)
    unit = sensitivity / norms
    inverse = np.linalg.inv(unit.T @ unit)
    effective = effective_points(residual, specimen)
    freedom = max(effective - count, 1.0)
    # sum of squares divided by the effective degrees of freedom
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
    """Compute half of the 95 % confidence interval of the mean of a population, by Student's t.

    Args:
        values: values of a sample, shape (specimens,).

    Returns:
        Half-width in the values' unit; 0 for a single specimen, which gives no information about scatter.
    """
    count = len(values)
    if count == 1:
        return 0.0
    return float(scipy.special.stdtrit(count - 1, 0.975) * np.std(values, ddof=1) / np.sqrt(count))
