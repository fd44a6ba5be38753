"""Confirmation of a run by second runs of the same design that differ in numerical settings only."""

import json
import math
from dataclasses import replace

import jsonschema
import numpy as np
import pytest

import forficula as ff
from forficula.analysis import Ending, Verdict, measure, summary
from forficula.analysis.confirmation import (
    HALF_STEP,
    OTHER_START,
    confirm,
    confirmation_text,
    same_ending,
    uncertainties,
)
from forficula.cli import main
from forficula.design import with_values
from forficula.dynamics import NumericalCheck, load_record, save_record
from forficula.quantities import show_uncertain, uncertain_number
from forficula.results import json_schema
from forficula.study.running.evaluate import evaluate
from forficula.study.running.runs import run

JOINT = ff.load_design("binder2025-joint")


@pytest.fixture(scope="module")
def confirmed():
    return run(JOINT, confirm=True)


def check(timestep, **values):
    return NumericalCheck(
        name=HALF_STEP, timestep=timestep, verdict="reached", goal="", status="", holds={}, values=values
    )


def test_half_the_timestep_gives_the_whole_first_order_error():
    """For given values v(h) = v(0) + C h the uncertainty at h is C h, computed from h / 2 or from 2 h."""
    limit, slope, h = 3.0, 40.0, 1e-3
    value = {name: (limit + slope * step,) for name, step in (("own", h), ("half", h / 2), ("twice", 2 * h))}
    for other, step in (("half", h / 2), ("twice", 2 * h)):
        result = uncertainties({"x": value["own"]}, h, [check(step, x=value[other])])
        assert result["x"][0] == pytest.approx(slope * h, rel=1e-12)


def test_another_start_counts_once_and_a_time_is_known_to_a_timestep_at_best():
    start = replace(check(1e-3, **{"fold.time": (0.5,), "x": (2.0,)}), name=OTHER_START)
    result = uncertainties({"fold.time": (0.5,), "x": (2.5,)}, 1e-3, [start])
    assert (result["fold.time"], result["x"]) == ((1e-3,), (0.5,))


def test_values_missing_in_a_second_run_have_no_uncertainty():
    assert uncertainties({"fold.time": (0.5,)}, 1e-3, [check(5e-4)]) == {}


@pytest.mark.parametrize(
    ("half", "text"),
    [(4e-4, "58.4 ± 0.4 ms"), (1.6e-4, "58.40 ± 0.16 ms"), (3e-9, "58.4 ms"), (None, "58.4 ms"), (5.5e-3, "58 ± 6 ms")],
)
def test_an_uncertainty_is_shown_with_significant_digits_only(half, text):
    assert show_uncertain(58.4e-3, half, "s") == text


@pytest.mark.parametrize(
    ("value", "half", "text"),
    [
        (0.1827, 4e-4, "0.1827 ± 0.0004"),
        (0.548, 3e-4, "0.5480 ± 0.0003"),
        (0.1827, 4e-5, "0.1827"),
        (0.1827, 0.0, "0.1827"),
        (0.1827, math.nan, "0.1827"),
        (12.5, 3.0, "12 ± 3"),
        (4.11e-5, 6e-8, "4.110e-05 ± 6e-08"),
        (2.53e-7, 1.4e-10, "2.530e-07 ± 1e-10"),
        (0.0, 0.02, "0 ± 0.02"),
        (0.0, 0.0, "0"),
    ],
)
def test_an_uncertainty_that_the_four_digits_of_an_energy_do_not_show_is_left_out(value, half, text):
    assert uncertain_number(value, half) == text


def test_a_joint_is_confirmed_at_half_the_timestep_and_from_another_start(confirmed):
    outcome = measure(confirmed)
    assert outcome.verdict is Verdict.REACHED
    assert [item.name for item in outcome.confirmation.checks] == [HALF_STEP, OTHER_START]
    assert outcome.confirmation.agree
    assert 0 < outcome.confirmation.of("fold.time") < 0.01 * outcome.transitions["fold"].time
    assert outcome.confirmation.unsettled == ()


def test_the_run_itself_has_the_same_bits_whether_it_is_confirmed_or_not(confirmed):
    alone = run(JOINT)
    assert all((alone.series[name] == confirmed.series[name]).all() for name in alone.series)


def test_a_saved_run_keeps_its_confirmation(confirmed, tmp_path):
    save_record(confirmed, tmp_path / "record.nc")
    assert load_record(tmp_path / "record.nc").checks == confirmed.checks


@pytest.fixture(scope="module")
def by_hand():
    """Return the outcomes of the joint: as designed, at half the timestep, and from the other initial state."""
    half = with_values(JOINT, {"protocol.timestep": "0.05 ms"})
    return [measure(run(item)) for item in (JOINT, half, JOINT.with_other_start())]


@pytest.mark.parametrize(
    ("key", "unit", "attribute"),
    [
        ("tendon_length", "m", "tendon_length"),
        ("tendon_energy", "J", "tendon_energy"),
        ("membrane_energy", "J", "membrane_energy"),
    ],
)
def test_uncertainties_of_a_length_and_an_energy_are_differences_between_separate_runs(
    confirmed, by_hand, key, unit, attribute
):
    """Uncertainty: the larger of twice the difference at half the timestep and that from the other initial state."""
    states = summary(confirmed, measure(confirmed), {})["states"]
    for name in ("folded", "opened"):
        first, half, other = (np.array(getattr(item.states[name], attribute)) for item in by_hand)
        expected = np.maximum(2 * np.abs(first - half), np.abs(first - other))
        assert states[name][f"{key}_uncertainty_{unit}"] == pytest.approx(expected, rel=1e-9, abs=0)
    assert any(np.any(state["tendon_length_uncertainty_m"]) for state in states.values())


