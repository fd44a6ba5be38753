"""Assumptions as a figure, a table and a page: effects by colour and by symbol."""

import csv
from dataclasses import replace

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import same_color

from forficula.analysis import Verdict
from forficula.show.folder.assumptions_folder import write_assumptions
from forficula.show.study.assumptions_figure import draw_assumptions
from forficula.show.study.assumptions_table import assumption_rows
from forficula.show.style import VERMILION, description
from forficula.study.assumptions.assumptions import Effect
from tests.assumptions import ASSUMED


def marks(axes, row):
    """Return marker, colour and horizontal position of the marks in a row."""
    lines = [line for line in axes.lines if line.get_linestyle() == "None" and line.get_ydata()[0] == row]
    return [(line.get_marker(), line.get_color(), line.get_xdata()[0]) for line in lines]


def test_dots_show_changes_of_times_and_triangles_show_failures():
    time, work = draw_assumptions(ASSUMED).axes
    ((marker, _, change),) = marks(time, 0)
    assert (marker, change) == ("o", pytest.approx(100 * (0.3206 / 0.2206 - 1)))
    ((marker, colour, _),) = marks(time, 1)
    assert marker == ">"
    assert same_color(colour, VERMILION)
    # the work of a stage that failed belongs to another motion
    assert [mark[0] for mark in marks(work, 1)] == [">"]


def test_a_run_without_a_reliable_result_has_a_cross():
    unknown = replace(ASSUMED.runs[1], verdict=Verdict.UNDECIDED, effect=Effect.UNKNOWN)
    for axes in draw_assumptions(replace(ASSUMED, runs=(ASSUMED.runs[0], unknown))).axes:
        assert [mark[0] for mark in marks(axes, 1)] == ["x"]


def test_a_change_of_the_verdict_has_a_colour_and_a_symbol_of_its_own():
    opens = replace(ASSUMED.runs[1], times={"close": 0.3})
    time, _ = draw_assumptions(replace(ASSUMED, runs=(ASSUMED.runs[0], opens))).axes
    ((marker, colour, _),) = marks(time, 1)
    assert marker == "D"
    assert same_color(colour, VERMILION)
    names = [text for text in time.texts if text.get_weight() != "bold"]  # and not the panel's letter
    assert [same_color(text.get_color(), VERMILION) for text in names] == [False, True]


def test_the_band_is_the_numerical_uncertainty_of_the_designs_own_run():
    time, work = draw_assumptions(ASSUMED).axes
    for axes, half in ((time, 100 * 0.01 / 0.2206), (work, 100 * 0.001 / 0.3929)):
        (band,) = axes.patches
        assert (band.get_x(), band.get_x() + band.get_width()) == pytest.approx((-half, half))
    assert description(draw_assumptions(ASSUMED)).endswith(
        "Closed; 1 of 2 changed assumptions changes the verdict: twice the damping of hinges (still closing)."
    )


def test_a_design_that_drives_nothing_and_one_that_fails_are_drawn():
    FigureCanvasAgg(draw_assumptions(replace(ASSUMED, transitions=()))).draw()
    missed = replace(ASSUMED.own, verdict=Verdict.STUCK, times={"close": None})
    (work,) = draw_assumptions(replace(ASSUMED, own=missed)).axes
    assert work.get_xlabel().startswith("work of closing")


@pytest.mark.usefixtures("no_figures")
def test_the_folder_has_tables_the_figure_and_a_page(tmp_path):
    unreliable = replace(ASSUMED.runs[0], verdict=Verdict.DIVERGED, effect=Effect.UNKNOWN)
    result = replace(ASSUMED, runs=(*ASSUMED.runs, unreliable))
    write_assumptions(result, tmp_path)
    assert {path.name for path in tmp_path.iterdir()} == {
        *("assumptions.json", "assumptions.csv", "assumptions.png", "report.html", "figures"),
    }
    with (tmp_path / "assumptions.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert rows[0].keys() == assumption_rows(result)[0].keys()
    assert [row["effect"] for row in rows] == ["", "numbers", "verdict", "unknown"]
    assert rows[2]["close_time_s"] == ""
    page = (tmp_path / "report.html").read_text("utf-8")
    assert "Does not apply: gravity, because the axis of the hinge is upright." in page
    assert "1 of 3 changes have no reliable result" in page
    assert "shorter where the change requires it: twice the damping of hinges 0.1 ms" in page


def test_the_legend_names_only_what_is_drawn():
    named = [text.get_text() for text in draw_assumptions(ASSUMED).legends[0].get_texts()]
    assert "fails with the change" in named
    assert "no reliable result" not in named
    unknown = replace(ASSUMED.runs[1], verdict=Verdict.UNDECIDED, effect=Effect.UNKNOWN)
    figure = draw_assumptions(replace(ASSUMED, runs=(ASSUMED.runs[0], unknown)))
    assert "no reliable result" in [text.get_text() for text in figure.legends[0].get_texts()]
