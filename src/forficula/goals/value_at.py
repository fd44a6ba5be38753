"""Values of a parameter at a fraction of its range, as in a design file."""

from __future__ import annotations

from collections.abc import Sequence

from forficula.quantities import Unit, parse_quantity

# digits of continuous parameters: few enough that a person can read the design and build it again
_DIGITS = 6


def choice_at(choices: Sequence[object], share: float) -> object:
    """Return the choice at a fraction in [0, 1] of the range, which is divided equally among the choices."""
    return choices[min(int(share * len(choices)), len(choices) - 1)]


def design_file_value(number: float, unit: Unit | None) -> object:
    """Return a number, SI, as in a design file: as text with its display unit, if it has one."""
    if unit is None:
        return float(f"{number:.{_DIGITS}g}")
    shown = number / parse_quantity(f"1 {unit.display}", unit)
    return f"{float(f'{shown:.{_DIGITS}g}')!r} {unit.display}".replace(".0 ", " ")
