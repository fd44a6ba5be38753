"""Verdict if no sample meets two facts together: proportions with intervals, and cases without a verdict."""

from dataclasses import replace

import numpy as np
import pytest

from forficula.goals.binomial_interval import one_sided_upper_bound
from forficula.goals.identify.exclusion import (
    Evidence,
    Together,
    agreeing,
    best_subsets,
    conjunction,
    smallest_unmet,
    triples_of,
)
from forficula.goals.identify.identify import directed_shares, misses, open_targets


def evidence(met, conclusive=None, excess=None, targets=None):
    """Results of samples that are conclusive for all facts, and miss unmet ones by one scale."""
    return Evidence(
        met=met,
        conclusive=np.ones_like(met) if conclusive is None else conclusive,
        excess=np.where(met, 0.0, 1.0) if excess is None else excess,
        targets=[()] * len(met) if targets is None else targets,
    )


def halves(placed=()):
    """Of 40 drawn samples, 20 meet fact 0, the others fact 1, and 2 of these fact 2; placed samples follow."""
    met = np.zeros((40 + len(placed), 4), dtype=bool)
    met[:20, 0] = met[20:40, 1] = met[20:22, 2] = True
    return met, [()] * 40 + list(placed)


def test_facts_exclude_one_another_only_if_each_is_met_and_placed_samples_miss_both_together():
    met, targets = halves(placed=[(0, 1)])
    pair = conjunction((0, 1), evidence(met, targets=targets))
    assert pair.verdict is Together.EXCLUDED
    assert (pair.conclusive_count, pair.drawn, pair.alone, pair.tried) == (40, 0, (20, 20), 1)
    assert pair.independent == 10
    # none of 40: the Clopper-Pearson bound, without assuming independence of the facts
    assert pair.most == pytest.approx(1 - 0.05 ** (1 / 40))
    # no sample was placed, or samples were placed for other facts
    assert conjunction((0, 1), evidence(met[:40])).verdict is Together.UNTRIED
    assert conjunction((0, 1), evidence(met, targets=[*targets[:40], (0, 1, 2, 3)])).verdict is Together.UNTRIED
    # a placed sample meets both
    met[40, :2] = True
    assert conjunction((0, 1), evidence(met, targets=targets)).verdict is Together.PLACED


def test_rarely_met_facts_give_no_verdict_on_exclusion():
    met, targets = halves(placed=[(0, 2)])
    pair = conjunction((0, 2), evidence(met, targets=targets))
    assert pair.verdict is Together.RARE
    # of two samples that meet the rarer fact, none meets the other: at 95 %, up to 78 of 100 such samples may
    assert 1 - 0.05 ** (1 / 2) > 0.5
    assert conjunction((1, 2), evidence(met, targets=targets)).verdict is Together.MET
    assert conjunction((0, 3), evidence(met, targets=targets)).verdict is Together.NEVER
    assert best_subsets(met) == [(1, 2)]


def test_facts_that_values_between_the_samples_may_meet_do_not_exclude_one_another():
    met, targets = halves(placed=[(0, 1)])
    requested = []

    def open_between(facts):
        requested.append(facts)
        return True

    seen = replace(evidence(met, targets=targets), open_between=open_between)
    assert conjunction((0, 1), seen).verdict is Together.OPEN
    # emulators are not evaluated if samples are decisive
    assert conjunction((1, 2), seen).verdict is Together.MET
    assert requested == [(0, 1)]


def test_facts_that_one_sample_nearly_meets_do_not_exclude_one_another():
    met, targets = halves(placed=[(0, 1)])
    excess = np.where(met, 0.0, 1.0)
    excess[40] = [0.05, 0.08, 1.0, 1.0]
    pair = conjunction((0, 1), evidence(met, excess=excess, targets=targets))
    assert pair.near == pytest.approx(0.08)
    assert pair.verdict is Together.NEARLY


