"""Forms of laws: the terms of a law without their values."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from typing import Literal

from forficula.material.law.law_keys import TERMS

_SPRINGS = ("linear spring", "quadratic spring", "cubic spring")
_DAMPERS = ("", "linear damper", "quadratic damper", "cubic damper")
# terms that dissipate energy: order of the damper, number of Maxwell branches
_LOSSES: tuple[tuple[Literal[0, 1, 2, 3], int], ...] = (
    (0, 0),
    (1, 0),
    (2, 0),
    (3, 0),
    (0, 1),
    (0, 2),
    (1, 1),
)


@dataclass(frozen=True, kw_only=True)
class LawForm:
    """The terms of a law to fit.

    Attributes:
        order: order of the spring's polynomial.
        damper: order of the damper's polynomial; 0 without a damper.
        branches: number of Maxwell branches.
        permanent_set: "none"; "residual" for a residual strain that exists from the start, for example because the
            first cycle was left out; or "yield" for a yield strain, beyond which the spring creeps.
        softening: "none"; "m" for Ogden and Roxburgh's law with m alone, which is all that cycles with a single
            amplitude can determine; or "m and beta".
    """

    order: Literal[1, 2, 3] = 1
    damper: Literal[0, 1, 2, 3] = 0
    branches: int = 0
    permanent_set: Literal["none", "residual", "yield"] = "none"
    softening: Literal["none", "m", "m and beta"] = "none"

    @property
    def name(self) -> str:
        """Name of the form in words."""
        plural = "es" if self.branches > 1 else ""
        parts = [
            _SPRINGS[self.order - 1],
            _DAMPERS[self.damper],
            f"{self.branches} Maxwell branch{plural}" if self.branches else "",
            {"none": "", "residual": "residual strain", "yield": "yield"}[self.permanent_set],
            {"none": "", "m": "softening", "m and beta": "softening by amplitude"}[self.softening],
        ]
        return ", ".join(part for part in parts if part)

    @property
    def is_prony_series(self) -> bool:
        """Whether the form is a spring with two or more Maxwell branches, without a damper and without softening."""
        return self.branches > 1 and not self.damper and self.softening == "none"

    @property
    def linear_keys(self) -> tuple[str, ...]:
        """Keys, as in a law file, of values to which the stress is proportional without softening."""
        springs = [f"modulus.{term}" for term in TERMS[: self.order]]
        dampers = [f"viscosity.{term}" for term in TERMS[: self.damper]]
        return (*springs, *dampers, *(f"branches.{index}.modulus" for index in range(self.branches)))

    @property
    def other_keys(self) -> tuple[str, ...]:
        """Keys of the other values."""
        keys = [f"branches.{index}.time" for index in range(self.branches)]
        if self.permanent_set != "none":
            keys.append(f"{self.permanent_set}_strain")
        soft = {"none": [], "m": ["softening.r", "softening.m"]}
        return (*keys, *soft.get(self.softening, ["softening.r", "softening.m", "softening.beta"]))

    @property
    def keys(self) -> tuple[str, ...]:
        """Keys of all values, linear ones first."""
        return self.linear_keys + self.other_keys


def all_forms() -> tuple[LawForm, ...]:
    """Return the forms that a fit tries, simple ones first; softening is combined with at most one Maxwell branch.

    Two Maxwell branches without a damper are the start of a Prony series, which a fit extends as far as the data allow.
    """
    orders: tuple[Literal[1, 2, 3], ...] = (1, 2, 3)
    sets: tuple[Literal["none", "residual", "yield"], ...] = ("none", "residual", "yield")
    soft: tuple[Literal["m", "m and beta"], ...] = ("m", "m and beta")
    plain = [
        LawForm(order=order, damper=damper, branches=branches, permanent_set=permanent_set)
        for (damper, branches), permanent_set, order in product(_LOSSES, sets, orders)
    ]
    softening = [
        LawForm(order=order, branches=branches, softening=kind)
        for kind, branches, order in product(soft, (0, 1), orders)
    ]
    return (*plain, *softening)
