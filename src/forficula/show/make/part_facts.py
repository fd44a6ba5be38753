"""Size, mass and material of a part as text."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from forficula.make.files.bill import bill_of
from forficula.make.files.print_orientation import print_size
from forficula.make.part import Part, PartSet
from forficula.make.solid.mesh import MILLIMETRES
from forficula.quantities import show_value

# units of values, independent of their size, and their factors from SI
_SHOWN = {"m": ("mm", 1e3), "m^2": ("mm²", 1e6), "m^3": ("mm³", 1e9), "kg": ("g", 1e3)}


def size_text(part: Part) -> str:
    """Return the size of a part in its printing position, mm, without the unit."""
    return " × ".join(f"{MILLIMETRES * item:.1f}" for item in print_size(part))


def mass_text(mass: float | None, digits: int = 3) -> str:
    """Return a mass, kg, as text in g; "not known" if the material has no known density."""
    return "not known" if mass is None else f"{1e3 * mass:#.{digits}g}".rstrip(".") + " g"


def part_masses(parts: PartSet) -> dict[str, float | None]:
    """Return the mass of one piece of every part, by name, as in the bill, kg; None if the density is not known."""
    return {row.part: row.mass for row in bill_of(replace(parts, sheet=None))}


def masses_text(masses: Sequence[float | None]) -> str:
    """Return the mass of one of several parts, or their range; empty if one is not known."""
    known = [mass for mass in masses if mass is not None]
    if len(known) < len(masses) or not known:
        return ""
    least, most = mass_text(min(known)), mass_text(max(known))
    return most if least == most else f"{least.removesuffix(' g')} to {most}"


def material_text(part: Part) -> str:
    """Return the name of a part's material."""
    return part.stock.name or "no name"


def total_mass(parts: PartSet) -> float | None:
    """Return the mass of all parts except the sheet, as in the bill, kg; None if a density is not known."""
    mass_by_name = part_masses(parts)
    masses = [part.count * mass for part in parts.parts if (mass := mass_by_name[part.name]) is not None]
    return sum(masses) if len(masses) == len(parts.parts) else None


def value_text(value: float, unit: str) -> str:
    """Return a value of a check in the unit of its field; lengths in mm, as in drawings."""
    if not np.isfinite(value):
        return "–"
    if unit in _SHOWN:
        name, factor = _SHOWN[unit]
        return f"{factor * value:.4g} {name}".replace("-", "−")
    return show_value(value, unit).strip().replace("-", "−")
