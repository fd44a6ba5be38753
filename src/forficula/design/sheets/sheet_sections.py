"""Sections of a sheet's design for facets, creases, imperfection and supports."""

from __future__ import annotations

import math
from typing import Annotated, ClassVar, Literal

from pydantic import BeforeValidator, Field, field_validator

from forficula.design.section import ANGLE, DENSITY, MODULUS, SHORT_TIME, SMALL_LENGTH, TIME, Section, quantity
from forficula.design.sheets.sheet_names import checked_name
from forficula.quantities import Unit

CREASE_STIFFNESS = Unit(display="N m/rad/m", si="N m/rad/m", example="1e-2 N m/rad/m")
EXTENSION = Unit(display="N/m^2", si="N/m^2", example="1e5 N/m^2")
EXTENSION_DAMPING = Unit(display="N s/m^2", si="N s/m^2", example="10 N s/m^2")
CREASE_MOMENT = Unit(display="N m/m", si="N m/m", example="1e-2 N m/m")
CREASE_QUADRATIC = Unit(display="N m/rad^2/m", si="N m/rad^2/m", example="1e-3 N m/rad^2/m")
CREASE_CUBIC = Unit(display="N m/rad^3/m", si="N m/rad^3/m", example="1e-3 N m/rad^3/m")
CREASE_DAMPING = Unit(display="N m s/rad/m", si="N m s/rad/m", example="1e-3 N m s/rad/m")

_RESTS = ("as built", "flat")
# word of a group that switches off what the section of all creases has
NONE = "none"
_OF = "creases, mountains, valleys, a group by name, crease 2, role:zigzag, assignment:M, or several joined by and"


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


def _without_branches(value: object) -> object:
    """Read the word that switches the branches of a section off as an empty list."""
    return () if value == NONE else value


class CreaseBranch(Section):
    """A Maxwell branch of a crease: a spring and a damper in series."""

    about: ClassVar[str] = "A Maxwell branch of a crease: a spring and a damper in series"
    natural: ClassVar[tuple[str, ...]] = ("time",)

    stiffness: float = quantity(CREASE_STIFFNESS, "stiffness of its spring per length of the crease", above=0)
    time: float = quantity(TIME, "relaxation time", above=0)


class CreaseDamage(Section):
    """Loss of the moment of a crease over many folds: the share loss (1 - exp(-wear / turn)) is lost."""

    about: ClassVar[str] = (
        "Loss of the moment of a crease over many folds: the share loss (1 - exp(-wear / turn)) is lost"
    )

    loss: Annotated[
        float,
        Field(
            strict=True,
            gt=0,
            le=1,
            description="share of the moment that is lost after infinitely many folds",
            examples=[0.3],
        ),
    ]
    turn: float = quantity(ANGLE, "wear after which 63 % of this share is lost", above=0, examples=["36000 deg"])
    of: Annotated[
        Literal["turns", "set"],
        Field(
            description="wear of a crease: the sum of all its turns, in both senses, or of all changes of its permanent"
            " fold"
        ),
    ] = "turns"


