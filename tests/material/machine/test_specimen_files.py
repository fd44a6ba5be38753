import pytest

from forficula.errors import InputError
from forficula.material.machine.specimen_files import read_specimens
from tests.material.synthetic import AREA, LENGTH, few_rows, plain_text, xpert_text


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("a.csv", "b.csv", "sub/a.csv"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(plain_text(few_rows()), "utf-8")
    (tmp_path / "whole.txt").write_text(xpert_text(few_rows()), "utf-8")
    return tmp_path


def read(*patterns):
    return read_specimens(patterns, length=LENGTH, area=AREA)


@pytest.mark.usefixtures("folder")
def test_patterns_are_expanded_in_order_where_the_shell_did_not():
    assert read("*.csv").files == ("a.csv", "b.csv")
    assert [test.name for test in read("b.csv", "a.csv").tests] == ["b", "a"]


@pytest.mark.usefixtures("folder")
def test_files_with_one_name_in_two_folders_get_different_names():
    assert [test.name for test in read("a.csv", "sub/a.csv").tests] == ["a", "sub/a"]


def test_a_file_whose_name_looks_like_a_wildcard_is_read(folder):
    (folder / "a[1].csv").write_text(plain_text(few_rows()), "utf-8")
    assert read("a[1].csv").files == ("a[1].csv",)


@pytest.mark.usefixtures("folder")
def test_the_source_names_the_files():
    assert read("*.csv").source.endswith("tensile tests in a.csv, b.csv")


@pytest.mark.parametrize(
    ("patterns", "message"),
    [
        ((), "need at least one file"),
        (("sub",), r"^sub: need a file of a tensile test, got a folder; name its files, as in sub/\*\.csv"),
        (("q*.csv",), '^"q.*": no file has such a name'),
        (("none.csv",), r"^none\.csv: no such file"),
        (("a.csv", "./a.csv"), r"^\./a\.csv: is given twice"),
        (("a.csv", "cut.csv", "b.csv"), r"^cut\.csv: line \d+: .*cut off"),
    ],
)
def test_the_file_that_is_wrong_is_named(folder, patterns, message):
    lines = plain_text(few_rows()).splitlines()
    (folder / "cut.csv").write_text("\n".join([*lines[:-1], lines[-1].split(",")[0]]), "utf-8")
    with pytest.raises(InputError, match=message):
        read(*patterns)


@pytest.mark.usefixtures("folder")
def test_a_length_in_conflict_with_a_file_names_the_file():
    with pytest.raises(InputError, match=r"^whole\.txt: length: 50 mm was given, but the file has 60 mm"):
        read_specimens(["whole.txt"], length=0.05)
