"""Veins tied at the base: the joints, their stiffness, and the keys in a design."""

import numpy as np
import pytest

from forficula.design import design_from_text, design_text, load_design, named_designs, scale_design, with_values
from forficula.errors import InputError
from forficula.structure import coupling_rows, drive_of, hinges_of, static_keys, structure_of

REFERENCE = load_design("binder2025")
TIED = load_design("binder2025-coupled")


def test_neighbouring_turns_are_tied_with_their_signs():
    built = structure_of(TIED)
    turns = hinges_of(built, "turn")
    assert [coupling.hinges for coupling in built.couplings] == [(turns[0], turns[1]), (turns[1], turns[2])]
    assert all(coupling.rigid for coupling in built.couplings)
    folding = np.zeros(len(built.hinges))
    folding[list(turns)] = 0.3
    assert np.array_equal(coupling_rows(built) @ folding, [0, 0])


def test_one_motor_drives_one_vein_and_every_distal_hinge_has_a_motor():
    built = structure_of(TIED)
    proximal, distal = built.motors
    assert proximal.hinges == hinges_of(built, "turn")[:1]
    assert distal.hinges == hinges_of(built, "ring")
    assert drive_of(built, "fold").where == "on the proximal joint of vein 0"
    assert drive_of(built, "unfold").where == "on every distal joint and the proximal joint of vein 0"
    two = structure_of(with_values(TIED, {"protocol.driven_veins": [2, 0]}))
    assert two.motors[0].hinges == tuple(hinges_of(two, "turn")[vein] for vein in (0, 2))
    assert drive_of(two, "fold").where == "on the proximal joints of veins 0 and 2"


def test_a_wing_without_ties_is_unchanged():
    built = structure_of(REFERENCE)
    assert built.couplings == ()
    assert drive_of(built, "fold").where == "on every proximal joint"
    assert {"coupling", "driven_veins"}.isdisjoint({**REFERENCE.hash_values(), **REFERENCE.protocol.hash_values()})
    every = with_values(REFERENCE, {"protocol.driven_veins": [0, 1, 2]})
    assert structure_of(every).motors[0].hinges == built.motors[0].hinges


def test_the_stiffness_is_read_written_and_scaled_as_one_of_a_joint():
    soft = with_values(TIED, {"coupling.stiffness": 0.3})
    assert soft.as_tables()["coupling"] == {"stiffness": "0.3 N m/rad"}
    for design in (TIED, soft):
        assert design_from_text(design_text(design)).hash == design.hash
    assert len({REFERENCE.hash, TIED.hash, soft.hash}) == 3
    # energy scales with the cube of the size
    assert structure_of(scale_design(soft, 0.1)).couplings[0].stiffness == pytest.approx(0.3e-3)
    assert scale_design(TIED, 0.1).coupling.stiffness == "rigid"


def test_statics_distinguishes_wings_with_different_couplings():
    assert {"coupling", "protocol.driven_veins"} <= set(static_keys(REFERENCE))


@pytest.mark.parametrize(
    ("key", "value", "sentence"),
    [
        ("coupling.stiffness", "-1 N m/rad", "coupling.stiffness: need >= 0, got -1 N m/rad"),
        ("coupling.stiffness", "stiff", '"rigid" is allowed, too'),
        ("coupling.stifness", "1 N m/rad", "did you mean coupling.stiffness?"),
        ("protocol.driven_veins", [3], "protocol.driven_veins: need different numbers of veins, 0 to 2 with"),
        ("protocol.driven_veins", [0, 0], "got [0, 0]"),
        ("protocol.driven_veins", [], "driven_veins"),
        ("protocol.driven_veins", [-1], "driven_veins"),
    ],
)
def test_what_cannot_be_tied_or_driven_is_refused(key, value, sentence):
    with pytest.raises(InputError) as error:
        load_design("binder2025", {key: value})
    assert sentence in str(error.value)


def test_the_named_design_differs_from_the_reference_only_in_ties_and_motor():
    assert "one motor" in named_designs()["binder2025-coupled"]
    apart = TIED.model_copy(update={"coupling": None, "protocol": REFERENCE.protocol})
    assert apart.hash == REFERENCE.hash
