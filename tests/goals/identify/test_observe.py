"""The requested runs suffice for a fact, and give the same value as all runs."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.design import load_design
from forficula.goals.identify import observations_of
from forficula.goals.identify.identify import Finding, find
from forficula.goals.identify.row_quantity import row_quantities
from forficula.goals.identify.sample_runs import SampleRuns
from forficula.goals.identify.staircase import FAILS, HOLDS, OPEN, follows, next_point
from forficula.goals.outcome_quantity import quantities_of
from tests.goals.identify.closed_form import TENDONS, assess, holding_torque

LEAST = {
    "name": "least",
    "quantity": "least value",
    "until": "fold",
    "over": {"tendon.stiffness": "10 N/cm", "tendon.rest_length": "0..9 cm step 1"},
    "least": {"key": "protocol.fold_torque", "values": "2..100 N cm step 2"},
    "equals": "20 N cm",
}
FOLDED = {"name": "folded", "quantity": "folded", "until": "fold", "over": TENDONS}


# below the smallest tried overbend
SETTINGS = {"protocol.initial_overbend": "0 deg"}


def observed_wing(overbend, fact):
    """One fact of the reference wing with an overbend."""
    unknown = {"hinge.overbend": [overbend]}
    return observations_of({"design": "binder2025", "settings": SETTINGS, "unknown": unknown, "fact": [fact]})


def observed(overbend="3 deg", rows=assess, **fact):
    """Result of a sample for a fact, and the conditions that were run for it."""
    requested = observed_wing(overbend, fact)
    runs, known, ran = SampleRuns(requested.base, {"hinge.overbend": overbend}), {}, []
    while not isinstance(result := find(requested.facts[0], runs, known), Finding):
        ran += result.values()
        known |= dict(zip(result, rows(list(result.values())), strict=True))
    return result, [run.values for run in ran]


def least_steps(overbend):
    """The first of 2, 4, .. 100 N cm that folds each of the paper's softest tendons, N m; 102 N cm if none does."""
    design = load_design("binder2025", {**SETTINGS, "hinge.overbend": overbend, "tendon.stiffness": "10 N/cm"})
    torques = [holding_torque(design.with_values({"tendon.rest_length": 0.01 * length})) for length in range(10)]
    return [next((step for step in 0.02 * np.arange(1, 51) if step >= torque), 1.02) for torque in torques]


@given(st.lists(st.integers(0, 10), min_size=6, max_size=6))
@settings(max_examples=60, deadline=None)
def test_a_staircase_is_found_by_its_boundary(firsts):
    # by stiffness, the shortest tendon that folds; longer and softer ones fold, too
    firsts = sorted(firsts)
    truth = np.array([[place >= first for place in range(10)] for first in firsts])
    known = np.full(truth.shape, OPEN, dtype=np.int8)
    states, requested = known, 0
    while (point := next_point(states, axes=[1], reversed_axes=[0])) is not None:
        known[point], requested = (HOLDS if truth[point] else FAILS), requested + 1
        states = follows(known, [1], [0])
    assert (states == np.where(truth, HOLDS, FAILS)).all()
    # a boundary across 6 by 10 has at most as many corners on each side as it has steps
    assert requested <= 17


@pytest.mark.parametrize("overbend", ["1 deg", "3 deg", "8 deg", "30 deg"])
def test_a_count_along_a_boundary_is_that_of_all_conditions(overbend):
    fact = {**FOLDED, "statistic": "count", "equals": 32, "settings": {"protocol.fold_torque": "50 N cm"}}
    everything, all_runs = observed(overbend, **fact)
    lazily, few = observed(overbend, **fact, rising=["tendon.rest_length"], falling=["tendon.stiffness"])
    assert len(all_runs) == 60
    assert len(few) <= 18
    assert lazily == everything


@pytest.mark.parametrize("overbend", ["1 deg", "3 deg", "8 deg"])
@pytest.mark.parametrize("statistic", ["least", "largest", "mean"])
def test_least_torques_by_bisection_equal_those_of_a_full_scan_and_bound_the_closed_form(overbend, statistic):
    tried, many = observed(overbend, **{**LEAST, "statistic": statistic})
    halved, few = observed(overbend, **{**LEAST, "statistic": statistic, "least": {**LEAST["least"], "monotone": True}})
    assert halved == tried
    # of fifty values a single one, or six bisections
    assert len(few) <= 7 * 10
    assert len(many) == sum(round(step / 0.02) for step in least_steps(overbend)) or statistic == "least"
    exact = {"least": min, "largest": max, "mean": np.mean}[statistic](least_steps(overbend))
    assert halved.value == pytest.approx(exact)


def test_only_conditions_that_may_have_the_least_torque_of_all_are_searched():
    _, everywhere = observed(**{**LEAST, "statistic": "largest", "least": {**LEAST["least"], "monotone": True}})
    _, where_it_may_be = observed(**{**LEAST, "statistic": "least", "least": {**LEAST["least"], "monotone": True}})
    assert len(where_it_may_be) < len(everywhere)


def test_least_torque_is_one_step_above_all_if_none_succeeds():
    least = {**LEAST["least"], "values": "1..3 N cm step 1"}
    result, _ = observed("8 deg", **{**LEAST, "least": least, "over": {"tendon.rest_length": "0..2 cm step 1"}})
    assert result.value == pytest.approx(0.04)
    assert result.distance == pytest.approx(0.16)


