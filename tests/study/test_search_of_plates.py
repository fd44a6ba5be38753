"""Searches on plates: drives of either sign, and states in which their releases end."""

import math

import pytest

import forficula as ff
from forficula.design import with_values
from forficula.errors import InputError
from forficula.show.page.data.study_data import study_data
from forficula.study import load_study, run_study, table_csv
from tests.letters import LONG_STEPS

STEPS = "".join(f'"{key}" = "{value}"\n' for key, value in LONG_STEPS.items())
FACTORS = '"tendon.left.stiffness" = ["0.4 N/cm", "0.6 N/cm"]\n'
HEAD = f'design = "letter-fold"\nask = "least-torques"\n[settings]\n{STEPS}[factors]\n{FACTORS}'
TORQUES = (
    '[search]\nclose_torques = "0.1..0.7 N cm step 0.1"\nclose_with = "3 N cm"\nopen_torques = "0.5..3 N cm step 0.5"\n'
)


@pytest.fixture
def searched(tmp_path):
    def run(text):
        (tmp_path / "letters.toml").write_text(text, "utf-8")
        study = load_study(tmp_path / "letters.toml")
        return study, run_study(study, tmp_path / "out")

    return run


def test_the_least_torques_of_a_letter_are_those_of_single_runs(searched):
    """The second drive is negative: its magnitude is searched, and runs use it with its sign."""
    study, table = searched(HEAD + TORQUES)
    for point, values in enumerate(study.points):
        base = with_values(study.base, values)

        def ran(key, torque, base=base):
            outcome = ff.measure(ff.run(with_values(base, {key: torque}), confirm=False))
            assert outcome.verdict.conclusive
            return outcome

        close, back = (float(table[f"least_{name}_value"][point]) for name in ("close", "open"))
        least = ran("drive.close.value", close)
        assert least.holds["closed"]
        assert not ran("drive.close.value", close - 0.001).holds["closed"]
        # 60 N/m keeps it closed against all tried torques
        assert math.isnan(back) == (point == 1)
        assert ran("drive.open.value", -0.03 if point else -back).holds["opened"] == (point == 0)
        assert point or not ran("drive.open.value", -(back - 0.005)).holds["opened"]
        closed = least.states["closed"]
        assert float(table["closed_energy"][point]) == pytest.approx(closed.tendon_energy.sum(), rel=1e-3)
        assert float(table["closed_hinge_energy"][point]) == pytest.approx(closed.hinge_energy.sum(), rel=1e-3)
    assert "closed_hinge_energy_J" in table_csv(study, table).splitlines()[0]
    titles = {item["name"]: item["title"] for item in study_data(study, table)["quantities"]}
    assert titles["closed_energy"] == "tendons' energy when closed"
    assert titles["closed_hinge_energy"] == "springs' energy when closed"


def test_two_transitions_by_one_drive_cannot_have_two_torques(searched, tmp_path):
    design = ff.load_design("letter-fold")
    stages = [stage.model_dump() for stage in design.protocol.stages]
    stages[3] |= {"drive": "close", "until": "creases > 120 deg"}
    both = with_values(design, {"protocol.stages": stages})
    ff.design.save_design(both, tmp_path / "both.toml")
    with pytest.raises(InputError, match=r"transitions with drives of their own, got drive\.close\.value for both"):
        searched(HEAD.replace("letter-fold", "both.toml") + TORQUES)


def test_the_least_value_of_a_letter_may_be_negative(searched):
    text = HEAD.replace("least-torques", "least-value") + (
        '[search]\nkey = "crease.rest_angle"\nvalues = "-20..100 deg step 40"\nstate = "closed"\n'
    )
    _, table = searched(text)
    assert all(math.isfinite(float(value)) for value in table["least_rest_angle"])


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("close.value", "clos.value", "drive.clos.value: need "),
        ('"closed"', '"closd"', 'search.state: need "closed" or "opened", got "closd"; did you mean "closed"?'),
        ("least-value", "least-valeu", 'did you mean "least-value"?'),
        ('key = "drive.close.value"', "", "search.key: is missing"),
        ('"1..3 N cm step 1"', '"3..1 N cm step 1"', "search.values: need a range that rises"),
    ],
)
def test_a_meaningless_search_is_rejected_before_a_run(searched, old, new, message):
    text = HEAD.replace("least-torques", "least-value")
    text += '[search]\nkey = "drive.close.value"\nvalues = "1..3 N cm step 1"\nstate = "closed"\n'
    assert old in text
    with pytest.raises(InputError) as caught:
        searched(text.replace(old, new))
    assert message in str(caught.value)
