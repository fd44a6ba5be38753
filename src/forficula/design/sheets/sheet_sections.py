"""Sections of a sheet's design for facets, imperfection and supports."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from pydantic import Field, field_validator

from forficula.design.section import DENSITY, MODULUS, SHORT_TIME, SMALL_LENGTH, Section, quantity
from forficula.material.law.crease_law_file import CREASE_STIFFNESS


class FacetSection(Section):
    """The facets; a rule chooses values that are not given, and the written design file gives the reason."""

    about: ClassVar[str] = (
        "The facets; a rule chooses values that are not given, and the written design file gives the reason"
    )

    natural: ClassVar[tuple[str, ...]] = ("stretch_damping",)

    kind: Annotated[
        Literal["bars", "rigid", "membrane"],
        Field(
            description="model of a facet: bars: elastic bars along edges and diagonals; rigid: plates; membrane: an"
            " elastic sheet"
        ),
    ] = "bars"
    thickness: float | None = quantity(SMALL_LENGTH, "thickness", default=None, above=0)
    thickness_method: Annotated[
        Literal["none", "offset", "tapered", "hinge-shift", "split"] | None,
        Field(
            description="how rigid facets make room for their thickness. none, or not given: hinge axes lie in the"
            " mid-plane, and panels overlap when folded; offset: panels are shifted from the plane of the axes;"
            " tapered: panels are trimmed to the largest fold angle; hinge-shift: axes are shifted, for vertices of"
            " four creases; split: two folds with a strip between them replace folds that go around other panels",
            examples=["hinge-shift"],
        ),
    ] = None
    density: float | None = quantity(DENSITY, "density", default=None, above=0)
    youngs_modulus: float | None = quantity(MODULUS, "Young's modulus", default=None, above=0, examples=["2000 MPa"])
    poisson_ratio: Annotated[float | None, Field(strict=True, ge=0, lt=0.5, description="Poisson's ratio")] = Field(
        default=None, examples=[0.3]
    )
    bend_stiffness: float | None = quantity(
        CREASE_STIFFNESS,
        "bending stiffness of a facet per length of its diagonals",
        default=None,
        at_least=0,
    )
    strength: float | None = quantity(
        MODULUS,
        "stress that the material withstands, with which the largest stress is compared",
        default=None,
        above=0,
        examples=["50 MPa"],
    )
    stretch_damping: float | None = quantity(
        SHORT_TIME, "relaxation time of the Kelvin-Voigt damping of stretching", default=None, at_least=0
    )

    @field_validator("thickness_method")
    @classmethod
    def _none_is_absent(cls, method: str | None) -> str | None:
        return None if method == "none" else method


class Imperfection(Section):
    """Random deviations of the vertices from a flat sheet, which decide in which sense it leaves the flat state."""

    about: ClassVar[str] = (
        "Random deviations of the vertices from a flat sheet, which decide in which sense it leaves the flat state"
    )

    size: float = quantity(
        SMALL_LENGTH, "standard deviation of the vertices, normal to the sheet", default=0.0, at_least=0
    )
    seed: Annotated[
        int, Field(strict=True, ge=0, description="seed of the random numbers; each seed gives other deviations")
    ] = 0


class Support(Section):
    """A support: a facet, an edge or a vertex that is held."""

    about: ClassVar[str] = "A support: a facet, an edge or a vertex that is held"

    of: Annotated[
        str,
        Field(
            description="part of the sheet that is held: a facet, clamped; an edge, about which the sheet turns; or a"
            " vertex",
            examples=["facet 0", "edge 3", "vertex 4"],
        ),
    ]
    axes: Annotated[
        str | None,
        Field(
            pattern="^[xyz]{1,3}$",
            description="axes along which a vertex or an edge is held; xyz if not given",
            examples=["xz"],
        ),
    ] = None

    @property
    def whole(self) -> bool:
        """Return whether the part is held along all axes."""
        return set(self.axes or "xyz") == set("xyz")

    @property
    def kind(self) -> str:
        """Return the kind of part that is held: "facet", "edge" or "vertex"."""
        word = self.of.split()[0] if self.of.split() else ""
        return "edge" if word == "crease" else word
