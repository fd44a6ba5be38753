"""Fold path on the page of a structure: its shapes and numbers, and the slider that moves through them."""

import base64
import json
from dataclasses import replace

import numpy as np
import pytest

from forficula.design import load_design
from forficula.show.page import write_run_page
from forficula.show.page.data.fold_view import fold_view
from forficula.show.page.data.shape_mesh import shape_mesh
from forficula.show.page.data.shown_path import fold_of, without_crossing
from forficula.show.page.run_page import run_page
from forficula.statics import quasi_static_path
from forficula.statics.landscape import net_courses
from forficula.statics.net.driven.net_point import place_positions
from forficula.structure import structure_of
from tests.memory_strips import DAMAGE, YIELD, changed
from tests.plate_sheets import pushed, stage
from tests.show.page.conftest import until
from tests.show.page.test_page import data_of
from tests.workbench.test_server import SQUARE


def decoded(steps):
    """Return the numbers of `packed_steps`, (row, column)."""
    low, step = np.array(steps["low"]), np.array(steps["step"])
    return low + step * np.frombuffer(base64.b64decode(steps["steps"]), "<u2").reshape(-1, len(low))


def floats(text, kind="f4"):
    return np.frombuffer(base64.b64decode(text), f"<{kind}").astype(float)


@pytest.fixture(scope="module")
def tower(landscape_of):
    """The landscape of a tower that snaps under a force, and its fold path on a page."""
    landscape = landscape_of(load_design("kresling-cell"))
    return landscape, fold_view(fold_of(landscape.structure).path, beside_run=False)


def test_shapes_on_the_page_are_those_of_the_landscape_s_course(tower):
    landscape, view = tower
    structure, course = landscape.structure, net_courses(landscape)[0]
    clip, anchors = view["clips"][0], shape_mesh(landscape.structure).anchors
    points = decoded(clip["points"])
    force = floats(clip["along"][1]["values"])
    first = int(np.argmax(floats(clip["time"], "f8") >= clip["marks"][1]["time"])) + 1  # up to the snap
    assert clip["marks"][1]["name"] == "snap"
    assert clip["along"][1] == clip["along"][1] | {"name": "force", "unit": "N"}
    for point in course.slow.paths[0].points:
        wanted = place_positions(structure, landscape.net.net, point.shape)[anchors].ravel()
        # both are linear between their points, and the course has longer steps
        at = point.factor * abs(course.drive.strength)
        shown = np.array([np.interp(at, force[:first], column[:first]) for column in points.T])
        assert np.abs(shown - wanted).max() < 2e-3 * structure.span
    assert force[first - 1] == pytest.approx(course.slow.snaps[0].factor * abs(course.drive.strength), rel=1e-3)


def test_a_snap_ends_at_the_goal_where_panels_would_pass_through_each_other(tower):
    landscape, view = tower
    path, whole = fold_of(landscape.structure).path, quasi_static_path(landscape.structure)
    assert np.abs(whole.angles).max() > np.radians(200)  # under the force, statics fold the tower into itself
    assert np.abs(path.angles).max() < np.pi
    assert path.reached
    assert [mark["name"] for mark in view["clips"][0]["marks"]] == ["tall", "snap", "goal"]
    assert "beyond it panels of the sheet pass through each other" in view["notes"][-1]


def test_readings_of_single_creases_are_the_angles_and_moments_of_statics(tower):
    landscape, view = tower
    path, creases = fold_of(landscape.structure).path, view["clips"][0]["creases"]
    share, values = floats(view["clips"][0]["time"], "f8") / 100, decoded(creases["values"])
    assert [line["name"] for line in creases["lines"]] == [f"crease {number}" for number in range(12)]
    for number, line in enumerate(creases["lines"]):
        angle, moment = line["columns"]
        assert creases["columns"][angle] == {"name": "angle", "unit": "°"}
        wanted = np.degrees(np.interp(share, path.share, path.angles[:, number]))
        assert values[:, angle] == pytest.approx(wanted, abs=0.01)
        wanted = 1e5 * np.interp(share, path.share, path.moments[:, number])
        assert values[:, moment] == pytest.approx(wanted, abs=1e-3 * np.abs(wanted).max())
        assert creases["columns"][moment]["unit"] == "mN cm"


def test_energies_by_part_add_up_to_the_total(tower):
    plot = tower[1]["plots"][0]
    total, *parts = (floats(line["values"]) for line in plot["lines"])
    assert (plot["lines"][0]["name"], plot["ball"]) == ("total", 0)
    assert sum(parts) == pytest.approx(total, abs=1e-5 * total.max())


