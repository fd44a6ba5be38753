import base64
import re
import tomllib

import pytest

from forficula.design import design_from_text, with_values
from forficula.show.page import write_run_page
from tests.show.page.live_wing import SMALL, LiveWing, write_wing
from tests.show.page.test_accessible_pages import ALL, violations

MOST = 5e6  # bytes of a page
WINDOW = {"width": 500, "height": 500}  # pixels of a window that is drawn quickly


@pytest.fixture(scope="module")
def diverging_page(tmp_path_factory):
    """The page of a design whose timestep is too long, with or without drives."""
    path = tmp_path_factory.mktemp("diverging") / "report.html"
    write_wing(path, {"protocol.timestep": "3 ms"})
    return path


@pytest.fixture(scope="module")
def one_page(watch_all, recorded):
    """The page with its panel open, at its fastest."""
    opened = watch_all(recorded[-1], viewport=WINDOW)
    opened.live = LiveWing(opened.page.evaluate)
    opened.top_when_pressed = opened.evaluate("document.querySelector('.trial').getBoundingClientRect().top")
    return opened


@pytest.fixture
def trial(one_page):
    one_page.settle()
    yield one_page
    one_page.live.rest()


def begin_again(opened, shares=None):
    """Let the wing settle again with sliders at shares of their ranges, by key, and others as in the run."""
    opened.live.slide(shares)
    assert opened.live.do("Start again") == "Settled."


def test_a_page_with_the_engine_is_small_and_starts_it_only_on_request(watch, context, recorded):
    assert recorded[-1].stat().st_size < MOST
    others = len(context.pages)
    opened = watch(recorded[-1])
    assert opened.page.get_by_role("button", name="Try it").is_enabled()
    assert opened.page.evaluate("forficula.trial.panel") is None
    assert len(context.pages) == others + 1
    assert opened.page.workers == []


def test_folding_is_reported_before_rest(trial):
    begin_again(trial)
    trial.page.get_by_label("speed").last.select_option("1/20")
    trial.live.press("Fold")
    trial.live.until("/fold reached its goal in [0-9.]+ ms/.test(document.querySelector('.trial .time').textContent)")
    assert trial.page.locator(".verdict").inner_text() == ""
    trial.page.get_by_label("speed").last.select_option("real time")
    trial.live.until("document.querySelector('.verdict').textContent !== ''")
    said = trial.page.locator(".verdict").inner_text()
    assert re.fullmatch(r"The wing folded in \d+(\.\d+)? ms for \d\.\d+ J of work\.", said)


def test_changes_and_pushes_are_reported_as_different_from_a_run_of_the_file(trial):
    """The file has the final values, from the start."""
    note = trial.page.locator(".trial .note").first
    begin_again(trial, {"tendon.stiffness": 0.7})
    trial.live.do("Whole protocol")
    assert note.inner_text() == ""
    speed = trial.page.get_by_label("speed").last
    speed.select_option("1/20")
    trial.live.press("Whole protocol")
    trial.live.until("window.forficula.trial.panel.frame.stage === 'fold'")
    trial.live.put("tendon.stiffness", 0.6)
    speed.select_option("real time")
    trial.live.until("document.querySelector('.verdict').textContent !== ''")
    assert "which no run of a design file repeats" in note.inner_text()
    begin_again(trial)
    assert note.inner_text() == ""
    # a torque that does not act yet does not change the motion so far
    trial.live.put("protocol.fold_torque", 0.5)
    assert trial.live.do("Fold").startswith("The wing folded in")
    assert note.inner_text() == ""
    begin_again(trial)
    trial.page.evaluate("forficula.trial.panel.engine.send({ act: 'push', point: 5, force: [0, 0, 1] })")
    trial.page.evaluate("forficula.trial.panel.engine.send({ act: 'push', point: 0, force: null })")
    trial.live.do("Fold")
    assert "which no run of a design file repeats" in note.inner_text()


def test_a_diverged_simulation_stays_diverged_until_a_restart(watch, diverging_page):
    """Release, changes and pushes have no effect, and the simulator still replies."""
    opened = watch(diverging_page, viewport=SMALL)
    live = LiveWing(opened.page.evaluate)
    push = "forficula.trial.panel.engine.send({ act: 'push', point: 5, force: [0, 0, 1] })"
    for act in (
        lambda: live.press("Release"),
        lambda: live.put("protocol.gravity", 0.5),
        lambda: opened.page.evaluate(push),
    ):
        assert live.do("Whole protocol").startswith("Diverged at t = ")
        act()
        opened.page.wait_for_timeout(300)
        live.until("document.querySelector('.verdict').textContent !== ''")
        assert opened.page.locator(".verdict").inner_text().startswith("Diverged at t = ")
        assert live.do("Fold").startswith("Diverged at t = ")


