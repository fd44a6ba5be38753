"""Manufacturing tolerances: deviations of built structures from their design, and designs with such deviations."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, Literal

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.design import Design, check_keys_once, key_quantity, key_value, numbered_key
from forficula.design.file_fields import entry
from forficula.design.files.rejection import read_section
from forficula.design.section import Quantity, Section, field_quantity
from forficula.design.sheets.crease_law_section import CreaseLawSection
from forficula.errors import InputError, error_prefix
from forficula.material.law.crease_law_file import CreaseLawFile, load_crease_law
from forficula.material.law.law_file import load_law
from forficula.names import near_name
from forficula.quantities import Unit, as_written, format_quantity, parse_quantity, show_quantity

DEFAULT_SHARE = 0.1
SIZE = 'percentage such as "10 %", or as in a design'
# sections with the load, the measurements, and values that parts do not have
_NOT_BUILT = ("protocol", "drive", "measure", "support", "table", "make", "stops")
# range of validity of a law, which changes no run
_KNOWLEDGE = ("largest_strain", "lowest_strain_rate", "highest_strain_rate")
# size of the specimen of a law of creases, which changes no run
_SPECIMEN = ("thickness", "width")
# normal distributions are cut at 4.8 standard deviations
_TAIL = 1e-6
_SHARE = Unit(display="%", si="", example="10 %")
_NINETY_FIVE = float(scipy.special.ndtri(0.975))


class ToleranceEntry(Section):
    """A tolerance in a file that is a table, not a text."""

    distribution: Literal["uniform", "normal"] = entry("distribution of the built values", "uniform")
    size: Annotated[Any, SIZE] = entry("largest deviation (uniform), or standard deviation (normal)")
    intervals_of: Annotated[str | None, "path"] = entry(
        "for the law of a tendon or of creases: file of a fitted law whose 95 % intervals are used"
    )


@dataclass(frozen=True, kw_only=True)
class Deviation:
    """Deviation of a built value from its design value.

    Attributes:
        key: dotted key of the design.
        distribution: "uniform", up to its size in both directions, or "normal", with its size as the standard
            deviation.
        size: SI, or a fraction of the design's value.
        relative: whether the size is a fraction.
    """

    key: str
    distribution: Literal["uniform", "normal"]
    size: float
    relative: bool

    def width(self, value: float) -> float:
        """Return the half width or standard deviation about a value of the design, SI."""
        return self.size * abs(value) if self.relative else self.size

    def offsets(self, probabilities: Array) -> Array:
        """Return the quantiles of the deviation at these probabilities, in widths, same shape."""
        if self.distribution == "normal":
            return np.asarray(scipy.stats.norm.ppf(np.clip(probabilities, _TAIL, 1 - _TAIL)))
        return np.asarray(2.0 * probabilities - 1.0)

    def text(self, unit: Unit) -> str:
        """Return the tolerance in words, such as "± 10 %" or "normal, σ = 0.1 mm"."""
        size = f"{100 * self.size:.4g} %" if self.relative else show_quantity(self.size, unit)
        return f"± {size}" if self.distribution == "uniform" else f"normal, σ = {size}"


def default_deviations(design: Design) -> tuple[Deviation, ...]:
    """Return 10 %, uniform, for every positive number with a unit outside the protocol, in the design's order."""
    return tuple(
        Deviation(key=key, distribution="uniform", size=DEFAULT_SHARE, relative=True) for key in positive_keys(design)
    )


def positive_keys(design: Design) -> tuple[str, ...]:
    """Return the keys of positive numbers with units, without loads, measurements and lists of numbers."""
    keys = []
    for name in type(design).model_fields:
        if name not in _NOT_BUILT:
            keys += [key for key, value in _numbers(getattr(design, name), name) if value > 0]
    return tuple(keys)


def _numbers(value: object, key: str) -> Iterator[tuple[str, float]]:
    """Yield the numbers with units in a section of a design, or in a list of sections, with their keys."""
    if isinstance(value, Design):
        # a part of an assembly, which is in the medium of the assembly
        inside = [name for name in positive_keys(value) if not name.startswith("medium.")]
        yield from ((f"{key}.{name}", key_value(value, name)) for name in inside)
    elif isinstance(value, Section):
        without_effect = _SPECIMEN if isinstance(value, CreaseLawSection) else _KNOWLEDGE
        for name, field in type(value).model_fields.items():
            part = getattr(value, name)
            if field_quantity(field) is not None and isinstance(part, float) and name not in without_effect:
                yield f"{key}.{name}", part
            else:
                yield from _numbers(part, f"{key}.{name}")
    elif isinstance(value, tuple):
        for number, entry in enumerate(value):
            yield from _numbers(entry, f"{key}.{getattr(entry, 'name', None) or number}")


def read_deviations(tolerances: Mapping[str, object], design: Design) -> tuple[Deviation, ...]:
    """Read the tolerances of a goal file.

    Args:
        tolerances: tolerances by key of the design: a text such as "10 %" or "0.1 mm", uniform in both directions; a
            table with `distribution` and `size`; for `tendon.law` and `crease.law` a table with `intervals_of`, a law
            file whose 95 % intervals are used as independent normal distributions, because the file has no
            correlations. `all` means every positive number with a unit that is not in the protocol; other keys take
            precedence, and "none" removes one.
        design: the nominal design.

    Raises:
        InputError: an unknown key, or a value that is not allowed. The caller adds the name of the table.
    """
    check_keys_once(tolerances, design)
    deviations: dict[str, Deviation] = {}
    if "all" in tolerances:
        size, relative = _size("all", tolerances["all"], None)
        deviations = {
            key: Deviation(key=key, distribution="uniform", size=size, relative=relative)
            for key in positive_keys(design)
        }
    # "all" has list entries by their names; a file may have them by their numbers
    key_by_number = {numbered_key(design, key): key for key in deviations}
    for key_in_file, value in tolerances.items():
        if key_in_file == "all":
            continue
        key = key_by_number.get(numbered_key(design, key_in_file), key_in_file)
        if value == "none":
            if deviations.pop(key, None) is None:
                raise InputError(f'{key}: has no tolerance that "none" could remove{near_name(key, deviations)}')
            continue
        with error_prefix(f"{key}."):
            table = read_section(ToleranceEntry, value if isinstance(value, Mapping) else {"size": value})
        if table.intervals_of is None:
            deviations[key] = _deviation(key, table, design)
            continue
        for deviation in _fitted(key, table, design):
            deviations[key_by_number.get(numbered_key(design, deviation.key), deviation.key)] = deviation
    return tuple(deviations.values())


