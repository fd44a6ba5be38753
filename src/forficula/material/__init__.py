from forficula.material.fit.fit import FitCandidate, LawFit, Residual, fit_law
from forficula.material.law.crease_law import CreaseLaw
from forficula.material.law.drift import Drift, fit_drift
from forficula.material.law.law_cycle import change_at_cycle, drifts_of, law_at_cycle, stretched_before
from forficula.material.law.law_file import law_text, law_values, load_law, named_laws, save_law
from forficula.material.law.law_form import LawForm, all_forms
from forficula.material.law.law_keys import law_unit
from forficula.material.law.material_law import (
    Bounds,
    LawFact,
    MaterialLaw,
    MaxwellBranch,
    Unknown,
    area_for,
    chosen,
    require,
    scaled,
)
from forficula.material.law.softening import OgdenRoxburgh
from forficula.material.law.tendon_law import ElasticLaw, TendonBranch, TendonLaw
from forficula.material.machine.machine_file import read_tensile_test, read_tensile_tests
from forficula.material.tensile.cycle_drift import CycleDrift, CycleMedians, cycle_drift, cycle_medians
from forficula.material.tensile.cycles import Cycle, CycleBranch, find_cycles
from forficula.material.tensile.modulus import ModulusClass, Quartiles, moduli_by_strain
from forficula.material.tensile.strain_history import StrainHistory
from forficula.material.tensile.tensile_test import TensileTest

__all__ = [
    "Bounds",
    "CreaseLaw",
    "Cycle",
    "CycleBranch",
    "CycleDrift",
    "CycleMedians",
    "Drift",
    "ElasticLaw",
    "FitCandidate",
    "LawFact",
    "LawFit",
    "LawForm",
    "MaterialLaw",
    "MaxwellBranch",
    "ModulusClass",
    "OgdenRoxburgh",
    "Quartiles",
    "Residual",
    "StrainHistory",
    "TendonBranch",
    "TendonLaw",
    "TensileTest",
    "Unknown",
    "all_forms",
    "area_for",
    "change_at_cycle",
    "chosen",
    "cycle_drift",
    "cycle_medians",
    "drifts_of",
    "find_cycles",
    "fit_drift",
    "fit_law",
    "law_at_cycle",
    "law_text",
    "law_unit",
    "law_values",
    "load_law",
    "moduli_by_strain",
    "named_laws",
    "read_tensile_test",
    "read_tensile_tests",
    "require",
    "save_law",
    "scaled",
    "stretched_before",
]
