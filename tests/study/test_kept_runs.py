"""Kept runs of a study have the outcomes of the table, bitwise, and survive interruptions."""

import json
import shutil
import subprocess
import sys
from contextlib import closing

import numpy as np
import pytest

import forficula as ff
from forficula.dynamics import load_record
from forficula.errors import InputError
from forficula.study import load_study, run_study
from forficula.study.running.kept_runs import kept_runs, runs_to_keep
from tests.forks import forks

FACTORS = '"tendon.stiffness" = ["10 N/cm", "20 N/cm"]\n"tendon.rest_length" = ["0 cm", "6 cm"]'
SEARCH = '[search]\nfold_with = "50 N cm"\nfold_torques = "0..50 N cm step 25"\nunfold_torques = "20..100 N cm step 20"'
# the last value gives no valid wing
PLAIN = '"tendon.stiffness" = ["10 N/cm", "20 N/cm"]\n"pattern.units" = [1, 30]'


@pytest.fixture(scope="module")
def searched(tmp_path_factory, write_study_file):
    """A search whose runs are all kept: the study, its table, its folder, kept runs by name."""
    folder = tmp_path_factory.mktemp("searched")
    path = write_study_file(folder / "small.toml", FACTORS, 'ask = "least-torques"', SEARCH)
    study = load_study(path)
    table = run_study(study, folder)
    return study, table, folder, {kept.folder: kept for kept in kept_runs(runs_to_keep(study, table), folder)}


@pytest.fixture(scope="module")
def plain_once(tmp_path_factory, write_study_file):
    """A study of plain runs, its file, its table and its folder, without kept runs."""
    path = write_study_file(tmp_path_factory.mktemp("plain") / "small.toml", PLAIN)
    study = load_study(path)
    return study, path, run_study(study, path.parent / "out"), path.parent / "out"


@pytest.fixture
def plain(tmp_path, plain_once):
    """A study of plain runs, its table and a folder of its own beside its file."""
    study, path, table, folder = plain_once
    shutil.copy(path, tmp_path)
    shutil.copytree(folder, tmp_path / "out")
    return study, table, tmp_path / "out"


def value(table, name, point):
    return float(table[name].values.ravel()[point])


def again(study, table, folder):
    """Kept runs by name, and the number of runs that they needed."""
    seen = []
    runs = kept_runs(runs_to_keep(study, table), folder, progress=lambda done, needed, _: seen.append((done, needed)))
    return {run.folder: run for run in runs}, seen


def energy(state):
    return float(np.sum(state.tendon_energy))


def names(folder):
    return sorted(place.name for place in (folder / "runs").iterdir())


def test_kept_folding_equals_the_table_bitwise(searched):
    _, table, _, kept = searched
    folds = np.flatnonzero(np.isfinite(table["least_fold_torque"].values.ravel()))
    assert 0 < len(folds) < 4
    for point in folds:
        outcome = kept[f"runs/{point + 1}-folding"].outcome
        assert outcome.transitions["fold"].strength == value(table, "least_fold_torque", point)
        assert outcome.transitions["fold"].time == value(table, "fold_time", point)
        assert outcome.transitions["fold"].work == value(table, "fold_work", point)
        assert energy(outcome.states["flat"]) == value(table, "flat_energy", point)
        assert energy(outcome.states["folded"]) == value(table, "folded_energy", point)


def test_kept_opening_equals_the_table_bitwise(searched):
    study, table, _, kept = searched
    opens = np.flatnonzero(np.isfinite(table["least_unfold_torque"].values.ravel()))
    assert len(opens) > 0
    for point in opens:
        outcome = kept[f"runs/{point + 1}-opening"].outcome
        assert (outcome.status, outcome.holds["opened"]) == ("folded and opened", True)
        assert outcome.transitions["fold"].strength == study.search.reference
        assert outcome.transitions["unfold"].strength == value(table, "least_unfold_torque", point)
        assert outcome.transitions["unfold"].time == value(table, "unfold_time", point)
        assert outcome.transitions["unfold"].work == value(table, "unfold_work", point)
        assert energy(outcome.states["opened"]) == value(table, "opened_energy", point)


