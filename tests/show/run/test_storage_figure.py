"""Figures of a run that waits: the wait is marked, and the pull is drawn over seconds to days."""

import numpy as np
import pytest

import forficula as ff
from forficula.analysis.storage import storages
from forficula.show import draw_angles
from forficula.show.folder.run_folder import run_drawings
from forficula.show.page.run_page import run_page
from forficula.show.run.outcome_table import print_storage
from forficula.show.run.storage_figure import draw_storage
from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH
from tests.show.legible import check_words


@pytest.mark.parametrize(
    ("kind", "width"),
    [*((kind, COLUMN_WIDTH) for kind in ("storage", "angles", "energy")), ("storage", PAGE_WIDTH)],
)
def test_the_words_of_its_figures_can_be_read(stored_run, kind, width):
    check_words(run_drawings(stored_run, ff.measure(stored_run))[kind](width), width)


def test_the_pull_is_drawn_over_the_time_at_rest(stored_run):
    folded, opened = draw_storage(stored_run).axes
    assert [axes.get_title() for axes in (folded, opened)] == ["store folded: 30 d", "leave open: 30 d"]
    wait = storages(stored_run)[1]
    for tendon, line in enumerate(opened.lines):
        time, pull = line.get_data()
        assert time[-1] == pytest.approx(30 * 86400, rel=1e-6)
        assert pull == pytest.approx(wait.pulls[:, tendon])
        assert np.all(np.diff(pull) <= 1e-3 * pull[0])
    assert [text.get_text() for text in opened.get_xticklabels()] == ["1 s", "1 min", "1 h", "1 d", "30 d"]


def test_a_wait_is_marked_on_the_axis_of_the_run(stored_run):
    whole = draw_angles(stored_run, ff.measure(stored_run)).axes[0]
    assert [text.get_text() for text in whole.texts].count("30 d") == 2


def test_a_run_without_a_wait_has_no_such_figure(reference_run, reference_outcome):
    assert "storage" not in run_drawings(reference_run, reference_outcome)


def test_terminal_and_page_say_what_the_month_did(stored_run, capsys):
    outcome = ff.measure(stored_run)
    print_storage(stored_run, outcome)
    output = " ".join(capsys.readouterr().out.split())
    # 19 %, as in the documentation
    assert "After 30 d opened its tendons pull 19" in output
    assert "Then it opened again." in output
    assert "After 30 d opened its tendons pull 19" in run_page(stored_run, outcome)
