from itertools import pairwise

import numpy as np
import pytest

from forficula.analysis import measure
from forficula.design import load_design
from forficula.show.film.film_clock import film_cuts, last_sound_time, moment
from forficula.study.running.runs import run

SETTLE = [{"name": "settle", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "20 ms"}]


@pytest.fixture(scope="module")
def cuts(reference_run, reference_outcome):
    return film_cuts(reference_run, reference_outcome)


def test_a_film_holds_the_three_states_and_slows_down_the_two_moves_between_them(cuts, reference_outcome):
    held = {cut.words: cut.first for cut in cuts if cut.first == cut.last}
    assert held == {
        f"{letter} {name}": reference_outcome.states[name].time
        for letter, name in zip("abc", ("flat", "folded", "opened"), strict=True)
    }
    moves = [cut for cut in cuts if cut.slowed is not None]
    assert [cut.words for cut in moves] == ["fold", "unfold"]
    for cut in moves:
        assert 2.5 < cut.length < 5
        assert cut.length == pytest.approx(cut.slowed * (cut.last - cut.first))
        assert float(f"{cut.slowed:.1g}") == cut.slowed
    assert 8 < sum(cut.length for cut in cuts) < 14


def test_time_goes_on_all_through_a_film_and_no_part_of_a_move_is_left_out(cuts):
    times = [moment(cuts, time)[1] for time in np.linspace(0, sum(cut.length for cut in cuts), 500)]
    assert np.all(np.diff(times) >= 0)
    ends = [(cut.first, cut.last) for cut in cuts]
    assert all(after[0] == before[1] for before, after in pairwise(ends))
    assert moment(cuts, 0.0) == (cuts[0], cuts[0].first)
    assert moment(cuts, 1e3) == (cuts[-1], cuts[-1].last)


def test_when_a_move_ends_the_hinges_are_near_where_they_come_to_rest(cuts, reference_run):
    for cut, state in zip((cut for cut in cuts if cut.slowed), ("b folded", "c opened"), strict=True):
        rest = next(cut.first for cut in cuts if cut.words == state)
        before, now, then = (
            np.degrees(reference_run.angles("ring")[np.searchsorted(reference_run.time, time)])
            for time in (cut.first, cut.last, rest)
        )
        # this is 95 % of the motion, averaged with the turns of the veins
        assert abs(now - then).mean() < 0.1 * abs(then - before).mean()


def test_a_film_can_be_slowed_down_as_one_likes(reference_run, reference_outcome):
    moves = [cut for cut in film_cuts(reference_run, reference_outcome, slowed=10.0) if cut.slowed]
    assert [cut.slowed for cut in moves] == [10.0, 10.0]
    assert moves[0].length == pytest.approx(10 * (moves[0].last - moves[0].first))


def test_a_run_without_a_driven_stage_is_one_cut():
    record = run(load_design("binder2025", {"protocol.stages": SETTLE}))
    (cut,) = film_cuts(record, measure(record))
    assert (cut.words, cut.first, cut.last) == ("the whole run", 0.0, 0.02)


def test_a_wing_that_does_not_fold_is_not_called_folded():
    fold = {"name": "fold", "drive": "fold", "until": "folded", "hold": "0 s", "time_limit": "5 ms"}
    record = run(load_design("binder2025", {"protocol.stages": [*SETTLE, fold]}))
    assert [cut.words for cut in film_cuts(record, measure(record))] == ["a flat", "fold", "not folded"]


def test_a_run_that_diverges_is_shown_up_to_where_it_did():
    record = run(load_design("binder2025", {"protocol.timestep": "5 ms"}))
    assert record.diverged_at is not None
    cuts = film_cuts(record, measure(record))
    assert cuts[-1].last <= last_sound_time(record) < record.diverged_at
