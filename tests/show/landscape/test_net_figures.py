"""Figures, files and printed text of a net's landscape."""

import dataclasses
import json

import numpy as np
import pytest
from rich.console import Console
from scipy.spatial.transform import Rotation

from forficula.analysis.simulated_rests import rest_distances
from forficula.design import load_design
from forficula.show.folder.landscape_folder import landscape_drawings, landscape_kinds, write_landscape
from forficula.show.folder.presentation import folder_drawings
from forficula.show.landscape.barriers_figure import draw_barriers
from forficula.show.landscape.headline import headline
from forficula.show.landscape.landscape_table import landscape_table
from forficula.show.landscape.net_pictures import _aligned
from forficula.show.landscape.slow_paths_figure import draw_slow_paths
from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH
from forficula.statics import energy_landscape
from forficula.structure import structure_of
from forficula.study.running.runs import run
from tests.pyramid import SIDE, pyramid
from tests.show.legible import check_words

KINDS = ["states", "modes", "barriers", "courses"]


@pytest.fixture(scope="module")
def landscape():
    return energy_landscape(pyramid())


@pytest.fixture(scope="module")
def record():
    # a force that grows faster than most also causes the snap
    return run(pyramid(**{"crease.damping": 1e-4, "drive.push.rise": 0.2, "drive.pull.rise": 0.2}))


def printed(landscape, record=None):
    console = Console(width=110)
    with console.capture() as capture:
        console.print(landscape_table(landscape, record))
    return capture.get()


# the page-wide figure with the most words
@pytest.mark.parametrize(("kind", "width"), [*((kind, COLUMN_WIDTH) for kind in KINDS), ("courses", PAGE_WIDTH)])
def test_the_words_of_every_figure_can_be_read(landscape, kind, width):
    check_words(landscape_drawings(landscape)[kind](width), width)


def test_every_picture_is_below_the_middle_of_its_title(landscape):
    # the states have different sizes and positions
    for axes in landscape_drawings(landscape)["states"](PAGE_WIDTH).axes:
        (picture,) = axes.images
        left, right, low, high = picture.get_extent()
        pixel = abs(right - left) / picture.get_array().shape[1]
        assert np.mean(axes.get_xlim()) == pytest.approx((left + right) / 2, abs=2 * pixel)
        assert np.mean(axes.get_ylim()) == pytest.approx((low + high) / 2, abs=2 * pixel)


def test_every_kind_of_line_of_a_path_is_in_the_legend(landscape):
    figure = landscape_drawings(landscape)["courses"](PAGE_WIDTH)
    plots = [axes for axes in figure.axes if axes.get_xlabel()]
    looks = {
        (line.get_color(), line.get_linestyle())
        for axes in plots
        for line in axes.lines
        if line.get_marker() == "None" and line.get_color() != "0.8"  # the zero line
    }
    legend = figure.legends[0]
    named = {(handle.get_color(), handle.get_linestyle()) for handle in legend.legend_handles}
    assert looks <= named
    # dashes of a whole range and not of each of its steps
    unstable = [line for axes in plots for line in axes.lines if line.get_linestyle() == "--"]
    assert unstable
    assert min(len(line.get_xdata()) for line in unstable) > 2
    # panels have letters, and moments numbers
    assert [text.get_text() for axes in plots for text in axes.texts if text.get_weight() == "bold"] == ["A", "B"]
    assert {"1", "2"} <= {text.get_text() for text in plots[0].texts}


def test_barriers_are_drawn_with_contact_as_well(landscape):
    touching = dataclasses.replace(
        landscape.structure, contact=structure_of(load_design("letter-fold", {"protocol.contact": True})).contact
    )
    assert landscape_kinds(dataclasses.replace(landscape, structure=touching)) == tuple(KINDS)


