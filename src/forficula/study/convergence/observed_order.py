"""How a time goes with the timestep: its limit, and the order at which it gets there."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.serial import Key, Seconds, Written

# Of the integrator, semi-implicit Euler: Hairer, Lubich and Wanner, Geometric Numerical Integration, 2006, I.1.2.
FORMAL_ORDER = 1.0
_LOWEST_ORDER, _HIGHEST_ORDER = 0.5, 5.0
# A fit whose residuals are a larger share than this of what the times change by tells no order.
_SCATTER = 0.05
_NO_CHANGE = 1e-9


@dataclass(frozen=True, kw_only=True)
class OrderFit:
    """The law T(h) = limit + coefficient h^order through times at several timesteps.

    Attributes:
        limit: T for h -> 0, s.
        coefficient: s / s^order.
        order: observed, or the integrator's where none can be told.
        observed: whether the order is the times' own.
        reason: why it is not; empty where it is.
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
        """The order where it is the times' own, else None."""
        return self.order if self.observed else None

    @property
    def assumed_order(self) -> Annotated[float | None, Written.ALWAYS]:
        """The order where it is the integrator's, else None."""
        return None if self.observed else self.order

    def time(self, timestep: Array) -> Array:
        """The law's time at these timesteps, s."""
        return np.asarray(self.limit + self.coefficient * timestep**self.order)


def fit_order(timesteps: Array, times: Array) -> OrderFit:
    """Fit T(h) = T0 + C h^p, the law of Richardson's extrapolation, by least squares.

    For every p the best T0 and C are linear, so only p is searched. With three timesteps in a constant ratio it is the
    textbook p = log((T3 - T2) / (T2 - T1)) / log(ratio); with others and more of them, weighted least squares as in Eça
    and Hoekstra 2014 (J. Comput. Phys. 262, 104-130, doi 10.1016/j.jcp.2014.01.006). As there, the formal order is
    taken where the times show none that can be trusted: here the 1 of semi-implicit Euler.

    Args:
        timesteps: two at least, all different, s, (run,).
        times: at them, s, (run,).
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
    """T0 and C of T0 + C h^p, and the standard deviation about it, where so many of T0, C and p are fitted."""
    powers = np.column_stack([np.ones_like(scaled), scaled**order])
    # short timesteps count for more, by 1 / h: they are nearer to where the law holds
    weights = len(scaled) / scaled / np.sum(1 / scaled)
    root = np.sqrt(weights)
    solution = np.linalg.lstsq(powers * root[:, None], times * root, rcond=None)[0]
    residual = times - powers @ solution
    freedom = max(1, len(times) - fitted)
    return float(solution[0]), float(solution[1]), float(np.sqrt(np.sum(weights * residual**2) / freedom))


def _best_order(scaled: Array, times: Array) -> float:
    """The p of the least squares; a coarse search first, for there may be more than one dip."""

    def misfit(order: float) -> float:
        return _linear_fit(scaled, times, order)[2]

    orders = np.geomspace(_LOWEST_ORDER, _HIGHEST_ORDER, 47)
    least = int(np.argmin([misfit(order) for order in orders]))
    bounds = orders[max(0, least - 1)], orders[min(len(orders) - 1, least + 1)]
    return float(scipy.optimize.minimize_scalar(misfit, bounds=bounds, method="bounded", options={"xatol": 1e-6}).x)
