"""Accessibility of every kind of page: WCAG 2.2, levels A and AA, by vision, keyboard and screen reader."""

import json

import pytest
from axe_playwright_python.base import AXE_SCRIPT

from tests.show.page.conftest import until, watching
from tests.show.page.keyboard import SEEN, try_controls, walk
from tests.show.page.page_kinds import KINDS

WIDE, NARROW = (1280, 600), (390, 844)
TAGS = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"]
# Contrast depends on the scheme; scrolling and the size of targets depend on the width. All rules are checked in a wide
# light window and these rules on a dark phone, so every rule is checked wherever its result can differ. A
# wide window displays all columns of the tables, without which contrast is not reported; their colours are the same
# on a phone.
ALL = {"runOnly": {"type": "tag", "values": TAGS}, "rules": {"target-size": {"enabled": True}}}
DARK_PHONE = {"runOnly": {"type": "rule", "values": ["color-contrast", "scrollable-region-focusable", "target-size"]}}
# Colours that axe does not check: signs that are not letters, and letters on a picture, a pattern or a band. The
# style's contrasts are checked in test_page.py, and maps write their signs on a plain background.
UNTOLD = ".stage, .what, .grid, .tick, .views, .scatter, .ball, .map-legend, .map-place, .filter, .drawn"

FAULTS = """(() => {
  const main = document.querySelector("main");
  main.insertAdjacentHTML("beforeend", "<button></button>");
  main.querySelector("img").removeAttribute("alt");
  document.querySelector("p").style.color = "#565d66"; // that of a light page
  main.querySelector(".table").removeAttribute("tabindex"); })()"""
# Pages with the parts of another kind, which have its phone layout, dark colours and order of controls.
SAME_PARTS = ("curves", "drawn study", "converge", "tolerance", "identify")
# the player is the same on every page: it is tested completely on the page of a run
TRIED_ELSEWHERE = {
    "compare": ".transport, .keys",
    **dict.fromkeys(("landscape", "parts", "optimise", "tolerance"), ".player"),
    **dict.fromkeys(("study", "drawn study"), ".player, .answer"),
}
LEAST_TRIED = {
    "run": {
        *("CANVAS", "BUTTON play", "INPUT time", "BUTTON b folded", "SELECT speed", "SELECT show", "BUTTON turn left"),
        *("BUTTON top: view from above", "BUTTON nearer", "SUMMARY Keys", "A Download design.toml"),
        *("BUTTON motion", "BUTTON fold"),
    },
    "compare": {"BUTTON one scale: draw all wings at the same scale", "BUTTON turn left"},
    "landscape": {"BUTTON barrier enlarged", "BUTTON whole curve"},
    "curves": {
        *("INPUT rigid fold", "SELECT hinge", "BUTTON S snap", "BUTTON barrier enlarged"),
        *("BUTTON rigid fold", "BUTTON fold"),
    },
    "study": {
        *("point", "SELECT show", "BUTTON pin to compare with another", "BUTTON unpin point #", "SUMMARY Commands"),
        *("INPUT", "BUTTON open point #", "BUTTON Download table.csv", "BUTTON outcome"),
    },
    "optimise": {
        *("point", "DIV least mass", "DIV most mass", "SUMMARY Axes", "INPUT", "SELECT across"),
        *("BUTTON show all designs", "BUTTON open design #", "BUTTON Download table.csv", "SELECT show"),
    },
    "tolerance": {"point", "DIV most margin", "SELECT upwards", "BUTTON open sample #", "BUTTON Download table.csv"},
    "identify": {
        "point",
        "DIV least facts met",
        "BUTTON open sample #",
    },
    "drawn study": {"point", "BUTTON open point #", "SELECT show"},
}


@pytest.fixture(scope="module", params=KINDS)
def kind(request):
    return request.param


@pytest.fixture(scope="module")
def opened(context, pages, kind):
    """A page of each kind, one after another."""
    with watching(context) as watch:
        yield watch(pages[kind], viewport=dict(zip(("width", "height"), WIDE, strict=True)))


def violations(page, options, within=":root"):
    """Return the violations that axe-core finds on a page, and the rules that it cannot decide, with their elements.

    Args:
        page: of Playwright.
        options: of axe-core.
        within: selector of what is looked at.
    """
    if not page.evaluate("window.axe !== undefined"):
        page.evaluate(AXE_SCRIPT)
    kinds = ("violations", "incomplete")
    result = page.evaluate(f"axe.run({json.dumps(within)}, {json.dumps(options | {'resultTypes': kinds})})")
    return tuple(
        [(item["id"], node["target"][-1], node["html"][:100]) for item in result[kind] for node in item["nodes"]]
        for kind in kinds
    )


def test_axe_finds_nothing_on_any_page_in_a_wide_light_window_and_on_a_dark_phone(opened, kind):
    opened.show(*WIDE)
    wrong, untold = violations(opened.page, ALL)
    assert wrong == []
    beyond = f"(targets) => targets.filter((each) => !document.querySelector(each).closest({json.dumps(UNTOLD)}))"
    assert opened.page.evaluate(beyond, [target for _, target, _ in untold]) == []
    if kind not in SAME_PARTS:
        opened.show(*NARROW, scheme="dark")
        assert violations(opened.page, DARK_PHONE)[0] == []


def test_the_keyboard_reaches_every_control_in_its_order_and_shows_where_it_is(opened, kind):
    backwards = () if kind in SAME_PARTS else (("Shift+Tab", NARROW, -1),)
    for key, window, order in (("Tab", WIDE, 1), *backwards):
        opened.show(*window)
        stops = walk(opened, key)
        places = [stop["place"] for stop in stops if stop["place"] >= 0]
        assert places[::order] == list(range(opened.page.evaluate(f"{SEEN}.length")))
        assert [stop["what"] for stop in stops if not (stop["ringed"] and stop["clear"])] == []


def test_every_control_does_something_when_its_key_is_pressed(opened, kind):
    opened.show()  # a small window is drawn faster; a narrower one hides controls
    tried, idle = try_controls(opened.page, TRIED_ELSEWHERE.get(kind, ":not(*)"))
    assert idle == []
    assert LEAST_TRIED.get(kind, set()) <= tried


def test_a_page_with_faults_fails(watch, pages):
    """Control: each fault is found in the window and scheme where it can be visible."""
    opened = watch(pages["converge"])
    opened.page.evaluate(FAULTS)
    opened.show(*WIDE)
    assert {rule for rule, *_ in violations(opened.page, ALL)[0]} == {"button-name", "image-alt"}
    opened.show(*NARROW, scheme="dark")
    assert {rule for rule, *_ in violations(opened.page, DARK_PHONE)[0]} == {
        "color-contrast",
        "scrollable-region-focusable",
    }
    assert try_controls(opened.page)[1] == ["BUTTON"]


def test_a_table_that_is_wider_than_a_phone_is_scrolled_by_the_keyboard_without_a_script(watch, pages):
    opened = watch(pages["converge"])
    opened.show(*NARROW)
    table = opened.page.locator(".table").first
    table.focus()
    opened.page.keyboard.press("ArrowRight")
    until(opened.page, "document.querySelector('.table').scrollLeft > 0")
    assert table.get_attribute("aria-label").startswith("timestep, fold time")
