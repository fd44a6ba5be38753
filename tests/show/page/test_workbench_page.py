"""The page of a workbench in a browser: changes are built by the package, and fold as in Python."""

import base64
import json
from time import monotonic

import numpy as np
import pytest
from PIL import Image, ImageDraw

from forficula.analysis import measure
from forficula.design import design_from_text
from forficula.show.page.data.shown_path import shown_path
from forficula.statics import quasi_static_path
from forficula.study.running.runs import run
from forficula.workbench.access import write_redirect
from tests.show.page.conftest import DEFAULTS, until
from tests.show.page.keyboard import walk
from tests.show.page.test_accessible_pages import ALL, DARK_PHONE, violations
from tests.workbench.serving import SECONDS, serving
from tests.workbench.test_server import SQUARE

# a coarse protocol, which is computed quickly
SETTINGS = {
    "protocol.timestep": "0.4 ms",
    "stops.time_constant": "2 ms",
    "protocol.window": "10 ms",
    "protocol.stages.0.time_limit": "20 ms",
    "protocol.stages.1.time_limit": "0.1 s",
    "protocol.stages.2.hold": "10 ms",
    "protocol.stages.2.time_limit": "0.1 s",
    "protocol.stages.3.time_limit": "0.2 s",
    "protocol.stages.4.hold": "10 ms",
    "protocol.stages.4.time_limit": "0.1 s",
}
DROP = """([files]) => {
  const data = new DataTransfer();
  for (const [name, text] of files) data.items.add(new File([text], name));
  document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
}"""
# moves a pointer over the drawing on a picture, through points in pixels of the picture
POINTER = """([pointerType, stops]) => {
  const drawing = document.querySelector(".trace-drawing");
  const { width } = drawing.viewBox.baseVal;
  const send = (type, [x, y]) => {
    const box = drawing.getBoundingClientRect();
    const [clientX, clientY] = [box.left + (x + 0.5) * box.width / width, box.top + (y + 0.5) * box.width / width];
    const options = { pointerType, pointerId: 1, clientX, clientY, button: 0, bubbles: true, cancelable: true };
    drawing.dispatchEvent(new PointerEvent(type, options));
  };
  drawing.setPointerCapture = () => undefined;  // there is no such pointer
  send("pointerdown", stops[0]);
  for (const stop of stops.slice(1)) send("pointermove", stop);
  send("pointerup", stops.at(-1));
}"""


@pytest.fixture(scope="module")
def served(tmp_path_factory):
    options = [part for key, text in SETTINGS.items() for part in ("--set", f"{key}={text}")]
    with serving("binder2025", *options, folder=tmp_path_factory.mktemp("bench")) as served:
        yield served


@pytest.fixture(scope="module")
def address(served):
    return served.address


SMALL = {"width": 500, "height": 500}  # size of a window in which the wing is drawn quickly
OPENED = "JSON.stringify(forficula.asked)"


class Bench:
    """The page, with its console messages."""

    def __init__(self, context, address, viewport=SMALL):
        self.page = context.new_page()
        self.page.set_viewport_size(viewport)
        self.messages = []
        self.page.on("console", lambda said: "GPU stall" in said.text or self.messages.append(said.text))
        self.page.on("pageerror", lambda error: self.messages.append(str(error)))
        self.page.goto(address)
        until(self.page, "window.forficula !== undefined", SECONDS)
        self.built()
        self.as_opened = None

    def built(self):
        """Wait until a request is answered or refused."""
        says = "document.querySelector('.says p[role=status]').textContent"
        until(self.page, f"!{says}.endsWith('\\u2026')", SECONDS)
        # a paused structure is not drawn
        self.page.evaluate("forficula.wing.panel?.engine.send({ act: 'pause' })")

    def begin_again(self):
        """Restore the initial state, in front of other pages."""
        self.page.bring_to_front()
        if self.page.evaluate(OPENED) != self.as_opened:
            self.page.evaluate("(keys) => forficula.open({ design: '', files: [], unit: '' }, keys)", SETTINGS)
            self.settled()
            self.as_opened = self.page.evaluate(OPENED)
        self.page.get_by_label("Find a key").fill("")
        self.page.get_by_role("tab").first.click()

    def field(self, key):
        """Return the field of a key, found as by a reader."""
        self.page.get_by_label("Find a key").fill(key)
        return self.page.locator(".field:visible").filter(has=self.page.locator(f'[data-key="{key}"]'))

    def put(self, key, text):
        """Write a value into the field of a key."""
        entry = self.field(key).locator("[data-key]")
        entry.fill(text)
        entry.press("Enter")
        self.settled()

    def settled(self):
        """Wait until the last action has taken effect."""
        self.page.wait_for_timeout(100)
        self.page.evaluate("forficula.idle()")
        self.built()

    def drop(self, *files):
        self.page.evaluate(DROP, [list(files)])
        self.page.wait_for_timeout(100)
        self.settled()

    def design_text(self):
        """Return the file that is downloaded."""
        link = self.page.get_by_role("link", name="Download the design")
        return base64.b64decode(link.get_attribute("href").partition("base64,")[2]).decode()

    def design(self):
        return design_from_text(self.design_text())

    def alert(self):
        return self.page.get_by_role("alert").inner_text()

    def press(self, name):
        self.page.get_by_role("button", name=name, exact=True).click()


