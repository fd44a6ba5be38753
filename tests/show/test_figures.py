import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from forficula.analysis import measure
from forficula.design import load_design
from forficula.dynamics import run
from forficula.show import draw_angles, draw_energies, draw_folding, draw_pattern

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


@pytest.mark.parametrize("name", ["reference", "settled", "not folded", "diverged"])
def test_every_run_can_be_drawn_whatever_the_wing_did(runs, name):
    record = runs[name]
    outcome = measure(record)
    for figure in (draw_angles(record, outcome), draw_energies(record), draw_folding(record, outcome)):
        assert np.unique(pixels(figure).reshape(-1, 3), axis=0).shape[0] > 10  # not blank


def test_every_axis_over_time_names_its_quantity_and_unit(runs):
    record = runs["reference"]
    for figure in (draw_angles(record, measure(record)), draw_energies(record)):
        for axes in figure.axes:
            if axes.get_subplotspec().is_first_col():
                assert axes.get_ylabel().endswith(("(deg)", "(J)"))
            if axes.get_subplotspec().is_last_row():
                assert axes.get_xlabel().endswith(("(s)", "(ms)"))


def test_the_three_states_are_marked_where_they_are(runs):
    record = runs["reference"]
    outcome = measure(record)
    axes = draw_angles(record, outcome).axes[0]
    marks = {text.get_text(): text.get_position() for text in axes.texts if text.get_text() in ("a", "b", "c")}
    expected = {"a": outcome.flat, "b": outcome.folded_state, "c": outcome.opened_state}
    assert {letter: place[0] for letter, place in marks.items()} == {
        letter: state.time for letter, state in expected.items()
    }


def test_a_wing_that_did_not_fold_has_no_mark_for_folded(runs):
    record = runs["not folded"]
    axes = draw_angles(record, measure(record)).axes[0]
    assert [text.get_text() for text in axes.texts if text.get_text() in ("a", "b", "c")] == ["a"]


@pytest.mark.parametrize("units", [1, 2, 5])
def test_the_pattern_shows_every_crease_and_tendon_of_a_fan(units):
    figure = draw_pattern(load_design("binder2025", {"pattern.units": units, "pattern.sector_angle": "12 deg"}))
    veins = 2 * units + 1
    # proximal, distal, ring, hub and outer edges, then the hub circle and the tendons
    edges = 2 * veins + 3 * (veins - 1)
    assert len(figure.axes[0].lines) == edges + 1 + veins
