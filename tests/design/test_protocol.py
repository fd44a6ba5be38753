"""Stages of a protocol: drives, goals and states by name, or goals as bounds."""

import pytest

from forficula.design import load_design, stage_drives, with_values
from forficula.errors import InputError
from forficula.structure import structure_of

REFERENCE = load_design("binder2025")


def stage(number, **values):
    return with_values(REFERENCE, {f"protocol.stages.{number}.{key}": value for key, value in values.items()})


@pytest.mark.parametrize("until", ["ring < -150 deg", "turn > 10 deg", "sweep > -0.1 rad", "distal_angle <= -2 rad"])
def test_a_goal_may_be_a_bound_on_a_measure_or_on_the_hinges_of_a_role(until):
    assert stage(1, until=until).protocol.stages[1].until == until


GOALS = '"time", "rest", "folded", "opened" or a bound such as "ring < -150 deg"'
MEASURES = '"ring", "turn", "lift", "sweep" or "distal_angle"'


@pytest.mark.parametrize(
    ("until", "message"),
    [
        ("folde", f'need {GOALS}, got "folde"; did you mean "folded"?'),
        ("ring", f'need {GOALS}, got "ring"'),
        ("rings < -150 deg", f'need a bound on {MEASURES}, got "rings"; did you mean "ring"?'),
        ("distal_angel > 1 deg", f'need a bound on {MEASURES}, got "distal_angel"; did you mean "distal_angle"?'),
        ("turn > 10 cm", '"cm" is not a unit of the right kind; write it such as "15 deg", got "10 cm"'),
        ("turn > 10", 'the unit is missing; write it such as "15 deg", got "10"'),
        ("turn > far deg", 'need a number and a unit such as "15 deg", got "far deg"'),
        ("ring < -181 deg", "a stop keeps ring from reaching it: need a value >= -180 deg, got -181 deg"),
        ("distal_angle > 20 deg", "a stop keeps distal_angle from reaching it: need a value <= 3 deg, got 20 deg"),
        ("turn > 170 deg", "a stop keeps turn from reaching it: need a value <= 90 deg, got 170 deg"),
        *(
            (text, f'need {GOALS}, got "{text}"')
            for text in ("ring << 3 deg", "ring =< 3 deg", "ring == 3 deg", "ring ≤ 3 deg", "-150 deg > ring")
        ),
        ("ring < 3 deg and turn > 2 deg", f'need {GOALS}, got "ring < 3 deg and turn > 2 deg"'),
        ("turn > nan deg", 'need a finite number with a unit such as "15 deg", got "nan deg"'),
    ],
)
def test_an_unknown_goal_is_refused_with_allowed_and_nearest_names(until, message):
    with pytest.raises(InputError) as caught:
        stage(1, until=until)
    assert str(caught.value).endswith(f"protocol.stages.1.until: {message}")
    assert len(str(caught.value).splitlines()) == 1


@pytest.mark.parametrize(
    ("drive", "message"),
    [
        ("flod", 'drive: need "none", "fold" or "unfold", got "flod"; did you mean "fold"?'),
        (["fold", "flod"], 'drive: need "none", "fold" or "unfold", got "flod"; did you mean "fold"?'),
        (["fold", "fold"], 'drive: need each drive once, got ["fold", "fold"]'),
        (
            ["fold", "unfold"],
            'drive: need one drive, because a wing is not folded and unfolded in one stage, got ["fold", "unfold"]',
        ),
        *(
            (wrong, f'drive: need a drive by name in quotes, a list of them, or "none", got {written}')
            for wrong, written in ((3, "3"), ([], "[]"), ([3], "[3]"), (True, "true"))
        ),
    ],
)
def test_an_unknown_or_repeated_drive_is_refused(drive, message):
    with pytest.raises(InputError) as caught:
        stage(1, drive=drive)
    assert str(caught.value).endswith(f"protocol.stages.1.{message}")


@pytest.mark.parametrize(
    ("drive", "drives"), [("fold", ("fold",)), (["fold"], ("fold",)), (["none", "fold"], ("fold",))]
)
def test_a_stage_may_have_a_list_of_drives(drive, drives):
    design = stage(1, drive=drive)
    assert stage_drives(design.protocol.stages[1]) == drives
    assert [transition.stage for transition in structure_of(design).transitions] == [1, 3]


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({1: ["unfold"]}, 'need at most one stage with drive = "unfold", got 2'),
        ({3: ["none", "fold"]}, 'need at most one stage with drive = "fold", got 2'),
        ({1: ["none"]}, 'need a stage with drive = "fold" before the one with drive = "unfold", got '),
        (
            {0: ["fold"], 1: "none"},
            'need a first stage with drive = "none", which ends in the flat state, got ["fold"]',
        ),
    ],
)
def test_the_drives_of_a_fan_count_in_lists_as_alone(values, message):
    with pytest.raises(InputError) as caught:
        with_values(REFERENCE, {f"protocol.stages.{number}.drive": drive for number, drive in values.items()})
    assert f"protocol.stages: {message}" in str(caught.value)


def test_stages_that_name_no_state_end_flat_folded_and_opened_after_their_releases():
    assert structure_of(REFERENCE).stage_states == ("flat", "", "folded", "", "opened")
    assert structure_of(stage(2, drive="none", until="time")).stage_states == ("flat", "", "folded", "", "opened")


BETWEEN = 'from the stage with drive = "fold" to the one with drive = "unfold"'


def test_stages_may_name_the_states_at_their_ends_themselves():
    named = with_values(REFERENCE, {"protocol.stages.1.state": "folded", "protocol.stages.3.state": "opened"})
    # a protocol that names one state must name all
    assert structure_of(named).stage_states == ("", "folded", "", "opened", "")
    assert named.hash != REFERENCE.hash


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({2: "fold"}, '2.state: need "flat", "folded" or "opened", got "fold"; did you mean "folded"?'),
        ({2: "sideways"}, '2.state: need "flat", "folded" or "opened", got "sideways"'),
        ({2: ""}, '2.state: need "flat", "folded" or "opened", got ""'),
        ({1: "folded", 2: "folded"}, '2.state: need a name that is not used yet, got "folded" again'),
        ({0: "folded", 1: "flat"}, '0.state: need "flat" before the stage with drive = "fold", got "folded"'),
        ({1: "flat"}, f'1.state: need "folded" {BETWEEN}, got "flat"'),
        ({2: "opened"}, f'2.state: need "folded" {BETWEEN}, got "opened"'),
        ({3: "folded"}, '3.state: need "opened" from the stage with drive = "unfold" on, got "folded"'),
    ],
)
def test_an_unknown_unreached_or_repeated_state_is_refused(values, message):
    with pytest.raises(InputError) as caught:
        with_values(REFERENCE, {f"protocol.stages.{number}.state": state for number, state in values.items()})
    assert str(caught.value).endswith(f"protocol.stages.{message}")
