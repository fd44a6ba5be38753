"""The size of a specimen, from the file or from the user; both must agree."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from forficula.errors import InputError
from forficula.material.machine.machine_names import all_keys, name_key
from forficula.material.machine.machine_units import AREA, LENGTH, ColumnKind
from forficula.material.machine.recording import Property, message_at_line
from forficula.material.tensile.tensile_test import UNITS, size_rule
from forficula.quantities import as_written, format_quantity, show_quantity

# The better choice first: the length to which the travel refers, before lengths of the whole specimen.
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
_LEVERS = ("Lever arm", "Lever", "Hebelarm", "Hebel", "Bras de levier")
_DIAMETERS = ("d0", "Probendurchmesser", "Specimen diameter", "Diameter", "Durchmesser")
_MOST_ROUNDING = 0.01  # largest relative difference that counts as rounding, for sizes with few digits such as "5"


@dataclass(frozen=True, kw_only=True)
class _Size:
    """A length or an area from the file, SI, with its rounding error."""

    value: float
    rounding: float
    source: str


def specimen_length(properties: Sequence[Property], size: float | None) -> float:
    """Return the length of a specimen before the test, m.

    Args:
        properties: properties in the file.
        size: length from the user, m.

    Raises:
        InputError: file and user disagree beyond rounding, neither gives a length, or the length is impossible.
    """
    return _agreed("length", _first(properties, _LENGTHS, LENGTH, needed=size is None), size)


def specimen_area(properties: Sequence[Property], size: float | None) -> float:
    """Return the cross-section of a specimen before the test, m2: from the file, or computed from edges or diameter.

    Args:
        properties: properties in the file.
        size: area from the user, m2.

    Raises:
        InputError: file and user disagree beyond rounding, neither gives an area, or the area is impossible.
    """
    needed = size is None
    area = _first(properties, _AREAS, AREA, needed=needed)
    if area is None:
        width = _first(properties, _WIDTHS, LENGTH, needed=needed)
        thickness = _first(properties, _THICKNESSES, LENGTH, needed=needed)
        diameter = _first(properties, _DIAMETERS, LENGTH, needed=needed)
        if width and thickness:
            area = _product(width, thickness, 1.0)
        elif diameter:
            area = _product(diameter, diameter, math.pi / 4)
    return _agreed("area", area, size)


def strip_size(key: str, properties: Sequence[Property], size: float | None) -> float | None:
    """Return the width, the thickness or the lever arm of a folded strip, m; None if neither file nor user gives it.

    Args:
        key: "width", "thickness" or "lever".
        properties: properties in the file.
        size: size from the user, m.

    Raises:
        InputError: file and user disagree beyond rounding, or the size is impossible.
    """
    labels = {"width": _WIDTHS, "thickness": _THICKNESSES, "lever": _LEVERS}[key]
    from_file = _first(properties, labels, LENGTH, needed=size is None)
    return None if size is None and from_file is None else _agreed(key, from_file, size)


def _first(properties: Sequence[Property], labels: Sequence[str], kind: ColumnKind, *, needed: bool) -> _Size | None:
    """Return the property in the file with the best of the labels; None without one."""
    by_key = {name_key(entry.label): entry for entry in reversed(properties)}
    best = next((by_key[key] for label in labels for key in all_keys(label) if key in by_key), None)
    if best is None:
        return None
    factor = kind.factor(best.unit)
    if factor is None:
        if not needed:
            return None
        what = f"{as_written(best.unit)} is not its unit" if best.unit else "the unit is missing"
        raise InputError(message_at_line(best.line, f"{best.label}: {what}; {kind.rule()}"))
    return _Size(
        value=best.value * factor, rounding=best.rounding * factor, source=message_at_line(best.line, best.label)
    )


def _product(a: _Size, b: _Size, factor: float) -> _Size:
    """Compute an area from two edges; its relative rounding error is the sum of theirs."""
    rounding = factor * (abs(a.value) * b.rounding + abs(b.value) * a.rounding)
    source = a.source if a is b else f"{a.source} and {b.source}"
    return _Size(value=factor * a.value * b.value, rounding=rounding, source=source)


def _agreed(key: str, from_file: _Size | None, size: float | None) -> float:
    """Return the size from the file or from the user; refuse two sizes that disagree."""
    unit = UNITS[key]
    if size is None:
        if from_file is None:
            raise InputError(f"{key}: is not in the file; give the specimen's {key}, such as {unit.example}")
        if rule := size_rule(key, from_file.value):
            raise InputError(f"{from_file.source}: {rule}")
        return from_file.value
    if rule := size_rule(key, size):
        raise InputError(f"{key}: {rule}")
    if from_file is not None:
        allowed = min(from_file.rounding, _MOST_ROUNDING * abs(from_file.value)) + 1e-9 * abs(from_file.value)
        if abs(from_file.value - size) > allowed:
            other = f"{show_quantity(from_file.value, unit)} ({from_file.source})"
            raise InputError(f"{key}: {format_quantity(size, unit)} was given, but the file has {other}")
    return size
