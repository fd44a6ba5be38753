"""Sections of a sheet's design that say what is built: its facets, its creases and what holds it."""

from __future__ import annotations

import math
from typing import Annotated, ClassVar, Literal

from pydantic import Field, field_validator

from forficula.design.section import ANGLE, DENSITY, MODULUS, SHORT_TIME, SMALL_LENGTH, Section, quantity
from forficula.design.sheets.sheet_names import checked_name
from forficula.quantities import Unit

CREASE_STIFFNESS = Unit(display="N m/rad/m", si="N m/rad/m", example="1e-2 N m/rad/m")
EXTENSION = Unit(display="N/m^2", si="N/m^2", example="1e5 N/m^2")
EXTENSION_DAMPING = Unit(display="N s/m^2", si="N s/m^2", example="10 N s/m^2")
CREASE_DAMPING = Unit(display="N m s/rad/m", si="N m s/rad/m", example="1e-3 N m s/rad/m")

_RESTS = ("as built", "flat")
_OF = "creases, mountains, valleys, a group by name, crease 2, role:zigzag, assignment:M, or several with and between"


class FacetSection(Section):
    """The panels, one on every facet; without a value one is chosen by a rule, which the written design tells."""

    about: ClassVar[str] = (
        "The panels, one on every facet; without a value one is chosen by a rule, which the written design tells"
    )

    natural: ClassVar[tuple[str, ...]] = ("stretch_damping",)

    kind: Annotated[
        Literal["bars", "rigid", "membrane"],
        Field(description="bars: elastic bars along edges and diagonals; rigid: plates; membrane: an elastic sheet"),
    ] = "bars"
    thickness: float | None = quantity(SMALL_LENGTH, "thickness", default=None, above=0)
    density: float | None = quantity(DENSITY, "mass by volume", default=None, above=0)
    youngs_modulus: float | None = quantity(MODULUS, "Young's modulus", default=None, above=0, examples=["2000 MPa"])
    poisson_ratio: Annotated[float | None, Field(strict=True, ge=0, lt=0.5, description="Poisson's ratio")] = Field(
        default=None, examples=[0.3]
    )
    bend_stiffness: float | None = quantity(
        CREASE_STIFFNESS,
        "of springs in which a facet bends along diagonals, by length",
        default=None,
        at_least=0,
    )
    strength: float | None = quantity(
        MODULUS,
        "stress that its material withstands, to be set beside the largest",
        default=None,
        above=0,
        examples=["50 MPa"],
    )
    stretch_damping: float | None = quantity(
        SHORT_TIME, "relaxation time of the Kelvin-Voigt damping of what stretches", default=None, at_least=0
    )


class Imperfection(Section):
    """How far a sheet of nodes is from its drawing: what else is there decides which way it leaves a flat state."""

    about: ClassVar[str] = (
        "How far a sheet of nodes is from its drawing: what else is there decides which way it leaves a flat state"
    )

    size: float = quantity(SMALL_LENGTH, "standard deviation of its vertices, square to it", default=0.0, at_least=0)
    seed: Annotated[int, Field(strict=True, ge=0, description="of the random numbers: another one, another way")] = 0


class CreaseGroup(Section):
    """Creases that differ from the others; what is left out is as in [crease]."""

    about: ClassVar[str] = "Creases that differ from the others; what is left out is as in [crease]"

    name: Annotated[
        str | None, Field(description="by which drives, measures and other groups call it", examples=["gates"])
    ] = None
    of: Annotated[str, Field(description=f"which: {_OF}", examples=["crease 0"])]
    stiffness: float | None = quantity(CREASE_STIFFNESS, "of their springs by length", default=None, at_least=0)
    rest_angle: float | str | None = quantity(
        ANGLE, "where their springs rest", default=None, words=_RESTS, examples=["0 deg"]
    )
    law: Annotated[Literal["linear", "locking"] | None, Field(description="of their springs", examples=["linear"])] = (
        None
    )
    lock_angle: float | None = quantity(
        ANGLE, "beyond which a locking spring stiffens", default=None, above=0, below=math.pi, examples=["135 deg"]
    )
    damping: float | None = quantity(CREASE_DAMPING, "viscous damping by length", default=None, at_least=0)
    extension: float | None = quantity(EXTENSION, "of springs in which they open, by length", default=None, above=0)
    extension_damping: float | None = quantity(
        EXTENSION_DAMPING, "damping of their opening, by length", default=None, at_least=0
    )
    fold_limit: float | None = quantity(
        ANGLE, "how far they fold", default=None, above=0, at_most=math.pi, examples=["175 deg"]
    )
    back_limit: float | None = quantity(
        ANGLE, "how far the other way", default=None, at_least=0, at_most=math.pi, examples=["3 deg"]
    )
    stop_stiffness: float | None = quantity(
        CREASE_STIFFNESS, "of their stops by length", default=None, above=0, examples=["1 kN m/rad/m"]
    )
    start: float | None = quantity(ANGLE, "how far folded they start", default=None, examples=["-1 deg"])

    @field_validator("name")
    @classmethod
    def _checked(cls, name: str | None) -> str | None:
        return None if name is None else checked_name(name)


