"""Estimates of what takes longer than ten seconds."""

import itertools

from forficula.commands.cost import CountEstimate, RunEstimate, write_survey_estimate
from forficula.design import load_design
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


def test_the_estimate_of_a_continued_study_counts_only_the_runs_of_now(capsys, monkeypatch):
    clock = iter([0.0, 0.0, 0.5, 2.0])
    monkeypatch.setattr("forficula.commands.cost.monotonic", lambda: next(clock))
    estimate = CountEstimate()
    # 900 runs were done before, and two take two seconds
    estimate.update(901, 1000)
    estimate.update(902, 1000)
    assert capsys.readouterr().err == "estimate: 1.6 min for 1000 runs\n"


def test_the_landscape_of_a_net_is_estimated_from_the_time_of_its_steps_on_this_machine(capsys, monkeypatch):
    ticks = itertools.count()
    monkeypatch.setattr("forficula.statics.net.survey_cost.perf_counter", lambda: 1e-3 * next(ticks))
    write_survey_estimate(structure_of(load_design("bistable-clasp")))
    assert capsys.readouterr().err == "estimate: 4.6 s to 17 s for the static analysis\n"
    write_survey_estimate(structure_of(load_design("binder2025-joint")))
    assert capsys.readouterr().err == ""