def test_statics_that_fail_do_not_cost_the_page_of_a_run(short_run, monkeypatch):
    def fail(*_, **__):
        raise np.linalg.LinAlgError("Singular matrix")

    monkeypatch.setattr("forficula.show.page.data.shown_path.quasi_static_path", fail)
    fold = fold_of(short_run.structure)
    assert fold.missing == "This page has no fold path, because its computation failed: Singular matrix."


def test_a_structure_that_stores_no_energy_has_no_plot_of_it():
    structure = structure_of(pushed(0.01, [stage(drive="push")]))
    view = fold_view(fold_of(structure).path, beside_run=False)
    assert "energy" not in [plot["title"] for plot in view["plots"]]
    assert [number["name"] for number in view["clips"][0]["along"]] == ["torque"]


def test_a_small_budget_leaves_out_shapes_but_no_event(tower):
    path = fold_of(tower[0].structure).path
    view = fold_view(path, beside_run=False, budget=3000)
    time = floats(view["clips"][0]["time"], "f8")
    assert len(time) < len(floats(tower[1]["clips"][0]["time"], "f8"))
    for mark in path.marks:
        assert np.abs(time / 100 - mark.share).min() < 2e-3


def test_a_structure_without_a_drive_gets_a_sentence_that_says_why_it_has_no_path(
    short_run, short_outcome, monkeypatch
):
    fold = fold_of(replace(short_run.structure, drives=(), transitions=()))
    assert fold.path is None
    assert fold.missing.startswith("This page has no fold path: binder2025: need a drive that folds it")
    monkeypatch.setattr("forficula.show.page.run_page.fold_of", lambda _: fold)
    page = run_page(short_run, short_outcome)
    assert f"<p class=note>{fold.missing}</p>" in page
    assert data_of(page)["paths"] == []


@pytest.fixture(scope="module")
def opened(watch_all, short_run, short_outcome, tmp_path_factory):
    path = tmp_path_factory.mktemp("fold") / "report.html"
    write_run_page(short_run, short_outcome, path, engine=False)
    opened = watch_all(path)
    assert opened.page.locator(".modes button").all_inner_texts() == ["motion", "fold"]
    opened.page.get_by_role("button", name="fold", exact=True).click()
    opened.settle()
    return opened


def test_the_keyboard_moves_shape_energy_and_ball_along_the_path(opened, short_run):
    page, path = opened.page, fold_of(short_run.structure).path
    page.get_by_role("slider", name="fold", exact=True).focus()
    seen = []
    for key, share in (("Home", 0.0), ("PageUp", 0.05), ("End", 1.0), ("PageDown", 0.95)):
        page.keyboard.press(key)
        until(page, f"Math.abs(forficula.clock.time - {100 * share}) < 1e-9")
        opened.settle()
        point = path.point(share)
        vertices = page.evaluate("Array.from(forficula.player.stage.views[0].shape.vertices)")
        ends = point.positions[[end for bar in short_run.structure.bars for end in bar.points]]
        away = np.linalg.norm(ends[:, None] - np.reshape(vertices, (-1, 3)), axis=2).min(axis=1)
        assert away.max() < 1e-3 * short_run.structure.span
        energy = sum(point.energy.values())
        text = page.locator(".time").inner_text()
        assert text.startswith(f"{100 * share:.1f} % · ")
        ball = """(() => {
            const { charts: [chart] } = forficula.plots, box = chart.over.getBoundingClientRect();
            const { x, y, width, height } = chart.over.querySelector(".ball").getBoundingClientRect();
            return [chart.posToVal(x + width / 2 - box.x, "x"), chart.posToVal(y + height / 2 - box.y, "y")]; })()"""
        assert page.evaluate(ball) == pytest.approx([100 * share, energy], abs=0.005)
        seen.append(text)
    assert len(set(seen)) == 4
    assert 'The wing snaps when the drive "fold" reaches' in page.locator("#player").inner_text()
    assert opened.messages == []


def test_a_position_of_the_slider_takes_so_little_of_a_processor_that_a_phone_draws_thirty_per_second(opened):
    page, count = opened.page, 20
    session = page.context.new_cdp_session(page)
    session.send("Performance.enable", {"timeDomain": "threadTicks"})  # does not count other programs

    def spent():
        metrics = {item["name"]: item["value"] for item in session.send("Performance.getMetrics")["metrics"]}
        return sum(metrics[f"{kind}Duration"] for kind in ("Script", "Layout", "RecalcStyle"))

    before = spent()
    page.evaluate(
        "async (count) => { for (let at = 0; at < count; at++) { forficula.clock.seek((100 * at) / count);"
        " await new Promise(requestAnimationFrame); } }",
        count,
    )
    # a phone is assumed to be four times as slow; the graphics chip draws at the same time
    assert (spent() - before) / count < 1 / 30 / 4


