"""Page of a run, in a browser without network."""

import io
import re
from xml.etree import ElementTree

import matplotlib.image
import numpy as np
import pytest

from forficula.analysis import summary
from forficula.analysis.energy_by_mechanism import energy_shares
from forficula.design import load_design
from forficula.dynamics import versions
from forficula.show.page import write_run_page
from forficula.show.page.parts.run_sentences import angle_range
from forficula.show.structure.shape import shape_of
from forficula.show.structure.surface import face_strains, surface_at
from forficula.structure import drawn_points
from forficula.structure.membrane_stress import principal_strains, principal_stresses
from forficula.study.running.runs import run
from tests.show.page.appearance import check_shown
from tests.show.page.conftest import until

# positions are 4-byte floats, and interpolation between frames adds half of this
EXACT = 1e-6  # m
FRAME = 1000 / 60  # ms

WIDTHS = "(bands) => bands.map((band) => band.style.width)"
# largest distances of the drawn vertices from the picture's centre, across and upwards, 1 at its edges, over time
REACHES = """(towards) => { const { clock, player } = forficula; const { stage } = player; const { eye } = stage;
eye.show({ towards });
return Array.from({ length: 41 }, (_, step) => {
  clock.seek(clock.momentAt(step / 40)); stage.pose(); stage.draw();
  const reach = [0, 0]; const { vertices } = stage.views[0].shape; const point = eye.controls.target.clone();
  for (let at = 0; at < vertices.length; at += 3) {
    point.fromArray(vertices, at).project(eye.camera);
    [point.x, point.y].forEach((place, axis) => { reach[axis] = Math.max(reach[axis], Math.abs(place)); });
  }
  return reach;
}); }"""


@pytest.fixture(scope="module")
def report(short_run, short_outcome, tmp_path_factory):
    path = tmp_path_factory.mktemp("run") / "report.html"
    write_run_page(short_run, short_outcome, path)
    return path


@pytest.fixture(scope="module")
def one_page(watch_all, report):
    return watch_all(report)


@pytest.fixture
def opened(one_page):
    """The page as it opens."""
    one_page.show()
    one_page.page.evaluate(
        """() => { const { clock, player } = forficula;
        clock.pause(); clock.setSpan(clock.spans[0]); clock.seek(0); clock.setSpeed("even");
        document.querySelector("select").value = "even";
        player.stage.eye.show({ towards: [0.37, -0.695, 0.616] });
        document.activeElement.blur(); scrollTo(0, 0); }"""
    )
    one_page.settle()
    return one_page


def pixels(page, selector="canvas"):
    return np.round(255 * matplotlib.image.imread(io.BytesIO(page.locator(selector).first.screenshot()))[..., :3])


def go_to(opened, state):
    """Return the state of an index."""
    opened.page.evaluate("(state) => forficula.clock.seekClip(0, forficula.clips[0].marks[state].time)", state)
    opened.settle()


def time(page):
    return page.evaluate("forficula.clock.time")


def readout_texts(page, row):
    return page.locator(f"#readout tr:has(th:text-is('{row}')) td").all_inner_texts()


def readout(page, row):
    """Return the numbers of a row, without uncertainties."""
    return [float(text.replace("−", "-").partition(" ")[0]) for text in readout_texts(page, row)]


def drawn(page):
    """Return the vertices drawn now, m, (vertex, 3)."""
    vertices = page.evaluate("Array.from(forficula.player.stage.views[0].shape.vertices)")
    return np.array(vertices).reshape(-1, 3)


def record_points(record, row):
    points = record.series["point_position"][row, drawn_points(record.structure)]
    return np.concatenate([points, record.series["membrane_position"][row]])


def furthest(points, vertices):
    """Return the largest distance of some points from the nearest vertex, m."""
    return np.linalg.norm(points[:, None] - vertices[None], axis=2).min(axis=1).max()


def test_the_page_opens_from_a_file_without_a_request_and_without_a_word_on_the_console(opened):
    page = opened.page
    page.get_by_role("button", name="b folded").click()
    page.get_by_label("show").select_option("fold")
    page.get_by_role("button", name="top: view from above").click()
    opened.settle()
    assert opened.messages == []
    assert [url for url in opened.requests if not url.startswith(("file:", "data:"))] == []
    assert len(opened.requests) == 1


