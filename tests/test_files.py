import errno
import json
import os
import random
import shutil
import stat
import subprocess
import sys
import time
from pathlib import Path

import pytest

from forficula.design import load_design
from forficula.dynamics import load_record
from forficula.errors import InputError
from forficula.files import (
    clear_leftovers,
    open_to_append,
    read_bytes,
    replacing,
    replacing_all,
    write_bytes,
    write_text,
)
from forficula.material import load_law, read_tensile_test
from forficula.study import load_study

OLD = {"a.txt": "old a", "b.txt": "old b", "figures/c.svg": "old c", "gone.txt": "old", "mine.txt": "mine"}
NEW = {"a.txt": "new a", "b.txt": "new b", "figures/c.svg": "new c", "d.txt": "new d", "more/e.svg": "new e"}
AFTER = NEW | {"mine.txt": "mine"}


def everything_in(folder):
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*"))


def files_in(folder):
    """Content of a folder, with hidden files and empty folders."""
    return {
        path.relative_to(folder).as_posix(): None if path.is_dir() else path.read_text()
        for path in folder.rglob("*")
        if path.is_file() or not any(path.iterdir())
    }


def fill(folder, content=OLD):
    for name, text in content.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)


def write_new(folder):
    with replacing_all(folder, remove=("gone.txt",)) as unfinished:
        for name, text in NEW.items():
            write_text(unfinished / name, text)


def refusal(folder):
    """Return why the new files could not be written, or None."""
    try:
        write_new(folder)
    except InputError as error:
        return str(error)
    return None


def fails_from(monkeypatch, first, last):
    """Have the disk refuse to rename the first to the last time, from now on."""
    rename, calls = os.replace, [0]

    def replace(source, target):
        calls[0] += 1
        if first <= calls[0] <= last:
            raise PermissionError(errno.EPERM, "Operation not permitted")
        rename(source, target)

    monkeypatch.setattr(os, "replace", replace)
    return calls


def test_a_text_is_written_as_utf_8_with_plain_line_ends(tmp_path):
    write_text(tmp_path / "deep" / "er" / "a.txt", "é\nb\n")
    assert (tmp_path / "deep" / "er" / "a.txt").read_bytes() == b"\xc3\xa9\nb\n"


@pytest.mark.parametrize("content", [b"\x00\r\n", memoryview(b"\x00\r\n")])
def test_bytes_are_written_as_they_are(tmp_path, content):
    write_bytes(tmp_path / "a.nc", content)
    assert (tmp_path / "a.nc").read_bytes() == b"\x00\r\n"


def test_an_existing_file_is_replaced_and_no_other_file_remains(tmp_path):
    (tmp_path / "a.txt").write_text("old and longer")
    write_text(tmp_path / "a.txt", "new")
    assert (tmp_path / "a.txt").read_text() == "new"
    assert everything_in(tmp_path) == ["a.txt"]


def test_a_file_has_the_permissions_that_the_user_gives_to_new_files(tmp_path):
    before = os.umask(0o027)
    try:
        write_text(tmp_path / "a.txt", "")
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "a.txt").stat().st_mode) == 0o640


def test_the_temporary_name_keeps_the_ending_because_writers_go_by_it(tmp_path):
    with replacing(tmp_path / "a.png") as temporary:
        assert temporary.suffix == ".png"
        assert temporary.parent == tmp_path


@pytest.mark.parametrize("failure", [RuntimeError("bug"), KeyboardInterrupt()])
def test_a_file_is_left_as_it_was_when_writing_is_broken_off(tmp_path, failure):
    (tmp_path / "a.txt").write_text("old")

    def write():
        with replacing(tmp_path / "a.txt") as temporary:
            temporary.write_text("half")
            raise failure

    with pytest.raises(type(failure)):
        write()
    assert (tmp_path / "a.txt").read_text() == "old"
    assert everything_in(tmp_path) == ["a.txt"]