@pytest.fixture(scope="module")
def connected(browser, served):
    """Pages that reach the workbench, in an authorised browser."""
    context = browser.new_context(**DEFAULTS)
    name, _, value = served.cookie.partition("=")
    context.add_cookies([{"name": name, "value": value, "url": served.address}])
    yield context
    context.close()


def test_a_browser_is_let_in_once_from_the_file_it_is_given(browser, served, tmp_path):
    address = served.invitation()
    write_redirect(address, tmp_path / "open.html")
    context = browser.new_context(**DEFAULTS)
    page = context.new_page()
    page.set_viewport_size(SMALL)
    # it is let in before it has a structure to draw
    page.route("**/model", lambda route: route.abort())
    page.goto((tmp_path / "open.html").as_uri())
    page.wait_for_url(served.address)
    until(page, "document.querySelector('h1').textContent.includes('binder2025')", SECONDS)
    # no script reads the cookie
    assert page.evaluate("document.cookie") == ""
    page.close()
    # again, or in another tab with the address typed by hand
    assert context.request.get(served.address).status == 200
    refused = context.new_page()
    assert refused.goto(address).status == 403
    assert refused.get_by_role("heading").inner_text() == "This browser is not let in"
    context.close()
    other = browser.new_context(**DEFAULTS)
    assert other.new_page().goto(served.address).status == 403
    other.close()


@pytest.fixture(scope="module")
def opened(connected, address):
    return Bench(connected, address)


@pytest.fixture
def bench(opened):
    """The page at its start; one for all tests, because each page starts a simulator."""
    opened.messages.clear()
    opened.begin_again()
    yield opened
    opened.built()
    assert opened.messages == []


def test_a_key_that_is_changed_is_built_by_the_package_and_folds_as_in_python(bench):
    bench.put("pattern.hub_radius", "1.8 cm")
    design = bench.design()
    assert design.pattern.hub_radius == pytest.approx(0.018)
    outcome = measure(run(design))
    page = bench.page
    page.locator(".trial .choices select").first.select_option("real time")
    bench.press("Whole protocol")
    ended = "forficula.wing.panel.frame.ended?.stages.length === 5 && forficula.wing.panel.frame.stageNumber === null"
    until(page, ended, SECONDS)
    result = page.evaluate("forficula.wing.panel.frame.ended")
    assert result["status"] == outcome.status
    stated = np.degrees(outcome.states["folded"].readings["distal_angle"].mean)
    assert np.degrees(result["stages"][2]["readings"][0]) == pytest.approx(stated, abs=0.01)
    assert np.abs(stated).min() > 150


def test_a_pattern_of_more_veins_is_built_and_the_page_goes_on(bench):
    page = bench.page
    page.get_by_role("button", name="top: view from above").click()
    page.locator(".trial .choices select").first.select_option("1/20")
    bench.put("pattern.units", "2")
    assert len(bench.design().tendons) == 5
    assert page.evaluate("forficula.wing.panel.frame.readings[0].length") == 5
    assert page.locator(".readout tbody tr").count() == 5
    assert page.locator(".trial .choices select").first.input_value() == "0.05"
    assert page.evaluate("forficula.wing.panel.stage.eye.look.towards.z") > 0.99
    assert "pattern.units=2" in page.locator(".taking code").inner_text()
    assert page.locator("#view-wing .stage canvas").count() == len(page.workers) == 1
    # it is kept over a reload, and undo restores the design's value
    page.reload()
    until(page, "window.forficula !== undefined", SECONDS)
    bench.built()
    assert len(bench.design().tendons) == 5
    bench.field("pattern.units").get_by_role("button").click()
    bench.settled()
    assert len(bench.design().tendons) == 3


