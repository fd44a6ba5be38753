"""The structure of a run's page in the reader's hand, in a browser with the network cut."""

import base64
import re
import tomllib

import numpy as np
import pytest

from forficula.analysis import measure
from forficula.design import design_from_text, load_design, with_values
from forficula.dynamics import with_timestep
from forficula.show.page import write_run_page
from forficula.study.runs import run
from tests.show.page.conftest import SHORT, until
from tests.show.page.test_accessible_pages import ALL, asked

MOST = 5e6  # bytes of a page
SECONDS = 60  # for what takes a few, on a machine that is busy


@pytest.fixture(scope="module")
def fine_run():
    """The reference in half a second, at its own step: at twice that, what is opened while it swings may diverge."""
    return run(load_design("binder2025", SHORT | {"protocol.timestep": "0.2 ms"}))


@pytest.fixture(scope="module")
def fine_outcome(fine_run):
    return measure(fine_run)


@pytest.fixture(scope="module")
def page_with_engine(fine_run, fine_outcome, tmp_path_factory):
    path = tmp_path_factory.mktemp("trial") / "report.html"
    write_run_page(fine_run, fine_outcome, path)
    return path


@pytest.fixture(scope="module")
def trial(watch_all, page_with_engine):
    """The page with its panel open, at its fastest."""
    opened = watch_all(page_with_engine)
    press(opened)
    opened.page.get_by_label("speed").last.select_option("real time")
    return opened


def press(opened):
    opened.page.get_by_role("button", name="Try it").click()
    until(opened.page, "forficula.trial.panel !== null || forficula.trial.failed !== ''", SECONDS)


def do(opened, name):
    """Press a button of the panel and wait for what comes of it."""
    opened.page.get_by_role("button", name=name, exact=True).click()
    until(opened.page, "document.querySelector('.verdict').textContent !== ''", SECONDS)
    return opened.page.locator(".verdict").inner_text()


def begin_again(opened, **values):
    """The wing settled again with sliders at these shares of their ranges, the others as in the run."""
    page = opened.page
    back = page.get_by_role("button", name="All as in this run")
    if back.is_enabled():
        back.click()
    for name, value in values.items():
        slider = page.get_by_role("slider", name=name.replace("_", " ").capitalize(), exact=True)
        slider.fill(str(round(value * int(slider.get_attribute("max")))))
    return do(opened, "Start again")


def live_angles(opened):
    """Distal angles now, deg."""
    return np.degrees(opened.page.evaluate("forficula.trial.panel.frame.readings[0]"))


def test_a_page_with_its_engine_is_small_and_says_nothing_of_it_until_it_is_asked(watch, page_with_engine):
    assert page_with_engine.stat().st_size < MOST
    opened = watch(page_with_engine)
    assert opened.page.get_by_role("button", name="Try it").is_enabled()
    assert opened.page.evaluate("forficula.trial.panel") is None
    assert len(opened.page.context.pages) == 1
    assert opened.page.workers == []


def test_the_wing_folds_at_a_press_to_the_angles_of_the_summary_and_opens_again(trial, fine_outcome):
    assert begin_again(trial) == "Settled."
    pace = trial.page.get_by_label("speed").last
    pace.select_option("1/20")
    trial.page.get_by_role("button", name="Fold", exact=True).click()
    # told before it has come to rest
    told = "/fold reached its goal in [0-9.]+ ms/.test(document.querySelector('.trial .time').textContent)"
    until(trial.page, told, SECONDS)
    pace.select_option("real time")
    until(trial.page, "document.querySelector('.verdict').textContent !== ''", SECONDS)
    said = trial.page.locator(".verdict").inner_text()
    assert re.fullmatch(r"The wing folded in \d+(\.\d+)? ms for \d\.\d+ J of work\.", said)
    stated = np.degrees(fine_outcome.states["folded"].readings["distal_angle"].mean)
    assert live_angles(trial) == pytest.approx(stated, abs=6)  # of a fold that still swings there
    said = do(trial, "Unfold")
    assert said.startswith("The wing opened again in ")
    stated = np.degrees(fine_outcome.states["opened"].readings["distal_angle"].mean)
    assert live_angles(trial) == pytest.approx(stated, abs=0.5)


def test_the_whole_protocol_ends_with_the_numbers_of_the_run(trial, fine_run, fine_outcome):
    begin_again(trial)
    trial.page.get_by_role("button", name="Whole protocol").click()
    until(trial.page, "(forficula.trial.panel.frame.ended?.stages.length ?? 0) === 5", SECONDS)
    until(trial.page, "forficula.trial.panel.frame.stageNumber === null", SECONDS)
    ended = trial.page.evaluate("forficula.trial.panel.frame.ended")
    assert ended["status"] == fine_outcome.status
    for stage, end in zip(ended["stages"], fine_run.stages, strict=True):
        assert stage["end_s"] == pytest.approx(end.end, abs=1e-4)
    stated = np.degrees(fine_outcome.states["folded"].readings["distal_angle"].mean)
    assert np.degrees(ended["stages"][2]["readings"][0]) == pytest.approx(stated, abs=0.01)


