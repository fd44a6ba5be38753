"""The value "none" removes an element of a design: a tendon, an optional section, an entry of a list of tables."""

import pytest

from forficula.design import design_from_text, design_text, load_design
from forficula.errors import InputError
from forficula.options import read_settings
from forficula.structure import structure_of


def tendons(design):
    return [tendon.name for tendon in structure_of(design).tendons]


@pytest.mark.parametrize(
    ("name", "values", "left"),
    [
        ("binder2025", {"tendon.0": "none"}, ["tendon1", "tendon2"]),
        ("binder2025", {"tendon": {"2": "none"}}, ["tendon0", "tendon1"]),
        ("binder2025", {"tendon.0": "none", "tendon.stiffness": "5 N/cm"}, ["tendon1", "tendon2"]),
        ("binder2025", {"tendon": "none"}, []),
        ("letter-fold", {"tendon.left": "none"}, ["right"]),
        ("letter-fold", {"tendon.0": "none", "tendon.1": "none"}, []),
        ("letter-fold", {"tendon": "none"}, []),
    ],
)
def test_a_removed_tendon_is_not_in_the_structure(name, values, left):
    design = load_design(name, values)
    assert tendons(design) == left
    assert load_design(name).with_values(values).hash == design.hash
    assert design_from_text(design_text(design)).hash == design.hash


def test_other_tendons_keep_their_values():
    design = load_design("letter-fold", {"tendon.0": "none", "tendon.1.stiffness": "0.3 N/cm"})
    assert [(tendon.name, tendon.stiffness) for tendon in design.tendon] == [("right", 30.0)]


def test_an_optional_section_is_removed_and_may_be_absent_already():
    coupled = load_design("binder2025-coupled", {"coupling": "none"})
    assert coupled.coupling is None
    assert structure_of(coupled).couplings == ()
    assert load_design("binder2025", {"coupling": "none"}).hash == load_design("binder2025").hash
    assert load_design("binder2025-built", {"medium": "none"}).medium is None


def test_an_entry_of_a_list_of_tables_is_removed():
    assert load_design("letter-fold", {"support.0": "none"}).support == ()


def test_files_and_settings_of_a_command_remove_elements(tmp_path):
    (tmp_path / "wing.toml").write_text(
        'based_on = "binder2025-coupled"\ncoupling = "none"\ntendon.1 = "none"\n', "utf-8"
    )
    wing = load_design(tmp_path / "wing.toml")
    assert (wing.coupling, tendons(wing)) == (None, ["tendon0", "tendon2"])
    by_command = load_design("binder2025-coupled", read_settings(["coupling=none", "tendon.1=none"]))
    assert by_command.hash == wing.hash


@pytest.mark.parametrize(
    ("name", "values", "message"),
    [
        ("binder2025", {"tendon.7": "none"}, 'tendon.7: need the number of a vein with a tendon, 0, 1, 2, got "7"'),
        ("binder2025", {"tendon.1": "no"}, 'tendon.1: need a table under [tendon.1], or "none", got "no"'),
        ("binder2025", {"membrane": "none"}, 'membrane: need a table under [membrane], got "none"'),
        ("binder2025-joint", {"tendon": "none"}, 'tendon: need a table under [tendon], got "none"'),
        ("letter-fold", {"drive.open": "none"}, 'protocol.stages.3.drive: need "none" or "close", got "open"'),
    ],
)
def test_what_cannot_be_removed(name, values, message):
    with pytest.raises(InputError) as error:
        load_design(name, values)
    assert message in str(error.value)