class Crease(Section):
    """The creases; angles count in a crease's own sense, folding as assigned positive, 0 flat."""

    about: ClassVar[str] = "The creases; angles count in a crease's own sense, folding as assigned positive, 0 flat"

    stiffness: float | None = quantity(
        CREASE_STIFFNESS, "of the spring in a crease by its length; chosen if not given", default=None, at_least=0
    )
    rest_angle: float | str = quantity(
        ANGLE,
        'where that spring rests: an angle, "flat" or "as built"',
        default="as built",
        words=_RESTS,
        at_least=-math.pi,
        at_most=math.pi,
    )
    law: Annotated[
        Literal["linear", "locking"],
        Field(description="of that spring; locking: it stiffens beyond lock_angle and lets no panels pass each other"),
    ] = "linear"
    lock_angle: float = quantity(
        ANGLE,
        "beyond which a locking spring stiffens, folded either way (Liu and Paulino 2017)",
        default=math.radians(135.0),
        above=0,
        below=math.pi,
    )
    damping: float | None = quantity(
        CREASE_DAMPING, "viscous damping by length of crease; chosen if not given", default=None, at_least=0
    )
    extension: float | None = quantity(
        EXTENSION,
        "of a spring in which the crease opens, by its length; only where facets are rigid, which are hinged without",
        default=None,
        above=0,
    )
    extension_damping: float | None = quantity(
        EXTENSION_DAMPING,
        "viscous damping of its opening, by its length; chosen if not given",
        default=None,
        at_least=0,
    )
    fold_limit: float | None = quantity(
        ANGLE,
        "stop: how far a crease folds; without it 180 deg where facets are rigid, else no stop",
        default=None,
        above=0,
        at_most=math.pi,
        examples=["175 deg"],
    )
    back_limit: float | None = quantity(
        ANGLE,
        "stop: how far it bends the other way; without it 0 deg where facets are rigid, else no stop",
        default=None,
        at_least=0,
        at_most=math.pi,
        examples=["3 deg"],
    )
    stop_stiffness: float | None = quantity(
        CREASE_STIFFNESS,
        "of both stops, by length of crease; without it stops are rigid in statics, and in a run 1000 times as stiff as"
        " the crease",
        default=None,
        above=0,
        examples=["1 kN m/rad/m"],
    )
    start: float = quantity(ANGLE, "how far folded it starts; only where facets are rigid", default=0.0)
    group: Annotated[
        tuple[CreaseGroup, ...], Field(description="creases that differ, of several that say so the last one counts")
    ] = ()


def largest_extension(crease: Crease) -> float:
    """The stiffest springs in which creases of a section or of its groups open, by length; 0 where none opens."""
    return max(crease.extension or 0.0, *(group.extension or 0.0 for group in crease.group), 0.0)


class Support(Section):
    """What is held."""

    about: ClassVar[str] = "What is held"

    of: Annotated[str, Field(description="facet 0, or where facets bend vertex 3, too", examples=["facet 0"])]
    axes: Annotated[
        str | None,
        Field(pattern="^[xyz]{1,3}$", description="of a vertex: along which axes; xyz if not given", examples=["xz"]),
    ] = None