def _deviation(key: str, table: ToleranceEntry, design: Design) -> Deviation:
    """Return one tolerance of one key."""
    quantity = key_quantity(key, type(design), table.size)
    value = key_value(design, key)
    if value is None:
        example = "..." if quantity is None else f'"{quantity.unit.example}"'
        raise InputError(
            f"{key}: has no value in {design.name}, so it cannot have a tolerance; set one first, as in --set"
            f" {key}={example}"
        )
    if isinstance(value, bool) or not isinstance(value, float):
        raise InputError(f"{key}: need a key whose value is a number with fractions, {design.name} has {value!r}")
    if table.size is None:
        raise InputError(f'{key}.size: is missing; give it, as in {{ distribution = "normal", size = "5 %" }}')
    size, relative = _size(key, table.size, quantity)
    if relative and value == 0:
        raise InputError(
            f"{key}: is 0 in {design.name}, so a relative tolerance has no effect; give a tolerance with a unit"
        )
    return Deviation(key=key, distribution=table.distribution, size=size, relative=relative)


def _size(key: str, text: object, quantity: Quantity | None) -> tuple[float, bool]:
    """Return a size, and whether it is a fraction."""
    relative = quantity is None or (isinstance(text, str) and text.strip().endswith("%"))
    with error_prefix(f"{key}: "):
        size = parse_quantity(text, _SHARE if relative or quantity is None else quantity.unit)
    if size <= 0 or (relative and size >= 1):
        rule = "> 0 and < 100 %" if relative else "> 0"
        raise InputError(f"{key}: need a tolerance {rule}, got {as_written(text)}")
    return size, relative


def _fitted(key: str, table: ToleranceEntry, design: Design) -> Iterator[Deviation]:
    """Yield the 95 % intervals of a fitted law as normal distributions about the design's own values."""
    if table.model_fields_set != {"intervals_of"} or table.intervals_of is None:
        entries = as_written(table.model_dump(exclude_unset=True))
        raise InputError(f'{key}: need {{ intervals_of = "my-law.toml" }} without other keys, got {entries}')
    with error_prefix(f"{key}.intervals_of: "):
        widths = _interval_widths(key, table.intervals_of, design)
    for key_of_value, width in widths.items():
        key_value(design, key_of_value)
        yield Deviation(key=key_of_value, distribution="normal", size=width / (2 * _NINETY_FIVE), relative=False)


def _interval_widths(key: str, path: str, design: Design) -> dict[str, float]:
    """Return the widths of the 95 % intervals of a law file, SI, by the keys of the values in the design."""
    widths = {}
    law = load_crease_law(path) if "crease" in key.split(".") else load_law(path)
    if isinstance(law, CreaseLawFile):
        for term, pair in law.intervals.items():
            quantity = key_quantity(f"{key}.{term}", type(design), pair[0])
            assert quantity is not None
            low, high = (parse_quantity(end, quantity.unit) for end in pair)
            widths[f"{key}.{term}"] = high - low
    else:
        for bounds in law.intervals:
            section, _, term = bounds.key.partition(".")
            inside = f"{term}_{section}" if section in ("modulus", "viscosity") else bounds.key
            widths[f"{key}.{inside}"] = bounds.high - bounds.low
    if not widths:
        raise InputError(f"{law.name} has no intervals; need a law that was fitted")
    return widths


def deviation_widths(design: Design, deviations: Sequence[Deviation]) -> Array:
    """Return half widths or standard deviations about a design's values, SI, (deviation,)."""
    return np.array([deviation.width(float(key_value(design, deviation.key))) for deviation in deviations])


def deviating_values(design: Design, deviations: Sequence[Deviation], offsets: Sequence[float]) -> dict[str, object]:
    """Return deviating values of a design, limited to what their keys allow.

    Args:
        design: the nominal design.
        deviations: deviations of some of its keys.
        offsets: in widths, (deviation,).

    Returns:
        By key, as in a design file.
    """
    values: dict[str, object] = {}
    for deviation, offset in zip(deviations, offsets, strict=True):
        nominal = float(key_value(design, deviation.key))
        quantity = key_quantity(deviation.key, type(design))
        value = nominal + float(offset) * deviation.width(nominal)
        if quantity is None:
            values[deviation.key] = value
            continue
        low, high = allowed_ends(design, deviation.key)
        values[deviation.key] = format_quantity(min(max(value, low), high), quantity.unit)
    return values


def allowed_ends(design: Design, key: str) -> tuple[float, float]:
    """Return the least and the largest value that a key of a design may have, SI; infinite if unlimited."""
    quantity = key_quantity(key, type(design))
    if quantity is None:
        return -math.inf, math.inf
    low = quantity.at_least if quantity.at_least > quantity.above else math.nextafter(quantity.above, math.inf)
    high = quantity.at_most if quantity.at_most < quantity.below else math.nextafter(quantity.below, -math.inf)
    return low, high
