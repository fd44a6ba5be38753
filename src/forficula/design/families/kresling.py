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
    """The sheet: an upright twisted tower of triangles between polygons."""

    about: ClassVar[str] = "The sheet: an upright twisted tower of triangles between polygons"

    kind: Annotated[Literal["kresling"], Field(description="family of crease patterns")]
    sides: int = count("number of sides of every polygon", least=3)
    layers: int = Field(default=1, strict=True, ge=1, le=MOST_CELLS, description="number of layers, one above another")
    radius: float = quantity(LENGTH, "radius of the circle through the corners of a polygon", above=0)
    height: float = quantity(LENGTH, "height of a layer", above=0)
    twist: float = quantity(
        ANGLE, "angle by which a polygon is turned relative to the one below", above=-math.pi, below=math.pi
    )
    alternating: Annotated[
        bool, Field(strict=True, description="whether every second layer is twisted in the opposite direction")
    ] = False
    end_plates: Annotated[bool, Field(strict=True, description="whether polygons close the tower at both ends")] = False

    @property
    def sheet(self) -> CreasePattern:
        """The crease pattern."""
        return kresling_pattern(
            self.sides, self.layers, self.radius, self.height, self.twist, self.alternating, self.end_plates
        )


class KreslingDesign(SheetDesign):
    """A Kresling tower with its protocol."""

    papers: ClassVar[Mapping[str, str]] = {"cai2015": "geometry of the tower and its two states"}
    reference: ClassVar[str | None] = "kresling-cell"

    pattern: Kresling
