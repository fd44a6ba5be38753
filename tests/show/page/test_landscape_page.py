"""Page of a landscape: energy curves, and the position of a run on them."""

from dataclasses import replace

import numpy as np
import pytest

from forficula.analysis.simulated_snap import inner_hinge
from forficula.design import load_design
from forficula.show.page.data.landscape_curves import curve_data, landscape_curves, run_travel
from forficula.show.page.data.landscape_poses import poses_of, poses_travel
from forficula.show.page.landscape_page import landscape_page
from forficula.statics import energy_landscape
from forficula.statics.tree.ensemble import ensemble
from forficula.statics.tree.pose import carried_points, places_of, pose, tree_of
from forficula.statics.tree.potential import stored_energy
from forficula.study.running.runs import run
from tests.show.page.conftest import until
from tests.show.page.test_page import HOSTILE, data_of


def posed_points(structure, angles):
    """Return the positions of the structure's points at hinge angles, m, (point, 3), and its pose."""
    tree = tree_of(structure)
    at = pose(tree, angles[np.newaxis])
    carried = carried_points(
        tree, [point.body for point in structure.points], np.array([point.place for point in structure.points])
    )
    return places_of(carried, at)[:, 0].T, at


def on_line(course, line):
    """Return the energies of a line at the angles of a course, J, nan beyond its ends."""
    order = np.argsort(line.angle)
    return np.interp(course.angle, line.angle[order], line.energy[order], left=np.nan, right=np.nan)


@pytest.fixture(scope="module")
def curves(surveyed, short_run):
    return landscape_curves(surveyed("reference"), run_travel(short_run))


def test_every_tendon_that_was_simulated_is_on_the_curve_of_statics(curves, short_run):
    curve = curves[0]
    assert [ball.name for ball in curve.balls] == ["0", "1", "2"]
    for ball in curve.balls:
        assert len(ball.angle) == len(short_run.time)
        apart = np.abs(ball.energy - on_line(ball, curve.lines[0]))
        # 1e-4 of 0.18 J; the run exceeds its stops by some hundredths of a degree
        assert np.nanmax(apart) < 2e-5
        assert np.isfinite(apart).mean() > 0.3


def test_interpolated_lines_follow_the_closed_form(curves, surveyed):
    landscape, line = surveyed("reference"), curves[0].lines[0]
    actual = landscape.tendons[1]
    exact = actual.stored_energy(actual.sense * line.angle)
    assert np.abs(line.energy - exact).max() < 1e-6 * exact.max()


def test_a_run_is_on_the_curve_at_rest_and_leaves_it_during_the_snap(curves, short_run):
    curve, ends = curves[1], [end.end for end in short_run.stages]
    apart = np.abs(curve.balls[0].energy - on_line(curve.balls[0], curve.lines[0]))
    rows = np.searchsorted(short_run.time, [ends[2], ends[-1]]) - 1
    assert np.nanmax(apart[rows]) < 0.01 * curve.lines[0].energy.max()
    assert np.nanmax(apart) == pytest.approx(short_run.series["membrane_energy"].max(), rel=0.2)


def test_gravitational_energy_has_the_reference_level_of_statics():
    still = {"name": "settle", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "20 ms"}
    design = load_design("binder2025", {"protocol.gravity": "9.81 m/s^2", "protocol.stages": [still]})
    record = run(design)
    landscape = energy_landscape(design, points=31)
    ball = landscape_curves(landscape, run_travel(record))[1].balls[0]
    rows = [0, -1]
    angles = record.series["hinge_angle"][rows]
    parts = stored_energy(ensemble([record.structure]), angles)
    assert abs(parts["weight"][1] - parts["weight"][0]) > 1e-5
    assert ball.energy[rows] == pytest.approx(sum(parts.values()), abs=2e-5)


def test_tendons_with_springs_are_on_the_sum_of_both_in_the_sense_of_their_hinges(surveyed):
    landscape = surveyed("plates")
    (curve,) = landscape_curves(landscape, run_travel(run(landscape.design)))
    assert curve.lines[0].name == "tendon and spring"
    assert not curve_data(curve)["backwards"]
    assert [ball.name for ball in curve.balls] == ["left", "right"]
    for ball in curve.balls:
        assert np.nanmax(np.abs(ball.energy - on_line(ball, curve.lines[0]))) < 1e-4 * curve.lines[0].energy.max()
        assert ball.angle.max() > np.radians(90)


