"""Response of a material to a strain history: the set of its spring and the stress of its Maxwell branches."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.material.law.material_law import MaxwellBranch

_NOTHING = 1e-30  # remaining share of a stress that counts as 0


def check_history(time: Array, strain: Array) -> None:
    """Check that time and strain form a history.

    Raises:
        InputError: fewer than two samples, different shapes, a number that is not finite, or a time that does not
            increase.
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
    """Compute the strain at which a spring becomes slack, shape (samples,); it creeps beyond the yield strain."""
    if yield_strain is None:
        return np.full(strain.shape, residual)
    return np.maximum(residual, np.maximum.accumulate(strain) - yield_strain)


def branch_stress(branch: MaxwellBranch, time: Array, strain: Array, starts: ArrayLike = ()) -> Array:
    """Compute the stress of a Maxwell branch that is relaxed at the first sample, Pa, shape (samples,).

    The result is exact if the strain is linear between samples: over a step h the stress q becomes
    q exp(-h / tau) + E (1 - exp(-h / tau)) (tau / h) de.

    Args:
        branch: branch of a law.
        time: s, shape (samples,).
        strain: shape (samples,).
        starts: first samples of further concatenated histories, at which the branch is also relaxed.
    """
    spans = np.diff(time)
    spans[np.asarray(starts, dtype=np.int64) - 1] = np.inf
    steps = spans / branch.time
    gained = branch.modulus * np.diff(strain) * -np.expm1(-steps) / steps
    stress = np.zeros(len(time))
    stress[1:] = _decaying_sum(steps, gained)
    return stress


def _decaying_sum(steps: Array, gained: Array) -> Array:
    """Solve q[k] = q[k-1] exp(-steps[k]) + gained[k], q[-1] = 0, by doubling spans (Hillis and Steele 1986)."""
    kept, result, span = np.exp(-steps), gained.copy(), 1
    while span < len(steps) and np.any(kept[span:] > _NOTHING):
        result[span:] += kept[span:] * result[:-span]
        kept[span:] *= kept[:-span]
        span *= 2
    return result