def test_the_wing_is_drawn_in_the_colours_that_the_legend_gives(opened):
    colours = pixels(opened.page).reshape(-1, 3)
    assert len(np.unique(colours, axis=0)) > 200
    # a distal panel is blue, a proximal one sand, a taut tendon yellow, a valley's vein dark blue
    for red, green, blue in ((176, 216, 240), (240, 224, 184), (253, 231, 37), (0, 114, 178)):
        near = np.abs(colours - [red, green, blue]).max(axis=1) < 32
        assert near.sum() > 100, (red, green, blue)


def test_every_third_of_the_run_the_drawn_wing_is_where_the_simulator_had_it(opened, short_run):
    for row in np.linspace(0, len(short_run.time) - 1, 4).astype(int):
        opened.page.evaluate("(moment) => { forficula.clock.seek(moment); }", float(short_run.time[row]))
        opened.settle()
        assert furthest(record_points(short_run, row), drawn(opened.page)) < EXACT


def test_play_moves_the_wing_and_the_cursor_and_stops_at_the_end(opened):
    page = opened.page
    page.get_by_label("speed").select_option("1/5")
    before, place, picture = drawn(page), page.locator(".cursor").first.bounding_box()["x"], pixels(page)
    page.get_by_role("button", name="play").click()
    until(page, "forficula.clock.time > 0.05")
    page.get_by_role("button", name="pause").click()
    opened.settle()
    assert np.abs(drawn(page) - before).max() > 0.02
    assert page.locator(".cursor").first.bounding_box()["x"] > place + 20
    assert (pixels(page) != picture).any(axis=2).mean() > 0.01
    page.get_by_label("speed").select_option("real time")
    page.get_by_role("button", name="play").click()
    until(page, "!forficula.clock.playing")
    assert time(page) == pytest.approx(page.evaluate("forficula.clock.span.end"))


def test_even_motion_takes_its_time_where_the_wing_is_fast(opened):
    slow = [
        opened.page.evaluate("(at) => { forficula.clock.seek(at); return forficula.clock.slowness; }", moment)
        for moment in (0.005, 0.06)
    ]
    assert slow[1] > 2 * slow[0]


def test_scrubbed_to_folded_the_wing_has_the_angles_that_the_summary_states(opened, short_run, short_outcome):
    stated = summary(short_run, short_outcome, versions())["states"]["folded"]
    page = opened.page
    page.get_by_role("button", name="b folded").click()
    opened.settle()
    assert time(page) == pytest.approx(stated["time_s"])
    # as displayed, to a tenth of a degree
    shown = readout(page, "distal angle (deg)")
    assert shown == pytest.approx(stated["distal_angle_deg"], abs=0.0501)
    assert max(shown) < -150
    assert [float(energy) for energy in readout(page, "tendon energy (J)")] == stated["tendon_energy_J"]
    table = page.locator("#outcome table", has_text="State folded").locator("tbody tr")
    assert readout_texts(page, "distal angle (deg)") == [
        table.nth(vein).locator("td").first.inner_text() for vein in range(3)
    ]
    assert page.locator("#readout caption").inner_text().endswith(", folded (means)")
    assert (
        f"{angle_range(np.array(stated['distal_angle_deg']))} folded" in page.locator("figcaption").first.inner_text()
    )


def test_dragging_along_the_time_line_scrubs_to_the_same_place(opened, short_outcome):
    page = opened.page
    track = page.get_by_role("slider", name="time").bounding_box()
    folded = short_outcome.states["folded"].time
    share = page.evaluate(f"forficula.clock.shareAt({folded})")
    page.mouse.move(track["x"] + 20, track["y"] + track["height"] / 2)
    page.mouse.down()
    page.mouse.move(track["x"] + 9 + share * (track["width"] - 18), track["y"] + track["height"] / 2, steps=4)
    page.mouse.up()
    opened.settle()
    assert page.evaluate("forficula.clock.shareAt(forficula.clock.time)") == pytest.approx(share, abs=2e-3)
    assert max(readout(page, "distal angle (deg)")) < -140


