"""Identifications in folders: interrupted ones give the same result, and all write their files."""

import json
import os

import numpy as np
import pytest
import xarray

import forficula as ff
from forficula.cli import main
from forficula.design import load_design, save_design
from forficula.errors import InputError
from forficula.goals.identify import observations_of
from forficula.goals.identify.run_identify import identify
from forficula.show.goals.identify_figures import identify_drawings
from forficula.show.goals.identify_text import together_sentences
from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH, description
from forficula.study.running.evaluate import stored_energy
from tests.forks import forks
from tests.letters import LONG_STEPS, QUICK

# a sheet that closes and opens in a fraction of a second
HIDDEN = {"tendon.left.stiffness": "0.5 N/cm", "crease.damping": "0.04 N m s/rad/m"}
UNKNOWN = {
    "tendon.left.stiffness": {"distribution": "uniform", "low": "0.2 N/cm", "high": "1 N/cm"},
    "crease.damping": {"distribution": "log-uniform", "low": "0.01 N m s/rad/m", "high": "0.1 N m s/rad/m"},
}


@pytest.fixture(scope="module")
def planted():
    """Observations of a sheet with hidden values: when it closed, and its energy while open."""
    letter = load_design("letter-fold", LONG_STEPS)
    outcome = ff.measure(ff.run(letter.with_values(HIDDEN), confirm=False))
    time, stored = outcome.transitions["close"].time, stored_energy(outcome.states["flat"])
    close = {"until": "close"}
    facts = [
        {**close, "name": "closes as seen", "quantity": "close_time", "absent": "2 s", "equals": f"{time} s",
         "tolerance": "10 ms"},
        {**close, "name": "stores as much", "quantity": "flat_energy", "absent": "0 J", "equals": f"{stored} J",
         "tolerance": "2 mJ"},
    ]  # fmt: skip
    tables = {"name": "planted", "design": letter, "unknown": UNKNOWN, "fact": facts}
    return observations_of({**tables, "sampling": {"samples": 16, "directed": 24}})


@pytest.fixture(scope="module")
def result(planted, tmp_path_factory):
    return identify(planted, tmp_path_factory.mktemp("identify"))


class KilledError(Exception):
    """A process that ends at once."""


def test_hidden_values_of_a_sheet_are_identified_from_its_times(result):
    near = result.isel(sample=int(np.argmin(result.scaled_distance.sum("fact").values)))
    spread = np.ptp(result.value.values, axis=0)
    # the nearest sample deviates by a small fraction of the differences between samples
    assert (near.distance.values < 0.2 * spread).all()
    assert float(near.crease_damping) == pytest.approx(0.04, rel=0.3)
    assert float(near.tendon_left_stiffness) == pytest.approx(50, rel=0.2)


def test_an_interrupted_identification_gives_the_same_result(planted, result, tmp_path):
    # interrupted twice among the drawn samples, and once among the placed ones
    for stop in (5, 5, 15):
        left = [stop]

        def count(_done, _wanted, _row, left=left):
            left[0] -= 1
            if not left[0]:
                raise KilledError

        with pytest.raises(KilledError):
            identify(planted, tmp_path, run_progress=count)
    ran = []
    again = identify(planted, tmp_path, run_progress=lambda *report: ran.append(report))
    assert 0 < len(ran) < result.attrs["runs"]
    xarray.testing.assert_identical(again, result)
    identify(planted, tmp_path, run_progress=lambda *_: pytest.fail("ran what was there"))


SEEN = """
design = "letter.toml"
[unknown]
"tendon.left.stiffness" = { distribution = "uniform", low = "0.2 N/cm", high = "1 N/cm" }
"crease.damping" = { distribution = "log-uniform", low = "0.01 N m s/rad/m", high = "0.1 N m s/rad/m" }
[sampling]
samples = 16
directed = 8
[[fact]]
name = "closes soon"
quantity = "close_time"
until = "close"
absent = "2 s"
at_most = "0.25 s"
[[fact]]
name = "stores little"
quantity = "flat_energy"
until = "close"
absent = "0 J"
at_most = "40 mJ"
"""


# runs the identification without the start and end of the command line, which take longer than these runs
IMPORTS = """
from forficula.goals.identify import load_observations
from forficula.goals.identify.run_identify import identify
"""
IDENTIFY = "identify(load_observations(sys.argv[1]), sys.argv[2])"


