"""What tables tell of a part: its size and its mass."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from forficula.make.files.bill import bill_of
from forficula.make.files.lying import lying_size
from forficula.make.part import Part, PartSet
from forficula.make.solid.mesh import MILLIMETRES
from forficula.quantities import show_value

# units that parts are told in, whatever their size, and their factors from SI
_SHOWN = {"m": ("mm", 1e3), "m^2": ("mm²", 1e6), "m^3": ("mm³", 1e9), "kg": ("g", 1e3)}


def size_text(part: Part) -> str:
    """The size of a part as it lies where it is printed, mm, without the unit."""
    return " × ".join(f"{MILLIMETRES * each:.1f}" for each in lying_size(part))


def mass_text(mass: float | None, digits: int = 3) -> str:
    """A mass, kg, in g; of none that the sources of its material give no density for."""
    return "not known" if mass is None else f"{1e3 * mass:#.{digits}g}".rstrip(".") + " g"


def part_masses(parts: PartSet) -> dict[str, float | None]:
    """The mass of one of every part, by its name, as in the bill, kg; None where the density is not known."""
    return {row.part: row.mass for row in bill_of(replace(parts, sheet=None))}


def masses_text(masses: Sequence[float | None]) -> str:
    """The mass of one of some parts, or from the least to the most; nothing where one is not known."""
    known = [mass for mass in masses if mass is not None]
    if len(known) < len(masses) or not known:
        return ""
    least, most = mass_text(min(known)), mass_text(max(known))
    return most if least == most else f"{least.removesuffix(' g')} to {most}"


def material_text(part: Part) -> str:
    """What a part is made of."""
    return part.stock.name or "no name"


def total_mass(parts: PartSet) -> float | None:
    """Of all parts but the sheet, as in the bill, kg; None where the density of one is not known."""
    own = part_masses(parts)
    masses = [part.count * mass for part in parts.parts if (mass := own[part.name]) is not None]
    return sum(masses) if len(masses) == len(parts.parts) else None


def value_text(value: float, unit: str) -> str:
    """A value of a check in the unit of the field; a length in mm, as parts are drawn."""
    if not np.isfinite(value):
        return "–"
    if unit in _SHOWN:
        name, factor = _SHOWN[unit]
        return f"{factor * value:.4g} {name}".replace("-", "−")
    return show_value(value, unit).strip().replace("-", "−")
