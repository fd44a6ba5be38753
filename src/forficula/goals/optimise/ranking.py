"""Which trials are better: limits first, then probability, then objectives."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from forficula.arrays import Array, Flags
from forficula.goals.optimise.trial import Trial

Standing = tuple[float, ...]


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