def test_a_kept_run_has_its_transition(searched):
    _, _, _, kept = searched
    assert {(run.part, run.transition) for run in kept.values()} == {("folding", 0), ("opening", 1)}


def test_largest_torque_is_kept_if_none_works(searched):
    study, table, _, kept = searched
    fails = np.flatnonzero(np.isnan(table["least_fold_torque"].values.ravel()))
    assert len(fails) > 0
    for point in fails:
        run = kept[f"runs/{point + 1}-folding"]
        assert run.outcome.transitions["fold"].strength == study.search.first.values[-1]
        # the row contains the torque, too
        assert table["status"].values.ravel()[point].startswith(f"{run.outcome.status} (fold with ")
        assert f"runs/{point + 1}-opening" not in kept
    folds = np.isfinite(table["least_fold_torque"].values.ravel())
    closed = np.flatnonzero(folds & np.isnan(table["least_unfold_torque"].values.ravel()))
    for point in closed:
        assert (
            kept[f"runs/{point + 1}-opening"].outcome.transitions["unfold"].strength == study.search.second.values[-1]
        )


def test_a_kept_run_is_the_folder_of_a_run(searched):
    _, _, folder, kept = searched
    for name, run in kept.items():
        record = load_record(folder / name / "record.nc")
        assert np.array_equal(record.time, run.record.time)
        assert json.loads((folder / name / "summary.json").read_text())["status"] == run.outcome.status
        assert ff.load_design(folder / name / "design.toml").hash == record.design.hash


def test_existing_runs_are_read_and_not_repeated(searched):
    study, table, folder, kept = searched
    read, seen = again(study, table, folder)
    assert seen == []
    assert read.keys() == kept.keys()
    for name, item in read.items():
        assert repr(item.outcome) == repr(kept[name].outcome)


def test_a_plain_study_keeps_the_run_of_each_valid_point(plain):
    study, table, folder = plain
    kept, seen = again(study, table, folder)
    assert names(folder) == ["1", "3"]
    assert sorted(item.point for item in kept.values()) == [0, 2]
    for item in kept.values():
        assert item.outcome.transitions["fold"].work == value(table, "fold_work", item.point)
        assert item.outcome.status == table["status"].values.ravel()[item.point]
    assert seen == [(1, 2), (2, 2)]


def test_folded_points_are_kept_evenly_spread_if_there_are_many(searched):
    study, table, _, _ = searched
    folded = np.flatnonzero(np.isfinite(table["least_fold_torque"].values.ravel())).tolist()
    assert len(folded) == 3
    assert sorted({run.point for run in runs_to_keep(study, table, 2)}) == [folded[0], folded[-1]]
    assert {run.point for run in runs_to_keep(study, table, 3)} == set(folded)
    assert {run.point for run in runs_to_keep(study, table, 4)} == {0, 1, 2, 3}
    assert runs_to_keep(study, table, 0) == []


def test_obsolete_runs_are_removed_and_other_files_stay(plain):
    study, table, folder = plain
    list(kept_runs(runs_to_keep(study, table), folder))
    (folder / "runs" / "3" / "film.mp4").write_bytes(b"mine")
    (folder / "runs" / ".3-abcd1234").mkdir()
    (folder / "runs" / ".notes").mkdir()
    list(kept_runs([], folder))
    assert names(folder) == [".notes", "3"]
    assert [place.name for place in (folder / "runs" / "3").iterdir()] == ["film.mp4"]


def test_a_run_of_other_versions_or_of_another_design_or_torn_is_run_again(plain):
    study, table, folder = plain
    first, _ = again(study, table, folder)
    summary, record = (folder / "runs" / "1" / name for name in ("summary.json", "record.nc"))
    for damage in (
        lambda: summary.write_text(summary.read_text().replace('"mujoco": "', '"mujoco": "0.')),
        lambda: summary.write_text(summary.read_text().replace('"key": "', '"key": "x')),
        lambda: summary.write_text(summary.read_text()[:100]),
        lambda: record.write_bytes(b"torn"),
        record.unlink,
    ):
        damage()
        kept, seen = again(study, table, folder)
        assert len(seen) == 1
        assert repr(kept["runs/1"].outcome) == repr(first["runs/1"].outcome)


