"""A folding test: moment and fold angle of a strip with one crease."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.material.tensile.tensile_test import falling, size_rule
from forficula.serial import Metres, Written

_MOST_ANGLE = 2 * np.pi  # no crease turns further, but an angle in a wrong unit does


@dataclass(frozen=True, kw_only=True, eq=False)
class FoldingTest:
    """Fold angle and moment of one strip, and its size.

    Attributes:
        name: name of the strip.
        time: s, shape (row,), never decreasing; None if the file has no time.
        angle: fold angle, 0 if the strip is flat, rad, shape (row,).
        moment: moment that increases the angle, N m, shape (row,).
        width: length of the crease, m.
        thickness: thickness of the strip, m; None if it is not known.

    Raises:
        InputError: arrays of different lengths, fewer than two rows, numbers that are not finite, time that decreases,
            angles beyond a full turn, or an impossible size.
    """

    name: str
    time: Annotated[Array | None, Written.NEVER]
    angle: Annotated[Array, Written.NEVER]
    moment: Annotated[Array, Written.NEVER]
    width: Metres
    thickness: Metres | None

    @property
    def rows(self) -> Annotated[int, Written.ALWAYS]:
        """Number of rows."""
        return len(self.angle)

    @property
    def moment_by_width(self) -> Array:
        """Moment per length of the crease, N m/m, shape (row,)."""
        return self.moment / self.width

    def __post_init__(self) -> None:
        rows = self.angle.shape
        if len(rows) != 1 or rows[0] < 2:
            raise InputError(f"{self.name}: angle: need at least two rows, got shape {rows}")
        columns = {"angle": self.angle, "moment": self.moment} | ({} if self.time is None else {"time": self.time})
        for key, values in columns.items():
            if values.shape != rows:
                raise InputError(
                    f"{self.name}: {key}: need as many rows as there are angles, {rows}, got {values.shape}"
                )
            if not np.isfinite(values).all():
                row = int(np.argmin(np.isfinite(values)))
                raise InputError(f"{self.name}: {key}: need finite numbers, got {values[row]} in row {row}")
        if self.time is not None and (decrease := falling(self.time)) is not None:
            before, after = self.time[decrease - 1 : decrease + 1]
            raise InputError(f"{self.name}: time: need times that never decrease, got {after:g} s after {before:g} s")
        if (most := float(np.abs(self.angle).max())) > _MOST_ANGLE:
            raise InputError(
                f"{self.name}: angle: need at most 360 deg, got {np.rad2deg(most):.4g} deg; is its unit wrong?"
            )
        for key, size in (("width", self.width), ("thickness", self.thickness)):
            if size is not None and (rule := size_rule(key, size)):
                raise InputError(f"{self.name}: {key}: {rule}")
