"""Every kind of page in a second browser, without network: `make browsers`, before a release."""

import json
import os

import numpy as np
import pytest

from tests.show.page.firefox import INSTALL, firefox_path, running
from tests.show.page.page_kinds import KINDS, MOVING
from tests.show.page.test_workbench_page import POINTER
from tests.workbench.serving import serving

WIDE, NARROW = (1280, 800), (390, 844)
WHY = "pages are not tested in a second browser"
_WEBGL = "!!document.createElement('canvas').getContext('webgl2')"
_DRAWN = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))"
# pixels of each plot that are not empty
_INKS = """[...document.querySelectorAll('.chart canvas')].map((canvas) => {
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  let ink = 0;
  for (let at = 3; at < data.length; at += 4) ink += data[at] > 0;
  return ink; })"""
_CLOCK = "(window.forficula.clock ?? window.forficula.panel.playing.clock)"


# saves a minute in every run of the tests, for code that changes rarely
pytestmark = pytest.mark.skipif(
    os.environ.get("FORFICULA_EVERY_BROWSER") != "1", reason=f"{WHY}: that is make browsers, before a release"
)


@pytest.fixture(scope="module", params=["light", "dark"])
def firefox(request, tmp_path_factory):
    program = firefox_path()
    if not program:
        pytest.fail(f"Firefox is missing; install it, as with: {INSTALL}, or name it in FORFICULA_FIREFOX: {WHY}")
    with running(program, tmp_path_factory.mktemp("firefox") / "profile", request.param) as firefox:
        yield firefox


def requests_of(firefox):
    """Return the addresses that a page requested, except data in the page itself."""
    return [url for url in firefox.requests if not url.startswith(("file:", "data:", "blob:"))]


@pytest.mark.parametrize("kind", KINDS)
def test_every_page_opens_without_a_request_or_a_word_on_the_console_and_fits_its_window(firefox, pages, kind):
    for width, height in (WIDE, NARROW):
        firefox.open(pages[kind], width, height)
        assert firefox.evaluate("document.querySelector('#data') === null || window.forficula !== undefined")
        firefox.evaluate(_DRAWN)
        assert firefox.evaluate("document.documentElement.scrollWidth") <= width
        assert (firefox.messages, requests_of(firefox)) == ([], [])


@pytest.mark.parametrize("kind", MOVING)
def test_plots_and_the_structure_are_drawn_and_play_moves_them(firefox, pages, kind):
    firefox.open(pages[kind], *WIDE)
    firefox.evaluate(_DRAWN)
    assert all(ink > 1000 for ink in firefox.evaluate(_INKS))
    without = kind in ("drawn study", "parts")
    assert firefox.evaluate("document.querySelectorAll('.chart canvas').length") >= (not without)
    if kind == "curves":
        _moves_by_slider(firefox)
    if kind == "drawn study":  # has no run
        return
    if not firefox.evaluate(_WEBGL):
        assert "This browser has no WebGL" in firefox.evaluate("document.querySelector('.player').textContent")
        pytest.fail(f"Firefox has no WebGL here; by {INSTALL} the processor draws: {WHY}")
    if kind == "curves":  # have no run
        return
    before = np.asarray(firefox.picture(".stage"), dtype=int)
    assert len(np.unique(before.reshape(-1, 3), axis=0)) > 200
    firefox.click(".play")
    firefox.until(f"{_CLOCK}.time > {_CLOCK}.span.start + 0.1 * ({_CLOCK}.span.end - {_CLOCK}.span.start)")
    firefox.click(".play")
    firefox.evaluate(_DRAWN)
    assert not firefox.evaluate(f"{_CLOCK}.playing")
    moved = np.abs(np.asarray(firefox.picture(".stage"), dtype=int) - before).max(axis=2) > 16
    assert moved.mean() > 0.01
    assert (firefox.messages, requests_of(firefox)) == ([], [])


