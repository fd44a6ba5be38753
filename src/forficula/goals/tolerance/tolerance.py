"""Tolerance: how likely it is that a design works as it is built, and what decides it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.arrays import Flags
from forficula.goals.tolerance.indices import Indices, Values, tells_lines
from forficula.goals.tolerance.narrowing import Narrowed
from forficula.goals.tolerance.nearest_failure import Answer, Reach
from forficula.goals.tolerance.plan import Plan
from forficula.goals.tolerance.probability import Probability, probability
from forficula.goals.tolerance.question import Question
from forficula.goals.tolerance.samples import Samples, fact_names
from forficula.goals.tolerance.screening import Screening

# of straight lines, which every factor has
_MOST_SHOWN = 10


@dataclass(frozen=True, kw_only=True)
class NearestFailure:
    """The failure with the least of all deviations at once that was found.

    Attributes:
        offsets: in widths, (factors,).
        works: up to which share of these it works.
    """

    offsets: Values
    works: float

    @property
    def largest(self) -> float:
        """The largest of the deviations, in widths."""
        return float(np.max(np.abs(self.offsets)))


@dataclass(frozen=True, kw_only=True)
class VerdictMap:
    """What becomes of designs of which two factors are off, and nothing else.

    Attributes:
        first: number of the factor along the first axis.
        second: along the second.
        steps: of both, in widths, (2, cells).
        samples: cell by cell, the second factor fastest.
    """

    first: int
    second: int
    steps: Values
    samples: Samples


@dataclass(frozen=True, kw_only=True)
class Tolerance:
    """How likely it is that a design works as it is built, and what decides it.

    Attributes:
        question: what was asked.
        plan: which runs were made.
        seed: of the points.
        runs: how many designs were tried.
        nominal: the design as it is meant, one sample.
        samples: independent points within the tolerances, from which the probabilities come.
        indices: of every margin, of the factors that matter and of the others as one group; where there was no time
            for these, first-order ones of the factors' straight lines, without total ones.
        effects: of every factor, from few rows, the share of the margin's variance that has to do with it; of few
            factors those of their own indices; NaN where there are none.
        kept: numbers of the factors with indices of their own, in the order of the indices.
        screened: what chose them among many; None where every factor has its own.
        narrowed: of every factor.
        reaches: of every factor alone how far it may go down and up, in widths; empty where that was not looked for.
        nearest: nearest failure with all factors off; None where none was found or looked for.
        map: over the two factors that decide most, or None.
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
        """How likely it is."""
        works = self.probability
        return f"<Tolerance of {self.question.design.name}: works in {works.low:.0%} to {works.high:.0%} of cases>"

    @property
    def probability(self) -> Probability:
        """That it works."""
        return self.probabilities["works"]

    @property
    def probabilities(self) -> Mapping[str, Probability]:
        """Of all that may hold, in the order of the protocol."""
        return {
            name: counted(self.samples.answers, holds)
            for name, holds in zip(fact_names(self.question), self.samples.facts, strict=True)
        }

    @property
    def nominal_works(self) -> bool:
        """Whether the design works as it is meant."""
        return bool(self.nominal.answers[0] is Answer.WORKS)

    @property
    def tells_what_decides(self) -> bool:
        """Whether there are enough designs to tell which tolerance decides."""
        return self.plan.rows > 0 or tells_lines(len(self.samples), len(self.question.keys))

    @property
    def meets(self) -> bool:
        """Whether every limit on the probability is met by the whole of its interval."""
        works = self.probability
        return all(
            works.low >= limit.bound if limit.kind == ">=" else works.high <= limit.bound
            for limit in self.question.wanted
        )

    @property
    def outcomes(self) -> Mapping[str, int]:
        """How many of the samples came to what, the most frequent first."""
        return dict(Counter(self.samples.outcomes.tolist()).most_common())

    @property
    def order(self) -> tuple[int, ...]:
        """Numbers of the factors with indices of their own, those that decide most first."""
        decides = self.indices.first[0] if np.isnan(self.indices.total[0]).all() else self.indices.total[0]
        ranked = np.argsort(-np.nan_to_num(decides[: len(self.kept)]), kind="stable")
        return tuple(self.kept[place] for place in ranked)

    @property
    def shown(self) -> tuple[int, ...]:
        """Places in the indices of what people are shown: those that decide most, then the others as a group."""
        groups = range(len(self.kept), len(self.indices.groups))
        return (*(self.kept.index(factor) for factor in self.order[:_MOST_SHOWN]), *groups)


def counted(answers: NDArray[np.object_], holds: Flags) -> Probability:
    """The probability of what holds in some samples, (samples,) both; those that tell nothing counted apart."""
    tells = (answers == Answer.WORKS) | (answers == Answer.FAILS)
    holding = int(np.sum(tells & holds))
    told = int(np.sum(tells))
    return probability(holding, told - holding, len(answers) - told)
