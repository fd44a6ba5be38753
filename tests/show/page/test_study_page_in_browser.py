"""Page of a study, in a browser without network."""

import csv
import io
import re
from xml.etree import ElementTree

import numpy as np
import pytest

from forficula.analysis import Verdict
from forficula.show.page.study_page import write_study_page
from forficula.structure import drawn_points
from forficula.study import load_study, run_study, table_csv
from forficula.study.running.kept_runs import kept_runs, runs_to_keep
from tests.planted import folds_if, soft
from tests.show.page.appearance import check_shown
from tests.show.page.conftest import until
from tests.show.study.test_maps import many_ends, planted, sampled

FACTORS = '"tendon.stiffness" = ["10 N/cm", "60 N/cm"]\n"tendon.rest_length" = ["0 cm", "5 cm", "8 cm"]'
SEARCH = '[search]\nfold_torques = "0..50 N cm step 25"\nunfold_torques = "50..100 N cm step 25"'
LEAST = ("least_fold_torque", "least_unfold_torque")
EXACT = 1e-6  # m, precision of 4-byte floats


class StudyPage:
    """A page, its study and frequent queries."""

    def __init__(self, path, table, text, kept):
        self.path, self.table, self.text = path, table, text
        self.rows = list(csv.DictReader(io.StringIO(text)))
        self.kept = {(item.point, item.part): item for item in kept}


@pytest.fixture(scope="module")
def small(tmp_path_factory, write_study_file):
    """A search over six tendons; the runs of three that fold are kept."""
    folder = tmp_path_factory.mktemp("study")
    path = write_study_file(folder / "small.toml", FACTORS, 'ask = "least-torques"', SEARCH)
    # with 500 N cm a longer timestep diverges
    path.write_text(path.read_text("utf-8").replace('timestep = "0.4 ms"', 'timestep = "0.1 ms"'), "utf-8")
    study = load_study(path)
    table = run_study(study, folder)
    runs = runs_to_keep(study, table, 3)
    kept = list(kept_runs(runs, folder))
    write_study_page(study, table, folder / "report.html", kept, len(kept))
    return StudyPage(folder / "report.html", table, table_csv(study, table), kept)


@pytest.fixture(scope="module")
def one_page(watch_all, small):
    return watch_all(small.path)


@pytest.fixture
def opened(one_page):
    """The page at its start: outcomes, all rows in order."""
    page = one_page.page
    page.set_default_timeout(10_000)
    choose(page, "show", "outcome")
    page.evaluate("document.querySelectorAll('.filter input:not(:checked)').forEach((box) => box.click())")
    page.evaluate("document.activeElement.blur(); scrollTo(0, 0)")
    one_page.settle()
    return one_page


@pytest.fixture
def planted_page(tmp_path, study_file):
    """A page of a planted table, without runs."""

    def write(table, factors, head='ask = "least-torques"'):
        path = tmp_path / "report.html"
        write_study_page(load_study(study_file(factors, head)), table, path, (), 0)
        return path

    return write


def cell(page, point):
    return page.locator(f".grid [data-point='{point}']")


def choice(page, label):
    return page.locator(f".map label[data-name='{label}'] select")


def choose(page, label, option):
    choice(page, label).select_option(label=option)


def chosen(page, label):
    return choice(page, label).evaluate("each => each.selectedOptions[0].text")


def check_paired_plots(page, records):
    """Check that two runs side by side have their own angles and energies, with common ranges and their own stages."""
    headings = page.locator(".plots h2").all_inner_texts()
    titles = [heading.split("\n")[0] for heading in headings]
    assert titles[0::2] == titles[1::2] == ["Distal hinge angle (deg)", "Turn about its own axis (deg)", "Energy (J)"]
    charts = page.evaluate(
        """forficula.panel.playing.plots.charts.map(({ data, scales }) =>
            ({ data: data.map((line) => [...line]), range: [scales.y.min, scales.y.max] }))"""
    )
    for place, record in enumerate(records):
        moments, *lines = charts[place]["data"]
        angles = np.degrees(record.angles("ring"))
        for line, column in zip(lines, angles.T, strict=True):
            expected = np.interp(np.array(moments) + record.stages[1].start, record.time, column)
            assert np.allclose(line, expected, atol=1e-3)
    assert not np.array_equal(charts[0]["data"][1], charts[1]["data"][1])
    assert [chart["range"] for chart in charts[0::2]] == [chart["range"] for chart in charts[1::2]]