def test_a_bad_value_is_reported_beside_its_key_and_the_last_working_model_is_kept(bench):
    before = bench.design().hash
    bench.put("pattern.hub_radius", "-3 cm")
    field = bench.field("pattern.hub_radius")
    assert field.locator(".wrong").inner_text() == "pattern.hub_radius: need >= 0, got -3 cm"
    assert field.locator("input").get_attribute("aria-invalid") == "true"
    assert field.locator("input").input_value() == "-3 cm"
    assert "the last working model is kept" in bench.alert()
    assert bench.design().hash == before
    assert bench.page.evaluate("forficula.wing.panel.frame.readings[0].length") == 3
    # another key is changed meanwhile, and the bad value can be corrected
    bench.put("pattern.sector_angle", "19 deg")
    assert bench.design().pattern.sector_angle == pytest.approx(np.radians(19))
    assert bench.field("pattern.hub_radius").locator("input").input_value() == "-3 cm"
    bench.put("pattern.hub_radius", "1.6 cm")
    assert bench.field("pattern.hub_radius").locator(".wrong").inner_text() == ""
    assert bench.design().pattern.hub_radius == pytest.approx(0.016)


def test_values_that_are_only_allowed_together_are_accepted_together(bench):
    bench.put("protocol.initial_overbend", "4 deg")
    assert "last working model" in bench.alert()
    bench.put("hinge.overbend", "5 deg")
    design = bench.design()
    assert (design.protocol.initial_overbend, design.hinge.overbend) == pytest.approx(np.radians([4, 5]))
    assert bench.page.locator(".field.rejected").count() == 0


def test_a_slider_changes_the_design_without_building_it_again(bench):
    page = bench.page
    page.evaluate("forficula.wing.panel.stage.element.dataset.same = 'yes'")
    page.get_by_role("slider", name="Tendon stiffness").fill("140")
    until(page, "'tendon.stiffness' in forficula.asked.settings", SECONDS)
    text = page.evaluate("forficula.asked.settings['tendon.stiffness']")
    assert bench.design().tendon.stiffness == pytest.approx(100 * float(text.split()[0]))
    assert bench.field("tendon.stiffness").locator("input").input_value() == text
    assert page.evaluate("forficula.wing.panel.stage.element.dataset.same") == "yes"


# what a picture keeps in graphics memory; true if the canvas is that of the last picture
GRAPHICS = """(stage) => {
  const { geometries, textures, programs } = stage.statistics();
  const same = window.canvas === stage.canvas;
  window.canvas = stage.canvas;
  return [geometries, textures, programs, same];
}"""


def graphics(page, view):
    page.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
    return page.evaluate(f"({GRAPHICS})(forficula.wing.{view}.stage)")


PULL = """(at) => {
  const { stage, moving } = forficula.wing.fold;
  const points = moving.pointsAt(at);
  const last = points.length / 3 - 1;
  const seen = stage.eye.controls.target.clone().fromArray(points, 3 * last).project(stage.eye.camera);
  const box = stage.canvas.getBoundingClientRect();
  return [box.x + (seen.x + 1) / 2 * box.width, box.y + (1 - seen.y) / 2 * box.height];
}"""
SHAPE = "Array.from(forficula.wing.fold.moving.pointsAt(forficula.wing.fold.clock.clipTime(0)))"


def shape(page):
    return np.array(page.evaluate(SHAPE)).reshape(-1, 3)


def folded(page):
    until(page, "forficula.wing.fold.complete", SECONDS)
    page.wait_for_timeout(100)


