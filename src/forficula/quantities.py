"""Conversion between text with units and SI floats: "10 N/cm" is 1000.0 inside the package."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cache, lru_cache
from typing import TYPE_CHECKING, TypeGuard

from forficula.errors import InputError

if TYPE_CHECKING:
    from pint import UnitRegistry

_NUMBER_THEN_UNIT = re.compile(
    r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|[+-]?(?:nan|inf(?:inity)?))(.*)", re.I | re.S
)
# names with one-digit powers only: pint would compute a tower of powers endlessly
_UNIT = re.compile(
    r"[\s(]*(?:1\s*/\s*)?[^\W\d_]+(?:\s*(?:\^|\*\*)\s*-?\d)?(?:[\s*/·()]+[^\W\d_]+(?:\s*(?:\^|\*\*)\s*-?\d)?)*[\s)]*|[°%]"
)
_ROUNDING = 1e-12  # [chosen] share below which a value is rounding: 1e-21 J is less than a molecule's thermal energy
_LONGEST_UNIT = 60
_LONGEST_SHOWN = 60
_MOST_DIGITS = 12  # with more digits, a number in the display unit shows the rounding of its factor
# name, factor from SI, and the least SI value for this unit; smaller values have the last unit
READING_UNITS = {
    "J": (("J", 1.0, 0.1), ("mJ", 1e3, 1e-4), ("µJ", 1e6, 1e-7), ("nJ", 1e9, 1e-10)),
    "N m": (("N cm", 1e2, 1e-3), ("mN cm", 1e5, 1e-6), ("µN cm", 1e8, 1e-9), ("nN cm", 1e11, 1e-12)),
    "m": (("m", 1.0, 2.0), ("cm", 1e2, 0.02), ("mm", 1e3, 1e-4), ("µm", 1e6, 1e-7)),
    "s": (("s", 1.0, 0.2), ("ms", 1e3, 1e-4), ("µs", 1e6, 1e-7)),
    "N": (("N", 1.0, 0.1), ("mN", 1e3, 1e-4), ("µN", 1e6, 1e-7)),
    "Pa": (("GPa", 1e-9, 1e9), ("MPa", 1e-6, 1e5), ("kPa", 1e-3, 1e2), ("Pa", 1.0, 0.0)),
    "rad": (("deg", math.degrees(1.0), 0.0),),
}
# factors of common units by SI unit, to avoid loading pint, which takes half a second
_USUAL = {
    "": {"%": 0.01, "times": 1.0},
    "1/s": {},
    "J": {"mJ": 1e-3},
    "J/m^3": {"kJ/m^3": 1e3},
    "N": {"mN": 1e-3},
    "N m": {"N cm": 1e-2, "mN cm": 1e-5},
    "N m s/rad": {},
    "N m s/rad/m": {},
    "N m/rad": {},
    "N m/rad/m": {},
    "N s/m": {},
    "N s/m^2": {},
    "N/m": {"N/cm": 1e2},
    "N/m^2": {},
    "Pa": {"kPa": 1e3, "MPa": 1e6, "GPa": 1e9},
    "Pa s": {"kPa s": 1e3, "MPa s": 1e6},
    "Pa s^2": {"MPa s^2": 1e6},
    "Pa s^3": {"MPa s^3": 1e6},
    "dimensionless": {"%": 0.01},
    "kg": {"g": 1e-3},
    "kg m^2": {},
    "kg/m^3": {"g/cm^3": 1e3},
    "m": {"cm": 1e-2, "mm": 1e-3, "µm": 1e-6},
    "m/s^2": {},
    "m^2": {"mm^2": 1e-6},
    "rad": {"deg": math.radians(1.0)},
    "rad/s": {"deg/s": math.radians(1.0)},
    "s": {"µs": 1e-6, "ms": 1e-3, "min": 60.0, "h": 3600.0, "d": 86400.0},
}


# exponents of length, mass and time in the SI units that `Unit.si` consists of
_DIMENSIONS = {
    "1": (0, 0, 0),
    "dimensionless": (0, 0, 0),
    "J": (2, 1, -2),
    "N": (1, 1, -2),
    "Pa": (-1, 1, -2),
    "kg": (0, 1, 0),
    "m": (1, 0, 0),
    "rad": (0, 0, 0),
    "s": (0, 0, 1),
}
# a factor of a unit, such as "/m^3" in "kg/m^3"
_SI_FACTOR = re.compile(r"\s*(/?)\s*([^\W\d_]+|1)(?:\^(-?\d))?")


@dataclass(frozen=True)
class Unit:
    """The units of one kind of quantity.

    Attributes:
        si: coherent SI unit, such as "N/m"; its factor is exactly 1.
        display: unit for display, such as "N/cm"; the SI unit if not given.
        example: valid value for error messages; needed only for quantities that are read.
    """

    si: str
    display: str = field(default="", kw_only=True)
    example: str = field(default="", kw_only=True)

    def __post_init__(self) -> None:
        if not self.display:
            object.__setattr__(self, "display", self.si)


def parse_quantity(text: object, unit: Unit) -> float:
    """Convert text such as "10 N/cm" to an SI float.

    Args:
        text: a number followed by a unit of the same dimension as `unit`.
        unit: expected unit.

    Returns:
        The value in `unit.si`.

    Raises:
        InputError: no unit, an unknown unit, a wrong dimension, no number, or a number that is not finite. The message
            has the value and a valid example; the caller adds the key.
    """
    return _parsed_text(text, unit) if isinstance(text, str) and len(text) <= _LONGEST_KEPT else _parsed(text, unit)


def _parsed(text: object, unit: Unit) -> float:
    right, got = f'such as "{unit.example}"', f"got {as_written(text)}"
    if isinstance(text, float) and not math.isfinite(text):
        raise InputError(f"need a finite number with a unit {right}, {got}")
    if isinstance(text, int | float) and not isinstance(text, bool):
        raise InputError(f"the unit is missing; write it as text {right}, {got}")
    if not isinstance(text, str):
        raise InputError(f"need text with a unit {right}, {got}")
    match = _NUMBER_THEN_UNIT.fullmatch(text)
    if match is None:
        raise InputError(f"need a number and a unit {right}, {got}")
    number, unit_text = float(match[1]), match[2].strip()
    if not math.isfinite(number):
        raise InputError(f"need a finite number with a unit {right}, {got}")
    if re.match(r",\d", unit_text):
        raise InputError(f"write decimals with a point {right}, {got}")
    if not unit_text:
        raise InputError(f"the unit is missing; write it {right}, {got}")
    value = number * _factor(unit_text, unit, text)
    if not math.isfinite(value):
        raise InputError(f"need a finite number with a unit {right}, {got}")
    return value


_LONGEST_KEPT = 100
# texts of a file are parsed again for each design that is derived from it
_parsed_text = lru_cache(maxsize=4096)(_parsed)


def format_quantity(value: float, unit: Unit) -> str:
    """Write an SI float as text that `parse_quantity` converts to exactly the same value.

    Args:
        value: value in `unit.si`.
        unit: units for writing.

    Returns:
        Text in `unit.display` with the fewest digits that are exact. Text in `unit.si` if no number of digits is exact,
        or if more than 12 digits are needed and that text is shorter.
    """
    factor, in_si = _factor(unit.display, unit, value), f"{value!r} {unit.si}"
    for digits in range(1, 18):
        number = float(f"{value / factor:.{digits}g}")
        if number * factor == value:
            text = f"{repr(number).removesuffix('.0')} {unit.display}"
            return text if digits <= _MOST_DIGITS or len(text) <= len(in_si) else in_si
    return in_si


@cache
def dimension(unit: Unit) -> tuple[int, int, int]:
    """Return the exponents of length, mass and time in a unit that consists of SI units; angles count as numbers.

    Every simulation needs them. Loading pint for them would take a quarter of the main command's time.
    """
    length = mass = time = 0
    for divided, name, power in _SI_FACTOR.findall(unit.si):
        of_length, of_mass, of_time = _DIMENSIONS[name]
        exponent = int(power or 1) * (-1 if divided else 1)
        length, mass, time = length + exponent * of_length, mass + exponent * of_mass, time + exponent * of_time
    return length, mass, time


def round_below(most: float) -> float:
    """Return the largest of 1, 2 and 5 times a power of ten that does not exceed a number > 0, for scale bars.

    >>> round_below(0.07), round_below(430)
    (0.05, 200.0)
    """
    power = 10.0 ** math.floor(math.log10(most))
    return next(steps * power for steps in (5, 2, 1) if steps * power <= most)


def as_written(value: object) -> str:
    """Write a value for an error message: as in a design file, on one short line."""
    # with more levels, nested lists and tables have more brackets than the line has characters
    return _written(value, _LONGEST_SHOWN // 2)


def _written(value: object, levels: int) -> str:
    """Write a value on one short line, with nested lists and tables down to a number of levels."""
    match value:
        case bool():
            text = str(value).lower()
        case str():
            text = json.dumps(value[: 2 * _LONGEST_SHOWN], ensure_ascii=False)
            # lone surrogates, which cannot be encoded
            text = re.sub("[\ud800-\udfff]", lambda half: f"\\u{ord(half[0]):04x}", text)
        case list() | tuple() | dict() if levels == 0:
            text = "..."
        case list() | tuple():
            text = f"[{_first_of(_written(item, levels - 1) for item in value)}]"
        case dict():
            entries = (f"{str(key)[:_LONGEST_SHOWN]} = {_written(item, levels - 1)}" for key, item in value.items())
            text = f"{{{_first_of(entries)}}}"
        case int() if abs(value) >= 10**_LONGEST_SHOWN:
            text = "a whole number of very many digits"
        case _:
            text = str(value)
    text = " ".join(text.split())
    return text if len(text) <= _LONGEST_SHOWN else f"{text[: _LONGEST_SHOWN - 3]}..."


def _first_of(texts: Iterable[str]) -> str:
    """Join texts by commas until they are longer than one line."""
    joined, length = [], 0
    for text in texts:
        joined.append(text)
        length += len(text) + 2
        if length > _LONGEST_SHOWN + 2:
            break
    return ", ".join(joined)


def plain_value(value: object) -> object:
    """Convert numbers, including 0-d arrays, and arrays of numpy to Python's; return other values unchanged."""
    if getattr(value, "shape", None) == () and hasattr(value, "item"):
        return value.item()
    return value.tolist() if hasattr(value, "tolist") and hasattr(value, "dtype") else value


