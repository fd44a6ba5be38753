"""Materials: from tensile tests to a law."""

from forficula.public_names import public_names

_PUBLIC = (
    "Characterisation",
    "CreaseLawFile",
    "Cycle",
    "LawFit",
    "MaterialLaw",
    "ModulusClass",
    "StrainHistory",
    "TendonSize",
    "TendonSizes",
    "TensileTest",
    "area_for",
    "characterise",
    "find_cycles",
    "fit_law",
    "load_crease_law",
    "load_law",
    "moduli_by_strain",
    "named_crease_laws",
    "named_laws",
    "read_tensile_test",
    "read_tensile_tests",
    "save_crease_law",
    "save_law",
    "size_tendons",
)

# all names are in __init__.pyi; those that are not public are for other modules of forficula
__getattr__, __dir__, __all__ = public_names(__name__, __file__, public=_PUBLIC)
