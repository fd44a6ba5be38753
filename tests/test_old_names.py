"""Names of version 0.1: every one works, and those that are gone from the list warn and say what replaces them."""

import warnings

import pytest

import forficula as ff
from forficula.old_names import OLD_NAMES

NAMES_OF_0_1 = [
    "AssumptionRun",
    "Assumptions",
    "Characterisation",
    "Check",
    "Convergence",
    "CreasePattern",
    "Cycling",
    "Design",
    "EarwigFan",
    "EnergyLandscape",
    "InputError",
    "LawFit",
    "MaterialLaw",
    "Outcome",
    "Part",
    "PartSet",
    "Record",
    "StableState",
    "StrainHistory",
    "Structure",
    "Study",
    "TendonSizes",
    "TensileTest",
    "Verdict",
    "area_for",
    "assumptions",
    "barrier",
    "characterise",
    "check_parts",
    "collect",
    "compare",
    "converge",
    "earwig_pattern",
    "energy_landscape",
    "estimate",
    "figure",
    "film",
    "find_cycles",
    "fit_law",
    "identify",
    "json_schema",
    "landscape",
    "load_design",
    "load_law",
    "load_record",
    "load_study",
    "make_parts",
    "measure",
    "moduli_by_strain",
    "named_designs",
    "named_laws",
    "named_studies",
    "new_study",
    "optimise",
    "page",
    "pattern_facts",
    "read_fold",
    "read_folded_frames",
    "read_tensile_test",
    "read_tensile_tests",
    "run",
    "run_cycles",
    "run_study",
    "save",
    "save_design",
    "save_law",
    "save_record",
    "scale_design",
    "size_tendons",
    "stable_states",
    "structure_of",
    "structure_warnings",
    "timestep_warnings",
    "tolerance",
    "write_fold",
]


def test_no_name_is_missing_or_in_both_lists():
    assert len(NAMES_OF_0_1) == 75
    assert set(NAMES_OF_0_1) == OLD_NAMES.keys() | set(ff.__all__) & set(NAMES_OF_0_1)
    assert not OLD_NAMES.keys() & set(ff.__all__)


@pytest.mark.parametrize("name", sorted(OLD_NAMES))
def test_an_old_name_works_and_says_what_replaces_it(name):
    with pytest.warns(DeprecationWarning, match=f"forficula.{name} is deprecated.*: use ") as caught:
        assert getattr(ff, name) is not None
    # the warning is about the line of the user
    assert caught[0].filename == __file__


@pytest.mark.parametrize("name", sorted(name for name, old in OLD_NAMES.items() if old.instead.startswith("ff.")))
def test_what_replaces_a_name_exists(name):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        value = ff
        for part in OLD_NAMES[name].instead.removeprefix("ff.").partition("(")[0].partition(",")[0].split("."):
            value = getattr(value, part)
