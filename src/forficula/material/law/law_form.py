"""Which terms a law has, before their values are known."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from typing import Literal

from forficula.material.law.law_keys import TERMS

_SPRINGS = ("linear spring", "quadratic spring", "cubic spring")
_DAMPERS = ("", "linear damper", "quadratic damper", "cubic damper")
# how strain energy may be lost: order of the damper, number of Maxwell branches
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
        order: of the spring's polynomial.
        damper: order of the damper's polynomial; 0 is none.
        branches: number of Maxwell branches.
        permanent_set: none; a residual strain that was there from the start, as where the first cycle was dropped; or
            a yield strain, beyond which it creeps.
        softening: none; Ogden-Roxburgh with m alone, which is all that cycles of one amplitude can tell; or with beta.
    """

    order: Literal[1, 2, 3] = 1
    damper: Literal[0, 1, 2, 3] = 0
    branches: int = 0
    permanent_set: Literal["none", "residual", "yield"] = "none"
    softening: Literal["none", "m", "m and beta"] = "none"

    @property
    def name(self) -> str:
        """What people call it."""
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
        """Whether it is a spring with two Maxwell branches or more, and nothing else that its rate matters to."""
        return self.branches > 1 and not self.damper and self.softening == "none"

    @property
    def linear_keys(self) -> tuple[str, ...]:
        """The values that the stress is proportional to, as in a law file; without softening."""
        springs = [f"modulus.{term}" for term in TERMS[: self.order]]
        dampers = [f"viscosity.{term}" for term in TERMS[: self.damper]]
        return (*springs, *dampers, *(f"branches.{index}.modulus" for index in range(self.branches)))

    @property
    def other_keys(self) -> tuple[str, ...]:
        """The other values."""
        keys = [f"branches.{index}.time" for index in range(self.branches)]
        if self.permanent_set != "none":
            keys.append(f"{self.permanent_set}_strain")
        soft = {"none": [], "m": ["softening.r", "softening.m"]}
        return (*keys, *soft.get(self.softening, ["softening.r", "softening.m", "softening.beta"]))

    @property
    def keys(self) -> tuple[str, ...]:
        """All values, linear ones first."""
        return self.linear_keys + self.other_keys


def all_forms() -> tuple[LawForm, ...]:
    """Every form that a fit tries at first, simple ones first; softening goes with a Maxwell branch at most.

    Two Maxwell branches without a damper stand for a Prony series, which a fit makes longer as far as the data go.
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