class CreaseGroup(Section):
    """Creases that differ from the others; values that are not given are those of [crease]."""

    about: ClassVar[str] = "Creases that differ from the others; values that are not given are those of [crease]"

    name: Annotated[
        str | None,
        Field(description="name of the group, for drives, measures and other groups", examples=["gates"]),
    ] = None
    of: Annotated[str, Field(description=f"creases of the group: {_OF}", examples=["crease 0"])]
    stiffness: float | None = quantity(
        CREASE_STIFFNESS, "stiffness of their springs per length", default=None, at_least=0
    )
    rest_angle: float | str | None = quantity(
        ANGLE, "rest angle of their springs", default=None, words=_RESTS, examples=["0 deg"]
    )
    law: Annotated[
        Literal["linear", "locking"] | None, Field(description="law of their springs", examples=["linear"])
    ] = None
    lock_angle: float | None = quantity(
        ANGLE,
        "angle beyond which a locking spring stiffens",
        default=None,
        above=0,
        below=math.pi,
        examples=["135 deg"],
    )
    friction: float | None = quantity(
        CREASE_MOMENT, "moment of their dry friction per length", default=None, at_least=0
    )
    quadratic_stiffness: float | None = quantity(
        CREASE_QUADRATIC, "quadratic term of their moment per length", default=None
    )
    cubic_stiffness: float | None = quantity(CREASE_CUBIC, "cubic term of their moment per length", default=None)
    yield_moment: float | str | None = quantity(
        CREASE_MOMENT,
        'moment per length at which they begin to fold permanently; "none" if they never do',
        default=None,
        words=(NONE,),
        above=0,
    )
    hardening: float | None = quantity(
        CREASE_STIFFNESS,
        "slope of their moment while they yield, per length",
        default=None,
        at_least=0,
        examples=["1e-3 N m/rad/m"],
    )
    branches: Annotated[
        tuple[CreaseBranch, ...] | None,
        BeforeValidator(_without_branches),
        Field(description='Maxwell branches; an empty list or "none" if they have none', examples=[[]]),
    ] = None
    damage: Annotated[
        CreaseDamage | Literal["none"] | None,
        Field(description='loss of their moment over many folds; "none" if they keep it', examples=["none"]),
    ] = None
    damping: float | None = quantity(CREASE_DAMPING, "viscous damping per length", default=None, at_least=0)
    extension: float | None = quantity(
        EXTENSION, "stiffness per length of the springs against opening", default=None, above=0
    )
    extension_damping: float | None = quantity(
        EXTENSION_DAMPING, "viscous damping of opening per length", default=None, at_least=0
    )
    fold_limit: float | None = quantity(
        ANGLE, "stop: largest fold angle", default=None, above=0, at_most=math.pi, examples=["175 deg"]
    )
    back_limit: float | None = quantity(
        ANGLE,
        "stop: largest angle in the opposite sense",
        default=None,
        at_least=0,
        at_most=math.pi,
        examples=["3 deg"],
    )
    stop_stiffness: float | None = quantity(
        CREASE_STIFFNESS, "stiffness of their stops per length", default=None, above=0, examples=["1 kN m/rad/m"]
    )
    start: float | None = quantity(ANGLE, "initial fold angle", default=None, examples=["-1 deg"])

    @field_validator("name")
    @classmethod
    def _checked(cls, name: str | None) -> str | None:
        return None if name is None else checked_name(name)