def test_in_even_motion_the_time_line_is_stretched_where_the_wing_moves_in_real_time_it_is_not(opened, short_run):
    page = opened.page
    stage, whole = short_run.stages[1], short_run.time[-1] - short_run.time[0]
    speed, bands = page.get_by_label("speed"), ".band"
    widths = {}
    for name in ("even motion", "real time"):
        speed.select_option(name)
        opened.settle()
        widths[name] = [float(width.rstrip("%")) / 100 for width in page.eval_on_selector_all(bands, WIDTHS)]
        left, right = (
            page.evaluate(f"forficula.plots.charts[0].valToPos({item}, 'x')") for item in (stage.start, stage.end)
        )
        assert (right - left) / page.locator(".u-over").first.bounding_box()["width"] == pytest.approx(
            widths[name][0], abs=1e-3
        )
    assert widths["real time"][0] == pytest.approx((stage.end - stage.start) / whole, abs=1e-6)
    assert widths["even motion"][0] > 1.5 * widths["real time"][0]
    speed.select_option("even motion")


def test_from_every_side_the_wing_fills_the_picture_and_stays_in_it_all_through_the_run(opened):
    for towards in ([0.37, -0.695, 0.616], [0, -0.0005, 1], [0.9, 0.3, -0.3]):
        reaches = np.array(opened.page.evaluate(REACHES, towards))
        assert reaches.max() < 1
        # largest in the limiting direction; during the snap there is space for the moments before and after
        assert np.median(reaches.max(axis=1)) > 0.8
        assert reaches.max(axis=1).min() > 0.5


def test_without_following_the_camera_is_fixed(opened):
    page = opened.page
    places = []
    follow = page.get_by_role("button", name="follow: keep the picture filled as the structure moves")
    for pressed in ("false", "true"):
        follow.click()
        assert follow.get_attribute("aria-pressed") == pressed
        for state in "12":
            page.keyboard.press(state)
            opened.settle()
            places.append(page.evaluate("forficula.player.stage.eye.camera.position.toArray()"))
    assert places[0] == places[1]
    assert not np.allclose(places[2], places[3], rtol=0.05)


def seek(opened, moment):
    opened.page.evaluate("(moment) => { forficula.clock.seekClip(0, moment); }", float(moment))
    opened.settle()


def test_arrows_stand_where_torques_act_while_they_act_and_the_legend_says_how_strong_these_are(opened, short_run):
    arrows = "forficula.player.stage.views[0].shape.efforts.count()"
    ends = {end.stage.name: end for end in short_run.stages}
    for stage, share, count, said in (
        ("settle", 0.5, 0, "no drive acts now"),
        ("fold", 0.5, 3, "torque on every proximal joint: 50 N cm"),
        ("release folded", 0.5, 0, "no drive acts now"),
        ("unfold", 0.5, 6, "torque on every joint: 100 N cm"),
    ):
        seek(opened, ends[stage].start + share * (ends[stage].end - ends[stage].start))
        assert opened.page.evaluate(arrows) == count
        assert opened.page.locator(".legend .effort").inner_text() == said


def test_a_tendon_that_is_slack_is_drawn_as_long_as_it_is_at_rest_and_a_taut_one_straight(opened, short_run):
    lengths = """() => { const { instanceMatrix, count } = forficula.player.stage.views[0].shape.tendons;
    const pieces = count / 3; return [0, 1, 2].map((tendon) => Array.from({ length: pieces }, (_, piece) =>
      Math.hypot(...instanceMatrix.array.slice(16 * (tendon * pieces + piece) + 4, 16 * (tendon * pieces + piece) + 7)))
      .reduce((sum, each) => sum + each)); }"""
    rests = np.array([tendon.law.rest_length for tendon in short_run.structure.tendons])
    for end in short_run.stages[1:3]:
        seek(opened, end.start)
        now = short_run.series["tendon_length"][np.argmin(np.abs(short_run.time - end.start))]
        # chords of a parabola are shorter than its arc
        assert opened.page.evaluate(lengths) == pytest.approx(np.maximum(now, rests), rel=5e-3)
    assert now.max() < rests.min()  # the folded wing's tendons are slack


