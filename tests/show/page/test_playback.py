import base64
import json
from dataclasses import replace

import numpy as np
import pytest

from forficula.analysis import measure, summary
from forficula.design import load_design
from forficula.show.page.data.shape_mesh import moving_points, shape_mesh
from forficula.show.page.playback import clip_data, legend_data, make_clip
from forficula.show.page.run_page import run_page
from forficula.structure import Table
from forficula.study.running.runs import run

MEGABYTE = 1_000_000


def unpacked(text, kind):
    return np.frombuffer(base64.b64decode(text), dtype=f"<{kind}")


@pytest.fixture(scope="module")
def data(short_run, short_outcome):
    """Return a clip as the page has it: converted to JSON and back."""
    return json.loads(json.dumps(clip_data(make_clip(short_run, short_outcome))))


def test_the_wing_between_the_frames_is_where_the_record_has_it_to_a_micrometre(data, short_run):
    time = unpacked(data["time"], "f8")
    points = unpacked(data["points"], "f4").reshape(len(time), -1)
    recorded = moving_points(short_run, shape_mesh(short_run.structure)).reshape(len(short_run.time), -1)
    drawn = np.stack([np.interp(short_run.time, time, column) for column in points.T], axis=1)
    assert np.abs(drawn - recorded).max() < 1e-6


def test_angles_and_energies_are_those_of_the_record(data, short_run):
    time = unpacked(data["time"], "f8")
    rows = np.searchsorted(short_run.time, time)
    assert np.array_equal(short_run.time[rows], time)
    readings = {item["name"]: item["values"] for item in data["readings"]}
    for values, expected in (
        (readings["distal_angle"], np.degrees(short_run.angles("ring"))),
        (readings["turn"], np.degrees(short_run.angles("turn"))),
        (data["tendonEnergy_J"], short_run.series["tendon_energy"]),
    ):
        shown = unpacked(values, "f4").reshape(len(time), -1)
        assert np.allclose(shown, expected[rows], rtol=1e-6, atol=1e-9)


def test_states_and_ends_of_stages_are_frames(data, short_run, short_outcome):
    time = set(unpacked(data["time"], "f8"))
    assert [mark["time"] for mark in data["marks"]] == [state.time for state in short_outcome.states.values()]
    assert [mark["name"] for mark in data["marks"]] == ["flat", "folded", "opened"]
    assert {end.end for end in short_run.stages} <= time


def test_a_budget_is_kept_and_the_states_with_it(short_run, short_outcome):
    clip = make_clip(short_run, short_outcome, budget=10_000)
    assert clip.points.size * 4 <= 10_000
    assert {mark.time for mark in clip.marks} <= set(clip.time)


def test_a_state_that_was_not_reached_is_not_called_by_its_name():
    stages = [
        {"name": "settle", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "10 ms"},
        {"name": "fold", "drive": "fold", "until": "folded", "hold": "0 s", "time_limit": "5 ms"},
    ]
    record = run(load_design("binder2025", {"protocol.stages": stages}))
    clip = make_clip(record, measure(record))
    assert [(mark.letter, mark.name) for mark in clip.marks] == [("a", "flat"), ("b", "after folding")]


def test_a_run_that_diverged_is_shown_up_to_where_its_hinges_pass_their_stops_by_a_turn_and_says_so():
    record = run(load_design("binder2025", {"protocol.timestep": "5 ms"}))
    # it ends before a hinge is 10 deg beyond its stop
    assert np.degrees(np.abs(record.angles("ring")).max()) < 190
    page = run_page(record, measure(record))
    assert "diverged at t = 0.035 s" in page
    assert "are not shown." not in page
    # the residual of a balance that does not close is not reported
    assert "The energy balance misses" not in page
    assert make_clip(record, measure(record)).time[-1] == record.time[-1]
    # versions of an earlier recording
    shown = len(record.time) // 2
    series = {name: values.copy() for name, values in record.series.items()}
    turn = record.structure.motors[0].hinges
    series["hinge_angle"][shown:, turn] = 7.0
    turned = replace(record, series=series)
    assert "in which a hinge is a full turn beyond its stops, are not shown." in run_page(turned, measure(turned))
    clip = make_clip(turned, measure(turned))
    assert clip.time[-1] == record.time[shown - 1]
    # 0 and 1 are within a turn, but follow meaningless rows
    series = {name: values.copy() for name, values in record.series.items()}
    series["hinge_angle"][1], series["hinge_angle"][2] = np.nan, np.inf
    broken = replace(record, series=series)
    assert len(make_clip(broken, measure(broken)).time) == 1
    assert "diverged" in run_page(broken, measure(broken))


def test_marks_have_the_angles_and_energies_that_the_summary_states(data, short_run, short_outcome):
    stated = summary(short_run, short_outcome, {})["states"]
    for mark in data["marks"]:
        state = stated[mark["name"]]
        assert mark["readings"]["distal_angle"]["mean"] == state["distal_angle_deg"]
        assert mark["tendonEnergy_J"] == state["tendon_energy_J"]
        swing = np.subtract(state["distal_angle_high_deg"], state["distal_angle_low_deg"]) / 2
        assert mark["readings"]["distal_angle"]["swing"] == pytest.approx(swing, abs=1e-9)


def test_five_seconds_of_a_wing_of_five_units_that_never_rests_take_less_than_five_megabytes(large_record):
    rows = 5001
    random = np.random.default_rng(0)
    series = {}
    for name, values in large_record.series.items():
        jitter = 1e-3 * random.normal(size=(rows, *values.shape[1:]))
        series[name] = values[:1] + jitter
    record = replace(large_record, time=np.linspace(0, 5, rows), series=series)
    assert len(run_page(record, measure(large_record)).encode()) < 5 * MEGABYTE


def test_gravity_is_an_arrow_and_a_level_table_the_grid_of_a_page(short_run, short_outcome):
    clip = make_clip(short_run, short_outcome)
    assert not {"gravity", "table_m"} & clip_data(clip).keys()
    heavy = replace(clip.structure, gravity=9.81, table=Table(height=-0.2, stops=clip.structure.stops))
    level, tilted = (
        clip_data(replace(clip, structure=replace(heavy, down=down))) for down in ((0.0, 0.0, -1.0), (1.0, 0.0, 0.0))
    )
    assert (level["gravity"], level["table_m"]) == ([0.0, 0.0, -1.0], -0.2)
    assert tilted["gravity"] == [1.0, 0.0, 0.0]
    assert "table_m" not in tilted
    samples = {entry["sample"] for entry in legend_data([replace(clip, structure=heavy)])}
    assert "gravity" in samples
