"""Pages of goals, in a browser without network."""

import csv
import io

import numpy as np
import pytest

from tests.show.page.conftest import until

KEPT = "forficula.panel.playing?.run.point"


@pytest.fixture(scope="module")
def pages_of_goals(watch_all, goals):
    return {kind: watch_all(path) for kind, (_, path) in goals.items()}


@pytest.fixture
def optimise(pages_of_goals):
    return as_it_opens(pages_of_goals["optimise"])


@pytest.fixture
def tolerance(pages_of_goals):
    return as_it_opens(pages_of_goals["tolerance"])


@pytest.fixture
def identify(pages_of_goals):
    return as_it_opens(pages_of_goals["identify"])


def as_it_opens(opened):
    """Without selected ranges, in a window of the initial size."""
    page = opened.page
    page.set_default_timeout(10_000)
    opened.show()
    button = page.locator(".lines button", has_text="show all")
    if button.is_visible():
        button.click()
    page.evaluate("document.activeElement.blur(); scrollTo(0, 0)")
    opened.settle()
    return opened


def mark(page, point):
    return page.locator(f".scatter [data-point='{point}']")


def handle(page, name):
    return page.get_by_role("slider", name=name, exact=True)


def choose(page, label, option):
    page.locator(f".map label[data-name='{label}'] select").select_option(label=option)


def shown(page):
    """Return the numbers of the rows that the table displays."""
    return [int(text) for text in page.locator("#points tbody tr:not([hidden]) th").all_inner_texts()]


def test_a_press_on_a_point_plays_its_run(optimise, goals):
    page, (tried, _) = optimise.page, goals["optimise"]
    for run in tried.kept:
        mark(page, run.point).focus()
        page.keyboard.press("Enter")
        assert page.locator("#point h2").inner_text() == f"Design {run.point + 1}"
        assert page.evaluate(KEPT) == run.point
        angles = np.degrees(run.record.angles("ring")).ravel()
        line = page.evaluate("Array.from(forficula.panel.playing.plots.charts[0].data[1])")
        assert angles.min() - 0.5 <= min(line) <= min(angles.min() + 5, max(line))
    assert optimise.messages == []


def test_a_design_that_was_not_kept_says_so_and_has_its_numbers(optimise, goals):
    page, (tried, _) = optimise.page, goals["optimise"]
    kept = {run.point for run in tried.kept}
    point = next(index for index in range(tried.table.sizes["candidate"]) if index not in kept)
    page.get_by_role("button", name=f"open design {point + 1}", exact=True).click()
    assert "was not kept" in page.locator("#run").inner_text()
    mass = page.locator("#point tr", has_text="mass").locator("td").inner_text()
    assert float(mass.split()[0]) == pytest.approx(1e3 * float(tried.table["mass"].values[point]), rel=5e-3)
    assert mark(page, point).get_attribute("aria-selected") == "true"


def test_the_page_opens_with_the_best(watch, goals):
    tried, path = goals["optimise"]
    page = watch(path).page
    point = page.evaluate("forficula.panel.point")
    assert tried.table["best"].values[point]
    assert page.evaluate(KEPT) == point
    assert page.locator(".scatter text.best").text_content() == "most margin"


def test_pressing_a_line_opens_its_point(optimise, goals):
    page, (tried, _) = optimise.page, goals["optimise"]
    page.locator(".lines .drawn").scroll_into_view_if_needed()
    box = page.locator(".lines .drawn").bounding_box()
    rest = tried.table["tendon_rest_length"].values
    point = int(np.argmax(rest))
    # on the first axis, slightly below its end
    axis = page.locator(".lines svg path.axis").first.evaluate(
        "each => { const { x, y, height } = each.getBBox(); return [x, y, height]; }"
    )
    page.mouse.click(box["x"] + axis[0], box["y"] + axis[1] + 2)
    assert page.evaluate("forficula.panel.point") == point


