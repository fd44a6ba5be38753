"""The history of strain and stress of a specimen, and its strain rates."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError, error_prefix
from forficula.material.law.stress import check_history
from forficula.material.tensile.cycles import BAND
from forficula.material.tensile.turning_points import turning_points

_RATE_ERROR = 0.02  # largest error of the rate from noise, as a share of the typical rate
_WIDEST = 50  # samples, largest distance over which a slope is taken
_SHARES = (0.1, 0.9)  # quantiles of the rate by travelled strain: slower samples are turning points or noise


@dataclass(frozen=True, kw_only=True, eq=False)
class StrainHistory:
    """Strain and engineering stress of one specimen in one test.

    Attributes:
        time: s, shape (samples,), increasing.
        strain: extension per resting length, shape (samples,).
        stress: force per initial area, Pa, shape (samples,).
        name: name of the specimen.
        first: first sample that a fit compares; a law is also computed through the samples before, such as those of the
            first cycle.
        offset: zero of the force at the middle of the time, Pa, measured on a slack specimen; None if the specimen
            never hung slack, so that the zero must be fitted with the law.
        drift: drift of that zero, Pa/s.

    Raises:
        InputError: rows of different length, a first sample out of range, numbers that are not finite, or a time that
            does not increase.
    """

    time: Array
    strain: Array
    stress: Array
    name: str = "specimen"
    first: int = 0
    offset: float | None = None
    drift: float = 0.0

    @property
    def zero(self) -> Array:
        """Known zero of the force, Pa, shape (samples,)."""
        return self.zero_at(self.time)

    def zero_at(self, time: Array) -> Array:
        """Compute the known zero of the force, Pa, at given times, s, in their shape."""
        middle = (self.time[0] + self.time[-1]) / 2
        return np.asarray((self.offset or 0.0) + self.drift * (time - middle))

    def __post_init__(self) -> None:
        for field in ("time", "strain", "stress"):
            object.__setattr__(self, field, np.asarray(getattr(self, field), dtype=np.float64))
        with error_prefix(f"{self.name}: "):
            check_history(self.time, self.strain)
            if self.stress.shape != self.time.shape or not np.all(np.isfinite(self.stress)):
                raise InputError(f"stress: need a finite number in each of the {len(self.time)} rows")
            if not 0 <= self.first < len(self.time):
                raise InputError(f"first: need a sample from 0 to {len(self.time) - 1}, got {self.first}")


def strain_rate(history: StrainHistory) -> Array:
    """Compute the strain rate, 1/s, shape (samples,).

    The rate is the slope over a number of neighbouring samples that depends on the noise of the strain: one on each
    side without noise, so that turning points remain sharp. Samples need not be equally spaced.
    """
    strain, time = history.strain, history.time
    steps, spans = np.diff(strain), np.diff(time)
    typical = float(np.median(np.abs(steps))) or float(np.mean(np.abs(steps)))
    # the deviation from the line through its two neighbours has 1 + share^2 + (1 - share)^2 times the variance of white
    # noise, 1.5 for equally spaced samples; the median is insensitive to turning points
    share = spans[1:] / (spans[:-1] + spans[1:])
    deviations = np.abs(share * steps[:-1] - (1 - share) * steps[1:]) / np.sqrt(1 + share**2 + (1 - share) ** 2)
    noise = float(np.median(deviations)) / 0.6745 if len(deviations) else 0.0
    reach = 1 if typical == 0 else int(np.clip(np.ceil(noise / np.sqrt(2) / (_RATE_ERROR * typical)), 1, _WIDEST))
    if reach == 1:
        return np.asarray(np.gradient(strain, time))
    rows = np.arange(len(time))
    before, after = np.maximum(rows - reach, 0), np.minimum(rows + reach, len(time) - 1)
    return np.asarray((strain[after] - strain[before]) / (time[after] - time[before]))


def rate_range(history: StrainHistory) -> tuple[float, float]:
    """Compute the lowest and the highest strain rate of a history, from its first compared sample on, 1/s.

    Between two turning points, a tenth of the strain is travelled at rates below the lowest rate, and a tenth above the
    highest one. Holds do not count, because no strain is travelled.
    """
    strain = history.strain[history.first :]
    speed, span = np.abs(strain_rate(history))[history.first :], np.gradient(history.time)[history.first :]
    turns = turning_points(strain, BAND * float(np.ptp(strain)))
    rates = []
    for start, end in pairwise(turns):
        rising = np.argsort(speed[start : end + 1])
        speeds = speed[start : end + 1][rising]
        travelled = np.cumsum(speeds * span[start : end + 1][rising])
        rates.append(speeds[np.searchsorted(travelled, np.multiply(_SHARES, travelled[-1]))])
    return float(np.min(rates)), float(np.max(rates))
