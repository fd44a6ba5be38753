"""Designs of Miura sheets."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from forficula.design.families.counts import count
from forficula.design.section import ANGLE, LENGTH, Section, quantity
from forficula.design.sheets.sheet import SheetDesign
from forficula.pattern import CreasePattern, miura_pattern


class MiuraOri(Section):
    """The sheet: parallelograms in rows, every second one mirrored, which fold all at once."""

    about: ClassVar[str] = "The sheet: parallelograms in rows, every second one mirrored, which fold all at once"

    kind: Annotated[Literal["miura-ori"], Field(description="the family of crease patterns")]
    columns: int = count("of parallelograms, across the straight creases")
    rows: int = count("of parallelograms, across the zigzag creases")
    long_side: float = quantity(LENGTH, "of a parallelogram, along the straight creases", above=0)
    short_side: float = quantity(LENGTH, "of a parallelogram, along the zigzag creases", above=0)
    acute_angle: float = quantity(ANGLE, "of a parallelogram", above=0, below=math.pi / 2, examples=["60 deg"])
    fold: float = quantity(
        ANGLE, "fold angle of the zigzag creases as built; 0 deg is flat", default=0.0, at_least=0, below=math.pi
    )

    @property
    def sheet(self) -> CreasePattern:
        """The crease pattern."""
        return miura_pattern(self.columns, self.rows, self.long_side, self.short_side, self.acute_angle, self.fold)


class MiuraDesign(SheetDesign):
    """A Miura sheet, and what is done to it."""

    papers: ClassVar[Mapping[str, str]] = {
        "schenk2013": "places of the vertices",
        "tachi2009": "rigid folding of the parallelograms",
    }
    reference: ClassVar[str | None] = "miura-sheet"

    pattern: MiuraOri
