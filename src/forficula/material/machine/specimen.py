"""The size of a specimen, from the file or from who tested it; both must agree."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from forficula.errors import InputError
from forficula.material.machine.machine_names import all_keys, name_key
from forficula.material.machine.machine_units import AREA, LENGTH, ColumnKind
from forficula.material.machine.recording import Property, at_line
from forficula.material.tensile.tensile_test import UNITS, size_rule
from forficula.quantities import as_written, format_quantity, show_quantity

# The better choice first: the length that the travel is counted from, before lengths of the whole specimen.
_LENGTHS = (
    *("L0", "Messlänge Standardweg", "Gage length, standard travel", "Gauge length, standard travel", "L0 SW"),
    *("L0 - course standard", "Anfangsmesslänge", "Messlänge", "Gage length", "Gauge length", "Initial length"),
    *("Specimen length", "Probenlänge", "Length", "Länge", "Versuchslänge", "Einspannlänge", "Longueur"),
    *("Grip to grip separation at the start position", "Einspannlänge in Startposition", "Grip separation"),
)
_AREAS = (
    *("S0", "A0", "Querschnitt", "Querschnittsfläche", "Probenquerschnitt", "Anfangsquerschnitt", "Cross-section"),
    *("Cross-sectional area", "Cross section area", "Specimen area", "Area", "Fläche", "Section"),
)
_WIDTHS = ("b0", "Probenbreite", "Specimen width", "Width", "Breite")
_THICKNESSES = ("a0", "Probendicke", "Specimen thickness", "Thickness", "Dicke")
_DIAMETERS = ("d0", "Probendurchmesser", "Specimen diameter", "Diameter", "Durchmesser")
_MOST_ROUNDING = 0.01  # a size written as "5" is not known to a tenth


@dataclass(frozen=True, kw_only=True)
class _Size:
    """A length or an area that the file gives, SI, and by how much it may be off for its digits."""

    value: float
    rounding: float
    source: str


def specimen_length(properties: Sequence[Property], given: float | None) -> float:
    """The length of a specimen before the test, m.

    Args:
        properties: of the file.
        given: by the user, m.

    Raises:
        InputError: the file and the user disagree beyond rounding, neither gives it, or no specimen has such a size.
    """
    return _agreed("length", _first(properties, _LENGTHS, LENGTH, needed=given is None), given)


def specimen_area(properties: Sequence[Property], given: float | None) -> float:
    """The area of a specimen's cross-section before the test, m2: as the file gives it, or from its edges or diameter.

    Args:
        properties: of the file.
        given: by the user, m2.

    Raises:
        InputError: the file and the user disagree beyond rounding, neither gives it, or no specimen has such a size.
    """
    needed = given is None
    area = _first(properties, _AREAS, AREA, needed=needed)
    if area is None:
        width = _first(properties, _WIDTHS, LENGTH, needed=needed)
        thickness = _first(properties, _THICKNESSES, LENGTH, needed=needed)
        diameter = _first(properties, _DIAMETERS, LENGTH, needed=needed)
        if width and thickness:
            area = _product(width, thickness, 1.0)
        elif diameter:
            area = _product(diameter, diameter, math.pi / 4)
    return _agreed("area", area, given)


def _first(properties: Sequence[Property], labels: Sequence[str], kind: ColumnKind, *, needed: bool) -> _Size | None:
    """The best of the labels that stands in the file."""
    by_key = {name_key(each.label): each for each in reversed(properties)}
    found = next((by_key[key] for label in labels for key in all_keys(label) if key in by_key), None)
    if found is None:
        return None
    factor = kind.factor(found.unit)
    if factor is None:
        if not needed:
            return None
        what = f"{as_written(found.unit)} is not its unit" if found.unit else "the unit is missing"
        raise InputError(at_line(found.line, f"{found.label}: {what}; {kind.rule()}"))
    return _Size(value=found.value * factor, rounding=found.rounding * factor, source=at_line(found.line, found.label))


def _product(a: _Size, b: _Size, factor: float) -> _Size:
    """An area from two edges, its rounding the sum of theirs."""
    rounding = factor * (abs(a.value) * b.rounding + abs(b.value) * a.rounding)
    source = a.source if a is b else f"{a.source} and {b.source}"
    return _Size(value=factor * a.value * b.value, rounding=rounding, source=source)


def _agreed(key: str, found: _Size | None, given: float | None) -> float:
    """The one size that file and user mean."""
    unit = UNITS[key]
    if given is None:
        if found is None:
            raise InputError(f"{key}: the file does not say it; give the specimen's {key}, such as {unit.example}")
        if rule := size_rule(key, found.value):
            raise InputError(f"{found.source}: {rule}")
        return found.value
    if rule := size_rule(key, given):
        raise InputError(f"{key}: {rule}")
    if found is not None:
        allowed = min(found.rounding, _MOST_ROUNDING * abs(found.value)) + 1e-9 * abs(found.value)
        if abs(found.value - given) > allowed:
            file_says = f"{show_quantity(found.value, unit)} ({found.source})"
            raise InputError(f"{key}: {format_quantity(given, unit)} was given, but the file says {file_says}")
    return given
