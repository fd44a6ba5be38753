"""Factors of a study: keys of the design and their values."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from typing import Annotated, Any, Literal

import numpy as np
import scipy
from pydantic import BeforeValidator

from forficula.arrays import Array
from forficula.design import NO_LAW, Design, key_quantity, names_law, tendon_material
from forficula.design.file_fields import ByKey, DesignValue, entry
from forficula.design.files.provenance import DESCRIPTIVE_KEYS
from forficula.design.files.rejection import read_section
from forficula.design.section import Quantity, Section
from forficula.errors import InputError, error_prefix
from forficula.quantities import Unit, as_written, format_quantity, parse_quantity, plain_value

_RANGE = re.compile(r"\s*(\S+?)\s*\.\.\s*(\S+)\s*(.*?)\s*\bstep\s+(\S+)\s*(.*?)\s*")
MOST_VALUES = 1_000_000
_LONGEST_RANGE = 200


@dataclass(frozen=True, kw_only=True)
class Factor:
    """Key of the design and the values that it takes.

    Attributes:
        key: dotted key of the design.
        model: class of the design.
        values: values as in a design file: texts with units, numbers, words. Empty if the values are sampled.
        distribution: distribution of the values, or None.
    """

    key: str
    model: type[Design]
    values: tuple[object, ...] = ()
    distribution: Distribution | None = None

    @property
    def unit(self) -> Unit | None:
        """Unit of the values; None if they have none or if one of them is a word."""
        quantity = key_quantity(self.key, self.model)
        if quantity is None or any(word in self.values for word in quantity.words):
            return None
        return quantity.unit

    @property
    def dimension(self) -> str:
        """Name in tables."""
        return self.key.replace(".", "_")


@dataclass(frozen=True, kw_only=True)
class Distribution:
    """Distribution of the values of a factor, SI.

    Attributes:
        name: "uniform", "log-uniform" or "normal".
        first: low end, or mean.
        second: high end, or standard deviation.
    """

    name: str
    first: float
    second: float

    def quantiles(self, probabilities: Array) -> Array:
        """Return the quantiles at these probabilities, same shape."""
        match self.name:
            case "normal":
                quantiles = scipy.stats.norm.ppf(probabilities, self.first, self.second)
            case "log-uniform":
                quantiles = scipy.stats.loguniform.ppf(probabilities, self.first, self.second)
            case _:
                quantiles = scipy.stats.uniform.ppf(probabilities, self.first, self.second - self.first)
        return np.asarray(quantiles)


# the parameters of each distribution
DISTRIBUTIONS = {"uniform": ("low", "high"), "log-uniform": ("low", "high"), "normal": ("mean", "deviation")}
VALUES = 'list, or range such as "10..60 N/cm step 10"'


class DistributionEntry(Section):
    """Content of a distribution in a file."""

    distribution: Literal["uniform", "log-uniform", "normal"] = entry("distribution of the values of the key", ...)
    low: DesignValue = entry("least value (uniform, log-uniform)")
    high: DesignValue = entry("largest value (uniform, log-uniform)")
    mean: DesignValue = entry("mean (normal)")
    deviation: DesignValue = entry("standard deviation (normal)")


Values = Annotated[Any, VALUES]
Grid = Annotated[dict[str, Any], BeforeValidator(ByKey(allowed=VALUES))]
Factors = Annotated[
    dict[str, Any], BeforeValidator(ByKey(allowed=f"{VALUES}, or distribution", entry=DistributionEntry))
]


def read_factor(key: str, value: object, model: type[Design]) -> Factor:
    """Read a factor of a study file.

    Args:
        key: dotted key of the design.
        value: a list of values (for "tendon.law" names of materials, paths of law files, or "none"); a range such as
            "10..60 N/cm step 10"; or a table with `distribution` and its two parameters: low and high for uniform and
            log-uniform, mean and deviation for normal.
        model: class of the design.

    Raises:
        InputError: an unknown key, a key on which no run depends, or values that are not allowed.
    """
    value = plain_value(value)
    value = [plain_value(item) for item in value] if isinstance(value, list) else value
    quantity = key_quantity(key, model, value)
    if key in DESCRIPTIVE_KEYS:
        raise InputError(f"{key}: need a key on which runs depend; this one is a word about the design")
    if isinstance(value, list):
        if not value:
            raise InputError(f"{key}: need at least one value, got an empty list")
        _check_values(key, value, model)
        return Factor(key=key, values=tuple(value), model=model)
    if isinstance(value, str) and not names_law(key):
        values = range_values(key, value, numbers=quantity is None)
        _check_values(key, values[:1], model)
        return Factor(key=key, values=values, model=model)
    if isinstance(value, Mapping):
        with error_prefix(f"{key}."):
            table = read_section(DistributionEntry, value)
        return Factor(key=key, distribution=_distribution(key, table, quantity), model=model)
    rule = 'a list, a range such as "1..5 cm step 1", or a distribution'
    if names_law(key):
        rule = 'a list such as ["tpu-82a"]'
    raise InputError(f"{key}: need {rule}, got {value!r}")


def written_in_units(key: str, value: object, model: type[Design]) -> object:
    """Return the value of a factor in the form of a study file: numbers in SI become text with the unit of the key.

    Args:
        key: dotted key of the design.
        value: a list of values, a table of a distribution, or any other value, which is returned unchanged.
        model: class of the design.

    Raises:
        InputError: an unknown key.
    """
    value = plain_value(value)
    if not isinstance(value, list | tuple | Mapping) or (quantity := key_quantity(key, model, value)) is None:
        return value

    def written(number: object) -> object:
        number = plain_value(number)
        if isinstance(number, bool) or not isinstance(number, int | float) or not math.isfinite(number):
            return number
        return format_quantity(float(number), quantity.unit)

    if isinstance(value, Mapping):
        return {name: written(number) for name, number in value.items()}
    return [written(number) for number in value]


def range_values(key: str, text: str, *, numbers: bool = False) -> tuple[object, ...]:
    """Return the values of a range such as "10..60 N/cm step 10", ends included, as in a design file.

    Args:
        key: key that error messages name.
        text: the range.
        numbers: whether a range without a unit gives numbers. Otherwise it gives texts without a unit.

    Raises:
        InputError: not a range, a step that does not divide the range, or more than a million values.
    """
    match = _RANGE.fullmatch(text) if len(text) <= _LONGEST_RANGE else None
    if match is None:
        raise InputError(f'{key}: need a range such as "10..60 N/cm step 10", got {as_written(text)}')
    first, last, unit, step, step_unit = match.groups()
    if step_unit and step_unit != unit:
        raise InputError(f'{key}: need the step in the unit of the range, "{unit}", got "{step_unit}"')
    try:
        low, high, width = float(first), float(last), float(step)
    except ValueError:
        raise InputError(f'{key}: need three numbers, as in "10..60 N/cm step 10", got "{text}"') from None
    if not all(map(math.isfinite, (low, high, width))) or width <= 0 or high < low:
        raise InputError(f'{key}: need a range that rises by a step > 0, got "{text}"')
    steps = (high - low) / width * (1 + 1e-12) + 1e-9
    if steps >= MOST_VALUES:
        raise InputError(f'{key}: need at most {MOST_VALUES} values, got {steps:.6g} steps in "{text}"')
    if hint := undivided(low, high, width):
        raise InputError(f'{key}: need a step that divides the range, {hint}, got "{text}"')
    count = math.floor(steps) + 1
    # decimal arithmetic: three times 0.1 is 0.3, as a person would write it
    values = [float(Decimal(first) + index * Decimal(step)) for index in range(count)]
    if numbers and not unit:
        return tuple(int(value) if value.is_integer() else value for value in values)
    return tuple(f"{value:.12g} {unit}".strip() for value in values)


def undivided(low: float, high: float, step: float) -> str:
    """Suggest ends and steps for a range that its step does not divide; "" if it does.

    Args:
        low: first value, in the unit in which the range is written.
        high: last value, >= low.
        step: difference between two values, > 0.
    """
    number = (high - low) / step
    if math.isclose(number, round(number), rel_tol=1e-9, abs_tol=1e-9):
        return ""
    nearest_counts = (math.floor(number), math.floor(number) + 1)
    ends = [f"{low + steps * step:.12g}" for steps in nearest_counts if steps]
    # only steps that can be written in a few digits
    texts = [f"{(high - low) / steps:.6g}" for steps in nearest_counts if steps]
    widths = [
        text for text in texts if float(text) and abs(math.remainder(high - low, float(text))) <= 1e-9 * float(text)
    ]
    hint = f"such as an end of {' or '.join(ends)}"
    return f"{hint} or a step of {' or '.join(widths)}" if widths else hint


def _check_values(key: str, values: Sequence[object], model: type[Design]) -> None:
    """Reject values that cannot be coordinates of a table, and equal values. Bounds are not checked here."""
    quantity = key_quantity(key, model)
    known: dict[object, object] = {}
    for value in values:
        if names_law(key) and isinstance(value, str) and value != NO_LAW:
            with error_prefix(f"{key}: "):
                tendon_material(value)
        if quantity is None:
            if not isinstance(value, str | int | float | list):
                raise InputError(f"{key}: need numbers or words, got {as_written(value)}")
            if isinstance(value, float) and not math.isfinite(value):
                raise InputError(f"{key}: need finite numbers, got {as_written(value)}")
            same: object = _comparable(value)
        elif value in quantity.words:
            same = value
        else:
            with error_prefix(f"{key}: "):
                same = float(f"{quantity.parse(value):.12g}")  # rounded, because units have factors: 50 mm equals 5 cm
        if same in known:
            twice = as_written(value) if value == known[same] else f"{as_written(known[same])} and {as_written(value)}"
            raise InputError(f"{key}: need values that differ, got {twice}{' twice' * (value == known[same])}")
        known[same] = value


def _comparable(value: object) -> object:
    """Return a value without a unit in a form in which equal values are equal, but true differs from 1."""
    if isinstance(value, list):
        return tuple(_comparable(item) for item in value)
    return type(value) is bool, value


def _finite(value: object) -> float:
    """Return a finite number; raise InputError for anything else."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise InputError(f"need a number, got {as_written(value)}")
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise InputError(f"need a finite number, got {as_written(value)}")
    return number


def _distribution(key: str, table: DistributionEntry, quantity: Quantity | None) -> Distribution:
    name = table.distribution
    names = DISTRIBUTIONS[name]
    if table.model_fields_set != {"distribution", *names}:
        fields = ", ".join(field for field in type(table).model_fields if field in table.model_fields_set)
        raise InputError(f"{key}: a {name} distribution needs {names[0]} and {names[1]}, got {fields}")
    numbers = []
    for parameter in names:
        value = getattr(table, parameter)
        with error_prefix(f"{key}.{parameter}: "):
            numbers.append(_finite(value) if quantity is None else parse_quantity(value, quantity.unit))
    first, second = numbers
    if name == "normal" and second <= 0:
        raise InputError(f"{key}.deviation: need > 0, got {table.deviation}")
    if not math.isfinite(second - first):
        raise InputError(f"{key}.high: need a finite distance from low, {table.low}, got {table.high}")
    if name != "normal" and second <= first:
        raise InputError(f"{key}.high: need > low, {table.low}, got {table.high}")
    if name == "log-uniform" and first <= 0:
        raise InputError(f"{key}.low: need > 0, got {table.low}")
    return Distribution(name=name, first=first, second=second)
