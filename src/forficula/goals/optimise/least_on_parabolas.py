"""The least of parabolas within the limits that others set.

Nothing here or in what it is fed with is left to a library of linear algebra: what those return depends, in the last
bit, on the processor and on how many threads they take, and a search that is taken up again elsewhere would then ask
for other designs.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Flags

# Rounds of multipliers, Newton steps of each at most, and halvings of a step.
_ROUNDS, _STEPS, _HALVINGS = 10, 20, 12
# Stiffness of the penalty: at first, by how much it grows, and at most.
_STIFFNESS, _STIFFER, _STIFFEST = 10.0, 5.0, 1e5
_ENOUGH = 1e-9
# A change of multipliers, as a share of one more, that is none.
_SETTLED = 1e-6


@dataclass(frozen=True, kw_only=True)
class Parabolas:
    """Several parabolas over the same axes.

    Attributes:
        values: at the origin, (parabola,).
        slopes: there, (parabola, axis).
        curvatures: symmetric, (parabola, axis, axis).
    """

    values: Array
    slopes: Array
    curvatures: Array

    def at(self, place: Array) -> tuple[Array, Array]:
        """Values and slopes at a place."""
        bent = (self.curvatures * place).sum(axis=2)
        return self.values + ((self.slopes + bent / 2) * place).sum(axis=1), self.slopes + bent


@dataclass(frozen=True, kw_only=True)
class Problem:
    """What is to be small, within what.

    Attributes:
        cost: one parabola, and, where there are ceilings, a number on top: the least one that is above all of them.
        ceilings: parabolas whose greatest counts; none where only the cost does.
        limits: parabolas that are not to fall below 0.
        prices: what it costs, by limit, to fall below it by 1, once no place meets them.
        low: bounds of the place.
        high: likewise.
    """

    cost: Parabolas
    ceilings: Parabolas
    limits: Parabolas
    prices: Array
    low: Array
    high: Array


def least_place(problem: Problem, start: Array) -> Array:
    """Find the place of least cost near a start, by augmented Lagrangians and projected Newton steps.

    Powell, 1969, and Hestenes, 1969, doi.org/10.1007/BF00927673; multipliers stay below the prices, so that limits that
    cannot be met are missed by as little as can be. Bertsekas, 1982, doi.org/10.1137/0320018, for the bounds.

    Args:
        problem: what is to be small.
        start: within the bounds.
    """
    ceilings, limits = len(problem.ceilings.values), len(problem.limits.values)
    prices = np.concatenate([np.ones(ceilings), problem.prices])
    multipliers = np.concatenate([np.full(ceilings, 1 / max(ceilings, 1)), np.zeros(limits)])
    place, top = start, float(problem.ceilings.at(start)[0].max()) if ceilings else 0.0
    stiffness = _STIFFNESS
    for _ in range(_ROUNDS):
        place, top = _relaxed(problem, place, top, multipliers, prices, stiffness)
        slack = np.concatenate([top - problem.ceilings.at(place)[0], problem.limits.at(place)[0]])
        before, multipliers = multipliers, np.clip(multipliers - stiffness * slack, 0.0, prices)
        if (np.abs(multipliers - before) <= _SETTLED * (1 + before)).all():
            break
        stiffness = min(_STIFFER * stiffness, _STIFFEST)
    return place


def _relaxed(
    problem: Problem, place: Array, top: float, multipliers: Array, prices: Array, stiffness: float
) -> tuple[Array, float]:
    """Newton steps on the augmented Lagrangian, within the bounds."""
    has_top = len(problem.ceilings.values) > 0
    low = np.append(problem.low, -math.inf) if has_top else problem.low
    high = np.append(problem.high, math.inf) if has_top else problem.high
    unknowns = np.append(place, top) if has_top else place
    value, slope, curvature = _lagrangian(problem, unknowns, multipliers, prices, stiffness)
    for _ in range(_STEPS):
        held = ((unknowns <= low) & (slope > 0)) | ((unknowns >= high) & (slope < 0))
        if held.all() or np.abs(slope[~held]).max() < _ENOUGH:
            break
        step = _newton_step(slope, curvature, held)
        # where nothing is curved it is as long as it likes
        longest = np.abs(step[: len(place)]).max()
        step *= min(1.0, float((problem.high - problem.low).max()) / longest) if longest > 0 else 1.0
        for halving in range(_HALVINGS):
            trial = np.clip(unknowns + step / 2**halving, low, high)
            found = _lagrangian(problem, trial, multipliers, prices, stiffness)
            if found[0] < value - 1e-4 * abs(((trial - unknowns) * slope).sum()):
                break
        else:
            break
        unknowns, (value, slope, curvature) = trial, found
    return (unknowns[:-1], float(unknowns[-1])) if has_top else (unknowns, 0.0)


def _lagrangian(
    problem: Problem, unknowns: Array, multipliers: Array, prices: Array, stiffness: float
) -> tuple[float, Array, Array]:
    """The augmented Lagrangian, its slope and its curvature."""
    ceilings = len(problem.ceilings.values)
    place = unknowns[:-1] if ceilings else unknowns
    axes = len(place)
    slope, curvature = np.zeros(len(unknowns)), np.zeros((len(unknowns), len(unknowns)))
    cost, cost_slope = problem.cost.at(place)
    value = float(cost[0])
    slope[:axes], curvature[:axes, :axes] = cost_slope[0], problem.cost.curvatures[0]
    slack, slopes = problem.limits.at(place)
    curvatures = problem.limits.curvatures
    if ceilings:
        value, slope[-1] = value + float(unknowns[-1]), 1.0
        heights, height_slopes = problem.ceilings.at(place)
        slack = np.concatenate([unknowns[-1] - heights, slack])
        slopes = np.concatenate([-height_slopes, slopes])
        curvatures = np.concatenate([-problem.ceilings.curvatures, curvatures])
        upward = np.zeros(len(slack))
        upward[:ceilings] = 1.0
        slopes = np.concatenate([slopes, upward[:, None]], axis=1)
    push = multipliers - stiffness * slack
    pushing, capped = push > 0, push > prices
    force = np.clip(push, 0.0, prices)
    # beyond its price a limit pushes no harder, and its penalty goes on straight
    inside = (force**2 - multipliers**2) / (2 * stiffness)
    beyond = np.where(capped, (push - prices) * prices / stiffness, 0.0)
    value += float((inside + beyond).sum())
    slope -= (force[:, None] * slopes).sum(axis=0)
    curvature[:axes, :axes] -= (force[:, None, None] * curvatures).sum(axis=0)
    bent = np.where(pushing & ~capped, stiffness, 0.0)
    curvature += (bent[:, None, None] * slopes[:, :, None] * slopes[:, None, :]).sum(axis=0)
    return value, slope, curvature


def _newton_step(slope: Array, curvature: Array, held: Flags) -> Array:
    """A step down, along what is not held, with as much damping as that takes."""
    free = np.flatnonzero(~held)
    rows = [[float(curvature[i, j]) for j in free] for i in free]
    right = [-float(slope[i]) for i in free]
    largest = max(1e-9, *(abs(rows[i][i]) for i in range(len(free))))
    step = np.zeros(len(slope))
    damping = 0.0
    while True:
        solved = solved_positive([[*row] for row in rows], right, damping)
        if solved is not None:
            step[free] = solved
            return step
        damping = max(4 * damping, 1e-6 * largest)


def solved_positive(rows: list[list[float]], right: list[float], damping: float) -> list[float] | None:
    """Solve linear equations that are symmetric and positive definite, by Cholesky; None where they are not.

    Args:
        rows: of the matrix; they are overwritten.
        right: hand side.
        damping: that is added on the diagonal.
    """
    count = len(rows)
    for i in range(count):
        for j in range(i + 1):
            total = rows[i][j] + (damping if i == j else 0.0)
            for k in range(j):
                total -= rows[i][k] * rows[j][k]
            if i == j:
                if not total > 1e-12 * (abs(rows[i][i]) + damping):
                    return None
                rows[i][i] = math.sqrt(total)
            else:
                rows[i][j] = total / rows[j][j]
    found = list(right)
    for i in range(count):
        for k in range(i):
            found[i] -= rows[i][k] * found[k]
        found[i] /= rows[i][i]
    for i in reversed(range(count)):
        for k in range(i + 1, count):
            found[i] -= rows[k][i] * found[k]
        found[i] /= rows[i][i]
    return found
