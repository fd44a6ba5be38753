"""Softening of rubber-like materials after their first stretch: the Mullins effect."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import ArrayLike

from forficula.arrays import Array
from forficula.errors import InputError

Triple = tuple[float, float, float]

_CURVE_POINTS = 201


@dataclass(frozen=True, kw_only=True)
class OgdenRoxburgh:
    """Softening of a material below the largest strain reached so far.

    The stress of the virgin curve is multiplied by eta = 1 - erf((Wmax - W) / (m + beta Wmax)) / r, where W is the
    strain energy per volume of the virgin curve and Wmax its largest previous value (Ogden and Roxburgh 1999,
    doi 10.1098/rspa.1999.0431, with beta as in common finite-element codes). On the virgin curve eta is 1.

    Attributes:
        r: 1/r is the largest share of the stress that is lost; >= 1.
        m: constant part of the energy scale, J/m^3, >= 0.
        beta: share of Wmax in the energy scale, >= 0; m and beta are not both 0.

    Raises:
        InputError: a number out of these bounds or not finite.
    """

    r: float
    m: float
    beta: float = 0.0

    def __post_init__(self) -> None:
        for name, least in (("r", 1.0), ("m", 0.0), ("beta", 0.0)):
            value = getattr(self, name)
            if not (np.isfinite(value) and value >= least):
                raise InputError(f"softening.{name}: need a finite number >= {least:g}, got {value:g}")
        if self.m == self.beta == 0:
            raise InputError("softening.m: need m or beta > 0, got 0 for both")

    def share(self, largest: ArrayLike, energy: ArrayLike) -> Array:
        """Compute eta, the remaining share of the virgin curve's stress.

        Args:
            largest: Wmax, J/m^3.
            energy: W <= Wmax, J/m^3, of a shape that broadcasts with `largest`.

        Returns:
            Values between 1 - 1/r and 1, in the common shape.
        """
        most, current = np.asarray(largest, dtype=np.float64), np.asarray(energy, dtype=np.float64)
        width = self.m + self.beta * most
        # for a virgin, unloaded material with m = 0 this is 0/0, and eta is 1
        depth = np.divide(
            most - current, width, out=np.zeros(np.broadcast_shapes(most.shape, current.shape)), where=width > 0
        )
        return np.asarray(1 - scipy.special.erf(depth) / self.r)


def spring_stress(moduli: Triple, strain: ArrayLike) -> Array:
    """Compute the stress of the elastic curve, E1 e + E2 e^2 + E3 e^3 for e > 0, else 0, Pa, in the strain's shape."""
    e = np.maximum(np.asarray(strain, dtype=np.float64), 0.0)
    return np.asarray(e * (moduli[0] + e * (moduli[1] + e * moduli[2])))


def spring_energy(moduli: Triple, strain: ArrayLike) -> Array:
    """Compute the energy per volume under the elastic curve, J/m^3, in the strain's shape."""
    e = np.maximum(np.asarray(strain, dtype=np.float64), 0.0)
    return np.asarray(e**2 * (moduli[0] / 2 + e * (moduli[1] / 3 + e * moduli[2] / 4)))


def softened_moduli(moduli: Triple, softening: OgdenRoxburgh, peak: float) -> tuple[Triple, float]:
    """Approximate the softened curve, below a strain that was reached before, by a polynomial for simulation.

    The fit is by least squares over strains from 0 to the peak. If the best polynomial would push, the best one without
    negative terms is used.

    Args:
        moduli: moduli of the virgin curve, Pa.
        softening: softening of the material.
        peak: largest previous strain, > 0.

    Returns:
        The moduli, Pa, and the largest error of the stress as a share of the stress at the peak.

    Raises:
        InputError: the peak is not > 0.
    """
    if not (np.isfinite(peak) and peak > 0):
        raise InputError(f"peak: need a strain > 0, got {peak:g}")
    strain = np.linspace(0, peak, _CURVE_POINTS)
    energy = spring_energy(moduli, strain)
    stress = softening.share(energy[-1], energy) * spring_stress(moduli, strain)
    powers = np.stack([(strain / peak) ** power for power in (1, 2, 3)], axis=1)
    terms = np.linalg.lstsq(powers, stress, rcond=None)[0]
    if not pulls(*terms):
        terms = scipy.optimize.nnls(powers, stress)[0]
    error = float(np.max(np.abs(powers @ terms - stress)) / max(stress[-1], np.finfo(float).tiny))
    first, second, third = (float(term / peak**power) for power, term in enumerate(terms, start=1))
    return (first, second, third), error


def pulls(first: float, second: float, third: float) -> bool:
    """Return whether a polynomial without constant term is >= 0 at every positive strain."""
    return bool(first >= 0 and third >= 0 and (second >= 0 or second**2 < 4 * first * third))
