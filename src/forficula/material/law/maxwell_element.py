"""A Maxwell element: a spring and a damper in series, as branches of tendons and creases are."""

from __future__ import annotations

import math
from dataclasses import dataclass

from forficula.errors import InputError


@dataclass(frozen=True, kw_only=True)
class MaxwellElement:
    """A Maxwell branch of a tendon or of a crease: a spring and a damper in series, parallel to its spring.

    The force F of a branch of a tendon follows dF/dt = stiffness dL/dt - F / time at any length L, slack or taut, and
    the moment M of a branch of a crease follows dM/dt = stiffness d(angle)/dt - M / time (Maxwell 1867).

    Attributes:
        stiffness: N/m of a tendon, N m/rad of a crease, > 0.
        time: relaxation time, s, > 0.

    Raises:
        InputError: a number that is not > 0 and finite.
    """

    stiffness: float
    time: float

    def __post_init__(self) -> None:
        for name, unit in (("stiffness", ""), ("time", " s")):
            value = getattr(self, name)
            if not (math.isfinite(value) and value > 0):
                raise InputError(f"branch.{name}: need a finite number > 0, got {value:g}{unit}")
