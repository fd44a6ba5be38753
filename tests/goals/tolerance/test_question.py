"""Questions of tolerance analyses: varying values, their deviations, and conditions for working."""

import numpy as np
import pytest

from forficula.design import load_design
from forficula.errors import InputError
from forficula.goals.tolerance.question_file import question_of


@pytest.fixture(scope="module")
def design():
    return load_design("binder2025")


def test_default_tolerances_are_ten_per_cent_on_positive_values_outside_the_protocol(design):
    question = question_of(design)
    assert question.assumed
    assert "tendon.stiffness" in question.keys
    assert not any(key.startswith("protocol.") for key in question.keys)
    assert {deviation.size for deviation in question.deviations} == {0.1}
    assert question.width_text(0) == "± 10 %"


def test_arguments_override_tolerances_and_limits_of_a_file(design, tmp_path):
    path = tmp_path / "asked.toml"
    path.write_text('[tolerances]\n"tendon.stiffness" = "5 %"\n[limits]\nfold_time = "<= 40 ms"\n', "utf-8")
    question = question_of(design, goal=path)
    assert question.keys == ("tendon.stiffness",)
    assert [str(limit) for limit in question.limits] == ["fold_time <= 0.04 s"]
    assert question.sources == ("run",)
    question = question_of(design, {"vein.diameter": "0.1 mm"}, goal=path)
    assert question.keys == ("vein.diameter",)
    assert question.width_text(0) == "± 0.1 mm"


def test_a_named_goal_gives_its_torques_tolerances_and_required_probability(design):
    question = question_of(design, goal="light-wing")
    assert question.design.protocol.fold_torque == pytest.approx(0.2)
    assert [str(limit) for limit in question.wanted] == ["probability >= 95 %"]
    assert all("torque" in str(limit) for limit in question.limits)


def test_values_out_of_bounds_are_detected_before_a_run(design):
    question = question_of(design, {"hinge.fold_limit": "10 %", "tendon.stiffness": "10 %"})
    assert question.allows(np.array([-1.0, 1.0]))
    # further than folded flat
    assert not question.allows(np.array([0.1, 0.0]))
    assert not question.allows(np.array([0.0, -11.0]))


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"tolerances": {"tendon.stifness": "5 %"}}, r"tendon\.stifness"),
        ({"tolerances": {"tendon.stiffness": "-5 %"}}, "tendon.stiffness: need a tolerance > 0"),
        ({"tolerances": "5 %"}, "tolerances: need them by key"),
        ({"tolerances": {}}, "tolerances: need at least one"),
        ({"limits": {"fold_time": "quick"}}, r"limits\.fold_time: need a limit such as"),
        ({"limits": {"least_fold_torque": ">= 5 N cm"}}, "least_fold_torque: need an upper limit"),
        ({"goal": "heavy-wing"}, "neither a named goal"),
    ],
)
def test_errors_name_the_key(design, arguments, message):
    with pytest.raises(InputError, match=message):
        question_of(design, **arguments)


def test_errors_in_a_table_name_the_file(design, tmp_path):
    path = tmp_path / "asked.toml"
    path.write_text('[tolerance]\n"tendon.stiffness" = "5 %"\n', "utf-8")
    with pytest.raises(InputError, match=r"asked\.toml: .*did you mean tolerances"):
        question_of(design, goal=path)


def test_settings_of_a_goal_apply_except_to_varied_and_overridden_keys(design, tmp_path):
    path = tmp_path / "asked.toml"
    path.write_text(
        'design = "binder2025-joint"\n[settings]\ntendon.stiffness = "7 N/cm"\nvein.diameter = "4 mm"\n'
        'protocol.timestep = "0.1 ms"\n[vary."tendon.stiffness"]\nlow = "1 N/cm"\nhigh = "9 N/cm"\n',
        "utf-8",
    )
    provided = design.with_values({"vein.diameter": "6 mm"})
    requested = question_of(provided, goal=path, settings={"vein.diameter": "6 mm"}).design
    assert requested.protocol.timestep == pytest.approx(1e-4)
    assert requested.vein.diameter == pytest.approx(6e-3)
    # the best design of a search has its own value of the varied key
    assert requested.tendon.stiffness == design.tendon.stiffness
    alone = question_of(None, goal=path, settings={"protocol.timestep": "0.2 ms"}).design
    assert alone.name == "binder2025-joint"
    assert alone.tendons[0].stiffness == pytest.approx(700.0)
    assert alone.protocol.timestep == pytest.approx(2e-4)


def test_settings_without_a_key_in_the_design_are_reported_with_the_goal(design, tmp_path):
    path = tmp_path / "asked.toml"
    path.write_text('[settings]\n"facet.thickness" = "1 mm"\n', "utf-8")
    with pytest.raises(InputError, match=r"asked\.toml: settings: facet: unknown key"):
        question_of(design, goal=path)
    with pytest.raises(InputError, match=r"asked\.toml: design: is missing"):
        question_of(None, goal=path)
