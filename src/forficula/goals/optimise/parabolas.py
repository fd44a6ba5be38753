"""Parabolas through the trials around a point, and the position of their optimum within the limits.

Near a base b of the unit cube every objective f and every margin g of a limit is modelled as

    q(s) = q0 + a.s + s.C s / 2,    s = x - b,

over all axes except choices. The coefficients are fitted to the trials nearest to the base, with weights that decrease
with the distance. n axes have (n + 1) (n + 2) / 2 coefficients, and up to twice as many trials are fitted. If there are
too few trials for a parabola, a plane is fitted, C = 0. The proposed point is b + s, where the step s is the solution
of

    minimise    t + 0.001 sum_i f_i(s) + sum_j p_j v_j
    subject to  w_i f_i(s) <= t,  g_j(s) + v_j >= d,  v_j >= 0,  |s| <= R,  0 <= b + s <= 1.

The auxiliary t turns the greatest of the weighted objectives (Steuer and Choo, 1983, doi.org/10.1007/BF02591870) into
smooth constraints. The violations v_j make the problem solvable even if no step meets all limits. They have an exact
penalty with prices p_j above any multiplier, so limits are met if possible, and otherwise missed by as little as
possible (the elastic mode of Gill, Murray and Saunders, 2005, doi.org/10.1137/S0036144504446096). The distance d from
the limits and the reach R differ between proposals, to compensate for errors of the parabolas. The problem has a few
variables and is solved by SciPy's SLSQP (Kraft, 1988).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import scipy

from forficula.arrays import Array, Flags, Indices
from forficula.goals.optimise.trials import Archive, Axis, Point, Trial, placed

# Weight of the sum of all objectives beside the greatest one, so that no objective is worsened without benefit.
_SUM = 1e-3
# Price of missing a limit by its whole bound, in spans of the objectives: more than any objective can gain.
_PRICE, _LEAST_SPAN = 100.0, 1e-12
# Price of a limit that is to be relaxed, as a fraction of the full price.
_GIVING = 0.1
# Trials closer than this fraction of their distance from the base add nothing to a fit.
_APART = 0.02
_TRIALS_PER_COEFFICIENT = 2
# Distance, as a fraction of the radius, at which the weight of a trial is half of that at the base.
_NEAR = 0.1
_LEAST_RADIUS = 1e-6
# Singular values below this fraction of the largest belong to coefficients that the trials do not determine.
_UNDETERMINED = 1e-8
_PRECISION, _STEPS = 1e-15, 100


@dataclass(frozen=True, kw_only=True)
class Aim:
    """Function that a proposal minimises: the greatest of the weighted objectives.

    Attributes:
        weights: one per objective.
        ideal: least value of each objective so far.
        span: range of each objective over the front.
    """

    weights: Array
    ideal: Array
    span: Array

    def shares(self, objectives: Array) -> Array:
        """Return objectives, scaled from 0 at the ideal to 1 at the end of the span."""
        return (objectives - self.ideal) / self.span

    def values(self, objectives: Array) -> Array:
        """Return the value of each row of objectives."""
        shares = self.shares(objectives)
        return np.asarray((self.weights * shares).max(axis=1) + _SUM * shares.sum(axis=1))


@dataclass(frozen=True, kw_only=True)
class Parabola:
    """Quadratic model of a quantity near a base.

    Attributes:
        value: value at the base.
        slope: derivatives with respect to the coordinates of the free axes.
        curvature: second derivatives, symmetric.
        span: range of the fitted values.
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
        free: axes that vary: all except choices.
        radius: distance of the farthest trial.
        objectives: objectives as parabolas, scaled from 0 at the ideal to 1 at the end of the span.
        margins: margins as parabolas, by index of the limit, if enough trials are known.
    """

    base: Trial
    free: Flags
    radius: float
    objectives: tuple[Parabola, ...]
    margins: Mapping[int, Parabola]


def neighbourhood(axes: Sequence[Axis], archive: Archive, base: Trial, aim: Aim) -> Neighbourhood | None:
    """Fit parabolas to the trials around a base; None if there are too few for planes."""
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
    """Return indices of the points nearest to a base, the nearest first, without those that nearly coincide.

    Args:
        points: one per row.
        away: distances from the base.
        count: largest number of points.
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
    """Fit a parabola to values near a base, or a plane if there are too few.

    Args:
        points: coordinates on the free axes, one point per row.
        values: values of a quantity at these points.
        centre: the base.
    """
    steps = points - centre
    # normalised, so that squares of small steps are not much smaller than the steps
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
    """Return the number of coefficients of a parabola over some axes."""
    return (axes + 1) * (axes + 2) // 2


def proposed(
    axes: Sequence[Axis], near: Neighbourhood, aim: Aim, reach: float, back: float, giving: int | None = None
) -> Point:
    """Return the point where the parabolas of a neighbourhood have the optimum of an aim within the limits.

    Stepped axes are rounded to their steps first; then the optimum over the other axes is computed.

    Args:
        axes: axes of the search.
        near: neighbourhood with the parabolas.
        aim: aim to be minimised.
        reach: the longest step, as a fraction of the neighbourhood's radius.
        back: distance to keep from the limits, as a fraction of the span of their margins.
        giving: index of the limit to relax if not all can be met; None to treat all equally.
    """
    centre = np.array(near.base.point)
    low = np.maximum(-reach * near.radius, -centre[near.free])
    high = np.minimum(reach * near.radius, 1 - centre[near.free])
    stepped = np.array([axis.levels > 0 for axis in axes])[near.free]
    point = centre.copy()
    point[near.free] += _optimum(near, aim, low, high, back, giving)
    (rounded,) = placed(axes, point[None, :])
    if stepped.any() and not stepped.all():
        fixed = (np.array(rounded) - centre)[near.free]
        step = _optimum(near, aim, np.where(stepped, fixed, low), np.where(stepped, fixed, high), back, giving)
        point[near.free] = centre[near.free] + step
        (rounded,) = placed(axes, point[None, :])
    return rounded


def _optimum(near: Neighbourhood, aim: Aim, low: Array, high: Array, back: float, giving: int | None) -> Array:
    """Return the step, in unit-cube coordinates, that minimises an aim within bounds.

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
            {"type": "ineq", "fun": lambda x, of=of: of(x)[0], "jac": lambda x, of=of: of(x)[1]}
            for of in ((margins, ceilings) if near.margins else (ceilings,))
        ],
        options={"ftol": _PRECISION, "maxiter": _STEPS},
    )
    step = solution.x[:count]
    return np.clip(radius * np.where(np.isfinite(step), step, 0.0), low, high)


def _at(parabolas: Sequence[Parabola], step: Array) -> tuple[Array, Array]:
    """Return values and slopes of parabolas after a step, one row each."""
    bent = np.array([parabola.curvature @ step for parabola in parabolas]).reshape(-1, len(step))
    slopes = np.array([parabola.slope for parabola in parabolas]).reshape(-1, len(step))
    values = np.array([parabola.value for parabola in parabolas])
    return values + (slopes + bent / 2) @ step, slopes + bent