def _traces(firefox):
    """Check that a picture is read, that its junctions are found, and that an edge between two of them is drawn."""
    firefox.evaluate("""new Promise((done) => {
        const canvas = Object.assign(document.createElement("canvas"), { width: 400, height: 300 });
        const pen = canvas.getContext("2d");
        pen.fillStyle = "white", pen.fillRect(0, 0, 400, 300);
        pen.lineWidth = 4, pen.strokeRect(50, 50, 300, 200);
        canvas.toBlob((blob) => done(window.forficula.tracing.take(new File([blob], "sketch.png"))));
    })""")
    said = "document.querySelector('.trace-said').textContent"
    assert firefox.evaluate(said) == "Clicks snap to 4 junctions of lines and corners."
    firefox.evaluate("document.getElementById('tab-trace').click()")
    firefox.evaluate(f"({POINTER})(['touch', [[54, 48], [200, 60], [347, 53]]])")
    drawn = firefox.evaluate("window.forficula.tracing.history.pattern")
    assert drawn["edges"] == [[0, 1]]
    assert np.allclose(drawn["vertices"], [[49.5, 49.5], [349.5, 49.5]], atol=0.5)


def _moves_by_slider(firefox):
    """Check that the slider of a fold moves the structure, its energy and the ball on the curve of the energy."""
    state = """JSON.stringify([document.querySelector('.time').textContent, forficula.plots.charts[0].over
        .querySelector('.ball').style.transform, Array.from(forficula.player?.stage?.views[0].shape.vertices ?? [])])"""
    before = firefox.evaluate(state)
    firefox.evaluate(
        "document.querySelector('.track input').value = 6000,"
        " document.querySelector('.track input').dispatchEvent(new Event('input'))"
    )
    firefox.until("Math.abs(forficula.clock.time - 60) < 0.1")
    firefox.evaluate(_DRAWN)
    after = firefox.evaluate(state)
    (text, ball, vertices), (later_text, later_ball, later_vertices) = json.loads(before), json.loads(after)
    assert (later_text.startswith("60.0 %"), text != later_text, ball != later_ball) == (True, True, True)
    if firefox.evaluate(_WEBGL):
        assert vertices != later_vertices


def test_what_a_page_should_not_do_is_heard(firefox, tmp_path):
    """Control: if the console or the network were not observed, the other tests could not fail."""
    (tmp_path / "bad.html").write_text(
        "<!doctype html><title>bad</title><script>console.error('said'); fetch('http://example.invalid/')"
        ".catch(() => { window.cut = true; }); setTimeout(() => nothing.at.all);</script>",
        "utf-8",
    )
    firefox.open(tmp_path / "bad.html", *WIDE)
    firefox.until("window.cut === true")
    assert requests_of(firefox) == ["http://example.invalid/"]
    assert [text for text in firefox.messages if "said" in text]
    assert [text for text in firefox.messages if "nothing is not defined" in text]


def test_a_workbench_builds_what_is_changed_and_keeps_the_last_good_model(firefox, tmp_path):
    with serving("binder2025", folder=tmp_path) as served:
        firefox.open(served.invitation(), *WIDE)
        firefox.until("window.forficula !== undefined")
        field = "document.querySelector('[data-key=\"pattern.units\"]')"

        def put(text):
            firefox.evaluate(f"{field}.value = '{text}', {field}.dispatchEvent(new Event('change'))")
            firefox.evaluate("window.forficula.idle()")

        put("2")
        assert firefox.evaluate("window.forficula.wing.panel.frame.readings[0].length") == 5
        put("0")
        assert firefox.evaluate("document.querySelector('.field.rejected .wrong').textContent").startswith(
            "pattern.units: need >= 1"
        )
        assert firefox.evaluate("window.forficula.wing.panel.frame.readings[0].length") == 5
        _traces(firefox)
        assert firefox.messages == []
        origin = served.address.rpartition("/")[0].rpartition("/")[0]
        assert all(url.startswith((f"{origin}/", "data:", "blob:")) for url in firefox.requests)
