"""The command line asks how likely a design works as it is built."""

import json

import pytest

from forficula.cli import main

FEW = ("--tolerance", "facet.thickness=1 %", "--minutes", "0.01")


@pytest.fixture
def called(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)

    def call(*arguments, expected=0):
        status = 0
        try:
            main(arguments)
        except SystemExit as ended:
            status = ended.code or 0
        assert status == expected
        return capsys.readouterr()

    return call


def test_a_tolerance_leaves_a_folder_that_says_how_likely_it_works_and_draws_its_figures(called, tmp_path):
    told = json.loads(called("tolerance", "letter-fold", *FEW, "--keep", "1", "--json").out)
    assert told["works"]["works"] + told["works"]["fails"] + told["works"]["unknown"] == 16
    assert told["tolerances"] == {"facet.thickness": "± 1 %"}
    folder = tmp_path / "out" / "letter-fold-tolerance"
    for name in ("tolerance.nc", "table.csv", "report.html", "design.toml", "plan.json", "runs"):
        assert (folder / name).exists()
    again = called("tolerance", "letter-fold", *FEW, "--keep", "1")
    assert "replaces the tolerance there; the rows stay" in again.err
    assert "letter-fold: It works in" in again.out
    assert json.loads((folder / "tolerance.json").read_text("utf-8")) == told


def test_a_dry_run_says_how_long_it_takes_and_leaves_nothing(called, tmp_path):
    told = called("tolerance", "letter-fold", *FEW, "--dry-run").out
    assert told.startswith(
        "letter-fold: 1 value that may be off; 16 points for the probability, at most 17 runs in all, about"
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
def test_what_is_wrong_is_told_in_one_line(called, arguments, message):
    told = called("tolerance", "letter-fold", *arguments, expected=1).err.splitlines()
    assert message in told[-1]