def test_handles_filter_the_lines_the_plane_and_the_table(optimise, goals):
    page, (tried, _) = optimise.page, goals["optimise"]
    mass = tried.table["mass"].values
    low, high = mass.min(), mass.max()
    handle(page, "most mass").focus()
    for _ in range(10):
        page.keyboard.press("ArrowDown")
    within = np.flatnonzero(mass <= low + 0.8 * (high - low) + 1e-12)
    assert 0 < len(within) < len(mass)
    assert shown(page) == (within + 1).tolist()
    assert page.locator(".scatter .out").count() == len(mass) - len(within)
    assert f"{len(within)} of {len(mass)} designs" in page.locator(".lines [role=status]").inner_text()
    # it keeps the focus, and the other end does not move
    assert page.evaluate("document.activeElement.getAttribute('aria-label')") == "most mass"
    assert handle(page, "most mass").get_attribute("aria-valuenow") == "80"
    assert handle(page, "least mass").get_attribute("aria-valuenow") == "0"
    page.keyboard.press("Home")
    assert handle(page, "most mass").get_attribute("aria-valuenow") == "0"
    page.get_by_role("button", name="show all designs").click()
    assert len(shown(page)) == len(mass)


def ends(page, name):
    """Return the centre of an axis, and its lower and upper ends, in the window."""
    page.locator(".lines .drawn").scroll_into_view_if_needed()
    least, most = (handle(page, f"{end} {name}").bounding_box() for end in ("least", "most"))
    return least["x"] + least["width"] / 2, least["y"], most["y"] + most["height"]


def drag(page, x, start, end):
    page.mouse.move(x, start)
    page.mouse.down()
    page.mouse.move(x, end, steps=4)
    page.mouse.up()


def selected_range(page, name):
    return [int(handle(page, f"{end} {name}").get_attribute("aria-valuenow")) for end in ("least", "most")]


def test_a_handle_is_dragged_and_an_axis_is_swept_with_the_mouse(optimise):
    page = optimise.page
    x, foot, head = ends(page, "mass")
    drag(page, x, foot + 4, (foot + head) / 2)
    assert selected_range(page, "mass") == [pytest.approx(50, abs=3), 100]
    assert len(shown(page)) < 16
    page.get_by_role("button", name="show all designs").click()
    x, foot, head = ends(page, "mass")
    drag(page, x, foot - 0.25 * (foot - head), foot - 0.75 * (foot - head))
    assert selected_range(page, "mass") == [pytest.approx(25, abs=3), pytest.approx(75, abs=3)]


def test_axes_of_the_plane_are_chosen_among_parameters_quantities_and_margins(optimise, goals):
    page, (tried, _) = optimise.page, goals["optimise"]
    choose(page, "across", "tendon area")
    choose(page, "upwards", "least margin")
    places = [mark(page, point).locator("circle").last.bounding_box() for point in range(16)]
    for side, name, rising in (("x", "tendon_area", 1), ("y", "margin", -1)):
        middle = np.array([place[side] + place["height"] / 2 for place in places])
        assert np.corrcoef(rising * middle, tried.table[name].values)[0, 1] == pytest.approx(1, abs=1e-6)
    choose(page, "across", "mass")
    choose(page, "upwards", "hinge holding torque")
    assert page.locator(".scatter path.front").count() == 1


def test_arrows_go_from_point_to_point_to_the_right(optimise, goals):
    page, (tried, _) = optimise.page, goals["optimise"]
    order = np.argsort(tried.table["mass"].values, kind="stable")
    mark(page, order[3]).focus()
    page.keyboard.press("ArrowRight")
    assert page.evaluate("Number(document.activeElement.dataset.point)") == order[4]
    assert page.locator(".scatter [data-point][tabindex='0']").count() == 1


