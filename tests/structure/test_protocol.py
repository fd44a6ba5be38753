"""Protocols of fans, joints and sheets have one form: drives, goals, states and transitions by name."""

import math

import numpy as np
import pytest

from forficula.design import key_value, load_design, named_designs, with_values
from forficula.structure import drive_of, goal_of, hinges_of, structure_of

STAGES = [
    {"name": "wait", "drive": "none", "until": "time", "time_limit": "1 s"},
    {"name": "go", "drive": ["go", "press"], "until": "creases > 70 deg", "state": "there", "time_limit": "1 s"},
]


@pytest.mark.parametrize("name", named_designs())
def test_the_strength_of_every_drive_is_the_value_of_its_key(name):
    design = load_design(name)
    drives = design.named_protocol.drives
    assert drives
    for drive in drives:
        value, built = key_value(design, drive.key), drive_of(structure_of(design), drive.name)
        if value is not None:  # None where creases continue to their targets
            assert drive.strength == built.strength == value
        assert len(built.shares) == len(structure_of(design).motors)


@pytest.mark.parametrize("name", named_designs())
def test_every_goal_of_states_and_transitions_is_read(name):
    structure = structure_of(load_design(name))
    named = [state.goal for state in structure.states]
    for transition in structure.transitions:
        named += [transition.goal, transition.released]
        assert transition.state in [state.name for state in structure.states]
    assert {goal_of(structure, text).kind for text in named} <= {"bounds", "time", "rest"}


@pytest.mark.parametrize("angle", [math.radians(150), math.nextafter(2.0, 3), math.pi / 3])
def test_the_angle_of_a_fold_is_exact(angle):
    structure = structure_of(load_design("binder2025").with_values({"protocol.folded_angle": angle}))
    folded, released = goal_of(structure, "folded").most, goal_of(structure, structure.transitions[0].released).most
    rings = list(hinges_of(structure, "ring"))
    assert set(folded[rings].tolist()) == {-angle}
    assert set(released[rings].tolist()) == {-angle / 2}
    assert np.isinf(np.delete(folded, rings)).all()


@pytest.mark.parametrize("veins", [[0], [1], [2, 1]])
def test_motors_of_driven_veins_come_before_those_of_ring_folds(veins):
    structure = structure_of(with_values(load_design("binder2025"), {"protocol.driven_veins": veins}))
    proximal, distal = structure.motors
    assert [structure.hinges[hinge].name for hinge in proximal.hinges] == [f"turn{vein}" for vein in sorted(veins)]
    assert distal.hinges == hinges_of(structure, "ring")
    assert [drive.shares for drive in structure.drives] == [(1.0, 0.0), (-1.0, 1.0)]


def test_drives_of_one_stage_act_as_one_in_proportion():
    drives = [
        {"name": "go", "kind": "torque", "of": "crease 0", "value": "2 N cm"},
        {"name": "press", "kind": "torque", "of": "creases", "value": "-1 N cm", "rise": "0.5 s"},
    ]
    structure = structure_of(with_values(load_design("letter-fold"), {"drive": drives, "protocol.stages": STAGES}))
    both = drive_of(structure, "go and press")
    assert [len(motor.hinges) for motor in structure.motors] == [1, 1]
    assert both.strengths == pytest.approx((0.01, -0.01))
    assert (both.key, both.rise) == ("drive.go.value", 0.5)
