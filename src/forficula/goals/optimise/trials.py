"""Points of the unit cube in which a search moves, their results, and their ranking."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from forficula.arrays import Array, Flags
from forficula.serial import Key, Written

Point = tuple[float, ...]
# Rounding of coordinates: fine enough for every quantity, coarse enough that rounding errors give no new points.
_DIGITS = 6
Standing = tuple[float, ...]


@dataclass(frozen=True, kw_only=True)
class Axis:
    """A parameter in the search: a coordinate from 0 to 1.

    Attributes:
        levels: number of allowed positions, evenly spaced; 0 for a continuous parameter.
        ordered: whether near positions are similar: true for steps, false for choices.
    """

    levels: int = 0
    ordered: bool = True

    def __post_init__(self) -> None:
        if self.levels < 0 or (self.levels == 0 and not self.ordered):
            raise ValueError(f"levels: need >= 1 for a choice and >= 0 for an ordered axis, got {self.levels}")


def placed(axes: Sequence[Axis], shares: Array) -> list[Point]:
    """Return the nearest allowed points; n levels lie in the middles of n parts.

    Args:
        axes: axes of the search, as many as the shares have columns.
        shares: coordinates, which may lie outside [0, 1], one row per point.
    """
    columns = []
    for axis, column in zip(axes, np.clip(shares, 0.0, 1.0).T, strict=True):
        parts = np.minimum(np.floor(column * axis.levels), axis.levels - 1)
        columns.append(np.round((parts + 0.5) / axis.levels if axis.levels else column, _DIGITS))
    return [tuple(float(value) for value in row) for row in zip(*columns, strict=True)]


def distances(axes: Sequence[Axis], points: Array, centre: Sequence[float]) -> Array:
    """Return distances of points from a centre: the largest difference of any coordinate; 1 if a choice differs."""
    apart = np.abs(points - np.asarray(centre))
    unordered = np.array([not axis.ordered for axis in axes])
    return np.asarray(np.where(unordered & (apart > 0), 1.0, apart).max(axis=1))


@dataclass(frozen=True, kw_only=True)
class Trial:
    """A point and its result.

    Attributes:
        point: coordinates from 0 to 1, one per axis.
        objectives: objectives to be minimised, in any units; nan if unknown.
        margins: by how much each limit is met (> 0) or missed (< 0); nan if not computed, because a cheaper one was
            missed before.
        surplus: probability of working minus the required one; nan if none is required or it was not computed.
    """

    point: Point
    objectives: tuple[float, ...]
    margins: tuple[float, ...] = ()
    surplus: float = math.nan

    @property
    def unknown(self) -> int:
        """Number of limits and objectives that were not computed."""
        return sum(map(math.isnan, (*self.margins, *self.objectives)))

    @property
    def violation(self) -> float:
        """Sum by which limits are missed."""
        return sum(-margin for margin in self.margins if margin < 0)

    @property
    def shortfall(self) -> float:
        """Difference to the required probability; 0 if none is required or it is met."""
        return -self.surplus if self.surplus < 0 else 0.0

    @property
    def feasible(self) -> bool:
        """Whether every limit is met, including that on the probability."""
        return not self.unknown and self.violation == 0 and self.shortfall == 0


@dataclass(frozen=True, kw_only=True)
class Archive:
    """Trials in their order, one row each.

    Attributes:
        trials: in their order.
        points: coordinates.
        objectives: nan if unknown.
        margins: margins of limits, and last the surplus of probability; nan if unknown.
        standings: see `standing`, without objectives.
    """

    trials: tuple[Trial, ...]
    points: Array
    objectives: Array
    margins: Array
    standings: Array


def archive_of(trials: Sequence[Trial]) -> Archive:
    """Return the arrays of at least one trial."""
    return Archive(
        trials=tuple(trials),
        points=np.array([trial.point for trial in trials]),
        objectives=np.array([trial.objectives for trial in trials]),
        margins=np.array([(*trial.margins, trial.surplus) for trial in trials]),
        standings=np.array([standing(trial)[:3] for trial in trials], dtype=float),
    )


def standing(trial: Trial, objective: float = 0.0) -> Standing:
    """Return the sort key of a trial: number of limits not computed, violation, missing probability, objective.

    This is the rule of Deb, 2000, doi.org/10.1016/S0045-7825(99)00389-8, extended to several kinds of violation.

    Args:
        trial: trial to rank.
        objective: used only if the trial is feasible.
    """
    infeasible = trial.unknown or trial.violation or trial.shortfall
    return (trial.unknown, trial.violation, trial.shortfall, 0.0 if infeasible else objective)


def undominated(objectives: Array) -> Flags:
    """Return which rows are not dominated: no other row is at least as small everywhere and smaller somewhere.

    Args:
        objectives: objectives to be minimised, one row per trial.
    """
    nowhere_larger = (objectives[:, None, :] <= objectives[None, :, :]).all(axis=2)
    somewhere_smaller = (objectives[:, None, :] < objectives[None, :, :]).any(axis=2)
    return np.asarray(~(nowhere_larger & somewhere_smaller).any(axis=0))


def pareto_front(trials: Sequence[Trial]) -> list[Trial]:
    """Return the feasible trials that are not dominated, sorted by objectives; for one objective, the best trial.

    Of trials with the same objectives, the first one is returned.
    """
    first = {trial.objectives: trial for trial in reversed(trials) if trial.feasible}
    kept = sorted(first.values(), key=lambda trial: trial.objectives)
    if not kept:
        return []
    chosen = undominated(np.array([trial.objectives for trial in kept]))
    return [trial for trial, is_best in zip(kept, chosen, strict=True) if is_best]


def best_ranked(trials: Sequence[Trial], count: int) -> list[Trial]:
    """Return the best trials, best first.

    With several objectives, feasible trials are sorted by fronts, and within a front by their crowding distance.
    """
    if trials and len(trials[0].objectives) == 1:
        return sorted(trials, key=lambda trial: standing(trial, trial.objectives[0]))[:count]
    feasible = [trial for trial in trials if trial.feasible]
    ranked: list[Trial] = []
    while feasible and len(ranked) < count:
        values = np.array([trial.objectives for trial in feasible])
        chosen = undominated(values)
        front = [trial for trial, is_best in zip(feasible, chosen, strict=True) if is_best]
        crowding = _crowding(values[chosen])
        ranked += [front[index] for index in np.argsort(-crowding, kind="stable")]
        feasible = [trial for trial, is_best in zip(feasible, chosen, strict=True) if not is_best]
    others = sorted((trial for trial in trials if not trial.feasible), key=standing)
    return (ranked + others)[:count]


def _crowding(objectives: Array) -> Array:
    """Return the crowding distance of each row of a front, Deb et al., 2002, doi.org/10.1109/4235.996017."""
    crowding = np.zeros(len(objectives))
    for column in objectives.T:
        order = np.argsort(column, kind="stable")
        span = column[order[-1]] - column[order[0]]
        crowding[order[[0, -1]]] = np.inf
        if span > 0 and len(order) > 2:
            crowding[order[1:-1]] += (column[order[2:]] - column[order[:-2]]) / span
    return crowding


@dataclass(frozen=True, kw_only=True)
class Relaxation:
    """Cost of one limit.

    Attributes:
        limit: index of the limit.
        best: largest margin of any trial; nan if never computed.
        alone: largest margin of trials that meet all other limits, so that only this one would have to be relaxed; nan
            if there are none.
        unseen: largest margin of trials that miss no other computed limit, but lack some limits because this one was
            missed before; nan if there are none.
        trial: the trial of `alone`, or None.
    """

    limit: Annotated[int, Written.NEVER]
    best: Annotated[float, Key("best_margin")]
    alone: Annotated[float, Key("best_where_others_hold")]
    unseen: Annotated[float, Written.NEVER]
    trial: Annotated[Trial | None, Written.NEVER]


def relaxations(trials: Sequence[Trial]) -> list[Relaxation]:
    """Return the cost of each limit, in their order."""
    count = len(trials[0].margins) if trials else 0
    return [_relaxation(trials, number) for number in range(count)]


def nearest_trial(trials: Sequence[Trial]) -> Trial | None:
    """Return the trial that is closest to meeting every limit; None without trials."""
    return min(trials, key=standing, default=None)


def _relaxation(trials: Sequence[Trial], number: int) -> Relaxation:
    known = [trial for trial in trials if not math.isnan(trial.margins[number])]
    alone = [trial for trial in known if all(margin >= 0 for margin in _others(trial, number))]
    unseen = [
        trial.margins[number]
        for trial in known
        if trial not in alone and not any(margin < 0 for margin in _others(trial, number))
    ]
    best = max(alone, key=lambda trial: trial.margins[number], default=None)
    return Relaxation(
        limit=number,
        best=max((trial.margins[number] for trial in known), default=math.nan),
        alone=math.nan if best is None else best.margins[number],
        unseen=max(unseen, default=math.nan),
        trial=best,
    )


def _others(trial: Trial, number: int) -> list[float]:
    """Return the margins of all limits but one."""
    return [margin for other, margin in enumerate(trial.margins) if other != number]
