"""Maps of many points show bins: means, and the most frequent outcomes, and say so."""

import json
import re
import sys

import numpy as np
import pytest
from matplotlib.collections import QuadMesh

from forficula.show.page.data.study_data import page_bins, study_data
from forficula.show.page.study_page import study_page
from forficula.show.study.bins import bins_of
from forficula.show.study.map_panel import MapPanel
from forficula.show.study.maps import draw_status_map, draw_work_maps, map_drawings, table_view
from forficula.study import load_study
from forficula.study.running.kept_runs import KeptRun
from tests.show.study.test_maps import TWO, as_run, many_ends, planted, sampled

DRAWN = """
"tendon.stiffness" = { distribution = "uniform", low = "10 N/cm", high = "30 N/cm" }
"tendon.rest_length" = { distribution = "uniform", low = "0 cm", high = "9 cm" }
"""


@pytest.fixture
def few(monkeypatch):
    """Draw bins from ten points on, three points in a bin."""
    module = sys.modules["forficula.show.study.bins"]
    monkeypatch.setattr(module, "_MOST_POINTS", 10)
    monkeypatch.setattr(module, "_POINTS_PER_BIN", 3)


@pytest.fixture
def table(few):  # noqa: ARG001
    """Return twelve samples of two factors, which are in 2 x 2 bins."""
    return sampled(as_run(many_ends()))


def values(panel):
    return panel.values.values.tolist()


def test_a_bin_has_the_mean_of_its_points_if_at_least_half_of_them_have_a_value(table):
    bins = bins_of(table_view(table))
    assert bins.counts.tolist() == [2, 2, 4, 4]
    assert [bins.view.table[name].values.tolist() for name in TWO] == [[1500, 2500], pytest.approx([0.0225, 0.0675])]
    panel = bins.panel(MapPanel(title="", values=table["fold_work"], reasons=table["outcome"], unit="J"))
    # works are 1 to 12 in the order of the points; 1, 2, 3, 5 and 6 folded
    assert np.array_equal(values(panel), [[1.5, 3], [5.5, np.nan]], equal_nan=True)
    panel = bins.panel(MapPanel(title="", values=table["unfold_work"], reasons=table["outcome"], unit="J"))
    assert np.array_equal(values(panel), [[1.5, np.nan], [np.nan, np.nan]], equal_nan=True)
    assert panel.reasons.values[0, 1] == "did not open"
    assert panel.reasons.values[1, 1] == "did not fold"


def test_an_empty_bin_has_no_points(table):
    corners = table.isel(sample=[0, 1] * 6 + [11])
    bins = bins_of(table_view(corners))
    outcomes = bins.most_frequent(corners["outcome"].values, np.ones(13, dtype=bool))
    assert bins.counts.tolist() == [12, 0, 0, 1]
    assert outcomes.tolist() == ["folded and opened", "no points", "no points", "did not fold"]
    assert bins.shares(corners["outcome"].values)[0] == "12 points: 100 % folded and opened"
    assert bins.shares(corners["outcome"].values)[1] == "0 points"


def test_values_that_are_spread_over_decades_have_bins_of_equal_ratios(table):
    spread = table.assign_coords(tendon_stiffness=("sample", 10.0 ** np.linspace(0, 4, 12)))
    edges = bins_of(table_view(spread)).view.edges["tendon_stiffness"]
    assert edges == pytest.approx([1, 100, 1e4])
    assert bins_of(table_view(table)).view.edges["tendon_stiffness"] == pytest.approx([1000, 2000, 3000])


@pytest.mark.usefixtures("few")
def test_values_of_a_fine_grid_are_joined():
    grid = planted(TWO)
    bins = bins_of(table_view(grid), 2)
    assert bins.shape == (2, 2)
    assert bins.counts.tolist() == [4, 4, 2, 2]
    panel = bins.panel(MapPanel(title="", values=grid["fold_work"], reasons=grid["outcome"], unit="J"))
    assert values(panel) == [[(1 + 2 + 5 + 6) / 4, (3 + 4 + 7 + 8) / 4], [9.5, 11.5]]
    assert [bins.bin_of(point, grid) for point in range(12)] == [0, 0, 1, 1, 0, 0, 1, 1, 2, 2, 3, 3]


def test_maps_say_how_many_points_and_bins_they_show(table):
    figure = draw_status_map(table)
    assert figure.get_suptitle() == "12 points in 2 x 2 bins; colour: most frequent outcome of a bin"
    figure = draw_work_maps(table)
    text = " ".join(figure.get_suptitle().split())
    assert text.startswith("12 points in 2 x 2 bins; colour: mean of a bin; if most of its points have no value")
    meshes = [item for axes in figure.axes for item in axes.collections if isinstance(item, QuadMesh)]
    assert np.ma.compressed(meshes[0].get_array()).tolist() == [1.5, 3, 5.5]
    third = table.assign_coords(vein_density=("sample", np.arange(12.0), {"key": "vein.density"}))
    assert draw_status_map(third).get_suptitle().startswith("12 points in 2 x 2 bins, over all values of vein density")
    for drawing in map_drawings(table).values():
        drawing(3.5)


def test_few_points_are_drawn_one_by_one():
    assert bins_of(table_view(sampled(planted(TWO)))) is None
    assert draw_status_map(sampled(planted(TWO))).get_suptitle() == ""


def test_the_page_shows_bins_and_says_so(study_file, table, reference_run, reference_outcome):
    study = load_study(study_file(DRAWN, tail="[sampling]\ncount = 12"))
    data = study_data(study, table)
    assert (data["noun"], data["points"], data["sampled"]) == ("bin", 4, False)
    assert [factor["texts"] for factor in data["factors"]] == [["15", "25"], ["2.25", "6.75"]]
    works = next(item for item in data["quantities"] if item["name"] == "fold_work")
    assert works["values"] == [1.5, 3, 5.5, None]
    assert data["statuses"][0] == "2 points: 100 % folded and opened"
    assert data["words"][data["verdicts"][3]]["word"] == "did not fold"
    kept = [
        KeptRun(point=point, part="run", folder=f"runs/{point}", record=reference_run, outcome=reference_outcome)
        for point in (2, 9, 4)
    ]
    holds = {state: table[f"{name}_work"].notnull() for state, name in (("folded", "fold"), ("opened", "unfold"))}
    page = study_page(study, table.assign(holds), kept, 3)
    assert "This page shows 12 points in 2 x 2 bins" in page
    assert "A table of 12 points is too long for this page; table.csv lists all." in page
    shown = json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL)[1])
    assert [(run["point"], run["title"][:8]) for run in shown["runs"]] == [(1, "point 3:"), (2, "point 5:")]
    assert shown["csv"] is None
    assert page_bins(table).bin_of(9, table) == 2
