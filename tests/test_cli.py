import contextlib
import csv
import json
import math
import os
import re
import shutil
import signal
import subprocess
import sys

import numpy as np
import pytest

import forficula as ff
from forficula.cli import app, main
from forficula.commands.cost import CountEstimate, RunEstimate
from forficula.design import design_pattern
from forficula.goals import load_goal
from forficula.show.style import figure_files
from tests.assumptions import flap
from tests.material.folding.strips import folded_strip
from tests.material.synthetic import cyclic_test, plain_text

# the shortest run that leaves everything: 10 ms of settling
SHORT = """\
based_on = "binder2025"
[[protocol.stages]]
name = "settle"
drive = "none"
until = "time"
hold = "0 s"
time_limit = "10 ms"
"""


@pytest.fixture(autouse=True)
def in_an_empty_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def everything_in(folder):
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*"))


# the command line, which leaves the figures and the fold paths of runs out
UNDRAWN = """\
import sys
from forficula.cli import main
from forficula.files import write_bytes
from forficula.show.folder import run_folder
from forficula.show.page import run_page
from forficula.show.page.data.shown_path import Fold
def save_nothing(drawings, folder, copies):
    return {stem: str(write_bytes(folder / f"{stem}.png", b"")) for stem in drawings}
run_folder.save_figures = save_nothing
run_page.fold_of = lambda structure: Fold(path=None, missing="Not computed.")
"""
# the same command, which ends while it replaces existing files
DYING = f"""\
{UNDRAWN}
import os, signal
replace = os.replace
def die(source, target):
    replace(source, target)
    if "record.nc" in str(target) and "old" in str(target):
        os.kill(os.getpid(), signal.SIGKILL)
os.replace = die
main(sys.argv[1:])
"""


def process(*arguments):
    """Run Python in a process of its own, as a user's shell does."""
    return subprocess.run(
        [sys.executable, *arguments],
        capture_output=True,
        text=True,
        check=False,
        env=os.environ | {"PYTHONWARNINGS": "error"},
    )


@pytest.fixture
def call(capsys, request):
    """Call the command line, which must end with 0 or what is expected, and return what it wrote.

    Figures are composed in tests that ask for `no_figures`.
    """
    if "no_figures" not in request.fixturenames:
        request.getfixturevalue("undrawn")

    def call(*arguments, expected=0):
        status = 0
        try:
            main(arguments)
        except SystemExit as ended:
            status = ended.code or 0
        assert status == expected
        return capsys.readouterr()

    return call


@pytest.fixture
def refusal(in_an_empty_folder, capsys):
    """Call the command line and return its one line; what was in the folder must be all that is there."""

    def call(*arguments):
        before = everything_in(in_an_empty_folder)
        with pytest.raises(SystemExit) as caught:
            main(arguments)
        output = capsys.readouterr()
        assert caught.value.code == 1
        assert output.out == ""
        assert output.err.startswith("forficula: ")
        assert output.err.count("\n") == 1
        assert everything_in(in_an_empty_folder) == before
        return output.err.removeprefix("forficula: ").removesuffix("\n")

    return call


def test_a_bad_value_ends_the_process_with_1_and_one_line(in_an_empty_folder):
    done = process("-m", "forficula", "run", "binder2025", "--set", "tendon.stiffness=10 N", "--out", "result")
    message = '"N" is not a unit of the right kind; write it such as "10 N/cm", got "10 N"'
    assert (done.returncode, done.stdout, done.stderr) == (1, "", f"forficula: tendon.stiffness: {message}\n")
    assert everything_in(in_an_empty_folder) == []


def test_a_run_leaves_its_files_and_names_their_folder_last(in_an_empty_folder):
    (in_an_empty_folder / "my-wing.toml").write_text(SHORT)
    done = process("-m", "forficula", "run", "my-wing.toml", "--set", "tendon.stiffness=20 N/cm")
    assert done.returncode == 0
    assert "Traceback" not in done.stderr
    assert done.stdout.startswith("my-wing: settled\n")
    assert done.stdout.splitlines()[-1] == "written to out/my-wing; open out/my-wing/report.html"
    folder = in_an_empty_folder / "out" / "my-wing"
    assert {"design.toml", "model.xml", "record.nc", "summary.json", "report.html"} < set(everything_in(folder))
    assert json.loads((folder / "summary.json").read_text())["status"] == "settled"
    assert ff.load_design(folder / "design.toml").tendon.stiffness == 2000.0

    # to the last bit, which netCDF keeps
    again = ff.run(ff.load_design(folder / "design.toml"), confirm=False)
    assert again.data.equals(ff.load_run(folder / "record.nc").data)


@pytest.mark.usefixtures("no_figures")
def test_a_run_of_a_wing_that_blows_up_is_carried_out(in_an_empty_folder, call):
    (in_an_empty_folder / "wild.toml").write_text(SHORT.replace('"10 ms"', '"1 s"'))
    output = call("run", "wild.toml", "--set", "protocol.timestep=10 ms", "--out", "there", expected=3)
    assert output.out.startswith("wild: diverged at t = ")
    assert "warning: a timestep of 10 ms is too long" in output.err
    assert json.loads((in_an_empty_folder / "there" / "summary.json").read_text())["folded"] is None
    call("run", "wild.toml", "--set", "protocol.timestep=10 ms", "--out", "there", "--tolerate")


def test_a_landscape_leaves_its_files_and_names_their_folder_last(in_an_empty_folder, call):
    (in_an_empty_folder / "my-wing.toml").write_text(SHORT)
    output = call("landscape", "my-wing.toml", "--set", "tendon.rest_length=0 cm")
    assert output.out.startswith("my-wing: bistable (flat, folded); barrier ")
    assert "The simulated wing: settled." in output.out
    assert output.out.splitlines()[-1] == "written to out/my-wing-landscape; open out/my-wing-landscape/report.html"
    folder = in_an_empty_folder / "out" / "my-wing-landscape"
    figures = [name for kind in ("levels", "tendon", "wing") for name in figure_files(kind)]
    assert everything_in(folder) == sorted(["design.toml", "figures", "landscape.json", "report.html", *figures])
    content = json.loads((folder / "landscape.json").read_text())
    assert content["simulation"]["status"] == "settled"
    # three independent hinges of 10 N/cm and no resting length: about 6 J each
    # (docs/model/theory.md, section "Values from the paper")
    assert content["levels_J"] == pytest.approx([18, 12, 6, 0], abs=0.2)


def test_a_landscape_needs_no_simulation_and_one_of_plates_leaves_what_there_is(in_an_empty_folder, call):
    output = call("landscape", "letter-fold", "--no-simulation", "--out", "there")
    assert output.out.startswith("letter-fold: bistable (flat, closed); barrier ")
    assert "simulated" not in output.out + output.err
    figures = [name for kind in ("levels", "rests", "tendon") for name in figure_files(kind)]
    result = everything_in(in_an_empty_folder / "there")
    assert result == sorted(["design.toml", "figures", "landscape.json", "report.html", *figures])
    content = json.loads((in_an_empty_folder / "there" / "landscape.json").read_text())
    assert content["simulation"] is None
    assert ff.load_design(in_an_empty_folder / "there" / "design.toml").hash == ff.load_design("letter-fold").hash


def test_a_pattern_is_written_by_the_ending_of_its_file(in_an_empty_folder, call):
    fold = call("pattern", "binder2025", "--set", "pattern.units=2", "--out", "deep/fan.fold")
    svg = call("pattern", "binder2025", "--out", "fan.svg")
    assert (fold.out, svg.out) == ("written to deep/fan.fold\n", "written to fan.svg\n")
    assert json.loads((in_an_empty_folder / "deep" / "fan.fold").read_text())["file_spec"] == 1.2
    assert "<svg" in (in_an_empty_folder / "fan.svg").read_text()


def test_a_new_design_file_can_be_run(call):
    assert call("new", "my-wing.toml").out == "written to my-wing.toml; run it with: forficula run my-wing.toml\n"
    assert ff.load_design("my-wing.toml").hash == ff.load_design("binder2025").hash


