"""Summary of a law and its values for files of results."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

from forficula.material.law.drift import Drift
from forficula.material.law.law_cycle import drifts_of
from forficula.material.law.law_file import law_values
from forficula.material.law.law_keys import law_unit
from forficula.material.law.material_law import LawFact, MaterialLaw
from forficula.serial import Key


@dataclass(frozen=True, kw_only=True)
class LawValue:
    """A value of a law that is not 0.

    Attributes:
        key: key in a law file.
        value: value in SI.
        interval: 95 % confidence interval; None if it is not known.
        unit: SI unit, "1" for a number.
    """

    key: str
    value: float
    interval: Annotated[tuple[float, float] | None, Key("interval_95")]
    unit: str


@dataclass(frozen=True, kw_only=True)
class LawSummary:
    """A law that was fitted.

    Attributes:
        name: name of the material.
        source: source of the tests.
        parameters: values that are not 0.
        drift: drift over the cycles, by the drifting quantity.
        facts: facts about the tests.
    """

    name: str
    source: str
    parameters: list[LawValue]
    drift: Mapping[str, Drift]
    facts: tuple[LawFact, ...]


def law_summary(law: MaterialLaw) -> LawSummary:
    """Return the summary of a law, as in `material.json`."""
    return LawSummary(
        name=law.name, source=law.source, parameters=known_values(law), drift=drifts_of(law), facts=law.facts
    )


def known_values(law: MaterialLaw) -> list[LawValue]:
    """Return the values of a law that are not 0 or have a confidence interval."""
    bounds = {interval.key: (interval.low, interval.high) for interval in law.intervals}
    return [
        LawValue(key=key, value=value, interval=bounds.get(key), unit=law_unit(key).si.replace("dimensionless", "1"))
        for key, value in law_values(law).items()
        if value or key in bounds
    ]
