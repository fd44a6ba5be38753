import json
import os
import random
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from forficula.cli import main
from forficula.cores import usable_cores
from forficula.errors import InputError
from forficula.show.study.maps import draw_torque_maps
from forficula.study import collect, estimate, load_study, run_study, table_csv
from forficula.study.running.evaluate import evaluate
from forficula.study.running.plan import StudyPlan
from forficula.study.study_designs import point_design
from tests.forks import forks
from tests.show.study.test_maps import legend

TENDONS = '"tendon.stiffness" = "10..30 N/cm step 10"\n"tendon.rest_length" = ["5 cm", "9 cm"]'
LEAST_TORQUES = 'ask = "least-torques"'
# every factor needs another model, and the last two points are no valid wings
MIXED = '"pattern.units" = [1, 2, 30]\n"pattern.hub_radius" = ["1.5 cm", "1.8 cm"]'


def keys(folder):
    """The keys of the rows in all journals, in their order, and the number of truncated lines."""
    result, torn = [], 0
    for path in sorted(folder.glob("journal*.jsonl")):
        for line in path.read_bytes().split(b"\n"):
            try:
                result.append(json.loads(line).get("key"))
            except ValueError:
                torn += bool(line)
    return [key for key in result if key is not None], torn


def by_key(rows):
    return {row["key"]: row for row in rows}


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory):
    """Run a study without interruption, once; its table and its folder, by the text of the study."""
    done = {}

    def run(path):
        text = Path(path).read_text()
        if text not in done:
            folder = tmp_path_factory.mktemp("whole") / "out"
            done[text] = run_study(load_study(path), folder), folder
        return done[text]

    return run


@pytest.fixture(scope="module")
def whole(undisturbed):
    """The table of an uninterrupted study."""
    return lambda path: undisturbed(path)[0]


@pytest.mark.parametrize("batch", [1, 7, 1024])
@pytest.mark.parametrize("threads", [1, 2])
def test_rows_have_the_same_bits_whatever_the_threads_and_the_size_of_a_batch(
    tmp_path, study_file, whole, threads, batch
):
    path = study_file(TENDONS)
    table = run_study(load_study(path), tmp_path / "out", threads=threads, batch=batch)
    assert table.identical(whole(path))


def test_rows_have_the_same_bits_in_any_order(study_file):
    designs = list(StudyPlan(load_study(study_file(TENDONS))).values())
    first = by_key(evaluate(designs))
    shuffled = random.Random(5).sample(designs, len(designs))
    assert by_key(evaluate(designs[::-1])) == first
    assert by_key(evaluate(shuffled)) == first


@pytest.mark.parametrize("batch", [1, 5])
def test_a_search_gives_the_same_bits_whatever_shares_a_batch(tmp_path, study_file, whole, batch):
    # coarse steps are unreliable with the 500 N cm of other tests
    search = '[search]\nfold_with = "50 N cm"\n'
    search += 'fold_torques = "0..50 N cm step 25"\nunfold_torques = "50..100 N cm step 25"\nrefinements = 1'
    path = study_file('"tendon.stiffness" = ["10 N/cm", "20 N/cm"]', head=LEAST_TORQUES, tail=search)
    assert run_study(load_study(path), tmp_path / "out", batch=batch).identical(whole(path))


def test_a_complete_study_runs_nothing_again(tmp_path, study_file):
    study, rows = load_study(study_file(TENDONS)), []
    table = run_study(study, tmp_path)
    assert run_study(study, tmp_path, progress=lambda *report: rows.append(report)).identical(table)
    assert rows == []
    assert estimate(study, tmp_path) == (6, 0, 0.0)


def test_progress_counts_the_runs_up_to_all_of_them(tmp_path, study_file):
    seen = []
    run_study(load_study(study_file(TENDONS)), tmp_path, batch=4, progress=lambda *report: seen.append(report))
    assert [(done, needed) for done, needed, _ in seen] == [(number, 6) for number in range(1, 7)]
    assert {row["outcome"] for _, _, row in seen} <= {
        *("folded and opened", "did not open", "did not stay open", "did not fold", "still folding", "still opening"),
        "undecided",
    }


