import pytest

from forficula.goals.tolerance.plan import PLANS, plan_within


def test_five_minutes_suffice_for_indices_of_25_tolerances():
    """64 designs of the reference wing take about 5 s on two cores."""
    plan = plan_within(25, 5 / 64, 300)
    assert plan is PLANS[0]
    assert plan.most_runs(25) * 5 / 64 < 300


@pytest.mark.parametrize("factors", [1, 9, 25, 60])
def test_less_time_gives_plans_with_fewer_runs(factors):
    runs = [plan.most_runs(factors) for plan in PLANS]
    assert runs == sorted(runs, reverse=True)
    assert len(set(runs)) == len(runs)


@pytest.mark.parametrize("seconds", [0.1, 1, 5, 17])
def test_a_plan_takes_no_longer_than_it_may(seconds):
    plan = plan_within(12, seconds, 300)
    assert plan.most_runs(12) * seconds <= 300 or plan is PLANS[-1]


def test_screened_points_and_rows_of_plans_are_among_their_points():
    for plan in PLANS:
        assert plan.screened <= plan.rows <= plan.points
        assert all(number & (number - 1) == 0 for number in (plan.points, plan.rows, plan.screened))


def test_few_factors_have_indices_of_their_own_without_screening():
    plan = PLANS[0]
    assert not plan.screens(plan.kept)
    assert not plan.screens(plan.kept + 1)
    assert plan.screens(plan.kept + 2)
