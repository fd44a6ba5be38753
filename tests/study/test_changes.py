"""Studies of named changes: mechanisms that are removed or weakened, one at a time and in pairs."""

import csv
import io
import math

import numpy as np
import pytest
import xarray as xr

import forficula as ff
from forficula.analysis.margin import combined_margin
from forficula.cli import main
from forficula.errors import InputError
from forficula.show import print_study, write_study
from forficula.show.folder.study_folder import study_drawings
from forficula.show.page.study_page import study_page
from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH, description
from forficula.study import collect, load_study, run_study, table_csv
from forficula.study.running.evaluate import row_key
from forficula.study.running.journal import read_rows
from forficula.study.tables.redundancy import change_rows, redundancy, redundancy_sentences
from forficula.study.tables.table import build_table

# A sheet of two panels that two tendons hold closed against the spring of the crease. Both ends of a tendon lie at the
# distance A from the crease, so that it pulls with the moment k (2 A cos(a/2) - L) A sin(a/2) at the fold angle a.
A, K, L = 0.05, 50.0, 0.05
MOMENT_AT_90 = K * (2 * A * math.cos(math.pi / 4) - L) * A * math.sin(math.pi / 4)
# one tendon at 90 deg has 1.5 times the moment of the crease, which is 0.2 m wide
CREASE = MOMENT_AT_90 / (1.5 * math.pi / 2) / 0.2
# share of the stiffness that each change leaves to the left and to the right tendon
SHARES = {
    "no left tendon": (0.0, 1.0),
    "no right tendon": (1.0, 0.0),
    "left tendon at 0.6": (0.6, 1.0),
    "right tendon at 0.6": (1.0, 0.6),
}
FILE = f"""
name = "clasp"
design = "clasp.toml"
vary = "pairs"

[settings]
crease.stiffness = "{CREASE:.9g} N m/rad/m"
drive.open.value = "-10 N cm"

[[change]]
name = "no left tendon"
values = {{ "tendon.left" = "none" }}

[[change]]
name = "no right tendon"
values = {{ "tendon.right" = "none" }}

[[change]]
name = "left tendon at 0.6"
multiply = {{ "tendon.left.stiffness" = 0.6 }}

[[change]]
name = "right tendon at 0.6"
multiply = {{ "tendon.1.stiffness" = 0.6 }}
"""


def write_clasp(folder):
    """Write a letter fold of two panels with two equal tendons across its crease."""
    (folder / "clasp.toml").write_text(
        """
based_on = "letter-fold"
pattern.panels = 2
pattern.panel_lengths = ["10 cm"]
pattern.width = "20 cm"

[[tendon]]
name = "left"
from = "facet 0 at 0.5, 0.25"
to = "facet 1 at 0.5, 0.25"
stiffness = "0.5 N/cm"
rest_length = "5 cm"
damping = "0.02 N s/m"

[[tendon]]
name = "right"
from = "facet 0 at 0.5, 0.75"
to = "facet 1 at 0.5, 0.75"
stiffness = "0.5 N/cm"
rest_length = "5 cm"
damping = "0.02 N s/m"

[[measure]]
name = "mouth"
kind = "distance"
from = "edge 1 at 0.5"
to = "edge 2 at 0.5"
""",
        "utf-8",
    )


@pytest.fixture(scope="module")
def clasp(tmp_path_factory):
    """The study of the clasp, its table, and its folder."""
    folder = tmp_path_factory.mktemp("clasp")
    write_clasp(folder)
    (folder / "study.toml").write_text(FILE, "utf-8")
    study = load_study(folder / "study.toml")
    return study, run_study(study, folder / "out"), folder


def stays_closed(left: float, right: float) -> bool:
    """Whether tendons with these shares of their stiffness exceed the moment of the crease at 90 deg."""
    return (left + right) * MOMENT_AT_90 > CREASE * 0.2 * math.pi / 2


def shares(names) -> tuple[float, float]:
    """Return the stiffness that changes together leave to both tendons."""
    left, right = np.prod([(1.0, 1.0), *(SHARES[name] for name in names)], axis=0)
    return float(left), float(right)