def test_a_dropped_fold_file_is_shown_folded_and_dragged_though_the_engine_refuses_it(bench):
    bench.drop(("door.fold", json.dumps(SQUARE)))
    page = bench.page
    assert page.locator("h1").inner_text() == "door"
    assert "creases are not joints" in page.locator("#view-wing .offer").inner_text()
    assert page.locator("#view-wing .stage canvas").count() == 1
    folded(page)
    assert page.locator(".folding .note").first.inner_text().startswith("The fold path was computed in ")
    # the slider moves along the path of the package
    slider = page.get_by_role("slider", name="fold")
    assert np.ptp(shape(page)[:, 2]) == pytest.approx(0, abs=1e-6)
    slider.fill("5000")
    page.wait_for_timeout(200)
    path = shown_path(quasi_static_path(design_from_text(bench.design_text())))
    assert shape(page) == pytest.approx(path.point(0.5).positions, abs=2e-4 * path.structure.span)
    # a change of a value continues from the position of the slider
    bench.put("facet.thickness", "0.1 mm")
    assert bench.design().facet.thickness == pytest.approx(1e-4)
    folded(page)
    assert page.get_by_role("slider", name="fold").input_value() == "5000"
    assert np.ptp(shape(page)[:, 2]) > 0.01
    # a vertex is dragged along its equilibria, which takes a force
    page.locator("#view-wing .stage canvas").scroll_into_view_if_needed()
    at, rest = page.evaluate(PULL, 50), shape(page)
    page.mouse.move(*at)
    page.mouse.down()
    page.mouse.move(at[0], at[1] - 30, steps=3)
    until(page, "/force of .* m?N holds/.test(document.querySelector('.pushed').textContent)", SECONDS)
    assert np.abs(shape(page) - rest).max() > 1e-3
    page.mouse.up()
    assert shape(page) == pytest.approx(rest)
    assert "N holds" in page.locator(".drag [role=status]").inner_text()
    refused, _ = violations(page, ALL, "#view-wing")
    assert refused == []
    bench.drop(("bad.fold", "{"))
    assert bench.alert().startswith("bad.fold is not opened: bad.fold: ")
    assert page.locator("h1").inner_text() == "door"
    page.get_by_role("tab", name="Pattern").click()
    until(page, "document.querySelector('#view-sheet img')?.complete === true", SECONDS)
    assert "valley" in page.locator("#view-sheet img").get_attribute("alt")


def test_a_file_that_was_dropped_later_is_not_kept_waiting_by_those_before(bench):
    names = []

    def hear(request):
        if request.url.endswith("/design"):
            names.append(request.post_data_json["files"][0]["name"])

    bench.page.on("request", hear)
    sheet = json.dumps(SQUARE)
    bench.page.evaluate(
        f"(all) => {{ for (const each of all) ({DROP})([[each]]); }}", [[f"door{n}.fold", sheet] for n in range(5)]
    )
    bench.page.wait_for_timeout(100)
    bench.settled()
    bench.page.remove_listener("request", hear)
    assert bench.page.locator("h1").inner_text() == "door4"
    assert names == ["door0.fold", "door4.fold"]


def test_a_vertex_is_dragged_by_keys_until_it_is_released(bench):
    bench.drop(("door.fold", json.dumps(SQUARE)))
    page = bench.page
    folded(page)
    rest = shape(page)
    page.get_by_text("Drag without a pointer").click()
    page.locator(".drag select").select_option("vertex 3")
    page.get_by_role("button", name="drag up").focus()
    page.keyboard.press("ArrowUp")
    end = monotonic() + SECONDS
    while np.abs(shape(page) - rest).max() <= 3e-4:
        assert monotonic() < end
        page.wait_for_timeout(50)
    assert "N holds" in page.locator(".drag [role=status]").inner_text()
    page.get_by_role("button", name="Release", exact=True).click()
    assert shape(page) == pytest.approx(rest)


def test_a_wing_is_also_moved_along_its_fold_path(bench):
    page = bench.page
    *live, _ = graphics(page, "panel")
    page.get_by_role("button", name="fold", exact=True).click()
    try:
        # the path may be complete before the slider is there
        page.get_by_role("slider", name="fold").wait_for(timeout=1000 * SECONDS)
        folded(page)
        assert page.get_by_role("slider", name="fold").count() == 1
        assert page.locator("#view-wing .stage canvas").count() == 1
        # another picture takes the renderer of the last one, whose shaders are compiled
        assert graphics(page, "fold")[-1]
    finally:
        # the other tests of this page move the live wing
        page.get_by_role("button", name="live", exact=True).click()
    until(page, "forficula.wing.panel?.stage !== undefined", SECONDS)
    assert page.locator("#view-wing .stage canvas").count() == 1
    # and leaves nothing in its memory
    assert graphics(page, "panel") == [*live, True]