@pytest.mark.parametrize("name", ["own tendons", "off the bars", "slack", "soft plates", "small"])
def test_every_landscape_with_a_curve_has_its_states_on_it(surveyed, name):
    for curve in landscape_curves(surveyed(name)):
        assert curve.balls == ()
        for mark in curve.marks:
            off = np.abs(on_line(mark, curve.lines[0]) - mark.energy)
            assert np.nanmax(off) <= 2e-3 * curve.lines[0].energy.max() + 1e-12
        curve_data(curve)


def test_a_diverged_run_is_reported_and_not_played(surveyed, short_run, tmp_path):
    page = landscape_page(surveyed("reference"), tmp_path, {}, replace(short_run, diverged_at=0.01))
    assert data_of(page)["kind"] == "curves"
    assert "Run of this design" not in page
    assert "The simulated wing: diverged" in page


def test_a_design_with_a_hostile_name_stays_text(surveyed, tmp_path):
    landscape = surveyed("reference")
    named = replace(landscape, design=landscape.design.model_copy(update={"name": HOSTILE}))
    assert landscape_page(named, tmp_path, {}).count("<script") == 2


@pytest.fixture(scope="module")
def pages(surveyed, short_run, tmp_path_factory):
    folder = tmp_path_factory.mktemp("landscape")
    for name, record in (("run", short_run), ("still", None)):
        page = landscape_page(surveyed("reference"), folder, {}, record)
        (folder / f"{name}.html").write_text(page, "utf-8")
    return folder


@pytest.fixture(scope="module")
def opened(watch_all, pages):
    return watch_all(pages / "run.html")


def balls(page, curve=0):
    """Return where balls are drawn, and where they should be, pixels, (ball, 2)."""
    script = """(number) => {
        const { chart, now } = forficula.curves[number], box = chart.over.getBoundingClientRect();
        const drawn = [...chart.over.querySelectorAll(".ball")].map((ball) => {
            const { x, y, width, height } = ball.getBoundingClientRect();
            return [x + width / 2 - box.x, y + height / 2 - box.y]; });
        return [drawn, now.map(([angle, energy]) => [chart.valToPos(angle, "x"), chart.valToPos(energy, "y")])]; }"""
    return np.array(page.evaluate(script, curve))


def test_the_balls_follow_the_clock(opened, curves, short_run):
    for row in np.linspace(0, len(short_run.time) - 1, 4).astype(int):
        opened.page.evaluate("(moment) => { forficula.clock.seek(moment); }", float(short_run.time[row]))
        opened.settle()
        now = np.array(opened.page.evaluate("forficula.curves[0].now"))
        for (angle, energy), ball in zip(now, curves[0].balls, strict=True):
            # interpolated between frames
            assert angle == pytest.approx(np.degrees(ball.angle[row]), abs=0.2)
            assert energy == pytest.approx(ball.energy[row], abs=2e-4)
        drawn, wanted = balls(opened.page)
        assert drawn == pytest.approx(wanted, abs=0.1)
    assert opened.messages == []


def test_pressing_a_curve_moves_the_clock_to_the_nearest_time(opened):
    page = opened.page
    for angle, energy in ((-30.0, 0.12), (-170.0, 0.0)):
        script = "([x, y]) => { const { chart } = forficula.curves[0], box = chart.over.getBoundingClientRect();"
        script += " return [box.x + chart.valToPos(x, 'x'), box.y + chart.valToPos(y, 'y')]; }"
        page.evaluate("forficula.curves[0].element.scrollIntoView({ block: 'center' })")
        page.mouse.click(*page.evaluate(script, [angle, energy]))
        opened.settle()
        near = min(abs(place - angle) for place, _ in page.evaluate("forficula.curves[0].now"))
        assert near < 5


