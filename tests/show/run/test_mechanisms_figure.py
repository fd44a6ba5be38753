from dataclasses import replace

import numpy as np
import pytest

from forficula.analysis.energy_by_mechanism import energy_shares
from forficula.design import load_design
from forficula.show.run.mechanisms_figure import draw_mechanisms, energy_bands, energy_spans, mechanism_colours
from forficula.show.run.outcome_table import print_events
from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH, description
from forficula.structure import Mechanism
from forficula.study.running.runs import run

STAGE = {"hold": "0 s", "drive": "none", "until": "time", "name": "settle", "time_limit": "20 ms"}


def panels(figure):
    """Axes with areas."""
    return [axes for axes in figure.axes if axes.collections]


def upper_edges(axes):
    """Largest height of each area, the lowest area first."""
    return [float(area.get_paths()[0].vertices[:, 1].max()) for area in axes.collections]


@pytest.mark.parametrize("width", [PAGE_WIDTH, COLUMN_WIDTH])
def test_every_driven_stage_has_a_panel_whose_areas_reach_the_line_of_the_energy_supplied(reference_run, width):
    figure = draw_mechanisms(reference_run, width)
    shown = panels(figure)
    assert [axes.get_title() for axes in shown] == ["fold", "unfold"]
    for axes in shown:
        supplied = axes.lines[0].get_ydata()
        assert upper_edges(axes)[-1] == pytest.approx(supplied.max(), rel=0.01)
        assert upper_edges(axes) == sorted(upper_edges(axes))
    assert figure.get_size_inches()[0] == width


def test_the_legend_has_the_areas_from_top_to_bottom_and_the_events(reference_run):
    figure = draw_mechanisms(reference_run)
    legend = next(axes.get_legend() for axes in figure.axes if axes.get_legend())
    texts = [text.get_text().replace("\n", " ") for text in legend.get_texts()]
    assert texts == [
        "energy at the start plus work of the torques",
        *("losses", "motion", "membrane", "tendons"),
        *("end of the drive", "goal reached", "half-way: turn", "half-way: ring"),
    ]


def test_losses_of_a_panel_count_from_its_start(reference_run):
    shares = energy_shares(reference_run)
    for span in energy_spans(reference_run):
        rows = (reference_run.time >= span.start) & (reference_run.time <= span.end)
        *held, lost = energy_bands(reference_run, shares, rows)
        assert lost.energy[0] == 0
        total = sum(band.energy for band in held) + lost.energy
        start = shares.held[rows][0]
        work = reference_run.work[rows] - reference_run.work[rows][0]
        np.testing.assert_allclose(total, start + work, atol=0.01 * total.max())


def test_a_panel_ends_after_the_motion_and_not_with_the_drive(reference_run):
    """The wing is still long before it is released, and a wing that a pulse starts moves long after the pulse."""
    fold, unfold = energy_spans(reference_run)
    assert fold.stage.goal_time < fold.end < unfold.start
    stages = list(reference_run.stages)
    stages[1] = replace(stages[1], end=stages[1].start + 0.002, goal_time=None)
    pulse, _ = energy_spans(replace(reference_run, stages=tuple(stages)))
    assert pulse.end == pytest.approx(fold.end, abs=0.02)


def test_a_run_without_drives_is_drawn_as_a_whole():
    record = run(load_design("binder2025", {"protocol.stages": [STAGE]}))
    (axes,) = panels(draw_mechanisms(record))
    assert axes.get_title() == "whole run"
    assert axes.get_xlim()[1] == pytest.approx(20)


def test_a_diverged_run_is_drawn_until_it_diverged():
    record = run(load_design("binder2025", {"protocol.timestep": "5 ms"}))
    assert record.diverged_at is not None
    for axes in panels(draw_mechanisms(record)):
        assert np.isfinite(upper_edges(axes)).all()


def test_the_description_gives_the_largest_energies(reference_run):
    text = description(draw_mechanisms(reference_run))
    assert 'Largest energies in the stage "fold": tendons 0.54' in text
    assert "J of 2.36" in text


def test_mechanisms_have_different_colours():
    kinds = ("tendons", "membranes", "hinges", "springs", "couplings")
    parts = tuple(Mechanism(name=f"{part}: {kind}", **{kind: (0,)}) for part in ("fan", "midwing") for kind in kinds)
    colours = mechanism_colours(parts)
    assert len(set(colours)) == len(parts)
    # the kinds of a structure without mechanisms have the colours of other figures
    assert mechanism_colours(parts[:5]) == ["#0072B2", "#E69F00", "#56B4E9", "#009E73", "#CC79A7"]


def test_the_terminal_says_in_which_order_groups_of_hinges_move(reference_run, letter_run, capsys):
    print_events(reference_run)
    output = " ".join(capsys.readouterr().out.split())
    assert output.count("Stage ") == 2
    assert 'Stage "fold", times since its start: the turn begins to move at 2 ms' in output
    # a single group of hinges
    print_events(letter_run)
    assert not capsys.readouterr().out
