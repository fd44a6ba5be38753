import json
import os
import random
import signal
import subprocess
import sys
import time
from contextlib import contextmanager

import pytest

import forficula as ff
from forficula.cli import main
from forficula.errors import InputError
from forficula.study import collect, estimate, load_study, run_study
from forficula.study.running.journal import open_journal, read_rows

DESIGN = ff.load_design("binder2025")

TENDONS = '"tendon.stiffness" = "10..30 N/cm step 10"\n"tendon.rest_length" = ["5 cm", "9 cm"]'
# a process that runs a study
RUN = "import sys\nfrom forficula.study import load_study, run_study\nrun_study(load_study(sys.argv[1]), sys.argv[2])"


@contextmanager
def files_of_at_most(size):
    """Limit the size of files of this process, as if the disk were full."""
    import resource

    before, written = resource.getrlimit(resource.RLIMIT_FSIZE), sys.dont_write_bytecode
    # Python would cut the compiled modules that it stores, and later processes could not read them
    sys.dont_write_bytecode = True
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        sys.dont_write_bytecode = written
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


def append(folder, rows, shard=(1, 1)):
    with open_journal(folder, DESIGN, shard) as journal:
        for row in rows:
            journal.append(row)


def rewrite(path, **changes):
    """Change the signature of a journal to another design or other versions."""
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
    # the last line says that the study is complete
    *lines, last, _ = lines_of(journal)
    journal.write_bytes(b"\n".join([*lines, last[:-30]]))
    again = []
    assert run_study(study, tmp_path / "out", progress=lambda *report: again.append(report)).identical(table)
    assert [(done, needed) for done, needed, _ in again] == [(6, 6)]


@pytest.mark.parametrize("rubbish", [b"[]", b'"word"', b'{"key": []}', b"{}", b"\xff\xfe", b"null", b"\0" * 100])
def test_invalid_lines_are_skipped(tmp_path, rubbish):
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


def test_numbers_are_read_back_bitwise(tmp_path):
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
        assert f"design_hash {DESIGN.hash} in the file, {study.base.hash} now" in str(caught.value)
        assert "mujoco" not in str(caught.value)
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["journal.jsonl"]


@pytest.mark.parametrize("name", ["mujoco", "numpy", "forficula", "schema"])
def test_a_shard_that_other_versions_computed_is_refused_with_what_differs(tmp_path, study_file, name):
    study, out = load_study(study_file(TENDONS)), tmp_path / "out"
    for number in (1, 2):
        run_study(study, out, shard=(number, 2))
    collect(study, out)
    # as if copied from another machine
    rewrite(out / "journal-2-of-2.jsonl", **{name: "0.0.1"})
    expected = rf"journal-2-of-2\.jsonl: .*versions: {name} 0\.0\.1 in the file, \S+ now; "
    for start in (run_study, collect):
        with pytest.raises(InputError, match=expected) as caught:
            start(study, out)
        assert "design_hash" not in str(caught.value)


def test_name_of_the_design_does_not_matter(tmp_path):
    append(tmp_path, [{"key": "1-a", "status": "folded"}])
    rewrite(tmp_path / "journal.jsonl", design="another name")
    assert set(read_rows(tmp_path, DESIGN)) == {"1-a"}


@pytest.mark.parametrize("signature", ["", '{"written_by": 3}\n', '{"written_by": {"schema": 1, "des\n'])
def test_rows_that_do_not_say_which_versions_wrote_them_are_refused(tmp_path, signature):
    (tmp_path / "journal.jsonl").write_text(signature + '{"key": "1-a", "status": "folded"}\n')
    with pytest.raises(InputError, match=r"journal\.jsonl: has rows without the versions that wrote them; choose"):
        read_rows(tmp_path, DESIGN)


@pytest.mark.parametrize("cut", [1, 30])
def test_a_journal_with_a_truncated_first_line_is_continued(tmp_path, cut):
    append(tmp_path, [])
    path = tmp_path / "journal.jsonl"
    path.write_bytes(path.read_bytes()[:-cut])
    assert read_rows(tmp_path, DESIGN) == {}
    append(tmp_path, [{"key": "1-a", "status": "folded"}])
    assert set(read_rows(tmp_path, DESIGN)) == {"1-a"}


