import json
import os
import subprocess
import sys

import pytest

import forficula as ff
from forficula.errors import InputError
from forficula.study import collect, estimate, load_study, run_study
from forficula.study.journal import open_journal, read_rows

DESIGN = ff.load_design("binder2025")

TENDONS = '"tendon.stiffness" = "10..30 N/cm step 10"\n"tendon.rest_length" = ["5 cm", "9 cm"]'
# a process that may write files of so many bytes only: to it, the disk is full
LIMITED = """
import resource, signal, sys
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv[1]), int(sys.argv[1])))
from forficula.cli import main
main(sys.argv[2:])
"""


def append(folder, rows, shard=(1, 1)):
    with open_journal(folder, DESIGN, shard) as journal:
        for row in rows:
            journal.append(row)


def rewrite(path, **changes):
    """Have a journal say that another design or other versions wrote it."""
    first, *rows = path.read_text().splitlines()
    signature = json.loads(first)
    signature["written_by"] |= changes
    path.write_text("\n".join([json.dumps(signature), *rows]) + "\n")


@pytest.mark.parametrize("cut", [1, 5, 20, 44])
def test_a_line_that_a_crash_cut_short_costs_that_row_only(tmp_path, cut):
    rows = [{"key": f"1-{number}", "status": "folded", "fold_time_s": number / 3} for number in range(3)]
    append(tmp_path, rows)
    whole = (tmp_path / "journal.jsonl").read_bytes()
    (tmp_path / "journal.jsonl").write_bytes(whole[:-cut])
    kept = read_rows(tmp_path, DESIGN)
    assert kept == {row["key"]: row for row in (rows if cut == 1 else rows[:2])}
    append(tmp_path, rows[2:])
    assert read_rows(tmp_path, DESIGN) == {row["key"]: row for row in rows}


def test_a_torn_row_is_run_again_and_the_table_is_the_same(tmp_path, study_file):
    study = load_study(study_file(TENDONS))
    table = run_study(study, tmp_path / "out")
    journal = tmp_path / "out" / "journal.jsonl"
    journal.write_bytes(journal.read_bytes()[:-30])
    again = []
    assert run_study(study, tmp_path / "out", progress=lambda *each: again.append(each)).identical(table)
    assert [(done, needed) for done, needed, _ in again] == [(6, 6)]


@pytest.mark.parametrize("rubbish", [b"[]", b'"word"', b'{"key": []}', b"{}", b"\xff\xfe", b"null", b"\0" * 100])
def test_lines_that_are_no_rows_are_passed_over(tmp_path, rubbish):
    append(tmp_path, [{"key": "1-a", "status": "folded"}])
    with (tmp_path / "journal.jsonl").open("ab") as file:
        file.write(rubbish + b"\n")
    append(tmp_path, [{"key": "1-b", "status": "folded"}])
    assert set(read_rows(tmp_path, DESIGN)) == {"1-a", "1-b"}


def test_the_journals_of_shards_are_read_together(tmp_path):
    append(tmp_path, [{"key": "1-a", "status": "folded"}], (1, 2))
    append(tmp_path, [{"key": "1-b", "status": "folded"}], (2, 2))
    append(tmp_path, [{"key": "1-c", "status": "folded"}])
    assert set(read_rows(tmp_path, DESIGN)) == {"1-a", "1-b", "1-c"}
    assert len(list(tmp_path.glob("journal*.jsonl"))) == 3


def test_numbers_come_back_with_the_same_bits(tmp_path):
    row = {"key": "1-a", "status": "folded", "a": 0.1 + 0.2, "b": 5e-324, "c": 1.7976931348623157e308, "d": -0.0}
    append(tmp_path, [row])
    assert {name: repr(value) for name, value in read_rows(tmp_path, DESIGN)["1-a"].items()} == {
        name: repr(value) for name, value in row.items()
    }


def test_rows_of_another_design_are_refused_with_what_differs(tmp_path, study_file):
    append(tmp_path / "out", [{"key": "1-a", "status": "folded"}])
    study = load_study(study_file(TENDONS))
    for start in (run_study, collect, estimate):
        with pytest.raises(InputError) as caught:
            start(study, tmp_path / "out")
        assert f"design_hash {DESIGN.hash} there, {study.base.hash} now" in str(caught.value)
        assert "mujoco" not in str(caught.value)
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["journal.jsonl"]


