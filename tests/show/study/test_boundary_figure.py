"""Figures and pages of located boundaries: cells of different size, boundary lines and the points that ran."""

from __future__ import annotations

import io

import numpy as np
import pytest
from matplotlib.collections import LineCollection, PathCollection, PolyCollection

from forficula.show.page.study_page import study_page
from forficula.show.study.boundary_figure import boundary_shapes, draw_boundary_map
from forficula.show.study.maps import map_drawings
from forficula.show.study.study_table import print_study
from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH, description
from forficula.study import load_study, run_study
from forficula.study.refine.summary import boundary_text
from tests.planted import folds_if, soft

GRID = '"tendon.stiffness" = "10..60 N/cm step 10"\n"tendon.rest_length" = "0..9 cm step 1"'
THREE = GRID.replace("step 10", "step 25").replace("step 1", "step 3") + '\n"vein.diameter" = ["3 mm", "5 mm"]'


@pytest.fixture(scope="module")
def refined(tmp_path_factory, write_study_file):
    """Tables of planted boundaries, by the text of the factors and the sampling."""

    def run(factors, sampling=""):
        folder = tmp_path_factory.mktemp("refined")
        tail = f'[sampling]\nmethod = "refine"\n{sampling}'
        return run_study(
            load_study(write_study_file(folder / "s.toml", factors, "", tail)), folder, cluster=folds_if(soft)[0]
        )

    return run


@pytest.fixture(scope="module")
def table(refined):
    return refined(GRID)


def collections(axes, kind):
    return [item for item in axes.collections if isinstance(item, kind)]


def test_a_marker_is_drawn_for_every_point_and_none_for_a_position_without_one(table):
    (axes,) = draw_boundary_map(table).axes
    drawn = np.concatenate([item.get_offsets() for item in collections(axes, PathCollection)])
    points = np.column_stack([100 * table["tendon_rest_length"].values, table["tendon_stiffness"].values / 100])
    assert sorted(drawn.round(6).tolist()) == sorted(points.round(6).tolist())


def test_a_map_of_two_points_has_a_region(refined):
    table = refined('"tendon.stiffness" = ["60 N/cm", "70 N/cm"]', "most_points = 2")
    (axes,) = draw_boundary_map(table).axes
    (region,) = collections(axes, PolyCollection)[0].get_paths()
    assert region.vertices[:, 0].min() == pytest.approx(60)
    assert region.vertices[:, 0].max() == pytest.approx(70)


def test_the_boundary_line_is_where_the_outcome_changes(table):
    (axes,) = draw_boundary_map(table).axes
    (lines,) = collections(axes, LineCollection)
    ends = np.concatenate(lines.get_segments())
    assert np.abs(ends[:, 1] - (12.3 + 4.1 * ends[:, 0])).max() < 1.0
    assert [ends[:, 0].min(), ends[:, 0].max()] == pytest.approx([0, 9])


def test_the_map_of_the_page_has_the_cells_and_boundaries_of_the_figure(table, refined):
    drawn = boundary_shapes(table)
    assert (drawn.x, drawn.y) == (1, 0)
    ends = np.array([end for line in drawn.lines for end in line])
    assert np.abs(ends[:, 1] - (12.3 + 4.1 * ends[:, 0])).max() < 1.0
    sides = np.array([[*corners[0], *corners[2]] for corners in drawn.cells])
    assert np.sum((sides[:, 2] - sides[:, 0]) * (sides[:, 3] - sides[:, 1])) == pytest.approx(9 * 50)
    assert boundary_text(table) == "boundary between outcomes"
    # the points of three factors lie in many planes
    assert boundary_shapes(refined(THREE, "divisions = 5")) is None


def test_regions_fill_the_map_without_overlap(table):
    (axes,) = draw_boundary_map(table).axes
    filled = [
        item for item in collections(axes, PolyCollection) if len(item.get_facecolor()) and item.get_alpha() == 0.55
    ]
    area = 0.0
    for item in filled:
        for path in item.get_paths():
            x, y = path.vertices.T
            area += abs(np.dot(x[:-1], y[1:]) - np.dot(x[1:], y[:-1])) / 2
    assert area == pytest.approx(9 * 50, rel=1e-6)


def test_each_value_of_a_third_factor_has_a_panel(refined):
    three = refined(THREE, "divisions = 5")
    figure = draw_boundary_map(three)
    assert [axes.get_title() for axes in figure.axes] == ["vein diameter 3 mm", "vein diameter 5 mm"]
    assert list(map_drawings(three)) == ["boundaries"]


def test_a_single_factor_is_a_strip(refined):
    one = refined('"tendon.stiffness" = ["10 N/cm", "40 N/cm", "160 N/cm"]', 'logarithmic = ["tendon.stiffness"]')
    (axes,) = draw_boundary_map(one).axes
    assert axes.get_xscale() == "log"
    assert [tick.get_text() for tick in axes.get_xticklabels()] == ["10", "40", "160"]
    assert axes.get_yticks().size == 0


@pytest.mark.parametrize("width", [COLUMN_WIDTH, PAGE_WIDTH])
def test_the_figure_has_a_legend_and_a_description(table, width):
    figure = draw_boundary_map(table, width=width)
    figure.savefig(io.BytesIO())
    texts = [text.get_text() for text in figure.legends[0].get_texts()]
    assert any(text.endswith("points)") for text in texts)
    assert "boundary, straight in each cell" in texts
    assert "of 4641 of the full grid" in description(figure)
    assert figure.get_figwidth() <= width


def test_the_page_and_the_terminal_state_the_conclusions(table, capsys):
    page = study_page(table.study, table, (), 0, engine=False)
    print_study(table.study, table)
    printed = " ".join(capsys.readouterr().out.split())
    for text in ("4641 points of the full grid", "An island of another result is missed if it contains no point"):
        assert text in page
        assert text in printed
    assert "tendon.stiffness, initial grid" in page
    assert "values drawn" not in page
