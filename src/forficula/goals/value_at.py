"""Values at a share of the way, as a design file has them: of choices one, of numbers a few digits."""

from __future__ import annotations

from collections.abc import Sequence

from forficula.quantities import Unit, parse_quantity

# of what varies without steps: a design that a person can read, and build again
_DIGITS = 6


def choice_at(choices: Sequence[object], share: float) -> object:
    """The one of several choices, each with an equal part of the way, at a share of it, in [0, 1]."""
    return choices[min(int(share * len(choices)), len(choices) - 1)]


def written(number: float, unit: Unit | None) -> object:
    """A number, SI, as a design file has it: text with the unit that is shown, where it has one."""
    if unit is None:
        return float(f"{number:.{_DIGITS}g}")
    shown = number / parse_quantity(f"1 {unit.display}", unit)
    return f"{float(f'{shown:.{_DIGITS}g}')!r} {unit.display}".replace(".0 ", " ")
