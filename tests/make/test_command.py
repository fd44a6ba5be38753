"""`forficula make`, as a user calls it."""

import io
import json
import re

import pytest
from matplotlib.colors import to_hex
from rich.console import Console

import forficula as ff
from forficula.cli import main
from forficula.show.folder.parts_folder import parts_drawings, read_checks
from forficula.show.make.parts_table import parts_table

pytestmark = pytest.mark.usefixtures("undrawn")
# bridges that burn away
NARROW = ("--set", "make.crease_style=perforation", "--set", "make.crease_bridge=0.05 mm")


@pytest.fixture
def call(capsys, tmp_path, monkeypatch):
    """Call the command line, which must exit with a status, and return its output."""
    monkeypatch.chdir(tmp_path)

    def call(*arguments, expected=0):
        status = 0
        try:
            main(("make", "letter-fold", *arguments))
        except SystemExit as ended:
            status = ended.code or 0
        assert status == expected
        return capsys.readouterr()

    return call


def test_a_folder_and_a_table_are_written(call, tmp_path):
    output = call()
    assert output.out.startswith("letter-fold: 1 piece, 1 cut\n")
    assert "checks hold, 0 fail" in output.out
    assert output.out.endswith("written to out/letter-fold-parts; open out/letter-fold-parts/parts.html\n")
    folder = tmp_path / "out" / "letter-fold-parts"
    files = {"bill.csv", "bill.json", "checks.json", "design.toml", "sheet.dxf", "sheet.svg"}
    assert {path.name for path in folder.iterdir()} >= files
    assert ff.load_design(folder / "design.toml").hash == ff.load_design("letter-fold").hash


def test_a_failed_check_is_reported_and_exits_with_2_by_default(call):
    output = call(*NARROW, expected=2)
    assert "fails" in output.out
    assert "narrower ones burn away" in " ".join(output.out.split())
    assert call(*NARROW, "--no-strict").out == output.out
    assert call(*NARROW, "--strict", expected=2).out == output.out


def test_failures_are_red_on_the_terminal_in_the_figure_and_on_the_page(call, tmp_path):
    call(*NARROW, expected=2)
    folder = tmp_path / "out" / "letter-fold-parts"
    page = (folder / "parts.html").read_text("utf-8")
    assert re.search(r'<strong class="fails">1 of \d checks fails; see below.</strong>', page)
    assert '<strong class="fails">failed</strong>' in page
    parts, checks = ff.make.parts(ff.load_design(folder / "design.toml")), read_checks(folder)
    title = parts_drawings(parts, checks)["sheet"](7.1)._suptitle
    assert "checks fails: bridges" in title.get_text()
    assert to_hex(title.get_color()) == "#d55e00"
    console = Console(file=io.StringIO(), force_terminal=True, color_system="standard", width=110)
    console.print(parts_table(parts, checks))
    assert "\x1b[1;31mfails" in console.file.getvalue()


def test_windows_that_leave_too_narrow_strips_are_marked_on_the_sheet():
    sheet = ff.make.parts("binder2025-thick", "sheet").sheet
    assert {check.name for check in sheet.checks if check.ok is False} == {"strips", "windows"}
    # two veins each have a strap that is close to both hinges or crosses them
    assert len(sheet.faults) == 6


def test_windows_that_meet_and_pieces_that_come_off_are_marked_on_the_sheet():
    sheet = ff.make.parts("binder2025", "sheet").sheet
    assert sum(check.ok is False for check in sheet.checks) == 2
    assert len(sheet.faults) >= 4
    assert ff.make.parts("letter-fold", "sheet").sheet.faults == ()


def test_results_are_data(call):
    output = json.loads(call("--part", "sheet", "--json").out)
    assert (output["design"], [row["part"] for row in output["parts"]]) == ("letter-fold", ["sheet"])
    assert {check["ok"] for check in output["checks"]} == {True}


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--part", "shet"), "shet"),
        (("--part", "joint"), "--part sheet"),
        (("--record", "nowhere"), "--record: nowhere"),
        (("--set", "make.kerff=1 mm"), "did you mean make.kerf"),
    ],
)
def test_invalid_input_exits_with_1_and_writes_nothing(call, tmp_path, arguments, message):
    output = call(*arguments, expected=1)
    assert output.err.startswith("forficula: ")
    assert message in output.err
    assert list(tmp_path.iterdir()) == []


def test_a_run_of_another_design_is_refused(letter_run):
    parts = ff.make.parts("letter-fold", "sheet")
    assert all(check.ok for check in ff.make.check_parts(parts, letter_run))
    other = ff.make.parts(ff.load_design("letter-fold").with_values({"protocol.window": "70 ms"}), "sheet")
    with pytest.raises(ff.InputError, match="record: need a run of letter-fold with the same values"):
        ff.make.check_parts(other, letter_run)
    with pytest.raises(ff.InputError, match="record: need the record of a run, or its folder, got a int"):
        ff.make.check_parts(parts, 3)


def test_parts_are_saved_by_one_call(call, tmp_path):
    call()
    ff.save(ff.make.parts("letter-fold", "sheet"), tmp_path / "there")
    called, saved = (
        {file.relative_to(folder): file.read_bytes() for file in folder.rglob("*.*") if file.is_file()}
        for folder in (tmp_path / "out" / "letter-fold-parts", tmp_path / "there")
    )
    assert called == saved


def test_every_part_of_an_assembly_gets_a_folder_of_its_own(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    main(("make", "two-clasps", "--json"))
    assert set(json.loads(capsys.readouterr().out)) >= {"inner", "outer"}
    for part in ("inner", "outer"):
        assert (tmp_path / "out" / "two-clasps-parts" / part / "bill.json").is_file()
    with pytest.raises(SystemExit):
        main(("make", "two-clasps", "--record", "run"))
    assert "--record: is for a design that is not an assembly" in capsys.readouterr().err
