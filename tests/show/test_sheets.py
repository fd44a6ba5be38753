"""Sheets whose facets bend are drawn by everything that draws runs: facets, creases by fold angle, supports."""

import dataclasses
import re

import numpy as np
import pytest
from rich.console import Console

from forficula.show import print_outcome, print_strength
from forficula.show.film.film_clock import film_cuts, moment
from forficula.show.film.film_frame import FilmFrame
from forficula.show.folder.run_folder import run_drawings
from forficula.show.page.parts.outcome_tables import strength_table
from forficula.show.page.playback import clip_data, legend_data, make_clip, mark_readings
from forficula.show.run.outcome_rows import balance_rows, state_rows
from forficula.show.structure.labels import by_number, condensed, reading_labels, role_groups
from forficula.show.structure.painted_shape import fold_colours, paint_shape
from forficula.show.structure.shape import shape_of
from forficula.show.structure.surface import surface_at
from forficula.show.structure.viewpoint import page_view
from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH
from forficula.structure import facet_triangles, hinge_groups, measure_of
from tests.show.legible import check_words, colours
from tests.show.sheets import SHEETS, sheet_run


def words_of(figure):
    """Return every text in the legends of a figure."""
    legends = [*figure.legends, *(legend for axes in figure.axes if (legend := axes.get_legend()))]
    return [text.get_text() for legend in legends for text in legend.get_texts()]


# page-wide figures have space for all words except for the one with the most
@pytest.mark.parametrize(
    ("name", "width"),
    [*((name, COLUMN_WIDTH) for name in SHEETS), ("miura with a tendon", PAGE_WIDTH), ("single vertex", PAGE_WIDTH)],
)
def test_every_figure_is_drawn_at_any_width_and_all_its_words_can_be_read(name, width):
    for draw in run_drawings(*sheet_run(name)).values():
        figure = draw(width)
        check_words(figure, width)
        assert not any(re.search(r"vein|wing|panel|plate|bend \d", text) for text in words_of(figure))


@pytest.mark.parametrize("name", SHEETS)
def test_the_facets_are_drawn_where_they_are_and_no_bar_on_them(name):
    record, _ = sheet_run(name)
    structure = record.structure
    shape = shape_of(structure)
    triangles, facets = facet_triangles(structure)
    assert np.bincount(facets).tolist() == [len(facet.points) - 2 for facet in structure.facets]
    for corners, facet in zip(triangles.tolist(), facets.tolist(), strict=True):
        assert set(corners) <= set(structure.facets[facet].points)
    surface = surface_at(record, shape, float(record.time[-1]))
    assert surface.faces[:, :3] == pytest.approx(record.series["point_position"][-1][triangles])
    assert len(surface.bars) == 0
    creases = hinge_groups(structure)["creases"]
    assert sorted(line.hinge for line in shape.lines if line.hinge is not None) == list(creases)
    tails = [structure.hinges[crease].flaps[0] for crease in creases]
    assert surface.lines[-len(creases) :, 0] == pytest.approx(record.series["point_position"][-1][tails])


def test_creases_show_how_they_fold():
    record, _ = sheet_run("flat")
    shape = shape_of(record.structure)
    start, end = (surface_at(record, shape, time).folds for time in (0.0, float(record.time[-1])))
    letters = [line.crease for line in shape.lines]
    folds = np.isfinite(end)
    assert start[folds] == pytest.approx(0.0, abs=1e-6)
    assert [("M" if angle < 0 else "V") for angle in end[folds]] == [letter for letter in letters if letter != "B"]
    valley, mountain, flat, folded = fold_colours(np.array([1.0, -1.0, 0.0, 3.0]))
    assert valley[2] > valley[0]
    assert mountain[0] > mountain[2]
    assert np.ptp(flat[:3]) == 0
    assert np.ptp(folded[:3]) > np.ptp(valley[:3])


def test_a_facet_is_seen_from_its_back_where_it_is_turned():
    record, _ = sheet_run("flat")
    shape, view = shape_of(record.structure), page_view()
    surface = surface_at(record, shape, 0.0)
    turned = type(view)(right=view.right, up=-view.up, towards=-view.towards)
    above, below = (_seen(paint_shape(surface, item, "red")) for item in (view, turned))
    # paper has more red than blue, its back more blue than red; lines have neither
    assert (above[:, 0] >= above[:, 2]).mean() > 0.9
    assert (below[:, 2] > below[:, 0]).mean() > 0.8


