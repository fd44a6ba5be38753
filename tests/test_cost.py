"""Estimates of what takes longer than ten seconds."""

import itertools

from forficula.commands.cost import CountEstimate, RunEstimate, write_survey_estimate
from forficula.design import StageSection, load_design
from forficula.structure import structure_of


def test_the_estimate_of_several_runs_side_by_side_is_for_the_first_of_them(capsys, monkeypatch):
    clock = iter([0.0, 0.0, 2.0])
    monkeypatch.setattr("forficula.commands.cost.monotonic", lambda: next(clock))
    estimate = RunEstimate(lambda *_: None, searches=False, several=True)
    for time in (0.0, 0.5):
        estimate("0 of 12 runs, fold", time, 6.5)
    assert capsys.readouterr().err.startswith(
        "estimate: about 24 s for the first runs, less if stages reach their goals"
    )


def test_only_simulated_stages_before_quasi_static_ones_are_estimated(capsys, monkeypatch):
    fold = StageSection(name="fold", drive="fold", until="time", time_limit="6.5 s")
    press = StageSection(name="press", drive="fold", until="time", time_limit="1000 s", motion="quasi-static")
    clock = iter([0.0, 0.0, 2.0, 0.0, 0.0, 2.0, 90.0])
    monkeypatch.setattr("forficula.commands.cost.monotonic", lambda: next(clock))
    estimate = RunEstimate(lambda *_: None, searches=False, stages=(fold, press))
    for time in (0.0, 0.5):
        estimate("fold", time, 1006.5)
    assert capsys.readouterr().err.startswith("estimate: at most 24 s for the simulated stages, less if stages reach")
    # statics took the time between the two reports, which does not scale with the rest of the simulated time
    estimate = RunEstimate(lambda *_: None, searches=False, stages=(press, fold))
    for stage, time in (("press", 0.1), ("press", 0.2), ("fold", 1000.1)):
        estimate(stage, time, 1006.5)
    reason = "the number of static steps of quasi-static stages is unknown"
    assert capsys.readouterr().err == f"estimate: none, because {reason}; 1.5 min so far\n"


def test_the_estimate_of_a_continued_study_counts_only_the_runs_of_now(capsys, monkeypatch):
    clock = iter([0.0, 0.0, 0.5, 2.0])
    monkeypatch.setattr("forficula.commands.cost.monotonic", lambda: next(clock))
    estimate = CountEstimate()
    # 900 runs were done before, and two take two seconds
    estimate.update(901, 1000)
    estimate.update(902, 1000)
    assert capsys.readouterr().err == "estimate: 1.6 min for 1000 runs\n"


def test_the_landscape_of_a_structure_is_estimated_from_the_time_of_its_steps_on_this_machine(capsys, monkeypatch):
    ticks = itertools.count()
    monkeypatch.setattr("forficula.statics.net.survey_cost.perf_counter", lambda: 1e-3 * next(ticks))
    write_survey_estimate(structure_of(load_design("bistable-clasp")))
    assert capsys.readouterr().err == "estimate: 4.6 s to 17 s for the static analysis\n"
    write_survey_estimate(structure_of(load_design("binder2025-joint")))
    assert capsys.readouterr().err == ""
    # 12 hinges on a table
    write_survey_estimate(structure_of(load_design("binder2025-on-table")))
    assert capsys.readouterr().err == "estimate: 58 s to 3.6 min for the static analysis\n"
