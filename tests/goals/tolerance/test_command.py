"""The command for the probability that a design works within its tolerances."""

import json

import pytest

from forficula.cli import main
from forficula.design import load_design, save_design
from tests.letters import QUICK

FEW = ("--tolerance", "facet.thickness=1 %", "--minutes", "0.01")


@pytest.fixture
def called(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    save_design(load_design("letter-fold", QUICK), tmp_path / "letter.toml")

    def call(*arguments, expected=0):
        status = 0
        try:
            main(arguments)
        except SystemExit as ended:
            status = ended.code or 0
        assert status == expected
        return capsys.readouterr()

    return call


@pytest.mark.usefixtures("undrawn")
def test_command_writes_a_folder_with_the_probability_and_figures(called, tmp_path):
    output = json.loads(called("tolerance", "letter.toml", *FEW, "--keep", "1", "--json").out)
    assert output["works"]["works"] + output["works"]["fails"] + output["works"]["unknown"] == 16
    assert output["tolerances"] == {"facet.thickness": "± 1 %"}
    folder = tmp_path / "out" / "letter-fold-tolerance"
    for name in ("tolerance.nc", "table.csv", "report.html", "design.toml", "plan.json", "runs"):
        assert (folder / name).exists()
    again = called("tolerance", "letter.toml", *FEW, "--keep", "1")
    assert "replaces the tolerance of letter-fold; the rows are kept" in again.err
    assert "letter-fold: The design works in" in again.out
    assert json.loads((folder / "tolerance.json").read_text("utf-8")) == output


def test_dry_run_reports_the_time_and_writes_nothing(called, tmp_path):
    output = called("tolerance", "letter.toml", *FEW, "--dry-run").out
    assert output.startswith(
        "letter-fold: 1 value with a tolerance; 16 points for the probability, at most 17 runs in total, about"
    )
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--tolerance", "facet.thicknes=1 %"), "did you mean facet.thickness"),
        (("--tolerance", "facet.thickness"), "--tolerance: need KEY=VALUE"),
        (("--minutes", "0"), "minutes: need a number > 0"),
        (("--seed", "1.5"), "need a whole number"),
        (("--shard", "3/2"), "--shard: need a number and a count"),
        (("--goal", "heavy-wing"), "neither a named goal"),
    ],
)
def test_errors_are_one_line(called, arguments, message):
    output = called("tolerance", "letter-fold", *arguments, expected=1).err.splitlines()
    assert message in output[-1]


GOAL = """
design = "letter.toml"
[settings]
"protocol.timestep" = "0.4 ms"
"tendon.left.stiffness" = "0.49 N/cm"
[vary]
"tendon.right.stiffness" = { low = "0.4 N/cm", high = "0.6 N/cm" }
[objectives]
mass = "least"
[tolerances]
"facet.thickness" = "1 %"
"""


@pytest.mark.usefixtures("undrawn")
def test_a_design_runs_with_the_settings_of_the_goal_which_are_reported(called, tmp_path):
    (tmp_path / "goal.toml").write_text(GOAL, "utf-8")
    said = called("tolerance", "letter.toml", "--goal", "goal.toml", "--minutes", "0.01", "--keep", "0").err
    assert "and tendon.left.stiffness set to the values of goal.toml" in said
    built = load_design(str(tmp_path / "out" / "letter-fold-tolerance" / "design.toml"))
    assert built.protocol.timestep == pytest.approx(4e-4)
    assert built.tendon[0].stiffness == pytest.approx(49.0)


def test_the_design_of_the_goal_is_the_default(called, tmp_path):
    (tmp_path / "goal.toml").write_text(GOAL, "utf-8")
    output = json.loads(called("tolerance", "--goal", "goal.toml", "--dry-run", "--json").out)
    assert output["design"] == "letter-fold"
    assert output["values"] == ["facet.thickness"]
    assert output["points"] <= output["most_runs"]
    said = called("tolerance", expected=1).err
    assert "tolerance: need a design, or --goal with a file that has one" in said
