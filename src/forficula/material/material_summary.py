"""A characterised material as plain data with units in its keys, as `material.json` has it."""

from __future__ import annotations

import math
from importlib import metadata
from typing import Any

from forficula.material.characterisation import SIMULATED_STIFFNESSES, Characterisation, Specimen
from forficula.material.fit.fit import Candidate, LawFit
from forficula.material.law.drift import Drift
from forficula.material.law.law_cycle import drifts_of
from forficula.material.law.law_file import law_values
from forficula.material.law.law_keys import law_unit
from forficula.material.law.material_law import MaterialLaw
from forficula.material.tensile.cycles import Cycle
from forficula.material.tensile.modulus import ModulusClass, Quartiles

_CYCLE_KEYS = {
    "secant_modulus": "secant_modulus_Pa",
    "loss": "loss_J_per_m3",
    "residual_strain": "residual_strain",
    "slack_strain": "slack_strain",
    "onset_strain": "onset_strain",
    "largest_strain": "largest_strain",
}


def material_summary(material: Characterisation) -> dict[str, Any]:
    """A material as plain data with units in its keys, as `material.json` has it; what is absent is None."""
    low, high = material.simulated_moduli
    change = {f"{key}_per_cycle": _known(getattr(material.change, name)) for name, key in _CYCLE_KEYS.items()}
    return {
        "material": material.name,
        "specimens": [_specimen_summary(each) for each in material.specimens],
        "cycles": [
            {"cycle": each.number, "specimens": each.specimens} | _cycle_values(each) for each in material.cycles
        ],
        "drift": {
            "specimens": material.change.specimens,
            "change": change,
            **{key: _drift_summary(drift) for key, drift in material.drifts.items()},
        },
        "modulus_by_strain": [_modulus_summary(each) for each in (*material.by_cycle, *material.pooled)],
        "simulated_stiffnesses": {
            "stiffness_N_per_m": list(SIMULATED_STIFFNESSES),
            "modulus_at_the_specimens_size_Pa": [low, high],
        },
        "law": None if material.law is None else _law_summary(material.law),
        "fit": None if material.fit is None else _fit_summary(material.fit),
        "remarks": list(material.remarks),
        "versions": {name: metadata.version(name) for name in ("forficula", "numpy", "scipy")},
    }


def law_rows(law: MaterialLaw) -> list[tuple[str, float, tuple[float, float] | None]]:
    """The values of a law that are not 0: key, value in SI, 95 % confidence interval where one is known."""
    bounds = {each.key: (each.low, each.high) for each in law.intervals}
    return [(key, value, bounds.get(key)) for key, value in law_values(law).items() if value or key in bounds]


def _known(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _cycle_values(cycle: Any) -> dict[str, float | None]:
    """Of a cycle, or of medians over cycles."""
    return {key: _known(getattr(cycle, name)) for name, key in _CYCLE_KEYS.items()}


def _specimen_summary(specimen: Specimen) -> dict[str, Any]:
    test = specimen.test

    def one(cycle: Cycle) -> dict[str, Any]:
        return {"cycle": cycle.number, **_cycle_values(cycle), "zero_stress_Pa": cycle.zero_stress}

    return {
        "name": test.name,
        "length_m": test.length,
        "area_m2": test.area,
        "rows": len(test.time),
        "strain_rate_per_s": specimen.strain_rate,
        "cycles": [one(cycle) for cycle in specimen.cycles],
        "left_out_cycles": [one(cycle) for cycle in specimen.left_out],
    }


def _modulus_summary(entry: ModulusClass) -> dict[str, Any]:
    return {
        "cycle": "pooled" if entry.cycle is None else entry.cycle,
        "way": entry.way,
        "from_strain": entry.from_strain,
        "to_strain": entry.to_strain,
        "secant_modulus_Pa": _quartiles(entry.secant_modulus),
        "local_modulus_Pa": _quartiles(entry.local_modulus),
        "values": entry.values,
        "points": entry.points,
    }


def _quartiles(entry: Quartiles) -> dict[str, float]:
    return {"lower_quartile": entry.lower, "median": entry.median, "upper_quartile": entry.upper}


def _drift_summary(drift: Drift | None) -> dict[str, Any] | None:
    """As `Drift` has it, so that it can be read back; a relative drift is one of the logarithm."""
    if drift is None:
        return None
    return {
        "kind": drift.kind,
        "relative": drift.relative,
        "rate": drift.rate,
        "rate_interval_95": list(drift.interval),
        "plateau_cycles": drift.cycles if drift.kind == "plateau" else None,
        "seen_cycles": list(drift.seen),
    }


def _law_summary(law: MaterialLaw) -> dict[str, Any]:
    return {
        "name": law.name,
        "source": law.source,
        "parameters": [
            {
                "key": key,
                "value": value,
                "interval_95": None if bounds is None else list(bounds),
                "unit": "1" if law_unit(key).si == "dimensionless" else law_unit(key).si,
            }
            for key, value, bounds in law_rows(law)
        ],
        "drift": {key: _drift_summary(drift) for key, drift in drifts_of(law).items()},
        "facts": [{"what": fact.what, "value": fact.value} for fact in law.facts],
    }


def _fit_summary(fit: LawFit) -> dict[str, Any]:
    return {
        "law": fit.form.name,
        "points": fit.points,
        "effective_points": fit.effective_points,
        "bayesian_information_criterion": fit.bic,
        "residual_rms_Pa": fit.misfit,
        "residual_rms_by_largest_stress": fit.relative_misfit,
        "amplitude_standard_deviation": fit.scatter,
        "amplitudes": [{"specimen": each.name, "amplitude": each.amplitude} for each in fit.residuals],
        "force_zero": [
            {"specimen": each.name, "offset_Pa": each.offset, "drift_Pa_per_s": each.drift} for each in fit.residuals
        ],
        "compared": [_candidate_summary(each, fit.bic) for each in fit.candidates],
    }


def _candidate_summary(candidate: Candidate, chosen: float) -> dict[str, Any]:
    tried = math.isfinite(candidate.bic)
    return {
        "law": candidate.form.name,
        "values": len(candidate.form.keys),
        "bayesian_information_criterion": candidate.bic if tried else None,
        "above_chosen": candidate.bic - chosen if tried else None,
        "residual_rms_Pa": candidate.misfit if tried else None,
        "refused": candidate.refused or None,
    }