def test_a_scaled_design_is_printed_as_one_and_the_groups_that_it_cannot_keep_beside_it(in_an_empty_folder, call):
    printed = call("scale", "binder2025", "--length", "1/10", "--set", "protocol.gravity=9.81 m/s^2")
    (in_an_empty_folder / "small.toml").write_text(printed.out)
    small = ff.load_design("small.toml")
    assert small.pattern.distal_length == pytest.approx(0.01, rel=1e-15)
    assert small.protocol.gravity == 9.81
    first, *output = printed.err.splitlines()
    assert first == (
        "3 of 18 dimensionless groups of binder2025-x0.1 change, because gravity and materials are not scaled:"
    )
    assert [line.partition(" (")[0] for line in output] == [
        "  gravity: 0.000386 -> 3.86e-05",
        "  Reynolds number, left out: 1.69e+05 -> 1.69e+04",
        "  relaxation of the membrane: 0.603 -> 6.03",
    ]


def test_a_scaled_design_is_written_and_can_be_run(in_an_empty_folder, call):
    (in_an_empty_folder / "wing.toml").write_text(SHORT)
    assert "small.toml" in call("scale", "wing.toml", "--length", "0.5", "--out", "small.toml").out
    call("run", "small.toml", "--out", "out/small")
    same = call("scale", "miura-sheet", "--length", "1").err
    assert same == "miura-sheet-x1 keeps all 9 dimensionless groups: over t / t* it moves identically\n"


def test_the_named_designs_are_listed_with_their_sources(call):
    lines = call("designs").out.splitlines()
    names = [line for line in lines if not line.startswith(" ")]
    assert names == [
        "binder2025",
        "binder2025-built",
        "binder2025-coupled",
        "binder2025-joint",
        "binder2025-on-table",
        "binder2025-stored",
        "binder2025-thick",
        "binder2025-upright",
        "bistable-clasp",
        "bistable-miura",
        "earwig-hindwing",
        "earwig-midwing",
        "force-clasp",
        "four-plate-snap",
        "graded-fan",
        "kresling-cell",
        "letter-fold",
        "miura-sheet",
        "thick-miura",
        "two-clasps",
        "waterbomb-base",
    ]
    assert "10.3390/biomimetics11010009" in lines[1]
    # what one would look at it for, and where its values come from
    assert len(lines) == 3 * len(names)


def test_a_pattern_is_described_where_no_file_is_to_be_written(call):
    fan = call("pattern", "binder2025").out.splitlines()
    assert fan[0] == "earwig fan, 1 unit, 3 veins: 9 vertices, 4 facets, 22.35 cm by 15.06 cm"
    assert "Every vertex folds flat by itself; whether layers collide is not checked." in fan
    text = " ".join(" ".join(fan).split())
    assert "Folded flat without thickness, it has an outline of 4" in text
    assert "and up to 4 layers." in text
    freedoms = [line.split()[-2:] for line in fan if line.startswith("rigid facets")]
    assert freedoms == [["2", "1"], ["1", "0"]]
    call("pattern", "binder2025", "--out", "fan.fold")
    # residuals of a file's digits may differ from those of the design's
    assert call("pattern", "fan.fold").out.splitlines()[:3] == fan[:3]
    strip = call("pattern", "letter-fold").out
    assert "No interior vertex: every crease folds independently.\n" in strip


def test_a_file_without_a_unit_has_the_unit_of_the_option_or_a_chosen_size(in_an_empty_folder, call, refusal):
    call("pattern", "letter-fold", "--out", "sheet.fold")
    document = json.loads((in_an_empty_folder / "sheet.fold").read_text())
    (in_an_empty_folder / "sheet.fold").write_text(json.dumps(document | {"frame_unit": "unit"}))
    assert "0.297 mm by 0.21 mm" in call("pattern", "sheet.fold", "--unit", "1 mm").out
    without = call("pattern", "sheet.fold")
    assert "20 cm by 14.14 cm" in without.out
    assert without.err.startswith("warning: sheet.fold: the file states no unit of length: its largest dimension is")
    assert "[chosen]" in without.err
    assert "--unit" in without.err
    assert refusal("pattern", "sheet.fold", "--unit", "0 mm") == '--unit: need > 0, got "0 mm"'
    said = '--unit: a design already has units, got "1 mm"'
    assert refusal("pattern", "letter-fold", "--unit", "1 mm") == said


@pytest.mark.parametrize("ending", [".png", ".pdf"])
def test_a_picture_of_a_pattern_is_written_by_the_ending_of_its_file(in_an_empty_folder, call, ending):
    assert call("pattern", "binder2025", "--out", f"fan{ending}").out == f"written to fan{ending}\n"
    start = (in_an_empty_folder / f"fan{ending}").read_bytes()[:5]
    assert start.startswith(b"\x89PNG" if ending == ".png" else b"%PDF-")


def test_a_fold_file_is_drawn_and_has_no_values_to_set(call, refusal):
    call("pattern", "letter-fold", "--out", "sheet.fold")
    assert call("pattern", "sheet.fold", "--out", "sheet.svg").out == "written to sheet.svg\n"
    message = "--set: a FOLD file has no values to replace, got pattern.panels=4"
    assert refusal("pattern", "sheet.fold", "--set", "pattern.panels=4") == message


def test_a_new_design_file_of_each_kind_describes_itself(call, refusal):
    call("new", "wing.toml")
    call("new", "letter.toml", "--kind", "pleats")
    assert "earwig fan" in call("pattern", "wing.toml").out
    assert "strip of 3 panels" in call("pattern", "letter.toml").out
    call("pattern", "letter-fold", "--out", "sheet.fold")
    call("new", "sheet.toml", "--kind", "fold-file")
    assert "strip of 3 panels" in call("pattern", "sheet.toml").out
    kinds = "earwig-fan, joint, miura-ori, waterbomb, yoshimura, kresling, pleats, vertex, fold-file"
    said = f'kind: need one of {kinds}, got "pleat"; did you mean "pleats"?'
    assert refusal("new", "other.toml", "--kind", "pleat") == said


def test_keys_and_named_studies_are_listed(call, refusal):
    said = call("keys", "coupling").out
    assert "[coupling]" in said
    assert said.splitlines()[-1].endswith("docs/glossary.md")
    assert 'N m/rad, >= 0 or "rigid"' in " ".join(said.split())
    assert "fold_angle" not in said
    assert "sampling" in call("keys", "--study").out
    assert "[crease]" in call("keys", "crease", "--kind", "vertex").out
    assert "[joint.0]" in call("keys", "joint", "--kind", "assembly").out
    assert refusal("keys", "tendn") == "tendn: unknown key; did you mean tendon?"
    assert "intervals_of" in call("keys", "tolerances", "--goal").out
    said = "keys: need one of --study, --goal and --observations, got several"
    assert refusal("keys", "--goal", "--study") == said
    listed = call("studies").out
    assert "60 points of binder2025 over tendon.stiffness and tendon.rest_length" in listed
    assert "a goal: least mass of binder2025 over vein.diameter" in listed


@pytest.mark.parametrize(
    ("kind", "ending", "next_command"),
    [
        ("design", "toml", "forficula run new.toml"),
        ("study", "toml", "forficula study new.toml"),
        ("goal", "toml", "forficula optimise new.toml"),
        ("observations", "toml", "forficula identify new.toml"),
        ("tests", "csv", "forficula material new-made-up-1.csv new-made-up-2.csv new-made-up-3.csv"),
    ],
)
def test_a_new_file_names_the_command_that_takes_it(call, kind, ending, next_command):
    said = call("new", kind, f"new.{ending}").out
    assert next_command in said


def test_a_new_study_runs_as_it_is(call):
    call("new", "study", "new.toml")
    assert "3 points, at most 3 runs" in call("study", "new.toml", "--dry-run").out


