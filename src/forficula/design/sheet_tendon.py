"""The section of a sheet's design for a tendon."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, field_validator

from forficula.design.part import LENGTH, STIFFNESS, TENDON_DAMPING, quantity
from forficula.design.sheet_course import Joined
from forficula.design.sheet_names import checked_name


class SheetTendon(Joined):
    """A spring between two places that pulls and never pushes."""

    name: Annotated[str, Field(description="what tables and figures call it")]
    stiffness: float = quantity(STIFFNESS, "force by extension beyond the resting length", at_least=0)
    rest_length: float = quantity(LENGTH, "length below which it does not pull", at_least=0)
    damping: float = quantity(TENDON_DAMPING, "viscous damping, at any length", default=0.0, at_least=0)

    _checked = field_validator("name")(checked_name)