@pytest.mark.skipif(os.name != "posix", reason="signals are POSIX's")
@pytest.mark.usefixtures("undrawn")
def test_command_killed_at_any_moment_continues_and_ends_with_the_same_bytes(tmp_path):
    file, whole, out = tmp_path / "seen.toml", tmp_path / "whole", tmp_path / "killed"
    save_design(load_design("letter-fold", QUICK), tmp_path / "letter.toml")
    file.write_text(SEEN, "utf-8")
    main(["identify", str(file), "--out", str(whole)])
    # among the drawn samples, at their end, or among the placed ones
    journal = out / "journal.jsonl"
    with forks(IMPORTS, IDENTIFY, file, out) as kill_once:
        killed = [
            kill_once(lambda rows=rows: journal.exists() and journal.read_bytes().count(b"\n") > rows)
            for rows in (3, 16)
        ]
    assert killed[0]
    assert not (out / "identified.nc").exists()
    main(["identify", str(file), "--out", str(out)])
    for name in ("identified.json", "samples.csv", "summary.txt"):
        assert (out / name).read_bytes() == (whole / name).read_bytes()
    tables = [xarray.load_dataset(folder / "identified.nc", engine="h5netcdf") for folder in (whole, out)]
    xarray.testing.assert_identical(*tables)
    # completed runs are not repeated; the row that was being written may be truncated
    lines = [line for line in (out / "journal.jsonl").read_text("utf-8").splitlines() if line]
    keys = [json.loads(line)["key"] for line in lines if line.startswith('{"key"') and line.endswith("}")]
    assert len(keys) == len(set(keys)) == tables[0].attrs["runs"]


def test_rows_of_another_design_are_rejected(planted, tmp_path):
    (tmp_path / "journal.jsonl").write_text(
        json.dumps({"written_by": {"schema": 0, "design": "other", "design_hash": "0"}}) + "\n", "utf-8"
    )
    with pytest.raises(InputError, match="rows of another design or other versions"):
        identify(planted, tmp_path)


@pytest.mark.parametrize("width", [COLUMN_WIDTH, PAGE_WIDTH])
def test_figures_have_alternative_texts(result, width):
    output = {name: description(draw(width)) for name, draw in identify_drawings(result).items()}
    assert output.keys() == {"facts", "together", "unknowns", "pairs"}
    assert "closes as seen" in output["facts"]
    assert "tendon.left.stiffness" in output["pairs"]


@pytest.mark.usefixtures("no_figures")
def test_command_writes_its_files_and_reports_agreeing_ranges(tmp_path, capsys):
    file = tmp_path / "seen.toml"
    file.write_text(
        'design = "letter-fold"\n[unknown]\n"tendon.left.stiffness" = ["0.4 N/cm", "0.6 N/cm"]\n'
        '"crease.damping" = ["0.03 N m s/rad/m"]\n[sampling]\nsamples = 4\ndirected = 0\n'
        '[[fact]]\nname = "closes"\nquantity = "close_time"\nabsent = "2 s"\nat_most = "1 s"\n'
        '[[fact]]\nname = "never closes"\nquantity = "closed"\nstatistic = "none"\n',
        "utf-8",
    )
    out = tmp_path / "out"
    main(["identify", str(file), "--out", str(out), "--json"])
    output = json.loads(capsys.readouterr().out)
    assert [fact["met"] for fact in output["facts"]] == [4, 0]
    assert output["facts"][1]["nearest"] == 1
    (pair,) = output["pairs"]
    assert (pair["facts"], pair["told"], pair["met"]) == (["closes", "never closes"], 4, 0)
    assert (pair["met_alone"], pair["verdict"]) == ([4, 0], "one is never met")
    assert "Facts that no sample meets: never closes." in output["sentences"]
    names = {path.name for path in out.iterdir()}
    assert {
        "identified.nc",
        "samples.csv",
        "summary.txt",
        "facts.png",
        "pairs.png",
        "report.html",
        "journal.jsonl",
    } <= names
    lines = (out / "samples.csv").read_text("utf-8").splitlines()
    assert len(lines) == 5
    assert lines[0].startswith("sample,tendon_left_stiffness (N/m),")
    kept = xarray.load_dataset(out / "identified.nc", engine="h5netcdf")
    assert together_sentences(kept) == output["sentences"]
    # numbers of a file are numpy numbers, and are written as the same JSON
    ff.save(kept, tmp_path / "again")
    assert (tmp_path / "again" / "identified.json").read_text("utf-8") == (out / "identified.json").read_text("utf-8")
    main(["figure", str(out), "--kind", "facts", "--out", str(tmp_path / "facts.svg")])
    assert "never closes" in (tmp_path / "facts.svg").read_text("utf-8")


def test_dry_run_reports_the_number_of_runs(tmp_path, capsys):
    file = tmp_path / "seen.toml"
    file.write_text(
        'design = "letter-fold"\n[unknown]\n"tendon.left.stiffness" = ["0.4 N/cm", "0.6 N/cm"]\n'
        '[sampling]\nsamples = 8\ndirected = 8\n[[fact]]\nname = "closes"\nquantity = "closed"\n',
        "utf-8",
    )
    main(["identify", str(file), "--dry-run", "--out", str(tmp_path / "out")])
    assert "seen: 16 samples, about 16 runs" in capsys.readouterr().out
    assert not (tmp_path / "out").exists()
