"""Designs of a single vertex."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from forficula.design.section import ANGLE, LENGTH, Section, quantity
from forficula.design.sheets.sheet import SheetDesign
from forficula.pattern import CreasePattern, vertex_pattern


class Vertex(Section):
    """The sheet: one vertex surrounded by triangles, whose angles need not add up to 360 deg."""

    about: ClassVar[str] = "The sheet: one vertex surrounded by triangles, whose angles need not add up to 360 deg"

    kind: Annotated[Literal["vertex"], Field(description="family of crease patterns")]
    sectors: tuple[float, ...] = quantity(
        ANGLE, "angles between neighbouring creases, counterclockwise", above=0, below=math.pi
    )
    sector_sum: float | None = quantity(
        ANGLE,
        "sum to which the sectors are scaled; if not given, sectors remain as given",
        default=None,
        above=0,
        examples=["350 deg"],
    )
    lengths: tuple[float, ...] = quantity(LENGTH, "lengths of the creases: one for all or one for each", above=0)
    assignment: Annotated[
        str, Field(description="M, V, F or U for every crease; if not given, as the vertex is built")
    ] = ""
    fold: float | None = quantity(
        ANGLE,
        "fold angle of the first of four creases as built; if not given, the sheet is flat, a cone or a saddle",
        default=None,
        at_least=0,
        at_most=math.pi,
        examples=["30 deg"],
    )

    @property
    def sheet(self) -> CreasePattern:
        """The crease pattern."""
        lengths = self.lengths[0] if len(self.lengths) == 1 else self.lengths
        return vertex_pattern(self._scaled_sectors(), lengths, self.assignment, self.fold)

    def _scaled_sectors(self) -> tuple[float, ...]:
        if self.sector_sum is None:
            return self.sectors
        scale = self.sector_sum / math.fsum(self.sectors)
        return tuple(scale * sector for sector in self.sectors)


class VertexDesign(SheetDesign):
    """One vertex with the facets around it, and its protocol."""

    papers: ClassVar[Mapping[str, str]] = {"faber2018": "vertices whose sector angles do not sum to 360 deg"}
    reference: ClassVar[str | None] = "bistable-clasp"

    pattern: Vertex
