"""Page of parts to make, in a browser without network."""

import dataclasses
import itertools
import math
import re

import numpy as np
import pytest

from forficula.errors import InputError
from forficula.make.checks.check import Check
from forficula.make.hinge.strap_shape import strap_line
from forficula.make.make_parts import make_parts
from forficula.show.make.part_mesh import part_mesh
from forficula.show.make.part_poses import apart, poses_at
from forficula.show.page.parts_page import parts_page, write_parts_page
from forficula.structure import built_points
from tests.show.page.conftest import until

QUANTISED = 1e-6  # m: half of 1/65535 of 120 mm, and rounding of 4-byte floats
SMALL = (400, 400)  # pixels: the processor draws
BOWED = 2e-4  # m: error of interpolation between two stored shapes
CHECKS = (
    Check(name="least gap", part="fold0", ok=False, value=2.1e-4, limit=4e-4, unit="m", text="too near by 0.19 mm"),
    Check(name="stop", part="fold0", ok=True, value=math.pi / 60, limit=math.pi / 60, unit="rad", text="they meet"),
    Check(
        name="tears", part="strap0", ok=None, value=math.nan, limit=2.0, unit="", text="no source gives its strength"
    ),
)


@pytest.fixture(scope="module")
def parts(short_run):
    """A section of three veins whose joints turn by half a turn."""
    return make_parts(short_run.design, "section")


@pytest.fixture(scope="module")
def one_page(watch_all, parts, short_run, tmp_path_factory):
    path = tmp_path_factory.mktemp("parts") / "parts.html"
    write_parts_page(parts, CHECKS, path, short_run, files=["stl/proximal0.stl", "a b.csv"])
    assert path.stat().st_size < 1_080_000
    return watch_all(path)


@pytest.fixture
def opened(one_page):
    """The page as it opens."""
    one_page.show(*SMALL)
    one_page.page.evaluate(
        """() => { const { clock, run, choose } = forficula;
        clock.pause(); run.pause(); clock.seek(0);
        for (const select of document.querySelectorAll("#player > .choices select")) {
          select.value = "0"; select.dispatchEvent(new Event("change"));
        }
        for (const box of document.querySelectorAll(".kinds input:not(:checked)")) box.click();
        const slider = document.querySelector(".slide input");
        slider.value = 0; slider.dispatchEvent(new Event("input"));
        choose(null); document.activeElement.blur(); scrollTo(0, 0); }"""
    )
    one_page.settle()
    return one_page


def drawn(opened, name):
    """Return the corners of the triangles of a part as drawn now, m, (corner, 3)."""
    return np.array(opened.page.evaluate("name => forficula.shape.verticesOf(name)", name)).reshape(-1, 3)


def corners(part, parts):
    """Return the same corners in the built shape, m."""
    mesh = part_mesh(part, parts.joints)
    return mesh.points[mesh.triangles].reshape(-1, 3)


def hinge_to(opened, angle):
    """Turn the joints by the slider, rad."""
    slider = opened.page.get_by_role("slider", name="hinge angle")
    slider.evaluate(
        "(each, angle) => { each.value = angle; each.dispatchEvent(new Event('input')); }", math.degrees(angle)
    )
    opened.settle()


def rigid(one, other):
    """Return the rotation and translation between two sets of points (Kabsch 1976)."""
    middles = one.mean(axis=0), other.mean(axis=0)
    left, _, right = np.linalg.svd((one - middles[0]).T @ (other - middles[1]))
    turn = (left @ np.diag([1, 1, np.linalg.det(left @ right)]) @ right).T
    return turn, middles[1] - turn @ middles[0]


@pytest.mark.parametrize("angle", [math.radians(3), -1.2345, -math.pi])
def test_every_bar_is_drawn_where_its_joint_has_it(opened, parts, angle):
    hinge_to(opened, angle)
    poses = poses_at(parts, angle)
    for part in (part for part in parts.parts if part.kind == "bar"):
        place = poses[part.body].of(corners(part, parts))
        assert np.abs(drawn(opened, part.name) - place).max() < QUANTISED, part.name


def test_slack_straps_bow_as_elasticas_and_taut_ones_are_straight(opened, parts):
    place, joint = parts.straps[0], parts.joints[0]
    for angle in (0.0, -1.5, -math.pi):
        hinge_to(opened, angle)
        pose = poses_at(parts, angle)[joint.distal.body]
        exact = strap_line(place, place.ends[0, 0], pose.of(place.ends[0, 1]), joint.frame[:, 1], 1)
        # four sides of the tube at every point except the last, two triangles each
        rails = drawn(opened, "strap0")[: 32 * 24].reshape(32, 4, 6, 3)[:, :, 0].mean(axis=1)
        shares = np.linspace(0, 1, len(exact))
        line = np.column_stack([np.interp(np.arange(32) / 32, shares, axis) for axis in exact.T])
        assert np.abs(rails - line).max() < BOWED, angle


