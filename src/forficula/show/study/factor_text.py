"""A study's factors and their values as text."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from forficula.quantities import Unit, parse_quantity

if TYPE_CHECKING:
    from xarray import DataArray


def plain_name(factor: DataArray) -> str:
    """Return a factor's name: its key without "protocol.", since the protocol's keys are clear without it."""
    return key_text(str(factor.attrs.get("key", factor.name)))


def key_text(key: str) -> str:
    """Return a key of a design as words, such as "tendon rest length"."""
    return key.removeprefix("protocol.").replace(".", " ").replace("_", " ")


def display_values(factor: DataArray) -> tuple[NDArray[Any], str]:
    """Return a factor's values in the display unit, and that unit; words are unchanged."""
    values, si, display = factor.values, factor.attrs.get("units", ""), factor.attrs.get("display", "")
    if values.dtype.kind not in "iuf" or not si or not display or si == display:
        return values, str(display or si)
    unit = Unit(display=display, si=si, example=f"1 {display}")
    return values / parse_quantity(f"1 {display}", unit), display


def number_text(value: object) -> str:
    """Return a value without its unit; words are unchanged."""
    return f"{value:.4g}" if isinstance(value, float | int) and not isinstance(value, bool) else str(value)


def value_with_unit(factor: DataArray, index: int) -> str:
    """Return one of a factor's values, such as "10 N/cm"."""
    values, unit = display_values(factor)
    return f"{number_text(values[index].item())} {unit}".rstrip()


def value_text(factor: DataArray, index: int) -> str:
    """Return a factor and one of its values, such as "tendon stiffness 10 N/cm"."""
    return f"{plain_name(factor)} {value_with_unit(factor, index)}"


def factor_label(factor: DataArray) -> str:
    """Return a factor and its unit, such as "tendon stiffness (N/cm)"."""
    unit = display_values(factor)[1]
    return f"{plain_name(factor)} ({unit})" if unit else plain_name(factor)
