"""Convergence of a time with the timestep: its limit and its observed order."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.serial import Key, Seconds, Written

# Order of the integrator, semi-implicit Euler: Hairer, Lubich and Wanner, Geometric Numerical Integration, 2006, I.1.2.
FORMAL_ORDER = 1.0
_LOWEST_ORDER, _HIGHEST_ORDER = 0.5, 5.0
# No order is reported if the residuals exceed this fraction of the change of the times.
_SCATTER = 0.05
_NO_CHANGE = 1e-9


@dataclass(frozen=True, kw_only=True)
class OrderFit:
    """Law T(h) = limit + coefficient h^order fitted to times at several timesteps.

    Attributes:
        limit: T for h -> 0, s.
        coefficient: s / s^order.
        order: the observed order, or that of the integrator if no order can be observed.
        observed: whether the order was observed.
        reason: why no order was observed; empty if it was.
        scatter: standard deviation of the times about the law, s.
    """

    limit: Seconds
    coefficient: Annotated[float, Written.NEVER]
    order: Annotated[float, Written.NEVER]
    observed: Annotated[bool, Written.NEVER]
    reason: Annotated[str, Key("why_not_observed")]
    scatter: Seconds

    @property
    def observed_order(self) -> Annotated[float | None, Written.ALWAYS]:
        """The observed order; None if the integrator's order was assumed."""
        return self.order if self.observed else None

    @property
    def assumed_order(self) -> Annotated[float | None, Written.ALWAYS]:
        """The integrator's order if it was assumed; None if an order was observed."""
        return None if self.observed else self.order

    def time(self, timestep: Array) -> Array:
        """Return the time of the law at these timesteps, s."""
        return np.asarray(self.limit + self.coefficient * timestep**self.order)


def fit_order(timesteps: Array, times: Array) -> OrderFit:
    """Fit T(h) = T0 + C h^p, the law of Richardson's extrapolation, by least squares.

    For every p the best T0 and C are linear, so only p is searched. With three timesteps in a constant ratio, p is the
    textbook log((T3 - T2) / (T2 - T1)) / log(ratio). In all other cases, weighted least squares are used, as in Eça
    and Hoekstra 2014 (J. Comput. Phys. 262, 104-130, doi 10.1016/j.jcp.2014.01.006). As in that paper, the formal order
    is assumed if the times show no reliable one: here 1, the order of semi-implicit Euler.

    Args:
        timesteps: at least two, all different, s, (run,).
        times: time at each timestep, s, (run,).
    """
    scaled = timesteps / timesteps.max()
    change = float(np.ptp(times))
    limit, coefficient, scatter = _linear_fit(scaled, times, FORMAL_ORDER, fitted=2)
    order, reason = FORMAL_ORDER, ""
    if change <= _NO_CHANGE * float(np.abs(times).max()):
        reason = "it does not change"
    elif len(times) < 3:
        reason = "three timesteps are needed"
    else:
        best = _best_order(scaled, times)
        fitted = _linear_fit(scaled, times, best)
        if fitted[2] > _SCATTER * change:
            reason = f"it scatters by {100 * fitted[2] / change:.2g} % of its change"
        elif not 1.01 * _LOWEST_ORDER < best < 0.99 * _HIGHEST_ORDER:
            reason = f"none from {_LOWEST_ORDER:g} to {_HIGHEST_ORDER:g} fits"
        else:
            order, (limit, coefficient, scatter) = best, fitted
    return OrderFit(
        limit=limit,
        coefficient=coefficient / float(timesteps.max()) ** order,
        order=order,
        observed=not reason,
        reason=reason,
        scatter=scatter,
    )


def _linear_fit(scaled: Array, times: Array, order: float, fitted: int = 3) -> tuple[float, float, float]:
    """Return T0 and C of T0 + C h^p, and the standard deviation about it, with `fitted` fitted parameters."""
    powers = np.column_stack([np.ones_like(scaled), scaled**order])
    # short timesteps have larger weights, 1 / h, because the law holds for h -> 0
    weights = len(scaled) / scaled / np.sum(1 / scaled)
    root = np.sqrt(weights)
    solution = np.linalg.lstsq(powers * root[:, None], times * root, rcond=None)[0]
    residual = times - powers @ solution
    freedom = max(1, len(times) - fitted)
    return float(solution[0]), float(solution[1]), float(np.sqrt(np.sum(weights * residual**2) / freedom))


def _best_order(scaled: Array, times: Array) -> float:
    """Return the p with the least squares. A coarse search comes first, because there may be several minima."""

    def misfit(order: float) -> float:
        return _linear_fit(scaled, times, order)[2]

    orders = np.geomspace(_LOWEST_ORDER, _HIGHEST_ORDER, 47)
    least = int(np.argmin([misfit(order) for order in orders]))
    bounds = orders[max(0, least - 1)], orders[min(len(orders) - 1, least + 1)]
    return float(scipy.optimize.minimize_scalar(misfit, bounds=bounds, method="bounded", options={"xatol": 1e-6}).x)
