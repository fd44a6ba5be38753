"""The status of a study whose shards run, fail, vanish, are killed, damaged or written twice."""

import json
import os
import re
import signal
import subprocess
import sys
import time

import pytest

from forficula.cli import main
from forficula.errors import InputError
from forficula.study import collect, load_study, run_study
from forficula.study.running.attempt_writer import attempt
from forficula.study.running.evaluate import evaluate, row_key
from forficula.study.running.journal import open_journal
from forficula.study.running.study_status import ShardState, array_expression, study_status

NINE_POINTS = '"tendon.stiffness" = "10..30 N/cm step 10"\n"tendon.rest_length" = ["5 cm", "7 cm", "9 cm"]'
HOUR = 3600
LINUX = pytest.mark.skipif(os.name != "posix", reason="signals are POSIX's")


@pytest.fixture(scope="module")
def study(tmp_path_factory, write_study_file):
    return load_study(write_study_file(tmp_path_factory.mktemp("study") / "nine.toml", NINE_POINTS))


@pytest.fixture(scope="module")
def stand_in(study):
    """An evaluator that returns the row of one real run for every design."""
    (row,) = evaluate([study.base])
    return lambda designs, _: ({**row, "key": row_key(design)} for design in designs)


@pytest.fixture
def out(tmp_path, study, stand_in):
    """A folder in which three shards with three points each are done."""
    for number in (1, 2, 3):
        run_study(study, tmp_path / "out", shard=(number, 3), cluster=stand_in)
    return tmp_path / "out"


def journal(out, number):
    return out / f"journal-{number}-of-3.jsonl"


def states(study, out):
    return [shard.state.value for shard in study_status(study, out).shards]


def failing_after(count, stand_in, error):
    """An evaluator that fails after some rows."""

    def rows(designs, until_last):
        for number, row in enumerate(stand_in(designs, until_last)):
            if number == count:
                raise error
            yield row

    return rows


def age(path, seconds=HOUR):
    before = path.stat().st_mtime - seconds
    os.utime(path, (before, before))


def vanish(path):
    path.unlink()


def cut(path):
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
    age(path)


