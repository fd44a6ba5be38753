"""What is checked of parts before they are made."""

from __future__ import annotations

from dataclasses import dataclass


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
    value: float
    limit: float
    unit: str
    text: str
