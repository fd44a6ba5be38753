"""Points of the unit cube in which a search moves, what became of them, and which of them are better."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from forficula.arrays import Array, Flags
from forficula.serial import Key, Written

Point = tuple[float, ...]
# Fine enough for every quantity, and coarse enough that the last bit of a sum is not another point.
_DIGITS = 6
Standing = tuple[float, ...]


@dataclass(frozen=True, kw_only=True)
class Axis:
    """A parameter as a search sees it: a share from 0 to 1.

    Attributes:
        levels: how many places it has, evenly spaced; 0 where it is continuous.
        ordered: whether near places are alike: those of steps are, those of a choice are not.
    """

    levels: int = 0
    ordered: bool = True

    def __post_init__(self) -> None:
        if self.levels < 0 or (self.levels == 0 and not self.ordered):
            raise ValueError(f"levels: need >= 1 of a choice and >= 0 of what is ordered, got {self.levels}")


def placed(axes: Sequence[Axis], shares: Array) -> list[Point]:
    """The nearest places of shares, which may lie outside of 0 to 1; places of n levels are the middles of n parts.

    Args:
        axes: as many as the shares have columns.
        shares: one row a point.
    """
    columns = []
    for axis, column in zip(axes, np.clip(shares, 0.0, 1.0).T, strict=True):
        parts = np.minimum(np.floor(column * axis.levels), axis.levels - 1)
        columns.append(np.round((parts + 0.5) / axis.levels if axis.levels else column, _DIGITS))
    return [tuple(float(value) for value in row) for row in zip(*columns, strict=True)]


def distances(axes: Sequence[Axis], points: Array, centre: Sequence[float]) -> Array:
    """How far points lie from a centre: the greatest difference of any share; 1 where a choice differs."""
    apart = np.abs(points - np.asarray(centre))
    unordered = np.array([not axis.ordered for axis in axes])
    return np.asarray(np.where(unordered & (apart > 0), 1.0, apart).max(axis=1))


@dataclass(frozen=True, kw_only=True)
class Trial:
    """A point and what is known of it.

    Attributes:
        point: shares from 0 to 1, one an axis.
        objectives: to be made small, in any units; nan where one is not known.
        margins: by how much each limit holds (> 0) or fails (< 0); nan of those that were not looked at, because a
            cheaper one failed before.
        surplus: by how much the probability of working is more than wanted, or, where < 0, less; nan where none is
            wanted or the point was not worth asking.
    """

    point: Point
    objectives: tuple[float, ...]
    margins: tuple[float, ...] = ()
    surplus: float = math.nan

    @property
    def unknown(self) -> int:
        """How many limits and objectives were not looked at."""
        return sum(map(math.isnan, (*self.margins, *self.objectives)))

    @property
    def violation(self) -> float:
        """By how much limits that were looked at fail, in all."""
        return sum(-margin for margin in self.margins if margin < 0)

    @property
    def shortfall(self) -> float:
        """What is missing of the wanted probability; 0 where none was asked."""
        return -self.surplus if self.surplus < 0 else 0.0

    @property
    def feasible(self) -> bool:
        """Whether every limit holds and no probability is missing."""
        return not self.unknown and self.violation == 0 and self.shortfall == 0


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


def standing(trial: Trial, objective: float = 0.0) -> Standing:
    """What sorts trials, the best first: limits not looked at, violation, missing probability, objective.

    This is the rule of Deb, 2000, doi.org/10.1016/S0045-7825(99)00389-8, with more than one kind of failing.

    Args:
        trial: to place.
        objective: that counts where nothing else does.
    """
    lost = trial.unknown or trial.violation or trial.shortfall
    return (trial.unknown, trial.violation, trial.shortfall, 0.0 if lost else objective)


def undominated(objectives: Array) -> Flags:
    """Which rows no other row beats: none is as small everywhere and smaller somewhere.

    Args:
        objectives: to be made small, one row a trial.
    """
    nowhere_larger = (objectives[:, None, :] <= objectives[None, :, :]).all(axis=2)
    somewhere_smaller = (objectives[:, None, :] < objectives[None, :, :]).any(axis=2)
    return np.asarray(~(nowhere_larger & somewhere_smaller).any(axis=0))


def pareto_front(trials: Sequence[Trial]) -> list[Trial]:
    """The feasible trials that no other one beats, by their objectives; of one objective, the best one.

    Of trials with the same objectives the first one is taken.
    """
    first = {trial.objectives: trial for trial in reversed(trials) if trial.feasible}
    kept = sorted(first.values(), key=lambda trial: trial.objectives)
    if not kept:
        return []
    chosen = undominated(np.array([trial.objectives for trial in kept]))
    return [trial for trial, is_best in zip(kept, chosen, strict=True) if is_best]


def best_ranked(trials: Sequence[Trial], count: int) -> list[Trial]:
    """The best trials, the best first.

    Of several objectives, feasible ones go by fronts, one after another, and within a front by how lonely they are.
    """
    if trials and len(trials[0].objectives) == 1:
        return sorted(trials, key=lambda trial: standing(trial, trial.objectives[0]))[:count]
    feasible = [trial for trial in trials if trial.feasible]
    ranked: list[Trial] = []
    while feasible and len(ranked) < count:
        values = np.array([trial.objectives for trial in feasible])
        chosen = undominated(values)
        front = [trial for trial, is_best in zip(feasible, chosen, strict=True) if is_best]
        lonely = _crowding(values[chosen])
        ranked += [front[index] for index in np.argsort(-lonely, kind="stable")]
        feasible = [trial for trial, is_best in zip(feasible, chosen, strict=True) if not is_best]
    others = sorted((trial for trial in trials if not trial.feasible), key=standing)
    return (ranked + others)[:count]


def _crowding(objectives: Array) -> Array:
    """How far apart the neighbours of each row of a front are, as of Deb et al., 2002, doi.org/10.1109/4235.996017."""
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
    """What one limit costs.

    Attributes:
        limit: its number.
        best: the greatest margin that any trial has; nan where none was looked at.
        alone: the greatest margin of trials that meet all others, so that nothing else would have to give; nan where
            there are none.
        unseen: the greatest margin of trials that are known to fail no other but were not asked all others, for this
            one failed before; nan where there are none.
        trial: that has `alone`, or None.
    """

    limit: Annotated[int, Written.NEVER]
    best: Annotated[float, Key("best_margin")]
    alone: Annotated[float, Key("best_where_others_hold")]
    unseen: Annotated[float, Written.NEVER]
    trial: Annotated[Trial | None, Written.NEVER]


def relaxations(trials: Sequence[Trial]) -> list[Relaxation]:
    """What each limit costs, in their order."""
    count = len(trials[0].margins) if trials else 0
    return [_relaxation(trials, number) for number in range(count)]


def nearest_trial(trials: Sequence[Trial]) -> Trial | None:
    """The trial that comes nearest to meeting every limit; None of none."""
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
    """The margins of all limits but one."""
    return [margin for other, margin in enumerate(trial.margins) if other != number]