def test_the_recorded_run_moves_bars_as_the_simulator_did(opened, parts, short_run):
    opened.page.get_by_label("motion").select_option("as in the simulated run")
    structure = short_run.structure
    built = built_points(structure)
    moved = [part.body for part in parts.parts if part.kind == "bar"][1::2]
    for row in np.linspace(0, len(short_run.time) - 1, 3).astype(int):
        opened.page.evaluate("moment => forficula.run.seek(moment)", float(short_run.time[row]))
        opened.settle()
        for part in (part for part in parts.parts if part.body in moved):
            turn, way = rigid(corners(part, parts), drawn(opened, part.name))
            indices = [number for number, point in enumerate(structure.points) if point.body == part.body]
            present = short_run.series["point_position"][row, indices]
            # angles are 4-byte floats, interpolated between kept rows
            assert np.abs(built[indices] @ turn.T + way - present).max() < 1e-5, (row, part.name)


def test_in_the_exploded_view_every_part_has_its_displacement(opened, parts):
    slider = opened.page.get_by_label("take apart")
    slider.focus()
    slider.press("End")
    hinge_to(opened, 0.0)
    for part, way in zip(parts.parts, apart(parts), strict=True):
        if part.kind not in ("strap", "root"):
            assert np.abs(drawn(opened, part.name) - corners(part, parts) - way).max() < QUANTISED, part.name
    hub, *rods = (drawn(opened, part.name) for part in parts.parts if part.kind in ("hub", "root"))
    assert len(rods) == 3
    # the direction away from its rods is x
    assert all(rod[:, 0].min() > hub[:, 0].max() for rod in rods)


def test_the_keyboard_turns_joints_degree_by_degree_and_from_stop_to_stop(opened):
    page = opened.page
    slider = page.get_by_role("slider", name="hinge angle")
    slider.focus()
    for key, angle in (("Home", -180), ("ArrowRight", -179), ("PageUp", -169), ("End", 3), ("ArrowLeft", 2)):
        slider.press(key)
        opened.settle()
        assert page.locator(".time").inner_text().startswith(f"{angle:.1f}°,".replace("-", "−"))
    slider.press("Home")
    opened.settle()
    assert re.search(r"straps slack by \d", slider.get_attribute("aria-valuetext"))
    assert page.get_by_role("button", name="folding stop").get_attribute("aria-pressed") == "true"
    slider.press(" ")
    until(page, "forficula.clock.playing")
    slider.press(" ")


def test_hidden_parts_are_not_drawn_and_pressing_a_part_describes_it(opened, parts):
    page = opened.page
    seen = "forficula.shape.group.children.filter(each => each.isMesh && each.visible).length"
    assert page.evaluate(seen) == len(parts.parts)
    page.get_by_label("strap, 6").uncheck()
    opened.settle()
    assert page.evaluate(seen) == len(parts.parts) - 3
    page.get_by_role("button", name="distal1").click()
    output = page.locator(".chosen").inner_text()
    assert re.fullmatch(r"distal1: distal bar of petg, [\d.]+ g, [\d.]+ × [\d.]+ × [\d.]+ mm", output)
    page.get_by_label("root, 3").uncheck()
    page.locator("canvas").scroll_into_view_if_needed()
    # position of the hub's centre in the window
    hub = drawn(opened, "hub").mean(axis=0).tolist()
    x, y = page.evaluate(
        """place => { const { stage } = forficula; const { camera, target } = stage.eye;
        const point = target.clone().fromArray(place).project(camera); const box = stage.canvas.getBoundingClientRect();
        return [box.left + (point.x + 1) / 2 * box.width, box.top + (1 - point.y) / 2 * box.height]; }""",
        hub,
    )
    page.mouse.click(x, y)
    assert page.locator(".chosen").inner_text().startswith("hub: hub of petg")
    assert page.get_by_role("button", name="hub").get_attribute("aria-pressed") == "true"


def test_checks_are_described_in_words_and_failures_come_first(opened):
    page = opened.page
    rows = page.locator("#checks tbody tr").all_inner_texts()
    assert [row.split("\t")[1:] for row in rows] == [
        ["failed", "0.21 mm", "0.4 mm"],
        ["not checked", "–", "2"],
        ["passed", "3 deg", "3 deg"],
    ]
    assert "1 of 2 checks fails" in page.locator(".outcome").inner_text()
    assert "fatigue" in page.locator("#honest").inner_text().lower()
    links = [item.get_attribute("href") for item in page.locator("#files a").all()]
    assert links == ["stl/proximal0.stl", "a%20b.csv"]


def test_the_page_fits_a_phone_without_console_messages_or_requests(opened):
    for scheme, width in itertools.product(("light", "dark"), (390, 1280)):
        opened.show(width, 844, scheme)
        assert opened.page.evaluate("document.documentElement.scrollWidth") == width
    assert opened.messages == []
    assert len(opened.requests) == 1


def test_the_same_parts_give_the_same_bytes_and_another_run_is_refused(parts, short_run, letter_run):
    assert parts_page(parts, CHECKS, short_run) == parts_page(parts, CHECKS, short_run)
    with pytest.raises(InputError, match="record: need a run of the design of the parts, binder2025"):
        parts_page(parts, CHECKS, letter_run)


def test_a_sheet_alone_has_a_page_on_which_nothing_moves():
    parts = make_parts("letter-fold", "sheet")
    page = parts_page(parts, parts.sheet.checks)
    assert page.count("<script") == 1  # saves figures
    assert 'id="data"' not in page
    assert "The finished sheet is 297.0 mm × 210.0 mm." in page
    assert "<svg" in page
    assert "<svg" not in parts_page(dataclasses.replace(parts, sheet=None), ())