def is_whole(value: object, least: int, most: float = math.inf) -> TypeGuard[int]:
    """Return whether a value is a whole number between bounds; True and False are not."""
    return isinstance(value, int) and not isinstance(value, bool) and least <= value <= most


def reading_unit(unit: str, largest: float) -> tuple[str, float]:
    """Choose a unit in which values are easy to read.

    Args:
        unit: SI unit of the values; other units are chosen for "J", "N m", "m", "s", "N", "Pa" and "rad".
        largest: largest of the values, in this unit.

    Returns:
        The name of the unit and its factor from SI; torques are in N cm, as is usual in the field. If all values are
        0, the SI unit if it is among the units.
    """
    names = READING_UNITS.get(unit, ((unit, 1.0, 0.0),))
    if largest == 0:
        return next((entry for entry in names if entry[1] == 1), names[0])[:2]
    return next((entry for entry in names if largest >= entry[2]), names[-1])[:2]


def show_quantity(value: float, unit: Unit, digits: int = 4) -> str:
    """Write an SI float as readable text, with a number of significant digits in the display unit."""
    return f"{value / _factor(unit.display, unit, value):.{digits}g} {unit.display}"


def show_value(value: float, unit: str, digits: int = 4, *, largest: float = 0.0) -> str:
    """Write an SI float as readable text, in the unit that `reading_unit` chooses.

    A value that is only rounding beside the smallest unit, or beside the largest of several values, is written as 0.
    """
    smallest = 1 / max(factor for _, factor, _ in READING_UNITS.get(unit, [("", math.inf, 0.0)]))
    value = 0.0 if abs(value) < _ROUNDING * max(smallest, largest) else value
    name, factor = reading_unit(unit, abs(value))
    return f"{factor * value:.{digits}g} {name}"