def flip_a_bit(path):
    content = bytearray(path.read_bytes())
    content[len(content) // 2] ^= 4
    path.write_bytes(content)


def lose_a_row(path):
    lines = path.read_bytes().splitlines(keepends=True)
    path.write_bytes(b"".join(lines[:2] + lines[3:]))


def from_another_version(path):
    path.write_bytes(path.read_bytes().replace(b'"mujoco": "', b'"mujoco": "0.', 1))


DAMAGE = {
    vanish: ("missing", "no process has started"),
    cut: ("stale", "its process has written nothing for 1 h"),
    flip_a_bit: ("failed", "1 of 3 rows are missing (1 damaged)"),
    lose_a_row: ("failed", "1 of 3 rows are missing"),
    from_another_version: ("failed", "mujoco 0."),
}


@pytest.mark.parametrize("damage", DAMAGE, ids=lambda damage: damage.__name__)
def test_a_damaged_shard_is_listed_runs_again_and_the_table_is_complete(study, out, stand_in, damage, capsys):
    table = collect(study, out)
    damage(journal(out, 2))
    status = study_status(study, out)
    state, why = DAMAGE[damage]
    assert [shard.state.value for shard in status.shards] == ["done", state, "done"]
    assert why in status.shards[1].why
    assert (status.complete, status.run_again) == (False, "2")
    if damage is from_another_version:
        journal(out, 2).unlink()
    run_study(study, out, shard=(2, 3), cluster=stand_in)
    assert study_status(study, out).complete
    assert collect(study, out).identical(table)
    capsys.readouterr()


@pytest.mark.parametrize("value", ['"many"', "null", "-4", "1e400", "true"])
def test_damaged_numbers_of_a_process_are_ignored(study, out, value):
    text = journal(out, 1).read_text()
    journal(out, 1).write_text(re.sub(r'"(seconds|points|stored)": [\d.]+', rf'"\1": {value}', text))
    shard = study_status(study, out).shards[0]
    assert (shard.state.value, shard.points_done, shard.rate) == ("failed", 0, None)


@pytest.mark.parametrize("name", ["journal-0-of-0.jsonl", "journal-5-of-3.jsonl", "journal-1-of-1000000000.jsonl"])
def test_journals_of_impossible_shards_are_ignored(study, out, name):
    (out / name).write_bytes(journal(out, 1).read_bytes())
    assert states(study, out) == ["done", "done", "done"]


def test_rows_that_were_written_twice_count_once(study, out):
    journal(out, 2).with_suffix(".2.jsonl").write_bytes(journal(out, 2).read_bytes())
    status = study_status(study, out)
    assert (status.complete, status.points_done) == (True, 9)


def test_a_shard_that_fails_has_its_reason_and_continues(tmp_path, study, stand_in):
    with pytest.raises(InputError):
        run_study(study, tmp_path, shard=(1, 3), cluster=failing_after(2, stand_in, InputError("disk quota exceeded")))
    shard = study_status(study, tmp_path).shards[0]
    assert (shard.state, shard.points_done, shard.why) == (ShardState.FAILED, 2, "disk quota exceeded")
    rows = []
    run_study(study, tmp_path, shard=(1, 3), cluster=stand_in, progress=lambda *report: rows.append(report))
    assert len(rows) == 1
    assert states(study, tmp_path) == ["done", "missing", "missing"]


def test_a_running_shard_has_points_rate_and_time_left_and_is_stale_after_five_silent_minutes(
    tmp_path, study, stand_in, monkeypatch
):
    monkeypatch.setenv("SLURM_ARRAY_JOB_ID", "88")
    monkeypatch.setenv("SLURM_ARRAY_TASK_ID", "1")
    seen = []

    def rows(designs, until_last):
        yield from list(stand_in(designs, until_last))[:2]
        seen.append(study_status(study, tmp_path).shards[0])
        age(journal(tmp_path, 1), 290)
        seen.append(study_status(study, tmp_path).shards[0])
        age(journal(tmp_path, 1), 20)
        seen.append(study_status(study, tmp_path).shards[0])
        raise InputError("stop")

    with pytest.raises(InputError, match="stop"):
        run_study(study, tmp_path, shard=(1, 3), cluster=rows)
    assert [(shard.state.value, shard.points_done) for shard in seen] == [("running", 2)] * 2 + [("stale", 2)]
    assert seen[0].job == "88_1"
    assert seen[0].host


def test_progress_is_written_at_an_interval_and_gives_the_rate(tmp_path, study, stand_in, monkeypatch):
    monkeypatch.setattr("forficula.study.running.attempt_writer._INTERVAL", 0.05)
    seen = []

    def rows(designs, until_last):
        yield from list(stand_in(designs, until_last))[:2]
        limit = time.monotonic() + 20
        while not seen or (seen[-1].rate is None and time.monotonic() < limit):
            time.sleep(0.05)
            seen.append(study_status(study, tmp_path).shards[0])
        raise InputError("stop")

    with pytest.raises(InputError, match="stop"):
        run_study(study, tmp_path, shard=(1, 3), cluster=rows)
    # two of three runs are done
    assert seen[-1].time_left == pytest.approx(1 / seen[-1].rate)


def test_slow_shards_are_marked(tmp_path, study):
    for number, seconds in enumerate([10.0, 11.0, 9.0, 30.0, 10.0], start=1):
        with open_journal(tmp_path, study.base, (number, 5)) as opened, attempt(opened, study) as writer:
            opened.write_entry({"attempt": {"name": writer._name, "rows": 5, "seconds": seconds, "ended": False}})
            writer._write = lambda _: None
    assert [shard.slow for shard in study_status(study, tmp_path).shards] == [False, False, False, True, False]


def test_the_shards_of_another_study_in_the_same_folder_do_not_count(out, write_study_file, tmp_path):
    finer = load_study(write_study_file(tmp_path / "finer.toml", NINE_POINTS.replace("step 10", "step 5")))
    assert study_status(finer, out).shards == ()


def test_the_latest_division_counts(study, out, stand_in):
    for path in out.glob("journal*.jsonl"):
        age(path)
    run_study(study, out, shard=(2, 5), cluster=stand_in)
    assert states(study, out) == ["missing", "done", "missing", "missing", "missing"]
    # with all rows, an undivided run has nothing to do
    run_study(study, out)
    assert states(study, out) == ["done"]


def test_a_second_process_without_locks_writes_to_a_file_of_its_own(tmp_path, study, stand_in, monkeypatch):
    table = run_study(study, tmp_path / "whole", cluster=stand_in)
    # as on a network file system without locks
    monkeypatch.setattr("forficula.lock._take", lambda _: None)

    def rows(designs, until_last):
        if not journal(tmp_path, 1).with_suffix(".2.jsonl").exists():
            run_study(study, tmp_path, shard=(1, 3), cluster=rows)
        yield from stand_in(designs, until_last)

    run_study(study, tmp_path, shard=(1, 3), cluster=rows)
    assert sorted(path.name for path in tmp_path.glob("journal*")) == [
        "journal-1-of-3.2.jsonl",
        "journal-1-of-3.jsonl",
    ]
    for number in (2, 3):
        run_study(study, tmp_path, shard=(number, 3), cluster=stand_in)
    assert study_status(study, tmp_path).complete
    assert set(collect(study, tmp_path).data_vars) == set(table.data_vars)
    assert collect(study, tmp_path)["fold_time"].equals(table["fold_time"])


def test_a_process_of_another_machine_that_may_be_alive_keeps_its_file(tmp_path, study, stand_in):
    run_study(study, tmp_path, shard=(1, 3), cluster=stand_in)
    lines = journal(tmp_path, 1).read_text().splitlines()
    start = json.loads(lines[1])
    start["attempt"]["host"] = "node17"
    journal(tmp_path, 1).write_text("\n".join([lines[0], json.dumps(start), lines[2]]) + "\n")
    before = journal(tmp_path, 1).read_bytes()
    run_study(study, tmp_path, shard=(1, 3), cluster=stand_in)
    assert journal(tmp_path, 1).read_bytes() == before
    assert states(study, tmp_path)[0] == "done"


@LINUX
def test_rows_that_do_not_reach_the_file_server_are_an_error(tmp_path, study, stand_in, monkeypatch):
    def full(_):
        raise OSError(122, "Disk quota exceeded")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(InputError, match=r"journal-1-of-3\.jsonl: cannot be written: Disk quota exceeded"):
        run_study(study, tmp_path, shard=(1, 3), cluster=stand_in)
    assert states(study, tmp_path)[0] != "done"


def test_a_shard_does_not_read_the_journals_of_the_others(study, out, stand_in):
    journal(out, 1).write_text("damaged")
    journal(out, 2).unlink()
    assert run_study(study, out, shard=(2, 3), cluster=stand_in) is None
    assert states(study, out)[1] == "done"


@LINUX
def test_a_job_that_the_engine_ends_says_that_it_was_stopped(tmp_path, study_file):
    path, out = study_file('"tendon.stiffness" = "10..40 N/cm step 1"'), tmp_path / "out"
    command = [sys.executable, "-m", "forficula", "study", path, "--out", out, "--shard", "1/2", "--keep", "0"]
    journal = out / "journal-1-of-2.jsonl"
    with subprocess.Popen(command, stderr=subprocess.DEVNULL) as process:
        # the first of two rows has been counted
        while not journal.exists() or journal.read_bytes().count(b'"key"') < 2:
            assert process.poll() is None
            time.sleep(1e-3)
        process.send_signal(signal.SIGTERM)
        assert process.wait(60) == 128 + signal.SIGTERM
    shard = study_status(load_study(path), out).shards[0]
    assert (shard.state, shard.why) == (ShardState.FAILED, "stopped")
    assert 0 < shard.points_done < shard.points


def test_the_command_prints_a_table_and_what_to_run_again(out, study_file, capsys):
    path = study_file(NINE_POINTS, name="nine.toml")
    arguments = ["study", str(path), "--out", str(out), "--status"]
    main(arguments)
    assert f"complete: forficula study {path} --out {out} --collect" in capsys.readouterr().out
    journal(out, 1).unlink()
    flip_a_bit(journal(out, 3))
    with pytest.raises(SystemExit) as ended:
        main(arguments)
    assert ended.value.code == 2
    printed = capsys.readouterr().out
    assert "1 of 3 rows are missing (1 damaged)" in " ".join(printed.split())
    assert "--shard K/3\n    1,3\n" in printed
    (out / "study.slurm").touch()
    with pytest.raises(SystemExit):
        main([*arguments, "--json"])
    result = json.loads(capsys.readouterr().out)
    assert (result["complete"], result["run_again"], result["points"]) == (False, "1,3", 9)
    assert [shard["state"] for shard in result["shards"]] == ["missing", "done", "failed"]
    with pytest.raises(SystemExit):
        main(arguments)
    assert f"run again: sbatch --array=1,3 {out / 'study.slurm'}" in " ".join(capsys.readouterr().out.split())


def test_a_folder_in_which_nothing_ran_has_no_shards(tmp_path, study):
    status = study.status(tmp_path / "none")
    assert (status.shards, status.complete, status.run_again) == ((), False, "")
    assert not (tmp_path / "none").exists()


@pytest.mark.parametrize(
    ("numbers", "text"),
    [([], ""), ([3], "3"), ([3, 17, 40, 41, 42, 43, 44], "3,17,40-44"), ([1, 2, 4, 5], "1-2,4-5")],
)
def test_numbers_of_shards_are_written_as_slurm_reads_them(numbers, text):
    assert array_expression(numbers) == text