def test_a_new_goal_is_a_goal_as_it_is(call):
    call("new", "goal", "new.toml", "--kind", "pleats")
    assert load_goal("new.toml").base.name == "letter-fold"


def test_new_observations_are_observations_as_they_are(call):
    call("new", "observations", "new.toml")
    assert "new: 384 samples" in call("identify", "new.toml", "--dry-run").out


@pytest.mark.parametrize("kind", ["study", "goal", "observations", "tests"])
def test_a_switch_of_earlier_versions_writes_the_same_file_and_warns(in_an_empty_folder, call, kind):
    ending = "csv" if kind == "tests" else "toml"
    call("new", kind, f"new.{ending}")
    written = call("new", f"old.{ending}", f"--{kind}")
    assert f"warning: --{kind} will be removed; use: forficula new {kind} old.{ending}" in written.err
    old, new = (sorted(in_an_empty_folder.glob(f"{name}*")) for name in ("old", "new"))
    assert [path.read_bytes() for path in old] == [path.read_bytes() for path in new]


def test_a_misspelt_kind_of_new_file_is_refused_with_the_nearest(refusal):
    said = 'new: need "design", "study", "goal", "observations" or "tests", got "stduy"; did you mean "study"?'
    assert refusal("new", "stduy", "new.toml") == said


def test_switches_of_earlier_versions_exclude_each_other(refusal):
    said = "new: need one of design, study, goal, observations or tests, got --goal and --tests"
    assert refusal("new", "other.toml", "--goal", "--tests") == said
    assert refusal("new", "other.csv", "--tests", "--kind", "pleats").startswith("--tests: cannot be used with --kind")


def test_json_is_the_only_standard_output(in_an_empty_folder, call, refusal):
    (in_an_empty_folder / "wing.toml").write_text(SHORT)
    ran = call("run", "wing.toml", "--out", "there", "--json")
    assert json.loads(ran.out) == json.loads((in_an_empty_folder / "there" / "summary.json").read_text())
    # flags of the whole may stand before the command, too
    surveyed = call("--json", "landscape", "binder2025-joint", "--no-simulation", "--out", "energy").out
    assert json.loads(surveyed) == json.loads((in_an_empty_folder / "energy" / "landscape.json").read_text())
    assert [load["name"] for load in json.loads(call("designs", "--json").out)] == list(ff.examples())
    assert {"key", "meaning", "allowed", "default"} == set(json.loads(call("keys", "guard", "--json").out)[0])
    points = {load["name"]: load.get("points") for load in json.loads(call("studies", "--json").out)}
    assert points["binder2025-search"] == 60
    sizes = json.loads(call("size", "binder2025", "--material", "tpu-82a", "--stiffness", "10 N/cm", "--json").out)
    assert [row["length_m"] for row in sizes] == [0.06, 0.09]
    assert json.loads(call("materials", "--json").out)[0].keys() == {"name", "source", "for"}
    assert refusal("new", "other.toml", "--json").startswith("--json: need run, landscape, converge, ")


def test_a_study_as_json_has_a_row_for_every_point(in_an_empty_folder, call, study_file):
    study_file(TENDONS)
    rows = json.loads(call("study", "small.toml", "--keep", "0", "--out", "there", "--json").out)
    with (in_an_empty_folder / "there" / "table.csv").open(newline="") as file:
        written = list(csv.DictReader(file))
    assert [list(row) for row in rows] == [list(row) for row in written]
    for row, texts in zip(rows, written, strict=True):
        for value, text in zip(row.values(), texts.values(), strict=True):
            if isinstance(value, float):
                assert float(text) == value
            else:
                assert text == {None: "", True: "true", False: "false"}.get(value, str(value))


def test_the_shell_can_complete_commands_and_options(in_an_empty_folder, call):
    call("--install-completion", "--shell", "bash", "--output", "completion.sh")
    script = (in_an_empty_folder / "completion.sh").read_text()
    assert "landscape" in script
    assert "--no-simulation" in script
    assert "--json" in script


def test_quiet_leaves_out_all_but_warnings(in_an_empty_folder, call):
    (in_an_empty_folder / "wing.toml").write_text(SHORT)
    call("run", "wing.toml", "--no-confirm", "--out", "there", "--quiet")
    said = call("run", "wing.toml", "--no-confirm", "--out", "there", "--quiet")
    assert said.out == ""
    assert all(line.startswith("warning: ") for line in said.err.splitlines())
    assert (in_an_empty_folder / "there" / "report.html").is_file()


def test_a_verdict_that_is_wanted_ends_with_0_and_no_other(in_an_empty_folder, call, refusal):
    fold = '[[protocol.stages]]\nname = "fold"\ndrive = "fold"\nuntil = "folded"\ntime_limit = "10 ms"\n'
    (in_an_empty_folder / "late.toml").write_text(SHORT + fold)
    call("run", "late.toml", "--no-confirm", expected=2)
    call("run", "late.toml", "--no-confirm", "--ok-if", "stuck", "--ok-if", "moving")
    (in_an_empty_folder / "wing.toml").write_text(SHORT)
    call("run", "wing.toml", "--no-confirm", "--ok-if", "moving", expected=2)
    assert refusal("run", "wing.toml", "--ok-if", "stuk").endswith('got "stuk"; did you mean "stuck"?')


def test_help_names_every_command(call):
    shown = call("--help").out
    for command in (
        *("run", "pattern", "landscape", "converge", "assumptions", "study", "new", "scale", "designs"),
        *("material", "materials", "size", "studies", "keys"),
    ):
        assert f" {command} " in shown


