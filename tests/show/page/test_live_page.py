"""Page of a design whose structure a reader moves, in a browser without network."""

import numpy as np
import pytest

from forficula.cli import main
from forficula.design import load_design
from forficula.errors import InputError
from forficula.show.page.live_page import live_page
from tests.show.page.conftest import until

SECONDS = 60


@pytest.fixture(scope="module")
def bench(watch_all, tmp_path_factory):
    """The page that the command line writes for a sheet of three panels."""
    path = tmp_path_factory.mktemp("bench") / "letter.html"
    main(["open", "letter-fold", "--set", "tendon.0.stiffness=0.6 N/cm", "--out", str(path)])
    opened = watch_all(path)
    until(opened.page, "forficula.trial.panel !== null || forficula.trial.failed !== ''", SECONDS)
    opened.page.get_by_label("speed").select_option("real time")
    return opened


def test_a_sheet_closes_in_a_page_without_a_run(bench):
    page = bench.page
    assert page.locator("#player").count() == 0
    assert page.locator(".slider", has_text="Tendon 0 stiffness").locator("output").inner_text() == "0.6 N/cm"
    until(page, "document.querySelector('.verdict').textContent === 'Settled.'", SECONDS)
    page.get_by_role("button", name="Close", exact=True).click()
    until(page, "document.querySelector('.verdict').textContent !== ''", SECONDS)
    assert page.locator(".verdict").inner_text().startswith("The structure got closed in ")
    assert np.degrees(page.evaluate("forficula.trial.panel.frame.readings[0]")).min() > 90
    assert bench.messages == []


def test_a_structure_that_the_page_cannot_simulate_is_refused_with_the_command_that_can():
    with pytest.raises(InputError, match=r"miura-sheet: cannot be moved in a page: .*forficula run miura-sheet"):
        live_page(load_design("miura-sheet"))
