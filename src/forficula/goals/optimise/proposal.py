"""Where parabolas through the trials around a point have their optimum within the limits."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Flags
from forficula.goals.optimise.archive import SUM, Aim, Archive
from forficula.goals.optimise.axis import Axis, Point, placed
from forficula.goals.optimise.least_on_parabolas import Parabolas, Problem, least_place
from forficula.goals.optimise.local_model import LEAST_RADIUS, Parabola, fitted, nearby, wanted_trials
from forficula.goals.optimise.trial import Trial

# What a violation of limits costs, in spans of the objectives: more than any objective can win.
_PRICE, _LEAST_SPAN = 100.0, 1e-12
# What it costs of a limit that is to give, as a share of that.
_GIVING = 0.1


@dataclass(frozen=True, kw_only=True)
class Neighbourhood:
    """The trials that are near enough to a base to say what is around it.

    Attributes:
        base: in whose middle it lies.
        free: which axes vary: all but choices.
        radius: distance of the furthest trial.
        objectives: as parabolas, from 0 at the ideal to 1 at the end of the span.
        margins: as parabolas, by number of the limit, those of which enough is known.
    """

    base: Trial
    free: Flags
    radius: float
    objectives: tuple[Parabola, ...]
    margins: Mapping[int, Parabola]


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
    of_margins = {number: each for number, each in enumerate(found[len(aim.ideal) :]) if each is not None}
    if len(of_objectives) < len(aim.ideal):
        return None
    return Neighbourhood(base=base, free=free, radius=radius, objectives=of_objectives, margins=of_margins)


def proposed(
    axes: Sequence[Axis], near: Neighbourhood, aim: Aim, reach: float, back: float, giving: int | None = None
) -> Point:
    """Where the parabolas of a neighbourhood have the least of an aim within the limits.

    Stepped axes are put on their places first, and the others then follow.

    Args:
        axes: of the search.
        near: whose parabolas are used.
        aim: that is to be small.
        reach: how far to go at most, as a share of the neighbourhood's radius.
        back: how far to stay within the limits, as a share of what their margins differ by.
        giving: the limit that is to give where not all can be met, by number; None where all count alike.
    """
    centre = np.array(near.base.point)
    low = np.maximum(-reach * near.radius, -centre[near.free])
    high = np.minimum(reach * near.radius, 1 - centre[near.free])
    stepped = np.array([axis.levels > 0 for axis in axes])[near.free]
    step = _least(near, aim, low, high, back, giving)
    found = centre.copy()
    found[near.free] += step
    (point,) = placed(axes, found[None, :])
    if stepped.any() and not stepped.all():
        fixed = (np.array(point) - centre)[near.free]
        step = _least(near, aim, np.where(stepped, fixed, low), np.where(stepped, fixed, high), back, giving)
        found[near.free] = centre[near.free] + step
        (point,) = placed(axes, found[None, :])
    return point


def _least(near: Neighbourhood, aim: Aim, low: Array, high: Array, back: float, giving: int | None) -> Array:
    """The step, as shares, that makes the aim small within bounds."""
    radius = near.radius
    weights = np.array([1.0]) if len(aim.weights) == 1 else aim.weights
    of_aim = [_scaled(each, radius, weight, 0.0) for each, weight in zip(near.objectives, weights, strict=True)]
    every = [_scaled(each, radius, 1.0, 0.0) for each in near.objectives]
    spans = {number: max(each.span, _LEAST_SPAN) for number, each in near.margins.items()}
    limits = [_scaled(each, radius, 1 / spans[number], -back) for number, each in near.margins.items()]
    axes = len(low)
    total = _joined(every, axes)
    if len(of_aim) == 1:
        cost, ceilings = _joined(of_aim, axes), _joined([], axes)
    else:
        cost = Parabolas(
            values=SUM * total.values.sum(keepdims=True),
            slopes=SUM * total.slopes.sum(axis=0, keepdims=True),
            curvatures=SUM * total.curvatures.sum(axis=0, keepdims=True),
        )
        ceilings = _joined(of_aim, axes)
    problem = Problem(
        cost=cost,
        ceilings=ceilings,
        limits=_joined(limits, axes),
        prices=np.array([_PRICE * span * (_GIVING if number == giving else 1) for number, span in spans.items()]),
        low=low / radius,
        high=high / radius,
    )
    start = np.clip(np.zeros(axes), problem.low, problem.high)
    return np.clip(radius * least_place(problem, start), low, high)


def _scaled(parabola: Parabola, radius: float, weight: float, shift: float) -> Parabolas:
    """A weighted parabola over steps in radii, shifted."""
    return Parabolas(
        values=np.array([weight * parabola.value + shift]),
        slopes=weight * radius * parabola.slope[None, :],
        curvatures=weight * radius**2 * parabola.curvature[None, :, :],
    )


def _joined(parabolas: Sequence[Parabolas], axes: int) -> Parabolas:
    return Parabolas(
        values=np.concatenate([np.zeros(0), *(each.values for each in parabolas)]),
        slopes=np.concatenate([np.zeros((0, axes)), *(each.slopes for each in parabolas)]),
        curvatures=np.concatenate([np.zeros((0, axes, axes)), *(each.curvatures for each in parabolas)]),
    )
