"""Figures, files and printed text of a net's landscape."""

import json

import pytest
from rich.console import Console

from forficula.analysis.simulated_rests import rest_distances
from forficula.show.folder.landscape_folder import landscape_drawings, write_landscape
from forficula.show.folder.presentation import folder_drawings
from forficula.show.landscape.landscape_table import landscape_table
from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH
from forficula.statics import energy_landscape
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
