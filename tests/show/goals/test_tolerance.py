"""Results of a tolerance analysis: figures with descriptions, a table, text, and the same figures from the file."""

import json
from dataclasses import replace

import numpy as np
import pytest
import xarray
from matplotlib.colors import to_hex, to_rgb

import forficula as ff
from forficula.design import load_design
from forficula.goals.tolerance.kept_samples import samples_to_keep
from forficula.goals.tolerance.nearest_failure import Answer
from forficula.goals.tolerance.tolerance_table import tolerance_table
from forficula.show.folder.presentation import folder_drawings
from forficula.show.folder.tolerance_folder import tolerance_drawings, write_tolerance
from forficula.show.goals.tolerance_figures import draw_cloud, draw_indices, draw_reaches
from forficula.show.goals.tolerance_text import print_tolerance
from forficula.show.style import COLUMN_WIDTH, VERMILION, description
from tests.goals.tolerance.closed_form import FACTORS, KEYS, LINE, SMALL, assessed, line


@pytest.fixture(scope="module")
def design():
    return load_design("letter-fold")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("tolerance")


@pytest.fixture(scope="module")
def tolerance(design, folder):
    return assessed(design, folder, SMALL, line)


@pytest.fixture(scope="module")
def table(tolerance):
    return tolerance_table(tolerance)


def test_bars_show_the_indices_of_the_factors_in_order_and_of_the_others(tolerance, table):
    axes = draw_indices(table).axes[0]
    names = [yticklabel.get_text() for yticklabel in axes.get_yticklabels()]
    assert names == ["tendon left rest length", "facet thickness", "3 others"]
    first = [bar.get_width() for bar in axes.containers[0]]
    assert first == pytest.approx([max(item, 0) for item in tolerance.indices.first[0]])
    assert [bar.get_width() for bar in axes.containers[1]] == pytest.approx(tolerance.indices.total[0].tolist())
    assert "is due to tendon left rest length" in description(axes.figure)


def test_the_cloud_has_a_point_for_each_sample_and_the_map_a_cell_for_each_design(tolerance, table):
    axes = draw_cloud(table).axes[0]
    points = {item.get_marker(): len(item.get_xdata()) for item in axes.lines}
    answers = tolerance.samples.answers
    assert points["o"] == (answers == Answer.WORKS).sum()
    assert points["x"] == (answers == Answer.FAILS).sum()
    assert axes.get_xlabel() == "tendon left rest length (cm)"
    # the cells, and the edge of the tolerances
    assert len(axes.patches) == SMALL.cells**2 + 1
    edge = axes.patches[-1]
    assert (edge.get_x(), edge.get_width()) == pytest.approx((4.5, 1.0))


def test_the_nearest_failure_is_in_the_first_row(tolerance, table):
    figure = draw_reaches(table, COLUMN_WIDTH)
    axes = figure.axes[0]
    assert axes.get_yticklabels()[0].get_text() == "tendon left rest length"
    failing = [
        item for item in axes.lines if item.get_marker() == "x" and to_hex(item.get_color()) == VERMILION.lower()
    ]
    assert [item.get_xdata()[0] for item in failing[:1]] == [tolerance.reaches[1][1].fails]
    assert "Tendon left rest length fails first" in description(figure)


def test_the_folder_has_all_of_it_and_draws_it_again(tolerance, table, folder):
    written = write_tolerance(tolerance, folder)
    assert set(folder_drawings(folder)) == set(tolerance_drawings(table)) == {"indices", "cloud", "reaches"}
    with xarray.open_dataset(folder / "tolerance.nc", engine="h5netcdf") as read:
        xarray.testing.assert_equal(read["probability"], written["probability"])
        assert read.attrs["says"] == written.attrs["says"]
        again = draw_indices(read.load())
    assert description(again) == description(draw_indices(table))
    content = json.loads((folder / "tolerance.json").read_text("utf-8"))
    assert content["works"]["works"] == tolerance.probability.works
    assert content["tighten_first"] == KEYS[1]
    rows = (folder / "table.csv").read_text("utf-8").splitlines()
    assert len(rows) == len(tolerance.samples) + 1
    assert rows[0].startswith("tendon_left_stiffness_N_per_m,tendon_left_rest_length_m,")


def test_the_terminal_has_probability_indices_and_reaches(tolerance, capsys):
    print_tolerance(tolerance)
    output = capsys.readouterr().out
    for words in (
        "letter-fold: The design works in",
        "stays opened",
        "the 3 others",
        "fails above",
        "tendon left rest length",
    ):
        assert words in output


def test_where_there_was_little_time_only_what_is_known_is_drawn(design, tmp_path):
    lines = assessed(design, tmp_path / "lines", LINE, line)
    axes = draw_indices(tolerance_table(lines)).axes[0]
    assert len(axes.containers) == 1
    assert len(axes.get_yticklabels()) == len(FACTORS)


def test_a_design_that_fails_has_no_figure_of_distances_to_failure(design, tmp_path, capsys):
    few = replace(SMALL, rows=16, points=32, cells=3)
    failing = assessed(design, tmp_path / "failing", few, lambda offsets: line(offsets) - 0.2)
    assert set(tolerance_drawings(tolerance_table(failing))) == {"indices", "cloud"}
    print_tolerance(failing)
    assert "The nominal design does not work: did not get opened." in capsys.readouterr().out


def test_kept_runs_cover_every_outcome_with_the_smallest_deviations(tolerance):
    kept = samples_to_keep(tolerance, 4)
    outcomes = [tolerance.samples.outcomes[run.point] for run in kept]
    assert sorted(map(outcomes.count, set(outcomes))) == [2, 2]
    failing = [run.point for run in kept if tolerance.samples.answers[run.point] is Answer.FAILS]
    squares = (tolerance.samples.offsets**2).sum(axis=1)
    assert min(squares[failing]) == min(squares[tolerance.samples.answers == Answer.FAILS])
    assert samples_to_keep(tolerance, 0) == []


def test_a_notebook_says_which_tolerance_to_tighten(table):
    assert "Tighten the tolerance of" in table._repr_html_()
    assert "<img" in table._repr_html_()


def test_a_tolerance_of_a_design_is_one_call(design, tmp_path):
    with pytest.raises(ff.InputError, match=r"tolerances\.facet\.thicknes: .*did you mean facet\.thickness"):
        ff.tolerance(design, tmp_path, tolerances={"facet.thicknes": "1 %"})


def test_points_stand_out_from_the_cells_behind_them_and_everything_is_in_the_legend(table):
    figure = draw_cloud(table)
    axes = figure.axes[0]

    def luminance(colour):
        return float(np.dot(to_rgb(colour), [0.2126, 0.7152, 0.0722]))

    cells = {to_hex(patch.get_facecolor()) for patch in axes.patches if patch.get_facecolor()[3]}
    failing = next(line for line in axes.lines if line.get_marker() == "x")
    assert failing.get_path_effects()  # a white edge
    assert min(luminance(cell) for cell in cells) - luminance(failing.get_color()) > 0.4
    named = [text.get_text() for text in figure.legends[0].get_texts()]
    assert named[-2:] == ["as designed", "the tolerances"]


def test_a_mark_that_is_not_drawn_is_not_in_the_legend(table):
    figure = draw_reaches(table)
    named = [text.get_text() for text in figure.legends[0].get_texts()]
    markers = {line.get_marker() for line in figure.axes[0].lines}
    assert ("undecided beyond" in named) == ("|" in markers)
    assert ("fails" in named) == ("x" in markers)
