"""A material's law as it is at a cycle, and after its first stretch."""

from __future__ import annotations

from dataclasses import replace

from forficula.errors import InputError
from forficula.material.law.drift import Drift
from forficula.material.law.law_keys import TERMS
from forficula.material.law.material_law import MaterialLaw, MaxwellBranch, known_moduli
from forficula.material.law.softening import Triple, softened_moduli


def drifts_of(law: MaterialLaw) -> dict[str, Drift]:
    """The drifts that a law has, by what drifts: those that the data could tell, be it that there is none."""
    both = {"stiffness": law.stiffness_drift, "residual_strain": law.residual_strain_drift}
    return {key: drift for key, drift in both.items() if drift is not None}


def change_at_cycle(drift: Drift, cycle: float) -> tuple[float, float, float]:
    """As `Drift.change`, but none before the first cycle seen, where a drift tells nothing.

    A first cycle that was left out is different from all others, and no course through those leads back to it.
    """
    if not cycle >= 1:
        raise InputError(f"cycle: need >= 1, got {cycle:g}")
    return drift.change(max(cycle, float(drift.seen[0])))


def law_at_cycle(law: MaterialLaw, cycle: float) -> MaterialLaw:
    """A law as it is at a cycle: every stress times the stiffness' drift, the set longer by the residual strain's.

    Args:
        law: at the first cycle that its drifts have seen, and before.
        cycle: >= 1.

    Returns:
        The law, without drifts and without intervals, since the drift's own uncertainty is not in them.

    Raises:
        InputError: a cycle that is none.
    """
    changes = {key: change_at_cycle(drift, cycle)[0] for key, drift in drifts_of(law).items()}
    factor, longer = changes.get("stiffness", 1.0), changes.get("residual_strain", 0.0)
    return replace(
        law,
        moduli=None if law.moduli is None else _times(law.moduli, factor),
        viscosity=None if law.viscosity is None else _times(law.viscosity, factor),
        branches=tuple(MaxwellBranch(modulus=each.modulus * factor, time=each.time) for each in law.branches),
        residual_strain=max(law.residual_strain + longer, 0.0),
        softening=None if law.softening is None else replace(law.softening, m=law.softening.m * factor),
        stiffness_drift=None,
        residual_strain_drift=None,
        intervals=(),
    )


def stretched_before(law: MaterialLaw, peak: float) -> tuple[MaterialLaw, float]:
    """A law with softening as it is after a stretch: a polynomial that a simulator can take, see `softened_moduli`.

    Args:
        law: with moduli.
        peak: the largest strain that its spring has seen, > 0.

    Returns:
        The law, unchanged where it has no softening, and the largest error as a share of the stress at the peak.

    Raises:
        InputError: an absent modulus, or a peak that is no strain > 0.
    """
    if law.softening is None:
        return law, 0.0
    moduli, error = softened_moduli(known_moduli(law), law.softening, peak)
    own = {f"modulus.{term}" for term in TERMS}
    kept = tuple(each for each in law.intervals if each.key not in own and not each.key.startswith("softening"))
    return replace(law, moduli=moduli, softening=None, intervals=kept), error


def _times(terms: Triple, factor: float) -> Triple:
    return terms[0] * factor, terms[1] * factor, terms[2] * factor
