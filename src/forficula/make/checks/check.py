"""What is checked of parts before they are made."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

from forficula.serial import WithUnit, Written


@dataclass(frozen=True, kw_only=True)
class Check:
    """Whether a part can be made and works as it is drawn, in one respect.

    Attributes:
        name: of what is checked.
        part: that it is checked of.
        ok: whether it holds; None where it was not checked, for the reason that the text gives.
        value: found, in the unit.
        limit: that it is held to, in the unit.
        unit: SI, "" for a number.
        text: a sentence that says what was found and what to do about it.
    """

    name: str
    part: str
    ok: bool | None
    value: Annotated[float, Written.NEVER]
    limit: Annotated[float, Written.NEVER]
    unit: Annotated[str, Written.NEVER]
    text: str

    @property
    def quantities(self) -> Annotated[Mapping[str, WithUnit], Written.BESIDE]:
        """Value and limit with their unit."""
        return {"value": WithUnit(self.value, self.unit), "limit": WithUnit(self.limit, self.unit)}


def least_check(name: str, part: str, *, found: float, least: float, text: str, mend: str = "") -> Check:
    """A check of whether a length, m, is as large as it has to be; where it is not, `mend` follows on the text."""
    held = bool(found >= least)
    told = text if held else text + mend
    return Check(name=name, part=part, ok=held, value=float(found), limit=least, unit="m", text=told)


def count_check(name: str, part: str, *, found: int, wanted: int, held: str, missed: str) -> Check:
    """A check of whether there are as many of something as there have to be, with what is told in either case."""
    ok = found == wanted
    told = held if ok else missed
    return Check(name=name, part=part, ok=ok, value=float(found), limit=float(wanted), unit="", text=told)
