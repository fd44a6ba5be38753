"""A tensile test: the recording of a testing machine for one specimen."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.quantities import Unit, show_quantity, show_value
from forficula.serial import Metres, SquareMetres, Written

# no rubber reaches this strain, but a length in a wrong unit does
_MOST_STRAIN = 20
# [chosen] m and m2: from a fibre with a diameter of 0.1 µm to a ship's rope; beyond, a unit or a power of ten is wrong
SIZES = {
    "length": (1e-6, 100.0),
    "area": (1e-15, 1.0),
    # of folded strips: from a ribbon of a microscope to a tarpaulin
    "width": (1e-6, 100.0),
    "thickness": (1e-7, 1.0),
    "lever": (1e-6, 100.0),
}
UNITS = {
    "length": Unit(display="mm", si="m", example="60 mm"),
    "area": Unit(display="mm^2", si="m^2", example="5 mm^2"),
    "width": Unit(display="mm", si="m", example="20 mm"),
    "thickness": Unit(display="mm", si="m", example="0.1 mm"),
    "lever": Unit(display="mm", si="m", example="30 mm"),
}


@dataclass(frozen=True, kw_only=True, eq=False)
class TensileTest:
    """Time, travel and force of one specimen, and its size before the test.

    Attributes:
        name: name of the specimen.
        time: s, shape (row,), never decreasing.
        extension: travel of the machine relative to the specimen's length, m, shape (row,).
        force: N, shape (row,), pulling positive.
        length: length of the specimen between the points whose distance the travel changes, m, 1e-6 to 100.
        area: cross-section of the specimen, m2, 1e-15 to 1.

    Raises:
        InputError: arrays of different lengths, fewer than two rows, numbers that are not finite, time that decreases,
            or an impossible size.
    """

    name: str
    time: Annotated[Array, Written.NEVER]
    extension: Annotated[Array, Written.NEVER]
    force: Annotated[Array, Written.NEVER]
    length: Metres
    area: SquareMetres

    @property
    def rows(self) -> Annotated[int, Written.ALWAYS]:
        """Number of rows."""
        return len(self.time)

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
        if (decrease := falling(self.time)) is not None:
            before, after = self.time[decrease - 1 : decrease + 1]
            raise InputError(f"{self.name}: time: need times that never decrease, got {after:g} s after {before:g} s")
        for key, size in (("length", self.length), ("area", self.area)):
            if rule := size_rule(key, size):
                raise InputError(f"{self.name}: {key}: {rule}")
        furthest = float(self.extension[np.argmax(np.abs(self.extension))])
        if not -self.length < furthest <= _MOST_STRAIN * self.length:
            raise InputError(
                f"{self.name}: extension: need more than -1 and at most {_MOST_STRAIN} times the specimen's length,"
                f" {show_value(self.length, 'm')}, got {show_value(furthest, 'm')}; is the unit of one of them wrong?"
            )

    @property
    def strain(self) -> Array:
        """Engineering strain: extension divided by the initial length, shape (row,)."""
        return self.extension / self.length

    @property
    def stress(self) -> Array:
        """Engineering stress: force divided by the initial area, Pa, shape (row,)."""
        return self.force / self.area


def size_rule(key: str, size: float) -> str:
    """Return the message for an impossible size of a specimen, with the allowed sizes; "" for a possible size.

    Args:
        key: "length", "area", "width", "thickness" or "lever".
        size: m or m2.
    """
    (least, most), unit = SIZES[key], UNITS[key]
    if least <= size <= most:
        return ""
    bounds = f"need {show_quantity(least, unit)} to {show_quantity(most, unit)}"
    return f"{bounds}, got {show_quantity(size, unit)}; is its unit wrong?"


def falling(time: Array) -> int | None:
    """Return the index of the first row whose time, shape (row,), is smaller than that before; None without one."""
    falls = np.flatnonzero(np.diff(time) < 0)
    return int(falls[0]) + 1 if len(falls) else None