def test_a_setting_that_sticks_says_so_and_what_to_try(trial):
    begin_again(trial, fold_torque=0)
    assert do(trial, "Fold") == "Did not fold."
    assert "Raise protocol.fold_torque" in trial.page.locator(".trial .note").first.inner_text()
    assert live_angles(trial).min() > -5


def test_a_setting_comes_out_as_the_design_file_that_has_it(trial, fine_run):
    begin_again(trial, tendon_stiffness=0.7, fold_torque=0.5)
    changes = trial.page.evaluate("forficula.trial.panel.sliders.changes")
    assert set(changes) == {"tendon.stiffness", "protocol.fold_torque"}
    address = trial.page.get_by_role("link", name="This setting as a design file").get_attribute("href")
    text = base64.b64decode(address.partition("base64,")[2]).decode()
    tomllib.loads(text)
    assert design_from_text(text).hash == with_values(fine_run.design, changes).hash


def test_sliders_have_a_mark_where_the_run_is_and_go_back_there(trial):
    begin_again(trial, tendon_stiffness=0.9)
    slider = trial.page.locator(".slider", has_text="Tendon stiffness")
    assert "changed" in slider.get_attribute("class")
    mark, thumb = slider.locator(".home").bounding_box(), slider.locator("input").bounding_box()
    trial.page.get_by_role("button", name="All as in this run").click()
    assert slider.locator("output").inner_text() == "10 N/cm"
    share = int(slider.locator("input").input_value()) / int(slider.locator("input").get_attribute("max"))
    assert mark["x"] + 1 == pytest.approx(thumb["x"] + 8 + share * (thumb["width"] - 16), abs=1.5)


def test_a_tip_that_is_pushed_moves_and_comes_back_when_it_is_left(trial):
    begin_again(trial)
    page = trial.page
    page.locator("#try canvas").scroll_into_view_if_needed()
    place = page.evaluate(
        """() => { const { live, stage } = forficula.trial.panel; const { canvas, eye } = stage;
        const points = Array.from(live.frame.points); let far = 0;
        const away = (at) => Math.hypot(points[at], points[at + 1]);
        for (let at = 0; at < points.length; at += 3) if (live.movable[at / 3] && away(at) > away(far)) far = at;
        const seen = eye.controls.target.clone().fromArray(points, far).project(eye.camera);
        const box = canvas.getBoundingClientRect();
        return [box.x + (seen.x + 1) / 2 * box.width, box.y + (1 - seen.y) / 2 * box.height, far]; }"""
    )
    before = np.array(page.evaluate("Array.from(forficula.trial.panel.frame.points)"))
    page.mouse.move(*place[:2])
    page.mouse.down()
    page.mouse.move(place[0], place[1] - 80, steps=4)
    page.wait_for_timeout(600)
    assert page.locator(".pushed").inner_text().startswith("pushed with ")
    pushed = np.array(page.evaluate("Array.from(forficula.trial.panel.frame.points)"))
    page.mouse.up()
    assert np.abs(pushed - before).max() > 0.005
    assert page.locator(".pushed").inner_text() == ""


def test_the_panel_says_nothing_on_the_console_and_asks_for_nothing(trial):
    assert trial.messages == []
    assert [url for url in trial.requests if not url.startswith(("file:", "data:", "blob:"))] == []


def test_a_structure_that_the_engine_moves_otherwise_is_told_with_the_reason(watch, tmp_path):
    stage = {"name": "settle", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "2 ms"}
    record = run(with_timestep(load_design("binder2025-built", {"protocol.stages": [stage]})))
    write_run_page(record, measure(record), tmp_path / "report.html")
    assert (tmp_path / "report.html").stat().st_size < MOST / 2
    opened = watch(tmp_path / "report.html")
    assert opened.page.get_by_role("button", name="Try it").is_disabled()
    assert "it moves in air or water" in opened.page.locator("#try").inner_text()


def test_a_page_without_its_engine_offers_nothing(fine_run, fine_outcome, tmp_path):
    write_run_page(fine_run, fine_outcome, tmp_path / "report.html", engine=False)
    text = (tmp_path / "report.html").read_text("utf-8")
    assert "wasm-unsafe-eval" not in text.partition("<title>")[0]
    assert 'id="try"' not in text


@pytest.mark.parametrize("size", [(1280, 800), (390, 844)])
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_in_the_open_panel_and_it_fits_its_window(trial, size, scheme):
    trial.show(*size, scheme=scheme)
    wrong, _ = asked(trial.page, ALL)
    assert wrong == []
    assert trial.page.evaluate("document.documentElement.scrollWidth") <= size[0]
    trial.show()


def test_sliders_and_buttons_act_by_the_keyboard(trial):
    begin_again(trial)
    page = trial.page
    slider = page.get_by_role("slider", name="Tendon stiffness")
    slider.focus()
    page.keyboard.press("ArrowRight")
    assert page.evaluate("forficula.trial.panel.sliders.changes")["tendon.stiffness"] > 1000
    assert "N/cm" in slider.get_attribute("aria-valuetext")
    page.get_by_role("button", name="Fold", exact=True).focus()
    page.keyboard.press("Enter")
    until(page, "document.querySelector('.verdict').textContent !== ''", SECONDS)
    assert page.locator(".verdict").inner_text().startswith("The wing folded in")
