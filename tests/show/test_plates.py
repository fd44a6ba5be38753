"""A structure without veins is drawn by everything that draws runs, and missing parts are left out."""

import re
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from rich.console import Console

from forficula.analysis import Verdict, measure
from forficula.design import load_design
from forficula.show.film.film import write_film
from forficula.show.film.film_clock import film_cuts, moment
from forficula.show.film.film_frame import FilmFrame
from forficula.show.folder.run_folder import run_drawings, write_run
from forficula.show.run.outcome_table import outcome_table
from forficula.show.structure.labels import aligned, counted, parts_of
from forficula.show.structure.shape import shape_of
from forficula.show.structure.surface import surface_at
from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH
from forficula.study.running.runs import run
from tests.show.legible import check_words, colours
from tests.show.plates import PARTS, WIDTH


def texts(figure):
    """Return every text of a figure except those of ticks."""
    result = [text.get_text() for axes in figure.axes for text in (*axes.texts, axes.title, axes.xaxis.label)]
    result += [axes.get_ylabel() for axes in figure.axes]
    legends = [*figure.legends, *(legend for axes in figure.axes if (legend := axes.get_legend()))]
    return result + [text.get_text() for legend in legends for text in legend.get_texts()]


# figures that differ from those of the complete structure
CHANGED = {
    "whole": ("pattern", "angles", "energy", "folding", "mechanisms", "package"),
    "with a pattern": ("pattern",),
    "without tendons": ("pattern", "energy", "folding", "mechanisms"),
    "without motors": ("angles", "energy", "folding", "mechanisms"),
    "unmeasured": ("angles",),
}


# the complete structure is also drawn at page width; others have more space there
@pytest.mark.parametrize(("name", "width"), [*((name, COLUMN_WIDTH) for name in PARTS), ("whole", PAGE_WIDTH)])
def test_every_figure_is_drawn_at_any_width_and_all_its_words_can_be_read(plates_runs, name, width):
    drawings = run_drawings(*plates_runs[name])
    assert set(CHANGED["whole"]) >= set(drawings)
    for kind in CHANGED[name]:
        figure = drawings[kind](width)
        check_words(figure, width)
        assert not any(re.search(r"vein|wing|panel|membrane|fold torque|distal", text) for text in texts(figure))


def test_the_plates_are_drawn_where_they_are(plates_runs):
    record, _ = plates_runs["whole"]
    shape = shape_of(record.structure)
    assert shape.regions == ("base", "flap")
    assert shape.solid == (True, True)
    # two with four corners, one divided into three triangles; none beside the polygon that is not convex
    assert [len(face) for face in shape.faces] == [4, 4, 3, 3, 3]
    for time in (0.0, 0.09, 0.33):
        surface = surface_at(record, shape, time)
        row = np.argmin(np.abs(record.time - time))
        assert surface.faces[0] == pytest.approx(record.series["point_position"][row, :4])
        areas = [np.linalg.norm(np.cross(face[2] - face[0], face[3] - face[1])) / 2 for face in surface.faces[:2]]
        areas += [np.linalg.norm(np.cross(face[1] - face[0], face[2] - face[0])) / 2 for face in surface.faces[2:]]
        assert sum(areas) == pytest.approx(WIDTH * (0.08 + 0.08 + (0.06 + 0.035) / 2))
    assert len(surface.lines) == 4 + 4 + 5
    assert len(surface.bars) == 0


def test_angles_and_distances_have_a_row_each_and_the_states_their_letters(plates_runs):
    figure = run_drawings(*plates_runs["whole"])["angles"](PAGE_WIDTH)
    assert [axes.get_ylabel() for axes in figure.axes if axes.get_ylabel()] == ["fold angle (deg)", "mouth (cm)"]
    assert [text for text in texts(figure) if text in "abc" and text] == ["a", "b", "c"]
    assert {"crease 1", "crease 2"} <= set(texts(figure))
    # the angles fill their axis
    angles = np.degrees(plates_runs["whole"][0].series["hinge_angle"])
    assert np.ptp(figure.axes[0].get_ylim()) < 1.2 * np.ptp(angles)


@pytest.mark.filterwarnings("error:constrained_layout")
@pytest.mark.parametrize(("panel", "width"), [("1 cm", COLUMN_WIDTH), ("9.9 cm", PAGE_WIDTH)])
def test_hundreds_of_panels_are_drawn_so_that_their_words_can_be_read(long_strip, width, panel):
    record, outcome = long_strip(panel)
    figures = {name: run_drawings(record, outcome)[name](width) for name in ("pattern", "angles", "folding")}
    for figure in figures.values():
        check_words(figure, width)
    (legend,) = [legend for axes in figures["angles"].axes if (legend := axes.get_legend())]
    assert [text.get_text() for text in legend.get_texts()] == ["199 creases, median"]
    # not a line: at least a tenth as high as long
    box = figures["pattern"].axes[0].get_window_extent()
    assert 0.08 < box.height / box.width < 0.2


@pytest.fixture(scope="module")
def long_strip():
    """Runs of a few timesteps with 200 panels."""

    @cache
    def of_panels(length):
        stages = [{"name": "settle", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "1 ms"}]
        values = {"pattern.panels": 200, "pattern.panel_lengths": [length], "protocol.stages": stages}
        record = run(load_design("letter-fold", values))
        return record, measure(record)

    return of_panels


def test_without_a_measure_the_angles_that_are_driven_are_drawn(plates_runs):
    figure = run_drawings(*plates_runs["unmeasured"])["angles"](PAGE_WIDTH)
    assert [axes.get_ylabel() for axes in figure.axes if axes.get_ylabel()] == ["crease angle (deg)"]


