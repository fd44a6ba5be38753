"""How a value changes over the cycles of a test."""

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
        kind: "none", where the data show none; "logarithm", rate ln N; or "plateau", rate (1 - exp(-(N - 1) / cycles)).
        rate: of the change.
        interval: of the rate, 95 % confidence.
        cycles: of the plateau; 0 for the others.
        relative: whether the change is in the logarithm of the value, or in the value itself.
        seen: first and last cycle of the data; beyond, a drift is an extrapolation.

    Raises:
        InputError: numbers that are no such drift.
    """

    kind: Kind
    rate: float
    interval: Annotated[tuple[float, float], Key("rate_interval_95")]
    cycles: Annotated[float, Written.NEVER]
    relative: bool
    seen: Annotated[tuple[int, int], Key("seen_cycles")]

    @property
    def plateau_cycles(self) -> Annotated[float | None, Written.ALWAYS]:
        """Cycles of the plateau; None where the drift has none."""
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
        """The change from the first cycle seen to another: its value and its 95 % confidence interval.

        Args:
            cycle: >= 1, the first one of the test being 1.

        Returns:
            A factor where the drift is relative, else a difference in the value's unit.

        Raises:
            InputError: the cycle is none.
        """
        if not (math.isfinite(cycle) and cycle >= 1):
            raise InputError(f"cycle: need >= 1, got {cycle:g}")
        way = float(_course(self.kind, np.array([float(cycle)]), self.cycles)[0])
        way -= float(_course(self.kind, np.array([float(self.seen[0])]), self.cycles)[0])
        low, high = sorted((self.interval[0] * way, self.interval[1] * way))
        middle = self.rate * way
        return (math.exp(middle), math.exp(low), math.exp(high)) if self.relative else (middle, low, high)


def fit_drift(cycles: Sequence[int], values: ArrayLike, *, relative: bool = True) -> Drift:
    """Fit the drift of a value over cycles of constant amplitude, where the data show one.

    No drift, one with the logarithm of the cycle (the field's usual one, for ln of the value a power law) and one to a
    plateau, each with a level of its own for every specimen; the choice is by the Bayesian information criterion. A
    value may rise as well as fall: some thermoplastic elastomers stiffen (Scetta et al. 2021, arXiv 2104.02504).

    Args:
        cycles: their numbers, rising, the first one of the test being 1.
        values: such as the peak stress or a modulus of each cycle, shape (cycles,) or (specimens, cycles).
        relative: fit the logarithm of the values.

    Raises:
        InputError: fewer than three cycles, other shapes, or values that are not finite, or not > 0 where relative.
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


def _course(kind: str, numbers: Array, length: float) -> Array:
    """How far a drift of rate 1 has come at each cycle."""
    if kind == "logarithm":
        return np.log(numbers)
    return np.zeros_like(numbers) if kind == "none" else -np.expm1(-(numbers - 1) / length)


def _of_kind(kind: Kind, numbers: Array, levelled: Array) -> tuple[float, Kind, float, float, float]:
    """BIC, kind, rate, half of its interval and length of the plateau of the best drift of a kind."""
    length = _plateau_length(numbers, levelled) if kind == "plateau" else 0.0
    course = _course(kind, numbers, length)
    course = course - course.mean()
    weight = float(course @ course) * len(levelled)
    rate = float(np.sum(levelled * course)) / weight if weight else 0.0
    squares = max(float(np.sum((levelled - rate * course) ** 2)), _FLOOR**2)
    own = {"none": 0, "logarithm": 1, "plateau": 2}[kind]
    points, count = levelled.size, own + len(levelled)
    bic = points * math.log(squares / points) + count * math.log(points)
    freedom = max(points - count, 1)
    half = float(scipy.special.stdtrit(freedom, 0.975)) * math.sqrt(squares / freedom / weight) if weight else 0.0
    return bic, kind, rate, half, length


def _plateau_length(numbers: Array, levelled: Array) -> float:
    """The length, in cycles, that fits best; between a part of a cycle and the cycles seen."""

    def residual(logarithm: Array) -> Array:
        course = _course("plateau", numbers, float(np.exp(logarithm[0])))
        course = course - course.mean()
        rate = float(np.sum(levelled * course)) / (float(course @ course) * len(levelled))
        return np.asarray((levelled - rate * course).ravel())

    bounds = (math.log(0.3), math.log(float(np.ptp(numbers))))
    found = scipy.optimize.least_squares(residual, [sum(bounds) / 2], bounds=([bounds[0]], [bounds[1]]))
    return float(np.exp(found.x[0]))
