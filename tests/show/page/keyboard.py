"""Keyboard access of a page: which elements are reached, whether focus is visible, and what keys do."""

CONTROLS = "button, a[href], select, input, summary, [tabindex='0']"
SEEN = f'[...document.querySelectorAll("{CONTROLS}")].filter((each) => each.checkVisibility())'
# the focused element: its index among all controls, whether it is visible, and whether nothing covers it
_FOCUSED = f"""(() => {{
  const at = document.activeElement, box = at.getBoundingClientRect();
  const style = getComputedStyle(at.querySelector(":scope > circle") ?? at);
  const middle = (low, high, end) => (Math.max(low, 0) + Math.min(high, end)) / 2;
  const there = document.elementFromPoint(
    middle(box.left, box.right, innerWidth), middle(box.top, box.bottom, innerHeight));
  const ring = style.outlineStyle === "none" ? 0 : parseFloat(style.outlineWidth);
  return {{ place: {SEEN}.indexOf(at), body: at === document.body, what: at.outerHTML.slice(0, 120),
    ringed: ring >= 2 || parseFloat(style.strokeWidth) >= 3,
    clear: there !== null && (at.contains(there) || there.contains(at)) }}; }})()"""

# counts what a key changes: the document, the selection, and drawn pictures; announcements come later
_WATCH = f"""(elsewhere) => window.watched = (() => {{
  let mutations = 0;
  let before = null;
  const spoken = ({{ target }}) => (target.closest ? target : target.parentElement)?.closest(".spoken");
  new MutationObserver((all) => {{ mutations += all.filter((each) => !spoken(each)).length; }})
    .observe(document, {{ subtree: true, childList: true, attributes: true, characterData: true }});
  const settled = () => new Promise((done) => requestAnimationFrame(done));
  const playing = () => window.forficula?.panel?.playing ?? window.forficula;
  const controls = () => {SEEN}.filter((each) => !each.matches(".table") && !each.closest(elsewhere));
  const textOf = (each) =>
    each.getAttribute("aria-label") ?? each.labels?.[0]?.firstChild.textContent ?? each.textContent;
  function nameOf(each) {{
    if (each.matches("[data-point]")) return "point";
    if (each.matches(".play")) return "BUTTON play"; // while it plays, pause
    // one plot and one figure are saved: Chromium stops downloads after ten of them without a person
    const name = (each.matches("canvas") ? "" : textOf(each).trim().replace(/\\d[\\d.]*/g, "#"))
      .replace(/(download ... of (?:the figure)?)(?!the picture).*/, "$1 ...");
    return `${{each.tagName.toUpperCase()}} ${{name}}`.trim();
  }}
  const state = () => JSON.stringify([playing()?.player?.stage?.statistics().frame,
    ...[...document.querySelectorAll("input, select, details")].map((each) => [each.value, each.checked, each.open])]);
  function keyOf(each) {{
    if (each.matches("canvas")) return "Shift+ArrowLeft";
    if (each.matches("[type=checkbox]")) return " ";
    if (each.matches("[type=range]")) return "ArrowRight";
    if (each.matches("[role=slider]")) return each.ariaValueNow === each.ariaValueMax ? "ArrowDown" : "ArrowUp";
    if (!each.matches("select")) return "Enter";
    return each.selectedIndex < each.options.length - 1 ? "ArrowDown" : "ArrowUp";
  }}
  const find = (name) => controls().find((each) => nameOf(each) === name);
  // those that exchange the other controls come last
  const last = (each) => Number(each.closest(".modes") !== null);
  return {{
    names: () => [...new Set(controls().sort((one, other) => last(one) - last(other)).map(nameOf))],
    async choose(name) {{
      playing()?.clock?.pause?.();
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


def walk(opened, key):
    """Press a key until the whole page is passed; returns the focused elements in order."""
    page, stops = opened.page, []
    page.evaluate("document.activeElement.blur(); getSelection().removeAllRanges(); scrollTo(0, 0)")
    for _ in range(400):
        page.keyboard.press(key)
        stop = page.evaluate(_FOCUSED)
        if stop["body"] or stop in stops:
            return stops
        stops.append(stop)
    raise AssertionError("it never ends")


def _download(page, name, key, trials=3):
    """Press the key of a control until a file comes: a busy machine may draw the control again in between."""
    from playwright.sync_api import TimeoutError as NeverCameError

    for trial in range(trials):
        try:
            with page.expect_download(timeout=15_000):
                page.keyboard.press(key)
        except NeverCameError:
            assert trial < trials - 1, f"{name} saves nothing"
            page.evaluate("(name) => watched.choose(name)", name)
        else:
            return


def try_controls(page, elsewhere=":not(*)"):
    """Press the key of every control, also of new ones; returns names that were tried, and those without effect.

    Of controls whose names differ by numbers only one is tried.

    Args:
        page: of Playwright.
        elsewhere: selector of what is left out, with all in it.
    """
    page.evaluate(_WATCH, elsewhere)
    seen, tried, idle = set(), set(), []
    while left := [name for name in page.evaluate("watched.names()") if name not in seen]:
        seen.add(left[0])
        key = page.evaluate("(name) => watched.choose(name)", left[0])
        if key is None:  # existed only beside an element that another key has closed
            continue
        tried.add(left[0])
        if "download a film" in left[0].lower():
            # a film takes seconds, and a second press stops it
            for filming in ("true", "false"):
                page.keyboard.press(key)
                page.wait_for_function(f"document.activeElement.textContent.includes('%') === {filming}")
            continue
        if "download" in left[0].lower():
            _download(page, left[0], key)
            continue
        page.keyboard.press(key)
        if not page.evaluate("watched.changed()"):
            idle.append(left[0])
    return tried, idle