def test_settings_are_values_as_in_a_file_or_bare_text(in_an_empty_folder, call):
    settings = {
        "tendon.stiffness": ("20 N/cm", 2000.0),
        "tendon.rest_length": ('"7 cm"', 0.07),
        "membrane.poisson_ratio": ("0.2", 0.2),
        "membrane.distal_rows": ("[0.5]", (0.5,)),
        "protocol.contact": ("true", True),
        "protocol.timestep": ("auto", "auto"),
        "protocol.window": ("5 ms", 5e-3),
    }
    (in_an_empty_folder / "wing.toml").write_text(SHORT)
    chosen = [part for key, (text, _) in settings.items() for part in ("--set", f"{key}={text}")]
    by_place = ("--set", "name=other wing", "--set", "protocol.stages.0.hold=1 ms")
    call("run", "wing.toml", "--no-confirm", "--out", "a", *by_place, *chosen)
    design = ff.load_run(in_an_empty_folder / "a" / "record.nc").design
    assert design.name == "other wing"
    assert design.protocol.stages[0].hold == 1e-3
    tables = design.model_dump()
    for key, (_, value) in settings.items():
        section, name = key.split(".")
        if value != "auto":  # the file has what was chosen
            assert tables[section][name] == value


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ["run", "bindr2025"],
            '"bindr2025" is neither a named design nor a .toml, .fold, .svg or .dxf file; did you mean "binder2025"?',
        ),
        (["run", "none.toml"], "none.toml: no such file"),
        (["run", "folder.toml"], "folder.toml: cannot be read: Is a directory"),
        (["run", "bad.toml"], "bad.toml: not TOML: Invalid value (at line 1, column 5)"),
        (["run", "latin.toml"], "latin.toml: not UTF-8 text from byte 11 on; save it as UTF-8"),
        (
            ["run", "binder2025", "--set", "tendon.stifness=10 N/cm"],
            'tendon.stifness: unknown key, got "10 N/cm"; did you mean tendon.stiffness?',
        ),
        (
            ["run", "binder2025", "--set", "tendon.stiffness"],
            '--set: need KEY=VALUE such as tendon.stiffness="20 N/cm", got "tendon.stiffness"',
        ),
        (
            ["run", "binder2025", "--set", "tendon.stiffness=10"],
            'tendon.stiffness: the unit is missing; write it as text such as "10 N/cm", got 10',
        ),
        (
            ["run", "binder2025", "--set", "tendon.rest_length=-3 cm"],
            "tendon.rest_length: need >= 0, got -3 cm",
        ),
        (
            ["run", "binder2025", "--set", "tendon.rest_length=inf"],
            'tendon.rest_length: need a finite number with a unit such as "12 cm", got inf',
        ),
        (
            ["pattern", "binder2025", "--set", "pattern.units=1.5", "--out", "a.svg"],
            "pattern.units: need a whole number, got 1.5",
        ),
        (
            ["pattern", "binder2025", "--set", "pattern.units=true", "--out", "a.svg"],
            "pattern.units: need a whole number, got true",
        ),
        (["run", "binder2025", "--out", "bad.toml"], "--out: need a folder, got the file bad.toml"),
        (["landscape", "binder2025", "--out", "bad.toml"], "--out: need a folder, got the file bad.toml"),
        (
            ["landscape", "bindr2025"],
            '"bindr2025" is neither a named design nor a .toml, .fold, .svg or .dxf file; did you mean "binder2025"?',
        ),
        (["run", "binder2025", "--out", "bad.toml/a/b"], "--out: need a folder, got the file bad.toml"),
        (
            ["pattern", "binder2025", "--out", "a.txt"],
            "--out: need a file that ends with .fold, .svg, .png or .pdf, got a.txt",
        ),
        (
            ["pattern", "binder2025", "--out", "bad.toml/a.svg"],
            "bad.toml/a.svg: cannot be written: bad.toml is a file, not a folder",
        ),
        (["new", "bad.toml"], "bad.toml: exists already; choose another name or remove it"),
        (["new", "wing"], "wing: need a name that ends with .toml"),
        (
            ["scale", "binder2025", "--length", "1/0"],
            '--length: need a number > 0 such as 1/10, 0.1 or 10, got "1/0"',
        ),
        (
            ["scale", "binder2025", "--length", "5 cm"],
            '--length: need a number > 0 such as 1/10, 0.1 or 10, got "5 cm"',
        ),
        (["scale", "binder2025", "--length", "1e-12"], "--length: need >= 1e-09 and <= 1e+09, got 1e-12"),
        (
            ["scale", "bindr2025", "--length", "2"],
            '"bindr2025" is neither a named design nor a .toml, .fold, .svg or .dxf file; did you mean "binder2025"?',
        ),
        (
            ["scale", "binder2025", "--length", "2", "--out", "bad.toml"],
            "--out: bad.toml: exists already; choose another name or remove it",
        ),
        (
            ["scale", "binder2025", "--length", "2", "--out", "small"],
            "--out: small: need a name that ends with .toml",
        ),
    ],
)
def test_bad_input_is_refused_in_one_line_and_nothing_is_written(refusal, in_an_empty_folder, arguments, message):
    (in_an_empty_folder / "bad.toml").write_text("x = ?")
    (in_an_empty_folder / "latin.toml").write_bytes('source = "Käfer"'.encode("latin-1"))
    (in_an_empty_folder / "folder.toml").mkdir()
    assert refusal(*arguments) == message


@pytest.mark.parametrize(
    ("setting", "named"),
    [
        ("pattern.units=9", "pattern.units"),
        ("vein.diameter=6 cm", "vein.diameter"),
        ("membrane.margin=5 cm", "membrane.margin"),
        ("tendon.distal_attachment=13 cm", "tendon.distal_attachment"),
        ("protocol.initial_overbend=4 deg", "protocol.initial_overbend"),
    ],
)
def test_values_that_do_not_fit_each_other_are_answered_with_the_design_and_the_key(refusal, setting, named):
    assert refusal("run", "binder2025", "--set", setting).startswith(f"binder2025: {named}: ")


@pytest.mark.parametrize(
    ("arguments", "named"),
    [
        (["run"], "DESIGN"),
        (["run", "binder2025", "--bogus"], "--bogus"),
        (["run", "binder2025", "extra"], "extra"),
        (["pattern"], "DESIGN"),
        (["frobnicate"], "frobnicate"),
        (["new"], "FILE"),
    ],
)
def test_a_wrong_command_is_answered_with_the_word_that_is_wrong(refusal, arguments, named):
    assert named in refusal(*arguments)


@pytest.mark.parametrize("value", [f"1{'0' * 5000}", "[" * 20_000, f'"10 N/cm{"**9" * 9}"', "N" * 100_000])
def test_a_hostile_setting_is_answered_in_one_line(refusal, value):
    assert refusal("run", "binder2025", "--set", f"tendon.stiffness={value}").startswith("tendon.stiffness: ")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["run", "binder2025", "x"], 'need no more arguments, got "x"'),
        (["run", "binder2025", "--out", "-x"], 'Write a value that begins with a hyphen as --out="-x"'),
        (["size", "tpu-82a", "--material", "-1 MPa"], 'Write a value that begins with a hyphen as --material="-1 MPa"'),
        (["run", "binder2025", "--out"], 'Command "run" parameter --out requires an argument.'),
        (["run", "binder2025", "--out", "--json"], 'Command "run" parameter --out requires an argument.'),
        (["run", "mine.toml"], 'mine.toml: design: unknown key, got "mine.toml"; allowed here: based_on, name,'),
        (["pattern", f"{'x' * 5000}.toml"], f"{'x' * 150}...{'x' * 14}.toml: cannot be read"),
        (["pattern", f"{'x' * 5000}.svg"], f"{'x' * 150}...{'x' * 15}.svg: cannot be read"),
    ],
)
def test_errors_of_the_command_line_are_one_short_line(refusal, in_an_empty_folder, arguments, message):
    (in_an_empty_folder / "mine.toml").write_text('design = "mine.toml"')
    answered = refusal(*arguments)
    assert message in answered
    assert len(answered) < 400


def test_too_long_file_names_are_refused_before_anything_runs(refusal):
    assert "File name too long" in refusal("run", "binder2025", "--out", "x" * 300)
    assert "File name too long" in refusal("new", "x" * 300 + ".toml")
    assert "File name too long" in refusal("pattern", "binder2025", "--out", "x" * 300 + ".svg")


@pytest.mark.parametrize(
    "arguments",
    [
        ["run", "binder2025"],
        ["pattern", "binder2025"],
        ["landscape", "binder2025"],
        ["converge", "binder2025", "--meshes", "1 2"],
        ["compare", "a", "b"],
        ["study", "binder2025-search"],
        ["study", "binder2025-search", "--slurm", "3"],
        ["material", "a.csv"],
        ["size", "binder2025", "--material", "resilin", "--stiffness", "10 N/cm"],
        ["figure", "a", "--kind", "energy"],
        ["film", "a"],
    ],
)
def test_a_name_without_letters_is_no_place_for_results(refusal, arguments):
    said = "Invalid value for --out: need the name of a file or a folder, got an empty text"
    assert refusal(*arguments, "--out", "") == said
    assert refusal(*arguments, "--out=") == said


def test_a_run_says_which_run_it_replaces(in_an_empty_folder, call):
    (in_an_empty_folder / "wing.toml").write_text(SHORT)
    said = 'there: replaces the run of wing ("settled")\n'
    assert "replaces" not in call("run", "wing.toml", "--no-confirm", "--out", "there").err
    assert call("run", "wing.toml", "--no-confirm", "--out", "there").err.startswith(said)
    (in_an_empty_folder / "there" / "summary.json").write_text('{"design": "a\\u001b[2J\\nb", "status": ' + "[" * 10**5)
    again = call("run", "wing.toml", "--no-confirm", "--out", "there")
    assert "there: replaces the run of an unknown name\n" in again.err


def test_a_landscape_a_convergence_study_and_a_study_say_what_they_replace(in_an_empty_folder, call, study_file):
    (in_an_empty_folder / "wing.toml").write_text(SHORT)
    study_file(TENDONS)
    for out, arguments, said in (
        (
            "a",
            ("landscape", "binder2025-joint", "--no-simulation"),
            "a: replaces the landscape of binder2025-joint\n",
        ),
        ("b", ("converge", "wing.toml", "--timesteps", "0.5 0.2 ms"), "b: replaces the convergence study of wing ("),
        (
            "c",
            ("study", "small.toml", "--keep", "0"),
            "c: replaces the table, the maps and the page; the rows are kept\n",
        ),
    ):
        assert "replaces" not in call(*arguments, "--out", out).err
        assert said in call(*arguments, "--out", out).err


