"""The section of a sheet's design for a tendon."""

from __future__ import annotations

from typing import Annotated, ClassVar

from pydantic import Field, field_validator

from forficula.design.sheet_course import Joined
from forficula.design.sheet_names import checked_name
from forficula.design.tendon import ElasticTendon


class SheetTendon(ElasticTendon, Joined):
    """What pulls two places together and never pushes: a spring, or a law of a material."""

    about: ClassVar[str] = "What pulls two places together and never pushes: a spring, or a law of a material"

    needed: ClassVar[tuple[str, ...]] = ("stiffness",)

    name: Annotated[str, Field(description="what tables and figures call it")]

    _checked = field_validator("name")(checked_name)
