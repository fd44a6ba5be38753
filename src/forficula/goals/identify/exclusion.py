"""Which facts exclude one another, as far as samples tell, and what it means that none meets them together."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from forficula.goals.share_interval import largest_share

Mask = NDArray[np.bool_]
Array = NDArray[np.float64]

# what would be expected of two facts that have nothing to do with one another: with so many, a chance of 5 % that none
# comes
_ENOUGH = 3.0


class Together(StrEnum):
    """What samples say of two facts."""

    MET = "met together"
    PLACED = "met together where placed"  # by no sample that was drawn, and by one that was placed
    EXCLUDED = "exclude one another"  # no sample, though of two that do not mind one another some would be expected
    RARE = "too rare to tell"  # no sample, and hardly one would be expected
    NEVER = "one is never met"


@dataclass(frozen=True, kw_only=True)
class Pair:
    """Two facts and how far they are met together.

    Attributes:
        first: number of a fact.
        second: number of another, larger.
        drawn: how many of the drawn samples meet both.
        placed: how many of the placed ones do.
        expected: how many of the drawn ones would, did the one not mind the other.
        most: largest share of the priors that may meet both, at a one-sided 95 %.
        verdict: what follows.
    """

    first: int
    second: int
    drawn: int
    placed: int
    expected: float
    most: float
    verdict: Together


def pairs_of(met: Mask, placed: Mask) -> list[Pair]:
    """All pairs of facts.

    Args:
        met: whether each sample met each fact, (samples, facts); of samples that ran.
        placed: which samples were placed, and not drawn from the priors, (samples,).
    """
    drawn, found = met[~placed], []
    counts = drawn.sum(axis=0)
    for one, other in itertools.combinations(range(met.shape[1]), 2):
        both = int((drawn[:, one] & drawn[:, other]).sum())
        later = int((met[placed, one] & met[placed, other]).sum())
        expected = float(counts[one] * counts[other] / max(len(drawn), 1))
        found.append(
            Pair(
                first=one,
                second=other,
                drawn=both,
                placed=later,
                expected=expected,
                most=largest_share(both, len(drawn)),
                verdict=_verdict(both, later, expected, bool(met[:, one].any() and met[:, other].any())),
            )
        )
    return found


def _verdict(both: int, later: int, expected: float, each_met: bool) -> Together:
    if both:
        return Together.MET
    if later:
        return Together.PLACED
    if not each_met:
        return Together.NEVER
    return Together.EXCLUDED if expected >= _ENOUGH else Together.RARE


def best_subsets(met: Mask) -> list[tuple[int, ...]]:
    """The largest sets of facts that one sample meets, each once, in the order of the samples that meet them first."""
    counts = met.sum(axis=1)
    most = counts.max(initial=0)
    found = [tuple(np.flatnonzero(row).tolist()) for row, count in zip(met, counts, strict=True) if count == most]
    return list(dict.fromkeys(found)) if most else []


def smallest_unmet(met: Mask, most: int = 3) -> list[tuple[int, ...]]:
    """The smallest sets of facts that no sample meets together, though every part of them is met by some.

    Args:
        met: whether each sample met each fact, (samples, facts).
        most: facts of a set.
    """
    found: list[tuple[int, ...]] = []
    for size in range(1, most + 1):
        for facts in itertools.combinations(range(met.shape[1]), size):
            if not met[:, facts].all(axis=1).any() and not any(set(each) <= set(facts) for each in found):
                found.append(facts)
    return found


def agreeing(met: Mask, excess: Array, placed: Mask, share: float = 0.1) -> Mask:
    """The drawn samples that agree: those that meet every fact, or the nearest where hardly any does.

    That is rejection, the plainest approximate Bayesian computation (Beaumont, Zhang and Balding 2002): what lies
    within some distance is taken for what agrees, and the distance is such that a share of the samples lies within.

    Args:
        met: whether each sample met each fact, (samples, facts); of samples that ran.
        excess: by how much each misses each fact, in units of its scale, (samples, facts).
        placed: which samples were placed: they are not drawn from the priors, and tell nothing of how likely values
            are.
        share: of the drawn samples that are taken where fewer meet all facts.
    """
    wanted = max(1, round(share * int((~placed).sum())))
    whole = met.all(axis=1) & ~placed
    if whole.sum() >= wanted:
        return whole
    # facts met first, then how far the others are
    missing = (excess / (1 + excess)).sum(axis=1)
    rank = np.where(placed, np.inf, missing)
    nearest = np.zeros(len(met), dtype=bool)
    nearest[np.argsort(rank, kind="stable")[:wanted]] = True
    return nearest & ~placed