def test_figures_of_a_run_are_png_and_others_where_they_are_wanted(in_an_empty_folder, call):
    ff.save_design(flap({"protocol.stages.0.until": "creases > 5 deg"}), in_an_empty_folder / "flap.toml")

    def endings(*options):
        call("run", "flap.toml", "--no-confirm", *options)
        folder = in_an_empty_folder / "out" / "flap"
        return {path.suffix for path in folder.rglob("*") if path.stem == "angles"}

    assert endings() == {".png"}
    assert endings("--figures", "svg,PDF") == {".png", ".svg", ".pdf"}
    # what an earlier run left would show another result
    assert endings("--figures", "svg") == {".png", ".svg"}
    assert endings() == {".png"}


@pytest.mark.parametrize("wrong", ["jpg", "svg;pdf", "", "svg,,pdf"])
def test_unknown_formats_of_figures_are_refused_before_anything_runs(refusal, wrong):
    message = refusal("run", "binder2025", "--figures", wrong)
    assert message == f'--figures: need one or more of png, svg, pdf, with commas, got "{wrong}"'


def test_assumptions_leave_a_table_that_a_run_of_the_same_design_then_names(in_an_empty_folder, call):
    quick = flap({"protocol.stages.0.until": "creases > 5 deg"})
    ff.save_design(quick, in_an_empty_folder / "flap.toml")
    done = call("assumptions", "flap.toml")
    assert "twice the damping of hinges" in done.out
    assert done.out.endswith("written to out/flap-assumptions; open out/flap-assumptions/report.html\n")
    output = call("run", "flap.toml", "--no-confirm").out
    assert "\nAssumptions: none of 9 changed assumptions changes the verdict (out/flap-assumptions).\n" in output


def test_a_run_that_was_killed_while_it_was_replaced_is_restored(in_an_empty_folder, call):
    (in_an_empty_folder / "wing.toml").write_text(SHORT)
    call("run", "wing.toml", "--no-confirm", "--out", "killed/there")

    def files(place):
        folder = in_an_empty_folder / place / "there"
        return {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*") if path.is_file()}

    before = files("killed")
    changed = ("wing.toml", "--set", "tendon.stiffness=20 N/cm", "--out", "killed/there")
    done = process("-c", DYING, "run", *changed)
    assert done.returncode == -signal.SIGKILL
    assert not (in_an_empty_folder / "killed" / "there" / "record.nc").exists()
    for place in ("filmed", "run"):
        shutil.copytree(in_an_empty_folder / "killed", in_an_empty_folder / place)
    call("film", "filmed/there", "--fps", "1", "--out", "a.gif")
    # refused, but what is there is restored first
    with pytest.raises(SystemExit):
        main(["run", "wing.toml", "--out", "run/there", "--cycles", "0"])
    assert files("filmed") == files("run") == before


TENDONS = '"tendon.stiffness" = ["10 N/cm", "20 N/cm", "30 N/cm"]'


def rows_in(journal):
    """The lines of a journal that are rows."""
    return [line for line in journal.read_bytes().splitlines() if line.startswith(b'{"key"')]


def test_a_study_leaves_its_table_and_names_their_folder_last(in_an_empty_folder, call, study_file):
    study_file(TENDONS)
    output = call("study", "small.toml")
    assert output.out.splitlines()[-1] == "written to out/small; open out/small/report.html"
    folder = in_an_empty_folder / "out" / "small"
    assert {"journal.jsonl", "table.csv", "table.nc"} < set(everything_in(folder))
    assert len((folder / "table.csv").read_text().splitlines()) == 4
    before = rows_in(folder / "journal.jsonl")
    call("study", "small.toml")
    assert rows_in(folder / "journal.jsonl") == before


def test_a_study_stores_the_requested_number_of_runs_for_playback(in_an_empty_folder, call, study_file):
    study_file(TENDONS)
    folder = in_an_empty_folder / "out" / "small"
    output = call("study", "small.toml", "--keep", "1")
    assert "storing 1 run for playback" in output.err
    assert [place.name for place in (folder / "runs").iterdir()] == ["1"]
    assert everything_in(folder / "runs" / "1") == ["design.toml", "record.nc", "summary.json"]
    with_a_run = (folder / "report.html").stat().st_size
    output = call("study", "small.toml", "--keep", "0")
    assert "keeping" not in output.err
    assert not (folder / "runs").exists()
    assert (folder / "report.html").stat().st_size < with_a_run - 50_000


def test_a_wrong_number_of_runs_is_refused_before_the_study(refusal, in_an_empty_folder, study_file):
    study_file(TENDONS)
    message = refusal("study", "small.toml", "--keep", "-1")
    assert message == "--keep: need a whole number of points >= 0, got -1"
    assert everything_in(in_an_empty_folder) == ["small.toml"]


def test_a_dry_run_counts_the_runs_and_writes_nothing(in_an_empty_folder, call, study_file):
    study_file(TENDONS)
    # how long, the machine decides
    assert call("study", "small.toml", "--dry-run").out.startswith("small: 3 points, at most 3 runs; 3 to do, about ")
    assert everything_in(in_an_empty_folder) == ["small.toml"]


def test_a_shard_says_how_to_collect_and_collecting_gives_the_same_table(in_an_empty_folder, call, study_file):
    study_file(TENDONS)
    output = call("study", "small.toml", "--shard", "1/2", "--out", "there")
    assert output.out == "shard 1/2 is done; when all are: forficula study small.toml --out there --collect\n"
    assert everything_in(in_an_empty_folder / "there") == ["journal-1-of-2.jsonl"]
    call("study", "small.toml", "--shard", "2/2", "--out", "there", "--keep", "0")
    table = (in_an_empty_folder / "there" / "table.csv").read_bytes()
    (in_an_empty_folder / "there" / "table.csv").unlink()
    call("study", "small.toml", "--out", "there", "--collect", "--keep", "0")
    assert (in_an_empty_folder / "there" / "table.csv").read_bytes() == table


def test_missing_shards_are_counted_in_one_line(capsys, call, study_file):
    study_file(TENDONS)
    call("study", "small.toml", "--shard", "2/3", "--out", "there")
    with pytest.raises(SystemExit) as caught:
        main(["study", "small.toml", "--out", "there", "--collect"])
    assert caught.value.code == 1
    expected = "forficula: there: 2 runs are missing; run the remaining shards, then collect\n"
    assert capsys.readouterr() == ("", expected)


def test_a_job_array_is_written_and_nothing_is_run(in_an_empty_folder, call, study_file):
    study_file(TENDONS)
    output = call("study", "small.toml", "--slurm", "4")
    assert output.out == "written to out/small/study.slurm; submit it with: sbatch out/small/study.slurm\n"
    assert everything_in(in_an_empty_folder / "out" / "small") == ["study.slurm"]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["none.toml"], "none.toml: no such file"),
        (
            ["none"],
            '"none" is neither a named study nor a .toml file; the named studies are binder2025-boundary,'
            " binder2025-choices, binder2025-coupling, binder2025-offsets, binder2025-redundancy, binder2025-room,"
            " binder2025-search, binder2025-storage, earwig-hindwing-gust, earwig-hindwing-orders,"
            " earwig-hindwing-pulse, earwig-hindwing-redundancy, earwig-midwing-sectors",
        ),
        (["small.toml", "--shard", "3/2"], '--shard: need a number and a count such as 2/8, got "3/2"'),
        (["small.toml", "--shard", "0/2"], '--shard: need a number and a count such as 2/8, got "0/2"'),
        (["small.toml", "--shard", "one"], '--shard: need a number and a count such as 2/8, got "one"'),
        (["small.toml", "--slurm", "0"], "--slurm: need a number of jobs from 1 to 10000, got 0"),
        (["small.toml", "--out", "small.toml"], "--out: need a folder, got the file small.toml"),
        (
            ["small.toml", "--slurm", "2", "--collect"],
            "--slurm: cannot be used with --collect; leave one of them out",
        ),
        (
            ["small.toml", "--slurm", "2", "--shard", "1/2"],
            "--slurm: cannot be used with --shard; leave one of them out",
        ),
        (
            ["small.toml", "--collect", "--shard", "1/2"],
            "--collect: cannot be used with --shard; leave one of them out",
        ),
        (
            ["small.toml", "--dry-run", "--keep", "3", "--no-engine"],
            "--dry-run: cannot be used with --keep and --no-engine; leave one of them out",
        ),
    ],
)
def test_an_impossible_study_is_refused_in_one_line(refusal, study_file, arguments, message):
    study_file(TENDONS)
    assert refusal("study", *arguments) == message


