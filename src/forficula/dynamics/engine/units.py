"""The units that a model is built in, so that a structure of any size compiles."""

from __future__ import annotations

import math
from dataclasses import dataclass

from forficula.design import Design, in_units
from forficula.structure import Structure


@dataclass(frozen=True, kw_only=True)
class ModelUnits:
    """Powers of ten that bring a structure to the size of 1; speeds stay m/s.

    MuJoCo refuses masses and inertias below 1e-15 in its own units, which an insect's veins have in SI.

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
        """Unit of energy and of torque, J."""
        return self.mass * (self.length / self.time) ** 2

    @property
    def power(self) -> float:
        """Unit of power, W."""
        return self.energy / self.time


def model_units(structure: Structure) -> ModelUnits:
    """Choose the units of a structure: the decades of its size and mass, and a unit of speed of 1 m/s."""
    length = _decade(structure.span)
    return ModelUnits(length=length, mass=_decade(structure.mass), time=length)


def design_in_model_units(design: Design, units: ModelUnits) -> Design:
    """The design with its numbers in the model's units."""
    return in_units(design, length=units.length, mass=units.mass, time=units.time)


def _decade(value: float) -> float:
    return float(f"1e{math.floor(math.log10(value))}")