def test_what_a_structure_lacks_is_in_no_legend(plates_runs):
    present = {
        name: set(texts(run_drawings(*plates_runs[name])["energy"](PAGE_WIDTH)))
        for name in ("whole", "without tendons")
    }
    assert {"tendons", "hinges", "kinetic", "dissipated by tendons"} <= present["whole"]
    assert not {"tendons", "dissipated by tendons", "membrane"} & present["without tendons"]
    assert "done by torques" not in texts(run_drawings(*plates_runs["without motors"])["energy"](PAGE_WIDTH))
    folding = texts(run_drawings(*plates_runs["without tendons"])["folding"](PAGE_WIDTH))
    assert {"base", "flap"} <= set(folding)
    assert "tendon" not in folding


def test_a_pattern_is_drawn_with_its_letters_and_without_one_what_is_built(plates_runs):
    patterned, plain = (
        set(texts(run_drawings(*plates_runs[name])["pattern"](PAGE_WIDTH))) for name in ("with a pattern", "whole")
    )
    assert {"mountain", "valley", "border", "tendon", "1", "2"} <= patterned
    assert {"edge of a plate", "tendon", "1", "2"} <= plain


@pytest.mark.parametrize("name", PARTS)
def test_every_run_is_filmed(plates_runs, name):
    record, outcome = plates_runs[name]
    cuts = film_cuts(record, outcome)
    held = [cut.words for cut in cuts if cut.first == cut.last]
    assert held == ([] if name == "without motors" else ["a flat", "b closed", "c open"])
    frame = FilmFrame(record, cuts, (320, 180))
    pictures = [frame.draw(*moment(cuts, time)).copy() for time in (0.0, sum(cut.length for cut in cuts) / 2)]
    assert all(colours(picture) > 10 for picture in pictures)


def test_a_film_is_written(plates_runs, tmp_path):
    write_film(plates_runs["whole"][0], tmp_path / "plates.gif", size=(160, 160), rate=2)
    assert (tmp_path / "plates.gif").stat().st_size > 1000


def test_the_table_has_a_row_for_every_hinge_distance_and_tendon(plates_runs):
    _, outcome = plates_runs["whole"]
    assert outcome.verdict is Verdict.REACHED
    console = Console(width=110)
    with console.capture() as capture:
        console.print(outcome_table("plates", outcome))
    output = [line.rstrip() for line in capture.get().splitlines()]
    # the first of each: states that do not fit continue below
    lines = {line.split("  ")[0].strip(): line for line in reversed(output)}
    assert {"crease 1", "crease 2", "mouth", "pull", "sum", "closing", "opening"} <= set(lines)
    # angles, and the springs' energies, which are part of the sum
    assert [float(cell) for cell in lines["crease 1"].split()[2:]][::2] == [-3.0, 172.0]
    stored = outcome.states["closed"]
    energy = 1e3 * (stored.tendon_energy.sum() + stored.hinge_energy.sum())
    assert f"{energy:.4g}" in lines["sum"].split()
    assert "+ change of hinge energy" in lines
    assert "+ dissipated by stops" in lines
    assert not any("membrane" in line for line in lines)


def test_a_wide_table_of_states_continues_below(plates_runs):
    record, outcome = plates_runs["whole"]
    missed = replace(outcome, holds=outcome.holds | {"closed": False})
    later = replace(
        record.structure,
        states=tuple(replace(state, unknown='after stage "close it slowly"') for state in record.structure.states),
    )
    console = Console(width=110)
    with console.capture() as capture:
        console.print(outcome_table("plates", replace(missed, structure=later)))
    lines = [line.rstrip() for line in capture.get().splitlines()]
    assert any('after stage "close it slowly":' in line for line in lines)
    assert max(map(len, lines)) <= 100
    assert sum(line.startswith("sum") for line in lines) == 3


def test_advice_does_not_mention_a_membrane_that_does_not_exist(plates_runs):
    record, _ = plates_runs["whole"]
    advice = measure(replace(record, diverged_at=0.5)).advice
    assert advice == 'Take a shorter timestep: protocol.timestep = "auto" chooses one.'


def test_names_that_differ_in_their_numbers_share_their_word():
    assert parts_of(["vein 0", "vein 12"]).heading == "vein"
    assert parts_of(["vein 0", "vein 12"]).names == ("0", "12")
    assert parts_of(["left", "right"]).names == ("left", "right")
    assert parts_of(["crease 1", "pull"]).heading == parts_of([]).heading == ""
    assert (counted(["vein 0"], "hinge"), counted(["a", "b"], "hinge")) == ("1 vein", "2 hinges")


def test_equal_names_share_a_row():
    rows, places = aligned([["vein 0", "vein 1"], ["vein 1", "vein 1", "cap"]])
    assert rows == ["vein 0", "vein 1", "vein 1", "cap"]
    assert places == [[0, 1], [1, 2, 3]]


def test_a_run_of_a_named_design_of_plates_writes_all_files(letter_run, no_figures, tmp_path):  # noqa: ARG001
    record, outcome = letter_run, measure(letter_run)
    write_run(record, outcome, tmp_path, engine=False, copies=(".svg", ".pdf"))
    assert outcome.verdict is Verdict.REACHED
    for name in ("pattern", "angles", "energy", "folding"):
        assert {f"{name}.png", f"figures/{name}.svg", f"figures/{name}.pdf"} <= {
            path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*.*")
        }
    page = (tmp_path / "report.html").read_text("utf-8")
    assert "Every value is that of the named design letter-fold." in page
    assert "Tendons: pull-only springs between two places" in page
