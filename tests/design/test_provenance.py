"""A changed design lists its changes instead of claiming the source of its base."""

import pytest

import forficula as ff
from forficula.design import differing_keys

PAPER = "Binder, Costi, Izzo, Seidl"
BASED = 'based_on = "binder2025"\n'


def test_a_changed_value_is_named_before_the_source():
    changed = ff.load_design("binder2025", {"tendon.stiffness": "20 N/cm"})
    assert changed.source.startswith(f"binder2025 with other values of tendon.stiffness; binder2025: {PAPER}")
    again = changed.with_values({"pattern.units": 2})
    assert again.source.startswith("binder2025 with other values of pattern.units and tendon.stiffness; ")
    assert again.source.count(PAPER) == 1


@pytest.mark.parametrize("values", [{}, {"name": "mine"}, {"tendon.stiffness": "1000 N/m"}, {"tendon.law": "none"}])
def test_the_same_values_keep_their_source(values):
    assert ff.load_design("binder2025", values).source == ff.load_design("binder2025").source


def test_a_file_names_the_design_that_it_is_based_on(tmp_path):
    (tmp_path / "wing.toml").write_text(f'{BASED}[tendon]\nrest_length = "7 cm"\n')
    wing = ff.load_design(tmp_path / "wing.toml")
    assert wing.source.startswith("binder2025 with other values of tendon.rest_length; ")
    (tmp_path / "own.toml").write_text(f'{BASED}source = "our bench"\n[tendon]\nrest_length = "7 cm"\n')
    assert ff.load_design(tmp_path / "own.toml").source == "our bench"


def test_only_the_first_of_many_changes_are_listed():
    values = {f"pattern.{key}_length": "13 cm" for key in ("proximal", "distal")}
    values |= {f"hinge.{key}": 2e-3 for key in ("damping",)} | {"vein.density": 1.0, "vein.diameter": 1e-3}
    values |= {"membrane.thickness": 2e-4, "membrane.youngs_modulus": 2e6, "protocol.timestep": 1e-4}
    assert "vein.density" not in (source := ff.load_design("binder2025").with_values(values).source)
    assert " and more; binder2025: " in source


def test_the_source_of_a_scaled_design_contains_the_factor():
    assert ff.scale_design("binder2025", 0.1).source.startswith("binder2025 at 0.1 times its size; binder2025: ")


def test_changes_of_a_named_entry_are_listed_under_its_name():
    letter = ff.load_design("letter-fold")
    stiffer = letter.with_values({"tendon.left.stiffness": "0.6 N/cm", "protocol.timestep": "0.1 ms"})
    assert differing_keys(letter, stiffer) == ["protocol.timestep", "tendon.left.stiffness"]
    assert differing_keys(letter, letter) == []
    assert stiffer.source.startswith("letter-fold with other values of protocol.timestep and tendon.left.stiffness; ")
