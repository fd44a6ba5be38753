"""Shape of a slack strap between its pegs: the elastica with hinged ends."""

from __future__ import annotations

import math

import numpy as np
import scipy
from numpy.typing import NDArray

# a strap is straight above this ratio of distance to length
_STRAIGHT = 1 - 1e-9


def elastica(length: float, apart: float, points: int = 33) -> NDArray[np.float64]:
    """Return evenly spaced points on an elastica with hinged ends, m, (point, 2).

    The first is at the origin and the last on the first axis; it bows towards the second axis. With the parameter m
    that solves 2 E(m) / K(m) - 1 = apart / length, and u from -K to K: x = (2 E(am u, m) - u) length / (2 K) and y =
    sqrt(m) cn(u, m) length / K (Love 1927, A Treatise on the Mathematical Theory of Elasticity, article 263).

    Args:
        length: along the strap, m.
        apart: distance of the ends, m, >= 0; if it is the length or more, the strap is straight.
        points: number of points.
    """
    share = max(0.0, apart) / length
    if share >= _STRAIGHT:
        straight = np.zeros((points, 2))
        straight[:, 0] = np.linspace(0.0, apart, points)
        return straight
    # m is 0.8261 if both ends coincide; with a larger m they would pass each other
    parameter = float(
        scipy.optimize.brentq(lambda m: 2 * scipy.special.ellipe(m) / scipy.special.ellipk(m) - 1 - share, 0.0, 0.9)
    )
    quarter = float(scipy.special.ellipk(parameter))
    u = np.linspace(-quarter, quarter, points)
    sine, cosine, delta, _ = scipy.special.ellipj(u, parameter)
    # Carlson's forms are used, because SciPy's incomplete integral is wrong at single amplitudes, by 0.1 at -0.729 for
    # m = 0.698
    squares = (cosine**2, delta**2, 1.0)
    second = sine * scipy.special.elliprf(*squares) - parameter / 3 * sine**3 * scipy.special.elliprd(*squares)
    along = (2 * second - u) * length / (2 * quarter)
    return np.column_stack([along - along[0], math.sqrt(parameter) * cosine * length / quarter])
