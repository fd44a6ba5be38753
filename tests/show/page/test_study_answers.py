"""Answers of a study's page for points without kept runs, in a browser without network."""

import numpy as np
import pytest

from forficula.show.page.study_page import write_study_page
from tests.show.page.conftest import until

SECONDS = 90
SAID = "(document.querySelector('.answer .outcome')?.textContent ?? '')"


@pytest.fixture(scope="module")
def table(searched):
    return searched[1]


@pytest.fixture(scope="module")
def answering(watch_all, searched, tmp_path_factory):
    """The page of a small study that kept no run."""
    path = tmp_path_factory.mktemp("study") / "report.html"
    write_study_page(*searched, path, [], 0)
    assert path.stat().st_size < 5e6
    return watch_all(path)


def test_a_cell_without_a_run_is_simulated_on_request_with_the_study_s_outcome(answering, table):
    page = answering.page
    assert "This run was not kept" in page.locator("#run").inner_text()
    page.get_by_role("button", name="Simulate it here").click()
    for point, status in enumerate(str(value) for value in table["status"].values.ravel()):
        if point > 2:
            break
        page.evaluate("(point) => { forficula.open(point); }", point)
        until(page, f"(window.forficula.panel.answers.panel !== null) && {SAID}.includes(': {status}')", SECONDS)
        least = table["least_fold_torque"].values.ravel()[point]
        output = f"least fold torque {100 * least:g} N cm"
        assert (output in page.evaluate(SAID)) == bool(np.isfinite(least))
    # the live structure has the point's values
    shown = page.locator(".slider", has_text="Tendon rest length").locator("output").inner_text()
    assert shown == "4 cm"
    assert answering.messages == []


def test_only_the_last_of_several_requests_is_answered(answering):
    """Earlier requests are not started."""
    page = answering.page
    page.evaluate(
        """() => { const { panel } = forficula.panel.answers; const { ask } = panel.engine;
        window.asked = 0; panel.engine.ask = (message) => { window.asked += 1; return ask(message); };
        for (const point of [0, 1, 2, 3, 4, 1]) forficula.open(point); }"""
    )
    until(page, f"{SAID} !== 'Simulating …'", SECONDS)
    assert "tendon rest length 9 cm: " in page.evaluate(SAID)
    assert page.evaluate("window.asked") == 1
    assert answering.messages == []


def test_a_finer_map_around_a_point_comes_cell_by_cell_and_agrees_at_the_study_s_own_points(answering, table):
    page = answering.page
    page.evaluate("() => { forficula.open(0); }")
    until(page, f"{SAID} !== 'Simulating …'", SECONDS)
    page.get_by_role("button", name="Refine here").click()
    cells = page.locator(".answer .grid td[aria-label]")
    assert cells.count() == 9  # between two stiffnesses and two lengths
    until(page, "!document.querySelector('.answer .grid').textContent.includes('not simulated')", SECONDS)
    every = "[...document.querySelectorAll('.answer .grid td[aria-label]')]"
    until(page, f"{every}.every((cell) => cell.title !== '')", SECONDS)
    titles = [cell.get_attribute("title") for cell in cells.all()]
    words = table["status"].values.reshape(3, 2)
    for stiffness, length, status in (("10", "4", words[0, 0]), ("10", "9", words[0, 1]), ("30", "9", words[1, 1])):
        title = next(title for title in titles if f"{stiffness} N/cm" in title and f" {length} cm" in title)
        assert f": {status}" in title
    assert answering.messages == []
