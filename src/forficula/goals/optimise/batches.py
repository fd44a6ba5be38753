"""The search itself: which points to look at next, from what became of those before."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Protocol

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.goals.optimise.archive import Aim, Archive, archive_of, bases_of
from forficula.goals.optimise.axis import Axis, Point, placed
from forficula.goals.optimise.proposal import neighbourhood, proposed
from forficula.goals.optimise.ranking import best_ranked, pareto_front
from forficula.goals.optimise.relaxation import relaxations
from forficula.goals.optimise.trial import Trial
from forficula.goals.optimise.variation import around, varied
from forficula.goals.optimise.weights import aim_weights

# Of a batch: the share that parabolas propose, and the share drawn around what they start from.
_PROPOSED, _AROUND = 0.25, 0.25
# Of the rest, as long as nothing is feasible: the share that fills the space further.
_FILLING = 0.5
# Trials before parabolas are of use, an axis, and at least.
_START, _LEAST_START = 4, 32
# How far proposals go, as shares of the neighbourhood, and how far they stay within the limits, one after another.
_REACHES, _BACKS = (2.0, 1.0, 0.5, 0.25), (1e-6, 1e-3, 1e-4, 1e-2)
# Bases are that far apart, and there are so many at most.
_APART, _BASES = 0.2, 4
# Trials that differential evolution goes on with, batches.
_POPULATION = 2
# A front of no more than its ends does not tell yet how far it spans.
_ENDS, _LEAST_SPAN = 2, 1e-12
_END_EVERY = 4


class Optimiser(Protocol):
    """A method that looks for the best points of the unit cube, batch after batch."""

    def ask(self) -> list[Point]:
        """Return the points to try next; none where no point is left."""
        ...

    def tell(self, trials: Sequence[Trial]) -> None:
        """Learn from trials of the points that were tried, which may be others than those that `ask` returned."""
        ...


class ParabolaSearch:
    """Search that fits parabolas to the trials around the best points and proposes the optimum of the parabolas.

    Scrambled Sobol points (Owen, 1998) fill the space first. Then parabolas through the trials around the best ones,
    apart from one another, propose where their optimum is, further ones are drawn around these, and the rest comes from
    differential evolution, which finds what parabolas do not see. Points are a pure function of the arguments and of
    what was told, in their order: a search that is told the same again asks the same again.
    """

    def __init__(
        self, axes: Sequence[Axis], objectives: int, batch: int, seed: int, starts: Sequence[Point] = ()
    ) -> None:
        """Start a search.

        Args:
            axes: of the unit cube.
            objectives: how many, 1 to 3.
            batch: points at a time.
            seed: of all that is drawn.
            starts: points to look at first.
        """
        self._axes, self._batch, self._seed, self._starts = axes, batch, seed, starts
        self._weights = aim_weights(objectives)
        self._filling = scipy.stats.qmc.Sobol(len(axes), rng=np.random.default_rng(seed))
        self._trials: list[Trial] = []
        self._tried: set[Point] = set()
        self._number = 0

    def ask(self) -> list[Point]:
        """Return the next batch of points, none of which was tried before; none where no point is left."""
        axes, batch = self._axes, self._batch
        generator = np.random.default_rng([self._seed, self._number])
        if len(self._trials) < filling_count(axes, batch):
            wanted = [*placed(axes, np.array(self._starts).reshape(-1, len(axes)))] if self._number == 0 else []
            wanted += placed(axes, _filling_points(self._filling, batch))
        else:
            wanted = _near(axes, archive_of(self._trials), self._weights, batch, self._number, generator)
            rest = batch - len(_new(wanted, self._tried, batch))
            spread = 0 if any(trial.feasible for trial in self._trials) else round(_FILLING * rest)
            wanted += placed(axes, _filling_points(self._filling, spread)) if spread else []
            wanted += varied(axes, best_ranked(self._trials, _POPULATION * batch), rest - spread, generator)
        points = _new(wanted, self._tried, batch)
        # what differential evolution repeats is of no use: fill instead, as long as there is anything to fill
        for _ in range(8):
            if len(points) < batch:
                more = placed(axes, _filling_points(self._filling, batch))
                points += _new(more, self._tried | set(points), batch - len(points))
        return points

    def tell(self, trials: Sequence[Trial]) -> None:
        """Learn from the trials of a batch."""
        self._trials += trials
        self._tried |= {trial.point for trial in trials}
        self._number += 1


def filling_count(axes: Sequence[Axis], batch: int) -> int:
    """How many points fill the space evenly before a search looks closer anywhere, in whole batches.

    Args:
        axes: of the search.
        batch: points at a time.
    """
    return batch * math.ceil(max(_LEAST_START, _START * len(axes), batch) / batch)


def _filling_points(filling: scipy.stats.qmc.Sobol, count: int) -> Array:
    """Further points of a sequence; drawn one by one, for together scipy warns of counts that are no power of two."""
    return np.array([filling.random()[0] for _ in range(count)])


def _new(points: Sequence[Point], asked: set[Point], count: int) -> list[Point]:
    """Points that were not asked before, each once."""
    return [point for point in dict.fromkeys(points) if point not in asked][:count]


def _near(
    axes: Sequence[Axis],
    archive: Archive,
    weights: Array,
    batch: int,
    number: int,
    generator: np.random.Generator,
) -> list[Point]:
    """What parabolas propose, and points around their bases."""
    found: list[Point] = []
    known = archive.objectives[np.isfinite(archive.objectives).all(axis=1)]
    if not len(known):
        return found
    front = np.array([trial.objectives for trial in pareto_front(archive.trials)])
    best = front if len(front) else known
    ideal, span = best.min(axis=0), np.ptp(front if len(front) > _ENDS else known, axis=0)
    giving = [] if len(front) else relaxations(archive.trials)
    count, ends = max(1, round(_PROPOSED * batch)), archive.objectives.shape[1]
    for each in range(count):
        turn = number * count + each
        # the ends of a front move last, and the rest is scaled by them
        chosen = turn // _END_EVERY % ends if each % _END_EVERY == 0 else turn % len(weights)
        aim = Aim(weights=weights[chosen], ideal=ideal, span=np.maximum(span, _LEAST_SPAN))
        bases = bases_of(axes, archive, aim, _APART, _BASES)
        base = bases[0 if each % 2 == 0 else turn // 2 % len(bases)]
        # where nothing is feasible one limit after another gives, so that what each costs alone is found, too
        gives = giving[number % len(giving)] if giving and each == count - 1 else None
        if gives is not None and gives.trial is not None:
            base = gives.trial
        near = neighbourhood(axes, archive, base, aim)
        if near is None:
            continue
        kind = (each if len(weights) == 1 else turn // len(weights)) % len(_REACHES)
        limit = None if gives is None else gives.limit
        found.append(proposed(axes, near, aim, _REACHES[kind], _BACKS[kind], limit))
        found += around(axes, base.point, near.radius / 2, max(1, round(_AROUND * batch / count)), generator)
    return found
