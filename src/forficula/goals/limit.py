"""Limits on quantities, and the margin by which a value meets or misses a limit."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from forficula.errors import InputError
from forficula.goals.outcome_quantity import PROBABILITY, OutcomeQuantity
from forficula.quantities import as_written, parse_quantity, show_quantity

_TEXT = re.compile(r"\s*(<=|>=)\s*(.+?)\s*")
_ROUNDING = 1e-9


@dataclass(frozen=True, kw_only=True)
class Limit:
    """Lower or upper limit of a quantity.

    Attributes:
        quantity: the limited quantity.
        kind: ">=" or "<=".
        bound: SI.
    """

    quantity: OutcomeQuantity
    kind: Literal[">=", "<="]
    bound: float

    def __str__(self) -> str:
        """Return the limit as in a goal file, such as "holding_torque >= 5 N cm"."""
        return f"{self.quantity.name} {self.kind} {show_quantity(self.bound, self.quantity.unit)}"

    def margin(self, value: float | None) -> float:
        """Return the margin of a value (SI), as a fraction of the bound: > 0 if met, < 0 if missed; in [-1, 1].

        -1 if there is no value. The margin of a bound of 0 is relative to one display unit.
        """
        if value is None or math.isnan(value):
            return -1.0
        scale = abs(self.bound) or parse_quantity(f"1 {self.quantity.unit.display}", self.quantity.unit)
        share = (value - self.bound) / scale if self.kind == ">=" else (self.bound - value) / scale
        # a value that equals the bound up to rounding meets the limit
        return min(max(share if abs(share) > _ROUNDING else 0.0, -1.0), 1.0)


def check_limits(limits: Sequence[Limit]) -> None:
    """Reject limits on one quantity that no value can meet, and an empty list.

    Raises:
        InputError: the limits at fault. The caller adds the key.
    """
    if not limits:
        raise InputError("need at least one limit, got an empty list")
    unit = limits[0].quantity.unit
    least = max((limit.bound for limit in limits if limit.kind == ">="), default=-math.inf)
    most = min((limit.bound for limit in limits if limit.kind == "<="), default=math.inf)
    if least > most:
        raise InputError(
            f"nothing is both >= {show_quantity(least, unit)} and <= {show_quantity(most, unit)}; exchange the bounds"
        )
    if limits[0].quantity.name == PROBABILITY and any(not 0 <= limit.bound <= 1 for limit in limits):
        wrong = next(limit.bound for limit in limits if not 0 <= limit.bound <= 1)
        raise InputError(f"need a share from 0 % to 100 %, got {show_quantity(wrong, unit)}")
    if limits[0].quantity.source == "search" and any(limit.bound <= 0 for limit in limits):
        wrong = next(limit.bound for limit in limits if limit.bound <= 0)
        raise InputError(f"need > 0, in the sense in which the drive acts, got {show_quantity(wrong, unit)}")


def read_limit(quantity: OutcomeQuantity, text: object) -> Limit:
    """Read a limit such as ">= 5 N cm".

    Raises:
        InputError: not a limit. The caller adds the key.
    """
    match = _TEXT.fullmatch(text) if isinstance(text, str) else None
    if match is None:
        right = f'">= {quantity.unit.example}" or "<= {quantity.unit.example}"'
        raise InputError(f"need a limit such as {right}, got {as_written(text)}")
    kind: Literal[">=", "<="] = ">=" if match[1] == ">=" else "<="
    return Limit(quantity=quantity, kind=kind, bound=parse_quantity(match[2], quantity.unit))