def test_a_summary_with_uncertainties_follows_its_schema_and_one_without_second_runs_has_none(confirmed):
    output = [
        summary(record, measure(record), {"forficula": ""}) for record in (confirmed, replace(confirmed, checks=()))
    ]
    for item in output:
        jsonschema.Draft202012Validator(json_schema("summary")).validate(json.loads(json.dumps(item)))
    with_runs, alone = (item["states"]["folded"] for item in output)
    assert "uncertainty" not in str(alone)
    assert {key: value for key, value in with_runs.items() if "_uncertainty_" not in key} == alone


def planted(first, half, h=1e-3):
    """Return the confirmation of a folded state by a run at half the timestep."""
    ending = Ending(verdict=Verdict.REACHED, transition=None)
    values, others = ({f"folded.{name}": item for name, item in run.items()} for run in (first, half))
    return confirm(ending, values, h, [check(h / 2, **others)])


def test_opposite_errors_of_two_tendons_cancel_in_the_energy_that_both_store():
    result = planted({"tendon.energy": (2.0, 3.0)}, {"tendon.energy": (2.1, 2.9)})
    assert result.of_state("folded", lambda values: values["tendon.energy"]) == pytest.approx([0.2, 0.2])
    assert result.of_state("folded", lambda values: values["tendon.energy"].sum()) == pytest.approx(0, abs=1e-12)


def test_the_smallest_of_many_angles_has_its_own_uncertainty_and_not_the_smallest_one():
    result = planted({"creases": (1.0, 2.0, 3.0)}, {"creases": (0.9, 2.0, 3.0)})
    assert result.of_state("folded", lambda values: values["creases"].min()) == pytest.approx(0.2)


def test_a_number_that_a_second_run_does_not_have_has_no_uncertainty():
    result = planted({"tendon.energy": (2.0,), "creases": (1.0,)}, {"creases": (1.1,)})
    assert result.of_state("folded", lambda values: values["tendon.energy"]) is None
    assert result.of_state("opened", lambda values: values["creases"]) is None
    assert result.of_state("folded", lambda values: values["creases"]) == pytest.approx([0.2])


def lost(record):
    """Return the record and a second one that did not stay open."""
    first, second = record.checks
    other = {"verdict": "not held", "status": "did not stay open", "holds": {**first.holds, "opened": False}}
    return replace(record, checks=(replace(first, **other), second))


def test_a_run_with_another_verdict_at_half_the_timestep_is_undecided_and_reports_both(confirmed):
    outcome = measure(lost(confirmed))
    assert outcome.verdict is Verdict.UNDECIDED
    assert outcome.status == "undecided: folded and opened at 0.1 ms, but did not stay open at half the timestep"
    assert outcome.holds == {"folded": True, "opened": None}
    assert outcome.transitions["fold"].succeeded
    assert (outcome.transitions["unfold"].succeeded, outcome.transitions["unfold"].time) == (False, None)
    assert "at a boundary" in outcome.advice


def test_a_wing_that_creeps_is_as_short_of_its_goal_as_one_that_is_stuck(confirmed):
    slow = measure(replace(confirmed, checks=())).ending
    stuck = replace(confirmed.checks[0], verdict="stuck")
    assert same_ending(replace(slow, verdict=Verdict.MOVING), stuck)
    assert not same_ending(slow, stuck)


def test_a_study_repeats_released_runs_and_reports_whether_the_verdict_changed():
    (row,) = evaluate([JOINT])
    assert (row["verdict"], row["confirmed"]) == ("reached", True)


def test_a_study_does_not_repeat_runs_that_fail_clearly():
    weak = with_values(JOINT, {"protocol.fold_torque": "1 N cm"})
    (row,) = evaluate([weak])
    assert row["verdict"] == "stuck"
    assert row["confirmed"] is None


@pytest.mark.usefixtures("undrawn")
def test_a_run_of_the_command_line_that_is_undecided_ends_with_status_3(monkeypatch, tmp_path, capsys, confirmed):
    monkeypatch.setattr("forficula.study.running.runs.run", lambda *_, **__: lost(confirmed))
    with pytest.raises(SystemExit) as stopped:
        main(["run", "binder2025-joint", "--out", str(tmp_path / "x"), "--no-engine"])
    assert stopped.value.code == 3
    assert "undecided: folded and opened at 0.1 ms" in capsys.readouterr().out


def test_the_search_of_a_timestep_is_not_called_a_confirmation(confirmed):
    outcome = measure(confirmed)
    (half, *_) = outcome.confirmation.checks
    searched = replace(outcome.confirmation, checks=(replace(half, name="80 µs instead of 40 µs"),))
    text = confirmation_text(outcome.ending, searched)
    assert text == "the search of the timestep found the same at 80 µs instead of 40 µs"
    assert confirmation_text(outcome.ending, outcome.confirmation).startswith("confirmed at half the timestep")
