"""Page of several runs, and refused arguments."""

import os
from dataclasses import replace

import numpy as np
import pytest

from forficula.analysis import measure
from forficula.cli import main
from forficula.dynamics import save_record
from forficula.errors import InputError
from forficula.show.page import compare_runs
from forficula.show.page.compare_page import ComparedRun, _energies
from forficula.show.page.playback import make_clip
from tests.show.page.appearance import check_shown


@pytest.fixture(scope="module")
def folders(short_run, slow_run, tmp_path_factory):
    """Folders of two runs: a fast and a slow one."""
    above = tmp_path_factory.mktemp("runs")
    for name, record in (("quick", short_run), ("slow", slow_run)):
        (above / name).mkdir()
        save_record(record, above / name / "record.nc")
    return above / "quick", above / "slow"


@pytest.fixture(scope="module")
def opened(watch_all, folders, tmp_path_factory):
    path = tmp_path_factory.mktemp("page") / "compared.html"
    main(["compare", *map(str, folders), "--out", str(path)])
    return watch_all(path)


def show(opened, span, moment):
    opened.page.get_by_label("show").select_option(span)
    opened.page.evaluate("(moment) => { forficula.clock.seek(moment); }", moment)
    opened.settle()


def test_wings_are_side_by_side_without_requests_or_console_messages(opened):
    assert opened.messages == []
    assert len(opened.requests) == 1
    cells = opened.page.locator(".cell")
    boxes = [cell.bounding_box() for cell in cells.all()]
    assert [text.split("\n")[0].strip() for text in cells.all_inner_texts()] == ["quick", "slow"]
    assert boxes[0]["y"] == boxes[1]["y"]
    assert boxes[0]["x"] + boxes[0]["width"] <= boxes[1]["x"] + 1


def test_one_clock_moves_all_wings_each_by_the_time_since_it_began_to_fold(opened, short_run, slow_run):
    show(opened, "folding", 0.02)
    for view, record in enumerate((short_run, slow_run)):
        tips = record.series["point_position"][:, [point.role == "tip" for point in record.structure.points]]
        moment = record.stages[1].start + 0.02
        expected = [np.interp(moment, record.time, column) for column in tips.reshape(len(record.time), -1).T]
        vertices = opened.page.evaluate(f"Array.from(forficula.player.stage.views[{view}].shape.vertices)")
        away = np.linalg.norm(np.array(vertices).reshape(-1, 3)[:, None] - np.reshape(expected, (-1, 3)), axis=2)
        assert away.min(axis=0).max() < 1e-6


def test_runs_that_differ_in_fold_time_are_seen_to_differ(opened, short_run, slow_run):
    # the stage ends when the goal has held for a while
    quick, slow = (record.stages[1].end - record.stages[1].start for record in (short_run, slow_run))
    show(opened, "folding", (quick + slow) / 2)
    texts = opened.page.locator(".state-now").all_inner_texts()
    assert texts[0].startswith("release folded" if quick < slow else "fold ·")
    assert texts[1].startswith("fold ·" if quick < slow else "release folded")


def test_turning_one_wing_turns_the_view_of_all(opened):
    before = opened.page.locator("canvas").first.screenshot()
    opened.page.get_by_role("button", name="top: view from above").click()
    opened.settle()
    assert opened.page.evaluate("forficula.player.stage.views.length") == 2
    assert opened.page.locator("canvas").first.screenshot() != before


def test_wings_are_drawn_to_one_scale_or_each_to_its_own_as_is_chosen(opened):
    show(opened, "whole runs", 0.03)
    eye = "(index) => { const { eye } = forficula.player.stage; eye.aim(index); return eye.camera.position.toArray(); }"
    shared = [opened.page.evaluate(eye, index) for index in (0, 1)]
    choice = opened.page.get_by_role("button", name="one scale: draw all wings at the same scale")
    choice.click()
    eyes = [opened.page.evaluate(eye, index) for index in (0, 1)]
    choice.click()
    assert shared[0] == shared[1]
    assert not np.allclose(eyes[0], eyes[1], rtol=0.02)


def test_only_values_that_differ_are_listed(opened):
    rows = opened.page.locator("#design tbody th").all_inner_texts()
    assert rows == ["protocol.fold_torque", "design hash"]


def test_the_keys_that_are_listed_are_those_of_several_wings(opened):
    listed = opened.page.locator(".keys th").all_text_contents()
    assert "space" in listed
    assert not {"1", "2", "3", "1 2 3"} & set(listed)


