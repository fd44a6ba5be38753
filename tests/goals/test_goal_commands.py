"""Properties that the three commands on goals share: dry runs, and folders of other goals."""

import json
from contextlib import suppress

import pytest

from forficula.cli import main
from forficula.design import load_design, save_design
from tests.letters import QUICK

GOAL = """
design = "binder2025-joint"
simulate = false
[vary]
"tendon.area" = { low = "1 mm^2", high = "9 mm^2" }
[limits]
hinge_holding_torque = ">= 8 N cm"
[objectives]
mass = "least"
[search]
runs = 16
batch = 16
"""
SEEN = """
design = "letter.toml"
[unknown]
"tendon.left.stiffness" = ["0.4 N/cm", "0.6 N/cm"]
[sampling]
samples = 2
directed = 0
[[fact]]
name = "closes"
quantity = "closed"
until = "close"
"""


@pytest.fixture
def called(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    save_design(load_design("letter-fold", QUICK), tmp_path / "letter.toml")
    for name in ("one", "other"):
        (tmp_path / f"{name}.toml").write_text(GOAL, "utf-8")
        (tmp_path / f"seen-{name}.toml").write_text(SEEN, "utf-8")

    def call(*arguments):
        # a successful command ends without a status, or with 0
        with suppress(SystemExit):
            main(arguments)
        return capsys.readouterr()

    return call


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (("optimise", "one.toml"), {"goal": "one", "most_designs": 16, "neighbours": 0}),
        (("identify", "seen-one.toml"), {"name": "seen-one", "samples": 2, "runs": 2}),
        (
            ("tolerance", "letter.toml", "--tolerance", "facet.thickness=1 %", "--minutes", "0.01"),
            {"design": "letter-fold", "values": ["facet.thickness"], "points": 16, "most_runs": 17},
        ),
    ],
)
def test_dry_run_reports_its_plan_as_data(called, tmp_path, arguments, says):
    output = json.loads(called(*arguments, "--dry-run", "--json").out)
    assert output.pop("time_s") >= 0
    assert output == says
    assert not (tmp_path / "out").exists()


@pytest.mark.usefixtures("undrawn")
def test_result_of_another_goal_is_named_before_it_is_replaced(called):
    called("optimise", "one.toml", "--out", "there", "--keep", "0")
    said = called("optimise", "other.toml", "--out", "there", "--keep", "0").err
    assert "there: replaces the optimisation of one; the rows are kept" in said


@pytest.mark.usefixtures("undrawn")
def test_result_of_other_observations_is_named_before_it_is_replaced(called, tmp_path):
    output = called("identify", "seen-one.toml", "--out", "there", "--json").out
    assert json.loads((tmp_path / "there" / "identified.json").read_text("utf-8")) == json.loads(output)
    said = called("identify", "seen-other.toml", "--out", "there").err
    assert "there: replaces the identification of seen-one; the rows are kept" in said
