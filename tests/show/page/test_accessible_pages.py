"""What holds of every kind of page for readers who see, press or hear it otherwise: WCAG 2.2, levels A and AA."""

import json

import pytest
from axe_playwright_python.base import AXE_SCRIPT

from tests.show.page.conftest import until, watching
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

FAULTS = """(() => {
  const main = document.querySelector("main");
  main.insertAdjacentHTML("beforeend", "<button></button>");
  main.querySelector("img").removeAttribute("alt");
  document.querySelector("p").style.color = "#565d66"; // that of a light page
  main.querySelector(".table").removeAttribute("tabindex"); })()"""
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

# counts what a key changes: the document, what is chosen in it, and pictures that are drawn; what is said aloud comes later
WATCH = f"""window.watched = (() => {{
  let mutations = 0;
  const spoken = ({{ target }}) => (target.closest ? target : target.parentElement)?.closest(".spoken");
  new MutationObserver((all) => {{ mutations += all.filter((each) => !spoken(each)).length; }})
    .observe(document, {{ subtree: true, childList: true, attributes: true, characterData: true }});
  const settled = () => new Promise((done) => requestAnimationFrame(done));
  const playing = () => window.forficula?.panel?.playing ?? window.forficula;
  const controls = () => {SEEN}.filter((each) => !each.matches(".table"));
  const nameOf = (each) => each.matches("[data-point]") ? "point" : each.matches(".play") ? "BUTTON play" : `${{each.tagName.toUpperCase()}} ${{
    (each.getAttribute("aria-label") ?? each.labels?.[0]?.firstChild.textContent ?? each.textContent).trim().replace(/\\d[\\d.]*/g, "#")}}`;
  const state = () => JSON.stringify([[...document.querySelectorAll("input, select, details")]
    .map((each) => [each.value, each.checked, each.open]), playing()?.player?.stage?.statistics().frame]);
  const keyOf = (each) => each.matches("canvas") ? "Shift+ArrowLeft" : each.matches("[type=checkbox]") ? " "
    : each.matches("[type=range]") ? "ArrowRight" : !each.matches("select") ? "Enter"
    : each.selectedIndex < each.options.length - 1 ? "ArrowDown" : "ArrowUp";
  const find = (name) => controls().find((each) => nameOf(each) === name);
  let before = null;
  return {{
    names: () => [...new Set(controls().map(nameOf))],
    async choose(name) {{
      playing()?.clock?.pause();
      await settled();
      if (!find(name)) {{
        // another control has hidden it
        for (const box of document.querySelectorAll("[type=checkbox]:not(:checked)")) box.click();
        window.forficula?.open?.(0);
        await settled();
      }}
      if (!find(name)) return null;
      find(name).focus();
      [before, mutations] = [state(), 0];
      return keyOf(document.activeElement);
    }},
    async changed() {{
      await settled();
      return mutations > 0 || state() !== before;
    }},
  }}; }})()"""
_PLAYER = {"BUTTON play", "INPUT time", "SELECT speed", "BUTTON turn left", "BUTTON nearer", "SUMMARY Keys"}
LEAST_TRIED = {
    "run": _PLAYER | {"BUTTON b folded", "SELECT show", "A Download design.toml", "BUTTON top: view from above"},
    "compare": _PLAYER | {"BUTTON one scale: all wings as large as they are by each other"},
    "curves": {"INPUT distal angle along the curve", "INPUT mean distal angle along the curve", "BUTTON barrier close up"},
    "study": _PLAYER
    | {"point", "BUTTON unpin point #", "BUTTON open point #", "BUTTON Download table.csv", "INPUT ", "SUMMARY Commands"},
    "drawn study": {"point", "BUTTON open point #", "SELECT show"},
}


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


def test_a_page_with_faults_fails(watch, pages):
    """A control: each fault is found in the window and the scheme in which it can be."""
    opened = watch(pages["converge"])
    opened.page.evaluate(FAULTS)
    opened.show(*WIDE)
    assert {rule for rule, *_ in asked(opened.page, ALL)[0]} == {"button-name", "image-alt"}
    opened.show(*WIDE, scheme="dark")
    assert {rule for rule, *_ in asked(opened.page, CONTRAST)[0]} == {"color-contrast"}
    opened.show(*NARROW)
    assert {rule for rule, *_ in asked(opened.page, WIDTH)[0]} == {"scrollable-region-focusable"}
    assert try_controls(opened.page)[1] == ["BUTTON "]


# the page of a landscape with a run is that of the run, with curves, which are those of one without
@pytest.mark.parametrize("kind", [kind for kind in MOVING if kind != "landscape"])
def test_every_control_does_something_when_its_key_is_pressed(watch, pages, kind):
    page = watch(pages[kind], viewport=dict(zip(("width", "height"), WIDE, strict=True))).page
    tried, idle = try_controls(page)
    assert idle == []
    assert LEAST_TRIED[kind] <= tried


def test_a_table_that_is_wider_than_a_phone_is_scrolled_by_the_keyboard_without_a_script(watch, pages):
    opened = watch(pages["converge"])
    opened.show(*NARROW)
    table = opened.page.locator(".table").first
    table.focus()
    opened.page.keyboard.press("ArrowRight")
    until(opened.page, "document.querySelector('.table').scrollLeft > 0")
    assert table.get_attribute("aria-label").startswith("timestep, fold time")


def try_controls(page):
    """Press the key of every control that there is and that comes: names that were tried, and those that did nothing.

    Of controls whose names differ by numbers only one is tried.
    """
    page.evaluate(WATCH)
    seen, tried, idle = set(), set(), []
    while left := [name for name in page.evaluate("watched.names()") if name not in seen]:
        seen.add(left[0])
        key = page.evaluate("(name) => watched.choose(name)", left[0])
        if key is None:  # was there only beside what another one has closed
            continue
        tried.add(left[0])
        if "download" in left[0].lower():
            with page.expect_download():
                page.keyboard.press(key)
            continue
        page.keyboard.press(key)
        if not page.evaluate("watched.changed()"):
            idle.append(left[0])
    return tried, idle