@pytest.mark.parametrize(
    ("failure", "reason"),
    [
        (OSError(28, "No space left on device"), "No space left on device"),
        (OSError("Can't write data (file write failed)"), "Can't write data (file write failed)"),
    ],
)
def test_a_full_disk_is_one_error_that_names_the_file_and_the_reason(tmp_path, failure, reason):
    def write():
        with replacing(tmp_path / "a.nc"):
            raise failure

    with pytest.raises(InputError) as caught:
        write()
    assert str(caught.value) == f"{tmp_path}/a.nc: cannot be written: {reason}"
    assert everything_in(tmp_path) == []


def test_a_file_in_the_place_of_a_folder_is_named(tmp_path):
    (tmp_path / "file").write_text("old")
    with pytest.raises(InputError, match=r"cannot be written: .*file is a file, not a folder$"):
        write_text(tmp_path / "file" / "a.txt", "")
    with pytest.raises(InputError, match=r"cannot be written: Not a directory$"):
        write_text(tmp_path / "file" / "deep" / "a.txt", "")
    assert everything_in(tmp_path) == ["file"]


def test_a_folder_in_the_place_of_the_file_stays(tmp_path):
    (tmp_path / "a.txt").mkdir()
    with pytest.raises(InputError, match=r"a.txt: cannot be written: Is a directory$"):
        write_text(tmp_path / "a.txt", "")
    assert everything_in(tmp_path) == ["a.txt"]


def test_files_in_folders_within_are_put_in_place_beside_those_that_were_there(tmp_path):
    (tmp_path / "out" / "figures").mkdir(parents=True)
    (tmp_path / "out" / "figures" / "mine.svg").write_text("stays")
    with replacing_all(tmp_path / "out") as unfinished:
        write_text(unfinished / "a.txt", "")
        write_text(unfinished / "figures" / "a.svg", "")
    assert everything_in(tmp_path) == ["out", "out/a.txt", "out/figures", "out/figures/a.svg", "out/figures/mine.svg"]


def test_nothing_is_put_in_place_where_a_file_has_the_name_of_a_folder(tmp_path):
    write_text(tmp_path / "out" / "figures", "")

    def write():
        with replacing_all(tmp_path / "out") as unfinished:
            write_text(unfinished / "a.txt", "")
            write_text(unfinished / "figures" / "a.svg", "")

    with pytest.raises(InputError, match="figures: need a folder or nothing there, got a file"):
        write()
    assert everything_in(tmp_path) == ["out", "out/figures"]


@pytest.mark.parametrize("lasting", [False, True])
def test_if_a_file_cannot_be_replaced_all_old_files_are_unchanged(tmp_path, lasting):
    # one number for every rename, including the files written before the exchange
    for number in range(1, 100):
        folder = tmp_path / str(number)
        fill(folder)
        with pytest.MonkeyPatch.context() as patch:
            calls = fails_from(patch, number, 10**9 if lasting else number)
            sentence = refusal(folder)
        if sentence is None:
            break
        assert "Operation not permitted" in sentence
        assert len(sentence.splitlines()) == 1
        if lasting:
            # nothing could be restored, either: the next run does that
            clear_leftovers(folder)
        assert files_in(folder) == OLD
    assert calls[0] == number - 1 > 12
    assert files_in(folder) == AFTER


def test_a_file_that_cannot_be_changed_is_named_and_old_files_are_unchanged(tmp_path):
    fill(tmp_path)
    attributes = shutil.which("chattr")
    command = [attributes or "", "+i", tmp_path / "b.txt"]
    if attributes is None or subprocess.run(command, capture_output=True, check=False).returncode:
        pytest.skip("no file can be made immutable here")
    try:
        sentence = refusal(tmp_path)
        assert files_in(tmp_path) == OLD
    finally:
        subprocess.run([attributes, "-i", tmp_path / "b.txt"], check=True)
    why = "Operation not permitted; the old files are unchanged"
    assert sentence == f"{tmp_path}/b.txt: cannot be replaced: {why}"
    write_new(tmp_path)
    assert files_in(tmp_path) == AFTER


