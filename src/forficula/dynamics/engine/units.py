"""Units of a compiled model, chosen so that structures of any size compile."""

from __future__ import annotations

import math
from dataclasses import dataclass

from forficula.design import Design, in_units
from forficula.structure import Structure


@dataclass(frozen=True, kw_only=True)
class ModelUnits:
    """Powers of ten that scale a structure to a size of about 1; the unit of speed is 1 m/s.

    MuJoCo rejects masses and inertias below 1e-15 in its own units, which the veins of an insect have in SI.


    Attributes:
        length: m.
        mass: kg.
        time: s.
    """

    length: float
    mass: float
    time: float

    @property
    def energy(self) -> float:
        """Return the unit of energy and of torque, J."""
        return self.mass * (self.length / self.time) ** 2

    @property
    def power(self) -> float:
        """Return the unit of power, W."""
        return self.energy / self.time


def model_units(structure: Structure) -> ModelUnits:
    """Return the units for a structure: the decades of its size and mass, and a unit of speed of 1 m/s."""
    length = _decade(structure.span)
    return ModelUnits(length=length, mass=_decade(structure.mass), time=length)


def design_in_model_units(design: Design, units: ModelUnits) -> Design:
    """Return the design with its numbers in the model's units."""
    return in_units(design, length=units.length, mass=units.mass, time=units.time)


def _decade(value: float) -> float:
    return float(f"1e{math.floor(math.log10(value))}")
