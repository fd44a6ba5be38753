"""Parts -> checks: whether they can be made, move through their range, and bear what pulls."""

from __future__ import annotations

from forficula.make.check import Check
from forficula.make.part import PartSet
from forficula.make.printing_checks import printing_checks
from forficula.make.range_checks import range_checks
from forficula.make.strength_checks import strength_checks


def check_parts(parts: PartSet) -> tuple[Check, ...]:
    """Check parts: geometry at nominal size, and formulas with the strengths of data sheets.

    What is not checked: that they print, fatigue, creep, bonding.

    >>> checks = ff.check_parts(ff.make_parts("binder2025-joint"))
    >>> [check.name for check in checks if check.ok is False]
    []
    """
    return (*range_checks(parts), *strength_checks(parts), *printing_checks(parts))