@pytest.mark.parametrize("width", [360, 1280])
def test_the_page_fits_its_window(opened, width):
    opened.show(width=width, height=700)
    assert opened.page.evaluate("document.documentElement.scrollWidth") <= width


def test_in_a_narrow_window_the_clock_stays_in_sight_of_every_wing(opened):
    opened.show(width=360, height=400)
    for cell in opened.page.locator(".cell").all():
        cell.evaluate("each => each.scrollIntoView()")
        play = opened.page.get_by_role("button", name="play").bounding_box()
        assert 0 <= play["y"] < 400 - play["height"]


def test_wings_plots_and_legend_do_not_overlap(opened):
    opened.show(width=1280, height=1000)
    show(opened, "whole runs", 0.03)
    opened.page.evaluate("forficula.player.stage.eye.show({ towards: [0.37, -0.695, 0.616] })")
    check_shown(opened)


def test_energies_of_very_different_size_are_on_axes_of_their_own(short_run, slow_run):
    outcome = measure(short_run)
    weak = replace(short_run, series=short_run.series | {"tendon_energy": short_run.series["tendon_energy"] / 100})
    runs = [
        ComparedRun(label=name, record=record, outcome=outcome)
        for name, record in (("strong", short_run), ("weak", weak), ("slow", slow_run))
    ]
    clips = [make_clip(run.record, run.outcome, name=run.label, budget=10**6) for run in runs]
    strong, faint = _energies(clips)
    assert [line.name for line in strong.lines] == ["strong", "slow"]
    assert [line.name for line in faint.lines] == ["weak"]
    assert faint.title == "energy of all tendons, weak"
    # every run has the colour of its place in all plots
    assert [line.look for plot in (strong, faint) for line in plot.lines] == [0, 2, 1]
    for plot in (strong, faint):
        largest = [line.values.max() for line in plot.lines]
        assert max(largest) < 6 * min(largest)
    (together,) = _energies([clips[0], clips[2]])
    assert together.title == "energy of all tendons"


def refusal(*arguments):
    with pytest.raises(InputError) as caught:
        compare_runs(*arguments)
    return str(caught.value)


def test_a_folder_without_a_run_is_refused_with_the_requirement(folders, tmp_path):
    page, empty, file = tmp_path / "page.html", tmp_path / "empty", tmp_path / "file"
    empty.mkdir()
    file.write_text("no record", "utf-8")
    quick, slow = folders
    assert "--out: need a file that ends with .html, got" in refusal(folders, tmp_path / "page.pdf")
    assert refusal([quick], page) == "compare: need 2 to 12 folders of runs, got 1"
    assert refusal([quick] * 13, page) == "compare: need 2 to 12 folders of runs, got 13"
    assert refusal([quick, quick / ".." / "quick"], page).startswith("compare: need every run once, got")
    assert refusal([quick, tmp_path / "none"], page).endswith("got no such folder")
    assert refusal([quick, file], page).endswith("got a file")
    assert "holds no run: record.nc is missing" in refusal([quick, empty], page)
    (empty / "record.nc").write_text("no record", "utf-8")
    assert "not a record of forficula" in refusal([slow, empty], page)
    assert not page.exists()


def test_a_folder_name_that_is_not_text_is_displayed_with_replacements(folders, tmp_path):
    quick, slow = folders
    odd = tmp_path / os.fsdecode(b"caf\xe9")
    try:
        odd.mkdir()
    except OSError:
        pytest.skip("the file system wants names that are text")
    (odd / "record.nc").write_bytes((slow / "record.nc").read_bytes())
    compare_runs([quick, odd], tmp_path / "page.html")
    assert "<h1>quick and caf\ufffd</h1>" in (tmp_path / "page.html").read_text("utf-8")


def test_folders_with_equal_names_are_labelled_with_their_parents(folders, tmp_path):
    quick, slow = folders
    for above, folder in (("first", quick), ("second", slow)):
        (tmp_path / above).mkdir()
        (tmp_path / above / "run").mkdir()
        (tmp_path / above / "run" / "record.nc").write_bytes((folder / "record.nc").read_bytes())
    page = tmp_path / "page.html"
    compare_runs([tmp_path / "first" / "run", tmp_path / "second" / "run"], page)
    assert "first/run and second/run" in page.read_text("utf-8")
