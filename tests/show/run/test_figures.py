import re
from dataclasses import replace

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.lines import Line2D
from rich.console import Console

from forficula.analysis import measure
from forficula.design import load_design, scale_design
from forficula.quantities import show_value
from forficula.show import draw_angles, draw_energies, draw_folding, draw_pattern, outcome_table
from forficula.show.folder.run_folder import run_drawings
from forficula.show.run import folding_figure
from forficula.show.structure.shape import shape_of
from forficula.show.structure.surface import surface_at
from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH, description
from forficula.structure import measure_of, structure_of
from forficula.study.running.runs import run
from tests.show.legible import colours
from tests.show.sheets import sheet_run

STAGE = {"hold": "0 s", "drive": "none", "until": "time"}
ONLY_SETTLED = [STAGE | {"name": "settle", "time_limit": "20 ms"}]
NOT_FOLDED = [*ONLY_SETTLED, STAGE | {"name": "fold", "drive": "fold", "until": "folded", "time_limit": "5 ms"}]


@pytest.fixture(scope="module")
def runs(reference_run):
    short = [run(load_design("binder2025", {"protocol.stages": stages})) for stages in (ONLY_SETTLED, NOT_FOLDED)]
    diverged = run(load_design("binder2025", {"protocol.timestep": "5 ms"}))
    return {"reference": reference_run, "settled": short[0], "not folded": short[1], "diverged": diverged}


def pixels(figure):
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[..., :3]


# the reference is drawn in tests of words
@pytest.mark.parametrize("name", ["settled", "not folded", "diverged"])
def test_every_run_can_be_drawn_whatever_the_wing_did(runs, name):
    record = runs[name]
    outcome = measure(record)
    for figure in (draw_angles(record, outcome), draw_energies(record), draw_folding(record, outcome)):
        assert colours(pixels(figure)) > 10  # not blank


def test_only_some_of_very_many_moments_are_drawn(runs, monkeypatch):
    record = runs["reference"]
    titles = [axes.get_title() for axes in draw_folding(record, measure(record)).axes if axes.get_title()]
    monkeypatch.setattr("forficula.show.run.folding_figure._MOST_PICTURES", 3)
    figure = draw_folding(record, measure(record))
    shown = [axes.get_title() for axes in figure.axes if axes.get_title() and "enlarged" not in axes.get_title()]
    drawn = [title for title in titles if "enlarged" not in title]
    assert (shown[0], len(shown), shown[-1]) == (drawn[0], 3, drawn[-1])
    assert f"at 3 of {len(drawn)} moments of a run" in description(figure)


def test_a_diverging_sheet_is_drawn_until_it_is_torn():
    stage = STAGE | {"name": "settle", "time_limit": "20 ms", "state": "settled"}
    torn = {"crease.stiffness": "0 N m/rad/m", "crease.rest_angle": "flat"}
    small = {"pattern.columns": 2, "pattern.rows": 2, "support": [{"of": "facet 0"}], "measure": [], "drive": []}
    weight = {"protocol.gravity": "9.81 m/s^2", "protocol.timestep": "0.03 ms", "protocol.stages": [stage]}
    record = run(load_design("miura-sheet", small | torn | weight))
    span = np.ptp(record.series["point_position"], axis=1).max(axis=1)
    assert not np.nanmax(np.where(np.isfinite(span), span, np.inf)) < 100 * record.structure.span
    figure = draw_folding(record, measure(record))
    assert colours(pixels(figure)) > 10
    assert max(figure.axes[0].get_xlim()) < 10 * record.structure.span


def test_every_axis_over_time_names_its_quantity_and_unit(runs):
    record = runs["reference"]
    for figure in (draw_angles(record, measure(record)), draw_energies(record)):
        for axes in figure.axes:
            if axes.get_subplotspec().is_first_col():
                assert axes.get_ylabel().endswith(("(deg)", "(J)"))
            if axes.get_subplotspec().is_last_row():
                assert axes.get_xlabel().endswith(("(s)", "(ms)"))


def entries(figure):
    """Return the entries of all legends of a figure: words and handle."""
    keys = [*figure.legends, *(key for axes in figure.axes if (key := axes.get_legend()))]
    pairs = (pair for key in keys for pair in zip(key.get_texts(), key.legend_handles, strict=True))
    return [(text.get_text(), handle) for text, handle in pairs]


def shown(handle):
    """Return whether the handle of a legend shows something."""
    if isinstance(handle, Line2D):
        return handle.get_linestyle() != "None" or handle.get_marker() not in (None, "None", "")
    return True


@pytest.mark.parametrize("name", ["settled", "not folded", "diverged"])
@pytest.mark.parametrize("width", [COLUMN_WIDTH, PAGE_WIDTH])
def test_every_entry_of_a_legend_has_a_line_or_a_colour(runs, name, width):
    for draw in run_drawings(runs[name], measure(runs[name])).values():
        assert [words for words, handle in entries(draw(width)) if not shown(handle)] == []


