"""Limits on quantities: at least or at most so much, and by what share of it they are met or missed."""

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


def check_limits(limits: Sequence[Limit]) -> None:
    """Refuse limits on one quantity that nothing could meet, and none at all.

    Raises:
        InputError: which; the caller knows the key.
    """
    if not limits:
        raise InputError("need at least one limit, got an empty list")
    unit = limits[0].quantity.unit
    least = max((each.bound for each in limits if each.kind == ">="), default=-math.inf)
    most = min((each.bound for each in limits if each.kind == "<="), default=math.inf)
    if least > most:
        raise InputError(
            f"nothing is both >= {show_quantity(least, unit)} and <= {show_quantity(most, unit)}; need them the other"
            " way round"
        )
    if limits[0].quantity.name == PROBABILITY and any(not 0 <= each.bound <= 1 for each in limits):
        wrong = next(each.bound for each in limits if not 0 <= each.bound <= 1)
        raise InputError(f"need a share from 0 % to 100 %, got {show_quantity(wrong, unit)}")
    if limits[0].quantity.source == "search" and any(each.bound <= 0 for each in limits):
        wrong = next(each.bound for each in limits if each.bound <= 0)
        raise InputError(f"need > 0, in the sense in which the drive acts, got {show_quantity(wrong, unit)}")


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