def test_the_barrier_can_be_seen_close_up(opened):
    page = opened.page
    page.get_by_role("button", name="barrier enlarged").click()
    opened.settle()
    low, high = page.evaluate("[forficula.curves[0].chart.scales.y.min, forficula.curves[0].chart.scales.y.max]")
    # 0.69 mJ of 0.18 J
    assert 1e-3 < high - low < 3e-3
    drawn, wanted = balls(page)
    assert drawn == pytest.approx(wanted, abs=0.1)
    page.get_by_role("button", name="whole curve").click()
    opened.settle()
    assert page.evaluate("forficula.curves[0].chart.scales.y.min") < 0


@pytest.mark.parametrize(("width", "height", "scheme"), [(1280, 900, "dark"), (390, 844, "light")])
def test_the_page_fits_a_desktop_and_a_phone(opened, width, height, scheme):
    opened.show(width, height, scheme)
    assert opened.page.evaluate("document.documentElement.scrollWidth") == width
    until(opened.page, "forficula.curves.every(({ chart }) => chart.width <= innerWidth)")
    opened.show()


@pytest.fixture(scope="module")
def still(watch_all, pages):
    return watch_all(pages / "still.html")


def test_without_a_run_a_slider_moves_the_structure_along_its_rigid_fold_with_the_balls_on_its_curves(still, surveyed):
    page, landscape = still.page, surveyed("reference")
    path, structure = landscape.fold_path, landscape.structure
    slider = page.get_by_role("slider", name="rigid fold")
    slider.focus()
    for key, place in (("End", -1), ("Home", 0)):
        page.keyboard.press(key)
        until(page, f"forficula.clock.time === {100 * (place < 0)}")
        still.settle()
        vertices = page.evaluate("Array.from(forficula.player.stage.views[0].shape.vertices)")
        points, _ = posed_points(structure, path.angles[place])
        # every drawn end of a bar agrees with the kinematics, to the 65535th part of the range of its coordinate
        ends = np.array([points[point] for bar in structure.bars for point in bar.points])
        away = np.linalg.norm(ends[:, None] - np.reshape(vertices, (-1, 3)), axis=2).min(axis=1)
        assert away.max() < 1e-5 * structure.span
        (ball,) = page.evaluate("forficula.curves[1].now")
        assert ball == pytest.approx([-np.degrees(path.ring_angle[place]), path.energy[place]], abs=1e-4)
        drawn, wanted = balls(page, 1)
        assert drawn == pytest.approx(wanted, abs=0.1)
        assert all(angle == pytest.approx(ball[0], abs=0.01) for angle, _ in page.evaluate("forficula.curves[0].now"))
    assert page.locator(".time").inner_text() == f"0.0 % · energy {path.energy[0]:.3g} J"
    assert still.messages == []
    assert len(still.requests) == 1


def test_a_path_under_the_drive_is_beside_the_rigid_fold(still):
    page = still.page
    names = page.locator(".modes button").all_inner_texts()
    assert names == ["rigid fold", "fold"]
    page.get_by_role("button", name="fold", exact=True).click()
    assert page.get_by_role("slider", name="fold", exact=True).count() == 1
    assert page.evaluate("forficula.curves.length") == 2
    page.get_by_role("button", name="rigid fold").click()


def test_a_hinge_that_turns_alone_moves_its_plate_unless_it_is_tied_to_others(surveyed, tmp_path):
    plates = surveyed("plates")
    data = data_of(landscape_page(plates, tmp_path, {}))
    assert data["paths"][0]["notes"] == ["This hinge turns alone; all others keep their starting angles."]
    assert [path["name"] for path in data["paths"]] == ["one hinge", "fold"]
    shown = inner_hinge(plates)
    poses = poses_of(plates, shown)
    assert np.ptp(poses.angles, axis=0) == pytest.approx(
        [np.ptp(shown.actual.angle) if hinge == shown.hinge else 0 for hinge in range(len(plates.structure.hinges))]
    )
    tied = replace(plates, structure=replace(plates.structure, couplings=(None,)))
    assert poses_of(tied, shown) is None


def test_poses_have_the_energy_of_the_curve_on_which_they_are(surveyed):
    for name in ("reference", "plates"):
        landscape = surveyed(name)
        for curve in landscape_curves(landscape, poses_travel(poses_of(landscape, inner_hinge(landscape)))):
            for ball in curve.balls:
                assert (
                    np.nanmax(np.abs(ball.energy - on_line(ball, curve.lines[0]))) < 1e-4 * curve.lines[0].energy.max()
                )
