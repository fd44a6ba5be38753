"""The law of a material at a given cycle, and after a first stretch."""

from __future__ import annotations

from dataclasses import replace

from forficula.errors import InputError
from forficula.material.law.drift import Drift
from forficula.material.law.law_keys import TERMS
from forficula.material.law.material_law import MaterialLaw, MaxwellBranch, known_moduli
from forficula.material.law.softening import Triple, softened_moduli


def drifts_of(law: MaterialLaw) -> dict[str, Drift]:
    """Return the known drifts of a law, also those of kind "none", by the drifting quantity."""
    both = {"stiffness": law.stiffness_drift, "residual_strain": law.residual_strain_drift}
    return {key: drift for key, drift in both.items() if drift is not None}


def change_at_cycle(drift: Drift, cycle: float) -> tuple[float, float, float]:
    """Compute the change of a drift at a cycle, as `Drift.change`, but without extrapolation before the first cycle.

    A first cycle that was left out differs from all others, and the drift of the others does not extend to it.
    """
    if not cycle >= 1:
        raise InputError(f"cycle: need >= 1, got {cycle:g}")
    return drift.change(max(cycle, float(drift.seen[0])))


def law_at_cycle(law: MaterialLaw, cycle: float) -> MaterialLaw:
    """Return the law of a material at a cycle, with the drifts of its stresses and of its residual strain.

    Args:
        law: law at the first cycle of the data.
        cycle: number of the cycle, >= 1.

    Returns:
        The law without drifts, and without intervals, because these do not include the uncertainty of the drift.

    Raises:
        InputError: the cycle is not >= 1.
    """
    changes = {key: change_at_cycle(drift, cycle)[0] for key, drift in drifts_of(law).items()}
    factor, longer = changes.get("stiffness", 1.0), changes.get("residual_strain", 0.0)
    return replace(
        law,
        moduli=None if law.moduli is None else _times(law.moduli, factor),
        viscosity=None if law.viscosity is None else _times(law.viscosity, factor),
        branches=tuple(MaxwellBranch(modulus=branch.modulus * factor, time=branch.time) for branch in law.branches),
        residual_strain=max(law.residual_strain + longer, 0.0),
        softening=None if law.softening is None else replace(law.softening, m=law.softening.m * factor),
        stiffness_drift=None,
        residual_strain_drift=None,
        intervals=(),
    )


def stretched_before(law: MaterialLaw, peak: float) -> tuple[MaterialLaw, float]:
    """Replace the softening of a law by a polynomial for the state after a stretch, see `softened_moduli`.

    Args:
        law: law with moduli.
        peak: largest strain that the spring has reached, > 0.

    Returns:
        The law, unchanged if it has no softening, and the largest error as a share of the stress at the peak.

    Raises:
        InputError: an absent modulus, or a peak that is not > 0.
    """
    if law.softening is None:
        return law, 0.0
    moduli, error = softened_moduli(known_moduli(law), law.softening, peak)
    replaced = {f"modulus.{term}" for term in TERMS}
    kept = tuple(
        bounds for bounds in law.intervals if bounds.key not in replaced and not bounds.key.startswith("softening")
    )
    return replace(law, moduli=moduli, softening=None, intervals=kept), error


def _times(terms: Triple, factor: float) -> Triple:
    return terms[0] * factor, terms[1] * factor, terms[2] * factor
