"""Checks of parts before they are made."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

from forficula.quantities import show_value
from forficula.serial import WithUnit, Written


@dataclass(frozen=True, kw_only=True)
class Check:
    """Result of one check: whether a part can be made and works as drawn.

    Attributes:
        name: name of the check.
        part: part that was checked.
        ok: whether it passed; None if it was not checked, for the reason in the text.
        value: measured, in the unit.
        limit: allowed, in the unit.
        unit: SI, "" for a number.
        text: a sentence with the result and, if it failed, with advice.
    """

    name: str
    part: str
    ok: bool | None
    value: Annotated[float, Written.NEVER]
    limit: Annotated[float, Written.NEVER]
    unit: Annotated[str, Written.NEVER]
    text: str

    def __repr__(self) -> str:
        """Result, with value and limit in their unit."""
        if self.ok is None:
            return f"<Check {self.name} of {self.part}: not checked>"
        value, limit = (show_value(number, self.unit).strip() for number in (self.value, self.limit))
        return f"<Check {self.name} of {self.part}: {'passed' if self.ok else 'failed'}, {value} (limit {limit})>"

    @property
    def quantities(self) -> Annotated[Mapping[str, WithUnit], Written.BESIDE]:
        """Value and limit with their unit."""
        return {"value": WithUnit(self.value, self.unit), "limit": WithUnit(self.limit, self.unit)}


def least_check(name: str, part: str, *, measured: float, least: float, text: str, mend: str = "") -> Check:
    """Return a check of whether a length, m, reaches its minimum; if it does not, `mend` is appended to the text."""
    ok = bool(measured >= least)
    sentence = text if ok else text + mend
    return Check(name=name, part=part, ok=ok, value=float(measured), limit=least, unit="m", text=sentence)


def count_check(name: str, part: str, *, measured: int, wanted: int, held: str, missed: str) -> Check:
    """Return a check of whether a number is as required, with a text for either case."""
    ok = measured == wanted
    sentence = held if ok else missed
    return Check(name=name, part=part, ok=ok, value=float(measured), limit=float(wanted), unit="", text=sentence)
