"""Limits on quantities: at least or at most so much, and by what share of it they are met or missed."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import Literal

from forficula.errors import InputError
from forficula.goals.outcome_quantity import OutcomeQuantity
from forficula.quantities import as_written, parse_quantity, show_quantity

_TEXT = re.compile(r"\s*(<=|>=)\s*(.+?)\s*")
_ROUNDING = 1e-9


@dataclass(frozen=True, kw_only=True)
class Limit:
    """What a quantity must not fall below, or not exceed.

    Attributes:
        quantity: which.
        kind: ">=" or "<=".
        bound: SI.
    """

    quantity: OutcomeQuantity
    kind: Literal[">=", "<="]
    bound: float

    def __str__(self) -> str:
        """As a goal file has it, such as "holding_torque >= 5 N cm"."""
        return f"{self.quantity.name} {self.kind} {show_quantity(self.bound, self.quantity.unit)}"

    def margin(self, value: float | None) -> float:
        """The share of the bound by which a value, SI, meets it, > 0, or misses it, < 0; within [-1, 1].

        -1 where there is no value. Of a bound of 0 it is a share of one display unit.
        """
        if value is None or math.isnan(value):
            return -1.0
        scale = abs(self.bound) or parse_quantity(f"1 {self.quantity.unit.display}", self.quantity.unit)
        share = (value - self.bound) / scale if self.kind == ">=" else (self.bound - value) / scale
        # what meets it exactly, but for rounding, meets it
        return min(max(share if abs(share) > _ROUNDING else 0.0, -1.0), 1.0)


def read_limit(quantity: OutcomeQuantity, given: object) -> Limit:
    """Read a limit such as ">= 5 N cm".

    Raises:
        InputError: it is none; the caller knows the key.
    """
    match = _TEXT.fullmatch(given) if isinstance(given, str) else None
    if match is None:
        right = f'">= {quantity.unit.example}" or "<= {quantity.unit.example}"'
        raise InputError(f"need a limit such as {right}, got {as_written(given)}")
    kind: Literal[">=", "<="] = ">=" if match[1] == ">=" else "<="
    return Limit(quantity=quantity, kind=kind, bound=parse_quantity(match[2], quantity.unit))