@pytest.mark.skipif(signal.getsignal(signal.SIGINT) == signal.SIG_IGN, reason="a job in the background ignores it")
def test_ctrl_c_stops_a_run_with_one_line_and_leaves_nothing(tmp_path):
    slow = [sys.executable, "-m", "forficula", "run", "binder2025", "--set", 'protocol.timestep="0.002 ms"']
    process = subprocess.Popen(slow, cwd=tmp_path, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    assert process.stderr is not None
    while not process.stderr.readline().startswith("settle"):
        assert process.poll() is None
    process.send_signal(signal.SIGINT)
    output, errors = process.communicate(timeout=120)
    assert process.returncode == 130
    assert errors.splitlines()[-1] == "forficula: stopped"
    assert "Traceback" not in errors
    assert output == ""
    assert list(tmp_path.iterdir()) == []


def test_a_landscape_over_two_keys_is_a_map_beside_a_study(tmp_path, write_study_file, call):
    study = write_study_file(
        tmp_path / "small.toml",
        '"tendon.rest_length" = ["0 cm", "9 cm"]',
        head='ask = "least-torques"',
        tail='[search]\nfold_torques = ["50 N cm"]\nunfold_torques = ["100 N cm"]',
    )
    call("study", str(study), "--keep", "0", "--out", str(tmp_path / "study"))
    ff.save_design(ff.load_study(study).base, tmp_path / "base.toml")
    over = ["--over", 'tendon.rest_length=["0 cm", "9 cm"]']
    options = ["--no-simulation", "--simulated", str(tmp_path / "study"), "--out", str(tmp_path / "map")]
    result = call("landscape", str(tmp_path / "base.toml"), *over, *options)
    assert "1 of 2 wings fold under slowly growing torques" in result.out
    assert {"map.csv", "map.nc", "map.png", "landscape.json"} <= {path.name for path in (tmp_path / "map").iterdir()}
    section = (tmp_path / "map" / "report.html").read_text("utf-8").partition('<section id="map">')[2]
    assert "<p>1 of 2 wings fold under slowly growing torques" in section


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--simulated", "nowhere"], "--simulated: needs --over"),
        (["--over", "tendon.rest_length"], "--over: need KEY=VALUE"),
        (["--over", "tendon.rest_lenght=1..2 cm step 1"], "did you mean tendon.rest_length?"),
        (["--over", "tendon.rest_length=1..2 cm step 1", "--simulated", "nowhere"], "table.nc: no such file"),
        (
            ["--over", "tendon.rest_length=5..9 cm step 3", "--no-simulation"],
            "tendon.rest_length: need a step that divides the range, such as an end of 8 or 11 or a step of 4 or 2",
        ),
        (
            ["--over", "tendon.rest_length=1..2 cm step 1", "--set", "tendon.rest_length=3 cm"],
            "--over: tendon.rest_length is also under --set; need it in one of them",
        ),
        (
            ["--no-simulation", "--ok-if", "stuck"],
            "--no-simulation: cannot be used with --ok-if; leave one of them out",
        ),
    ],
)
def test_a_wrong_map_is_refused_before_anything_is_written(options, message, tmp_path, capsys):
    with pytest.raises(SystemExit):
        main(["landscape", "binder2025", *options, "--out", str(tmp_path / "map")])
    assert message in capsys.readouterr().err
    assert not (tmp_path / "map").exists()


# all of it in 1.2 s of simulated time at most
CYCLED = """\
based_on = "binder2025"
[tendon]
area = "18.75 mm^2"
[tendon.law]
name = "rubber"
linear_modulus = "4.8 MPa"
[tendon.law.stiffness_drift]
kind = "logarithm"
rate = -0.05
interval = [-0.06, -0.04]
seen = [1, 2]
[protocol]
stages = [
  {name = "settle", drive = "none", until = "time", hold = "0 s", time_limit = "50 ms"},
  {name = "fold", drive = "fold", until = "folded", hold = "0 s", time_limit = "0.2 s"},
]
"""


def test_a_wing_is_folded_with_its_tendons_as_they_are_at_each_cycle(in_an_empty_folder, call):
    (in_an_empty_folder / "wing.toml").write_text(CYCLED)
    lines = call("run", "wing.toml", "--no-confirm", "--cycles", "3").out.splitlines()
    assert "Cycles: still folds after 3 cycles" in lines
    assert "  cycles beyond 2 are extrapolated: the tests contain cycles 1 to 2" in lines
    folder = in_an_empty_folder / "out" / "wing"
    left = {"cycles.csv", "cycles.json", "cycles.png"}
    assert left < set(everything_in(folder))
    rows = [line.split(",") for line in (folder / "cycles.csv").read_text().splitlines()]
    factor = rows[0].index("stiffness_by_first")
    assert [float(row[factor]) for row in rows[1:]] == pytest.approx([1, 2**-0.05, 3**-0.05])
    # an ordinary run into the same folder has none of it
    unchanged = CYCLED.replace("logarithm", "none").replace("rate = -0.05\ninterval = [-0.06, -0.04]\n", "")
    (in_an_empty_folder / "wing.toml").write_text(unchanged)
    lines = call("run", "wing.toml", "--no-confirm", "--cycles", "3")
    assert "\nCycles: the tests of rubber, cycles 1 to 2, show no drift: every cycle is like the first\n" in lines.out
    assert not left & set(everything_in(folder))


@pytest.mark.parametrize(
    ("cycles", "message"),
    [
        ("0", "--cycles: need a whole number >= 1, got 0"),
        ("3", '--cycles: need a stage with drive = "fold" in protocol.stages, got none'),
    ],
)
def test_impossible_cycles_are_refused_before_anything_runs(refusal, in_an_empty_folder, cycles, message):
    (in_an_empty_folder / "short.toml").write_text(SHORT)
    assert refusal("run", "short.toml", "--cycles", cycles) == message
    assert everything_in(in_an_empty_folder) == ["short.toml"]


@pytest.fixture
def specimen_files(in_an_empty_folder):
    """Write three specimens of 4.8 MPa, as a plain table that says neither length nor area."""
    for seed in (1, 2, 3):
        test = cyclic_test(lambda strain, _: 4.8e6 * strain, cycles=3, samples=60, noise=1e4, seed=seed)
        (in_an_empty_folder / f"tpu-{seed}.csv").write_text(plain_text(test), "utf-8")


SIZE = ("--length", "60 mm", "--area", "5 mm^2")


