"""Designs of Yoshimura sheets and tubes."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from forficula.design.families.counts import count
from forficula.design.section import ANGLE, LENGTH, Section, quantity
from forficula.design.sheets.sheet import SheetDesign
from forficula.errors import InputError
from forficula.pattern import CreasePattern, yoshimura_pattern, yoshimura_tube


class Yoshimura(Section):
    """The sheet: diamonds, flat, rolled up, or as a closed tube."""

    about: ClassVar[str] = "The sheet: diamonds, flat, rolled up, or as a closed tube"

    kind: Annotated[Literal["yoshimura"], Field(description="the family of crease patterns")]
    columns: int = count("of triangles on every line, around the roll")
    rows: int = count("of triangles, along the roll")
    base: float = quantity(LENGTH, "of a triangle", above=0)
    height: float = quantity(LENGTH, "of a triangle over its base", above=0)
    fold: float = quantity(
        ANGLE, "fold angle of the bases as built; 0 deg is flat", default=0.0, at_least=0, below=math.pi
    )
    closed: Annotated[bool, Field(strict=True, description="whether it is a tube, which closes by itself")] = False

    @model_validator(mode="after")
    def _rolled_once(self) -> Yoshimura:
        if self.closed and self.fold:
            raise InputError("pattern.fold: is for an open sheet; how far a closed tube is folded follows from columns")
        return self

    @property
    def sheet(self) -> CreasePattern:
        """The crease pattern."""
        if self.closed:
            return yoshimura_tube(self.columns, self.rows, self.base, self.height)
        return yoshimura_pattern(self.columns, self.rows, self.base, self.height, self.fold)


class YoshimuraDesign(SheetDesign):
    """A sheet or a tube of diamonds, and what is done to it."""

    papers: ClassVar[Mapping[str, str]] = {"guest1994": "geometry of triangulated tubes"}
    example: ClassVar[Mapping[str, object]] = {
        "columns": 5,
        "rows": 4,
        "base": "4 cm",
        "height": "2 cm",
        "fold": "30 deg",
    }

    pattern: Yoshimura