@pytest.mark.parametrize("batch", [5, 1024])
def test_number_of_needed_runs_never_shrinks_and_is_reached(tmp_path, study_file, batch):
    # coarse steps are unreliable with the 500 N cm of other tests
    search = '[search]\nfold_with = "50 N cm"\n'
    search += 'fold_torques = "0..50 N cm step 25"\nunfold_torques = "20..100 N cm step 10"\nrefinements = 1'
    study, seen = load_study(study_file(TENDONS, LEAST_TORQUES, search)), []
    run_study(study, tmp_path, batch=batch, progress=lambda *report: seen.append(report))
    done, needed, rows = zip(*seen, strict=True)
    assert list(needed) == sorted(needed)
    assert list(done) == sorted(done)
    assert done[-1] == needed[-1]
    # some wings open before the largest torque: runs no longer needed count as completed
    assert any(row["opened"] for row in rows)
    assert len(rows) < done[-1]


def test_the_first_points_run_before_the_last_designs_are_built(tmp_path, study_file, monkeypatch):
    built, seen = [], []
    monkeypatch.setattr(sys.modules["forficula.study.running.run_study"], "_WINDOW", 2)
    plan = sys.modules["forficula.study.running.plan"]
    monkeypatch.setattr(plan, "point_design", lambda *report: built.append(report) or point_design(*report))
    study = load_study(study_file(TENDONS))
    table = run_study(study, tmp_path, progress=lambda *report: seen.append((len(built), *report[:2])))
    assert seen == [(2, 1, 6), (2, 2, 6), (4, 3, 6), (4, 4, 6), (6, 5, 6), (6, 6, 6)]
    assert table.identical(run_study(study, tmp_path))


def test_a_study_of_many_points_has_the_table_of_one_whose_points_are_all_in_memory(
    tmp_path, study_file, whole, monkeypatch
):
    path = study_file(TENDONS)
    for module, name, number in (
        ("running.run_study", "_WINDOW", 2),
        ("running.plan", "_MOST_DESIGNS", 1),
        ("running.stored_rows", "_MOST_IN_MEMORY", 1),
        ("tables.point_columns", "POINTS_TOGETHER", 4),
        ("tables.table", "POINTS_TOGETHER", 4),
        ("tables.table_rows", "POINTS_TOGETHER", 4),
    ):
        monkeypatch.setattr(sys.modules[f"forficula.study.{module}"], name, number)
    study, seen = load_study(path), []
    for number in (1, 2):
        run_study(study, tmp_path, shard=(number, 2), progress=lambda *report: seen.append(report))
    assert collect(study, tmp_path).identical(whole(path))
    assert len(seen) == 6
    assert run_study(study, tmp_path, progress=lambda *report: seen.append(report)).identical(whole(path))
    assert len(seen) == 6
    assert table_csv(study, collect(study, tmp_path)) == table_csv(load_study(path), whole(path))


def test_many_missing_runs_are_not_counted_to_the_end(tmp_path, study_file, monkeypatch):
    study = load_study(study_file(TENDONS))
    monkeypatch.setattr(sys.modules["forficula.study.running.run_study"], "_MOST_COUNTED", 3)
    with pytest.raises(InputError, match="more than 3 runs are missing"):
        collect(study, tmp_path)
    most, left, _ = estimate(study, tmp_path)
    assert (most, left) == (6, 6)


def test_checking_of_the_points_of_other_shards_is_reported(tmp_path, study_file, monkeypatch):
    monkeypatch.setattr(sys.modules["forficula.study.running.run_study"], "_WINDOW", 2)
    study, seen = load_study(study_file(TENDONS)), []
    for number in (1, 2):
        run_study(study, tmp_path, shard=(number, 2), building=lambda *report: seen.append(report))
    assert seen == [(2, 6), (4, 6), (6, 6)]