def test_the_closed_form_decides_which_changes_alone_and_in_pairs_open_the_clasp(clasp):
    _, table, _ = clasp
    closed = {
        (str(first), str(second)): bool(held)
        for first, second, held in zip(
            table["first_change"].values, table["second_change"].values, table["closed"].values, strict=True
        )
    }
    expected = {names: stays_closed(*shares(filter(None, names))) for names in closed}
    assert closed == expected
    assert list(expected.values()).count(False) == 3


def test_both_tendons_are_redundant_but_not_together(clasp):
    _, table, _ = clasp
    report = redundancy(table)
    assert report.unchanged.works
    assert {run.names[0] for run in report.tolerated} == set(SHARES)
    assert {run.names for run in report.failing_pairs} == {
        ("no left tendon", "no right tendon"),
        ("no left tendon", "right tendon at 0.6"),
        ("no right tendon", "left tendon at 0.6"),
    }
    assert report.fatal == report.repaired_pairs == ()
    sentences = " ".join(redundancy_sentences(table))
    assert "4 of 4 changes are tolerated (a mechanism that such a change removes is redundant)" in sentences
    assert "Of 4 pairs of tolerated changes, 3 fail: no left tendon + no right tendon (did not stay closed" in sentences


def test_pairs_that_change_the_same_value_are_left_out_and_named(clasp):
    study, table, _ = clasp
    assert [pair.names for pair in study.plan.omitted] == [
        ("no left tendon", "left tendon at 0.6"),
        ("no right tendon", "right tendon at 0.6"),
    ]
    assert study.plan.omitted[0].why == "both change tendon.left"
    assert redundancy(table).omitted == study.plan.omitted
    assert len(study.points) == 1 + 4 + 6 - 2


def test_a_point_gives_the_run_of_the_changed_design(clasp):
    study, table, _ = clasp
    place = study.plan.together.index((0, 3))
    design = study.base.with_values({"tendon.left": "none", "tendon.right.stiffness": "0.3 N/cm"})
    outcome = ff.measure(ff.run(design, confirm=False))
    assert table["status"].values[place] == outcome.status
    assert table["close_work"].values[place] == outcome.transitions["close"].work


def test_the_margin_is_that_of_all_transitions_together(clasp):
    _, table, _ = clasp
    for place in range(table.sizes["change"]):
        margins = [float(table[f"{name}_margin"].values[place]) for name in ("close", "open")]
        assert table["margin"].values[place] == combined_margin(margins)
        works = bool(table["closed"].values[place] and table["opened"].values[place])
        assert (table["margin"].values[place] > 0) == works


def test_the_table_names_changes_and_values_as_text_and_in_a_file(clasp, tmp_path):
    study, table, _ = clasp
    rows = list(csv.DictReader(io.StringIO(table_csv(study, table))))
    assert [row["change"] for row in rows[:3]] == ["clasp", "no left tendon", "no right tendon"]
    assert rows[5] == rows[5] | {
        "change": "no left tendon + no right tendon",
        "changed_values": "tendon.left = none, tendon.right = none",
        "closed": "false",
        "verdict": "not held",
    }
    assert float(rows[1]["margin"]) == table["margin"].values[1]
    (tmp_path / "table.nc").write_bytes(table.to_netcdf(engine="h5netcdf"))
    with xr.open_dataset(tmp_path / "table.nc", engine="h5netcdf") as again:
        assert redundancy(again.load()) == redundancy(table)


def test_shards_give_the_same_table(clasp, tmp_path):
    study, table, _ = clasp
    for number in (1, 2):
        run_study(study, tmp_path, shard=(number, 2))
    assert collect(study, tmp_path).identical(table)


def test_the_terminal_lists_every_change_with_its_margins(clasp, capsys):
    study, table, _ = clasp
    print_study(study, table)
    printed = capsys.readouterr().out
    assert "close margin  open margin  margin  outcome" in printed
    assert "Unchanged, the structure gets closed and gets opened again with a margin of" in printed
    headings, rows = change_rows(table)
    assert headings[-1] == "outcome"
    assert [row[0] for row in rows] == ["clasp", *SHARES]


