"""What holds of every kind of page for readers who see, press or hear it otherwise: WCAG 2.2, levels A and AA."""

import json
import re

import pytest
from axe_playwright_python.base import AXE_SCRIPT

from tests.show.page.conftest import watching
from tests.show.page.page_kinds import KINDS, MOVING

WIDE, NARROW = (1280, 600), (390, 844)
TAGS = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"]
# What depends on the scheme is contrast, what depends on the width is what scrolls and how large a target is: with all
# rules in a wide light window, contrast in a dark one, and these two on a phone, every rule is asked wherever its
# answer can be another one. A wide window has all columns of the tables in sight, without which contrast is not told.
ALL = {"runOnly": {"type": "tag", "values": TAGS}, "rules": {"target-size": {"enabled": True}}}
CONTRAST = {"runOnly": {"type": "rule", "values": ["color-contrast"]}}
WIDTH = {"runOnly": {"type": "rule", "values": ["scrollable-region-focusable", "target-size"]}}
# Colours that axe does not tell: signs that are no letters, and letters on a picture, a pattern or a band. The style's
# colours are held to their contrasts in test_page.py, and maps write their signs on plain ground.
UNTOLD = ".stage, .what, .grid, .tick, .views, .scatter, .ball, .map-legend, .map-place, .filter"

CONTROLS = "button, a[href], select, input, summary, [tabindex='0']"
SEEN = f"[...document.querySelectorAll(\"{CONTROLS}\")].filter((each) => each.checkVisibility())"
# what has the keys: its place among all controls, whether that is seen, and whether nothing lies on it
FOCUSED = f"""(() => {{
  const at = document.activeElement, style = getComputedStyle(at.querySelector(":scope > circle") ?? at);
  const box = at.getBoundingClientRect();
  const middle = [(Math.max(box.left, 0) + Math.min(box.right, innerWidth)) / 2, (Math.max(box.top, 0) + Math.min(box.bottom, innerHeight)) / 2];
  const there = document.elementFromPoint(...middle);
  return {{ place: {SEEN}.indexOf(at), body: at === document.body,
    ringed: (style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 2) || parseFloat(style.strokeWidth) >= 3,
    clear: there !== null && (at.contains(there) || there.contains(at)), what: at.outerHTML.slice(0, 120) }}; }})()"""


@pytest.fixture(scope="module", params=KINDS)
def opened(request, browser, pages):
    """A page of each kind."""
    with watching(browser) as watch:
        yield watch(pages[request.param], viewport=dict(zip(("width", "height"), WIDE, strict=True)))


def asked(page, options):
    """What axe-core finds wrong on a page, and what it cannot tell: rules with the elements of which it says so."""
    if not page.evaluate("window.axe !== undefined"):
        page.evaluate(AXE_SCRIPT)
    kinds = ("violations", "incomplete")
    found = page.evaluate(f"axe.run({json.dumps(options | {'resultTypes': kinds})})")
    return tuple(
        [(each["id"], node["target"][-1], node["html"][:100]) for each in found[kind] for node in each["nodes"]]
        for kind in kinds
    )


def test_axe_finds_nothing_on_any_page_in_wide_and_narrow_light_and_dark_windows(opened):
    opened.show(*WIDE)
    wrong, untold = asked(opened.page, ALL)
    assert wrong == []
    beyond = f"(targets) => targets.filter((each) => !document.querySelector(each).closest({json.dumps(UNTOLD)}))"
    assert opened.page.evaluate(beyond, [target for _, target, _ in untold]) == []
    opened.show(*WIDE, scheme="dark")
    assert asked(opened.page, CONTRAST)[0] == []
    opened.show(*NARROW)
    assert asked(opened.page, WIDTH)[0] == []


def walk(opened, key):
    """Press a key until all of the page is passed: what had the keys, one after another."""
    page, stops = opened.page, []
    page.evaluate("document.activeElement.blur(); getSelection().removeAllRanges(); scrollTo(0, 0)")
    for _ in range(400):
        page.keyboard.press(key)
        stop = page.evaluate(FOCUSED)
        if stop["body"] or stop in stops:
            return stops
        stops.append(stop)
    raise AssertionError("it never ends")


@pytest.mark.parametrize(("key", "window", "order"), [("Tab", WIDE, 1), ("Shift+Tab", NARROW, -1)])
def test_every_control_of_any_page_is_reached_by_the_keyboard_in_its_order_and_is_seen_to_be(opened, key, window, order):
    opened.show(*window)
    stops = walk(opened, key)
    places = [stop["place"] for stop in stops if stop["place"] >= 0]
    assert places[::order] == list(range(opened.page.evaluate(f"{SEEN}.length")))
    assert [stop["what"] for stop in stops if not (stop["ringed"] and stop["clear"])] == []


@pytest.mark.parametrize(
    ("fault", "window", "scheme", "options", "rule"),
    [
        ("main.insertAdjacentHTML('beforeend', '<button></button>')", WIDE, "light", ALL, "button-name"),
        ("main.querySelector('img').removeAttribute('alt')", WIDE, "light", ALL, "image-alt"),
        ("main.querySelector('p').style.color = '#565d66'", WIDE, "dark", CONTRAST, "color-contrast"),
        ("main.querySelector('.table').removeAttribute('tabindex')", NARROW, "light", WIDTH, "scrollable-region-focusable"),
    ],
)
def test_a_page_with_a_fault_fails(watch, pages, fault, window, scheme, options, rule):
    opened = watch(pages["converge"])
    opened.show(*window, scheme=scheme)
    assert asked(opened.page, options)[0] == []
    opened.page.evaluate(f"(() => {{ const main = document.body; {fault}; }})()")
    assert {each[0] for each in asked(opened.page, options)[0]} == {rule}
