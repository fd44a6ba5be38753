"""Drift: the change of a value over the cycles of a test."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Literal, get_args

import numpy as np
import scipy
from numpy.typing import ArrayLike

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.quantities import as_written
from forficula.serial import Key, Written

Kind = Literal["none", "logarithm", "plateau"]

_FEWEST_CYCLES = 3
_FEWEST_FOR_PLATEAU = 5
_FLOOR = 1e-12  # smaller misfits are rounding


@dataclass(frozen=True, kw_only=True)
class Drift:
    """A change over the cycles of a test at constant amplitude.

    Attributes:
        kind: "none" if the data show no drift; "logarithm", rate ln N; or "plateau", rate (1 - exp(-(N - 1) / cycles)).
        rate: rate of the change.
        interval: 95 % confidence interval of the rate.
        cycles: decay constant of the approach to a plateau, in cycles; 0 for other kinds.
        relative: whether the change is in the logarithm of the value, or in the value itself.
        seen: first and last cycle of the data; outside, the drift is extrapolated.

    Raises:
        InputError: numbers that do not define a drift.
    """

    kind: Kind
    rate: float
    interval: Annotated[tuple[float, float], Key("rate_interval_95")]
    cycles: Annotated[float, Written.NEVER]
    relative: bool
    seen: Annotated[tuple[int, int], Key("seen_cycles")]

    @property
    def plateau_cycles(self) -> Annotated[float | None, Written.ALWAYS]:
        """Decay constant of the approach to a plateau, in cycles; None for other kinds."""
        return self.cycles if self.kind == "plateau" else None

    def __post_init__(self) -> None:
        if self.kind not in get_args(Kind):
            raise InputError(f"kind: need one of {', '.join(get_args(Kind))}, got {as_written(self.kind)}")
        if not 1 <= self.seen[0] < self.seen[1]:
            raise InputError(f"seen: need the first and the last cycle, from 1 on, got {list(self.seen)}")
        if not (math.isfinite(self.rate) and self.interval[0] <= self.rate <= self.interval[1]):
            raise InputError(f"rate: need a number within its interval {list(self.interval)}, got {self.rate:g}")
        if self.kind == "none" and self.rate != 0:
            raise InputError(f'rate: need 0 with kind = "none", got {self.rate:g}')
        if not math.isfinite(self.cycles) or (self.cycles > 0) != (self.kind == "plateau"):
            raise InputError(f"cycles: need > 0 for a plateau, 0 for the others, got {self.cycles:g}")

    def change(self, cycle: float) -> tuple[float, float, float]:
        """Compute the change from the first cycle of the data to another cycle.

        Args:
            cycle: number of the cycle, >= 1, where 1 is the first cycle of the test.

        Returns:
            The change and the two ends of its 95 % confidence interval: factors if the drift is relative, otherwise
            differences in the value's unit.

        Raises:
            InputError: the cycle is not >= 1 and finite.
        """
        if not (math.isfinite(cycle) and cycle >= 1):
            raise InputError(f"cycle: need >= 1, got {cycle:g}")
        shape = float(_shape(self.kind, np.array([float(cycle)]), self.cycles)[0])
        shape -= float(_shape(self.kind, np.array([float(self.seen[0])]), self.cycles)[0])
        low, high = sorted((self.interval[0] * shape, self.interval[1] * shape))
        middle = self.rate * shape
        return (math.exp(middle), math.exp(low), math.exp(high)) if self.relative else (middle, low, high)


def fit_drift(cycles: Sequence[int], values: ArrayLike, *, relative: bool = True) -> Drift:
    """Fit the drift of a value over cycles of constant amplitude.

    Three drifts are compared by the Bayesian information criterion, each with a separate level for every specimen: no
    drift; one that is proportional to the logarithm of the cycle (the usual one in this field; a power law if it is
    relative); and one that approaches a plateau. A value may rise or fall: some thermoplastic elastomers stiffen
    (Scetta et al. 2021, arXiv 2104.02504).

    Args:
        cycles: numbers of the cycles, ascending, where 1 is the first cycle of the test.
        values: a value of each cycle, such as the peak stress, shape (cycles,) or (specimens, cycles).
        relative: whether to fit the logarithm of the values.

    Raises:
        InputError: fewer than three cycles, other shapes, values that are not finite, or values that are not > 0 for a
            relative drift.
    """
    numbers, table = np.asarray(cycles, dtype=np.float64), np.atleast_2d(np.asarray(values, dtype=np.float64))
    if len(numbers) < _FEWEST_CYCLES or np.any(np.diff(numbers) <= 0) or numbers[0] < 1:
        raise InputError(f"cycles: need at least {_FEWEST_CYCLES} rising numbers >= 1, got {list(cycles)}")
    if table.shape[1:] != numbers.shape:
        raise InputError(f"values: need {len(numbers)} in each row, one for each cycle, got shape {table.shape}")
    if not np.all(np.isfinite(table)) or (relative and np.any(table <= 0)):
        raise InputError(f"values: need finite numbers{' > 0' if relative else ''}, got {np.min(table):g}")
    table = np.log(table) if relative else table
    scale = 1.0 if relative else max(float(np.max(np.abs(table))), np.finfo(float).tiny)
    levelled = (table - table.mean(axis=1, keepdims=True)) / scale
    fits = [_of_kind("none", numbers, levelled), _of_kind("logarithm", numbers, levelled)]
    if len(numbers) >= _FEWEST_FOR_PLATEAU:
        fits.append(_of_kind("plateau", numbers, levelled))
    _, kind, rate, half, length = min(fits, key=lambda fit: fit[0])
    return Drift(
        kind=kind,
        rate=rate * scale,
        interval=((rate - half) * scale, (rate + half) * scale),
        cycles=length,
        relative=relative,
        seen=(int(numbers[0]), int(numbers[-1])),
    )


def _shape(kind: str, numbers: Array, length: float) -> Array:
    """Compute the change at each cycle for a rate of 1."""
    if kind == "logarithm":
        return np.log(numbers)
    return np.zeros_like(numbers) if kind == "none" else -np.expm1(-(numbers - 1) / length)


def _of_kind(kind: Kind, numbers: Array, levelled: Array) -> tuple[float, Kind, float, float, float]:
    """Fit the best drift of a kind; return BIC, kind, rate, half of its interval, and decay constant of the plateau."""
    length = _plateau_length(numbers, levelled) if kind == "plateau" else 0.0
    shape = _shape(kind, numbers, length)
    shape = shape - shape.mean()
    weight = float(shape @ shape) * len(levelled)
    rate = float(np.sum(levelled * shape)) / weight if weight else 0.0
    squares = max(float(np.sum((levelled - rate * shape) ** 2)), _FLOOR**2)
    parameters = {"none": 0, "logarithm": 1, "plateau": 2}[kind]
    points, count = levelled.size, parameters + len(levelled)
    bic = points * math.log(squares / points) + count * math.log(points)
    freedom = max(points - count, 1)
    half = float(scipy.special.stdtrit(freedom, 0.975)) * math.sqrt(squares / freedom / weight) if weight else 0.0
    return bic, kind, rate, half, length


def _plateau_length(numbers: Array, levelled: Array) -> float:
    """Fit the decay constant of a plateau, in cycles, between 0.3 cycles and the range of the data."""

    def residual(logarithm: Array) -> Array:
        shape = _shape("plateau", numbers, float(np.exp(logarithm[0])))
        shape = shape - shape.mean()
        rate = float(np.sum(levelled * shape)) / (float(shape @ shape) * len(levelled))
        return np.asarray((levelled - rate * shape).ravel())

    bounds = (math.log(0.3), math.log(float(np.ptp(numbers))))
    fit = scipy.optimize.least_squares(residual, [sum(bounds) / 2], bounds=([bounds[0]], [bounds[1]]))
    return float(np.exp(fit.x[0]))
