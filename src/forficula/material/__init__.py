"""Materials: from tensile and folding tests to a law."""

from forficula.public_names import public_names

_PUBLIC = (
    "Characterisation",
    "CreaseCharacterisation",
    "CreaseFit",
    "CreaseLawFile",
    "Cycle",
    "FoldingTest",
    "LawFit",
    "MaterialLaw",
    "ModulusClass",
    "StrainHistory",
    "TendonSize",
    "TendonSizes",
    "TensileTest",
    "area_for",
    "characterise",
    "characterise_crease",
    "find_cycles",
    "fit_crease_law",
    "fit_law",
    "load_crease_law",
    "load_law",
    "moduli_by_strain",
    "named_crease_laws",
    "named_laws",
    "read_folding_tests",
    "read_tensile_test",
    "read_tensile_tests",
    "save_crease_law",
    "save_law",
    "size_tendons",
)

# all names are in __init__.pyi; those that are not public are for other modules of forficula
__getattr__, __dir__, __all__ = public_names(__name__, __file__, public=_PUBLIC)