def test_settings_are_saved_as_a_design_file(trial, recorded):
    begin_again(trial, {"tendon.stiffness": 0.7, "protocol.fold_torque": 0.5})
    changes = trial.live.changes
    assert set(changes) == {"tendon.stiffness", "protocol.fold_torque"}
    address = trial.page.get_by_role("link", name="This setting as a design file").get_attribute("href")
    text = base64.b64decode(address.partition("base64,")[2]).decode()
    tomllib.loads(text)
    assert design_from_text(text).hash == with_values(recorded[0].design, changes).hash


def test_sliders_mark_the_values_of_the_run_and_can_be_reset(trial):
    begin_again(trial, {"tendon.stiffness": 0.9})
    slider = trial.page.locator(".slider", has_text="Tendon stiffness")
    assert "changed" in slider.get_attribute("class")
    mark, thumb = slider.locator(".home").bounding_box(), slider.locator("input").bounding_box()
    trial.page.get_by_role("button", name="Reset all to this run").click()
    assert slider.locator("output").inner_text() == "10 N/cm"
    share = int(slider.locator("input").input_value()) / int(slider.locator("input").get_attribute("max"))
    assert mark["x"] + 1 == pytest.approx(thumb["x"] + 8 + share * (thumb["width"] - 16), abs=1.5)


def test_a_pushed_tip_returns_when_it_is_released(trial):
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
    page.evaluate("window.rest = Array.from(forficula.trial.panel.frame.points)")
    page.mouse.move(*place[:2])
    page.mouse.down()
    page.mouse.move(place[0], place[1] - 80, steps=4)
    trial.live.until(
        "forficula.trial.panel.frame.points.some((at, index) => Math.abs(at - window.rest[index]) > 0.005)"
    )
    assert page.locator(".pushed").inner_text().startswith("pushed with ")
    page.mouse.up()
    assert page.locator(".pushed").inner_text() == ""


def test_a_page_without_its_engine_offers_nothing(recorded, tmp_path):
    write_run_page(*recorded[:2], tmp_path / "report.html", engine=False)
    text = (tmp_path / "report.html").read_text("utf-8")
    assert "wasm-unsafe-eval" not in text.partition("<title>")[0]
    assert 'id="try"' not in text


@pytest.mark.parametrize(("size", "scheme"), [((1280, 800), "light"), ((390, 844), "dark")])
def test_axe_finds_nothing_in_the_open_panel_and_it_fits_its_window(trial, size, scheme):
    trial.live.rest()
    trial.show(*size, scheme=scheme)
    wrong, _ = violations(trial.page, ALL)
    assert wrong == []
    assert trial.page.evaluate("document.documentElement.scrollWidth") <= size[0]
    trial.show(**WINDOW)


def test_the_panel_is_in_view_when_it_is_opened(trial):
    assert 0 <= trial.top_when_pressed < 100


def test_on_a_phone_the_picture_stays_in_view_beside_its_sliders(trial):
    trial.show(390, 844)
    trial.page.locator(".trial").evaluate("(panel) => panel.scrollIntoView({ block: 'start' })")
    assert trial.page.locator(".trial .slider").first.bounding_box()["y"] < 700
    last = trial.page.locator(".trial .slider").last
    last.evaluate("(slider) => slider.scrollIntoView({ block: 'end' })")
    picture, slider = trial.page.locator(".trial .stage").bounding_box(), last.bounding_box()
    assert picture["y"] >= 0
    assert picture["y"] + picture["height"] < slider["y"] < 844
    trial.show(**WINDOW)


def test_sliders_and_buttons_act_by_the_keyboard(trial):
    begin_again(trial)
    page = trial.page
    slider = page.get_by_role("slider", name="Tendon stiffness")
    slider.focus()
    page.keyboard.press("ArrowRight")
    assert trial.live.changes["tendon.stiffness"] > 1000
    assert "N/cm" in slider.get_attribute("aria-valuetext")
    page.get_by_role("button", name="Fold", exact=True).focus()
    page.keyboard.press("Enter")
    trial.live.until("document.querySelector('.verdict').textContent !== ''")
    assert page.locator(".verdict").inner_text().startswith("The wing folded in")