@pytest.mark.parametrize("count", range(1, 17))
@pytest.mark.parametrize("width", [COLUMN_WIDTH, PAGE_WIDTH])
def test_pictures_in_rows_leave_at_most_one_place_empty_beside_the_legend(count, width):
    columns = folding_figure._columns(count, width)
    assert -count % columns <= 2
    assert width / columns > 1.1  # inch


def test_a_run_begins_and_ends_with_a_picture_and_leaves_out_moments_that_look_the_same():
    # the creases let go after the fold, and the sheet springs back
    record, outcome = sheet_run("miura with a tendon")
    titles = [axes.get_title() for axes in draw_folding(record, outcome).axes if axes.get_title()]
    reached = [name for name, state in outcome.states.items() if state is not None]
    for letter, name in zip("abc", reached, strict=False):
        assert any(title.startswith(f"{letter} {name}") for title in titles)
    shape = shape_of(record.structure)
    moments = folding_figure._moments(record, outcome)
    assert [moment.time for moment in moments] == sorted(moment.time for moment in moments)
    assert moments[0].time <= record.stages[1].start
    last = [surface_at(record, shape, time).faces for time in (moments[-1].time, float(record.time[-1]))]
    assert np.abs(last[1] - last[0]).max() < 0.05 * record.structure.span


@pytest.mark.parametrize("width", [COLUMN_WIDTH, PAGE_WIDTH])
def test_every_picture_is_in_the_middle_of_its_place_and_as_large_as_the_others_allow(runs, width):
    figure = draw_folding(runs["reference"], measure(runs["reference"]), width)
    largest = [0.0, 0.0]
    for axes in (axes for axes in figure.axes if axes.images):
        (left, right, low, high), (start, end) = axes.images[0].get_extent(), axes.get_xlim()
        assert (left + right) / 2 == pytest.approx((start + end) / 2, abs=0.02 * (end - start))
        largest = np.maximum(largest, [(right - left) / (end - start), (high - low) / np.ptp(axes.get_ylim())])
    # at most 15 % of the width and 30 % of the height of the fullest place are empty
    assert largest[0] > 0.85
    assert largest[1] > 0.7


def test_axes_of_angles_and_distances_are_as_wide_as_the_data(runs):
    sheet = sheet_run("miura with a tendon")
    for record, outcome in ((runs["reference"], measure(runs["reference"])), sheet):
        for axes in draw_angles(record, outcome).axes:
            lines = [line.get_ydata() for line in axes.lines if len(line.get_ydata()) > 2]
            values = np.concatenate(lines)
            assert np.ptp(values[np.isfinite(values)]) > 0.75 * np.ptp(axes.get_ylim())


def test_many_similar_creases_are_grouped_by_role_and_their_states_are_marked_on_a_line():
    record, outcome = sheet_run("miura with a tendon")
    axes = draw_angles(record, outcome).axes[0]
    words = [text.get_text() for text in draw_angles(record, outcome).axes[1].get_legend().get_texts()]
    assert [word.partition(",")[0] for word in words] == ["straight (12)", "zigzag (12)"]
    median = next(line for line in axes.lines if line.get_label().startswith("straight"))
    marks = [line for line in axes.lines if line.get_marker() == "o"]
    assert marks
    for mark in marks:
        at = np.interp(mark.get_xdata()[0], median.get_xdata(), median.get_ydata())
        assert mark.get_ydata()[0] == pytest.approx(at, abs=1.0)


def test_stages_are_numbered_where_their_names_do_not_fit_above_the_whole_run(runs):
    record = runs["reference"]
    close = {"fold": "a long name of a stage", "unfold": "another long name of a stage"}
    stages = tuple(
        replace(end, stage=end.stage.model_copy(update={"name": close.get(end.stage.name, end.stage.name)}))
        for end in record.stages
    )
    whole, first, second = draw_energies(replace(record, stages=stages)).axes[:3]
    assert [text.get_text() for text in whole.texts if text.get_text() in "12"] == ["1", "2"]
    assert "1 a long name of a stage" in [text.get_text() for text in first.texts]
    assert "2 another long name of a stage" in [text.get_text() for text in second.texts]


def test_the_three_states_are_marked_where_they_are(runs):
    record = runs["reference"]
    outcome = measure(record)
    axes = draw_angles(record, outcome).axes[0]
    marks = {text.get_text(): text.get_position() for text in axes.texts if text.get_text() in ("a", "b", "c")}
    expected = dict(zip("abc", outcome.states.values(), strict=True))
    assert {letter: place[0] for letter, place in marks.items()} == {
        letter: state.time for letter, state in expected.items()
    }


@pytest.fixture(scope="module")
def small():
    """A run of a wing of 10 mm, the size of an earwig's."""
    return run(scale_design(load_design("binder2025"), 1 / 22))


