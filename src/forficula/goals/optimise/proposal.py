"""Where parabolas through the trials around a point have their optimum within the limits."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import optimize

from forficula.goals.optimise.archive import SUM, Aim, Archive
from forficula.goals.optimise.axis import Axis, Point, placed
from forficula.goals.optimise.local_model import LEAST_RADIUS, Parabola, fitted, nearby, wanted_trials
from forficula.goals.optimise.trial import Trial

Array = NDArray[np.float64]

# What a violation of limits costs, in spans of the objectives: more than any objective can win.
_VIOLATION = 100.0
_ITERATIONS = 60


@dataclass(frozen=True, kw_only=True)
class Neighbourhood:
    """The trials that are near enough to a base to say what is around it.

    Attributes:
        base: in whose middle it lies.
        free: which axes vary: all but choices.
        radius: distance of the furthest trial.
        objectives: as parabolas, from 0 at the ideal to 1 at the end of the span.
        margins: as parabolas, those of limits of which enough is known.
    """

    base: Trial
    free: NDArray[np.bool_]
    radius: float
    objectives: tuple[Parabola, ...]
    margins: tuple[Parabola, ...]


def neighbourhood(axes: Sequence[Axis], archive: Archive, base: Trial, aim: Aim) -> Neighbourhood | None:
    """What the trials around a base say; None where they are too few for planes."""
    free = np.array([axis.ordered for axis in axes])
    if not free.any():
        return None
    centre = np.array(base.point)
    alike = (archive.points[:, ~free] == centre[~free]).all(axis=1)
    points = archive.points[alike][:, free]
    away = np.abs(points - centre[free]).max(axis=1)
    objectives, margins = aim.shares(archive.objectives[alike]), archive.margins[alike]
    found: list[Parabola | None] = []
    radius = 1.0
    for values in (*objectives.T, *margins.T):
        known = np.isfinite(values)
        near = nearby(points[known], away[known], wanted_trials(int(free.sum())))
        if len(near) < free.sum() + 2:
            found.append(None)
            continue
        radius = min(radius, max(float(away[known][near[-1]]), LEAST_RADIUS))
        found.append(fitted(points[known][near], values[known][near], centre[free]))
    of_objectives = tuple(each for each in found[: len(aim.ideal)] if each is not None)
    of_margins = tuple(each for each in found[len(aim.ideal) :] if each is not None)
    if len(of_objectives) < len(aim.ideal):
        return None
    return Neighbourhood(base=base, free=free, radius=radius, objectives=of_objectives, margins=of_margins)


def proposed(axes: Sequence[Axis], near: Neighbourhood, aim: Aim, reach: float, back: float) -> Point:
    """Where the parabolas of a neighbourhood have the least of an aim within the limits.

    Stepped axes are put on their places first, and the others then follow.

    Args:
        axes: of the search.
        near: whose parabolas are used.
        aim: that is to be small.
        reach: how far to go at most, as a share of the neighbourhood's radius.
        back: how far to stay within the limits, as a share of what their margins differ by.
    """
    centre = np.array(near.base.point)
    low = np.maximum(-reach * near.radius, -centre[near.free])
    high = np.minimum(reach * near.radius, 1 - centre[near.free])
    stepped = np.array([axis.levels > 0 for axis in axes])[near.free]
    step = _least(near, aim, low, high, back)
    found = centre.copy()
    found[near.free] += step
    (point,) = placed(axes, found[None, :])
    if stepped.any() and not stepped.all():
        fixed = (np.array(point) - centre)[near.free]
        step = _least(near, aim, np.where(stepped, fixed, low), np.where(stepped, fixed, high), back)
        found[near.free] = centre[near.free] + step
        (point,) = placed(axes, found[None, :])
    return point


def _least(near: Neighbourhood, aim: Aim, low: Array, high: Array, back: float) -> Array:
    """The step that makes the aim small: by sequential quadratic programming over step, worst objective, violation.

    Kraft, 1988, DFVLR-FB 88-28. Limits may be violated at a price, so that there is a step where no step meets them.
    """
    free, radius = len(low), near.radius
    weighted = list(zip(aim.weights, near.objectives, strict=True))

    def cost(unknowns: Array) -> float:
        step = radius * unknowns[:free]
        return float(unknowns[free] + _VIOLATION * unknowns[free + 1]) + SUM * sum(
            each.at(step) for each in near.objectives
        )

    def cost_slope(unknowns: Array) -> Array:
        step = radius * unknowns[:free]
        slope = radius * SUM * sum(each.slope_at(step) for each in near.objectives)
        return np.array([*slope, 1.0, _VIOLATION])

    def slack(unknowns: Array) -> Array:
        step, worst, violated = radius * unknowns[:free], unknowns[free], unknowns[free + 1]
        under = [worst - weight * each.at(step) for weight, each in weighted]
        return np.array(under + [each.at(step) + violated - back * each.span for each in near.margins])

    def slack_slope(unknowns: Array) -> Array:
        step = radius * unknowns[:free]
        under = [[*(-weight * radius * each.slope_at(step)), 1.0, 0.0] for weight, each in weighted]
        return np.array(under + [[*(radius * each.slope_at(step)), 0.0, 1.0] for each in near.margins])

    middle = np.clip(0.0, low, high)
    worst = max(weight * each.at(middle) for weight, each in weighted)
    violated = max((-each.at(middle) for each in near.margins), default=0.0)
    with warnings.catch_warnings():
        # a start that rounding puts a hair outside of the bounds is none of the user's business
        warnings.simplefilter("ignore", RuntimeWarning)
        solution = optimize.minimize(
            cost,
            np.array([*(middle / radius), worst, max(violated, 0.0)]),
            jac=cost_slope,
            method="SLSQP",
            bounds=[*zip(low / radius, high / radius, strict=True), (None, None), (0.0, None)],
            constraints={"type": "ineq", "fun": slack, "jac": slack_slope},
            options={"maxiter": _ITERATIONS},
        )
    step = radius * np.asarray(solution.x[:free], dtype=float)
    return np.asarray(np.clip(np.where(np.isfinite(step), step, middle), low, high))
