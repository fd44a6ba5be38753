"""Tolerances: how far the values of a built structure may be off its design's, and designs that are off so."""

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
from forficula.design.files.rejection import read_part
from forficula.design.section import Quantity, Section, field_quantity
from forficula.errors import InputError, error_prefix
from forficula.material.law.law_file import load_law
from forficula.names import near_name
from forficula.quantities import Unit, as_written, format_quantity, parse_quantity, show_quantity

DEFAULT_SHARE = 0.1
SIZE = 'share such as "10 %", or as in a design'
# what is done with a structure, how it is watched, and what changes nothing in it
_NOT_BUILT = ("protocol", "drive", "measure", "support", "make", "stops")
# up to where a law was measured, which changes no run
_KNOWLEDGE = ("largest_strain", "lowest_strain_rate", "highest_strain_rate")
# of normal distributions: quantiles beyond 4.8 deviations are not drawn
_TAIL = 1e-6
_SHARE = Unit(display="%", si="", example="10 %")
_NINETY_FIVE = float(scipy.special.ndtri(0.975))


class ToleranceEntry(Section):
    """A tolerance as files have it where it is no text."""

    distribution: Literal["uniform", "normal"] = entry("distribution of the values that are built", "uniform")
    size: Annotated[Any, SIZE] = entry("largest deviation if uniform, standard deviation if normal")
    intervals_of: Annotated[str | None, "path"] = entry(
        "for a tendon's law: a fitted law whose 95 % intervals are taken"
    )


@dataclass(frozen=True, kw_only=True)
class Deviation:
    """By how much a value of a design is off when it is built.

    Attributes:
        key: of the design, dotted.
        distribution: "uniform", up to its size either way, or "normal", with its size as the standard deviation.
        size: SI, or a share of the design's value.
        relative: whether it is a share.
    """

    key: str
    distribution: Literal["uniform", "normal"]
    size: float
    relative: bool

    def width(self, value: float) -> float:
        """Half the width, or the standard deviation, about a value of the design, SI."""
        return self.size * abs(value) if self.relative else self.size

    def offsets(self, shares: Array) -> Array:
        """By how many widths the value is off below which these shares of what is built lie, in the shares' shape."""
        if self.distribution == "normal":
            return np.asarray(scipy.stats.norm.ppf(np.clip(shares, _TAIL, 1 - _TAIL)))
        return np.asarray(2.0 * shares - 1.0)

    def text(self, unit: Unit) -> str:
        """As sentences have it, such as "10 %" or "normal, 0.1 mm"."""
        size = f"{100 * self.size:.4g} %" if self.relative else show_quantity(self.size, unit)
        return f"± {size}" if self.distribution == "uniform" else f"normal, σ = {size}"


def default_deviations(design: Design) -> tuple[Deviation, ...]:
    """10 %, uniform, on every positive number with a unit that is not the protocol's, in the design's order."""
    return tuple(
        Deviation(key=key, distribution="uniform", size=DEFAULT_SHARE, relative=True) for key in positive_keys(design)
    )


def positive_keys(design: Design) -> tuple[str, ...]:
    """Keys of a design's positive numbers with units, but for what is done with it and entries of lists of numbers."""
    found = []
    for name in type(design).model_fields:
        if name not in _NOT_BUILT:
            found += [key for key, value in _numbers(getattr(design, name), name) if value > 0]
    return tuple(found)


def _numbers(value: object, key: str) -> Iterator[tuple[str, float]]:
    """Numbers with units in a part of a design, or in entries of a list of parts, with their keys."""
    if isinstance(value, Section):
        for name, field in type(value).model_fields.items():
            inside = getattr(value, name)
            if field_quantity(field) is not None and isinstance(inside, float) and name not in _KNOWLEDGE:
                yield f"{key}.{name}", inside
            else:
                yield from _numbers(inside, f"{key}.{name}")
    elif isinstance(value, tuple):
        for number, entry in enumerate(value):
            yield from _numbers(entry, f"{key}.{getattr(entry, 'name', None) or number}")


def read_deviations(given: Mapping[str, object], design: Design) -> tuple[Deviation, ...]:
    """Read tolerances as a goal file has them.

    Args:
        given: by key of the design: text such as "10 %" or "0.1 mm", which is uniform, either way; a table with
            `distribution` and `size`; for `tendon.law` a table with `intervals_of`, a law file whose 95 % intervals
            are taken, each as a normal distribution, for how its values hang together is not in the file. `all` stands
            for every positive number with a unit that is not the protocol's; other keys come before it, and "none"
            takes one out.
        design: that is built.

    Raises:
        InputError: an unknown key, or a value that is not allowed; the caller knows the table.
    """
    check_keys_once(given, design)
    found: dict[str, Deviation] = {}
    if "all" in given:
        size, relative = _size("all", given["all"], None)
        found = {
            key: Deviation(key=key, distribution="uniform", size=size, relative=relative)
            for key in positive_keys(design)
        }
    # "all" calls entries by their names, a file perhaps by their numbers
    called = {numbered_key(design, key): key for key in found}
    for own, value in given.items():
        if own == "all":
            continue
        key = called.get(numbered_key(design, own), own)
        if value == "none":
            if found.pop(key, None) is None:
                raise InputError(f'{key}: has no tolerance that "none" could take away{near_name(key, found)}')
            continue
        with error_prefix(f"{key}."):
            table = read_part(ToleranceEntry, value if isinstance(value, Mapping) else {"size": value})
        if table.intervals_of is None:
            found[key] = _deviation(key, table, design)
            continue
        for each in _fitted(key, table, design):
            found[called.get(numbered_key(design, each.key), each.key)] = each
    return tuple(found.values())


