"""Which facts exclude one another, as far as samples tell, and what it means that none meets them together."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from forficula.arrays import Array, Indices
from forficula.goals.share_interval import largest_share

Mask = NDArray[np.bool_]

# of the samples that meet the rarer of some facts: where none meets the others, at most this share of all such may, at
# 95 %, or they are too few to tell
_RARE = 0.5
# of the facts' scales: where some sample misses none of them by more, they do not exclude one another
_NEAR = 0.1


class Together(StrEnum):
    """What samples say of some facts."""

    MET = "met together"
    PLACED = "met together where placed"  # by no sample that was drawn, and by one that was placed
    NEARLY = "nearly met together"  # by none, but one misses them by little
    OPEN = "open between samples"  # by none, but samples lie too far apart to exclude values between them
    EXCLUDED = "exclude one another"  # by none of those that tell, and by none that was placed to
    UNTRIED = "met by none, not tried"  # by none, but none was placed to meet them either
    RARE = "too rare to tell"  # by none, but hardly one meets the rarer one
    NEVER = "one is never met"


@dataclass(frozen=True, kw_only=True)
class Evidence:
    """What samples that ran say of all facts.

    Attributes:
        met: whether each sample met each fact for certain, (samples, facts).
        tells: whether it met or missed each for certain, (samples, facts).
        excess: by how much it misses each beyond its tolerance, in units of the fact's scale, (samples, facts).
        targets: of each sample the facts that it was placed to meet together; none where it was drawn from the priors.
        open_between: whether some facts may be met together by values between the samples, as far as emulators of the
            facts allow to say.
    """

    met: Mask
    tells: Mask
    excess: Array
    targets: Sequence[tuple[int, ...]]
    open_between: Callable[[tuple[int, ...]], bool] = lambda _: False

    @property
    def placed(self) -> Mask:
        """Which samples were placed, and not drawn from the priors, (samples,)."""
        return np.array([bool(target) for target in self.targets], dtype=bool)


@dataclass(frozen=True, kw_only=True)
class Conjunction:
    """Some facts and how far they are met together.

    Attributes:
        facts: their numbers, rising.
        told: how many of the drawn samples tell of all of them.
        drawn: how many of these meet all.
        alone: how many of these meet each, in the order of the facts.
        placed: how many of the placed samples meet all.
        tried: how many samples were placed to meet just these.
        near: the least over all samples of the most by which one of the facts is missed, in units of its scale.
        most: largest share of the priors that may meet all, at a one-sided 95 % (Clopper and Pearson): samples that do
            not tell are taken to meet them.
        verdict: what follows.
    """

    facts: tuple[int, ...]
    told: int
    drawn: int
    alone: tuple[int, ...]
    placed: int
    tried: int
    near: float
    most: float
    verdict: Together

    @property
    def independent(self) -> float:
        """How many of the samples that tell would meet all if each fact were met regardless of the others."""
        return float(np.prod([each / max(self.told, 1) for each in self.alone]) * self.told)


def conjunction(facts: Sequence[int], seen: Evidence) -> Conjunction:
    """What samples say of some facts together.

    Args:
        facts: their numbers.
        seen: by all samples that ran.
    """
    chosen, placed = list(facts), seen.placed
    met, tells = seen.met[:, chosen], seen.tells[:, chosen]
    whole, told = met.all(axis=1), tells.all(axis=1)
    # one that is missed for certain settles it, whatever the others are
    open_ = ~told & ~(tells & ~met).any(axis=1)
    drawn, alone = int((whole & told & ~placed).sum()), met[told & ~placed].sum(axis=0)
    later, tried = int((whole & placed).sum()), sum(tuple(facts) == tuple(target) for target in seen.targets)
    near = float(seen.excess[:, chosen].max(axis=1).min(initial=np.inf))
    verdict = _verdict(drawn, later, tried, near, alone if met.any(axis=0).all() else None)
    if verdict is Together.EXCLUDED and seen.open_between(tuple(facts)):
        verdict = Together.OPEN
    return Conjunction(
        facts=tuple(facts),
        told=int((told & ~placed).sum()),
        drawn=drawn,
        alone=tuple(int(each) for each in alone),
        placed=later,
        tried=tried,
        near=near,
        most=largest_share(drawn + int((open_ & ~placed).sum()), int((~placed).sum())),
        verdict=verdict,
    )


def _verdict(drawn: int, placed: int, tried: int, near: float, alone: Indices | None) -> Together:
    """What follows; `alone` is None where one of the facts is never met."""
    if drawn:
        return Together.MET
    if placed:
        return Together.PLACED
    if alone is None:
        return Together.NEVER
    if near <= _NEAR:
        return Together.NEARLY
    if largest_share(0, int(alone.min())) > _RARE:
        return Together.RARE
    return Together.EXCLUDED if tried else Together.UNTRIED


def pairs_of(seen: Evidence) -> list[Conjunction]:
    """All pairs of facts."""
    return [conjunction(pair, seen) for pair in itertools.combinations(range(seen.met.shape[1]), 2)]


def triples_of(seen: Evidence) -> list[Conjunction]:
    """Every three facts that no sample meets together, though any two of them are met by some."""
    return [conjunction(facts, seen) for facts in smallest_unmet(seen.met, 3) if len(facts) == 3]


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