def shown_points(page):
    """Return the numbers of the points in the table, in displayed order."""
    return [int(text) for text in page.locator("#points tbody tr:visible th").all_inner_texts()]


def test_the_page_opens_from_a_file_without_a_request_and_without_a_word_on_the_console(opened):
    page = opened.page
    for point in (0, 3, 5):
        cell(page, point).click()
    for option in page.locator(".map select option").all_inner_texts()[::4]:
        choose(page, "show", option)
    page.emulate_media(color_scheme="dark")
    opened.settle()
    page.emulate_media(color_scheme="light")
    opened.settle()
    assert opened.messages == []
    assert [url for url in opened.requests if not url.startswith(("file:", "data:", "blob:"))] == []


def test_a_click_on_a_cell_shows_that_run_and_its_numbers(opened, small):
    page = opened.page
    for point, row in enumerate(small.rows):
        cell(page, point).click()
        assert page.locator("#point h2").inner_text() == f"Point {point + 1}"
        stiffness, length = float(row["tendon_stiffness_N_per_m"]) / 100, float(row["tendon_rest_length_m"]) * 100
        output = page.locator("#point .outcome").inner_text()
        assert output == f"Tendon stiffness {stiffness:g} N/cm, tendon rest length {length:g} cm: {row['status']}."
        numbers = page.locator("#point tr", has_text="work of folding").locator("td").inner_text()
        if row["fold_work_J"]:
            assert float(numbers.removesuffix(" J")) == pytest.approx(float(row["fold_work_J"]), rel=5e-3)
        else:
            assert numbers == small.table["fold_outcome"].values.ravel()[point]
        assert cell(page, point).get_attribute("aria-selected") == "true"
        assert page.locator(".grid [aria-selected=true]").count() == 1


