"""Tolerances as text."""

from __future__ import annotations

from forficula.design import Design, key_quantity, key_value
from forficula.goals.deviation import Deviation
from forficula.quantities import show_quantity


def plain_key(key: str) -> str:
    """Return a key with spaces in place of dots and underscores."""
    return key.replace(".", " ").replace("_", " ")


def deviation_text(design: Design, deviation: Deviation) -> str:
    """Return a value and its tolerance, such as "10 N/cm ± 10 %"."""
    quantity = key_quantity(deviation.key, type(design))
    value = float(key_value(design, deviation.key))
    if quantity is None:
        return f"{value:g} ± {100 * deviation.size:g} %"
    join = " " if deviation.distribution == "uniform" else ", "
    return f"{show_quantity(value, quantity.unit)}{join}{deviation.text(quantity.unit)}"