@pytest.mark.usefixtures("specimen_files")
def test_tensile_tests_become_a_law_that_sizes_the_papers_tendons(in_an_empty_folder, call):
    output = call("material", "tpu-*.csv", *SIZE, "--law", "linear", "--out", "out/tpu")
    assert output.out.startswith("tpu: 3 specimens, length 60 mm, area 5 mm², cycles 2 to 3\n")
    assert output.out.splitlines()[-1] == "written to out/tpu; open out/tpu/report.html"
    folder = in_an_empty_folder / "out" / "tpu"
    assert {"material.json", "tendon_law.toml", "modulus.png"} < set(everything_in(folder))
    law = ff.material.load_law(folder / "tendon_law.toml")
    assert law.source.endswith("tpu-1.csv, tpu-2.csv, tpu-3.csv")
    call("size", "binder2025", "--material", str(folder / "tendon_law.toml"), *RANGE, "--out", "sizes.csv")
    rows = [row.split(",") for row in (in_an_empty_folder / "sizes.csv").read_text().splitlines()[1:]]
    # Binder et al. 2025: 12.5 to 75 mm^2; a fit to noise of 0.2 % of the stress
    areas = [float(row[2]) * 1e6 for row in rows if float(row[0]) == pytest.approx(0.06)]
    assert areas == pytest.approx([12.5, 25, 37.5, 50, 62.5, 75], rel=2e-3)


RANGE = ("--stiffness", "10..60 N/cm step 10")


def test_a_run_warns_of_tendons_far_faster_than_the_tests_of_their_material(in_an_empty_folder, call):
    output = call("run", "binder2025", "--set", "tendon.law=tpu-82a", "--set", "tendon.area=12.5 mm^2")
    (warning,) = [line for line in output.err.splitlines() if "up to which tpu-82a was measured" in line]
    assert warning.startswith("warning: taut tendons reach a strain rate of ")
    # 10 mm/min by 60 mm
    assert "times the 0.00278 1/s" in warning
    written = json.loads((in_an_empty_folder / "out" / "binder2025" / "summary.json").read_text("utf-8"))
    assert warning.removeprefix("warning: ") in written["warnings"]


def test_the_named_materials_are_listed_with_their_sources(call):
    lines = call("materials").out.splitlines()
    assert [line for line in lines if not line.startswith(" ")] == ["Laws of tendons", "Laws of creases"]
    names = [line.strip() for line in lines if line.startswith("  ") and not line.startswith("   ")]
    assert names[:5] == ["petg", "resilin", "steel", "tpu-82a", "tpu-95a"]
    assert names[5:] == ["paper", "pet-film", "petg-film", "pp-living-hinge"]
    assert len([line for line in lines if line.startswith("    ")]) == len(names)


def test_the_values_of_a_law_of_creases_are_shown_with_their_reasons_and_facts(call):
    output = call("materials", "paper").out
    assert "0.2358 N m/rad/m" in output
    assert "plastic moment of a strip, S t^2 / 4" in output
    assert "[chosen] stress at a strain of 1 %" in output


def test_folding_tests_become_a_law_that_a_design_can_name(call, in_an_empty_folder):
    strip = folded_strip()
    rows = zip(strip.time, np.rad2deg(strip.angle), 1e3 * strip.moment, strict=True)
    lines = ["Time (s),Angle (deg),Moment (N mm)", *(",".join(f"{cell:.8g}" for cell in row) for row in rows), ""]
    (in_an_empty_folder / "strip.csv").write_text("\n".join(lines), "utf-8")
    output = call("material", "strip.csv", "--width", "20 mm", "--thickness", "0.1 mm", "--out", "fold").out
    assert "fold: 1 strip, width 20 mm, thickness 0.1 mm" in output
    assert 'use the law in a design with --set crease.law="fold/crease_law.toml"' in output
    content = json.loads((in_an_empty_folder / "fold" / "crease.json").read_text("utf-8"))
    assert content["fit"]["law"] == "elastic and plastic"
    design = ff.load_design("letter-fold", {"crease.law": "fold/crease_law.toml", "crease.rest_angle": "0 deg"})
    fitted = {value["key"]: value["value"] for value in content["fit"]["values"]}
    assert design.crease.law.yield_moment == pytest.approx(fitted["yield_moment"], rel=1e-5)
    assert design.crease.law.name == "fold"
    page = (in_an_empty_folder / "fold" / "report.html").read_text("utf-8")
    assert "elastic and plastic" in page


def test_options_of_tensile_tests_are_refused_for_folding_tests(refusal, in_an_empty_folder):
    (in_an_empty_folder / "strip.csv").write_text("Angle (deg),Moment (N mm)\n0,0\n1,1\n2,2\n", "utf-8")
    message = refusal("material", "strip.csv", "--length", "60 mm")
    assert message == "--length: is for tensile tests; these are folding tests"


def test_a_material_known_as_a_range_is_sized_at_the_modulus_chosen(call):
    output = call("size", "binder2025", "--material", "resilin", "--modulus", "1 MPa", "--stiffness", "10 N/cm")
    assert "90 mm²" in output.out  # A = k L / E, 9 cm


@pytest.mark.usefixtures("specimen_files")
@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["material"], "need at least one file of a tensile test, got none"),
        (["material", "q*.csv"], '"q*.csv": no file has such a name'),
        (["material", "."], ".: need a file of a tensile test, got a folder; name its files, as in ./*.csv"),
        (
            ["material", "tpu-1.csv", "--length", "60 mm"],
            "tpu-1.csv: area: is not in the file; give the specimen's area, such as 5 mm^2",
        ),
        (
            ["material", "tpu-1.csv", "--length", "60"],
            '--length: the unit is missing; write it such as "60 mm", got "60"',
        ),
        (
            ["material", "tpu-1.csv", *SIZE, "--law", "foo"],
            '--law: need a law such as "zener", got "foo"; allowed here: linear, polynomial, kelvin-voigt, zener,'
            " prony, softening",
        ),
        (["material", "tpu-1.csv", *SIZE, "--out", "tpu-2.csv"], "--out: need a folder, got the file tpu-2.csv"),
        (
            ["size", "binder2025", "--material", "tpu82", *RANGE],
            '"tpu82" is neither a named material nor a .toml file; did you mean tpu-82a?',
        ),
        (
            ["size", "binder2025", "--material", "resilin", *RANGE],
            "--modulus: resilin: modulus.linear: known only as a range, 0.4 to 1.5 MPa; choose a value in it",
        ),
        (
            ["size", "binder2025", "--material", "tpu-82a", "--stiffness", "10..5 N/cm"],
            '--stiffness: need a range such as "10..60 N/cm step 10", got "10..5 N/cm"',
        ),
        (
            ["size", "binder2025", "--material", "tpu-82a", "--stiffness", "0 N/cm"],
            '--stiffness: need > 0, got "0 N/cm"',
        ),
        (
            ["size", "binder2025", "--material", "tpu-82a", *RANGE, "--out", "a.txt"],
            "--out: need a file that ends with .csv, got a.txt",
        ),
    ],
)
def test_an_impossible_material_is_refused_in_one_line(refusal, arguments, message):
    assert refusal(*arguments) == message


def test_a_figure_of_a_run_is_written_and_a_film(in_an_empty_folder, call):
    (in_an_empty_folder / "my-wing.toml").write_text(SHORT)
    call("run", "my-wing.toml", "--no-confirm", "--out", "there")
    assert call("figure", "there", "--kind", "energy", "--out", "papers/fig.svg").out == "written to papers/fig.svg\n"
    assert 'width="252pt"' in (in_an_empty_folder / "papers" / "fig.svg").read_text()
    call("figure", "there", "--kind", "energy", "--width", "page", "--out", "fig.svg")
    assert 'width="511.2pt"' in (in_an_empty_folder / "fig.svg").read_text()
    output = call("film", "there", "--out", "wing.gif", "--size", "320x180", "--fps", "2")
    assert output.out == "written to wing.gif\n"
    assert (in_an_empty_folder / "wing.gif").read_bytes().startswith(b"GIF89a")


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--out", "wing.avi"], "--out: need a file that ends with .mp4 or .gif, got wing.avi"),
        (["--size", "321x180"], '--size: need two even numbers from 160 to 4096 such as 1280x720, got "321x180"'),
        (["--size", "large"], '--size: need two even numbers from 160 to 4096 such as 1280x720, got "large"'),
        (["--fps", "0"], "--fps: need 1 to 60, got 0"),
        (["--slower", "-2"], "--slower: need 0.01 to 10000, got -2.0"),
        ([], "there: need the folder of a run, as forficula run writes it, got no such folder"),
    ],
)
def test_a_film_that_cannot_be_made_is_refused(refusal, options, message):
    out = [] if "--out" in options else ["--out", "wing.gif"]
    assert refusal("film", "there", *out, *options) == message