def test_progress_of_a_continued_study_starts_where_it_stopped(tmp_path, study_file):
    study, seen = load_study(study_file(TENDONS)), []
    run_study(study, tmp_path, shard=(1, 2))
    run_study(study, tmp_path, progress=lambda *report: seen.append(report))
    assert [(done, needed) for done, needed, _ in seen] == [(4, 6), (5, 6), (6, 6)]


def test_an_estimate_counts_runs_and_points_that_are_left_and_writes_nothing(tmp_path, study_file):
    study = load_study(study_file(TENDONS, head=LEAST_TORQUES))
    most, left, seconds = estimate(study, tmp_path / "out")
    # six fold torques, one release, ten unfold torques
    assert (most, left) == (6 * 17, 6)
    assert 0 < seconds < 60
    assert not (tmp_path / "out").exists()


def test_an_estimate_of_a_shard_counts_its_points_only(tmp_path, study_file):
    study = load_study(study_file(TENDONS))
    assert estimate(study, tmp_path, shard=(2, 4))[:2] == (2, 2)
    run_study(study, tmp_path, shard=(2, 4))
    assert estimate(study, tmp_path, shard=(2, 4)) == (2, 0, 0.0)
    assert estimate(study, tmp_path)[:2] == (6, 4)


def test_a_job_uses_the_cores_that_it_may_use(monkeypatch):
    if not hasattr(os, "sched_getaffinity"):
        pytest.skip("this system does not limit processes to cores")
    monkeypatch.setattr(os, "sched_getaffinity", lambda _: {3})
    assert usable_cores() == 1


def test_a_refined_grid_reuses_the_rows_that_it_shares(tmp_path, study_file, whole):
    coarse = '"tendon.stiffness" = "10..30 N/cm step 20"\n"tendon.rest_length" = ["5 cm"]'
    run_study(load_study(study_file(coarse)), tmp_path / "out")
    before, fine, rows = keys(tmp_path / "out")[0], study_file(TENDONS), []
    table = run_study(load_study(fine), tmp_path / "out", progress=lambda *report: rows.append(report))
    after, _ = keys(tmp_path / "out")
    assert (len(before), len(after), len(set(after)), len(rows)) == (2, 6, 6, 4)
    assert after[:2] == before
    assert table.identical(whole(fine))


def test_finer_torques_reuse_the_runs_of_the_coarse_ones(tmp_path, study_file):
    def study(step):
        search = f'[search]\nfold_torques = "0..40 N cm step {step}"\nunfold_torques = ["50 N cm"]'
        return load_study(study_file('"tendon.stiffness" = ["10 N/cm"]', head=LEAST_TORQUES, tail=search))

    run_study(study(20), tmp_path)
    before = set(keys(tmp_path)[0])
    run_study(study(10), tmp_path)
    after = keys(tmp_path)[0]
    assert len(after) == len(set(after))
    assert before < set(after)
    # 10 and 30 N cm, and the release at the new least torque, if it changed
    assert len(after) - len(before) in (2, 3)


def test_points_without_a_valid_wing_have_a_status_in_a_complete_table(tmp_path, study_file):
    study = load_study(study_file(MIXED))
    table = run_study(study, tmp_path / "out")
    status = table["status"].transpose("pattern_units", "pattern_hub_radius").values
    assert [text.startswith("cannot be built: binder2025: pattern.units: ") for text in status[2]] == [True, True]
    assert not any("cannot" in text for text in status[:2].ravel())
    # at such a coarse step some of the others are unreliable
    silent = ~np.isin(table["verdict"].values, ["reached", "moving", "stuck", "not held"])
    assert (table["verdict"].values == "not built").sum() == 2
    assert (table["flat_energy"].isnull().values == silent).all()
    assert len(keys(tmp_path / "out")[0]) == 4
    assert len(table_csv(study, table).splitlines()) == 7