def test_the_headline_names_barriers_between_states_of_the_protocol_first(landscape):
    other = dataclasses.replace(landscape.states[1], name="state 3", energy=1.0, withstands=())
    far = dataclasses.replace(landscape.passes[0], ends=(0, 2), barriers=(9.0, 8.0), energy=9.0)
    more = dataclasses.replace(landscape, states=(*landscape.states, other), passes=(*landscape.passes, far))
    barriers = [headline(shown).split("; ")[1] for shown in (landscape, more)]
    assert barriers[0] == barriers[1]
    assert "state 3" not in barriers[1]


def test_equilibria_at_a_stop_do_not_set_the_scale_of_the_strengths(landscape):
    """A crease at a rigid stop withstands a million times the torque of the snap."""
    course = landscape.courses[0]
    last = course.through.points[-1]
    points = (*course.through.points, dataclasses.replace(last, factor=1e6))
    stopped = dataclasses.replace(course, through=dataclasses.replace(course.through, points=points))
    figures = [
        draw_slow_paths(dataclasses.replace(landscape, courses=(shown, *landscape.courses[1:])))
        for shown in (course, stopped)
    ]
    limits = [figure.axes[0].get_ylim() for figure in figures]
    assert limits[0] == pytest.approx(limits[1])


def test_a_gap_without_a_saddle_is_named(landscape):
    apart = dataclasses.replace(landscape, passes=())
    words = [text.get_text() for text in draw_barriers(apart).axes[0].texts]
    assert words.count("no saddle\nfound") == len(landscape.states) - 1
    joined = [text.get_text() for text in draw_barriers(landscape).axes[0].texts]
    assert "no saddle\nfound" not in joined
    # energies of states and barriers have the unit of the axis
    assert all(" mJ" in text for text in joined)


def test_free_structures_are_turned_so_that_their_states_can_be_compared():
    free = np.array([[0.0, 0, 0], [1, 0, 0], [0, 2, 0], [0, 0, 0.5]])
    turn = Rotation.from_rotvec([0.3, -1.2, 0.8])
    assert _aligned(turn.apply(free) + np.array([4, 5, 6]), free) == pytest.approx(free)


def test_barriers_are_left_out_where_there_is_one_state():
    stiff = energy_landscape(pyramid(**{"crease.stiffness": 1.0}))
    assert len(stiff.states) == 1
    assert list(landscape_drawings(stiff)) == ["states", "modes", "courses"]


def test_the_table_has_states_barriers_drives_and_loads(landscape):
    text = printed(landscape)
    assert "pyramid: bistable, as far as the search found (up, down); barrier 0.4179 mJ from up to" in text
    assert "up to down" in text
    for words in ("push, on vertex 0", "snaps at 86.09 mN", "force push", "supports accelerated along −z"):
        assert words in text
    assert "there may be more than the 2 found." in " ".join(text.split())
    assert "nan" not in text


def test_the_run_is_set_beside_the_states(landscape, record):
    apart = rest_distances(landscape, record)
    assert set(apart) == {"up", "down", "up again"}
    assert max(apart.values()) < 1e-3 * SIDE
    assert "distances between vertices in the run differ" in " ".join(printed(landscape, record).split())


@pytest.mark.usefixtures("no_figures")
def test_a_folder_holds_figures_numbers_and_a_page(landscape, record, tmp_path):
    folder = tmp_path / "out"
    write_landscape(landscape, folder, record)
    written = json.loads((folder / "landscape.json").read_text("utf-8"))
    assert written["figures"] == KINDS
    assert [state["name"] for state in written["net"]["states"]] == ["up", "down"]
    assert set(written["rests_apart_m"]) == {"up", "down", "up again"}
    page = (folder / "report.html").read_text("utf-8")
    assert page.count("<img ") == len(KINDS)
    # above them the page plays the run
    assert '"kind":"run"' in page
    assert "Bistable, as far as the search found (up, down)" in page
    assert "http" not in page.replace("http-equiv", "").replace("http://www.w3.org", "")
    assert list(folder_drawings(folder)) == KINDS
