import os
import stat

import pytest

from forficula.errors import InputError
from forficula.files import replacing, replacing_all, write_bytes, write_text


def everything_in(folder):
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*"))


def test_a_text_is_written_as_utf_8_with_plain_line_ends(tmp_path):
    write_text(tmp_path / "deep" / "er" / "a.txt", "é\nb\n")
    assert (tmp_path / "deep" / "er" / "a.txt").read_bytes() == b"\xc3\xa9\nb\n"


@pytest.mark.parametrize("content", [b"\x00\r\n", memoryview(b"\x00\r\n")])
def test_bytes_are_written_as_they_are(tmp_path, content):
    write_bytes(tmp_path / "a.nc", content)
    assert (tmp_path / "a.nc").read_bytes() == b"\x00\r\n"


def test_a_file_that_was_there_is_replaced_and_nothing_else_is_left(tmp_path):
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
