"""Designs of strips of pleats."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from forficula.design.section import LENGTH, Section, quantity
from forficula.design.sheets.sheet import SheetDesign
from forficula.errors import InputError
from forficula.pattern import CreasePattern, pleat_pattern
from forficula.quantities import as_written

_MOST_PANELS = 1000


class Pleats(Section):
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


class PleatsDesign(SheetDesign):
    """A strip of pleats, and what is done to it."""

    reference: ClassVar[str | None] = "letter-fold"

    pattern: Pleats