# exits at every disk operation in turn, and reports the content then and after the next run
DIES = """
import itertools, json, os, signal, sys
from pathlib import Path
from tests.test_files import fill, files_in, write_new
from forficula.files import clear_leftovers
CHANGES = {"os.rename", "os.remove", "os.mkdir", "os.rmdir", "open"}
def main(folder):
    for number in itertools.count(1):
        fill(folder / str(number))
        child = os.fork()
        if not child:
            left = [number]
            def count(event, arguments):
                if event in CHANGES and str(folder) in str(arguments[0]):
                    left[0] -= 1
                    if not left[0]:
                        os.kill(os.getpid(), signal.SIGKILL)
            sys.addaudithook(count)
            write_new(folder / str(number))
            os._exit(0)
        _, status = os.waitpid(child, 0)
        clear_leftovers(folder / str(number))
        print(json.dumps(files_in(folder / str(number))), flush=True)
        if status == 0:
            return
main(Path(sys.argv[1]))
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
def test_killed_anywhere_a_run_leaves_the_old_files_or_the_new_ones_and_nothing_else(tmp_path):
    command, root = [sys.executable, "-c", DIES, tmp_path], Path(__file__).parents[1]
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=root)
    assert (done.returncode, done.stderr) == (0, "")
    *killed, finished = [json.loads(line) for line in done.stdout.splitlines()]
    assert finished == AFTER
    assert len(killed) > 40
    which = [{"old": OLD, "new": AFTER}["new" if "d.txt" in item else "old"] == item for item in killed]
    assert all(which)
    assert OLD in killed
    assert AFTER in killed


AGAIN_AND_AGAIN = """
import sys
from pathlib import Path
from forficula.files import replacing_all, write_text
for number in range(int(sys.argv[3])):
    with replacing_all(Path(sys.argv[1])) as unfinished:
        for name in "abcdef":
            write_text(unfinished / name, f"{sys.argv[2]}-{number}" + " " * 20_000)
    if not number:
        print("once", flush=True)
