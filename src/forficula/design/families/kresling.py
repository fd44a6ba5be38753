"""Designs of Kresling towers."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from forficula.design.families.counts import MOST_CELLS, count
from forficula.design.section import ANGLE, LENGTH, Section, quantity
from forficula.design.sheets.sheet import SheetDesign
from forficula.pattern import CreasePattern, kresling_pattern


class Kresling(Section):
    """The sheet: a twisted tower of triangles between polygons, as it stands."""

    about: ClassVar[str] = "The sheet: a twisted tower of triangles between polygons, as it stands"

    kind: Annotated[Literal["kresling"], Field(description="the family of crease patterns")]
    sides: int = count("of every polygon", least=3)
    layers: int = Field(default=1, strict=True, ge=1, le=MOST_CELLS, description="one above another")
    radius: float = quantity(LENGTH, "of the circle through the corners of a polygon", above=0)
    height: float = quantity(LENGTH, "of a layer", above=0)
    twist: float = quantity(ANGLE, "by which a polygon is turned against the one below", above=-math.pi, below=math.pi)
    alternating: Annotated[
        bool, Field(strict=True, description="whether every second layer is twisted the other way")
    ] = False
    end_plates: Annotated[bool, Field(strict=True, description="whether polygons close it below and above")] = False

    @property
    def sheet(self) -> CreasePattern:
        """The crease pattern."""
        return kresling_pattern(
            self.sides, self.layers, self.radius, self.height, self.twist, self.alternating, self.end_plates
        )


class KreslingDesign(SheetDesign):
    """A Kresling tower, and what is done to it."""

    papers: ClassVar[Mapping[str, str]] = {"cai2015": "geometry of the tower and its two states"}
    reference: ClassVar[str | None] = "kresling-cell"

    pattern: Kresling