def _deviation(key: str, table: ToleranceEntry, design: Design) -> Deviation:
    """One tolerance of one key."""
    quantity = key_quantity(key, type(design), table.size)
    value = key_value(design, key)
    if value is None:
        raise InputError(f"{key}: is not given in {design.name}, and what is not there cannot be off")
    if isinstance(value, bool) or not isinstance(value, float):
        raise InputError(f"{key}: need a key whose value is a number with fractions, {design.name} has {value!r}")
    if table.size is None:
        raise InputError(f'{key}.size: is missing; give it, as in {{ distribution = "normal", size = "5 %" }}')
    size, relative = _size(key, table.size, quantity)
    if relative and value == 0:
        raise InputError(f"{key}: is 0 in {design.name}, of which no share is more; give a tolerance with a unit")
    return Deviation(key=key, distribution=table.distribution, size=size, relative=relative)


def _size(key: str, given: object, quantity: Quantity | None) -> tuple[float, bool]:
    """A size, and whether it is a share."""
    relative = quantity is None or (isinstance(given, str) and given.strip().endswith("%"))
    with error_prefix(f"{key}: "):
        size = parse_quantity(given, _SHARE if relative or quantity is None else quantity.unit)
    if size <= 0 or (relative and size >= 1):
        rule = "> 0 and < 100 %" if relative else "> 0"
        raise InputError(f"{key}: need a tolerance {rule}, got {as_written(given)}")
    return size, relative


def _fitted(key: str, table: ToleranceEntry, design: Design) -> Iterator[Deviation]:
    """The 95 % intervals of a law's fit as normal distributions about the design's own values."""
    if table.model_fields_set != {"intervals_of"} or table.intervals_of is None:
        given = as_written(table.model_dump(exclude_unset=True))
        raise InputError(f'{key}: need {{ intervals_of = "my-law.toml" }} and nothing else, got {given}')
    with error_prefix(f"{key}.intervals_of: "):
        law = load_law(table.intervals_of)
    if not law.intervals:
        raise InputError(f"{key}.intervals_of: {law.name} has no intervals; need a law that was fitted")
    for bounds in law.intervals:
        section, _, term = bounds.key.partition(".")
        inside = f"{term}_{section}" if section in ("modulus", "viscosity") else bounds.key
        own = f"{key}.{inside}"
        key_value(design, own)
        width = (bounds.high - bounds.low) / (2 * _NINETY_FIVE)
        yield Deviation(key=own, distribution="normal", size=width, relative=False)


def deviation_widths(design: Design, deviations: Sequence[Deviation]) -> Array:
    """Half widths, or standard deviations, about a design's values, SI, (deviation,)."""
    return np.array([each.width(float(key_value(design, each.key))) for each in deviations])


def off_values(design: Design, deviations: Sequence[Deviation], offsets: Sequence[float]) -> dict[str, object]:
    """Values of a design that are off by so many widths each, kept within what their keys allow.

    Args:
        design: whose values they are off.
        deviations: of some of its keys.
        offsets: in widths, (deviation,).

    Returns:
        By key, as a design file has them.
    """
    values: dict[str, object] = {}
    for deviation, offset in zip(deviations, offsets, strict=True):
        own = float(key_value(design, deviation.key))
        quantity = key_quantity(deviation.key, type(design))
        value = own + float(offset) * deviation.width(own)
        if quantity is None:
            values[deviation.key] = value
            continue
        low, high = allowed_ends(design, deviation.key)
        values[deviation.key] = format_quantity(min(max(value, low), high), quantity.unit)
    return values


def allowed_ends(design: Design, key: str) -> tuple[float, float]:
    """The least and the largest value that a key of a design may have, SI; infinite where there is none."""
    quantity = key_quantity(key, type(design))
    if quantity is None:
        return -math.inf, math.inf
    low = quantity.at_least if quantity.at_least > quantity.above else math.nextafter(quantity.above, math.inf)
    high = quantity.at_most if quantity.at_most < quantity.below else math.nextafter(quantity.below, -math.inf)
    return low, high
