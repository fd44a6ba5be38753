"""Result of a tolerance analysis: probability of working, and which tolerances matter most."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.arrays import Flags
from forficula.goals.tolerance.indices import Indices, Values, enough_for_linear_fit
from forficula.goals.tolerance.narrowing import Narrowed
from forficula.goals.tolerance.nearest_failure import Answer, Reach
from forficula.goals.tolerance.plan import Plan
from forficula.goals.tolerance.probability import Probability, probability
from forficula.goals.tolerance.question import Question
from forficula.goals.tolerance.samples import Samples, fact_names
from forficula.goals.tolerance.screening import Screening

# number of factors that are displayed; linear indices exist for every factor
_MOST_SHOWN = 10


@dataclass(frozen=True, kw_only=True)
class NearestFailure:
    """Failure with the smallest deviations of all factors together that was found.

    Attributes:
        offsets: in widths, (factors,).
        works: fraction of these deviations up to which the design works.
    """

    offsets: Values
    works: float

    @property
    def largest(self) -> float:
        """Largest of the deviations, in widths."""
        return float(np.max(np.abs(self.offsets)))


@dataclass(frozen=True, kw_only=True)
class VerdictMap:
    """Results of designs in which only two factors deviate.

    Attributes:
        first: index of the factor along the first axis.
        second: index of the factor along the second axis.
        steps: values of both, in widths, (2, cells).
        samples: cell by cell, the second factor fastest.
    """

    first: int
    second: int
    steps: Values
    samples: Samples


@dataclass(frozen=True, kw_only=True)
class Tolerance:
    """Probability that a design works within its tolerances, and which tolerances matter most.

    Attributes:
        question: design, tolerances and conditions.
        plan: numbers of runs.
        seed: seed of the points.
        runs: number of designs that were tried.
        nominal: the nominal design, one sample.
        samples: independent points within the tolerances, from which the probabilities are estimated.
        indices: indices of every margin, for the important factors and for the others as one group. If there was no
            time for these, first-order indices from a linear fit, without total ones.
        effects: fraction of the margin's variance that involves each factor, from few rows; without screening the total
            indices; NaN if not computed.
        kept: factors with indices of their own, in the order of the indices.
        screened: result of the screening; None if every factor has its own indices.
        narrowed: effect of every factor's tolerance.
        reaches: range of every factor alone, downwards and upwards, in widths; empty if not computed.
        nearest: nearest failure with all factors deviating; None if not found or not computed.
        map: map over the two most important factors, or None.
    """

    question: Question
    plan: Plan
    seed: int
    runs: int
    nominal: Samples
    samples: Samples
    indices: Indices
    effects: Values
    kept: tuple[int, ...]
    screened: Screening | None
    narrowed: tuple[Narrowed, ...]
    reaches: tuple[tuple[Reach, Reach], ...]
    nearest: NearestFailure | None
    map: VerdictMap | None

    def __repr__(self) -> str:
        """Return the interval of the probability."""
        works = self.probability
        return f"<Tolerance of {self.question.design.name}: works in {works.low:.0%} to {works.high:.0%} of cases>"

    @property
    def probability(self) -> Probability:
        """Probability that the design works."""
        return self.probabilities["works"]

    @property
    def probabilities(self) -> Mapping[str, Probability]:
        """Probabilities of all properties, in the order of the protocol."""
        return {
            name: counted(self.samples.answers, holds)
            for name, holds in zip(fact_names(self.question), self.samples.facts, strict=True)
        }

    @property
    def nominal_works(self) -> bool:
        """Whether the nominal design works."""
        return bool(self.nominal.answers[0] is Answer.WORKS)

    @property
    def can_rank_factors(self) -> bool:
        """Whether there are enough designs to rank the tolerances."""
        return self.plan.rows > 0 or enough_for_linear_fit(len(self.samples), len(self.question.keys))

    @property
    def meets(self) -> bool:
        """Whether every limit on the probability is met by its whole interval."""
        works = self.probability
        return all(
            works.low >= limit.bound if limit.kind == ">=" else works.high <= limit.bound
            for limit in self.question.wanted
        )

    @property
    def outcomes(self) -> Mapping[str, int]:
        """Number of samples with each outcome, the most frequent first."""
        return dict(Counter(self.samples.outcomes.tolist()).most_common())

    @property
    def order(self) -> tuple[int, ...]:
        """Factors with indices of their own, the most important first."""
        importance = self.indices.first[0] if np.isnan(self.indices.total[0]).all() else self.indices.total[0]
        ranked = np.argsort(-np.nan_to_num(importance[: len(self.kept)]), kind="stable")
        return tuple(self.kept[index] for index in ranked)

    @property
    def shown(self) -> tuple[int, ...]:
        """Positions in the indices that are displayed: the most important factors, then the others as a group."""
        groups = range(len(self.kept), len(self.indices.groups))
        return (*(self.kept.index(factor) for factor in self.order[:_MOST_SHOWN]), *groups)


def counted(answers: NDArray[np.object_], holds: Flags) -> Probability:
    """Return the probability of a property of samples, (samples,) both, without the inconclusive ones."""
    conclusive = (answers == Answer.WORKS) | (answers == Answer.FAILS)
    holding = int(np.sum(conclusive & holds))
    count = int(np.sum(conclusive))
    return probability(holding, count - holding, len(answers) - count)