@pytest.mark.parametrize("part", ["folding", "opening"])
def test_a_click_on_a_cell_plays_the_run_that_was_kept_of_it(opened, small, part):
    page = opened.page
    choose(page, "show", "work of unfolding" if part == "opening" else "work of folding")
    for point in {point for point, item in small.kept if item == part}:
        cell(page, point).click()
        record = small.kept[point, part].record
        assert page.evaluate("forficula.panel.playing.run.folder") == small.kept[point, part].folder
        times = np.array(page.evaluate("Array.from(forficula.panel.playing.clips[0].time)"))
        assert np.isin(times, record.time).all()
        for moment in times[[0, len(times) // 2, -1]]:
            page.evaluate("(moment) => { forficula.panel.playing.clock.seek(moment); }", float(moment))
            opened.settle()
            vertices = page.evaluate("Array.from(forficula.panel.playing.player.stage.views[0].shape.vertices)")
            drawn = np.array(vertices).reshape(-1, 3)
            tips = record.series["point_position"][np.searchsorted(record.time, moment)][drawn_points(record.structure)]
            assert np.linalg.norm(tips[:, None] - drawn[None], axis=2).min(axis=1).max() < EXACT


def test_the_page_opens_the_most_successful_run_with_the_least_torque(one_page, small):
    page = one_page.page
    page.reload()
    until(page, "window.forficula !== undefined")
    # the most successful outcomes have the least numbers
    ranks = page.evaluate("forficula.model.study.verdicts")
    kept = {point for point, part in small.kept if part == "folding"}
    furthest = [point for point in kept if ranks[point] == min(ranks[item] for item in kept)]
    torques = [small.table[name].fillna(np.inf).values.ravel() for name in LEAST]
    assert page.evaluate("forficula.panel.point") == min(
        furthest, key=lambda point: [torque[point] for torque in torques]
    )
    assert page.evaluate("forficula.panel.playing.run.part") == "folding"


def open_folding(page, point):
    """Open a point, and its folding even if a failed run of it is played first."""
    cell(page, point).click()
    button = page.locator(".parts [data-part=folding]")
    if button.count():
        button.click()


def test_the_view_is_kept_from_cell_to_cell(opened, small):
    page = opened.page
    first, second = sorted({point for point, _ in small.kept})[:2]
    cell(page, first).click()
    page.locator(".stage canvas").focus()
    for key in ("Shift+ArrowLeft", "+", "+"):
        page.keyboard.press(key)
    places = []
    for point in (first, second):
        open_folding(page, point)  # an opening run of another point would start folded, seen from 7 % further away
        page.evaluate("forficula.panel.playing.clock.seek(0)")
        opened.settle()
        places.append(page.evaluate("forficula.panel.playing.player.stage.eye.camera.position.toArray()"))
    # the wings differ only in their tendons, and are flat
    assert np.allclose(*places, rtol=0.02)
    look = page.evaluate("forficula.panel.playing.player.stage.eye.look.closer")
    assert look == pytest.approx(1.15**-2)
    page.locator(".stage canvas").focus()
    page.keyboard.press("0")
    assert page.evaluate("forficula.panel.playing.player.stage.eye.look.closer") == 1


def test_a_press_on_a_cell_that_failed_plays_the_run_that_failed(opened, small):
    page = opened.page
    failed = {point for (point, _), kept in small.kept.items() if kept.outcome.verdict is not Verdict.REACHED}
    assert any((point, "opening") in small.kept for point in failed)
    for point in sorted(failed)[:3]:
        cell(page, point).click()
        part = page.evaluate("forficula.panel.playing.run.part")
        assert small.kept[point, part].outcome.verdict is not Verdict.REACHED


def test_a_pinned_run_moves_beside_the_one_that_is_opened_after_it_each_from_its_first_drive(opened, small):
    page = opened.page
    first, second = sorted({point for point, part in small.kept if part == "folding"})[:2]
    open_folding(page, first)
    page.get_by_role("button", name="pin to compare with another").click()
    open_folding(page, second)
    page.evaluate("forficula.panel.playing.clock.seek(0.012)")
    opened.settle()
    for view, point in enumerate((first, second)):
        record = small.kept[point, "folding"].record
        moment = record.stages[1].start + 0.012
        points = record.series["point_position"][:, drawn_points(record.structure)].reshape(len(record.time), -1)
        expected = np.reshape([np.interp(moment, record.time, column) for column in points.T], (-1, 3))
        vertices = page.evaluate(f"Array.from(forficula.panel.playing.player.stage.views[{view}].shape.vertices)")
        away = np.linalg.norm(expected[:, None] - np.reshape(vertices, (-1, 3))[None], axis=2)
        assert away.min(axis=1).max() < EXACT
    assert [text.split(":")[0] for text in page.locator(".cell b").all_inner_texts()] == [
        f"point {point + 1}" for point in (first, second)
    ]
    check_paired_plots(page, [small.kept[point, "folding"].record for point in (first, second)])
    assert [text.split(":")[0] for text in page.locator(".readout caption").all_inner_texts()] == [
        f"Point {point + 1}" for point in (first, second)
    ]
    opened.show(360, 740)
    lowest = max(item.bounding_box()["y"] + item.bounding_box()["height"] for item in page.locator(".cell").all())
    stage = page.locator(".stage").bounding_box()
    assert lowest <= stage["y"] + stage["height"] + 1
    opened.show()
    page.get_by_role("button", name=f"unpin point {first + 1}").click()
    assert page.locator(".cell b").count() == 0
    assert opened.messages == []


def test_scrubbed_to_folded_a_kept_run_has_the_angles_of_its_outcome(opened, small):
    page = opened.page
    (point, part), kept = next(iter(small.kept.items()))
    cell(page, point).click()
    if page.locator(f".parts [data-part={part}]").count():
        page.locator(f".parts [data-part={part}]").click()
    page.get_by_role("button", name="b folded").click()
    opened.settle()
    angles = np.degrees(kept.outcome.states["folded"].readings["distal_angle"].mean)
    shown = page.locator(".readout tr", has_text="distal angle").locator("td").all_inner_texts()
    assert np.allclose([float(text.replace("−", "-").partition(" ")[0]) for text in shown], angles, atol=2)


def test_a_run_that_was_not_kept_says_so_and_has_its_numbers(opened, small):
    page = opened.page
    point = next(point for point in range(6) if point not in {kept for kept, _ in small.kept})
    cell(page, point).click()
    assert "was not kept" in page.locator("#run").inner_text()
    assert page.locator("#run canvas").count() == 0
    assert page.locator("#point td").count() == 9


def test_arrows_move_between_cells_and_enter_opens_one(opened):
    page = opened.page
    cell(page, 0).click()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("ArrowUp")
    focused = "Number(document.activeElement.dataset.point)"
    assert page.evaluate(focused) == 4
    assert page.locator("#point h2").inner_text() == "Point 1"
    page.keyboard.press("Enter")
    assert page.locator("#point h2").inner_text() == "Point 5"
    page.keyboard.press("ArrowUp")  # there is no row above
    page.keyboard.press("End")
    assert page.evaluate(focused) == 5
    page.keyboard.press("Home")
    page.keyboard.press(" ")
    assert page.locator("#point h2").inner_text() == "Point 4"
    # one tab stop for all cells
    assert page.locator(".grid td[tabindex='0']").count() == 1


def test_cells_have_their_values_and_where_there_is_none_a_sign_and_a_reason(opened, small):
    page = opened.page
    choose(page, "show", "least fold torque")
    colours = {}
    for point, row in enumerate(small.rows):
        text, label = cell(page, point).inner_text(), cell(page, point).get_attribute("aria-label")
        if torque := row["least_fold_torque_N_m"]:
            assert float(text) == pytest.approx(100 * float(torque))
            assert label.endswith(f"least fold torque {float(text):g} N cm")
            colours[float(text)] = cell(page, point).evaluate("cell => getComputedStyle(cell).backgroundColor")
        else:
            word = small.table["fold_outcome"].values.ravel()[point]
            assert (text, label.endswith(word)) == ({"did not fold": "×", "still folding": "▷"}[word], True)
            assert "gradient" in cell(page, point).evaluate("cell => getComputedStyle(cell).backgroundImage")
    # lightness rises with the value, so the order is kept in grey print
    lightness = [
        np.dot([0.299, 0.587, 0.114], [int(part) for part in re.findall(r"\d+", colours[key])[:3]])
        for key in sorted(colours)
    ]
    assert lightness == sorted(lightness)
    assert len(set(lightness)) == len(colours) > 1
    assert "known for" in page.locator(".map > .note").inner_text()


def test_the_table_is_filtered_by_outcome(opened, small):
    page = opened.page
    outcomes = small.table["outcome"].values.ravel().tolist()
    wanted = outcomes[0]
    for box in page.locator(".filter label").all():
        if not box.inner_text().split("\n")[-1].strip().startswith(f"{wanted} ("):
            box.locator("input").uncheck()
    assert shown_points(page) == [point + 1 for point, outcome in enumerate(outcomes) if outcome == wanted]
    assert page.get_by_text(f"{outcomes.count(wanted)} of 6 points shown.").count() == 1
    for box in page.locator(".filter input:checked").all():
        box.uncheck()
    assert shown_points(page) == []


def test_the_table_is_ordered_by_any_column_and_what_has_no_value_is_last(opened, small):
    page = opened.page
    works = {point + 1: float(row["fold_work_J"]) for point, row in enumerate(small.rows) if row["fold_work_J"]}
    heading = page.locator("#points thead th", has_text="work of folding")
    for order, sign in (("ascending", 1), ("descending", -1)):
        heading.get_by_role("button").click()
        assert heading.get_attribute("aria-sort") == order
        assert shown_points(page)[: len(works)] == sorted(works, key=lambda point: sign * works[point])
        assert set(shown_points(page)[len(works) :]).isdisjoint(works)
    assert page.locator("#points [aria-sort]").count() == 1
    page.locator("#points thead th").first.get_by_role("button").click()
    assert shown_points(page) == [1, 2, 3, 4, 5, 6]


def test_the_number_of_a_row_opens_its_point_in_the_map_too(opened):
    page = opened.page
    page.get_by_role("button", name="open point 3").click()
    assert page.locator("#point h2").inner_text() == "Point 3"
    assert cell(page, 2).get_attribute("aria-selected") == "true"


def test_the_table_that_is_downloaded_is_the_one_of_the_folder(opened, small):
    with opened.page.expect_download() as download:
        opened.page.get_by_role("button", name="Download table.csv").click()
    assert download.value.suggested_filename == "table.csv"
    assert download.value.path().read_text("utf-8") == small.text


# numbers of geometries and shaders, and whether the canvas is that of the last run
GRAPHICS = """() => {
  const { canvas, statistics } = forficula.panel.playing.player.stage;
  const { geometries, programs } = statistics();
  const same = window.canvas === canvas;
  window.canvas = canvas;
  return [geometries, programs, same];
}"""


def test_a_run_that_is_opened_later_takes_the_graphics_memory_of_the_run_before(opened, small):
    page = opened.page
    points = [point for point, part in small.kept if part == "folding"]
    used = []
    for point in (points[0], points[1], points[0]):
        cell(page, point).click()
        opened.settle()
        used.append(page.evaluate(GRAPHICS))
        assert page.locator(".stage canvas").count() == 1
    assert used[0][:-1] == used[1][:-1] == used[2][:-1]
    assert used[1][-1]
    assert used[2][-1]
    assert opened.messages == []


@pytest.mark.parametrize(("width", "height"), [(360, 740), (640, 400)], ids=["a phone", "a laptop at 200 %"])
def test_nothing_is_wider_than_the_window_of(watch, small, width, height):
    page = watch(small.path, viewport={"width": width, "height": height}, pixels=2).page
    choose(page, "show", "work of folding")
    cell(page, 2).click()
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    assert page.evaluate("devicePixelRatio") == 2
    # on one column, a press leads to the numbers and the playback below the map
    assert -1 <= page.locator("#point").bounding_box()["y"] < height  # tolerance of half a pixel by rounding
    # and the map stays above them
    for part in ("#point", "#run .note, #run .player"):
        page.locator(part).first.evaluate("each => each.scrollIntoView()")
        grid = page.locator(".map-place").bounding_box()
        assert grid["y"] == pytest.approx(0, abs=1)
        assert 40 < grid["height"] < 0.4 * height


def test_the_plots_take_the_whole_width_below_the_map_and_the_player(opened):
    opened.show(1280, 800)
    boxes = [opened.page.locator(part).first.bounding_box() for part in ("#point", "#run .player", ".below .plots")]
    point, player, plots = boxes
    assert plots["y"] >= max(box["y"] + box["height"] for box in (point, player))
    assert plots["x"] == pytest.approx(point["x"], abs=1)
    assert plots["x"] + plots["width"] == pytest.approx(player["x"] + player["width"], abs=1)
    opened.show()


def test_a_map_of_few_rows_is_high_and_numbers_over_one_factor_are_points_over_axes(opened, watch, planted_page):
    opened.show(1280, 800)
    assert opened.page.locator(".map-place").bounding_box()["height"] > 150
    opened.show()
    table = planted(("tendon_stiffness",))
    page = watch(planted_page(table, '"tendon.stiffness" = ["10 N/cm", "20 N/cm", "30 N/cm"]')).page
    choose(page, "show", "work of folding")
    assert page.locator(".map .scatter [data-point]").count() == 3
    letters = page.locator(".map .scatter .label").all_text_contents()
    assert {"work of folding (J)", "tendon stiffness (N/cm)"} <= set(letters)
    page.locator(".scatter [data-point='2']").click()
    assert page.locator("#point h2").inner_text() == "Point 3"


def test_the_map_is_saved_as_a_vector_drawing_with_its_legend(opened):
    with opened.page.expect_download() as download:
        opened.page.get_by_role("button", name="download SVG of the map").click()
    drawing = ElementTree.fromstring(download.value.path().read_bytes())
    texts = {"".join(element.itertext()) for element in drawing.iter() if element.tag.endswith("text")}
    assert {"tendon rest length (cm)", "tendon stiffness (N/cm)"} <= texts
    legend = opened.page.locator(".map-legend li").all_inner_texts()
    assert len(legend) > 1
    assert {entry.split("\n")[-1] for entry in legend} <= texts


def test_of_more_than_two_factors_two_are_chosen_and_the_others_fixed(watch, planted_page):
    table = planted(("tendon_stiffness", "pattern_tangent", "pattern_hub_radius"))
    factors = (
        '"tendon.stiffness" = ["10 N/cm", "20 N/cm", "30 N/cm"]\n"pattern.tangent" = ["left", "right"]\n'
        '"pattern.hub_radius" = ["1 cm", "1.5 cm", "2 cm"]'
    )
    page = watch(planted_page(table, factors)).page
    choose(page, "show", "work of folding")
    choose(page, "across", "pattern hub radius")
    choose(page, "upwards", "tendon stiffness")
    choose(page, "pattern tangent", "right")
    expected = table["fold_work"].sel(pattern_tangent="right").values
    cells = page.locator(".grid tr:not(.feet)").all()
    shown = [[float(text) for text in row.locator("td").all_inner_texts()] for row in cells]
    assert np.allclose(shown[::-1], expected, rtol=5e-3)
    choose(page, "across", "tendon stiffness")
    assert chosen(page, "upwards") == "pattern hub radius"
    page.locator("#points tbody tr").first.get_by_role("button").click()
    assert chosen(page, "pattern tangent") == "left"


def test_drawn_points_lie_at_their_values_and_can_be_opened(watch, planted_page):
    drawn = '"tendon.stiffness" = {distribution = "uniform", low = "10 N/cm", high = "30 N/cm"}\n'
    drawn += '"tendon.rest_length" = {distribution = "uniform", low = "0 cm", high = "9 cm"}'
    table = sampled(many_ends())
    head = 'ask = "least-torques"\n[sampling]\ncount = 12\n'
    watched = watch(planted_page(table, drawn, head))
    page = watched.page
    choose(page, "show", "least fold torque")
    marks = page.locator(".scatter [data-point]")
    places = [mark.locator("circle").bounding_box() for mark in marks.all()]
    for name, side, rising in (("tendon_rest_length", "x", 1), ("tendon_stiffness", "y", -1)):
        middle = np.array([place[side] + place["width"] / 2 for place in places])
        assert np.corrcoef(rising * middle, table[name].values)[0, 1] == pytest.approx(1)
    marks.nth(5).click()
    assert page.locator("#point h2").inner_text() == "Point 6"
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Enter")
    assert page.locator("#point h2").inner_text() == "Point 7"
    assert watched.messages == []


def test_the_structure_plots_and_legend_do_not_overlap(opened):
    opened.show(1280, 1000)
    open_folding(opened.page, 2)
    opened.page.evaluate(
        "() => { const { clock, clips } = forficula.panel.playing; clock.seek(clips[0].marks[1].time); }"
    )
    check_shown(opened)
    opened.show()


def test_the_map_of_refined_points_shows_boundaries_and_cells(watch, tmp_path, write_study_file):
    factors = '"tendon.stiffness" = ["10 N/cm", "60 N/cm"]\n"tendon.rest_length" = ["0 cm", "9 cm"]'
    tail = '[sampling]\nmethod = "refine"\nboundary = ["folded"]\n'
    table = run_study(
        load_study(write_study_file(tmp_path / "s.toml", factors, "", tail)), tmp_path, cluster=folds_if(soft)[0]
    )
    write_study_page(table.study, table, tmp_path / "report.html", (), 0, engine=False)
    page = watch(tmp_path / "report.html").page
    ends = re.findall(r"M([\d.]+) ([\d.]+)L([\d.]+) ([\d.]+)", page.locator(".scatter .boundary").get_attribute("d"))
    outlines = page.locator(".scatter .cell-outline").get_attribute("d").split("Z")
    assert len(outlines) > 1
    # the boundary divides the marks of wings that fold from the others: it rises with the resting length
    (left, low), *_, (right, high) = sorted((float(x), float(y)) for end in ends for x, y in (end[:2], end[2:]))
    assert left < right
    assert low > high
    assert "boundary of the state folded" in page.locator(".map-legend").inner_text()
