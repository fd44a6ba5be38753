"""What a material law does: stress of a strain history, moduli and loss of a sinusoid."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from forficula.errors import InputError
from forficula.material.law.material_law import MaterialLaw, MaxwellBranch, known_moduli, require
from forficula.material.law.softening import Triple, softened_stress, spring_stress

Array = NDArray[np.float64]

_NOTHING = 1e-30  # share of a stress that is left and counts no more


@dataclass(frozen=True, kw_only=True)
class StressHistory:
    """The stress of a strain history, part by part.

    Attributes:
        spring: Pa, shape (samples,), >= 0.
        damper: Pa, shape (samples,).
        branches: Pa, shape (branches, samples).
        set_strain: the strain below which the spring is slack, shape (samples,).
    """

    spring: Array
    damper: Array
    branches: Array
    set_strain: Array

    @property
    def total(self) -> Array:
        """Sum of the parts, Pa, shape (samples,), < 0 where damper and branches push."""
        return np.asarray(self.spring + self.damper + self.branches.sum(axis=0))

    @property
    def pull(self) -> Array:
        """The total where > 0, Pa: what a testing machine sees of a specimen that gives way rather than push.

        So does a simulated tendon that lets go, see `TendonLaw.lets_go`; others have the total.
        """
        return np.maximum(self.total, 0.0)


def stress_of(law: MaterialLaw, time: ArrayLike, strain: ArrayLike) -> StressHistory:
    """Stress of a strain history; between two samples the strain runs straight.

    The material is at rest before the first sample, with the branches relaxed. A law without viscosity has no damper
    stress.

    Args:
        law: of the material.
        time: s, shape (samples,), rising.
        strain: shape (samples,).

    Raises:
        InputError: an absent modulus, or a time that does not rise.
    """
    moduli = known_moduli(law)
    times, strains = np.asarray(time, dtype=np.float64), np.asarray(strain, dtype=np.float64)
    check_history(times, strains)
    lowest = set_history(strains, law.residual_strain, law.yield_strain)
    extended = strains - lowest
    spring = (
        spring_stress(moduli, extended)
        if law.softening is None
        else softened_stress(moduli, law.softening, np.maximum(extended, 0.0))
    )
    branches = [branch_stress(branch, times, strains) for branch in law.branches]
    return StressHistory(
        spring=spring,
        damper=damper_stress(law.viscosity or (0.0, 0.0, 0.0), np.gradient(strains, times)),
        branches=np.array(branches).reshape(len(branches), len(times)),
        set_strain=lowest,
    )


def check_history(time: Array, strain: Array) -> None:
    """Refuse what is no history.

    Raises:
        InputError: fewer than two samples, shapes that differ, a number that is not finite, or a time that does not
            rise.
    """
    if time.ndim != 1 or time.shape != strain.shape or len(time) < 2:
        raise InputError(
            f"time and strain: need two rows of equal length >= 2, got shapes {time.shape} and {strain.shape}"
        )
    for name, values in (("time", time), ("strain", strain)):
        if not np.all(np.isfinite(values)):
            row = int(np.argmin(np.isfinite(values)))
            raise InputError(f"{name}: need finite numbers, got {values[row]} in row {row}")
    steps = np.diff(time)
    if np.any(steps <= 0):
        row = int(np.argmax(steps <= 0)) + 1
        raise InputError(
            f"time: need to rise from row to row, got {time[row]:g} s after {time[row - 1]:g} s in row {row}"
        )


def set_history(strain: Array, residual: float, yield_strain: float | None) -> Array:
    """Strain at which a spring is slack, shape (samples,); it creeps where the spring would pass its yield."""
    if yield_strain is None:
        return np.full(strain.shape, residual)
    return np.maximum(residual, np.maximum.accumulate(strain) - yield_strain)


def damper_stress(viscosity: Triple, rate: ArrayLike) -> Array:
    """Stress eta1 e' + eta2 e'|e'| + eta3 e'^3 of a strain rate (1/s), Pa, in its shape."""
    r = np.asarray(rate, dtype=np.float64)
    return np.asarray(r * (viscosity[0] + np.abs(r) * (viscosity[1] + np.abs(r) * viscosity[2])))


def branch_stress(branch: MaxwellBranch, time: Array, strain: Array, starts: ArrayLike = ()) -> Array:
    """Stress of a Maxwell branch that is relaxed at the first sample, Pa, shape (samples,).

    Exact where the strain runs straight between samples: over h it becomes
    q exp(-h / tau) + E (1 - exp(-h / tau)) (tau / h) de.

    Args:
        branch: of a law.
        time: s, shape (samples,).
        strain: shape (samples,).
        starts: first samples of further histories, end to end with the first, at which it is relaxed, too.
    """
    spans = np.diff(time)
    spans[np.asarray(starts, dtype=np.int64) - 1] = np.inf
    steps = spans / branch.time
    gained = branch.modulus * np.diff(strain) * -np.expm1(-steps) / steps
    stress = np.zeros(len(time))
    stress[1:] = _decaying_sum(steps, gained)
    return stress


def _decaying_sum(steps: Array, gained: Array) -> Array:
    """Solve q[k] = q[k-1] exp(-steps[k]) + gained[k] from q[-1] = 0 by doubling spans (Hillis and Steele 1986)."""
    kept, result, span = np.exp(-steps), gained.copy(), 1
    while span < len(steps) and np.any(kept[span:] > _NOTHING):
        result[span:] += kept[span:] * result[:-span]
        kept[span:] *= kept[:-span]
        span *= 2
    return result


def storage_modulus(law: MaterialLaw, frequency: float, strain: float = 0.0) -> float:
    """Elastic part of the modulus of a small sinusoid about a strain, Pa.

    E' = dS/de + sum E w^2 tau^2 / (1 + w^2 tau^2), the generalised Maxwell model (Ferry 1980, Viscoelastic Properties
    of Polymers, ch. 3).

    Args:
        law: of the material.
        frequency: Hz, >= 0.
        strain: of the spring, about which it swings.

    Raises:
        InputError: an absent modulus, or branches that are unknown.
    """
    require(law, "branches")
    first, second, third = known_moduli(law)
    w = _angular(frequency)
    slope = first + strain * (2 * second + 3 * third * strain)
    return slope + sum(each.modulus * (w * each.time) ** 2 / (1 + (w * each.time) ** 2) for each in law.branches)


def loss_modulus(law: MaterialLaw, frequency: float) -> float:
    """Viscous part of the modulus of a small sinusoid, E'' = eta1 w + sum E w tau / (1 + w^2 tau^2), Pa.

    Source as `storage_modulus`.

    Args:
        law: of the material.
        frequency: Hz, >= 0.

    Raises:
        InputError: branches that are unknown, or neither branches nor viscosity.
    """
    require(law, "branches")
    if not law.branches:
        require(law, "viscosity")
    w = _angular(frequency)
    linear = (law.viscosity or (0.0, 0.0, 0.0))[0]
    return linear * w + sum(each.modulus * w * each.time / (1 + (w * each.time) ** 2) for each in law.branches)


def loss_per_cycle(law: MaterialLaw, frequency: float, amplitude: float) -> float:
    """Energy that a cycle of a sinusoid turns into heat, J/m^3.

    pi E'' e0^2, plus 8/3 eta2 w^2 e0^3 + 3 pi/4 eta3 w^3 e0^4 of a nonlinear damper: the integral of stress times
    rate.

    Args:
        law: of the material.
        frequency: Hz, >= 0.
        amplitude: e0, of the strain.

    Raises:
        InputError: as `loss_modulus`.
    """
    loss, w = loss_modulus(law, frequency), _angular(frequency)
    _, second, third = law.viscosity or (0.0, 0.0, 0.0)
    nonlinear = amplitude**3 * w**2 * (8 / 3 * second + 3 * math.pi / 4 * third * w * amplitude)
    return math.pi * loss * amplitude**2 + nonlinear


def _angular(frequency: float) -> float:
    if not (math.isfinite(frequency) and frequency >= 0):
        raise InputError(f"frequency: need >= 0, got {frequency:g} Hz")
    return 2 * math.pi * frequency
