"""Predict and design bistable folding structures.

import forficula as ff

design = ff.load_design("binder2025")
record = ff.run(design)
outcome = ff.measure(record)
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from forficula.analysis import Outcome, Verdict, measure
    from forficula.analysis.sizing import TendonSizes, size_tendons
    from forficula.design import Design, load_design, named_designs, save_design, scale_design
    from forficula.dynamics import Record, load_record, save_record, timestep_warnings
    from forficula.errors import InputError
    from forficula.material import TensileTest, find_cycles, moduli_by_strain, read_tensile_test, read_tensile_tests
    from forficula.material.characterisation import Characterisation, characterise
    from forficula.material.fit.fit import LawFit, fit_law
    from forficula.material.law.law_file import load_law, named_laws, save_law
    from forficula.material.law.material_law import MaterialLaw, area_for
    from forficula.material.tensile.strain_history import StrainHistory
    from forficula.pattern import CreasePattern, EarwigFan, earwig_pattern, read_fold, read_folded_frames, write_fold
    from forficula.statics import EnergyLandscape, StableState, barrier, energy_landscape, stable_states
    from forficula.structure import Structure, structure_of, structure_warnings
    from forficula.study import Study, load_study, run_study
    from forficula.study.cycling import Cycling, run_cycles
    from forficula.study.runs import run

# Where each public name lives. They are fetched at first use: MuJoCo and xarray are slow to import, and help, errors
# and crease patterns need neither.
_HOMES = {
    "forficula.analysis": ("Outcome", "Verdict", "measure"),
    "forficula.design": ("Design", "load_design", "named_designs", "save_design", "scale_design"),
    "forficula.dynamics": ("Record", "load_record", "save_record", "timestep_warnings"),
    "forficula.analysis.sizing": ("TendonSizes", "size_tendons"),
    "forficula.errors": ("InputError",),
    "forficula.material": (
        "TensileTest",
        "find_cycles",
        "moduli_by_strain",
        "read_tensile_test",
        "read_tensile_tests",
    ),
    "forficula.material.characterisation": ("Characterisation", "characterise"),
    "forficula.material.fit.fit": ("LawFit", "fit_law"),
    "forficula.material.law.law_file": ("load_law", "named_laws", "save_law"),
    "forficula.material.law.material_law": ("MaterialLaw", "area_for"),
    "forficula.material.tensile.strain_history": ("StrainHistory",),
    "forficula.statics": ("EnergyLandscape", "StableState", "barrier", "energy_landscape", "stable_states"),
    "forficula.structure": ("Structure", "structure_of", "structure_warnings"),
    "forficula.study": ("Study", "load_study", "run_study"),
    "forficula.study.cycling": ("Cycling", "run_cycles"),
    "forficula.study.runs": ("run",),
    "forficula.pattern": (
        "CreasePattern",
        "EarwigFan",
        "earwig_pattern",
        "read_fold",
        "read_folded_frames",
        "write_fold",
    ),
}

__all__ = [
    "Characterisation",
    "CreasePattern",
    "Cycling",
    "Design",
    "EarwigFan",
    "EnergyLandscape",
    "InputError",
    "LawFit",
    "MaterialLaw",
    "Outcome",
    "Record",
    "StableState",
    "StrainHistory",
    "Structure",
    "Study",
    "TendonSizes",
    "TensileTest",
    "Verdict",
    "area_for",
    "barrier",
    "characterise",
    "earwig_pattern",
    "energy_landscape",
    "find_cycles",
    "fit_law",
    "load_design",
    "load_law",
    "load_record",
    "load_study",
    "measure",
    "moduli_by_strain",
    "named_designs",
    "named_laws",
    "read_fold",
    "read_folded_frames",
    "read_tensile_test",
    "read_tensile_tests",
    "run",
    "run_cycles",
    "run_study",
    "save_design",
    "save_law",
    "save_record",
    "scale_design",
    "size_tendons",
    "stable_states",
    "structure_of",
    "structure_warnings",
    "timestep_warnings",
    "write_fold",
]


def __getattr__(name: str) -> Any:
    """Fetch a public name from where it lives."""
    for home, names in _HOMES.items():
        if name in names:
            return getattr(import_module(home), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    """The public names."""
    return __all__