def test_deviation_of_a_position_is_the_difference_of_its_number_to_the_least():
    fact = {
        "name": "fastest",
        "quantity": "fold_time",
        "statistic": "least at",
        "until": "fold",
        "over": {"tendon.stiffness": ["10 N/cm", "40 N/cm"]},
        "settings": {"protocol.fold_torque": "500 N cm"},
        "absent": "1 s",
    }
    stiff, _ = observed(**fact, at={"tendon.stiffness": "40 N/cm"})
    assert stiff == Finding(value=0.0, miss=0.0, distance=0.0, met=True, conclusive=True, untold=0)
    soft, _ = observed(**fact, at={"tendon.stiffness": "10 N/cm"})
    # sqrt(I / (k a b)) of 4e-4 kg m^2 and 5.5 cm twice: 11.5 ms at 10 N/cm and half of it at 40, each doubled
    assert soft.distance == pytest.approx(11.5e-3, rel=1e-2)
    never, _ = observed(**{**fact, "settings": {"protocol.fold_torque": "0 N cm"}}, at={"tendon.stiffness": "10 N/cm"})
    assert (never.distance, never.met) == (1.0, False)


def test_two_statistics_can_be_compared():
    by_length = {
        "name": "long ones fold rather than short ones",
        "quantity": "folded",
        "statistic": "count",
        "until": "fold",
        "settings": {"protocol.fold_torque": "50 N cm"},
        "over": {"tendon.stiffness": TENDONS["tendon.stiffness"], "tendon.rest_length": "5..9 cm step 1"},
    }
    short = {"tendon.stiffness": TENDONS["tendon.stiffness"], "tendon.rest_length": "0..4 cm step 1"}
    held, _ = observed(**by_length, at_least={"over": short})
    assert held.met
    turned, _ = observed(**by_length, at_most={"over": short})
    design = load_design("binder2025")
    folds = [
        [
            holding_torque(design.with_values({"tendon.stiffness": 1e3 * k, "tendon.rest_length": 0.01 * length}))
            <= 0.5
            for length in range(10)
        ]
        for k in range(1, 7)
    ]
    assert turned.distance == np.sum(folds, axis=0)[5:].sum() - np.sum(folds, axis=0)[:5].sum()


def test_sums_of_quantities_and_runs_that_do_not_count():
    fact = {
        "name": "work a second",
        "quantity": "fold_work - 2 fold_work",
        "statistic": "largest",
        "until": "fold",
        "where": "folded",
        "over": {"tendon.rest_length": "0..9 cm step 1"},
        "settings": {"protocol.fold_torque": "30 N cm"},
        "absent": "7 J",
        "at_most": "0 J",
    }
    result, _ = observed(**fact)
    assert result.value == pytest.approx(-0.3 * np.radians(80))
    nothing, _ = observed("30 deg", **{**fact, "settings": {"protocol.fold_torque": "1 N cm"}})
    assert nothing.value == 7.0


def test_requested_runs_do_not_depend_on_other_known_rows():
    fact = {**FOLDED, "statistic": "count", "equals": 32, "settings": {"protocol.fold_torque": "50 N cm"}}
    fact |= {"rising": ["tendon.rest_length"], "falling": ["tendon.stiffness"]}

    def odd(runs):
        # an isolated short, stiff tendon folds, which contradicts any boundary
        rows = assess(runs)
        for run, row in zip(runs, rows, strict=True):
            row["folded"] |= (run.values["tendon.stiffness"], run.values["tendon.rest_length"]) == ("50 N/cm", "1 cm")
        return rows

    requested = observed_wing("3 deg", fact)
    runs = SampleRuns(requested.base, {"hinge.overbend": "3 deg"})
    lazily, ran = observed(rows=odd, **fact)
    conditions = [dict(zip(TENDONS, values, strict=True)) for values in itertools.product(
        [f"{k}0 N/cm" for k in range(1, 7)], [f"{length} cm" for length in range(10)])]  # fmt: skip
    every = [runs.at({**condition, "protocol.fold_torque": "50 N cm"}, "fold") for condition in conditions]
    known = dict(zip([run.key for run in every], odd(every), strict=True))
    assert find(requested.facts[0], runs, known) == lazily
    assert len(ran) < 60


def test_every_condition_is_run_if_the_far_corner_has_another_boundary():
    # the softest and longest tendons do not fold, as in the paper: a band folds, and no staircase
    def band(runs):
        rows = assess(runs)
        for run, row in zip(runs, rows, strict=True):
            soft = run.values["tendon.stiffness"] in ("10 N/cm", "20 N/cm", "30 N/cm")
            row["folded"] &= not (soft and run.values["tendon.rest_length"] == "9 cm")
        return rows

    fact = {**FOLDED, "statistic": "count", "equals": 32, "settings": {"protocol.fold_torque": "50 N cm"}}
    everything, _ = observed(rows=band, **fact)
    lazily, ran = observed(rows=band, **fact, rising=["tendon.rest_length"], falling=["tendon.stiffness"])
    assert lazily == everything
    assert len(ran) == 60


def test_row_quantities_have_the_names_of_goal_quantities():
    design = load_design("force-clasp")
    output = row_quantities(design)
    requested = {
        name for name, quantity in quantities_of(design).items() if quantity.source == "run" and quantity.unit.si
    }
    assert requested < set(output)
    # a state has its own name, and its numbers have one without spaces
    assert {"shut again", "shut_again_energy", "shut_again_angle"} <= set(output)
    row = {"shut again_stored_energy_J": 0.2, "shut again_angle_deg": 180.0, "shut again": True}
    assert output["shut_again_energy"].of(row) == 0.2
    assert output["shut_again_angle"].of(row) == pytest.approx(np.pi)
    assert output["shut again"].of(row) == 1
