"""Goals in a design: bounds on a measure, or on all hinges of a role, counted in their folding senses."""

from dataclasses import replace

import numpy as np
import pytest

from forficula.design import load_design, with_values
from forficula.errors import InputError
from forficula.structure import (
    Measure,
    drive_of,
    first_state,
    goal_of,
    measure_of,
    state_of,
    structure_of,
    transition_of,
)

REFERENCE = load_design("binder2025")
STRUCTURE = structure_of(REFERENCE)
RINGS = np.array([hinge.role == "ring" for hinge in STRUCTURE.hinges])
TURNS = np.array([hinge.role == "turn" for hinge in STRUCTURE.hinges])


@pytest.mark.parametrize("text", ["ring < -150 deg", "ring <= -150 deg", "distal_angle<-150deg", " ring  < -150  deg "])
def test_a_bound_as_text_has_the_bits_of_the_goal_of_that_bound(text):
    design = with_values(REFERENCE, {"protocol.folded_angle": "150 deg"})
    structure = structure_of(design)
    written, folded = goal_of(structure, text), goal_of(structure, "folded")
    assert written.kind == folded.kind == "bounds"
    assert written.least.tobytes() == folded.least.tobytes()
    assert written.most.tobytes() == folded.most.tobytes()


def test_a_bound_applies_only_to_hinges_of_its_role():
    turned = goal_of(STRUCTURE, "turn > 10 deg")
    assert turned.least[TURNS] == pytest.approx(np.full(3, np.radians(10)), rel=1e-15)
    assert np.isneginf(turned.least[~TURNS]).all()
    assert np.isposinf(turned.most).all()


def test_a_measure_of_the_other_sign_is_bounded_from_the_other_side():
    (rings,) = STRUCTURE.measures
    fold = Measure(name="fold", kind="angle", hinges=rings.hinges, signs=(-1,) * 3, label="fold")
    structure = replace(STRUCTURE, measures=(*STRUCTURE.measures, fold))
    ours, theirs = goal_of(structure, "fold > 150 deg"), goal_of(structure, "ring < -150 deg")
    assert ours.least.tobytes() == theirs.least.tobytes()
    assert ours.most.tobytes() == theirs.most.tobytes()


def test_goals_for_time_and_rest_set_no_bounds():
    for kind in ("time", "rest"):
        goal = goal_of(STRUCTURE, kind)
        assert goal.kind == kind
        assert np.isneginf(goal.least).all()
        assert np.isposinf(goal.most).all()


def test_a_distance_has_a_coordinate_after_the_hinges():
    tips = [number for number, point in enumerate(STRUCTURE.points) if point.role == "tip"]
    gaps = tuple(
        Measure(name=name, kind="distance", points=(tips[place], tips[place + 1]))
        for place, name in enumerate(("first gap", "second gap"))
    )
    structure = replace(STRUCTURE, measures=(*STRUCTURE.measures, *gaps))
    goal = goal_of(structure, "second gap < 2 cm")
    assert len(goal.most) == len(STRUCTURE.hinges) + 2
    assert goal.most[-2:].tolist() == [np.inf, 0.02]
    assert np.isneginf(goal.least).all()
    assert np.isposinf(goal.most[:-1]).all()
    with pytest.raises(InputError, match=r'^until: "second gap < 2 deg": "deg" is not a unit of the right kind; .*cm'):
        goal_of(structure, "second gap < 2 deg")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("rings < -150 deg", 'got "rings"; did you mean "ring"?'),
        ("distal_angel < 1 deg", 'got "distal_angel"; did you mean "distal_angle"?'),
        ("folde", 'got "folde"; did you mean "folded"?'),
        ("elsewhere", 'got "elsewhere"'),
    ],
)
def test_an_unknown_goal_is_refused_with_the_known_ones(text, message):
    with pytest.raises(InputError) as caught:
        goal_of(STRUCTURE, text)
    goals = (
        'until: need "time", "rest", "folded", "opened" or a bound on one of distal_angle, sweep, lift, turn, ring, '
    )
    assert str(caught.value) == goals + message


def test_the_first_state_is_the_one_that_no_transition_leads_to():
    assert first_state(STRUCTURE, STRUCTURE.stage_states) == "flat"
    assert first_state(STRUCTURE, ["", "folded", "opened"]) == ""


def test_unknown_parts_are_refused():
    assert measure_of(STRUCTURE, "nothing") is None
    assert state_of(STRUCTURE, "sideways") is None
    assert transition_of(STRUCTURE, "nothing") is None
    with pytest.raises(
        InputError, match=r'^drive: need "none", "fold" or "unfold", got "flod"; did you mean "fold"\?$'
    ):
        drive_of(STRUCTURE, "flod")


def test_parts_by_their_names():
    assert measure_of(STRUCTURE, "turn").hinges == tuple(np.flatnonzero(TURNS))
    assert measure_of(STRUCTURE, "distal_angle").hinges == tuple(np.flatnonzero(RINGS))
    assert state_of(STRUCTURE, "folded").missed == "not folded"
    assert transition_of(STRUCTURE, "unfold").state == "opened"