def show_uncertain(value: float, half: float | None, unit: str, digits: int = 4) -> str:
    """Write an SI float with its uncertainty, such as "58.4 ± 0.4 ms", both to the last significant digit.

    The uncertainty has one digit, or two if the first is a 1. An uncertainty that is smaller than the last digit of the
    value, or not known (None), is left out.
    """
    name, factor = reading_unit(unit, abs(value))
    shown, width = factor * value, factor * (half or 0.0)
    if not width or not math.isfinite(width) or f"{shown - width:.{digits}g}" == f"{shown + width:.{digits}g}":
        return f"{shown:.{digits}g} {name}"
    places = max(_digits_of_half(width), 0)
    return f"{shown:.{places}f} ± {width:.{places}f} {name}"


def uncertain_number(value: float, half: float, digits: int = 4) -> str:
    """Write a number with its uncertainty, which is left out if it is smaller than the last digit of the number.

    >>> uncertain_number(0.18268, 0.0004), uncertain_number(4.112e-5, 3e-7), uncertain_number(0.18268, 4e-5)
    ('0.1827 ± 0.0004', '4.11e-05 ± 3e-07', '0.1827')
    """
    plain = f"{value:.{digits}g}"
    first = math.floor(math.log10(abs(value))) if value else None
    if not math.isfinite(half) or half <= (0.0 if first is None else 0.5 * 10.0 ** (first - digits + 1)):
        return plain
    if first is None:
        return f"{plain} ± {half:.1g}"
    places = min(_digits_of_half(half), digits - 1 - first)
    if "e-" in plain:
        of_half = max(places + math.floor(math.log10(half)), 0)
        return f"{value:.{max(places + first, 0)}e} ± {half:.{of_half}e}"
    return f"{value:.{max(places, 0)}f} ± {half:.{max(places, 0)}f}"


