"""Progress of calls: one kind of report, shown only where somebody looks."""

import io
import sys
import types

import numpy as np
import pytest

import forficula as ff
from forficula.calls.journals import journal_folder, seed_of
from forficula.calls.progress import reporting, runs_done, simulated
from forficula.errors import InputError
from tests.letters import QUICK


@pytest.fixture(scope="module")
def design():
    return ff.load_design("letter-fold", QUICK)


def test_every_call_reports_the_same_kind_of_progress(design):
    reports = []
    factors = {"tendon.left.stiffness": ["0.4 N/cm", "0.5 N/cm"]}
    fact = {"name": "closes", "quantity": "closed", "until": "close"}
    sampling = {"samples": 2, "directed": 0}
    goal = {
        "name": "light",
        "design": "binder2025-joint",
        "simulate": False,
        "vary": {"tendon.rest_length": ["5 cm", "6 cm"]},
        "limits": {"hinge_holding_torque": ">= 1 N cm"},
        "objectives": {"mass": "least"},
    }
    calls = {
        "run": lambda: ff.run(design, reports.append, confirm=False),
        "landscape": lambda: ff.landscape("kresling-cell", progress=reports.append),
        "study": lambda: ff.sweep(design, factors, progress=reports.append),
        "converge": lambda: ff.converge(design, timesteps="0.5 0.25 ms", progress=reports.append),
        "assumptions": lambda: ff.assumptions(design, only=["timestep"], progress=reports.append),
        "tolerance": lambda: ff.tolerance(
            design, tolerances={"facet.thickness": "1 %"}, runs=8, progress=reports.append
        ),
        "identify": lambda: ff.identify(
            {"design": design, "unknown": factors, "fact": [fact], "sampling": sampling}, progress=reports.append
        ),
        "optimise": lambda: ff.optimise(goal, progress=reports.append),
    }
    for name, call in calls.items():
        reports.clear()
        call()
        assert reports, name
        assert {type(report) for report in reports} == {ff.Progress}
        assert all(report.task and str(report).startswith(report.task) for report in reports)


def test_nothing_is_shown_where_nobody_looks(design, capfd):
    ff.run(design, confirm=False)
    assert capfd.readouterr() == ("", "")


def test_a_terminal_shows_a_bar(monkeypatch):
    class Terminal(io.StringIO):
        def isatty(self):
            return True

    monkeypatch.setattr(sys, "stderr", terminal := Terminal())
    with reporting(None, simulated) as tell:
        tell("fold", 0.5, 1.0)
    assert "fold: 0.5 of at most 1 s" in terminal.getvalue()
    before = terminal.getvalue()
    with reporting(False, simulated) as tell:
        assert tell is None
    assert terminal.getvalue() == before


def test_a_notebook_shows_a_bar_that_disappears(monkeypatch):
    shown = []
    handle = types.SimpleNamespace(update=shown.append)
    shell = types.SimpleNamespace(kernel=object())
    notebook = types.ModuleType("IPython")
    notebook.get_ipython = lambda: shell
    display = types.ModuleType("IPython.display")
    display.HTML, display.display = str, lambda *_, **__: handle
    monkeypatch.setitem(sys.modules, "IPython", notebook)
    monkeypatch.setitem(sys.modules, "IPython.display", display)
    with reporting(None, runs_done) as tell:
        tell(1, 4, {})
        tell(2, 4, {})  # too soon for another one
    assert shown == ['<progress value="0.250"></progress> runs: 1 of at most 4 runs', ""]


def test_a_function_of_several_arguments_still_works_and_warns(design):
    seen = []
    with pytest.warns(DeprecationWarning, match="progress: functions get one argument, an ff.Progress"):
        ff.run(design, lambda stage, time, longest: seen.append((stage, time, longest)), confirm=False)
    assert {stage for stage, _, _ in seen} <= {stage.name for stage in design.protocol.stages}
    assert seen


def test_a_journal_without_a_folder_is_removed(design, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with journal_folder(None) as folder:
        assert folder.is_dir()
    assert not folder.exists()
    ff.sweep(design, {"tendon.left.stiffness": ["0.4 N/cm"]})
    assert list(tmp_path.iterdir()) == []


def test_a_seed_is_a_number_a_generator_or_nothing(design):
    assert seed_of(7, None) == 7
    assert seed_of(np.random.default_rng(1), None) == seed_of(np.random.default_rng(1), None)
    assert seed_of(None, None) != seed_of(None, None)
    with pytest.warns(DeprecationWarning, match="seed: use rng"):
        assert seed_of(0, 5) == 5
    with pytest.raises(InputError, match="seed: need either rng or seed, got both: rng = 1, seed = 2"):
        seed_of(1, 2)
    with pytest.raises(InputError, match="rng: need a whole number >= 0, got -1"):
        seed_of(-1, None)
    drawn = {"tendon.left.stiffness": {"distribution": "uniform", "low": "0.4 N/cm", "high": "0.5 N/cm"}}
    sampling = {"count": 4}
    one, other = (ff.new_study(design, drawn, rng=rng, sampling=sampling).points for rng in (1, np.int64(1)))
    assert one == other
    assert one != ff.new_study(design, drawn, sampling=sampling).points
