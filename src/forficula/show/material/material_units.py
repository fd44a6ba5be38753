"""Legible units of stresses and energies."""

from __future__ import annotations

_STRESS = (("MPa", 1e6), ("kPa", 1e3), ("Pa", 1.0))
_ENERGY = (("MJ/m³", 1e6), ("kJ/m³", 1e3), ("J/m³", 1.0))
_LEAST = 0.1  # least value in a unit; smaller values take the next unit


def stress_unit(largest: float) -> tuple[str, float]:
    """Return the unit for stresses or moduli up to the largest (Pa), and its size in Pa."""
    return _unit(_STRESS, largest)


def energy_unit(largest: float) -> tuple[str, float]:
    """Return the unit for energies by volume up to the largest (J/m3), and its size in J/m3."""
    return _unit(_ENERGY, largest)


def _unit(units: tuple[tuple[str, float], ...], largest: float) -> tuple[str, float]:
    return next((entry for entry in units if abs(largest) >= _LEAST * entry[1]), units[-1])
