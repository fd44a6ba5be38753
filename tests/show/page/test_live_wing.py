"""A wing that is moved in its page, from a file without network, in Chromium and in Firefox."""

import functools
import os

import numpy as np
import psutil
import pytest

from forficula.analysis import measure
from forficula.design import with_values
from forficula.study.running.runs import run
from tests.show.page.conftest import watching
from tests.show.page.firefox import INSTALL, firefox_path, running
from tests.show.page.live_wing import SMALL, LiveWing, check_as_recorded, write_wing

SETTLE = {"name": "settle", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "4 ms"}
FOLD = {"name": "fold", "drive": "fold", "until": "folded", "hold": "0 s", "time_limit": "0.1 s"}
LEAK = 40e6  # bytes: half a megabyte per fold; memory not yet collected amounts to 25e6
# presses a button several times, each after the reply; returns the number of folds
AGAIN = """(async () => {
  const button = [...document.querySelectorAll(".trial button")].find((each) => each.textContent === "%(name)s");
  const verdict = document.querySelector(".verdict");
  let folds = 0;
  for (let count = 0; count < %(count)d; count++) {
    button.click();
    while (!verdict.textContent) await new Promise((done) => setTimeout(done, 5));
    folds += verdict.textContent.startsWith("The wing folded in ");
  }
  return folds; })()"""
# shares of the ranges of sliders, by key
SETTINGS_OF_SLIDERS = (
    {"tendon.stiffness": 0.74},
    {"tendon.rest_length": 0.2, "tendon.stiffness": 0.65},
    {"protocol.fold_torque": 0.065},
    {"protocol.unfold_torque": 0.1},
    {"membrane.youngs_modulus": 0.28, "hinge.damping": 0.7},
    {"protocol.gravity": 0.49, "tendon.damping": 0.5},
)


@pytest.fixture(scope="module", params=["Chromium", "Firefox"])
def show(request, tmp_path_factory):
    """Open a page in a window; returns a function that evaluates expressions, with messages and requests."""
    if request.param == "Chromium":
        with watching(request.getfixturevalue("context")) as watch:
            yield lambda path, width, height: watch(path, viewport={"width": width, "height": height})
        return
    program = firefox_path()
    if not program:
        missing = f"Firefox is missing; install it, as with: {INSTALL}, or name it in FORFICULA_FIREFOX"
        reason = f"{missing}: the simulator in a page is not tested in a second browser"
        if os.environ.get("FORFICULA_NEED_FIREFOX") == "1":
            pytest.fail(reason)
        pytest.skip(reason)
    with running(program, tmp_path_factory.mktemp("firefox") / "profile") as firefox:
        yield firefox.open


@pytest.fixture(scope="module")
def shown(show, recorded):
    return show(recorded[-1], **SMALL)


@pytest.fixture(scope="module")
def one_wing(shown):
    return LiveWing(shown.evaluate)


@pytest.fixture
def wing(one_wing):
    yield one_wing
    one_wing.rest()


def test_it_folds_at_a_press_to_the_angles_of_the_summary_and_opens_again(wing, recorded):
    outcome = recorded[1]
    wing.slide()
    assert wing.do("Start again") == "Settled."
    assert wing.do("Fold").startswith("The wing folded in ")
    folded = np.degrees(outcome.states["folded"].readings["distal_angle"].mean)
    assert wing.angles == pytest.approx(folded, abs=6)  # the fold still swings
    assert wing.do("Unfold").startswith("The wing opened again in ")
    opened = np.degrees(outcome.states["opened"].readings["distal_angle"].mean)
    assert wing.angles == pytest.approx(opened, abs=0.5)


@pytest.fixture(scope="module")
def simulated(recorded):
    """The package's record of a setting, which is the same for every browser."""
    return functools.cache(lambda changes: run(with_values(recorded[0].design, dict(changes))))


def test_sliders_give_the_outcomes_of_the_package(wing, simulated):
    verdicts = set()
    wing.pace(4)
    for shares in SETTINGS_OF_SLIDERS:
        wing.slide(shares)
        assert set(wing.changes) == set(shares)
        wing.rest()
        record = simulated(tuple(sorted(wing.changes.items())))
        said = wing.do("Whole protocol")
        check_as_recorded(wing.ended, record)
        status = measure(record).status
        assert ("opened again" if "and opened" in status else status) in said.lower()
        verdicts.add(wing.ended["verdict"])
    wing.pace(1)
    assert len(verdicts) > 2


def test_without_a_torque_it_sticks_and_says_what_to_try(wing):
    wing.slide({"protocol.fold_torque": 0})
    wing.do("Start again")
    # it swings longer than the settling stage lasts
    wing.until("window.forficula.trial.panel.frame.time_s > 0.3")
    assert wing.do("Fold") == "Did not fold."
    # advice on torques needs statics, which a page does not have
    assert "Raise" not in wing.evaluate("document.querySelector('.trial .note').textContent")
    assert wing.angles.min() > -5


@pytest.mark.usefixtures("one_wing")
def test_there_are_no_console_messages_and_no_requests(shown):
    assert shown.messages == []
    assert [url for url in shown.requests if not url.startswith(("file:", "data:", "blob:"))] == []


def test_a_structure_that_the_engine_cannot_simulate_is_reported_with_the_reason(show, tmp_path):
    keys = {"protocol.stages": [SETTLE], "protocol.timestep": "0.2 ms"}
    write_wing(tmp_path / "report.html", keys, "binder2025-built")
    page = show(tmp_path / "report.html", **SMALL)
    assert "it moves in air or water" in page.evaluate("document.querySelector('#try').textContent")


def test_memory_does_not_grow_over_a_hundred_folds(show, tmp_path, request):
    if request.node.callspec.params["show"] == "Firefox" and os.environ.get("FORFICULA_EVERY_BROWSER") != "1":
        pytest.skip("memory of Firefox is not looked at: that is make browsers, before a release")
    steps = {"protocol.timestep": "0.4 ms", "stops.time_constant": "2 ms"}
    write_wing(tmp_path / "report.html", steps | {"protocol.stages": [SETTLE, FOLD]})
    wing = LiveWing(show(tmp_path / "report.html", **SMALL).evaluate)
    wing.pace(16)
    held = []
    for count in (20, 80):
        assert wing.evaluate(AGAIN % {"count": count, "name": "Whole protocol"}) == count
        held.append(sum(map(resident, psutil.Process().children(recursive=True))))
    # control: the browser is among these processes
    assert held[0] > 50e6
    assert held[1] - held[0] < LEAK


def resident(process):
    """Return the memory of a process, bytes; 0 if it has ended."""
    try:
        return process.memory_info().rss
    except psutil.Error:
        return 0
