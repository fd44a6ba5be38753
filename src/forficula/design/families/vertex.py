"""Designs of one vertex."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from forficula.design.section import ANGLE, LENGTH, Section, quantity
from forficula.design.sheets.sheet import SheetDesign
from forficula.pattern import CreasePattern, vertex_pattern


class Vertex(Section):
    """The sheet: one vertex with triangles around it, which may add up to 360 deg or not."""

    about: ClassVar[str] = "The sheet: one vertex with triangles around it, which may add up to 360 deg or not"

    kind: Annotated[Literal["vertex"], Field(description="the family of crease patterns")]
    sectors: tuple[float, ...] = quantity(
        ANGLE, "angles between neighbouring creases, counterclockwise", above=0, below=math.pi
    )
    lengths: tuple[float, ...] = quantity(LENGTH, "of the creases, one for all or one for each", above=0)
    assignment: Annotated[
        str, Field(description="M, V, F or U for every crease; without it as the vertex is built")
    ] = ""
    fold: float | None = quantity(
        ANGLE,
        "of four creases: fold angle of the first one as built; without it flat, a cone or a saddle",
        default=None,
        at_least=0,
        at_most=math.pi,
        examples=["30 deg"],
    )

    @property
    def sheet(self) -> CreasePattern:
        """The crease pattern."""
        lengths = self.lengths[0] if len(self.lengths) == 1 else self.lengths
        return vertex_pattern(self.sectors, lengths, self.assignment, self.fold)


class VertexDesign(SheetDesign):
    """One vertex with the facets around it, and what is done to it."""

    papers: ClassVar[Mapping[str, str]] = {"faber2018": "vertices whose sector angles do not sum to 360 deg"}
    reference: ClassVar[str | None] = "bistable-clasp"

    pattern: Vertex
