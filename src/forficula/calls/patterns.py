"""Calls about crease patterns."""

from __future__ import annotations

from typing import TYPE_CHECKING

from forficula.design import AnyDesign, as_design

if TYPE_CHECKING:
    from forficula.pattern import PatternFacts


def pattern_facts(design: AnyDesign) -> PatternFacts:
    """Say what a design's crease pattern is, as `forficula pattern` does: freedoms, faults, flat-foldability.

    Args:
        design: or its name, or the path of a design file, a FOLD file or a drawing.

    >>> ff.pattern_facts("binder2025").title
    'earwig fan, 1 unit, 3 veins'
    """
    from forficula.design import design_pattern
    from forficula.pattern import pattern_facts as facts_of

    return facts_of(design_pattern(as_design(design)))
