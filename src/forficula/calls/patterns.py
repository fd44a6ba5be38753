"""Calls about crease patterns."""

from __future__ import annotations

from typing import TYPE_CHECKING

from forficula.design import AnyDesign, as_design
from forficula.pattern import CreasePattern

if TYPE_CHECKING:
    from forficula.pattern import PatternFacts


def pattern_facts(design: AnyDesign | CreasePattern) -> PatternFacts:
    """Analyse a crease pattern, as `forficula pattern` does: degrees of freedom, faults, flat-foldability.

    Args:
        design: design, its name, the path of a design file, a FOLD file or a drawing, or a crease pattern.

    >>> ff.pattern_facts("binder2025").title
    'earwig fan, 1 unit, 3 veins'
    """
    from forficula.design import design_pattern
    from forficula.pattern import pattern_facts as facts_of

    return facts_of(design if isinstance(design, CreasePattern) else design_pattern(as_design(design)))
