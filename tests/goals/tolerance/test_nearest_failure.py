import pytest

from forficula.goals.tolerance.nearest_failure import Answer, reaches


class Window:
    """A design that works between bounds in each direction, and counts its evaluations."""

    def __init__(self, bounds, beyond=Answer.FAILS):
        self.bounds, self.beyond, self.rounds, self.runs = bounds, beyond, 0, 0

    def __call__(self, moves):
        self.rounds += 1
        self.runs += len(moves)
        return [Answer.WORKS if distance < self.bounds[direction] else self.beyond for direction, distance in moves]


STEPS = (1, 2, 4, 8)


def test_nearest_failure_is_bracketed_by_bisection():
    bounds = [0.3, 1.7, 3.1, 7.9, 20]
    window = Window(bounds)
    result = reaches(window, 5, STEPS, halvings=5)
    for bound, reach, stretch in zip(bounds[:4], result, (1, 1, 2, 4), strict=False):
        assert reach.works <= bound <= reach.fails
        assert reach.fails - reach.works == pytest.approx(stretch / 2**5)
    assert (result[4].works, result[4].fails, result[4].why) == (8, None, Answer.WORKS)
    # all directions share their rounds
    assert window.rounds == 6
    assert window.runs == 5 * 4 + 4 * 5


def test_first_failing_step_counts_even_if_later_steps_work():
    def island(moves):
        return [Answer.FAILS if 1.5 < distance < 3 else Answer.WORKS for _, distance in moves]

    (reach,) = reaches(island, 1, STEPS, halvings=6)
    assert reach.works <= 1.5 <= reach.fails == pytest.approx(1.5, abs=2**-6)


def test_an_unreliable_run_is_no_failure():
    (reach,) = reaches(Window([2.5], beyond=Answer.UNKNOWN), 1, STEPS, halvings=3)
    assert reach.fails is None
    assert (reach.why, reach.works, reach.beyond) == (Answer.UNKNOWN, 2.25, 2.5)


def test_limit_of_buildable_designs_is_not_searched():
    window = Window([2.5], beyond=Answer.OUTSIDE)
    (reach,) = reaches(window, 1, STEPS, halvings=3)
    assert (reach.why, reach.works, reach.beyond, reach.fails) == (Answer.OUTSIDE, 2, 4, None)
    assert window.rounds == 1


def test_no_bisection_if_all_steps_work():
    window = Window([9, 9])
    reaches(window, 2, STEPS, halvings=4)
    assert (window.rounds, window.runs) == (1, 8)


def test_without_steps_nothing_is_known():
    assert reaches(Window([9]), 1, (), halvings=4)[0].works == 0