class Crease(Section):
    """The creases; angles are 0 when flat and positive when a crease folds as assigned."""

    about: ClassVar[str] = "The creases; angles are 0 when flat and positive when a crease folds as assigned"
    later: ClassVar[tuple[str, ...]] = ("branches",)

    stiffness: float | None = quantity(
        CREASE_STIFFNESS,
        "stiffness of a crease's spring per length of the crease; chosen if not given",
        default=None,
        at_least=0,
    )
    rest_angle: float | str = quantity(
        ANGLE,
        'rest angle of the spring: an angle, "flat" or "as built"',
        default="as built",
        words=_RESTS,
        at_least=-math.pi,
        at_most=math.pi,
    )
    law: Annotated[
        Literal["linear", "locking"],
        Field(
            description="law of the spring; locking: the spring stiffens beyond lock_angle, so that facets do not pass"
            " through each other"
        ),
    ] = "linear"
    lock_angle: float = quantity(
        ANGLE,
        "angle beyond which a locking spring stiffens, in both senses (Liu and Paulino 2017)",
        default=math.radians(135.0),
        above=0,
        below=math.pi,
    )
    friction: float | None = quantity(
        CREASE_MOMENT,
        "moment of dry friction per length of the crease, needed to turn it slowly",
        default=None,
        at_least=0,
    )
    quadratic_stiffness: float | None = quantity(
        CREASE_QUADRATIC,
        "quadratic term of the moment over the angle from rest, per length of the crease: an asymmetric spring; 0 if"
        " not given",
        default=None,
    )
    cubic_stiffness: float | None = quantity(
        CREASE_CUBIC,
        "cubic term of the moment over the angle from rest, per length of the crease; 0 if not given",
        default=None,
    )
    yield_moment: float | None = quantity(
        CREASE_MOMENT,
        "moment per length of the crease at which it begins to fold permanently; if not given, it never does",
        default=None,
        above=0,
    )
    hardening: float | None = quantity(
        CREASE_STIFFNESS,
        "slope of the moment over the angle while a crease yields, per length of the crease: kinematic hardening; 0 if"
        " not given",
        default=None,
        at_least=0,
        examples=["1e-3 N m/rad/m"],
    )
    branches: Annotated[tuple[CreaseBranch, ...], Field(description="Maxwell branches parallel to the spring")] = ()
    damage: Annotated[
        CreaseDamage | None, Field(description="loss of the moment of a crease over many folds; none if not given")
    ] = None
    damping: float | None = quantity(
        CREASE_DAMPING,
        "viscous damping per length of the crease, parallel to the spring (Kelvin-Voigt); chosen if not given",
        default=None,
        at_least=0,
    )
    extension: float | None = quantity(
        EXTENSION,
        "stiffness, per length of the crease, of a spring against opening of the crease; only for rigid facets, whose"
        " creases are hinges if it is not given",
        default=None,
        above=0,
    )
    extension_damping: float | None = quantity(
        EXTENSION_DAMPING,
        "viscous damping of opening per length of the crease; chosen if not given",
        default=None,
        at_least=0,
    )
    fold_limit: float | None = quantity(
        ANGLE,
        "stop: largest fold angle of a crease; if not given, 180 deg for rigid facets, no stop for others",
        default=None,
        above=0,
        at_most=math.pi,
        examples=["175 deg"],
    )
    back_limit: float | None = quantity(
        ANGLE,
        "stop: largest angle in the opposite sense; if not given, 0 deg for rigid facets, no stop for others",
        default=None,
        at_least=0,
        at_most=math.pi,
        examples=["3 deg"],
    )
    stop_stiffness: float | None = quantity(
        CREASE_STIFFNESS,
        "stiffness of both stops per length of the crease; if not given, stops are rigid in statics and 1000 times as"
        " stiff as the crease in a run",
        default=None,
        above=0,
        examples=["1 kN m/rad/m"],
    )
    start: float = quantity(ANGLE, "initial fold angle of a crease; only for rigid facets", default=0.0)
    group: Annotated[
        tuple[CreaseGroup, ...],
        Field(description="groups of creases that differ; for a crease in several groups the last one counts"),
    ] = ()


def largest_extension(crease: Crease) -> float:
    """Return the largest stiffness per length against opening, of a section and its groups; 0 if no crease opens."""
    return max(crease.extension or 0.0, *(group.extension or 0.0 for group in crease.group), 0.0)


class Support(Section):
    """A support: a facet, an edge or a vertex that is held."""

    about: ClassVar[str] = "A support: a facet, an edge or a vertex that is held"

    of: Annotated[
        str,
        Field(
            description="part of the sheet that is held: a facet, clamped; an edge, about which the sheet turns; or,"
            " if facets bend, a vertex",
            examples=["facet 0", "edge 3"],
        ),
    ]
    axes: Annotated[
        str | None,
        Field(
            pattern="^[xyz]{1,3}$",
            description="axes along which a vertex, or an edge of facets that bend, is held; xyz if not given",
            examples=["xz"],
        ),
    ] = None

    @property
    def kind(self) -> str:
        """Return the kind of part that is held: "facet", "edge" or "vertex"."""
        word = self.of.split()[0] if self.of.split() else ""
        return "edge" if word == "crease" else word
