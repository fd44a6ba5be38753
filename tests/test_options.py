import re
from contextlib import redirect_stdout, suppress
from io import StringIO

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from forficula.cli import _COMMANDS, app, main
from forficula.errors import InputError
from forficula.files import replacing_all
from forficula.options import read_settings, read_shard, read_size
from forficula.results import KINDS, check_own_kind


@pytest.fixture
def refusal(tmp_path, monkeypatch, capsys):
    """Call the command line in an empty folder and return its one line."""
    monkeypatch.chdir(tmp_path)

    def call(*arguments):
        with pytest.raises(SystemExit) as caught:
            main(arguments)
        output = capsys.readouterr()
        assert (caught.value.code, output.out) == (1, "")
        assert output.err.count("\n") == 1
        return output.err.removeprefix("forficula: ").removesuffix("\n")

    return call


@pytest.mark.parametrize(
    ("command", "option"),
    [
        (["study", "binder2025-search"], "--slurm"),
        (["study", "binder2025-search"], "--keep"),
        (["run", "binder2025"], "--cycles"),
        (["film", "there", "--out", "a.gif"], "--fps"),
    ],
)
@pytest.mark.parametrize("number", ["2.5", "12.9", "1e1", "²", "٣", "0x10", "nan", "one", "9" * 5000])
def test_what_is_no_whole_number_is_refused_with_its_option(refusal, command, option, number):
    message = refusal(*command, option, number)
    assert message.startswith(f"Invalid value for {option}: need a whole number")
    assert (", got " in message, "of at most 18 digits" in message) == (True, number.startswith("99"))
    assert len(message) < 200


@given(st.text(st.characters(categories=["N"], include_characters="/+-_ "), max_size=8))
@example("²/3")
@example("٣/٣")
@example(f"1/{'9' * 5000}")
def test_a_shard_is_two_whole_numbers_or_one_error(text):
    if re.fullmatch(r"0*[1-9]\d{0,5}/0*[1-9]\d{0,5}", text, re.ASCII):
        number, _, count = text.partition("/")
        if int(number) <= int(count):
            assert read_shard(text) == (int(number), int(count))
            return
    with pytest.raises(InputError, match=r"^--shard: need a number and a count such as 2/8, got .{0,70}$"):
        read_shard(text)


@pytest.mark.parametrize("size", ["²x4", f"{'8' * 5000}x2", "٣٢٠x١٨٠"])
def test_a_size_is_of_plain_digits(size):
    with pytest.raises(InputError, match=r"^--size: need two even numbers"):
        read_size("--size", size, 64, 4096)


@pytest.mark.parametrize("option", ["--set", "--over"])
def test_a_key_that_is_set_twice_is_refused(option):
    with pytest.raises(InputError) as caught:
        read_settings(["tendon.stiffness=10 N/cm", " tendon.stiffness = 20 N/cm"], option)
    assert str(caught.value) == f"{option}: tendon.stiffness is given twice"


def test_bytes_that_are_not_text_are_refused():
    with pytest.raises(InputError, match=r"^--set: need text in UTF-8, got "):
        read_settings(["source=\udcff"])


def test_keys_that_are_set_once_are_values():
    assert read_settings(["a.b=1", "c = 2 cm"]) == {"a.b": 1, "c": "2 cm"}


MARKERS = {kind.name: kind.marker for kind in KINDS if kind.marker}


def offered(command):
    """The options that the help of a command shows."""
    with redirect_stdout(StringIO()) as output:
        main([command, "--help"])
    return re.findall(r"^│ [* ]*(--[a-z-]+)", output.getvalue(), re.M)


