"""A wing that is moved in its page as by a reader, in any browser."""

import json
import time

import numpy as np
import pytest

from forficula.analysis import measure
from forficula.design import load_design
from forficula.show.page import write_run_page
from forficula.show.structure.labels import driven_angles, shown_angles, shown_distances
from forficula.study.running.runs import run

SMALL = {"width": 200, "height": 200}  # pixels of a window that is drawn quickly
SECONDS = 60  # timeout of steps that take a few seconds, on a busy machine
_RELEASE = {"drive": "none", "until": "rest", "hold": "10 ms", "time_limit": "0.1 s"}
# the reference in half a second, at its own timestep: at twice that, opening while it swings may diverge
HALF_SECOND = {
    "protocol.window": "10 ms",
    "protocol.stages.0.time_limit": "20 ms",
    "protocol.stages.1.time_limit": "0.1 s",
    "protocol.stages.2": _RELEASE | {"name": "release folded"},
    # released sooner it would bounce off its stops and fold again
    "protocol.stages.3.hold": "0.1 s",
    "protocol.stages.3.time_limit": "0.2 s",
    "protocol.stages.4": _RELEASE | {"name": "release opened"},
}
# tolerances of a record's numbers: angles in deg, times in s, energies as shares of the largest
_ANGLE, _TIME, _ENERGY = 0.01, 1e-4, 1e-4
_BUTTON = "[...document.querySelectorAll('.trial button')].find((each) => each.textContent === {})"
_SAID = "document.querySelector('.verdict').textContent"
_SLIDE = """(([key, share]) => {
  const input = document.querySelector(`.slider[title^="${key}:"] input`);
  input.value = Math.round(share * input.max);
  input.dispatchEvent(new Event('input')); })"""


def shown_measures(structure):
    """Return the measures that a page shows: those of the structure, then driven angles that are not measured."""
    measured = shown_angles(structure)
    return (*measured, *shown_distances(structure), *driven_angles(structure, measured))


def write_wing(path, keys, name="binder2025"):
    """Write the page of a named design with other values of keys; returns its record and outcome."""
    record = run(load_design(name, keys))
    outcome = measure(record)
    write_run_page(record, outcome, path)
    return record, outcome


class LiveWing:
    """The open panel of a page, at its fastest; `evaluate` is that of a browser, for expressions of the page."""

    def __init__(self, evaluate):
        self.evaluate = evaluate
        evaluate("document.querySelector('button.try').click()")
        self.until("window.forficula.trial.panel !== null || window.forficula.trial.failed !== ''")
        assert evaluate("window.forficula.trial.failed") == ""
        pace = "document.querySelector('.trial select')"
        evaluate(f"{pace}.value = '1', {pace}.dispatchEvent(new Event('change'))")

    def until(self, expression):
        end = time.monotonic() + SECONDS
        while not self.evaluate(expression):
            assert time.monotonic() < end, f"never came: {expression}"
            time.sleep(0.05)

    def press(self, name):
        self.evaluate(f"{_BUTTON.format(json.dumps(name))}.click()")

    def do(self, name):
        """Press a button and wait for the outcome that the page reports."""
        self.press(name)
        self.until(f"{_SAID} !== ''")
        return self.evaluate(_SAID)

    def pace(self, value):
        """Set a multiple of real time, which the page's menu limits to 1: fewer frames are drawn."""
        self.evaluate(f"window.forficula.trial.panel.engine.send({{ act: 'pace', value: {value} }})")

    def rest(self):
        """Pause until the next command, so that nothing is drawn meanwhile."""
        self.evaluate("window.forficula.trial.panel.engine.send({ act: 'pause' })")

    def slide(self, shares=None):
        """Set sliders to shares of their ranges, by key, and reset the others to the run's values."""
        self.press("Reset all to this run")
        for key, share in (shares or {}).items():
            self.put(key, share)

    def put(self, key, share):
        self.evaluate(f"{_SLIDE}({json.dumps([key, share])})")

    @property
    def changes(self):
        return self.evaluate("window.forficula.trial.panel.sliders.changes")

    @property
    def ended(self):
        """Return the outcome of the stages since a button was pressed."""
        return self.evaluate("window.forficula.trial.panel.frame.ended")

    @property
    def angles(self):
        """Distal angles now, deg."""
        return np.degrees(self.evaluate("Array.from(window.forficula.trial.panel.frame.readings[0])"))


def check_as_recorded(outcome_of_page, record):
    """Check that stages, times, works, states and words of an outcome in a page are those of a record."""
    outcome = measure(record)
    assert outcome_of_page["status"] == outcome.status
    assert outcome_of_page["verdict"] == outcome.verdict
    assert [stage["name"] for stage in outcome_of_page["stages"]] == [end.stage.name for end in record.stages]
    for stage, end, item in zip(outcome_of_page["stages"], record.stages, outcome.stages, strict=True):
        assert stage["end_s"] == pytest.approx(end.end, abs=_TIME)
        assert (stage["goal_s"] is None) == (end.goal_time is None)
        assert stage["work_J"] == pytest.approx(item.work, rel=_ENERGY, abs=1e-9)
    states = record.structure.states
    assert [state["name"] for state in outcome_of_page["states"]] == [
        outcome.state_names[state.name] for state in states
    ]
    ends = {round(end.end, 9): number for number, end in enumerate(record.stages)}
    for state in filter(None, outcome.states.values()):
        stage = outcome_of_page["stages"][ends[round(state.time, 9)]]
        for values, shown in zip(stage["readings"], shown_measures(record.structure), strict=True):
            if shown.name in state.readings and shown.kind == "angle":
                assert np.degrees(values) == pytest.approx(np.degrees(state.readings[shown.name].mean), abs=_ANGLE)
        most = float(record.series["tendon_energy"].max(initial=0.0))
        assert stage["energies_J"] == pytest.approx(state.tendon_energy.tolist(), abs=_ENERGY * most)
