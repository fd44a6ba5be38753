"""Relaxation of Maxwell branches while they are extended or turned at a constant rate."""

from __future__ import annotations

import numpy as np

from forficula.arrays import Array

# nodes of the quadrature over a step, exact to 1e-9 up to steps of 20 relaxation times
_NODES = 16
# width below which a series of third order replaces a difference
_NARROW = 1e-2


def followed_share(time: Array, duration: Array | float) -> Array:
    """Return the share of its elastic force that a branch keeps of a constant ramp, in the common shape.

    The share is (1 - exp(-s)) / s with s = duration / time. It is also the mean of exp(-t / time) over the duration.
    """
    width = np.asarray(duration / time)
    return np.divide(-np.expm1(-width), width, out=np.ones_like(width), where=width > 0)


def working_share(time: Array, duration: Array | float) -> Array:
    """Return the slope of a spring that does the work of a branch in a ramp from rest, as a share of its stiffness.

    The work of the branch is stiffness turn^2 (1 - f) / s with s = duration / time and f of `followed_share`.
    """
    width = np.asarray(duration / time)
    # the series avoids the loss of digits at small widths, with an error of 1e-9
    series = 1 - width / 3 + width**2 / 12 - width**3 / 60
    return np.where(width > _NARROW, 2 * (1 - followed_share(time, duration)) / np.maximum(width, _NARROW), series)


def square_integrals(time: Array, duration: float) -> Array:
    """Compute the integrals of a^2, 2 a b and b^2 over a duration, (3, ...), in the shape of the times.

    The force of a branch that is extended at a constant rate is F0 a + F1 b with b = (1 - exp(-s / time)) /
    (1 - exp(-duration / time)) and a = exp(-s / time) - exp(-duration / time) b. Quadrature of positive numbers is
    used, because the closed forms lose all digits if the duration is far below the relaxation time.
    """
    nodes, weights = np.polynomial.legendre.leggauss(_NODES)
    share, width = (nodes.reshape(-1, *(1,) * time.ndim) + 1) / 2, duration / time
    late = np.expm1(-share * width) / np.expm1(-width)
    early = np.exp(-share * width) - np.exp(-width) * late
    products = (early * early, 2 * early * late, late * late)
    return np.array([np.tensordot(weights, product, axes=1) * duration / 2 for product in products])