@pytest.mark.parametrize("command", [name for name in app if not name.startswith("-")])
def test_an_option_that_help_shows_is_accepted_and_no_other(command, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    options = offered(command)
    assert "--quiet" in options
    for option in options:
        # of no design, file or folder at all: what is refused then, if anything, is not the option
        with suppress(SystemExit):
            main([command, "nowhere", option])
        said = capsys.readouterr().err
        assert not re.search(rf"unknown option|{option}: need (?!KEY)[a-z]+, ", said, re.I), (option, said)
    if "--json" not in options:
        with pytest.raises(SystemExit):
            main([command, "nowhere", "--json"])
        # the option, or what the command needs before that
        assert re.match("forficula: (--json: need run, |Command .* requires)", capsys.readouterr().err)


@pytest.mark.parametrize("kind", MARKERS)
def test_a_folder_with_another_kind_of_results_is_refused(tmp_path, kind):
    (tmp_path / MARKERS[kind]).write_text("{}")
    if kind == "optimisation":  # which has a study's table, too
        (tmp_path / MARKERS["study"]).write_text("{}")
    check_own_kind(tmp_path, kind)
    for name in MARKERS.keys() - {kind}:
        with pytest.raises(
            InputError, match=rf"need a folder of its own, got .*, which holds an? {kind} \({MARKERS[kind]}"
        ):
            check_own_kind(tmp_path, name)


def test_a_folder_that_cannot_be_made_is_refused_before_anything_runs(refusal, tmp_path):
    name = "n" * 300
    message = refusal("run", "binder2025", "--set", f"name={name}")
    assert message.startswith("--out: out/nnn")
    assert message.endswith("cannot be written: File name too long")
    assert not list(tmp_path.iterdir())
    with pytest.raises(InputError, match="cannot be written: File name too long"), replacing_all(tmp_path / "a" / name):
        raise AssertionError("not reached")
    assert not list(tmp_path.iterdir())


def test_a_study_does_not_replace_the_page_of_a_run(refusal, tmp_path):
    (tmp_path / "x").mkdir()
    (tmp_path / "x" / "summary.json").write_text("{}")
    assert refusal("study", "binder2025-search", "--out", "x").startswith(
        "--out: need a folder of its own, got x, which holds a run (summary.json), whose page and figures"
        " would be replaced"
    )


def test_rows_of_a_study_are_kept_apart_from_runs(tmp_path):
    (tmp_path / "journal-1-of-2.jsonl").write_text("")
    check_own_kind(tmp_path, "study")
    with pytest.raises(InputError, match=r"which holds rows of a study \(journal-1-of-2\.jsonl\)"):
        check_own_kind(tmp_path, "run")


SQUARE = (
    '{"file_spec": 1.1, "vertices_coords": [[0, 0], [1, 0], [1, 1], [0, 1]], "edges_assignment": ["B", "B", "B", "B",'
    ' "V"], "edges_vertices": [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]]}'
)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("new", "design", "a.toml", "--size", "1e30 m"), "--size: need >= 0.1 mm and <= 10 km, got 1e+30 m"),
        (("new", "design", "a.toml", "--size", "1e-9 m"), "--size: need >= 0.1 mm and <= 10 km, got 0.001 µm"),
        (("tolerance", "letter-fold", "--minutes", "-1"), "--minutes: need a number > 0, got -1.0"),
        (("tolerance", "letter-fold", "--runs", "0"), "--runs: need a whole number >= 1, got 0"),
        (("tolerance", "letter-fold", "--seed", "-1"), "--seed: need a whole number >= 0, got -1"),
        (("tolerance", "letter-fold", "--tolerance", 'facet.thick="5 %"'), "--tolerance: facet.thick: unknown key"),
        (("run", "miura-sheet", "--unit", "1 cm"), '--unit: a design already has units, got "1 cm"'),
        (("run", "square.fold", "--unit=-1 cm"), '--unit: need > 0, got "-1 cm"'),
        (("open", "miura-sheet", "--unit", "1 cm"), '--unit: a design already has units, got "1 cm"'),
        *(
            ((command, "miura-sheet", "--unit", "1 cm"), '--unit: a design already has units, got "1 cm"')
            for command in ("assumptions", "converge", "tolerance")
        ),
        (
            ("tolerance", "--unit", "1 cm", "--goal", "light-wing"),
            "--unit: needs a FOLD file or a drawing as the design",
        ),
        (("landscape", "letter-fold", "--over", "facet.thick=1"), "--over: facet.thick: unknown key"),
        (("run", "letter-fold", "--out", "aux"), "Invalid value for --out: need a path that every system can have"),
        (("run", "letter-fold", "--out", "out/NUL.txt/a"), "Invalid value for --out: need a path that every system"),
        (("run", "sqare.fold2"), '"sqare.fold2" is neither a named design nor a .toml, .fold, .svg or .dxf file; did'),
        (("study", "study.toml"), "study.toml: design: study.toml: need a design, got a study, because it has factors"),
        (
            ("study", "wing.toml"),
            "wing.toml: need a study, got a design, because it has based_on; give it to",
        ),
    ],
)
def test_an_error_names_the_option_and_comes_before_any_note(refusal, tmp_path, arguments, message):
    (tmp_path / "square.fold").write_text(SQUARE)
    (tmp_path / "study.toml").write_text('design = "study.toml"\n[factors]\n"facet.thickness" = ["1 mm"]\n')
    (tmp_path / "wing.toml").write_text('based_on = "binder2025"\n')
    assert refusal(*arguments).startswith(message)


def test_a_list_of_names_in_an_error_is_short(refusal):
    assert refusal("run", "none") == (
        '"none" is neither a named design nor a .toml, .fold, .svg or .dxf file; forficula designs lists the named'
        " designs: binder2025, binder2025-built, binder2025-coupled, binder2025-joint, ..."
    )


def test_examples_of_help_fit_on_a_line_of_a_terminal():
    for command in _COMMANDS:
        assert all(len(f"  forficula {example}") < 80 for example in command.examples), command.examples