def test_the_sheet_takes_the_colours_of_its_strains_with_their_scale_and_its_own_again(opened, short_run):
    shape = shape_of(short_run.structure)
    end = next(end for end in short_run.stages if end.stage.name == "release folded")
    seek(opened, end.start)
    strained, stressed, painted = (
        opened.page.get_by_role("button", name=name, exact=True) for name in ("strain", "stress", "panels")
    )
    strained.click()
    values = (
        "(quantity) => { const { strains, vertices } = forficula.player.stage.views[0].shape;"
        " return [...strains.at(vertices, quantity)]; }"
    )
    result = opened.page.evaluate(values, "strain")
    # equal to the strains by face in the figure
    expected = face_strains(shape, surface_at(short_run, shape, end.start))
    assert max(result) == pytest.approx(expected.max(), rel=1e-2)
    scale = opened.page.locator(".legend .energy:visible").last.inner_text()
    assert re.fullmatch(r"largest Green strain of the membrane: 0\s*[\d.]+ %", scale)
    # and the stress by triangle as the export computes it
    (law,) = {membrane.law for membrane in short_run.structure.membranes}
    built, now = (
        np.concatenate([part[membrane.triangles] for part, membrane in zip(parts, membranes, strict=True)])
        for membranes in [short_run.structure.membranes]
        for parts in ([membrane.built for membrane in membranes], _nodes_at(short_run, end.start))
    )
    principal = principal_strains(built, now)
    stresses = opened.page.evaluate(values, "stress")
    assert max(stresses) == pytest.approx(principal_stresses(law, principal).max(), rel=1e-2)
    stressed.click()
    scale = opened.page.locator(".legend .energy:visible").last.inner_text()
    assert re.fullmatch(r"largest stress of the membrane \(second Piola-Kirchhoff\): 0\s*[\d.]+ [kM]?Pa", scale)
    assert opened.page.locator(".legend .of-region:visible").count() == 0
    painted.click()
    assert opened.page.locator(".legend .of-region:visible").count() == 2


def _nodes_at(record, moment):
    """Return the nodes of each membrane at a time, m, (node, 3)."""
    row = np.argmin(np.abs(record.time - moment))
    ends = np.cumsum([len(membrane.built) for membrane in record.structure.membranes])[:-1]
    return np.split(record.series["membrane_position"][row], ends)


def saved(opened, label):
    """Press a button that offers a file; returns the name of the file and its content."""
    with opened.page.expect_download() as download:
        opened.page.get_by_role("button", name=label).first.click()
    return download.value.suggested_filename, download.value.path().read_bytes()


def test_a_plot_is_saved_as_a_vector_drawing_on_white_with_axes_units_and_legend(opened):
    opened.show(scheme="dark")
    name, content = saved(opened, "download SVG of distal hinge angle")
    assert name == "binder2025-distal-hinge-angle.svg"
    drawing = ElementTree.fromstring(content)
    tags = [element.tag.partition("}")[2] for element in drawing.iter()]
    assert "image" not in tags
    texts = ["".join(element.itertext()) for element in drawing.iter() if element.tag.endswith("text")]
    assert {"Distal hinge angle (deg)", "time since the start of the run (s), stretched", "vein", "0", "−180"} <= set(
        texts
    )
    # the three veins in the colours of a light page, in the legend and in the plot
    strokes = [element.get("stroke") for element in drawing.iter() if element.get("stroke-width") == "1.6"]
    assert strokes == ["#0072b2", "#d55e00", "#008060"] * 2
    name, content = saved(opened, "download PNG of distal hinge angle")
    picture = matplotlib.image.imread(io.BytesIO(content))
    width, height = float(drawing.get("width")), float(drawing.get("height"))
    assert picture.shape[:2] == (int(3 * height), int(3 * width))
    assert picture[0, 0] == pytest.approx(1)


def test_the_picture_is_saved_sharp_and_its_motion_as_a_film_that_can_be_stopped(opened):
    go_to(opened, 1)
    before = time(opened.page)
    name, content = saved(opened, "download PNG of the picture")
    picture = matplotlib.image.imread(io.BytesIO(content))
    assert (name, picture.shape[1]) == ("binder2025-picture.png", 2400)
    coloured = np.ptp(picture[..., :3], axis=2) > 0.1
    assert 0.02 < coloured.mean() < 0.9
    # frames of films have one size: the scales below the picture have one place, however long the names of states are
    mark = "forficula.clips[0].marks[0]"
    opened.page.evaluate(f"{mark}.name += ' after a long name'.repeat(4)")
    _, content = saved(opened, "download PNG of the picture")
    go_to(opened, 0)
    _, other = saved(opened, "download PNG of the picture")
    assert matplotlib.image.imread(io.BytesIO(content)).shape == matplotlib.image.imread(io.BytesIO(other)).shape
    opened.page.evaluate(f"{mark}.name = {mark}.name.split(' after a long')[0]")
    go_to(opened, 1)
    film = opened.page.get_by_role("button", name="download a film as GIF")
    film.click()
    until(opened.page, "/[1-9] %/.test(document.querySelector('.films').textContent)")
    assert time(opened.page) != before
    film.click()
    until(opened.page, "[...document.querySelectorAll('.films button')][1].textContent === 'GIF'")
    opened.settle()
    assert time(opened.page) == before
    # recorded in real time, which passes faster for the page
    opened.page.evaluate("window.now = performance.now.bind(performance), performance.now = () => 8 * now()")
    name, content = saved(opened, "download a film as WebM")
    opened.page.evaluate("delete performance.now")
    assert (name, content[:4]) == ("binder2025-motion.webm", bytes.fromhex("1a45dfa3"))


