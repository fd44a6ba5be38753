"""All trials of a search as arrays, and which of them are best by an aim."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.goals.optimise.axis import Axis, distances
from forficula.goals.optimise.ranking import standing
from forficula.goals.optimise.trial import Trial

# How much the sum of all objectives counts beside the worst of them, so that none is given away for nothing.
SUM = 1e-3


@dataclass(frozen=True, kw_only=True)
class Archive:
    """Trials in the order in which they were told, one row each.

    Attributes:
        trials: as they were told.
        points: shares of the axes.
        objectives: nan where not known.
        margins: of limits, and last the surplus of probability; nan where not known.
        standings: as `standing` gives them, without objectives.
    """

    trials: tuple[Trial, ...]
    points: Array
    objectives: Array
    margins: Array
    standings: Array


def archive_of(trials: Sequence[Trial]) -> Archive:
    """The arrays of trials, at least one."""
    return Archive(
        trials=tuple(trials),
        points=np.array([trial.point for trial in trials]),
        objectives=np.array([trial.objectives for trial in trials]),
        margins=np.array([(*trial.margins, trial.surplus) for trial in trials]),
        standings=np.array([standing(trial)[:3] for trial in trials], dtype=float),
    )


@dataclass(frozen=True, kw_only=True)
class Aim:
    """What a proposal is to make small: the greatest of the weighted objectives, counted from the best of each.

    Steuer and Choo, 1983, doi.org/10.1007/BF02591870.

    Attributes:
        weights: one an objective.
        ideal: the least of each objective so far.
        span: by how much each differs over the front.
    """

    weights: Array
    ideal: Array
    span: Array

    def shares(self, objectives: Array) -> Array:
        """Objectives, counted from 0 at the ideal to 1 at the end of the span."""
        return (objectives - self.ideal) / self.span

    def values(self, objectives: Array) -> Array:
        """What rows of objectives come to."""
        shares = self.shares(objectives)
        return np.asarray((self.weights * shares).max(axis=1) + SUM * shares.sum(axis=1))


def bases_of(axes: Sequence[Axis], archive: Archive, aim: Aim, apart: float, count: int) -> list[Trial]:
    """The best trials by an aim that lie apart from one another, the best first.

    Args:
        axes: of the search.
        archive: all trials.
        aim: by which those rank of which nothing else is missing.
        apart: least distance, as a share.
        count: how many at most.
    """
    lost = archive.standings.any(axis=1)
    values = np.where(lost, 0.0, aim.values(archive.objectives))
    order = np.lexsort((values, *archive.standings.T[::-1]))
    bases: list[Trial] = []
    while len(order) and len(bases) < count:
        bases.append(archive.trials[order[0]])
        order = order[distances(axes, archive.points[order], bases[-1].point) > apart]
    return bases