def test_a_crease_is_read_by_pointer_touch_and_list(opened, short_run):
    page, path = opened.page, fold_of(short_run.structure).path
    page.evaluate("forficula.clock.seek(30)")
    opened.settle()
    page.get_by_role("combobox", name="hinge").select_option(label="vein 0, ring")
    wanted = np.degrees(path.point(0.3).angles[3])
    output = page.locator(".crease-choice output").inner_text()
    assert float(output.removeprefix("angle ").partition("°")[0].replace("−", "-")) == pytest.approx(wanted, abs=0.1)
    assert page.locator(".crease-label").inner_text() == f"vein 0, ring: {output}"
    # pressing the middle of the same bar releases it, and pressing again chooses it
    page.evaluate("scrollTo(0, 0)")
    box = page.locator(".crease-mark").bounding_box()
    middle = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.click(*middle)
    assert page.get_by_role("combobox", name="hinge").input_value() == ""
    page.mouse.click(*middle)
    assert page.locator(".crease-label").inner_text().startswith("vein 0, ring")
    # a pointer shows another one while it is there
    page.mouse.move(5, 5)
    assert page.locator(".crease-label").inner_text().startswith("vein 0, ring")


def test_switching_between_motion_and_fold_keeps_the_view_of_the_eye_and_both_positions(opened):
    page = opened.page
    page.get_by_role("button", name="turn left").click()
    towards = "forficula.player.stage.eye.look.towards.toArray()"
    seen = page.evaluate(towards)
    page.evaluate("forficula.clock.seek(40)")
    page.get_by_role("button", name="motion", exact=True).click()
    opened.settle()
    assert page.get_by_role("slider", name="time").count() == 1
    assert page.evaluate(towards) == pytest.approx(seen)
    page.get_by_role("button", name="fold", exact=True).click()
    opened.settle()
    assert page.evaluate("forficula.clock.time") == 40
    assert page.evaluate("document.querySelectorAll('#player canvas').length") == 1


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_the_fold_slider_and_the_energy_curve_fit_a_phone(opened, scheme):
    opened.show(390, 844, scheme)
    assert opened.page.evaluate("document.documentElement.scrollWidth") == 390
    # the strength of the drive is the last number beside the position
    cut = """async () => { const { clock } = forficula; const before = clock.time; let cut = false;
      for (let share = 0; share <= 1; share += 0.02) {
        clock.seek(clock.timeAt(share));
        await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
        const { scrollWidth, clientWidth } = document.querySelector(".transport .time");
        cut ||= scrollWidth > clientWidth;
      }
      clock.seek(before);
      return cut; }"""
    assert not opened.page.evaluate(cut)
    ends = """['.player', '.picture', '.profile', '.track'].map((each) => {
        const { top, bottom } = document.querySelector(each).getBoundingClientRect();
        return each === ".player" ? top : bottom; })"""
    start, *bottoms = opened.page.evaluate(ends)
    assert bottoms == sorted(bottoms)
    assert bottoms[-1] - start < 844  # picture, curve and slider are visible at once
    opened.show()


def test_a_path_that_ends_where_panels_cross_has_the_moments_of_its_points(tmp_path):
    """The permanent folds of creases are cut with the other values of the points."""
    (tmp_path / "door.fold").write_text(json.dumps(SQUARE), "utf-8")
    whole = quasi_static_path(structure_of(load_design(tmp_path / "door.fold")))
    crossing = replace(whole, angles=2 * whole.angles)
    path = without_crossing(crossing)
    count = len(path.share)
    assert 1 < count < len(whole.share)
    assert path.moments == pytest.approx(crossing.moments[:count])


def test_the_notes_state_what_creases_dissipate_and_how_much_wear_leaves():
    notes = fold_view(quasi_static_path(changed("plates", laws=DAMAGE | YIELD)), beside_run=False)["notes"]
    (note,) = [note for note in notes if "dissipate" in note]
    assert note == (
        "On the path creases dissipate 4.23 mJ by permanent folds and 1.28 mJ by wear. At its end wear has left at"
        " least 65.5 % of the moment of every crease."
    )