def test_an_axis_keeps_its_selected_range_when_it_is_hidden_and_displayed_again(optimise):
    page = optimise.page
    page.locator(".lines summary").click()
    box = page.get_by_label("tendon area", exact=True)
    handle(page, "most tendon area").focus()
    page.keyboard.press("PageDown")
    box.uncheck()
    assert handle(page, "most tendon area").count() == 0
    assert len(shown(page)) == 16
    box.check()
    assert handle(page, "most tendon area").get_attribute("aria-valuenow") == "100"
    page.locator(".lines summary").click()


def test_the_table_that_is_downloaded_is_the_one_of_the_folder(optimise, goals):
    with optimise.page.expect_download() as download:
        optimise.page.get_by_role("button", name="Download table.csv").click()
    rows = list(csv.DictReader(io.StringIO(download.value.path().read_text("utf-8"))))
    assert [float(row["mass_kg"]) for row in rows] == goals["optimise"][0].table["mass"].values.tolist()


def test_samples_are_drawn_over_the_map_of_verdicts_of_two_values(tolerance):
    page = tolerance.page
    assert page.locator(".scatter rect.map-works, .scatter rect.map-fails").count() == 81
    failing = page.locator(".scatter .unfolded[data-point]").count()
    assert failing == page.locator("#points td", has_text="did not fold").count() > 0
    choose(page, "across", "hinge overbend")
    assert page.locator(".scatter rect").count() == 0
    choose(page, "across", "tendon rest length")


def test_a_sample_that_works_and_one_that_fails_can_both_be_played(tolerance, goals):
    page, (tried, _) = tolerance.page, goals["tolerance"]
    for run in tried.kept:
        mark(page, run.point).focus()
        page.keyboard.press("Enter")
        assert page.evaluate(KEPT) == run.point
    page.get_by_role("button", name="play").first.click()
    until(page, "forficula.panel.playing.clock.time > forficula.panel.playing.clock.span.start + 0.01")
    page.evaluate("forficula.panel.playing.clock.pause()")
    assert tolerance.messages == []


def test_pressing_a_pair_enlarges_it(identify):
    page = identify.page
    pair = page.locator(".pairs button").last
    upwards, across = pair.get_attribute("aria-label").removesuffix(", large").split(" over ")
    pair.click()
    chosen = page.locator(".map select").evaluate_all("all => all.map(each => each.selectedOptions[0].text)")
    assert chosen[:2] == [across, upwards]


def test_samples_that_agree_are_drawn_in_front_of_all_drawn_samples(identify, goals):
    page, (tried, _) = identify.page, goals["identify"]
    agrees = tried.table["agrees"].values & ~tried.table["directed"].values
    assert page.locator(".marginals figure").count() == len(tried.table.attrs["unknowns"])
    drawn = (
        page.locator(".pairs button")
        .first.locator("path")
        .evaluate_all(
            "all => all.map(each => [each.getAttribute('class'), each.getAttribute('d').split('M').length - 1])"
        )
    )
    assert drawn == [["all", int((~tried.table["directed"].values & ~agrees).sum())], ["agree", int(agrees.sum())]]
    rest = 100 * np.sort(tried.table["tendon_rest_length"].values[agrees])
    text = page.locator(".marginals figure", has_text="tendon rest length").locator("small").inner_text()
    low, high = (float(part) for part in text.removeprefix("middle half: ").split(" to "))
    assert rest[0] <= low <= high <= rest[-1]
    assert np.mean((rest >= low - 0.01) & (rest <= high + 0.01)) == pytest.approx(0.5, abs=0.2)


@pytest.mark.parametrize("kind", ["optimise", "tolerance", "identify"])
def test_nothing_is_wider_than_a_phone(pages_of_goals, kind):
    opened = as_it_opens(pages_of_goals[kind])
    opened.show(360, 740)
    assert opened.page.evaluate("document.documentElement.scrollWidth") <= 360
    assert opened.messages == []
    assert opened.requests == [opened.page.url]
    opened.show()