def test_a_landscape_can_be_awaited_or_stopped(bench):
    page = bench.page
    page.get_by_role("tab", name="Landscape").click()
    bench.press("Compute it")
    bench.press("Stop")
    until(page, "document.querySelector('#view-landscape .note').textContent === 'Stopped.'", SECONDS)
    page.locator("#which-design").select_option("binder2025-joint")
    bench.settled()
    assert page.locator("h1").inner_text() == "binder2025-joint"
    bench.press("Compute it")
    # changes made during the survey are not part of the result
    page.locator("#which-design").select_option("letter-fold")
    bench.settled()
    assert page.locator("h1").inner_text() == "letter-fold"
    until(page, "document.querySelector('#view-landscape button:not([hidden])').disabled === false", SECONDS)
    shown = page.frame_locator("#view-landscape iframe")
    shown.get_by_role("heading", name="binder2025-joint").wait_for()
    said = page.locator("#view-landscape .note").first.inner_text()
    assert said == "This result belongs to the design before its last change."


def test_building_can_be_stopped_and_the_last_working_model_is_kept(bench):
    bench.page.locator("#which-design").select_option("miura-sheet")
    bench.settled()
    bench.put("pattern.columns", "12")
    before = bench.design()
    entry = bench.field("pattern.rows").locator("[data-key]")
    # some thousand facets
    entry.fill("300")
    entry.press("Enter")
    bench.press("Stop building")
    bench.settled()
    assert bench.alert() == "building was stopped \u2013 the last working model is kept."
    assert bench.design() == before
    bench.put("pattern.columns", "3")
    assert bench.design().pattern.columns == 3


def test_the_design_file_can_be_edited(bench):
    page = bench.page
    page.get_by_role("tab", name="File").click()
    area = page.get_by_label("The design file")
    text = area.input_value()
    area.fill(text.replace('diameter = "5 mm"', 'diameter = "4 mm"'))
    bench.press("Build this text")
    bench.settled()
    assert bench.design().vein.diameter == pytest.approx(4e-3)
    area.fill("diameter = ")
    bench.press("Build this text")
    bench.settled()
    # the text stays and can be corrected
    assert area.input_value() == "diameter = "
    assert "is not opened" in bench.alert()
    assert bench.design().vein.diameter == pytest.approx(4e-3)


def test_keys_push_a_tip_which_returns_when_they_are_released(bench):
    page = bench.page
    page.get_by_text("Push without a pointer").click()
    page.locator(".push-keys select").first.select_option("tip 1")
    before = np.array(page.evaluate("Array.from(forficula.wing.panel.frame.points)"))
    page.get_by_role("button", name="push up").focus()
    page.keyboard.down("ArrowUp")
    end = monotonic() + SECONDS
    while np.abs(np.array(page.evaluate("Array.from(forficula.wing.panel.frame.points)")) - before).max() <= 1e-3:
        assert monotonic() < end
        page.wait_for_timeout(50)
    assert page.locator(".push-keys [role=status]").inner_text().startswith("tip 1 pushed with ")
    page.keyboard.up("ArrowUp")
    assert page.locator(".push-keys [role=status]").inner_text() == ""


def test_views_are_chosen_and_keys_changed_by_keyboard_alone(bench):
    page = bench.page
    page.get_by_role("tab", name="Wing").focus()
    page.keyboard.press("ArrowRight")
    assert page.evaluate("document.activeElement.id") == "tab-sheet"
    assert page.locator("#view-sheet").is_visible()
    assert not page.locator("#view-wing").is_visible()
    page.get_by_label("Find a key").focus()
    page.keyboard.type("sector")
    page.keyboard.press("Tab")
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.dataset.key") == "pattern.sector_angle"
    page.keyboard.press("Control+A")
    page.keyboard.type("21 deg")
    page.keyboard.press("Enter")
    until(page, "forficula.asked.settings['pattern.sector_angle'] === '21 deg'", SECONDS)
    # and the focus is where it was
    assert page.evaluate("document.activeElement.dataset.key") == "pattern.sector_angle"


def test_every_field_is_accessible_by_keyboard_and_screen_reader(connected, address):
    # a new page: focus begins where a page was last clicked
    opened = Bench(connected, address)
    page = opened.page
    wide, phone = ({"width": width, "height": 844} for width in (1280, 390))
    for window, key in ((wide, "Tab"), (phone, "Shift+Tab")):
        page.set_viewport_size(window)
        stops = walk(opened, key)
        assert [stop["what"] for stop in stops if not (stop["ringed"] and stop["clear"])] == []
        fields = page.locator("[data-key]:visible").count()
        assert fields > 10
        assert sum('id="key-' in stop["what"] for stop in stops) == fields
    opened.put("pattern.hub_radius", "-3 cm")
    for window, scheme, rules in ((phone, "dark", DARK_PHONE), (wide, "light", ALL)):
        page.set_viewport_size(window)
        page.emulate_media(color_scheme=scheme)
        within = ":root"
        for tab in ("Wing", "Pattern", "Landscape", "File"):
            page.get_by_role("tab", name=tab, exact=True).click()
            page.wait_for_timeout(300)
            refused, _ = violations(page, rules, within)
            assert refused == [], tab
            assert page.evaluate("document.documentElement.scrollWidth") <= window["width"]
            within = "[role=tabpanel]:not([hidden])"  # elements around the views are the same
    page.close()


