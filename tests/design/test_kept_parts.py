"""A design with other values keeps the parts that these leave alone, and is the one that is read from its file."""

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
def test_a_changed_design_is_the_one_that_is_read_from_its_file(name, values):
    changed = with_values(load_design(name), values)
    again = design_from_text(str(changed))
    assert (again.hash, again.source) == (changed.hash, changed.source)
    assert again.settled() == changed.settled()
    assert differing_keys(again.settled(), changed.settled()) == []


def test_parts_that_stay_as_they_are_are_kept():
    letter = load_design("letter-fold")
    changed = letter.with_values({"tendon.left.stiffness": 60.0})
    assert all(getattr(changed, name) is getattr(letter, name) for name in ("pattern", "facet", "crease", "protocol"))
    assert changed.tendon[1] is letter.tendon[1]
    assert changed.tendon[0] is not letter.tendon[0]


def test_a_value_that_only_looks_like_what_is_there_is_read_and_refused():
    wing = load_design("binder2025")
    assert wing.membrane.density == 0.0
    with pytest.raises(InputError, match=r"membrane\.density: need text with a unit"):
        wing.with_values({"membrane.density": False})


def test_parts_that_stay_are_checked_against_those_that_change():
    with pytest.raises(InputError, match=r"membrane\.margin: the margin is wider than the panel"):
        load_design("binder2025").with_values({"pattern.proximal_length": "3 cm"})


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda each: pickle.loads(pickle.dumps(each))])
def test_what_was_worked_out_of_a_design_is_no_part_of_it(copied):
    known, fresh = (Design.model_copy(load_design("binder2025")) for _ in range(2))
    assert len(known.hash) == 16
    assert known == fresh
    assert dict(known).keys() == dict(fresh).keys()
    assert copied(known) == known
    assert copied(known).hash == known.hash


def test_a_copy_with_another_value_has_another_hash():
    wing = load_design("binder2025")
    assert len({wing.hash, wing.model_copy(update={"vein": wing.vein.model_copy(update={"density": 1.0})}).hash}) == 2