def test_values_out_of_bounds_are_rows_with_a_status(tmp_path, study_file):
    table = run_study(load_study(study_file('"tendon.rest_length" = ["-1 cm", "9 cm"]')), tmp_path)
    assert table["status"].values[0] == "cannot be built: binder2025: tendon.rest_length: need >= 0, got -1 cm"
    assert "cannot" not in str(table["status"].values[1])


@pytest.mark.parametrize("head", ["", LEAST_TORQUES])
def test_a_wing_that_blows_up_is_a_row_with_a_status_and_touches_no_other(tmp_path, study_file, whole, head):
    tail = '[search]\nfold_torques = ["0 N cm", "50 N cm"]\nunfold_torques = ["100 N cm"]' if head else ""
    wild = study_file('"protocol.timestep" = ["8 ms", "0.4 ms"]', head, tail)
    tame = study_file('"protocol.timestep" = ["0.4 ms"]', head, tail, name="tame.toml")
    table, alone = run_study(load_study(wild), tmp_path / "out"), whole(tame)
    assert "diverged at t = " in str(table["status"].values[0])
    xr.testing.assert_identical(table.isel(protocol_timestep=[1]), alone.assign_attrs(table.attrs))


def test_a_search_with_points_without_a_valid_wing_is_complete(tmp_path, study_file):
    search = '[search]\nfold_torques = ["50 N cm"]\nunfold_torques = ["100 N cm"]'
    study = load_study(study_file('"pattern.units" = [1, 30]', head=LEAST_TORQUES, tail=search))
    table = run_study(study, tmp_path)
    assert str(table["status"].values[1]).startswith("cannot be built: ")
    for name in ("outcome", "fold_outcome", "reference_outcome"):
        assert table[name].values[1] == "cannot be built"
    assert table["verdict"].values.tolist()[1] == "not built"
    assert "cannot be built" in legend(draw_torque_maps(table))
    assert table["least_fold_torque"].isnull().values.tolist() == [False, True]


@pytest.mark.parametrize("count", [2, 3])
def test_shards_joined_are_the_undivided_study(tmp_path, study_file, whole, count):
    path = study_file(TENDONS)
    study, out = load_study(path), tmp_path / "out"
    for number in range(1, count):
        assert run_study(study, out, shard=(number, count)) is None
    missing = 6 // count
    with pytest.raises(InputError, match=f": {missing} runs are missing; run the remaining shards, then collect"):
        collect(study, out)
    last = run_study(study, out, shard=(count, count))
    assert last.identical(whole(path))
    assert collect(study, out).identical(last)
    result, torn = keys(out)
    assert (len(result), len(set(result)), torn) == (6, 6, 0)
    assert len(list(out.glob("journal-*-of-*.jsonl"))) == count


def test_shards_of_a_search_joined_are_the_undivided_study(tmp_path, study_file, whole):
    # coarse steps are unreliable with the 500 N cm of other tests
    search = '[search]\nfold_with = "50 N cm"\n'
    search += 'fold_torques = "0..50 N cm step 25"\nunfold_torques = ["100 N cm"]\nrefinements = 2'
    path = study_file(TENDONS, LEAST_TORQUES, search)
    study = load_study(path)
    assert run_study(study, tmp_path / "out", shard=(2, 2)) is None
    run_study(study, tmp_path / "out", shard=(1, 2))
    assert collect(study, tmp_path / "out").identical(whole(path))


@pytest.mark.parametrize("shard", [(0, 2), (3, 2), (1, 0)])
def test_an_invalid_shard_of_a_study_is_rejected(tmp_path, study_file, shard):
    with pytest.raises(InputError, match="shard: need a number from 1 to the count"):
        run_study(load_study(study_file(TENDONS)), tmp_path / "out", shard=shard)


