"""Parameters of an optimisation: keys of a design that vary between bounds, in steps, or among choices."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from forficula.design import Design, key_quantity, key_value
from forficula.design.file_fields import DesignValue, entry
from forficula.design.files.rejection import read_section
from forficula.design.section import Section
from forficula.errors import InputError, error_prefix
from forficula.goals.value_at import choice_at, design_file_value
from forficula.quantities import as_written, parse_quantity, show_quantity
from forficula.study.factors import Factor, read_factor, undivided

_MOST_STEPS = 1_000_000


class RangeEntry(Section):
    """Range of a key in a file."""

    low: DesignValue = entry("least value of the key", ...)
    high: DesignValue = entry("largest value of the key", ...)
    step: DesignValue = entry("difference between two allowed values; without a step, every value between is allowed")


@dataclass(frozen=True, kw_only=True)
class Parameter:
    """Key of the design and the values that it may have.

    Attributes:
        factor: the key and its choices, if it has choices; numbers are sorted in rising order.
        low: least value, SI; 0 for choices.
        high: largest value, SI; the number of choices for choices.
        ordered: whether neighbouring choices are similar: true for numbers and texts with units, false for words.
    """

    factor: Factor
    low: float
    high: float
    ordered: bool = True

    @property
    def key(self) -> str:
        """Dotted key of the design."""
        return self.factor.key

    @property
    def choices(self) -> tuple[object, ...]:
        """Allowed values; empty for a continuous parameter."""
        return self.factor.values

    def value(self, share: float) -> object:
        """Return the value at a fraction in [0, 1] of the range, as in a design file.

        Each choice occupies an equal part of the range.
        """
        share = min(max(share, 0.0), 1.0)
        if self.choices:
            return choice_at(self.choices, share)
        return design_file_value(self.low + share * (self.high - self.low), self.factor.unit)

    def share(self, value: object) -> float:
        """Return the fraction of the range at which a value lies (SI, or as in a design file).

        A choice lies in the middle of its part.

        Raises:
            InputError: the value is none of the choices.
        """
        if self.choices:
            for index, choice in enumerate(self.choices):
                if _si(self.factor, choice) == _si(self.factor, value):
                    return (index + 0.5) / len(self.choices)
            raise InputError(f"{self.key}: need one of its choices, got {as_written(value)}")
        number = float(str(_si(self.factor, value)))
        return min(max((number - self.low) / (self.high - self.low), 0.0), 1.0)

    def __str__(self) -> str:
        """Return the key with its values, such as "tendon.stiffness 4 to 30 N/cm"."""
        if self.choices:
            return f"{self.key} {' | '.join(str(choice) for choice in self.choices)}"
        unit = self.factor.unit
        if unit is None:
            return f"{self.key} {self.low:g} to {self.high:g}"
        return f"{self.key} {show_quantity(self.low, unit)} to {show_quantity(self.high, unit)}"


def read_parameter(key: str, value: object, design: Design) -> Parameter:
    """Read a parameter as a goal file has it.

    Args:
        key: dotted key of the design.
        value: a table with `low`, `high` and an optional `step`; or a list of choices or a range with a step, as for
            factors of a study.
        design: the design that is varied.

    Raises:
        InputError: an unknown key, or values that are not allowed. The caller adds the name of the table.
    """
    if isinstance(value, Mapping):
        with error_prefix(f"{key}."):
            table = read_section(RangeEntry, value)
        return _between(key, table.model_dump(exclude_unset=True), design)
    factor = read_factor(key, value, type(design))
    values = [_si(factor, choice) for choice in factor.values]
    ordered = all(isinstance(number, float | int) and not isinstance(number, bool) for number in values)
    if ordered:
        by_size = sorted(range(len(values)), key=lambda index: float(str(values[index])))
        factor = Factor(key=key, model=type(design), values=tuple(factor.values[index] for index in by_size))
    return Parameter(factor=factor, low=0.0, high=float(len(values)), ordered=ordered)


def _between(key: str, table: Mapping[str, object], design: Design) -> Parameter:
    """Return a parameter between two values, with or without steps."""
    quantity = key_quantity(key, type(design))
    if quantity is None and not isinstance(key_value(design, key), float):
        raise InputError(f"{key}: need a list or a range; only numbers with fractions, or with units, lie between two")
    factor = Factor(key=key, model=type(design))
    numbers = {}
    for name, value in table.items():
        with error_prefix(f"{key}.{name}: "):
            numbers[name] = _number(value) if quantity is None else quantity.parse(value)
            if quantity is not None and name != "step":
                quantity.read(value, in_si=False)
    low, high = numbers["low"], numbers["high"]
    if not low < high:
        raise InputError(f"{key}.high: need > low, {as_written(table['low'])}, got {as_written(table['high'])}")
    if "step" not in numbers:
        return Parameter(factor=factor, low=low, high=high)
    step = numbers["step"]
    if not 0 < step <= high - low or (high - low) / step >= _MOST_STEPS:
        raise InputError(f"{key}.step: need > 0 and at most high - low, got {as_written(table['step'])}")
    count = math.floor((high - low) / step * (1 + 1e-12) + 1e-9) + 1
    unit = factor.unit
    # in the display unit, in which steps are round numbers
    scale = 1.0 if unit is None else parse_quantity(f"1 {unit.display}", unit)
    if hint := undivided(low / scale, high / scale, step / scale):
        shown = "" if unit is None else f" (in {unit.display})"
        raise InputError(
            f"{key}.step: need one that divides high - low, {hint}{shown}, got {as_written(table['step'])}"
        )
    steps = [float(f"{(low + index * step) / scale:.12g}") for index in range(count)]
    texts: Sequence[object] = steps if unit is None else [f"{number:.12g} {unit.display}" for number in steps]
    stepped = Factor(key=key, model=type(design), values=tuple(texts))
    return Parameter(factor=stepped, low=0.0, high=float(count))


def _number(value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise InputError(f"need a number, got {as_written(value)}")
    return float(value)


def _si(factor: Factor, value: object) -> object:
    """Return a value in SI if it has a unit."""
    unit = factor.unit
    if unit is not None and isinstance(value, str):
        return parse_quantity(value, unit)
    return value