"""


def writer(folder, name, times):
    command = [sys.executable, "-c", AGAIN_AND_AGAIN, str(folder), name, str(times)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, text=True)


def test_killed_at_any_time_all_files_are_of_one_writing(tmp_path):
    delays = random.Random(11)
    for number in range(12):
        child = writer(tmp_path, str(number), 10**6)
        assert child.stdout.readline() == "once\n"
        time.sleep(delays.uniform(0, 0.05))
        child.kill()
        child.wait()
        child.stdout.close()
        clear_leftovers(tmp_path)
        content = files_in(tmp_path)
        assert sorted(content) == list("abcdef")
        assert len(set(content.values())) == 1


def test_after_concurrent_writes_to_one_folder_all_files_are_of_the_last_process(tmp_path):
    children = [writer(tmp_path, name, 40) for name in ("one", "two", "three")]
    assert [child.communicate()[0] and child.returncode for child in children] == [0, 0, 0]
    content = files_in(tmp_path)
    assert sorted(content) == list("abcdef")
    assert {text.strip() for text in content.values()} <= {"one-39", "two-39", "three-39"}
    assert len(set(content.values())) == 1


@pytest.mark.parametrize("whole", [True, False])
def test_temporary_files_of_killed_processes_are_removed_and_those_of_running_ones_are_not(tmp_path, whole):
    script = (
        "import sys, time\nfrom pathlib import Path\nfrom forficula.files import replacing, replacing_all\n"
        f"with {'replacing_all(Path(sys.argv[1]))' if whole else 'replacing(Path(sys.argv[1], chr(97)))'} as place:\n"
        f"    {'(place / chr(97))' if whole else 'place'}.write_text('half')\n"
        "    print('half', flush=True)\n"
        "    sys.stdin.readline()\n"
    )
    with subprocess.Popen(
        [sys.executable, "-c", script, tmp_path], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as living:
        with subprocess.Popen([sys.executable, "-c", script, tmp_path], stdout=subprocess.PIPE, text=True) as dead:
            assert [living.stdout.readline(), dead.stdout.readline()] == ["half\n", "half\n"]
            dead.kill()
        write_text(tmp_path / "b", "")
        assert len(list(tmp_path.glob(".*.lock"))) == 1
        living.communicate("\n")
    assert living.returncode == 0
    assert files_in(tmp_path) == {"a": "half", "b": ""}


def test_a_folder_of_the_user_that_looks_like_ours_is_left_alone(tmp_path):
    for name in (".forficula-notes", ".forficula-0123456789abcdef", ".a-12345678"):
        fill(tmp_path / name, {"file": "mine"})
    write_new(tmp_path)
    assert len([name for name in files_in(tmp_path) if name.endswith("/file")]) == 3


def test_the_current_folder_and_one_behind_a_link_and_a_mounted_one_can_be_written(tmp_path, monkeypatch):
    fill(tmp_path / "real")
    (tmp_path / "link").symlink_to(tmp_path / "real", target_is_directory=True)
    write_new(tmp_path / "link")
    assert files_in(tmp_path / "real") == AFTER
    monkeypatch.chdir(tmp_path / "real")
    write_new(Path())
    assert files_in(tmp_path / "real") == AFTER
    assert (tmp_path / "link").is_symlink()
    # nothing is made beside it: what is above a mounted folder is another disk
    assert sorted(place.name for place in tmp_path.iterdir()) == ["link", "real"]
    before = (tmp_path / "real").stat().st_ino
    write_new(tmp_path / "real")
    assert (tmp_path / "real").stat().st_ino == before


@pytest.mark.parametrize("write", [lambda path: write_text(path, "new"), lambda path: write_new(path.parent)])
def test_a_planted_link_is_replaced_and_not_followed(tmp_path, write):
    (tmp_path / "out").mkdir()
    (tmp_path / "elsewhere").write_text("theirs")
    (tmp_path / "out" / "a.txt").symlink_to(tmp_path / "elsewhere")
    write(tmp_path / "out" / "a.txt")
    assert (tmp_path / "elsewhere").read_text() == "theirs"
    assert not (tmp_path / "out" / "a.txt").is_symlink()


@pytest.mark.parametrize("exists", [True, False])
def test_lines_are_not_added_to_a_file_behind_a_link(tmp_path, exists):
    if exists:
        (tmp_path / "elsewhere").write_text("theirs")
    (tmp_path / "a.jsonl").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(InputError) as caught:
        open_to_append(tmp_path / "a.jsonl")
    sentence = f"{tmp_path}/a.jsonl: need a file or nothing there, got a link to {tmp_path}/elsewhere; remove it"
    assert str(caught.value) == sentence
    assert (tmp_path / "elsewhere").exists() == exists


def test_a_new_folder_that_could_not_be_filled_is_not_left_behind(tmp_path):
    def write():
        with replacing_all(tmp_path / "out") as unfinished:
            write_text(unfinished / "a.txt", "")
            raise RuntimeError("bug")

    with pytest.raises(RuntimeError):
        write()
    assert everything_in(tmp_path) == []


@pytest.fixture
def full_disk():
    """A disk on which no file gets longer than 1 KB."""
    resource = pytest.importorskip("resource")
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1024, limits[1]))
    yield
    resource.setrlimit(resource.RLIMIT_FSIZE, limits)


def fill_by(write, folder):
    with replacing_all(folder) as unfinished:
        (unfinished / "figures").mkdir()
        write(unfinished / "a.txt", "short")
        write(unfinished / "figures" / "b.svg", "x" * 2000)


@pytest.mark.usefixtures("full_disk")
def test_a_full_disk_is_reported_with_the_file_and_leaves_no_file(tmp_path):
    with pytest.raises(InputError) as caught:
        write_text(tmp_path / "page.html", "x" * 2000)
    assert str(caught.value) == f"{tmp_path / 'page.html'}: cannot be written: {os.strerror(errno.EFBIG)}"
    for write in (write_text, lambda path, text: path.write_text(text)):
        with pytest.raises(InputError) as caught:
            fill_by(write, tmp_path / "run")
        # errors from Python itself do not name the file
        place = tmp_path / "run" / "figures" / "b.svg" if write is write_text else tmp_path / "run"
        assert str(caught.value) == f"{place}: cannot be written: {os.strerror(errno.EFBIG)}"
    assert everything_in(tmp_path) == []


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no named pipes here")
@pytest.mark.parametrize("name", ["d.toml", "d.fold", "d.svg", "d.dxf", "law.toml", "s.toml", "t.csv", "record.nc"])
def test_a_named_pipe_is_refused_without_waiting(tmp_path, name):
    os.mkfifo(tmp_path / name)
    with pytest.raises(InputError, match=rf"{name}: need a regular file, got a named pipe$"):
        read_as_input(tmp_path / name)


@pytest.mark.skipif(not Path("/dev/zero").exists(), reason="there is no device without an end here")
@pytest.mark.parametrize("name", ["d.toml", "d.fold", "d.svg", "d.dxf", "law.toml", "s.toml", "t.csv", "record.nc"])
def test_a_device_without_an_end_is_refused(tmp_path, name):
    (tmp_path / name).symlink_to("/dev/zero")
    with pytest.raises(InputError, match=rf"{name}: need a regular file, got a device$"):
        read_as_input(tmp_path / name)


@pytest.mark.parametrize("name", ["d.toml", "d.fold", "d.svg", "d.dxf", "law.toml", "s.toml"])
def test_a_file_of_gigabytes_is_refused_before_it_is_read(tmp_path, name):
    with (tmp_path / name).open("wb") as file:
        file.truncate(3 * 2**30)
    with pytest.raises(InputError, match=rf"{name}: need a file of at most 64 MiB, got a larger one$"):
        read_as_input(tmp_path / name)


@pytest.mark.skipif(not Path("/dev/fd/0").exists(), reason="no shell hands over pipes by name here")
def test_a_pipe_that_a_shell_hands_over_is_read_to_its_end():
    end, start = os.pipe()
    os.write(start, b"0,1")
    os.close(start)
    try:
        assert read_bytes(Path(f"/dev/fd/{end}")) == b"0,1"
    finally:
        os.close(end)


def test_a_file_of_a_byte_more_than_the_limit_is_refused(tmp_path):
    (tmp_path / "long.csv").write_bytes(b"0" * 11)
    assert read_bytes(tmp_path / "long.csv", 11) == b"0" * 11
    with pytest.raises(InputError, match="at most"):
        read_bytes(tmp_path / "long.csv", 10)


def read_as_input(path):
    """Read a file by its name, as a user does."""
    match path.name:
        case "law.toml":
            load_law(path)
        case "s.toml":
            load_study(path)
        case "t.csv":
            read_tensile_test(path)
        case "record.nc":
            load_record(path)
        case _:
            load_design(path)


@pytest.mark.parametrize(("name", "what"), [("a\0b", "a null byte"), ("a\ud800b", "a lone surrogate")])
def test_a_name_that_no_file_can_have_is_one_error(tmp_path, name, what):
    for use, done in ((read_bytes, "read"), (lambda path: write_bytes(path, b""), "written"), (write_new, "written")):
        with pytest.raises(InputError, match=rf"cannot be {done}: (embedded null byte|its name holds {what})"):
            use(tmp_path / name)
