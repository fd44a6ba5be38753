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
    """The sheet: a strip of panels with a crease between neighbouring panels."""

    about: ClassVar[str] = "The sheet: a strip of panels with a crease between neighbouring panels"

    kind: Annotated[Literal["pleats"], Field(description="family of crease patterns")]
    panels: Annotated[int, Field(strict=True, ge=2, le=_MOST_PANELS, description="number of panels of the strip")]
    panel_lengths: tuple[float, ...] = quantity(
        LENGTH, "lengths of the panels along the strip, repeated if there are more panels", above=0
    )
    width: float = quantity(LENGTH, "width of the strip, along the creases", above=0)
    assignment: Annotated[
        str, Field(description="M (mountain) or V (valley) for every crease, repeated if there are more creases")
    ]

    @model_validator(mode="after")
    def _can_be_drawn(self) -> Pleats:
        for key, count, most, entries in (
            ("panel_lengths", len(self.panel_lengths), self.panels, "lengths, one for each panel"),
            ("assignment", len(self.assignment), self.panels - 1, "letters, one for each crease"),
        ):
            if not 1 <= count <= most:
                raise InputError(f"pattern.{key}: need 1 to {most} {entries}, got {count}")
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
    """A strip of pleats with its protocol."""

    reference: ClassVar[str | None] = "letter-fold"

    pattern: Pleats