@pytest.mark.parametrize("most", [-1, 1.5, True, "all"])
def test_an_invalid_number_of_points_is_rejected(plain, most):
    study, table, _ = plain
    with pytest.raises(InputError, match=r"need a whole number of points >= 0, got"):
        runs_to_keep(study, table, most)


def test_a_folder_that_cannot_be_written_is_an_error_that_names_it(plain):
    study, table, folder = plain
    (folder / "runs").write_text("a file")
    with pytest.raises(InputError, match="runs"):
        list(kept_runs(runs_to_keep(study, table), folder))


IMPORTS = """
import xarray
from forficula.study import load_study
from forficula.study.running.kept_runs import kept_runs, runs_to_keep
study, table = load_study(sys.argv[1]), xarray.load_dataset(sys.argv[2], engine="h5netcdf")
"""
KEEP = "list(kept_runs(runs_to_keep(study, table), sys.argv[3]))"


def test_an_interrupted_call_continues(plain, tmp_path):
    study, table, folder = plain
    whole = {run.folder: run for run in kept_runs(runs_to_keep(study, table), tmp_path / "whole")}
    table.to_netcdf(tmp_path / "table.nc", engine="h5netcdf")
    with forks(IMPORTS, KEEP, tmp_path / "small.toml", tmp_path / "table.nc", folder) as kill_once:
        assert kill_once((folder / ".runs.lock").exists)
        kill_once((folder / "runs" / "1").exists)
    again = {run.folder: run for run in kept_runs(runs_to_keep(study, table), folder)}
    assert {name: repr(item.outcome) for name, item in again.items()} == {
        name: repr(item.outcome) for name, item in whole.items()
    }
    assert names(folder) == ["1", "3"]
    # no hidden files are left, neither in this folder nor in the folders of the runs
    assert list(folder.rglob(".*")) == []


def test_leftovers_of_a_killed_process_are_removed(plain):
    study, table, folder = plain
    script = (
        "import os, signal, sys\nfrom pathlib import Path\nfrom forficula.files import replacing_all\n"
        "for name in ('1', '7-folding'):\n"
        "    if not os.fork():\n"
        "        with replacing_all(Path(sys.argv[1]) / 'runs' / name) as unfinished:\n"
        "            (unfinished / 'record.nc').write_text('half')\n"
        "            os.kill(os.getpid(), signal.SIGKILL)\n"
        "    os.wait()\n"
    )
    subprocess.run([sys.executable, "-c", script, folder], check=True)
    assert len(list(folder.rglob("runs/*/.forficula-*-work"))) == 2
    again(study, table, folder)
    assert names(folder) == ["1", "3"]
    assert list(folder.rglob(".*")) == []


def test_a_run_of_the_user_in_that_folder_stays(plain):
    study, table, folder = plain
    again(study, table, folder)
    (folder / "runs" / "1").rename(folder / "runs" / "favourite")
    list(kept_runs([], folder))
    assert names(folder) == ["favourite"]
    assert len(list((folder / "runs" / "favourite").iterdir())) == 3


def test_two_processes_that_keep_runs_in_one_folder_wait_for_each_other(plain):
    study, table, folder = plain
    first = kept_runs(runs_to_keep(study, table), folder)
    next(first)
    # this call needs none of the existing runs
    script = (
        "import sys\n"
        "from forficula.study.running.kept_runs import kept_runs\n"
        "assert not list(kept_runs([], sys.argv[1]))"
    )
    command = [sys.executable, "-c", script, folder]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as second, closing(first):
        assert second.stderr.readline() == f"waiting for another process that writes to {folder}\n"
        assert len(names(folder)) >= 1
        # while the first process works; the second one removes them right after it
        assert [names(folder) for _ in first] == [["1", "3"]]
        assert second.communicate()[1] == ""
    assert second.returncode == 0
    assert not (folder / "runs").exists()
