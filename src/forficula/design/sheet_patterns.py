"""Sections of a sheet's design for patterns that are drawn by a formula, one for each kind."""

from __future__ import annotations

import math
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field, model_validator

from forficula.design.part import ANGLE, LENGTH, Part, quantity
from forficula.errors import InputError
from forficula.pattern import (
    CreasePattern,
    kresling_pattern,
    miura_pattern,
    pleat_pattern,
    vertex_pattern,
    waterbomb_base,
    waterbomb_pattern,
    yoshimura_pattern,
    yoshimura_tube,
)
from forficula.quantities import as_written

_MOST_PANELS = 1000
# along either side of a sheet: a hundred thousand facets take minutes to draw
_MOST = 300


def _count(description: str, least: int = 1) -> Any:
    """A whole number that must be given."""
    return Field(strict=True, ge=least, le=_MOST, description=description)


class MiuraOri(Part):
    """The sheet: parallelograms in rows, every second one mirrored, which fold all at once."""

    about: ClassVar[str] = "The sheet: parallelograms in rows, every second one mirrored, which fold all at once"

    kind: Annotated[Literal["miura-ori"], Field(description="the family of crease patterns")]
    columns: int = _count("of parallelograms, across the straight creases")
    rows: int = _count("of parallelograms, across the zigzag creases")
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


class Waterbomb(Part):
    """The sheet: a waterbomb base, which snaps, or with columns and rows a flat sheet of waterbombs."""

    about: ClassVar[str] = (
        "The sheet: a waterbomb base, which snaps, or with columns and rows a flat sheet of waterbombs"
    )

    kind: Annotated[Literal["waterbomb"], Field(description="the family of crease patterns")]
    side: float = quantity(LENGTH, "of a square", above=0)
    columns: Annotated[
        int | None, Field(strict=True, ge=1, le=_MOST, description="of squares; with rows", examples=[4])
    ] = None
    rows: Annotated[
        int | None, Field(strict=True, ge=1, le=_MOST, description="of squares; with columns", examples=[4])
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


class Yoshimura(Part):
    """The sheet: diamonds, flat, rolled up, or as a closed tube."""

    about: ClassVar[str] = "The sheet: diamonds, flat, rolled up, or as a closed tube"

    kind: Annotated[Literal["yoshimura"], Field(description="the family of crease patterns")]
    columns: int = _count("of triangles on every line, around the roll")
    rows: int = _count("of triangles, along the roll")
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


class Kresling(Part):
    """The sheet: a twisted tower of triangles between polygons, as it stands."""

    about: ClassVar[str] = "The sheet: a twisted tower of triangles between polygons, as it stands"

    kind: Annotated[Literal["kresling"], Field(description="the family of crease patterns")]
    sides: int = _count("of every polygon", least=3)
    layers: int = Field(default=1, strict=True, ge=1, le=_MOST, description="one above another")
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


class Vertex(Part):
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


class Pleats(Part):
    """The sheet: a strip of panels one after another, with a crease between every two."""

    about: ClassVar[str] = "The sheet: a strip of panels one after another, with a crease between every two"

    kind: Annotated[Literal["pleats"], Field(description="the family of crease patterns")]
    panels: Annotated[int, Field(strict=True, ge=2, le=_MOST_PANELS, description="how many panels the strip has")]
    panel_lengths: tuple[float, ...] = quantity(
        LENGTH, "lengths of the panels along the strip, repeated where there are more panels", above=0
    )
    width: float = quantity(LENGTH, "width of the strip, along the creases", above=0)
    assignment: Annotated[
        str, Field(description="M (mountain) or V (valley) for every crease, repeated where there are more creases")
    ]

    @model_validator(mode="after")
    def _can_be_drawn(self) -> Pleats:
        for key, given, most, what in (
            ("panel_lengths", len(self.panel_lengths), self.panels, "lengths, one for each panel"),
            ("assignment", len(self.assignment), self.panels - 1, "letters, one for each crease"),
        ):
            if not 1 <= given <= most:
                raise InputError(f"pattern.{key}: need 1 to {most} {what}, got {given}")
        if set(self.assignment) - {"M", "V"}:
            raise InputError(
                f"pattern.assignment: need letters M (mountain) and V (valley), got {as_written(self.assignment)}"
            )
        _ = self.sheet
        return self

    @property
    def sheet(self) -> CreasePattern:
        """The crease pattern."""
        lengths, letters = self.panel_lengths, self.assignment
        return pleat_pattern(
            [lengths[panel % len(lengths)] for panel in range(self.panels)],
            self.width,
            "".join(letters[crease % len(letters)] for crease in range(self.panels - 1)),
        )
