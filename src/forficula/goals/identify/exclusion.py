"""Facts that exclude one another according to samples, and the verdict if no sample meets them together."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from forficula.arrays import Array, Indices
from forficula.goals.binomial_interval import one_sided_upper_bound

Mask = NDArray[np.bool_]

# Of the samples that meet the rarer of some facts, at most this fraction may meet the others, at 95 %, if none was
# found. Otherwise there are too few samples for a verdict.
_RARE = 0.5
# in scales of the facts: if some sample misses none of them by more, they do not exclude one another
_NEAR = 0.1


class Together(StrEnum):
    """Verdict on some facts together."""

    MET = "met together"
    PLACED = "met together where placed"  # by a placed sample, but by no drawn one
    NEARLY = "nearly met together"  # by none, but one misses them by little
    OPEN = "open between samples"  # by none, but samples are too far apart to exclude values between them
    EXCLUDED = "exclude one another"  # by no conclusive sample, although some were placed to meet them
    UNTRIED = "met by none, not tried"  # by none, but none was placed to meet them
    RARE = "too rare to tell"  # by none, but hardly any sample meets the rarer fact
    NEVER = "one is never met"


@dataclass(frozen=True, kw_only=True)
class Evidence:
    """Results of samples for all facts.

    Attributes:
        met: whether each sample certainly met each fact, (samples, facts).
        conclusive: whether each sample certainly met or missed each fact, (samples, facts).
        excess: deviation beyond the fact's tolerance, in units of the fact's scale, (samples, facts).
        targets: for each sample, the facts that it was placed to meet together; empty if it was drawn from the priors.
        open_between: whether values between the samples may meet some facts together, according to emulators.
    """

    met: Mask
    conclusive: Mask
    excess: Array
    targets: Sequence[tuple[int, ...]]
    open_between: Callable[[tuple[int, ...]], bool] = lambda _: False

    @property
    def placed(self) -> Mask:
        """Which samples were placed, not drawn from the priors, (samples,)."""
        return np.array([bool(target) for target in self.targets], dtype=bool)


@dataclass(frozen=True, kw_only=True)
class Conjunction:
    """Some facts, and how far they are met together.

    Attributes:
        facts: their indices, rising.
        conclusive_count: number of drawn samples that are conclusive for all of them.
        drawn: number of these that meet all facts.
        alone: number of these that meet each fact, in the order of the facts.
        placed: number of placed samples that meet all facts.
        tried: number of samples that were placed to meet exactly these facts.
        near: smallest deviation of any sample, in units of the facts' scales; the deviation of a sample is its largest
            one.
        most: largest fraction of the priors that may meet all facts, at a one-sided 95 % (Clopper and Pearson);
            inconclusive samples count as meeting them.
        verdict: on these facts together.
    """

    facts: tuple[int, ...]
    conclusive_count: int
    drawn: int
    alone: tuple[int, ...]
    placed: int
    tried: int
    near: float
    most: float
    verdict: Together

    @property
    def independent(self) -> float:
        """Expected number of conclusive samples that meet all facts if the facts were independent."""
        return float(np.prod([count / max(self.conclusive_count, 1) for count in self.alone]) * self.conclusive_count)


def conjunction(facts: Sequence[int], seen: Evidence) -> Conjunction:
    """Evaluate samples for some facts together.

    Args:
        facts: their indices.
        seen: results of all samples that ran.
    """
    chosen, placed = list(facts), seen.placed
    met, conclusive = seen.met[:, chosen], seen.conclusive[:, chosen]
    all_met, all_conclusive = met.all(axis=1), conclusive.all(axis=1)
    # a fact that is certainly missed is decisive, whatever the other facts are
    open_ = ~all_conclusive & ~(conclusive & ~met).any(axis=1)
    drawn, alone = int((all_met & all_conclusive & ~placed).sum()), met[all_conclusive & ~placed].sum(axis=0)
    later, tried = int((all_met & placed).sum()), sum(tuple(facts) == tuple(target) for target in seen.targets)
    near = float(seen.excess[:, chosen].max(axis=1).min(initial=np.inf))
    verdict = _verdict(drawn, later, tried, near, alone if met.any(axis=0).all() else None)
    if verdict is Together.EXCLUDED and seen.open_between(tuple(facts)):
        verdict = Together.OPEN
    return Conjunction(
        facts=tuple(facts),
        conclusive_count=int((all_conclusive & ~placed).sum()),
        drawn=drawn,
        alone=tuple(int(count) for count in alone),
        placed=later,
        tried=tried,
        near=near,
        most=one_sided_upper_bound(drawn + int((open_ & ~placed).sum()), int((~placed).sum())),
        verdict=verdict,
    )


def _verdict(drawn: int, placed: int, tried: int, near: float, alone: Indices | None) -> Together:
    """Return the verdict; `alone` is None if one of the facts is never met."""
    if drawn:
        return Together.MET
    if placed:
        return Together.PLACED
    if alone is None:
        return Together.NEVER
    if near <= _NEAR:
        return Together.NEARLY
    if one_sided_upper_bound(0, int(alone.min())) > _RARE:
        return Together.RARE
    return Together.EXCLUDED if tried else Together.UNTRIED


def pairs_of(seen: Evidence) -> list[Conjunction]:
    """Return all pairs of facts."""
    return [conjunction(pair, seen) for pair in itertools.combinations(range(seen.met.shape[1]), 2)]


def triples_of(seen: Evidence) -> list[Conjunction]:
    """Return all triples of facts that no sample meets together, although each pair of them is met by some sample."""
    return [conjunction(facts, seen) for facts in smallest_unmet(seen.met, 3) if len(facts) == 3]


def best_subsets(met: Mask) -> list[tuple[int, ...]]:
    """Return the largest sets of facts that one sample meets, without repetition, in the order of the samples."""
    counts = met.sum(axis=1)
    most = counts.max(initial=0)
    subsets = [tuple(np.flatnonzero(row).tolist()) for row, count in zip(met, counts, strict=True) if count == most]
    return list(dict.fromkeys(subsets)) if most else []


def smallest_unmet(met: Mask, most: int = 3) -> list[tuple[int, ...]]:
    """Return the smallest sets of facts that no sample meets together, although some sample meets every part of them.

    Args:
        met: whether each sample met each fact, (samples, facts).
        most: largest number of facts in a set.
    """
    unmet: list[tuple[int, ...]] = []
    for size in range(1, most + 1):
        for facts in itertools.combinations(range(met.shape[1]), size):
            if not met[:, facts].all(axis=1).any() and not any(set(smaller) <= set(facts) for smaller in unmet):
                unmet.append(facts)
    return unmet


def agreeing(met: Mask, excess: Array, placed: Mask, share: float = 0.1) -> Mask:
    """Return the drawn samples that agree: those that meet every fact, or the nearest ones if hardly any does.

    This is rejection, the simplest approximate Bayesian computation (Beaumont, Zhang and Balding 2002): samples within
    a distance are accepted, and the distance is chosen such that a fraction of the samples is accepted.

    Args:
        met: whether each sample met each fact, (samples, facts), for samples that ran.
        excess: deviation from each fact, in units of its scale, (samples, facts).
        placed: which samples were placed. They are excluded because they are not drawn from the priors.
        share: fraction of the drawn samples that is accepted if fewer meet all facts.
    """
    wanted = max(1, round(share * int((~placed).sum())))
    whole = met.all(axis=1) & ~placed
    if whole.sum() >= wanted:
        return whole
    # sorted by the number of met facts, then by the deviation from the others
    missing = (excess / (1 + excess)).sum(axis=1)
    rank = np.where(placed, np.inf, missing)
    nearest = np.zeros(len(met), dtype=bool)
    nearest[np.argsort(rank, kind="stable")[:wanted]] = True
    return nearest & ~placed