def test_a_journal_has_one_signature(tmp_path):
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
def test_an_impossible_folder_is_one_clear_error(tmp_path, study_file, out):
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
@pytest.mark.parametrize("limit", [100, 2000])
def test_a_full_disk_is_one_line_and_the_study_goes_on_when_there_is_room(tmp_path, study_file, capsys, limit):
    path = str(study_file(TENDONS))
    with files_of_at_most(limit), pytest.raises(SystemExit) as ended:
        main(["study", path, "--out", str(tmp_path / "out")])
    assert ended.value.code == 1
    expected = f"forficula: {tmp_path / 'out' / 'journal.jsonl'}: cannot be written: File too large\n"
    assert capsys.readouterr() == ("", expected)
    study = load_study(path)
    kept = len(read_rows(tmp_path / "out", study.base))
    assert kept == 0 if limit == 100 else 0 < kept < 6
    assert run_study(study, tmp_path / "out").identical(run_study(study, tmp_path / "other"))


def lines_of(path):
    return [line for line in path.read_bytes().split(b"\n") if line]


def changed(line, change):
    """A row with other contents and the old checksum, as if edited by hand or by another program."""
    return json.dumps(change(json.loads(line))).encode()


DAMAGE = {
    "no key": lambda line: changed(line, lambda row: {name: row[name] for name in row if name != "key"}),
    "no status": lambda line: changed(line, lambda row: {name: row[name] for name in row if name != "status"}),
    "no time": lambda line: changed(line, lambda row: {name: row[name] for name in row if name != "fold_time_s"}),
    "text for a number": lambda line: changed(line, lambda row: row | {"fold_time_s": "soon"}),
    "a list for a number": lambda line: changed(line, lambda row: row | {"fold_time_s": [1.0]}),
    "another number": lambda line: changed(line, lambda row: row | {"fold_time_s": 0.5}),
    "nan": lambda line: changed(line, lambda row: row | {"fold_time_s": float("nan")}),
    "another verdict": lambda line: changed(line, lambda row: row | {"folded": not row["folded"]}),
    "no checksum": lambda line: changed(line, lambda row: {name: row[name] for name in row if name != "crc32"}),
    "a long number": lambda line: line[:-1] + b', "x": ' + b"1" * 5000 + b"}",
    "nested": lambda line: line[:-1] + b', "x": ' + b"[" * 100_000 + b"]" * 100_000 + b"}",
    "nested only": lambda _: b"[" * 100_000,
    "torn": lambda line: line[:-30],
    "zeros": lambda line: bytes(len(line)),
}


@pytest.fixture(scope="module")
def whole_study(tmp_path_factory, write_study_file):
    """A study of two runs, its table and its journal."""
    folder = tmp_path_factory.mktemp("whole")
    study = load_study(write_study_file(folder / "small.toml", '"tendon.stiffness" = ["10 N/cm", "20 N/cm"]'))
    table = run_study(study, folder)
    journal = folder / "journal.jsonl"
    # the signature and the rows, without the start and end of the process
    journal.write_bytes(b"\n".join(line for line in lines_of(journal) if not line.startswith(b'{"attempt"')) + b"\n")
    return study, table, journal


@pytest.mark.parametrize("damage", DAMAGE.values(), ids=DAMAGE)
def test_a_damaged_row_is_reported_and_run_again(tmp_path, whole_study, capsys, damage):
    study, table, journal = whole_study
    signature, first, second = lines_of(journal)
    damaged = tmp_path / "journal.jsonl"
    damaged.write_bytes(b"\n".join([signature, damage(first), second, b""]))
    again = []
    assert run_study(study, tmp_path, progress=lambda *report: again.append(report)).identical(table)
    assert len(again) == 1
    said = f"warning: {damaged}: 1 damaged row is skipped; missing runs are repeated\n"
    assert capsys.readouterr().err == said
    # the line after it says that the study is complete
    assert json.loads(lines_of(damaged)[-2]) == json.loads(first)


