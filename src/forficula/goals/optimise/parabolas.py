"""Parabolas through the trials around a point, and where they have their optimum within the limits.

Near a base b of the unit cube every objective f and every margin g of a limit is modelled as

    q(s) = q0 + a.s + s.C s / 2,    s = x - b,

over all axes but choices. The coefficients fit the trials nearest to the base with weights that fall with the distance;
n axes have (n + 1) (n + 2) / 2 coefficients, and twice as many trials are fitted where there are as many. Too few
trials for a parabola get a plane, C = 0. The proposed point is b + s, where the step s is the solution of

    minimise    t + 0.001 sum_i f_i(s) + sum_j p_j v_j
    subject to  w_i f_i(s) <= t,  g_j(s) + v_j >= d,  v_j >= 0,  |s| <= R,  0 <= b + s <= 1.

The auxiliary t turns the greatest of the weighted objectives (Steuer and Choo, 1983, doi.org/10.1007/BF02591870) into
smooth constraints. The violations v_j make the problem solvable where no step meets all limits: they cost an exact
penalty with prices p_j above any multiplier, so that limits are met where they can be and are otherwise missed by as
little as possible (the elastic mode of Gill, Murray and Saunders, 2005, doi.org/10.1137/S0036144504446096). A distance
d from the limits and a reach R, which differ from proposal to proposal, make up for what the parabolas miss. The
problem has a few variables and is solved by SciPy's SLSQP (Kraft, 1988).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import scipy

from forficula.arrays import Array, Flags, Indices
from forficula.goals.optimise.trials import Archive, Axis, Point, Trial, placed

# Share of the sum of all objectives beside the greatest of them, so that none is given away for nothing.
_SUM = 1e-3
# Price of missing a limit by the whole of its bound, in spans of the objectives: more than any objective can win.
_PRICE, _LEAST_SPAN = 100.0, 1e-12
# Price of a limit that is to give, as a share of that.
_GIVING = 0.1
# Trials that nearly coincide, as shares of their distance from the base, add nothing to a fit.
_APART = 0.02
_TRIALS_PER_COEFFICIENT = 2
# Distance, as a share of the radius, at which a trial counts half as much as one at the base.
_NEAR = 0.1
_LEAST_RADIUS = 1e-6
# Singular values below this share of the largest belong to coefficients that the trials do not determine.
_UNDETERMINED = 1e-8
_PRECISION, _STEPS = 1e-15, 100


@dataclass(frozen=True, kw_only=True)
class Aim:
    """What a proposal is to minimise: the greatest of the weighted objectives.

    Attributes:
        weights: one an objective.
        ideal: the least value of each objective so far.
        span: the range of each objective over the front.
    """

    weights: Array
    ideal: Array
    span: Array

    def shares(self, objectives: Array) -> Array:
        """Objectives, counted from 0 at the ideal to 1 at the end of the span."""
        return (objectives - self.ideal) / self.span

    def values(self, objectives: Array) -> Array:
        """Compute the value of each row of objectives."""
        shares = self.shares(objectives)
        return np.asarray((self.weights * shares).max(axis=1) + _SUM * shares.sum(axis=1))


@dataclass(frozen=True, kw_only=True)
class Parabola:
    """A quantity near a base.

    Attributes:
        value: at the base.
        slope: derivatives with respect to the shares of the free axes.
        curvature: second derivatives, symmetric.
        span: range of the values that it was fitted to.
    """

    value: float
    slope: Array
    curvature: Array
    span: float


@dataclass(frozen=True, kw_only=True)
class Neighbourhood:
    """Parabolas through the trials around a base.

    Attributes:
        base: the trial in the middle.
        free: which axes vary: all but choices.
        radius: distance of the farthest trial.
        objectives: as parabolas, from 0 at the ideal to 1 at the end of the span.
        margins: as parabolas, by number of the limit, where enough trials are known.
    """

    base: Trial
    free: Flags
    radius: float
    objectives: tuple[Parabola, ...]
    margins: Mapping[int, Parabola]


def neighbourhood(axes: Sequence[Axis], archive: Archive, base: Trial, aim: Aim) -> Neighbourhood | None:
    """Fit parabolas to the trials around a base; None where they are too few for planes."""
    free = np.array([axis.ordered for axis in axes])
    if not free.any():
        return None
    centre = np.array(base.point)
    same_choices = (archive.points[:, ~free] == centre[~free]).all(axis=1)
    points = archive.points[same_choices][:, free]
    away = np.abs(points - centre[free]).max(axis=1)
    objectives, margins = aim.shares(archive.objectives[same_choices]), archive.margins[same_choices]
    fits: list[Parabola | None] = []
    radius = 1.0
    for values in (*objectives.T, *margins.T):
        known = np.isfinite(values)
        near = _nearest(points[known], away[known], _TRIALS_PER_COEFFICIENT * _coefficients(int(free.sum())))
        if len(near) < free.sum() + 2:
            fits.append(None)
            continue
        radius = min(radius, max(float(away[known][near[-1]]), _LEAST_RADIUS))
        fits.append(_fitted(points[known][near], values[known][near], centre[free]))
    of_objectives = tuple(fit for fit in fits[: len(aim.ideal)] if fit is not None)
    of_margins = {number: fit for number, fit in enumerate(fits[len(aim.ideal) :]) if fit is not None}
    if len(of_objectives) < len(aim.ideal):
        return None
    return Neighbourhood(base=base, free=free, radius=radius, objectives=of_objectives, margins=of_margins)


def _nearest(points: Array, away: Array, count: int) -> Indices:
    """Numbers of the points nearest to a base, the nearest first, without those that nearly coincide.

    Args:
        points: one row each.
        away: their distances from the base.
        count: how many at most.
    """
    chosen: list[int] = []
    for number in np.argsort(away, kind="stable")[: 4 * count]:
        if len(chosen) == count:
            break
        apart = np.abs(points[chosen] - points[number]).max(axis=1) if chosen else np.ones(1)
        if apart.min() > _APART * away[number]:
            chosen.append(int(number))
    return np.array(chosen, dtype=np.int64)


def _fitted(points: Array, values: Array, centre: Array) -> Parabola:
    """The parabola that best fits values near a base; a plane where there are too few of them.

    Args:
        points: places on the free axes, one row each.
        values: of a quantity there.
        centre: the base.
    """
    steps = points - centre
    # so that squares of small steps are no smaller than the steps
    radius = max(float(np.abs(steps).max()), _LEAST_RADIUS)
    steps = steps / radius
    count, axes = steps.shape
    rows, columns = np.triu_indices(axes)
    terms = [np.ones((count, 1)), steps]
    if count >= _coefficients(axes) + 2:
        terms.append(steps[:, rows] * steps[:, columns])
    weights = 1 / (_NEAR + np.abs(steps).max(axis=1))
    solution, *_ = np.linalg.lstsq(np.hstack(terms) * weights[:, None], values * weights, rcond=_UNDETERMINED)
    curvature = np.zeros((axes, axes))
    if len(terms) > 2:
        np.add.at(curvature, (rows, columns), solution[1 + axes :])
        curvature += curvature.T
    return Parabola(
        value=float(solution[0]),
        slope=solution[1 : 1 + axes] / radius,
        curvature=curvature / radius**2,
        span=float(np.ptp(values)),
    )


def _coefficients(axes: int) -> int:
    """How many coefficients a parabola over some axes has."""
    return (axes + 1) * (axes + 2) // 2


def proposed(
    axes: Sequence[Axis], near: Neighbourhood, aim: Aim, reach: float, back: float, giving: int | None = None
) -> Point:
    """Return the point where the parabolas of a neighbourhood have the optimum of an aim within the limits.

    Stepped axes are rounded to their places first; the optimum over the others then follows.

    Args:
        axes: of the search.
        near: whose parabolas are used.
        aim: to be minimised.
        reach: the longest step, as a share of the neighbourhood's radius.
        back: distance to keep from the limits, as a share of the span of their margins.
        giving: number of the limit that is to give where not all can be met; None where all count the same.
    """
    centre = np.array(near.base.point)
    low = np.maximum(-reach * near.radius, -centre[near.free])
    high = np.minimum(reach * near.radius, 1 - centre[near.free])
    stepped = np.array([axis.levels > 0 for axis in axes])[near.free]
    point = centre.copy()
    point[near.free] += _optimum(near, aim, low, high, back, giving)
    (place,) = placed(axes, point[None, :])
    if stepped.any() and not stepped.all():
        fixed = (np.array(place) - centre)[near.free]
        step = _optimum(near, aim, np.where(stepped, fixed, low), np.where(stepped, fixed, high), back, giving)
        point[near.free] = centre[near.free] + step
        (place,) = placed(axes, point[None, :])
    return place


def _optimum(near: Neighbourhood, aim: Aim, low: Array, high: Array, back: float, giving: int | None) -> Array:
    """The step, as shares, that minimises an aim within bounds.

    The unknowns are the step in radii, the violation of every limit in spans of its margin, and t.
    """
    count, radius = len(low), near.radius
    spans = np.array([max(margin.span, _LEAST_SPAN) for margin in near.margins.values()])
    prices = _PRICE * spans * np.array([_GIVING if number == giving else 1.0 for number in near.margins])
    violations = np.eye(len(spans), len(spans) + 1)

    def margins(unknowns: Array) -> tuple[Array, Array]:
        values, slopes = _at([*near.margins.values()], radius * unknowns[:count])
        slopes = radius * slopes / spans[:, None]
        return values / spans - back + unknowns[count:-1], np.hstack([slopes, violations])

    def ceilings(unknowns: Array) -> tuple[Array, Array]:
        values, slopes = _at(near.objectives, radius * unknowns[:count])
        slopes = np.hstack([-radius * aim.weights[:, None] * slopes, np.zeros((len(values), len(spans) + 1))])
        slopes[:, -1] = 1.0
        return unknowns[-1] - aim.weights * values, slopes

    def cost(unknowns: Array) -> tuple[float, Array]:
        values, slopes = _at(near.objectives, radius * unknowns[:count])
        slope = np.concatenate([_SUM * radius * slopes.sum(axis=0), prices, [1.0]])
        return float(_SUM * values.sum() + prices @ unknowns[count:-1] + unknowns[-1]), slope

    start = np.concatenate([np.clip(np.zeros(count), low, high) / radius, np.zeros(len(spans) + 1)])
    start[count:-1] = np.maximum(-margins(start)[0], 0.0)
    start[-1] = -ceilings(start)[0].min()
    solution = scipy.optimize.minimize(
        cost,
        start,
        jac=True,
        method="SLSQP",
        bounds=[*zip(low / radius, high / radius, strict=True), *[(0.0, None)] * len(spans), (None, None)],
        constraints=[
            {"type": "ineq", "fun": lambda each, of=of: of(each)[0], "jac": lambda each, of=of: of(each)[1]}
            for of in ((margins, ceilings) if near.margins else (ceilings,))
        ],
        options={"ftol": _PRECISION, "maxiter": _STEPS},
    )
    step = solution.x[:count]
    return np.clip(radius * np.where(np.isfinite(step), step, 0.0), low, high)


def _at(parabolas: Sequence[Parabola], step: Array) -> tuple[Array, Array]:
    """Values and slopes of parabolas after a step, one row each."""
    bent = np.array([parabola.curvature @ step for parabola in parabolas]).reshape(-1, len(step))
    slopes = np.array([parabola.slope for parabola in parabolas]).reshape(-1, len(step))
    values = np.array([parabola.value for parabola in parabolas])
    return values + (slopes + bent / 2) @ step, slopes + bent
