"""Dotted keys of a material law, such as "modulus.linear", and the units of their values."""

from __future__ import annotations

import difflib
import re
from collections.abc import Sequence

from forficula.errors import InputError
from forficula.quantities import Unit, as_written, show_quantity

TERMS = ("linear", "quadratic", "cubic")
STRAIN = Unit(display="%", si="dimensionless", example="100 %")
RATE = Unit(display="1/s", si="1/s", example="0.003 1/s")
NUMBER = Unit(display="dimensionless", si="dimensionless", example="1.5")

_UNITS = {
    "modulus.linear": Unit(display="MPa", si="Pa", example="4.8 MPa"),
    "modulus.quadratic": Unit(display="MPa", si="Pa", example="-1.2 MPa"),
    "modulus.cubic": Unit(display="MPa", si="Pa", example="0.5 MPa"),
    "viscosity.linear": Unit(display="MPa s", si="Pa s", example="0.1 MPa s"),
    "viscosity.quadratic": Unit(display="MPa s^2", si="Pa s^2", example="0.1 MPa s^2"),
    "viscosity.cubic": Unit(display="MPa s^3", si="Pa s^3", example="0.1 MPa s^3"),
    "branches.0.modulus": Unit(display="MPa", si="Pa", example="1.5 MPa"),
    "branches.0.time": Unit(display="s", si="s", example="0.12 s"),
    "yield_strain": STRAIN,
    "residual_strain": STRAIN,
    "softening.r": NUMBER,
    "softening.m": Unit(display="kJ/m^3", si="J/m^3", example="300 kJ/m^3"),
    "softening.beta": NUMBER,
    "largest_strain": STRAIN,
    "lowest_strain_rate": RATE,
    "highest_strain_rate": RATE,
}


def law_unit(key: str) -> Unit:
    """Return the unit of a value of a law.

    Args:
        key: dotted key, such as "viscosity.linear"; a branch has a number, as in "branches.1.time".

    Raises:
        InputError: there is no such key.
    """
    unit = _UNITS.get(re.sub(r"^branches\.\d+\.", "branches.0.", key))
    if unit is None:
        raise InputError(f"{key}: unknown key; {nearest(key, list(_UNITS))}")
    return unit


def nearest(word: str, allowed: Sequence[str]) -> str:
    """Return a hint for an unknown word: the nearest allowed one, or all."""
    near = difflib.get_close_matches(word.lower(), allowed, n=1)
    return f"did you mean {near[0]}?" if near else f"allowed here: {', '.join(allowed)}"


def show_value(key: str, value: float) -> str:
    """Return a value of a law as readable text with its unit."""
    return show_quantity(value, law_unit(key)).removesuffix(" dimensionless")


def show_range(key: str, low: float, high: float) -> str:
    """Return a range of a value of a law as readable text, such as "0.4 to 1.5 MPa"."""
    unit = law_unit(key)
    first = show_quantity(low, unit).removesuffix(f" {unit.display}")
    return f"{first} to {show_value(key, high)}"


def number(key: str, value: object) -> float:
    """Read a number without a unit.

    Raises:
        InputError: the value is not a number.
    """
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise InputError(f"{key}: need a number without quotes, got {as_written(value)}")
    return float(value)
