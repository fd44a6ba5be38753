"""Designs of waterbombs and of sheets of them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from forficula.design.families.counts import MOST_CELLS
from forficula.design.section import ANGLE, LENGTH, Section, quantity
from forficula.design.sheets.sheet import SheetDesign
from forficula.errors import InputError
from forficula.pattern import CreasePattern, waterbomb_base, waterbomb_pattern


class Waterbomb(Section):
    """The sheet: a waterbomb base, which snaps, or with columns and rows a flat sheet of waterbombs."""

    about: ClassVar[str] = (
        "The sheet: a waterbomb base, which snaps, or with columns and rows a flat sheet of waterbombs"
    )

    kind: Annotated[Literal["waterbomb"], Field(description="the family of crease patterns")]
    side: float = quantity(LENGTH, "of a square", above=0)
    columns: Annotated[
        int | None, Field(strict=True, ge=1, le=MOST_CELLS, description="of squares; with rows", examples=[4])
    ] = None
    rows: Annotated[
        int | None, Field(strict=True, ge=1, le=MOST_CELLS, description="of squares; with columns", examples=[4])
    ] = None
    fold: float = quantity(
        ANGLE, "of the base: fold angle of its diagonals as built", default=0.0, at_least=0, below=math.pi
    )
    apex: Annotated[
        Literal["up", "down"], Field(description="of the base: whether its centre stands above its rim as built")
    ] = "up"

    @model_validator(mode="after")
    def _base_or_sheet(self) -> Waterbomb:
        if (self.columns is None) != (self.rows is None):
            raise InputError("pattern.columns: need columns and rows for a sheet, neither for a base, got one of them")
        if self.columns is not None and (self.fold or self.apex != "up"):
            raise InputError("pattern.fold: is for the base; a sheet of waterbombs is built flat")
        return self

    @property
    def sheet(self) -> CreasePattern:
        """The crease pattern."""
        if self.columns is None or self.rows is None:
            return waterbomb_base(self.side, self.fold, self.apex)
        return waterbomb_pattern(self.columns, self.rows, self.side)


class WaterbombDesign(SheetDesign):
    """A waterbomb, or a sheet of them, and what is done to it."""

    papers: ClassVar[Mapping[str, str]] = {"chen2016": "the tessellation and its rigid folding"}
    reference: ClassVar[str | None] = "waterbomb-base"

    pattern: Waterbomb