def _seen(painted):
    """Return the colours of the pixels that are not empty."""
    low, high = painted.corners
    pixel = float(np.ptp([low, high], axis=0).max()) / 100
    picture = painted.picture(low, pixel, (100, 100)).reshape(-1, 4).astype(float)
    return picture[picture[:, 3] == 255]


def test_many_creases_are_summarised_by_smallest_median_and_largest_angle():
    record, outcome = sheet_run("miura with a tendon")
    structure = record.structure
    creases = measure_of(structure, "creases")
    assert list(role_groups(structure, creases)) == ["straight", "zigzag"]
    assert reading_labels(structure, creases) == ["smallest", "median straight", "median zigzag", "largest"]
    angles = record.measured("creases")
    output = condensed(structure, creases, angles)
    assert np.array_equal(output[:, 0], angles.min(axis=1))
    assert np.array_equal(output[:, 3], angles.max(axis=1))
    assert all(row[1] in every and row[2] in every for row, every in zip(output, angles, strict=True))
    rows = state_rows(structure, {name: state for name, state in outcome.states.items() if state is not None})
    names = [row[0] for row in rows.parts]
    assert names[:4] == ["smallest", "median straight", "median zigzag", "largest"]
    assert names[-3:] == ["creases", "facet bends", "bars"]
    assert rows.summed == "tendons, creases, facet bends and bars"
    clip = make_clip(record, outcome)
    assert clip.readings[0].labels == tuple(names[:4])
    assert all(len(mark_readings(clip, clip.readings[0], mark)[0]) == 4 for mark in clip.marks)


def test_the_energy_balance_separates_creases_from_bars():
    record, outcome = sheet_run("tower")
    output = dict(balance_rows(record.structure, outcome.energy_balance))
    assert any(label.endswith("change of crease energy") for label in output)
    assert any(label.endswith("change of bar energy") for label in output)
    assert words_of(run_drawings(record, outcome)["energy"](PAGE_WIDTH))[:3] == ["creases", "bars", "kinetic"]


def test_the_energy_balance_is_in_the_unit_of_its_largest_term():
    """The work of a stack that sinks under its weight is zero, and its gravitational energy is not."""
    record, outcome = sheet_run("tower")
    sinks = {"work": 0.0, "tendon": 0.0, "hinges": 0.0, "springs": 0.0, "gravitational": -2.765e-4}
    zero = dict.fromkeys(("hinge_damping", "elastic_damping", "kinetic", "stops"), 0.0)
    balance = dataclasses.replace(outcome.energy_balance, **sinks, **zero)
    output = dict(balance_rows(record.structure, balance))
    assert output["+ change of gravitational energy"] == "-0.2765 mJ"


def test_labels_with_numbers_are_listed_in_their_order():
    labels = ["crease 0", "crease 1", "crease 13", "crease 2"]
    assert [labels[place] for place in by_number(labels)] == ["crease 0", "crease 1", "crease 2", "crease 13"]
    assert by_number(["ring", "beside 3", "beside 1"]) == [0, 1, 2]


def test_the_page_shows_facets_creases_by_assignment_and_supports():
    record, outcome = sheet_run("miura with a tendon")
    clip = make_clip(record, outcome)
    assert [entry["text"] for entry in legend_data([clip])] == [
        "mountain (dash-dotted crease)",
        "valley (dashed crease)",
        "facet",
        "support",
        "tendon, coloured by stored energy",
    ]
    data = clip_data(clip)
    assert len(data["triangles"]) == 3 * 2 * 16
    assert {tube["kind"] for tube in data["tubes"]} == {"crease", "rim", "tendon"}
    assert len(data["joints"]) == 4
    assert "<td>edge" in strength_table(record)


def test_the_terminal_output_of_a_sheet_is_short(capsys):
    record, outcome = sheet_run("miura with a tendon")
    print_outcome("sheet", outcome)
    print_strength(record)
    printed = capsys.readouterr().out
    assert len(printed.splitlines()) < 70
    assert all(
        word in printed for word in ("facet bends", "120 deg", "work of the drives", "Largest strains and folds")
    )
    assert "bend 4" not in printed
    assert Console(width=110).measure(printed).maximum <= 110


@pytest.mark.parametrize("name", ["miura with a tendon", "tower"])
def test_a_film_shows_it_from_start_to_end(name):
    record, outcome = sheet_run(name)
    cuts = film_cuts(record, outcome, None)
    frame = FilmFrame(record, cuts, (640, 360))
    first, last = (frame.draw(*moment(cuts, time)).copy() for time in (0.0, sum(cut.length for cut in cuts)))
    assert colours(first) > 50
    assert (first != last).any()