@pytest.mark.parametrize("name", ["mujoco", "numpy", "forficula", "schema"])
def test_a_shard_that_other_versions_computed_is_refused_with_what_differs(tmp_path, study_file, name):
    study, out = load_study(study_file(TENDONS)), tmp_path / "out"
    for number in (1, 2):
        run_study(study, out, shard=(number, 2))
    collect(study, out)
    # as if copied in from another machine
    rewrite(out / "journal-2-of-2.jsonl", **{name: "0.0.1"})
    expected = rf"journal-2-of-2\.jsonl: .*versions: {name} 0\.0\.1 there, \S+ now; "
    for start in (run_study, collect):
        with pytest.raises(InputError, match=expected) as caught:
            start(study, out)
        assert "design_hash" not in str(caught.value)


def test_what_the_design_was_called_does_not_matter(tmp_path):
    append(tmp_path, [{"key": "1-a", "status": "folded"}])
    rewrite(tmp_path / "journal.jsonl", design="another name")
    assert set(read_rows(tmp_path, DESIGN)) == {"1-a"}


@pytest.mark.parametrize("signature", ["", '{"written_by": 3}\n', '{"written_by": {"schema": 1, "des\n'])
def test_rows_that_do_not_say_which_versions_wrote_them_are_refused(tmp_path, signature):
    (tmp_path / "journal.jsonl").write_text(signature + '{"key": "1-a", "status": "folded"}\n')
    with pytest.raises(InputError, match=r"journal\.jsonl: holds rows that do not say which versions wrote them; take"):
        read_rows(tmp_path, DESIGN)


@pytest.mark.parametrize("cut", [1, 30])
def test_a_journal_whose_first_line_a_crash_cut_short_is_gone_on_with(tmp_path, cut):
    append(tmp_path, [])
    path = tmp_path / "journal.jsonl"
    path.write_bytes(path.read_bytes()[:-cut])
    assert read_rows(tmp_path, DESIGN) == {}
    append(tmp_path, [{"key": "1-a", "status": "folded"}])
    assert set(read_rows(tmp_path, DESIGN)) == {"1-a"}


def test_a_journal_says_once_who_wrote_it(tmp_path):
    for key in ("1-a", "1-b"):
        append(tmp_path, [{"key": key, "status": "folded"}])
    lines = [line for line in (tmp_path / "journal.jsonl").read_text().splitlines() if line]
    assert [next(iter(json.loads(line))) for line in lines] == ["written_by", "key", "key"]


def test_journals_by_the_same_versions_joined_into_one_file_are_read(tmp_path):
    for number in (1, 2):
        append(tmp_path, [{"key": f"1-{number}", "status": "folded"}], (number, 2))
    parts = sorted(tmp_path.glob("journal-*.jsonl"))
    (tmp_path / "journal.jsonl").write_bytes(b"".join(part.read_bytes() for part in parts))
    for part in parts:
        part.unlink()
    assert set(read_rows(tmp_path, DESIGN)) == {"1-1", "1-2"}


def test_collecting_where_nothing_ran_writes_nothing(tmp_path, study_file):
    with pytest.raises(InputError, match="6 runs are missing"):
        collect(load_study(study_file(TENDONS)), tmp_path / "out")
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("out", ["file", "file/out", "x" * 300])
def test_a_folder_that_cannot_be_is_one_clear_error(tmp_path, study_file, out):
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError) as caught:
        run_study(load_study(study_file(TENDONS)), tmp_path / out)
    assert len(str(caught.value).splitlines()) == 1
    assert out in str(caught.value)


def test_a_journal_that_cannot_be_opened_is_one_clear_error(tmp_path, study_file):
    study = load_study(study_file(TENDONS))
    (tmp_path / "out" / "journal.jsonl").mkdir(parents=True)
    with pytest.raises(InputError, match=r"journal\.jsonl: cannot be "):
        run_study(study, tmp_path / "out")


@pytest.mark.skipif(os.name != "posix", reason="limits of a process are POSIX's")
@pytest.mark.parametrize("limit", [100, 1000])
def test_a_full_disk_is_one_line_and_the_study_goes_on_when_there_is_room(tmp_path, study_file, limit):
    path = str(study_file(TENDONS))
    arguments = ["study", path, "--out", str(tmp_path / "out")]
    done = subprocess.run(
        [sys.executable, "-c", LIMITED, str(limit), *arguments], capture_output=True, text=True, check=False
    )
    expected = f"forficula: {tmp_path / 'out' / 'journal.jsonl'}: cannot be written: File too large\n"
    assert (done.returncode, done.stdout, done.stderr) == (1, "", expected)
    study = load_study(path)
    kept = len(read_rows(tmp_path / "out", study.base))
    assert kept == 0 if limit == 100 else 0 < kept < 6
    assert run_study(study, tmp_path / "out").identical(run_study(study, tmp_path / "other"))
