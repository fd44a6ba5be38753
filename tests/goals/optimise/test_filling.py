"""A search that ends before it uses results says so."""

import pytest

from forficula.goals import goal_of
from forficula.goals.optimise import optimise_goal
from forficula.goals.optimise.parabola_search import ParabolaSearch
from forficula.goals.optimise.summary import filling_count, filling_text, summary_sentences
from forficula.goals.optimise.trials import Axis, Trial

AREA = {"tendon.area": {"low": "1 mm^2", "high": "9 mm^2"}}


def goal(vary=AREA, **search):
    return goal_of(
        {
            "name": "held",
            "design": "binder2025-joint",
            "simulate": False,
            "vary": vary,
            "limits": {"hinge_holding_torque": ">= 8 N cm"},
            "objectives": {"mass": "least"},
            "search": search,
        }
    )


def points(axes, batch, count, sign):
    """The first points of a search that minimises, or maximises, the first coordinate."""
    search, result = ParabolaSearch(axes, 1, batch, 0), []
    while len(result) < count:
        requested = search.ask()
        search.tell([Trial(point=item, objectives=(sign * item[0],)) for item in requested])
        result += requested
    return result[:count]


@pytest.mark.parametrize(("axes", "batch"), [(1, 4), (2, 16), (9, 16), (12, 32), (2, 64)])
def test_the_search_uses_results_only_after_filling_the_space(axes, batch):
    sides = [Axis() for _ in range(axes)]
    count = filling_count(sides, batch)
    low, high = (points(sides, batch, count + batch, sign) for sign in (1, -1))
    assert low[:count] == high[:count]
    assert low[count:] != high[count:]


def test_a_search_that_ends_before_it_uses_results_says_so(tmp_path):
    few = goal(runs=16, batch=16)
    said = "all 16 designs only fill the space evenly: the search begins to use results after 32"
    assert filling_text(few).startswith(said)
    assert summary_sentences(optimise_goal(few, tmp_path))[-1].startswith(said)
    assert filling_text(goal(runs=32, batch=8)) is not None
    assert filling_text(goal(runs=33, batch=8)) is None


def test_a_search_that_tries_all_designs_has_no_such_remark():
    assert filling_text(goal(vary={"tendon.area": ["4 mm^2", "5 mm^2", "6 mm^2"]}, runs=16, batch=4)) is None
