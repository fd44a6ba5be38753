"""Parameters: keys of a design that may vary, between bounds, by steps, or among choices."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from forficula.design import Design, key_quantity, key_value
from forficula.design.file_fields import DesignValue, entry
from forficula.design.files.rejection import read_part
from forficula.design.section import Section
from forficula.errors import InputError, error_prefix
from forficula.goals.value_at import choice_at, written
from forficula.quantities import as_written, parse_quantity, show_quantity
from forficula.study.factors import Factor, read_factor, undivided

_MOST_STEPS = 1_000_000


class RangeEntry(Section):
    """A range between two values as files have it."""

    low: DesignValue = entry("least value of a key that varies between two", ...)
    high: DesignValue = entry("largest value of a key that varies between two", ...)
    step: DesignValue = entry("from one value to the next; without it, any value between")


@dataclass(frozen=True, kw_only=True)
class Parameter:
    """A key of the design and the values that it may have.

    Attributes:
        factor: the key and, where it has choices, its values in their order; numbers among them rise.
        low: least value, SI; of choices 0.
        high: largest value, SI; of choices their number.
        ordered: whether neighbouring choices are alike: numbers, or texts with units, not words.
    """

    factor: Factor
    low: float
    high: float
    ordered: bool = True

    @property
    def key(self) -> str:
        """Of the design, dotted."""
        return self.factor.key

    @property
    def choices(self) -> tuple[object, ...]:
        """The values that it may have; none where it varies continuously."""
        return self.factor.values

    def value(self, share: float) -> object:
        """The value at a share of the way from the lowest to the highest, in [0, 1], as a design file has it.

        Choices take equal parts of it.
        """
        share = min(max(share, 0.0), 1.0)
        if self.choices:
            return choice_at(self.choices, share)
        return written(self.low + share * (self.high - self.low), self.factor.unit)

    def share(self, value: object) -> float:
        """The share at which a value, as a design file has it or SI, lies; of a choice the middle of its part.

        Raises:
            InputError: no such choice.
        """
        if self.choices:
            for place, choice in enumerate(self.choices):
                if _si(self.factor, choice) == _si(self.factor, value):
                    return (place + 0.5) / len(self.choices)
            raise InputError(f"{self.key}: need one of its choices, got {as_written(value)}")
        number = float(str(_si(self.factor, value)))
        return min(max((number - self.low) / (self.high - self.low), 0.0), 1.0)

    def __str__(self) -> str:
        """What it may be, such as "tendon.stiffness 4 to 30 N/cm"."""
        if self.choices:
            return f"{self.key} {' | '.join(str(choice) for choice in self.choices)}"
        unit = self.factor.unit
        if unit is None:
            return f"{self.key} {self.low:g} to {self.high:g}"
        return f"{self.key} {show_quantity(self.low, unit)} to {show_quantity(self.high, unit)}"


def read_parameter(key: str, given: object, design: Design) -> Parameter:
    """Read a parameter as a goal file has it.

    Args:
        key: of the design, dotted.
        given: a table with `low`, `high` and perhaps `step`; or a list of choices, or a range with a step, as a study's
            factors.
        design: that is varied.

    Raises:
        InputError: an unknown key, or values that are not allowed; the caller knows the table.
    """
    if isinstance(given, Mapping):
        with error_prefix(f"{key}."):
            table = read_part(RangeEntry, given)
        return _between(key, table.model_dump(exclude_unset=True), design)
    factor = read_factor(key, given, type(design))
    values = [_si(factor, value) for value in factor.values]
    ordered = all(isinstance(value, float | int) and not isinstance(value, bool) for value in values)
    if ordered:
        by_size = sorted(range(len(values)), key=lambda place: float(str(values[place])))
        factor = Factor(key=key, model=type(design), values=tuple(factor.values[place] for place in by_size))
    return Parameter(factor=factor, low=0.0, high=float(len(values)), ordered=ordered)


def _between(key: str, given: Mapping[str, object], design: Design) -> Parameter:
    """A parameter between two values, with steps or without."""
    quantity = key_quantity(key, type(design))
    if quantity is None and not isinstance(key_value(design, key), float):
        raise InputError(f"{key}: need a list or a range; only numbers with fractions, or with units, lie between two")
    factor = Factor(key=key, model=type(design))
    numbers = {}
    for name, value in given.items():
        with error_prefix(f"{key}.{name}: "):
            numbers[name] = _number(value) if quantity is None else quantity.parse(value)
            if quantity is not None and name != "step":
                quantity.read(value, in_si=False)
    low, high = numbers["low"], numbers["high"]
    if not low < high:
        raise InputError(f"{key}.high: need > low, {as_written(given['low'])}, got {as_written(given['high'])}")
    if "step" not in numbers:
        return Parameter(factor=factor, low=low, high=high)
    step = numbers["step"]
    if not 0 < step <= high - low or (high - low) / step >= _MOST_STEPS:
        raise InputError(f"{key}.step: need > 0 and at most high - low, got {as_written(given['step'])}")
    count = math.floor((high - low) / step * (1 + 1e-12) + 1e-9) + 1
    unit = factor.unit
    # in the unit that is shown, in which steps are round
    scale = 1.0 if unit is None else parse_quantity(f"1 {unit.display}", unit)
    if hint := undivided(low / scale, high / scale, step / scale):
        shown = "" if unit is None else f" (in {unit.display})"
        raise InputError(
            f"{key}.step: need one that divides high - low, {hint}{shown}, got {as_written(given['step'])}"
        )
    steps = [float(f"{(low + place * step) / scale:.12g}") for place in range(count)]
    texts: Sequence[object] = steps if unit is None else [f"{each:.12g} {unit.display}" for each in steps]
    stepped = Factor(key=key, model=type(design), values=tuple(texts))
    return Parameter(factor=stepped, low=0.0, high=float(count))


def _number(value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise InputError(f"need a number, got {as_written(value)}")
    return float(value)


def _si(factor: Factor, value: object) -> object:
    """A value in SI where it has a unit."""
    unit = factor.unit
    if unit is not None and isinstance(value, str):
        return parse_quantity(value, unit)
    return value
