"""A changed design reuses its unchanged sections, and equals the design that is read from its file."""

import copy
import pickle

import pytest

from forficula.design import Design, differing_keys, load_design, with_values
from forficula.design.files.design_file import design_from_text
from forficula.errors import InputError

CHANGES = [
    ("binder2025", {"tendon.stiffness": "12 N/cm", "hinge.damping": 2e-3}),
    ("binder2025", {"tendon.1.stiffness": "12 N/cm"}),
    ("binder2025", {"pattern.units": 2, "tendon.law": "tpu-82a", "tendon.area": "12.5 mm^2"}),
    ("binder2025-joint", {"tendon.rest_length": "4 cm"}),
    (
        "letter-fold",
        {"crease.group": [{"of": "crease 0", "stiffness": "0.2 N m/rad/m"}], "tendon.left.stiffness": 60.0},
    ),
    ("miura-sheet", {"pattern.acute_angle": "50 deg", "facet.kind": "bars"}),
]


@pytest.mark.parametrize(("name", "values"), CHANGES)
def test_a_changed_design_equals_the_one_read_from_its_file(name, values):
    changed = with_values(load_design(name), values)
    again = design_from_text(str(changed))
    assert (again.hash, again.source) == (changed.hash, changed.source)
    assert again.settled() == changed.settled()
    assert differing_keys(again.settled(), changed.settled()) == []


def test_unchanged_sections_are_reused():
    letter = load_design("letter-fold")
    changed = letter.with_values({"tendon.left.stiffness": 60.0})
    assert all(getattr(changed, name) is getattr(letter, name) for name in ("pattern", "facet", "crease", "protocol"))
    assert changed.tendon[1] is letter.tendon[1]
    assert changed.tendon[0] is not letter.tendon[0]


def test_a_value_of_another_type_that_compares_equal_is_read_and_refused():
    wing = load_design("binder2025")
    assert wing.membrane.density == 0.0
    with pytest.raises(InputError, match=r"membrane\.density: need text with a unit"):
        wing.with_values({"membrane.density": False})


def test_reused_sections_are_checked_against_changed_ones():
    with pytest.raises(InputError, match=r"membrane\.margin: the margin is wider than the panel"):
        load_design("binder2025").with_values({"pattern.proximal_length": "3 cm"})


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda item: pickle.loads(pickle.dumps(item))])
def test_cached_results_are_not_part_of_a_design(copied):
    known, fresh = (Design.model_copy(load_design("binder2025")) for _ in range(2))
    assert len(known.hash) == 16
    assert known == fresh
    assert dict(known).keys() == dict(fresh).keys()
    assert copied(known) == known
    assert copied(known).hash == known.hash


def test_a_copy_with_another_value_has_another_hash():
    wing = load_design("binder2025")
    assert len({wing.hash, wing.model_copy(update={"vein": wing.vein.model_copy(update={"density": 1.0})}).hash}) == 2