def test_no_flipped_bit_of_a_row_is_read_as_data(tmp_path, whole_study, capsys):
    study, _, journal = whole_study
    rows, content = read_rows(journal.parent, study.base), journal.read_bytes()
    start, chosen = content.index(b"\n") + 1, random.Random(11)
    places = chosen.sample(range(8 * start, 8 * len(content)), 1000)
    for place in places:
        damaged = bytearray(content)
        damaged[place // 8] ^= 1 << place % 8
        (tmp_path / "journal.jsonl").write_bytes(damaged)
        kept = read_rows(tmp_path, study.base)
        assert all(rows[key] == row for key, row in kept.items())
        assert len(kept) == 2 or "skipped" in capsys.readouterr().err


def test_rows_that_an_earlier_version_wrote_without_checksums_are_refused(tmp_path):
    append(tmp_path, [])
    rewrite(tmp_path / "journal.jsonl", schema=1)
    with (tmp_path / "journal.jsonl").open("a") as file:
        file.write('{"key": "1-a", "status": "folded"}\n')
    with pytest.raises(
        InputError, match=r"other versions: schema 1 in the file, 5 now; choose another folder with --out"
    ):
        read_rows(tmp_path, DESIGN)


def test_a_study_that_another_process_runs_is_rejected_but_its_shard_is_not(tmp_path):
    for shard, what in (((1, 1), "this study"), ((2, 3), "shard 2/3 of this study")):
        with open_journal(tmp_path, DESIGN, shard) as journal:
            with pytest.raises(InputError) as caught:
                append(tmp_path, [], shard)
            append(tmp_path, [{"key": "2-b", "status": "folded"}], (1, 3))
            journal.append({"key": "2-a", "status": "folded"})
        said = f"another process is running {what} in this folder; wait for it, or choose another folder"
        assert str(caught.value).partition(": ")[2] == said
        append(tmp_path, [], shard)
    assert set(read_rows(tmp_path, DESIGN)) == {"2-a", "2-b"}
    assert not list(tmp_path.glob(".*"))


@pytest.mark.skipif(os.name != "posix", reason="processes cannot be stopped here")
def test_the_second_start_of_a_running_study_is_rejected_at_once(tmp_path, study_file, capsys):
    path, out = study_file('"tendon.stiffness" = "10..30 N/cm step 5"'), tmp_path / "out"
    with subprocess.Popen([sys.executable, "-c", RUN, str(path), str(out)]) as first:
        while not (out / "journal.jsonl").exists():
            assert first.poll() is None
            time.sleep(1e-3)
        first.send_signal(signal.SIGSTOP)
        with pytest.raises(SystemExit) as ended:
            main(["study", str(path), "--keep", "0", "--out", str(out)])
        first.send_signal(signal.SIGCONT)
        said = "another process is running this study in this folder; wait for it, or choose another folder"
        assert capsys.readouterr().err == f"forficula: {out / 'journal.jsonl'}: {said}\n"
        assert ended.value.code == 1
    assert first.returncode == 0
    assert len(read_rows(out, load_study(path).base)) == 5


@pytest.mark.parametrize("exists", [True, False])
def test_a_planted_link_in_the_place_of_a_journal_is_not_followed(tmp_path, study_file, exists):
    study = load_study(study_file(TENDONS))
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "journal.jsonl").symlink_to(tmp_path / "theirs")
    if exists:
        (tmp_path / "theirs").write_text("theirs")
    with pytest.raises(
        InputError, match=r"journal\.jsonl: (need a file or nothing there, got a link to|cannot be read)"
    ):
        run_study(study, tmp_path / "out")
    assert (tmp_path / "theirs").exists() == exists
    assert not exists or (tmp_path / "theirs").read_text() == "theirs"


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes with names here")
def test_a_pipe_in_the_place_of_a_journal_is_an_immediate_error(tmp_path):
    os.mkfifo(tmp_path / "journal.jsonl")
    with pytest.raises(InputError, match=r"journal\.jsonl: cannot be read: need a file"):
        read_rows(tmp_path, DESIGN)