def test_the_figures_of_a_small_wing_are_in_millimetres_and_milliseconds(small):
    outcome = measure(small)
    assert draw_pattern(small.structure).axes[0].get_xlabel() == "x (mm)"
    assert draw_angles(small, outcome).axes[0].get_xlabel() == "time (ms)"
    assert draw_energies(small).axes[0].get_ylabel() == "energy (mJ)"
    folding = draw_folding(small, outcome).axes
    assert any(text.get_text() == "2 mm" for axes in folding for text in axes.texts)


@pytest.mark.parametrize("name", ["reference", "small"])
def test_every_picture_has_its_stage_and_the_time_since_its_start(runs, small, name):
    record = small if name == "small" else runs[name]
    outcome = measure(record)
    titles = [axes.get_title() for axes in draw_folding(record, outcome).axes if axes.get_title()]
    (enlarged,) = (title for title in titles if "enlarged" in title)
    # in the order of time, the enlarged state beside itself
    assert titles[titles.index(enlarged) - 1].startswith("b folded")
    output = [title for title in titles if title != enlarged]
    assert len({title.partition("\n")[2] or title for title in output}) == len(output) == 7
    starts = {end.stage.name: end.start for end in record.stages}
    for state, letter in zip(outcome.states.values(), "abc", strict=True):
        (title,) = (item for item in output if item.startswith(f"{letter} "))
        stage, since = title.partition("\n")[2].split(" + ")
        factor = {"s": 1, "ms": 1e-3}[since.split()[1]]
        assert factor * float(since.split()[0]) == pytest.approx(state.time - starts[stage], rel=5e-3)
    assert re.fullmatch(r"b folded\nenlarged 1\.\d times", enlarged)


def test_pictures_between_states_are_at_thirds_of_the_angle(runs):
    record = runs["reference"]
    fold = record.stages[1]
    titles = [axes.get_title() for axes in draw_folding(record, measure(record)).axes]
    times = [fold.start + 1e-3 * float(title.split()[2]) for title in titles if title.startswith("fold + ")]
    rows = (record.time >= fold.start) & (record.time <= fold.end)
    # ring hinges and driven hinges turn by different angles: each as a share of its own maximum
    turned = np.abs(record.series["hinge_angle"][rows] - record.series["hinge_angle"][rows][0])
    groups = [measure_of(record.structure, "ring").hinges, record.structure.motors[0].hinges]
    shares = (
        sum(turned[:, list(group)].mean(axis=1) / turned[:, list(group)].mean(axis=1).max() for group in groups) / 2
    )
    done = np.interp(times, record.time[rows], shares)
    assert done == pytest.approx([1 / 3, 2 / 3], abs=0.1)


def test_a_state_that_is_as_large_as_the_whole_is_not_enlarged(runs):
    titles = [axes.get_title() for axes in draw_folding(runs["settled"], measure(runs["settled"])).axes]
    assert not any("enlarged" in title for title in titles)


def test_the_table_of_a_small_wing_reads_well(small):
    console = Console(width=110)
    with console.capture() as capture:
        console.print(outcome_table("small", measure(small)))
    header, times = (
        next(line for line in capture.get().splitlines() if line.startswith(word)) for word in ("vein", "time")
    )
    assert "(mm)" in header
    assert "(µJ)" in header
    assert all(1 <= float(cell) < 1000 for cell in times.split()[1::2])
    assert set(times.split()[2::2]) == {"ms"}


def test_a_wing_that_did_not_fold_has_no_mark_for_folded(runs):
    record = runs["not folded"]
    axes = draw_angles(record, measure(record)).axes[0]
    assert [text.get_text() for text in axes.texts if text.get_text() in ("a", "b", "c")] == ["a"]


@pytest.mark.parametrize("units", [1, 2, 5])
def test_the_pattern_shows_every_crease_and_tendon_of_a_fan(units):
    design = load_design("binder2025", {"pattern.units": units, "pattern.sector_angle": "12 deg"})
    figure = draw_pattern(structure_of(design))
    veins = 2 * units + 1
    # proximal, distal, ring, hub and outer edges, then the hub circle and the tendons
    edges = 2 * veins + 3 * (veins - 1)
    assert len(figure.axes[0].lines) == edges + 1 + veins


def test_the_largest_kinetic_energy_is_drawn_and_reported_even_between_two_samples(runs):
    record = runs["reference"]
    at, most = record.kinetic_peak
    assert at not in record.time
    assert most > 1.01 * record.series["kinetic_energy"].max()
    figure = draw_energies(record)
    (line,) = (line for line in figure.axes[0].lines if line.get_label() == "kinetic")
    assert line.get_ydata().max() == most
    assert line.get_xdata()[line.get_ydata().argmax()] == pytest.approx(at)
    assert f"kinetic {show_value(most, 'J')}" in description(figure)