def test_a_pattern_is_traced_by_pointer_touch_and_keys_and_folds_beside_the_picture(bench, tmp_path):
    page = bench.page
    picture = Image.new("RGB", (400, 300), "white")
    pen = ImageDraw.Draw(picture)
    pen.rectangle((50, 50, 350, 250), outline="black", width=4)
    pen.line((200, 52, 200, 248), fill=(30, 50, 190), width=4)
    picture.save(tmp_path / "sketch.png")
    page.set_viewport_size({"width": 900, "height": 700})
    page.get_by_role("tab", name="Trace").click()
    page.set_input_files("#trace-file", tmp_path / "sketch.png")
    said = "document.querySelector('.trace-said').textContent"
    until(page, f"{said} === 'Clicks snap to 6 junctions of lines and corners.'", SECONDS)

    def pattern():
        drawn = page.evaluate("forficula.tracing.history.pattern")
        return len(drawn["vertices"]), "".join(sorted(drawn["letters"]))

    def pointer(kind, *stops):
        """Press at the first point, 2 pixels of the picture beside it, and release at the last one."""
        page.evaluate(POINTER, [kind, [[x + 2, y - 2] for x, y in stops]])

    # the scale: two clicks and a length
    page.get_by_label("Set the scale").check()
    page.get_by_label("Distance").fill("9 cm")
    for x in (51.5, 348.5):
        pointer("mouse", (x, 51.5))
    until(page, "forficula.tracing.state.scale !== null", SECONDS)
    assert "The length is 9 cm" in page.locator(".trace-choice:visible").nth(1).inner_text()
    # three borders by mouse and by touch, three by keys, which lead from vertex to vertex in the order of reading
    page.get_by_label("Draw", exact=True).check()
    left, middle, right, top, bottom = 51.5, 200, 348.5, 51.5, 248.5
    pointer("mouse", (left, top), (middle, 150), (middle, top))
    pointer("touch", (middle, top), (right, 150), (right, top))
    pointer("touch", (left, top), (left, 150), (left, bottom))
    assert pattern() == (4, "BBB")
    page.locator(".trace-drawing").focus()
    for key in ("n", "n", "n", "Enter", "n", "n", "n", "Enter", "p", "Enter", "p", "Enter", "Escape"):
        page.keyboard.press(key)
    assert pattern() == (6, "BBBBBB")
    page.keyboard.press("v")
    pointer("mouse", (middle, top), (middle, 150), (middle, bottom))
    assert pattern() == (6, "BBBBBBV")
    page.keyboard.press("Control+z")
    assert pattern() == (6, "BBBBBB")
    page.keyboard.press("Control+y")
    # a vertex is moved by an arrow key, and back by undo; a selected vertex is deleted
    page.get_by_label("Select and move").check()
    pointer("mouse", (right, top))
    page.locator(".trace-drawing").focus()
    page.keyboard.press("ArrowUp")
    assert page.evaluate(f"forficula.tracing.history.pattern.vertices.every(([, y]) => y > {top - 0.7})") is False
    page.keyboard.press("Control+z")
    pointer("mouse", (middle, 150))
    page.keyboard.press("Delete")
    assert pattern() == (6, "BBBBBB")
    page.keyboard.press("Control+z")
    # the result, beside its picture and as a file
    page.get_by_role("button", name="Fold it", exact=True).click()
    until(page, "document.querySelector('.trace-side canvas') !== null", SECONDS)
    bench.settled()
    sheet = bench.design().pattern
    assert sheet.kind == "fold-file"
    assert np.ptp(sheet.vertices_x) == pytest.approx(0.09, rel=1e-6)
    with page.expect_download() as download:
        page.get_by_role("button", name="Download as FOLD").click()
    assert json.loads(download.value.path().read_text())["forficula:picture"]["name"] == "sketch.png"
    refused, _ = violations(page, ALL, "#view-trace")
    assert refused == []
    page.set_viewport_size(SMALL)