def test_nothing_moves_on_a_phone_but_what_the_time_moves(opened):
    opened.show(390, 844)
    places = """async () => { const { clock } = forficula; const found = new Set();
      const parts = () => [".transport", ".legend", "#plots", "#readout", "#outcome"]
        .map((each) => Math.round(document.querySelector(each).getBoundingClientRect().top + scrollY)).join();
      for (let step = 0; step <= 40; step++) {
        clock.seek(clock.timeAt(step / 40));
        await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
        found.add(parts());
      }
      return found.size; }"""
    assert opened.page.evaluate(places) == 1
    hidden = "(tables) => tables.filter((table) => table.scrollWidth > table.clientWidth).length"
    assert opened.page.eval_on_selector_all("#readout .table, #outcome .table", hidden) == 0


@pytest.mark.parametrize("plot", [0, 1, 2])
def test_a_click_in_a_plot_moves_the_wing_to_that_time(opened, short_run, plot):
    page = opened.page
    place = page.locator(".u-over").nth(plot)
    box = place.bounding_box()
    place.click(position={"x": 0.3 * box["width"], "y": box["height"] / 2})
    opened.settle()
    share = page.evaluate("forficula.clock.shareAt(forficula.clock.time)")
    assert share == pytest.approx(0.3, abs=1.5 / box["width"])
    row = np.argmin(np.abs(short_run.time - time(page)))
    page.evaluate("(moment) => { forficula.clock.seek(moment); }", float(short_run.time[row]))
    opened.settle()
    assert furthest(record_points(short_run, row), drawn(page)) < EXACT


def test_the_keyboard_plays_steps_goes_to_the_states_turns_and_zooms(opened, short_outcome):
    page = opened.page
    page.locator("canvas").first.focus()
    eye = "forficula.player.stage.eye.camera.position.toArray()"
    for key, state in zip("123", short_outcome.states.values(), strict=True):
        page.keyboard.press(key)
        assert time(page) == pytest.approx(state.time)
    page.keyboard.press("ArrowLeft")
    assert time(page) < short_outcome.states["opened"].time
    page.keyboard.press("Home")
    assert time(page) == 0
    page.keyboard.press("End")
    assert time(page) == page.evaluate("forficula.clock.span.end")
    opened.settle()  # the camera follows in the next frame
    first = np.array(page.evaluate(eye))
    page.keyboard.press("Shift+ArrowLeft")
    turned = np.array(page.evaluate(eye))
    assert not np.allclose(first, turned)
    page.keyboard.press("+")
    middle = np.array(page.evaluate("forficula.player.stage.eye.controls.target.toArray()"))
    near = np.array(page.evaluate(eye))
    assert np.linalg.norm(near - middle) < np.linalg.norm(turned - middle)
    page.keyboard.press("0")
    assert np.allclose(page.evaluate(eye), first)
    page.keyboard.press(" ")
    assert page.evaluate("forficula.clock.playing")
    page.keyboard.press(" ")
    assert not page.evaluate("forficula.clock.playing")
    # dictated text presses letters and digits, so they work only in the player
    page.evaluate("document.activeElement.blur()")
    opened.settle()  # the camera follows what was played in the next frame
    before = (time(page), page.evaluate(eye))
    for key in ("2", "0", "+"):
        page.keyboard.press(key)
    assert (time(page), page.evaluate(eye)) == before


def test_screen_readers_hear_the_picture_the_plots_and_the_time(opened):
    page = opened.page
    assert "3 veins" in page.locator("canvas").first.get_attribute("aria-label")
    for plot in page.locator(".chart").all():
        assert "folded" in plot.get_attribute("aria-label")
    assert page.evaluate("document.documentElement.lang") == "en"
    page.get_by_role("button", name="b folded").click()
    opened.settle()
    until(page, "document.querySelector('.spoken').textContent.includes('b folded, distal angles')")
    said = page.get_by_role("slider", name="time").get_attribute("aria-valuetext")
    assert re.fullmatch(r"[\d.]+ s: b folded, distal angles −[\d.]+ to −[\d.]+ degrees", said)


