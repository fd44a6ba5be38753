"""One tensile test: what a machine recorded of one specimen."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.errors import InputError
from forficula.quantities import show_value

# no rubber stretches as far; a length in the wrong unit does
_MOST_STRAIN = 20


@dataclass(frozen=True, kw_only=True, eq=False)
class TensileTest:
    """Time, travel and force of one specimen, and its size before the test.

    Attributes:
        name: of the specimen.
        time: s, shape (row,), never falling.
        extension: travel of the machine from the specimen's length on, m, shape (row,).
        force: N, shape (row,), pulling positive.
        length: of the specimen between the points whose distance the travel changes, m, > 0.
        area: of its cross-section, m2, > 0.

    Raises:
        InputError: arrays of different lengths, fewer than two rows, numbers that are not finite, time that falls, or a
            size that is not > 0.
    """

    name: str
    time: NDArray[np.float64]
    extension: NDArray[np.float64]
    force: NDArray[np.float64]
    length: float
    area: float

    def __post_init__(self) -> None:
        rows = self.time.shape
        if len(rows) != 1 or rows[0] < 2:
            raise InputError(f"{self.name}: time: need at least two rows, got shape {rows}")
        for key, values in (("time", self.time), ("extension", self.extension), ("force", self.force)):
            if values.shape != rows:
                raise InputError(
                    f"{self.name}: {key}: need as many rows as there are times, {rows}, got {values.shape}"
                )
            if not np.isfinite(values).all():
                row = int(np.argmin(np.isfinite(values)))
                raise InputError(f"{self.name}: {key}: need finite numbers, got {values[row]} in row {row}")
        if (falls := falling(self.time)) is not None:
            before, after = self.time[falls - 1 : falls + 1]
            raise InputError(f"{self.name}: time: need times that never fall, got {after:g} s after {before:g} s")
        for key, size, unit in (("length", self.length, "m"), ("area", self.area, "m^2")):
            if not 0 < size < np.inf:
                raise InputError(f"{self.name}: {key}: need > 0, got {size:g} {unit}")
        furthest = float(self.extension[np.argmax(np.abs(self.extension))])
        if not -self.length < furthest <= _MOST_STRAIN * self.length:
            raise InputError(
                f"{self.name}: extension: need more than -1 and at most {_MOST_STRAIN} times the specimen's length,"
                f" {show_value(self.length, 'm')}, got {show_value(furthest, 'm')}; is the unit of one of them wrong?"
            )

    @property
    def strain(self) -> NDArray[np.float64]:
        """Engineering strain: extension over the first length, shape (row,)."""
        return self.extension / self.length

    @property
    def stress(self) -> NDArray[np.float64]:
        """Engineering stress: force over the first area, Pa, shape (row,)."""
        return self.force / self.area


def falling(time: NDArray[np.float64]) -> int | None:
    """The first row whose time, shape (row,), is before that of the row above; None where there is none."""
    falls = np.flatnonzero(np.diff(time) < 0)
    return int(falls[0]) + 1 if len(falls) else None
