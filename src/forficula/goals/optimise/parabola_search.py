"""Search by parabolas and differential evolution: proposes the next points from the results of earlier trials."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from typing import Protocol

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.goals.optimise.parabolas import Aim, neighbourhood, proposed
from forficula.goals.optimise.trials import (
    Archive,
    Axis,
    Point,
    Trial,
    archive_of,
    best_ranked,
    distances,
    pareto_front,
    placed,
    relaxations,
)

# Fractions of a batch that parabolas propose, and that are drawn around the best trials.
_PROPOSED, _AROUND = 0.25, 0.25
# Fraction of the remaining batch that fills the space, as long as no trial is feasible.
_FILLING = 0.5
# Number of trials before parabolas are used: per axis, and in total at least.
_START, _LEAST_START = 4, 32
# Lengths of proposed steps, as fractions of the neighbourhood, and distances to keep from the limits, used in turn.
_REACHES, _BACKS = (2.0, 1.0, 0.5, 0.25), (1e-6, 1e-3, 1e-4, 1e-2)
# Smallest distance between bases, and their largest number.
_APART, _BASES = 0.2, 4
# A front that consists of its ends alone does not yet define its span.
_ENDS, _LEAST_SPAN = 2, 1e-12
_END_EVERY = 4
# Number of batches of trials that differential evolution uses; fraction of them from which it starts.
_POPULATION, _LEADING = 2, 0.05
# Range of the step factor for differences; fraction of axes that change; fraction of positions that are drawn anew.
_STEPS, _CROSSED, _DRAWN = (0.4, 0.9), 0.8, 0.1
# Number of parts per side of the weights of aims, by the number of objectives: 17 and 28 directions.
_PARTS = {1: 1, 2: 16, 3: 6}
# Every objective has at least this weight, so that it is not worsened without benefit.
_LEAST_WEIGHT = 0.01


class Optimiser(Protocol):
    """A method that searches for the best points of the unit cube, batch by batch."""

    def ask(self) -> list[Point]:
        """Return the points to try next; empty if no point is left."""
        ...

    def tell(self, trials: Sequence[Trial]) -> None:
        """Use the trials of the tried points, which may differ from those that `ask` returned."""
        ...


class ParabolaSearch:
    """Search that fits parabolas to the trials around the best points and proposes the optimum of the parabolas.

    Scrambled Sobol points (Owen, 1998) fill the space first. Then parabolas are fitted to the trials around the best
    ones that are apart from each other. Their optima are proposed, further points are drawn around these, and the rest
    comes from differential evolution, which finds what parabolas do not represent. Points are a pure function of the
    arguments and of the trials in their order.
    """

    def __init__(
        self, axes: Sequence[Axis], objectives: int, batch: int, seed: int, starts: Sequence[Point] = ()
    ) -> None:
        """Start a search.

        Args:
            axes: axes of the unit cube.
            objectives: number of objectives, 1 to 3.
            batch: number of points per batch.
            seed: seed of all random numbers.
            starts: points to try first.
        """
        self._axes, self._batch, self._seed, self._starts = axes, batch, seed, starts
        self._weights = aim_weights(objectives)
        self._filling = scipy.stats.qmc.Sobol(len(axes), rng=np.random.default_rng(seed))
        self._trials: list[Trial] = []
        self._tried: set[Point] = set()
        self._number = 0

    def ask(self) -> list[Point]:
        """Return the next batch of untried points; empty if no point is left."""
        generator = np.random.default_rng([self._seed, self._number])
        if len(self._trials) < filling_count(self._axes, self._batch):
            starts = self._starts if self._number == 0 else []
            wanted = [*placed(self._axes, np.array(starts).reshape(-1, len(self._axes))), *self._fill(self._batch)]
        else:
            wanted = self._near_the_best(generator)
            rest = self._batch - len(self._new(wanted))
            spread = 0 if any(trial.feasible for trial in self._trials) else round(_FILLING * rest)
            wanted += self._fill(spread)
            best = best_ranked(self._trials, _POPULATION * self._batch)
            wanted += _varied(self._axes, best, rest - spread, generator)
        points = self._new(wanted)
        # points that differential evolution repeats are replaced by points that fill the space, as long as there are
        # any
        for _ in range(8):
            if len(points) < self._batch:
                points = self._new([*points, *self._fill(self._batch)])
        return points

    def tell(self, trials: Sequence[Trial]) -> None:
        """Use the trials of a batch."""
        self._trials += trials
        self._tried |= {trial.point for trial in trials}
        self._number += 1

    def _fill(self, count: int) -> list[Point]:
        """Return further points of the Sobol sequence."""
        # one by one, because SciPy warns of counts that are no power of two
        drawn = [self._filling.random()[0] for _ in range(count)]
        return placed(self._axes, np.array(drawn).reshape(count, len(self._axes)))

    def _new(self, points: Sequence[Point]) -> list[Point]:
        """Return untried points without repetition, at most a batch."""
        return [point for point in dict.fromkeys(points) if point not in self._tried][: self._batch]

    def _near_the_best(self, generator: np.random.Generator) -> list[Point]:
        """Return points that parabolas propose, and points around their bases."""
        axes, batch, weights, points = self._axes, self._batch, self._weights, list[Point]()
        archive = archive_of(self._trials)
        known = archive.objectives[np.isfinite(archive.objectives).all(axis=1)]
        if not len(known):
            return points
        front = np.array([trial.objectives for trial in pareto_front(self._trials)])
        best = front if len(front) else known
        ideal, span = best.min(axis=0), np.ptp(front if len(front) > _ENDS else known, axis=0)
        relaxable = [] if len(front) else relaxations(self._trials)
        count, ends = max(1, round(_PROPOSED * batch)), archive.objectives.shape[1]
        for number in range(count):
            turn = self._number * count + number
            # the ends of a front move last, because they scale the rest
            chosen = turn // _END_EVERY % ends if number % _END_EVERY == 0 else turn % len(weights)
            aim = Aim(weights=weights[chosen], ideal=ideal, span=np.maximum(span, _LEAST_SPAN))
            bases = _bases(axes, archive, aim)
            base = bases[0 if number % 2 == 0 else turn // 2 % len(bases)]
            # if nothing is feasible, one limit after another is relaxed, so that the cost of each alone is found, too
            relaxed = relaxable[self._number % len(relaxable)] if relaxable and number == count - 1 else None
            if relaxed is not None and relaxed.trial is not None:
                base = relaxed.trial
            near = neighbourhood(axes, archive, base, aim)
            if near is None:
                continue
            kind = (number if len(weights) == 1 else turn // len(weights)) % len(_REACHES)
            limit = None if relaxed is None else relaxed.limit
            points.append(proposed(axes, near, aim, _REACHES[kind], _BACKS[kind], limit))
            points += _around(axes, base.point, near.radius / 2, max(1, round(_AROUND * batch / count)), generator)
        return points


def filling_count(axes: Sequence[Axis], batch: int) -> int:
    """Return the number of points that fill the space evenly before the search uses results, in whole batches.

    Args:
        axes: axes of the search.
        batch: number of points per batch.
    """
    return batch * math.ceil(max(_LEAST_START, _START * len(axes), batch) / batch)


def aim_weights(objectives: int) -> Array:
    """Return weights of objectives, one row per aim; first the ends, then those in between in a scattered order.

    Das and Dennis, 1998, doi.org/10.1137/S1052623496307510. The minimum of the greatest weighted objective lies along
    the direction of the inverse weights.

    Args:
        objectives: 1, 2 or 3.
    """
    parts = _PARTS[objectives]
    shares = [
        np.array(counts) / parts
        for counts in itertools.product(range(parts + 1), repeat=objectives)
        if sum(counts) == parts
    ]
    ends = [share for share in shares if share.max() == 1]
    others = [share for share in shares if share.max() < 1]
    scattered = sorted(range(len(others)), key=lambda number: (number * 7) % max(len(others), 1))
    directions = np.maximum(np.array(ends + [others[number] for number in scattered]), _LEAST_WEIGHT)
    weights = 1 / directions
    return np.asarray(weights / weights.max(axis=1, keepdims=True))


def _bases(axes: Sequence[Axis], archive: Archive, aim: Aim) -> list[Trial]:
    """Return the best trials for an aim that are apart from each other, the best first."""
    lost = archive.standings.any(axis=1)
    values = np.where(lost, 0.0, aim.values(archive.objectives))
    order = np.lexsort((values, *archive.standings.T[::-1]))
    bases: list[Trial] = []
    while len(order) and len(bases) < _BASES:
        bases.append(archive.trials[order[0]])
        order = order[distances(axes, archive.points[order], bases[-1].point) > _APART]
    return bases


def _varied(axes: Sequence[Axis], best: Sequence[Trial], count: int, generator: np.random.Generator) -> list[Point]:
    """Return points by differential evolution from the best trials.

    Storn and Price, 1997, doi.org/10.1023/A:1008202821328: "best/1" with one of the few best trials.

    Args:
        axes: axes of the search.
        best: trials, the best first.
        count: number of points.
        generator: generator of random numbers.
    """
    points = np.array([trial.point for trial in best])
    base, first, second = (points[generator.integers(len(points), size=count)] for _ in range(3))
    leading = max(2, round(_LEADING * len(points)))
    start = points[generator.integers(min(leading, len(points)), size=count)]
    moved = start + generator.uniform(*_STEPS, size=(count, 1)) * (first - second)
    unordered = np.array([not axis.ordered for axis in axes])
    # choices have no differences: they are taken over
    moved[:, unordered] = start[:, unordered]
    crossed = generator.random(moved.shape) < _CROSSED
    crossed[np.arange(count), generator.integers(len(axes), size=count)] = True
    children = np.where(crossed, _reflected(moved), base)
    levelled = np.array([axis.levels > 0 for axis in axes])
    drawn = levelled & (generator.random(children.shape) < _DRAWN)
    return placed(axes, np.where(drawn, generator.random(children.shape), children))


def _around(
    axes: Sequence[Axis], base: Point, radius: float, count: int, generator: np.random.Generator
) -> list[Point]:
    """Return random points in the box of a radius about a point, with which parabolas are fitted later."""
    shift = radius * (2 * generator.random((count, len(axes))) - 1)
    shift[:, [not axis.ordered for axis in axes]] = 0.0
    return placed(axes, _reflected(np.asarray(base) + shift))


def _reflected(coordinates: Array) -> Array:
    """Reflect coordinates at 0 and 1."""
    return np.asarray(1 - np.abs(1 - np.abs(coordinates) % 2))