@pytest.mark.parametrize(("width", "height"), [(360, 740), (640, 400)], ids=["a phone", "a laptop at 200 %"])
def test_nothing_is_wider_than_the_window_of(opened, width, height):
    page = opened.page
    opened.show(width, height)
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    assert (
        page.evaluate(
            "Math.max(...[...document.querySelectorAll('button, select')].map(e => e.getBoundingClientRect().right))"
        )
        <= width
    )


def test_dark_windows_get_light_text_on_dark_ground(opened):
    page = opened.page
    opened.show(scheme="dark")
    colours = page.evaluate("[getComputedStyle(document.body).color, getComputedStyle(document.body).backgroundColor]")
    ink, ground = (np.mean([int(part) for part in re.findall(r"\d+", colour)[:3]]) for colour in colours)
    assert ink > 200 > 60 > ground
    assert pixels(page).mean() < 120


def test_selected_elements_are_visible_with_forced_colours(opened):
    page = opened.page
    page.emulate_media(forced_colors="active")
    widths = page.evaluate(
        "['true', 'false'].map((pressed) => parseFloat(getComputedStyle("
        "document.querySelector(`button[aria-pressed=${pressed}]`)).borderTopWidth))"
    )
    swatch = page.evaluate("getComputedStyle(document.querySelector('.swatch.panel')).backgroundColor")
    page.emulate_media(forced_colors="none")
    assert widths[0] > widths[1]
    assert swatch == page.evaluate("getComputedStyle(document.querySelector('.swatch.panel')).backgroundColor")


def test_the_wing_moves_by_itself_only_for_readers_who_have_not_asked_for_less_motion(watch, report, one_page):
    moving = watch(report, reduced_motion="no-preference", viewport={"width": 320, "height": 480}).page
    until(moving, "forficula.clock.time > 0")
    assert one_page.time_when_opened == 0


@pytest.mark.parametrize(
    ("width", "height", "scheme"),
    [(1280, 1000, "light"), (1280, 1000, "dark"), (360, 600, "light")],
    ids=["light", "dark", "phone"],
)
def test_the_wing_plots_and_legend_do_not_overlap(opened, width, height, scheme):
    opened.show(width, height, scheme)
    for state in (0, 1):
        go_to(opened, state)
        check_shown(opened, scheme, rows=2 if width > 1000 else None)


@pytest.mark.parametrize(
    ("fault", "what"),
    [
        ("document.querySelector('canvas').style.visibility = 'hidden'", "nothing is drawn"),
        ("document.body.style.background = 'black'", "not a light page"),
        ("document.querySelector('.plots').style.display = 'block'", "plots below one another"),
        ("document.querySelector('.legend').style.display = 'none'", "no legend"),
        ("document.querySelector('.plots').style.marginTop = '-500px'", "one thing lies on another"),
    ],
)
def test_the_overlap_check_detects_missing_elements(opened, fault, what):
    """Control: otherwise the checks of appearance could not fail."""
    opened.show(1280, 1000)
    go_to(opened, 1)
    opened.page.evaluate(fault)
    try:
        with pytest.raises(AssertionError, match=what):
            check_shown(opened, rows=2)
    finally:
        for changed in (".plots", "canvas", ".legend", "body"):
            opened.page.locator(changed).first.evaluate("each => each.removeAttribute('style')")


def test_downloaded_the_design_repeats_the_run(opened, short_run, tmp_path):
    with opened.page.expect_download() as download:
        opened.page.get_by_role("link", name="Download design.toml").click()
    assert download.value.suggested_filename == "design.toml"
    download.value.save_as(tmp_path / "design.toml")
    again = run(load_design(tmp_path / "design.toml"))
    assert again.design.hash == short_run.design.hash
    for name, values in short_run.series.items():
        assert np.array_equal(again.series[name], values), name
    assert "forficula run design.toml" in opened.page.locator("#repeat").inner_text()


def test_announcements_are_not_made_in_every_frame(opened):
    live = opened.page.locator("[aria-live], [role=status], output")
    assert [item.get_attribute("class") for item in live.all()] == ["spoken"]


