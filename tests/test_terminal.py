"""What the command line writes, whatever it writes to."""

import io
import json
import os
import subprocess
import sys
import warnings

import pytest

from forficula.cli import main
from forficula.terminal import command_output, set_result

LAW = "name = 'Ĝummi µ'\nsource = ''\n[modulus]\nlinear = '4.8 MPa'\n"


@pytest.mark.parametrize(
    ("encoding", "length", "name"),
    [("ascii", b"50 um", b"Gummi u"), ("cp1252", "50 µm".encode("cp1252"), "Gummi µ".encode("cp1252"))],
)
def test_letters_that_the_output_lacks_are_spelled(tmp_path, monkeypatch, encoding, length, name):
    def called(*arguments):
        """The bytes that a command writes to its two outputs, and what it ends with."""
        status = 0
        with monkeypatch.context() as patch:
            for output in ("stdout", "stderr"):
                patch.setattr(sys, output, io.TextIOWrapper(io.BytesIO(), encoding))
            try:
                main(arguments)
            except SystemExit as ended:
                status = ended.code
            sys.stderr.flush()
            return status, sys.stdout.buffer.getvalue(), sys.stderr.buffer.getvalue()

    (tmp_path / "law.toml").write_text(LAW, "utf-8")
    small = ["--material", str(tmp_path / "law.toml"), "--length", "50 µm"]
    status, output, errors = called("size", "binder2025", *small, "--stiffness", "10 N/cm")
    # on a busy machine it says how long it took
    assert (status, [line for line in errors.splitlines() if not line.startswith(b"took ")]) == (0, [])
    assert name in output
    status, output, errors = called("run", "binder2025", "--set", "tendon.rest_length=5 µJ")
    assert (status, output, errors.count(b"\n")) == (1, b"", 1)
    assert length[-2:-1] + b"J" in errors


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="there is no full device here")  # noqa: PTH110
@pytest.mark.parametrize("arguments", [["--help"], ["--version"], ["designs"], ["study", "--help"]])
def test_a_full_device_is_reported_in_one_line(arguments):
    with open("/dev/full", "w") as full:  # noqa: PTH123
        done = subprocess.run(
            [sys.executable, "-m", "forficula", *arguments], stdout=full, stderr=subprocess.PIPE, check=False, text=True
        )
    assert done.returncode == 1
    # on a slow machine the run time is printed before
    assert done.stderr.splitlines()[-1] == "forficula: the output cannot be written: No space left on device"


@pytest.mark.parametrize("buffered", [True, False])
def test_a_run_whose_output_is_closed_writes_its_folder_and_ends_quietly(tmp_path, monkeypatch, capsys, buffered):
    """As with `forficula run NAME | head -1`: the reader of the output is gone when the first line is written."""
    reading, writing = os.pipe()
    os.close(reading)
    # a large buffer is written when the folder is complete, none at the first line
    with io.TextIOWrapper(open(writing, "wb", buffering=-1 if buffered else 0), write_through=not buffered) as output:  # noqa: PTH123
        monkeypatch.setattr(sys, "stdout", output)
        main(["run", "binder2025-joint", "--no-engine", "--no-confirm", "--out", str(tmp_path)])
        monkeypatch.undo()
    assert {"summary.json", "report.html", "record.nc"} <= {path.name for path in tmp_path.iterdir()}
    errors = capsys.readouterr().err.splitlines()
    assert [line for line in errors if not line.startswith(("took ", "warning: "))] == []


def test_a_warning_of_a_library_is_one_line_without_its_place(monkeypatch, capsys):
    def warn():
        warnings.warn("Glyph 25240 missing\nfrom font(s) X.", UserWarning, stacklevel=1)
        warnings.warn("Glyph 12426 missing from font(s) X.", UserWarning, stacklevel=1)
        warnings.warn("overflow encountered in exp", RuntimeWarning, stacklevel=1)
        return {}

    monkeypatch.setattr("forficula.design.named_designs", warn)
    with warnings.catch_warnings():
        warnings.simplefilter("default")
        main(["designs"])
    assert capsys.readouterr().err == ("warning: Glyph 25240 missing from font(s) X.\n")


@pytest.mark.parametrize(
    "error",
    [
        MemoryError(),
        ImportError("libmujoco.so: failed to map segment from shared object"),
        RuntimeError("can't start new thread"),
        ValueError("Error: engine error: Could not allocate memory"),
    ],
)
def test_no_memory_left_is_reported_in_one_line(monkeypatch, capsys, error):
    def fill():
        raise error

    monkeypatch.setattr("forficula.design.named_designs", fill)
    with pytest.raises(SystemExit) as caught:
        main(["designs"])
    assert caught.value.code == 1
    output = capsys.readouterr()
    assert output.err.startswith("forficula: no memory left")
    assert output.err.count("\n") == 1


@pytest.mark.skipif(sys.platform != "linux", reason="other systems do not keep to the limit")
@pytest.mark.parametrize("limit", [150_000, 200_000, 230_000, 250_000])  # kB; OpenBLAS never returned at 200_000
def test_a_limit_on_memory_that_leaves_no_room_for_linear_algebra_ends_with_one_line(limit, tmp_path):
    run = f"{sys.executable} -m forficula run binder2025 --no-engine --out {tmp_path / 'run'}"
    ended = subprocess.run(
        ["bash", "-c", f"ulimit -v {limit}; exec {run}"], capture_output=True, text=True, timeout=60, check=False
    )
    assert ended.returncode == 1
    assert ended.stderr.startswith("forficula: no memory left")
    assert ended.stderr.count("\n") == 1


@pytest.mark.parametrize("items", [[], [{"a": 1, "b": ["µ", None]}], [{"a": {"b": 1}}, 2.5, "two\nlines"]])
def test_items_that_are_written_one_after_another_are_the_json_of_their_list(items, capsys):
    for result in (items, iter(items)):
        with command_output(quiet=False, as_json=True):
            set_result(result)
    text = capsys.readouterr().out
    assert text == 2 * f"{json.dumps(items, indent=2, ensure_ascii=False)}\n"
