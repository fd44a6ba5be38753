"""What it means that no sample meets two facts: shares with intervals, and when none says nothing."""

import numpy as np

from forficula.goals.identify.directed import directed_shares, misses, open_targets
from forficula.goals.identify.exclusion import Together, agreeing, best_subsets, pairs_of, smallest_unmet


def test_pairs_are_told_by_what_would_be_expected():
    # of 40 drawn samples 20 meet fact 0, the other 20 fact 1, 2 of the others fact 2; one placed meets 0 and 2
    met = np.zeros((41, 4), dtype=bool)
    met[:20, 0] = met[20:40, 1] = met[20:22, 2] = True
    met[40, [0, 2]] = True
    placed = np.arange(41) == 40
    found = {(pair.first, pair.second): pair for pair in pairs_of(met, placed)}
    assert found[0, 1].verdict is Together.EXCLUDED
    assert found[0, 1].expected == 10
    assert found[1, 2].verdict is Together.MET
    assert found[0, 2].verdict is Together.PLACED
    assert found[0, 3].verdict is Together.NEVER
    met[40] = False
    assert pairs_of(met, placed)[1].verdict is Together.RARE
    assert best_subsets(met) == [(1, 2)]


def test_the_smallest_sets_that_no_sample_meets_leave_out_what_follows_from_them():
    # any two of facts 0, 1 and 2, never all three; fact 3 never
    met = np.array([[1, 1, 0, 0], [0, 1, 1, 0], [1, 0, 1, 0]], dtype=bool)
    assert smallest_unmet(met) == [(3,), (0, 1, 2)]
    assert smallest_unmet(np.ones((1, 4), dtype=bool)) == []


def test_what_is_looked_for_is_what_no_sample_met():
    met = np.array([[1, 1, 0, 0], [0, 1, 1, 0], [0, 0, 0, 0]], dtype=bool)
    assert open_targets(met) == [(0, 1, 2, 3), (3,), (0, 2)]
    assert open_targets(np.ones((2, 3), dtype=bool)) == []


def test_placed_samples_stay_in_the_cube_and_gather_where_a_target_is_near():
    generator = np.random.default_rng(0)
    shares = generator.random((64, 3))
    # the facts are met at the corner where all shares are 1
    excess = 1 - shares[:, :2]
    for round_number in range(8):
        placed = directed_shares(shares, excess, [(0, 1)], 16, (0, round_number))
        assert ((placed >= 0) & (placed < 1)).all()
        shares, excess = np.vstack([shares, placed]), np.vstack([excess, 1 - placed[:, :2]])
    assert misses(excess, (0, 1))[-16:].mean() < 0.3 * misses(excess, (0, 1))[:64].mean()


def test_samples_that_could_not_run_are_infinitely_far():
    assert misses(np.array([[0.0, np.nan], [0.0, 0.0]]), (0, 1)).tolist() == [np.inf, 0]


def test_what_agrees_is_the_nearest_tenth_where_hardly_any_meets_everything():
    excess = np.linspace(0, 4, 50)[:, None] * [1, 1]
    met = excess == 0
    placed = np.arange(50) < 2
    assert np.flatnonzero(agreeing(met, excess, placed)).tolist() == [2, 3, 4, 5, 6]
    met[10:30] = True
    assert np.flatnonzero(agreeing(met, excess, placed)).tolist() == list(range(10, 30))