@pytest.mark.parametrize(
    ("name", "value", "least"),
    [("batch", 0, 1), ("batch", -3, 1), ("batch", 2.5, 1), ("threads", -1, 0), ("threads", True, 0)],
)
def test_an_invalid_number_of_runs_or_threads_is_rejected_before_anything_is_written(
    tmp_path, study_file, name, value, least
):
    shown = str(value).lower()
    with pytest.raises(InputError, match=f"^{name}: need a whole number >= {least}, got {shown}$"):
        run_study(load_study(study_file(TENDONS)), tmp_path / "out", **{name: value})
    assert not (tmp_path / "out").exists()


def test_table_does_not_depend_on_the_location_of_the_study(tmp_path, study_file):
    study = load_study(study_file(TENDONS))
    once, twice = (run_study(replace(study, name="x"), tmp_path / name) for name in ("a", "b"))
    assert once.identical(twice)


# enough runs of sufficient length, so that a kill finds some completed and some not
MANY = """
"tendon.stiffness" = "10..40 N/cm step 10"
"tendon.rest_length" = ["5 cm", "9 cm"]
"""
FEW_TORQUES = """
[search]
fold_torques = "10..50 N cm step 10"
unfold_torques = "20..100 N cm step 20"
refinements = 1
"""


@pytest.mark.skipif(os.name != "posix", reason="signals are POSIX's")
@pytest.mark.usefixtures("no_figures")
def test_a_study_killed_at_any_moment_continues_and_ends_with_the_same_bytes(tmp_path, study_file, undisturbed):
    path, moments = study_file(MANY, LEAST_TORQUES, FEW_TORQUES), random.Random(2025)
    table, folder = undisturbed(path)
    size = (folder / "journal.jsonl").stat().st_size
    out, killed, done = tmp_path / "killed", 0, 0
    journal, imports = out / "journal.jsonl", "from forficula.study import load_study, run_study"
    # without the start and end of the command line, which take longer than these runs
    with forks(imports, "run_study(load_study(sys.argv[1]), sys.argv[2])", path, out) as kill_once:
        for share in sorted(moments.random() for _ in range(2)):
            least = max(share * size, done + 1)
            killed += kill_once(
                lambda least=least: journal.exists() and journal.stat().st_size >= least, moments.uniform(0, 0.02)
            )
            done = journal.stat().st_size
    assert killed >= 1
    main(["study", str(path), "--out", str(out), "--keep", "0"])

    result, torn = keys(out)
    assert len(result) == len(set(result))
    assert torn <= killed
    assert set(result) == set(keys(folder)[0])
    assert (out / "table.csv").read_bytes() == table_csv(load_study(path), table).encode()
    with xr.open_dataset(out / "table.nc", engine="h5netcdf") as written:
        assert written.load().identical(table)


@pytest.mark.skipif(os.name != "posix", reason="signals are POSIX's")
@pytest.mark.skipif(signal.getsignal(signal.SIGINT) == signal.SIG_IGN, reason="a job in the background ignores it")
def test_ctrl_c_stops_a_study_with_one_line_and_the_same_command_continues(tmp_path, study_file, whole):
    path = study_file(MANY, LEAST_TORQUES, FEW_TORQUES)
    journal = tmp_path / "out" / "journal.jsonl"
    command = [sys.executable, "-m", "forficula", "study", path, "--out", journal.parent, "--keep", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        # the signature, the start of the process, and at least one row
        while not (journal.exists() and journal.stat().st_size >= 900):
            assert process.poll() is None
            time.sleep(1e-3)
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=120)
    said = [line for line in errors.splitlines() if not line.startswith("estimate: ")]
    assert (process.returncode, output, said) == (130, "", ["forficula: stopped"])
    before, rows = keys(tmp_path / "out")[0], []
    assert before
    table = run_study(load_study(path), tmp_path / "out", progress=lambda *report: rows.append(report))
    assert {row["key"] for _, _, row in rows}.isdisjoint(before)
    assert table.identical(whole(path))