def test_figures_show_single_changes_and_pairs(clasp):
    _, table, _ = clasp
    drawings = study_drawings(table)
    assert list(drawings) == ["changes", "pairs"]
    for draw in drawings.values():
        for width in (COLUMN_WIDTH, PAGE_WIDTH):
            figure = draw(width)
            assert "3 fail" in description(figure)
    bars = [label.get_text().replace("\n", " ") for label in drawings["changes"](PAGE_WIDTH).axes[0].get_yticklabels()]
    assert sorted(bars) == sorted(["clasp, unchanged", *SHARES])


@pytest.mark.usefixtures("undrawn")
def test_the_page_states_the_conclusions(clasp):
    study, table, _ = clasp
    page = study_page(study, table, (), 0, engine=False)
    assert "Redundancy and margins" in page
    assert "9 points. Unchanged, the structure gets closed" in page
    assert "tendon.left = none" in page


@pytest.mark.usefixtures("undrawn")
def test_the_folder_has_a_figure_of_changes(clasp, tmp_path):
    study, table, _ = clasp
    write_study(study, table, tmp_path)
    assert {"changes.png", "pairs.png", "table.csv", "table.nc"} <= {file.name for file in tmp_path.iterdir()}


def test_python_takes_numbers_in_si(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    study = ff.new_study(
        "letter-fold", change=[{"name": "soft", "values": {"tendon.left.stiffness": 40.0, "tendon.right": "none"}}]
    )
    assert study.points == ({}, {"tendon.left.stiffness": "0.4 N/cm", "tendon.right": "none"})
    assert repr(study) == "<Study study: 2 points of letter-fold over 1 change>"


def changes(tmp_path, text, head="", design="letter-fold"):
    """Load a study of a design with changes."""
    (tmp_path / "study.toml").write_text(f'design = "{design}"\n{head}\n{text}', "utf-8")
    return load_study(tmp_path / "study.toml")


def change(name, values):
    return f'[[change]]\nname = "{name}"\n{values}\n'


LEFT = change("left", 'values = { "tendon.left" = "none" }')


@pytest.mark.parametrize(
    ("text", "head", "message"),
    [
        (LEFT, 'vary = "grid"', 'vary: need "one-at-a-time" or "pairs" for changes under [[change]], got "grid"'),
        (
            f'[factors]\n"crease.stiffness" = ["1e-2 N m/rad/m"]\n{LEFT}',
            "",
            "factors: need a study without it if there are changes under [[change]]",
        ),
        (LEFT + LEFT, "", "change 1 (left): name: need a name that no other change has"),
        (
            LEFT + change("also left", 'values = { "tendon.0" = "none" }'),
            "",
            "change 1 (also left): need values that differ from those of change 0 (left)",
        ),
        (
            change("soft", 'values = { "tendon.left.stiffness" = 0.4 }'),
            "",
            "change 0 (soft): values.tendon.left.stiffness: the unit is missing",
        ),
        (
            change("soft", 'multiply = { "tendon.left.stiffness" = "half" }'),
            "",
            'change 0 (soft): multiply.tendon.left.stiffness: need a number such as 0.5, got "half"',
        ),
        (
            change("soft", 'multiply = { "facet.kind" = 0.5 }'),
            "",
            'change 0 (soft): multiply.facet.kind: need a key with a number, got "rigid"; give a value under values',
        ),
        (change("same", 'multiply = { "tendon.left.stiffness" = 1 }'), "", "need values that differ from those of the"),
        (change("empty", ""), "", "change 0 (empty): need at least one key under values or multiply"),
        (
            change("both", 'values = { "crease.damping" = "0 N m s/rad/m" }\nmultiply = { "crease.damping" = 0.5 }'),
            "",
            "change 0 (both): multiply.crease.damping: is under values, too; need it in one of them",
        ),
        (
            change("torque", 'multiply = { "drive.close.value" = 0.5 }'),
            'ask = "least-torques"',
            'change torque (drive.close.value): is what "least-torques" looks for',
        ),
        (change("gone", 'values = { "tendon.middle" = "none" }'), "", "change 0 (gone): tendon.middle: need one of 0"),
    ],
)
def test_changes_that_are_not_allowed(tmp_path, text, head, message):
    with pytest.raises(InputError) as error:
        changes(tmp_path, text, head)
    assert message in str(error.value)


def test_pairs_need_changes(study_file):
    with pytest.raises(InputError, match=r'vary: "pairs" needs changes with names, under \[\[change\]\]'):
        load_study(study_file('"hinge.damping" = ["1e-4 N m s/rad"]', 'vary = "pairs"'))


def test_a_pair_that_gives_the_design_of_one_of_its_changes_is_left_out(tmp_path):
    both = change("all at half", 'multiply = { "tendon.stiffness" = 0.5 }')
    one = change("vein 0 at half", 'values = { "tendon.0.stiffness" = "5 N/cm" }')
    study = changes(tmp_path, both + one, 'vary = "pairs"', "binder2025")
    assert [pair.why for pair in study.plan.omitted] == ['together they give the same design as "all at half" alone']


def test_changes_of_all_tendons_combine_with_the_removal_of_one(tmp_path):
    both = change("all at half", 'multiply = { "tendon.stiffness" = 0.5 }')
    study = changes(tmp_path, both + change("no 0", 'values = { "tendon.0" = "none" }'), 'vary = "pairs"', "binder2025")
    wing = study.base.with_values(study.points[-1])
    assert [None if tendon is None else tendon.stiffness for tendon in wing.tendons] == [None, 500.0, 500.0]


def test_least_torques_of_changed_designs_are_searched(tmp_path):
    study = changes(
        tmp_path, LEFT, 'ask = "least-torques"\n[search]\nclose_torques = ["1 N cm", "3 N cm"]\nopen_torques = []'
    )
    table = run_study(study, tmp_path / "out")
    assert "margin" not in table
    assert table["least_close_value"].values.tolist() == [0.01, 0.03]
    assert change_rows(table)[0] == ["change", "least close value (N cm)", "outcome"]
    assert study_drawings(table)["changes"](COLUMN_WIDTH).axes[0].get_xlabel() == "least close value (N cm)"
    # least values of a drive in the negative sense
    axes = study_drawings(table.assign(least_close_value=-table["least_close_value"]))["changes"](PAGE_WIDTH).axes[0]
    start, end = axes.get_xlim()
    assert (start, end) == (0, pytest.approx(1.15 * -3))
    assert [bar.get_width() for bar in axes.patches] == pytest.approx([-1, -3])
    assert [text.get_text() for text in axes.texts] == ["−1", "−3"]


def test_a_run_without_a_reliable_result_has_no_margin(clasp):
    study, _, folder = clasp
    rows = read_rows(folder / "out", study.base)
    designs = {number: study.base.with_values(point) for number, point in enumerate(study.points)}
    rows[row_key(designs[1])] |= {"verdict": "undecided", "outcome": "undecided"}
    table = build_table(study, designs, rows)
    assert np.isnan(table["margin"].values[1])
    assert redundancy(table).alone[0].works is None
    assert "Changes without a reliable result: no left tendon." in redundancy_sentences(table)


def test_new_study_files_explain_changes(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    main(["new", "study", "mine.toml"])
    text = (tmp_path / "mine.toml").read_text("utf-8")
    assert '# [[change]]\n# name = "half the tendon.stiffness"\n# multiply = { "tendon.stiffness" = 0.5 }\n' in text


def test_the_named_study_of_the_wing_changes_every_mechanism():
    study = load_study("binder2025-redundancy")
    changed = {key.partition(".")[0] for change in study.plan.changes for key in change.values}
    assert changed == {"tendon", "hinge", "protocol", "coupling", "membrane", "guard"}
    assert len(study.points) == 1 + len(study.plan.changes) + math.comb(len(study.plan.changes), 2) - len(
        study.plan.omitted
    )
