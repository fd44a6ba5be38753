"""Figures of a run that missed a goal: its motion, enlarged, and the acting torque with the least sufficient one."""

import numpy as np
import pytest

from forficula.analysis import Verdict, measure
from forficula.design import load_design, with_values
from forficula.show import draw_angles, draw_energies
from forficula.show.folder.run_folder import run_drawings
from forficula.show.run.missed_goal import needed_torque, stalled_stage, still_time
from forficula.statics import energy_landscape
from forficula.study.running.runs import run

SHORT = {"protocol.stages.0.time_limit": "20 ms", "protocol.stages.1.time_limit": "0.3 s", "protocol.rise": "0.1 s"}
WEAK = SHORT | {"protocol.fold_torque": "1 N cm", "tendon.rest_length": "7 cm"}


@pytest.fixture(scope="module")
def weak():
    """The reference with a torque that does not fold it."""
    return run(load_design("binder2025", WEAK))


@pytest.fixture(scope="module")
def drawings(weak):
    """Its drawings, with the least torque computed once."""
    return run_drawings(weak, measure(weak))


def lines(axes):
    return {line.get_label(): line for line in axes.lines}


def test_energies_are_their_changes_since_the_stage_that_missed_its_goal(weak):
    assert measure(weak).verdict in (Verdict.STUCK, Verdict.MOVING)
    whole, fold, *_ = draw_energies(weak).axes
    assert whole.get_ylabel().startswith("change of energy (")
    tendons = lines(fold)["tendons"]
    start = np.argmin(np.abs(tendons.get_xdata()))
    assert tendons.get_ydata()[start] == 0
    # the total stored energy would hide it
    assert max(whole.get_ylim()) < 0.5 * 1e3 * weak.series["tendon_energy"].sum(axis=1).max()


def test_the_motion_is_close_up_in_time_and_angle(weak, drawings):
    stage = stalled_stage(weak)
    figure = drawings["angles"](7.1)
    whole, fold = figure.axes[:2]
    assert whole.get_ylabel() == "turn angle (deg)"
    moved = still_time(weak, stage.start, stage.end) - stage.start
    assert fold.get_xlim()[1] <= 1e3 * 2 * moved
    rows = weak.time >= stage.start
    ring = np.degrees(weak.series["hinge_angle"][rows][:, list(weak.structure.measures[0].hinges)])
    low, high = figure.axes[2].get_ylim()
    assert low <= ring.min() < ring.max() <= high
    assert high - low <= max(0.1, 1.4 * np.ptp(ring))


def test_the_acting_torque_is_drawn_with_the_least_slow_torque(weak, drawings):
    figure = drawings["angles"](7.1)
    place = next(place for place, axes in enumerate(figure.axes) if axes.get_ylabel() == "torque (N cm)")
    drawn = lines(figure.axes[place + 1])  # lines of the stage, in ms
    acts = drawn["acting on every proximal joint"]
    at = np.interp([-1, 50, 100, 250], acts.get_xdata(), acts.get_ydata())
    assert at == pytest.approx([0, 0.5, 1, 1], abs=0.03)  # it rises over 0.1 s
    stronger = with_values(weak.design, {"protocol.fold_torque": "5 N cm"})  # largest torque of the landscape
    least = energy_landscape(stronger, points=61).least_torques["fold"]
    assert drawn["least slow torque"].get_ydata()[0] == pytest.approx(100 * least, rel=0.02)
    assert least > 0.01


def test_without_a_sufficient_torque_the_figure_says_so(weak):
    figure = draw_angles(weak, measure(weak), 3.5, lambda: np.nan)
    output = [text.get_text() for axes in figure.axes if (key := axes.get_legend()) for text in key.get_texts()]
    notes = [text.get_text() for axes in figure.axes for text in axes.texts]
    assert "no slow torque up to\n10 N cm suffices" in notes
    assert "least slow torque" not in output


def test_the_figure_has_the_verdict_and_the_advice(weak, drawings):
    outcome = measure(weak)
    for kind in ("angles", "energy", "folding"):
        heading = drawings[kind](3.5).get_suptitle().replace("\n", " ")
        assert heading.lower() == f"{outcome.status}. {outcome.advice}".lower()


def test_a_run_that_reached_its_goals_is_drawn_from_stop_to_stop(reference_run, reference_outcome):
    assert stalled_stage(reference_run) is None
    assert needed_torque(reference_run) is None
    figure = run_drawings(reference_run, reference_outcome)["angles"](7.1)
    assert [axes.get_ylabel() for axes in figure.axes if axes.get_ylabel()] == ["distal angle (deg)"]
    assert not figure.get_suptitle()