def test_inconclusive_samples_are_not_counted_and_widen_the_bound():
    met, targets = halves(placed=[(0, 1)])
    conclusive = np.ones_like(met)
    # 4 samples that meet fact 0 are inconclusive for fact 1; 4 that meet fact 1 are inconclusive for fact 3
    conclusive[:4, 1] = conclusive[20:24, 3] = False
    pair = conjunction((0, 1), evidence(met, conclusive=conclusive, targets=targets))
    assert (pair.conclusive_count, pair.alone) == (36, (16, 20))
    assert pair.most == pytest.approx(one_sided_upper_bound(4, 40))
    # a sample that certainly misses one fact does not meet both, whatever the other is
    assert conjunction((0, 3), evidence(met, conclusive=conclusive, targets=targets)).most == pytest.approx(
        one_sided_upper_bound(0, 40)
    )


def test_unmet_triples_of_facts_are_listed_with_the_number_of_placed_samples():
    met = np.repeat(np.array([[1, 1, 0], [0, 1, 1], [1, 0, 1]], dtype=bool), 6, axis=0)
    (three,) = triples_of(evidence(met))
    assert (three.facts, three.alone, three.verdict) == ((0, 1, 2), (12, 12, 12), Together.UNTRIED)
    tried = np.vstack([met, [[False] * 3]])
    (three,) = triples_of(evidence(tried, targets=[()] * 18 + [(0, 1, 2)]))
    assert (three.verdict, three.tried) == (Together.EXCLUDED, 1)


def test_smallest_unmet_sets_contain_no_larger_implied_sets():
    # any two of facts 0, 1 and 2 are met together, never all three; fact 3 is never met
    met = np.array([[1, 1, 0, 0], [0, 1, 1, 0], [1, 0, 1, 0]], dtype=bool)
    assert smallest_unmet(met) == [(3,), (0, 1, 2)]
    assert smallest_unmet(np.ones((1, 4), dtype=bool)) == []


def test_targets_are_sets_of_facts_that_no_sample_met():
    met = np.array([[1, 1, 0, 0], [0, 1, 1, 0], [0, 0, 0, 0]], dtype=bool)
    assert open_targets(met) == [(0, 1, 2, 3), (3,), (0, 2)]
    assert open_targets(np.ones((2, 3), dtype=bool)) == []
    # a triple whose pairs are met becomes a target when no smaller target is left
    assert open_targets(np.array([[1, 1, 0, 1], [0, 1, 1, 1], [1, 0, 1, 1]], dtype=bool)) == [(0, 1, 2, 3), (0, 1, 2)]


def test_placed_samples_stay_in_the_cube_and_concentrate_near_the_target():
    generator = np.random.default_rng(0)
    shares = generator.random((64, 3))
    # the facts are met at the corner where all coordinates are 1
    excess = 1 - shares[:, :2]
    for round_number in range(8):
        placed = directed_shares(shares, excess, [(0, 1)], 16, (0, round_number))
        assert ((placed >= 0) & (placed < 1)).all()
        shares, excess = np.vstack([shares, placed]), np.vstack([excess, 1 - placed[:, :2]])
    assert misses(excess, (0, 1))[-16:].mean() < 0.3 * misses(excess, (0, 1))[:64].mean()


def test_samples_that_could_not_run_have_infinite_distance():
    assert misses(np.array([[0.0, np.nan], [0.0, 0.0]]), (0, 1)).tolist() == [np.inf, 0]


def test_nearest_tenth_agrees_if_hardly_any_sample_meets_all_facts():
    excess = np.linspace(0, 4, 50)[:, None] * [1, 1]
    met = excess == 0
    placed = np.arange(50) < 2
    assert np.flatnonzero(agreeing(met, excess, placed)).tolist() == [2, 3, 4, 5, 6]
    met[10:30] = True
    assert np.flatnonzero(agreeing(met, excess, placed)).tolist() == list(range(10, 30))