def test_where_the_script_fails_the_page_says_so_and_keeps_its_numbers(context, report):
    page = context.new_page()
    page.add_init_script("delete window.ResizeObserver; delete Array.prototype.findLast;")
    page.goto(report.as_uri())
    assert "cannot be shown in this browser" in page.get_by_role("alert").inner_text()
    # the three states, the transitions and the energy balance
    assert page.locator("#outcome table").count() == 5
    page.close()


def test_without_webgl_the_processor_draws_the_same_picture_and_the_page_says_so(context, report, opened):
    go_to(opened, 1)
    expected = pixels(opened.page, ".stage")
    page = context.new_page()
    page.set_viewport_size({"width": 800, "height": 600})
    page.emulate_media(reduced_motion="reduce")
    page.add_init_script(
        """const get = HTMLCanvasElement.prototype.getContext;
        HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
          return kind.startsWith("webgl") ? null : get.call(this, kind, ...rest);
        };"""
    )
    messages = []
    page.on("console", lambda message: messages.append(message.text))
    page.on("pageerror", lambda error: messages.append(str(error)))
    page.goto(report.as_uri())
    page.get_by_text("This browser has no WebGL").wait_for()
    page.get_by_role("button", name="b folded").click()
    until(page, "document.querySelector('#readout td').textContent.startsWith('\\u2212')")
    page.evaluate("scrollTo(0, 0)")
    result = pixels(page, ".stage")
    # edges and shadows differ
    assert (np.abs(result - expected).max(axis=2) > 24).mean() < 0.05
    assert (np.ptp(result, axis=2) > 24).mean() > 0.05
    assert messages == []
    page.close()


def test_the_work_for_a_frame_leaves_most_of_it_to_the_graphics_chip(opened):
    """A frame at 60 per second lasts 16.7 ms; drawing itself is not timed, because there is no graphics chip."""
    page = opened.page
    times = page.evaluate(
        """() => { const { clock, player, plots } = forficula; const { stage } = player; const { span } = clock;
        return Array.from({ length: 100 }, (_, step) => {
          clock.seek(span.start + (step / 100) * (span.end - span.start));
          const begin = performance.now();
          stage.pose();
          for (const view of stage.views) view.shape.sort(stage.eye.camera.position);
          for (const chart of plots.charts) chart.valToPos(clock.time, "x");
          return performance.now() - begin;
        }); }"""
    )
    assert np.median(times) < FRAME / 4
    drawn = page.evaluate("({ ...forficula.player.stage.statistics() })")
    assert drawn["calls"] <= 16
    assert drawn["triangles"] < 50_000


def test_nothing_is_drawn_while_nothing_changes(opened):
    frames = "forficula.player.stage.statistics().frame"
    before = opened.page.evaluate(frames)
    opened.page.wait_for_timeout(300)
    assert opened.page.evaluate(frames) == before
    opened.page.keyboard.press("ArrowRight")
    opened.settle()
    assert opened.page.evaluate(frames) > before


def test_areas_of_the_energies_add_up_to_the_energy_put_in_since_the_start_of_the_shown_time(opened, short_run):
    page, shares = opened.page, energy_shares(short_run)
    names = [item.inner_text() for item in page.locator(".plots figure").nth(3).locator(".key li").all()]
    assert names == ["losses", "motion", "membrane", "tendons", "supplied"]
    for span in (0, 2):
        page.evaluate("(span) => { forficula.clock.setSpan(forficula.clock.spans[span]); }", span)
        opened.settle()
        moments, top, motion, membrane, tendons, supplied = np.array(
            page.evaluate("forficula.plots.charts[3].data.map((row) => Array.from(row))")
        )
        start = page.evaluate("forficula.clock.span.start")
        rows = np.searchsorted(short_run.time, moments)
        lost = shares.lost - np.interp(start, short_run.time, shares.lost)
        assert tendons == pytest.approx(shares.stored["tendons"][rows], abs=1e-6)
        assert motion - membrane == pytest.approx(shares.kinetic[rows], abs=1e-6)
        assert top == pytest.approx((shares.held + lost)[rows], abs=1e-3)
        assert supplied - top == pytest.approx(shares.missing[rows], abs=1e-3)
    page.evaluate("forficula.clock.setSpan(forficula.clock.spans[0])")


def test_the_order_of_events_is_on_the_page(opened):
    said = opened.page.locator("#outcome p").first.inner_text()
    assert said.startswith('Stage "fold", times since its start: the turn begins to move at ')
