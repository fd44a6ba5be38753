"""Which design a file holds, by the kind of its pattern."""

from __future__ import annotations

from collections.abc import Mapping

from forficula.design.design import Design
from forficula.design.fan import FanDesign

KINDS: Mapping[str, type[Design]] = {"earwig-fan": FanDesign}


def design_class(tables: Mapping[str, object]) -> type[Design]:
    """The class of a design's tables, not checked yet; of a fan where they do not say."""
    pattern = tables.get("pattern")
    kind = pattern.get("kind") if isinstance(pattern, Mapping) else None
    return KINDS.get(str(kind), FanDesign)