def test_a_figure_that_cannot_be_made_is_refused(refusal):
    message = "there: need a folder that forficula wrote, got no such folder"
    assert refusal("figure", "there", "--kind", "energy", "--out", "fig.pdf") == message
    assert "--width" in refusal("figure", "there", "--kind", "energy", "--out", "fig.pdf", "--width", "poster")


def test_what_is_wrong_with_the_pattern_of_a_file_names_the_file(in_an_empty_folder, refusal):
    edges = [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]]
    tent = {"file_spec": 1.1, "frame_unit": "cm", "edges_vertices": edges, "edges_assignment": ["B"] * 4 + ["M"]}
    tent |= {
        "vertices_coords": [[0, 0, 0], [1, 0, 0.5], [1, 1, 0], [0, 1, 0.5]],
        "faces_vertices": [[0, 1, 2], [0, 2, 3]],
    }
    (in_an_empty_folder / "tent.fold").write_text(json.dumps(tent))
    said = "tent.fold: vertices_coords: need one z for all vertices, got 0 to 0.005 m"
    assert refusal("pattern", "tent.fold", "--out", "tent.svg") == said
    # a strip of six triangles, joined after half a turn
    faces = [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5], [4, 5, 1], [1, 5, 0]]
    edges = sorted({tuple(sorted(pair)) for a, b, c in faces for pair in ((a, b), (b, c), (c, a))})
    places = [[math.cos(turn), math.sin(turn), turn % 2] for turn in range(6)]
    strip = tent | {"vertices_coords": places, "faces_vertices": faces, "edges_vertices": edges}
    (in_an_empty_folder / "strip.fold").write_text(json.dumps(strip | {"edges_assignment": ["U"] * len(edges)}))
    assert refusal("run", "strip.fold").startswith("strip.fold: faces_vertices[3]: need a sheet with two sides")


def test_new_names_its_files_and_where_options_go(in_an_empty_folder, call, refusal):
    assert refusal("new").startswith("new: need design, study, goal, observations or tests, and FILE")
    message = "new: need options after study, as in: forficula new study mine.toml --kind joint"
    assert refusal("new", "--kind", "joint", "study", "mine.toml") == message
    warned = call("new", "--kind", "joint", "--goal", "mine.toml").err
    assert "use: forficula new goal mine.toml --kind joint" in warned
    assert (in_an_empty_folder / "mine.toml").exists()


@pytest.mark.parametrize("kind", ["earwig-fan", "yoshimura", "pleats"])
def test_a_new_design_has_the_size_that_is_wanted(call, kind):
    call("new", "design", "small.toml", "--kind", kind, "--size", "8 cm")
    pattern = design_pattern(ff.load_design("small.toml"))
    assert np.ptp(pattern.vertices_coords, axis=0).max() == pytest.approx(0.08, rel=1e-5)


def test_a_size_that_cannot_be_is_refused(refusal):
    assert refusal("new", "design", "a.toml", "--size", "0 cm") == "--size: need >= 0.1 mm and <= 10 km, got 0 m"
    assert refusal("new", "design", "a.toml", "--size", "8 N").startswith('--size: "N" is not a unit of the right kind')
    assert refusal("new", "design", "a.toml", "--kind", "fold-file", "--size", "8 cm").startswith("--size: a fold-file")
    assert refusal("new", "a.toml", "--study", "--size", "8 cm").startswith("--size: cannot be used with --study")


def test_new_writes_sample_tests_for_the_name_of_a_table(in_an_empty_folder, call):
    assert "forficula material mine-made-up-1.csv" in call("new", "mine.csv").out
    assert len(list(in_an_empty_folder.glob("mine-made-up-*.csv"))) == 3


def test_stages_are_addressed_by_name(in_an_empty_folder, call):
    call(
        "run",
        "binder2025",
        "--set",
        "protocol.stages.release folded.time_limit=2.5 s",
        "--no-confirm",
        "--out",
        "there",
    )
    stages = {
        stage.name: stage for stage in ff.load_design(in_an_empty_folder / "there" / "design.toml").protocol.stages
    }
    assert stages["release folded"].time_limit == 2.5


def test_the_verdict_comes_before_warnings_and_the_page_last(in_an_empty_folder, call, monkeypatch):
    opened = []
    monkeypatch.setattr("webbrowser.open", opened.append)
    (in_an_empty_folder / "wing.toml").write_text(SHORT)
    with contextlib.redirect_stderr(sys.stdout):
        said = call("run", "wing.toml", "--set", "protocol.timestep=10 ms", "--no-confirm", "--tolerate")
    # a slow machine says what it waits for
    lines = [line for line in said.out.splitlines() if not line.endswith(" ...")]
    assert lines[0].startswith("wing: ")
    assert lines[1].startswith("warning: ")
    assert lines[-1] == "written to out/wing; open out/wing/report.html"
    call("run", "wing.toml", "--no-confirm", "--open")
    assert opened == [(in_an_empty_folder / "out" / "wing" / "report.html").resolve().as_uri()]


def test_every_help_page_has_two_examples_that_are_commands(call):
    for command in app:
        if command.startswith("-"):
            continue
        said = call(command, "--help").out
        examples = re.findall(r"^  forficula (\S+)", said.partition("Examples:")[2], re.M)
        assert examples[:2] == [command, command], command


def test_an_estimate_is_written_once_for_what_takes_longer_than_ten_seconds(capsys, monkeypatch):
    clock = iter([0.0, 0.0, 2.0, 3.0, 4.0])
    monkeypatch.setattr("forficula.commands.cost.monotonic", lambda: next(clock))
    estimate = CountEstimate(most=True)
    estimate.update(1, 20)
    estimate.update(2, 20)
    assert capsys.readouterr().err == "estimate: at most 38 s for at most 20 runs\n"
    estimate.update(3, 20)
    assert capsys.readouterr().err == ""


@pytest.mark.parametrize(("searches", "ending"), [(False, ""), (True, ", and twice as long at each finer timestep")])
def test_the_estimate_of_a_run_is_an_upper_limit(capsys, monkeypatch, searches, ending):
    clock = iter([0.0, 0.0, 0.5, 2.0])
    monkeypatch.setattr("forficula.commands.cost.monotonic", lambda: next(clock))
    seen = []
    estimate = RunEstimate(lambda *report: seen.append(report), searches=searches)
    for time in (0.0, 0.1, 0.5):
        estimate("fold", time, 6.5)
    said = f"estimate: at most 24 s, less if stages reach their goals early{ending}\n"
    assert (capsys.readouterr().err, len(seen)) == (said, 3)


VISCOUS = 'name = "{0}"\nsource = ""\n[modulus]\nlinear = "4.8 MPa"\n[viscosity]\nlinear = "{1} MPa s"\n'


@pytest.mark.filterwarnings("default:protocol.timestep")
def test_a_run_with_a_viscous_law_keeps_its_energy(in_an_empty_folder, call):
    (in_an_empty_folder / "viscous.toml").write_text(VISCOUS.format("viscous", 3))
    law = ("--set", "tendon.law=viscous.toml", "--set", "tendon.area=5 mm^2", "--no-confirm", "--no-engine")
    assert '"auto" is used' in call("run", "binder2025-joint", *law, "--out", "auto", expected=2).err
    assert abs(json.loads((in_an_empty_folder / "auto" / "summary.json").read_text())["residual"]) < 1e-4
    # the balance of the reference's timestep misses more than was exchanged, which the verdict says
    call("run", "binder2025-joint", *law, "--set", "protocol.timestep=0.1 ms", "--out", "own", expected=3)
    assert abs(json.loads((in_an_empty_folder / "own" / "summary.json").read_text())["residual"]) > 1