def _digits_of_half(half: float) -> int:
    """Return the decimal places of an uncertainty with one digit, or two if the first is a 1."""
    exponent = math.floor(math.log10(half))
    return (1 if half < 2 * 10.0**exponent else 0) - exponent


def show_duration(time: float) -> str:
    """Write a time, s, as readable text: in days, hours or minutes, or as `show_value`."""
    for name, unit in (("d", 86400.0), ("h", 3600.0), ("min", 60.0)):
        if time >= unit:
            return f"{time / unit:.4g} {name}"
    return show_value(time, "s")


@cache
def _registry() -> UnitRegistry[float]:
    """Return the pint registry, created at the first call, because this takes half a second."""
    from pint import UnitRegistry

    registry: UnitRegistry[float] = UnitRegistry(cache_folder=None)
    # pint does not know "Ncm", which is a common notation for torque
    for definition in (
        "Ncm = newton * centimeter",
        "Nmm = newton * millimeter",
        "Nm = newton * meter",
        "mNm = millinewton * meter",
    ):
        registry.define(definition)
    return registry


@cache
def _conversion(unit_text: str, si: str) -> float | None:
    """Return the factor from a unit to SI; None if the dimension differs. Raises pint's errors for an unknown unit."""
    if si in _USUAL and (usual := 1.0 if unit_text == si else _USUAL[si].get(unit_text)) is not None:
        return usual
    registry = _registry()
    source, target = registry.parse_units(unit_text), registry.parse_units(si)
    if source.dimensionality != target.dimensionality:
        return None
    # pint treats angles as numbers, so "%" would be an angle, and "Hz" an angular speed of 1 rad/s
    angles = _angle_power(si)
    if angles > 0 and _angle_power(unit_text) != angles:
        return None
    factor = float(registry.Quantity(1.0, source).to(target).magnitude)
    decimal = float(f"{factor:.12g}")
    # pint's g/cm^3 is 999.9999999999999 kg/m^3: use the decimal number if it agrees within rounding
    return decimal if abs(decimal - factor) <= 4 * math.ulp(factor) else factor


def _angle_power(unit_text: str) -> float:
    """Return the exponent of angle in a unit."""
    registry = _registry()
    _, roots = registry.get_root_units(registry.parse_units(unit_text))
    return float(str(dict(roots._units.items()).get("radian", 0)))


def _factor(unit_text: str, unit: Unit, text: object) -> float:
    """Return the factor from a unit to SI; raise InputError with the whole text for an unknown unit."""
    if len(unit_text) > _LONGEST_UNIT or not _UNIT.fullmatch(unit_text):
        raise InputError(_no_unit(unit_text, unit, text))
    try:
        factor = _conversion(unit_text, unit.si)
    except _pint_raises():
        raise InputError(_no_unit(unit_text, unit, text)) from None
    if factor is None:
        raise InputError(_no_unit(unit_text, unit, text, " of the right kind"))
    return factor


def _no_unit(unit_text: str, unit: Unit, text: object, kind: str = "") -> str:
    return f'{as_written(unit_text)} is not a unit{kind}; write it such as "{unit.example}", got {as_written(text)}'


def _pint_raises() -> tuple[type[Exception], ...]:
    """Return the exceptions that pint raises for text that is not a unit."""
    from tokenize import TokenError

    from pint.errors import PintError

    builtin = (ValueError, TypeError, AttributeError, ArithmeticError, LookupError, AssertionError)
    return (PintError, TokenError, *builtin)
