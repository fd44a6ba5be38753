"""What a specimen went through: strain and stress in time."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError, error_prefix
from forficula.material.law.stress import check_history
from forficula.material.tensile.cycles import BAND
from forficula.material.tensile.turning_points import turning_points

_RATE_ERROR = 0.02  # of the typical rate: how much noise of the strain may leave in it
_WIDEST = 50  # samples
_SHARES = (0.1, 0.9)  # of the way from one turn to the next: what is less is a turn, or noise


@dataclass(frozen=True, kw_only=True, eq=False)
class StrainHistory:
    """Strain and engineering stress of one specimen, from one test.

    Attributes:
        time: s, shape (samples,), rising.
        strain: extension by resting length, shape (samples,).
        stress: force by initial area, Pa, shape (samples,).
        name: of the specimen.
        first: the first sample that a fit compares; a law runs through those before, such as the first cycle, too.
        offset: of the force's zero at the middle of the time, Pa, as a slack specimen shows it; None where none hung
            slack, so that it has to be fitted with the law.
        drift: of that zero, Pa/s.

    Raises:
        InputError: rows of different length, a first sample that is none, numbers that are not finite, or a time
            that does not rise.
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
        """What is known of the force's zero, Pa, shape (samples,)."""
        return self.zero_at(self.time)

    def zero_at(self, time: Array) -> Array:
        """What is known of the force's zero at some times, s, in Pa and their shape."""
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
    """Rate of the strain, 1/s, shape (samples,).

    The slope over as many neighbouring samples as the noise of the strain asks for: one on either side where the
    strain is clean, so that turning points stay sharp. Samples need not be evenly spaced.
    """
    strain, time = history.strain, history.time
    steps, spans = np.diff(strain), np.diff(time)
    typical = float(np.median(np.abs(steps))) or float(np.mean(np.abs(steps)))
    # off the straight line through its neighbours white noise has this share of its variance more, 1.5 where samples
    # are evenly spaced; its median stands for it despite turning points
    share = spans[1:] / (spans[:-1] + spans[1:])
    off = np.abs(share * steps[:-1] - (1 - share) * steps[1:]) / np.sqrt(1 + share**2 + (1 - share) ** 2)
    noise = float(np.median(off)) / 0.6745 if len(off) else 0.0
    reach = 1 if typical == 0 else int(np.clip(np.ceil(noise / np.sqrt(2) / (_RATE_ERROR * typical)), 1, _WIDEST))
    if reach == 1:
        return np.asarray(np.gradient(strain, time))
    rows = np.arange(len(time))
    before, after = np.maximum(rows - reach, 0), np.minimum(rows + reach, len(time) - 1)
    return np.asarray((strain[after] - strain[before]) / (time[after] - time[before]))


def rate_range(history: StrainHistory) -> tuple[float, float]:
    """The lowest and the highest rate at which a history, from its first sample that counts, is strained, 1/s.

    Those at which at least a tenth of a way from turn to turn goes; in a hold nothing does.
    """
    strain = history.strain[history.first :]
    speed, span = np.abs(strain_rate(history))[history.first :], np.gradient(history.time)[history.first :]
    turns = turning_points(strain, BAND * float(np.ptp(strain)))
    found = []
    for start, end in pairwise(turns):
        rising = np.argsort(speed[start : end + 1])
        speeds = speed[start : end + 1][rising]
        travelled = np.cumsum(speeds * span[start : end + 1][rising])
        found.append(speeds[np.searchsorted(travelled, np.multiply(_SHARES, travelled[-1]))])
    return float(np.min(found)), float(np.max(found))
