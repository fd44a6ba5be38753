"""Sections of a sheet's design for creases: their springs, groups and laws."""

from __future__ import annotations

import math
from typing import Annotated, Any, ClassVar, Literal

from pydantic import BeforeValidator, Field, field_validator

from forficula.design.section import ANGLE, TIME, Section, quantity
from forficula.design.sheets.crease_law_section import RESTS, CreaseLawSection, CreaseLawValue, CreaseSpring
from forficula.design.sheets.sheet_names import checked_name
from forficula.material.law.crease_law_file import CREASE_DAMPING, CREASE_MOMENT, CREASE_STIFFNESS
from forficula.quantities import Unit

EXTENSION = Unit(display="N/m^2", si="N/m^2", example="1e5 N/m^2")
EXTENSION_DAMPING = Unit(display="N s/m^2", si="N s/m^2", example="10 N s/m^2")
CREASE_QUADRATIC = Unit(display="N m/rad^2/m", si="N m/rad^2/m", example="1e-3 N m/rad^2/m")
CREASE_CUBIC = Unit(display="N m/rad^3/m", si="N m/rad^3/m", example="1e-3 N m/rad^3/m")

# word of a group that switches off what the section of all creases has
NONE = "none"
_OF = "creases, mountains, valleys, a group by name, crease 2, role:zigzag, assignment:M, or several joined by and"


def _without_branches(value: object) -> object:
    """Read the word that switches the branches of a section off as an empty list."""
    return () if value == NONE else value


def _without_damage(value: object) -> object:
    """Read the word that switches the damage of all creases off as an absent section."""
    return None if value == NONE else value


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


class _NamedCreases(Section):
    """Creases that a group selects."""

    about: ClassVar[str] = "Creases that a group selects"

    name: Annotated[
        str | None,
        Field(description="name of the group, for drives, measures and other groups", examples=["gates"]),
    ] = None
    of: Annotated[str, Field(description=f"creases of the group: {_OF}", examples=["crease 0"])]

    @field_validator("name")
    @classmethod
    def _checked(cls, name: str | None) -> str | None:
        return None if name is None else checked_name(name)


class CreaseGroup(CreaseSpring, _NamedCreases):
    """Creases that differ from the others; values that are not given are those of [crease]."""

    about: ClassVar[str] = "Creases that differ from the others; values that are not given are those of [crease]"

    law: Annotated[
        CreaseLawValue | None,
        Field(description="law of their springs: its form, or the name or file of a law", examples=["linear"]),
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
    yield_moment: float | str | None = quantity(  # type: ignore[assignment]
        CREASE_MOMENT,
        'moment per length at which they begin to fold permanently; "none" if they never do',
        default=None,
        words=(NONE,),
        above=0,
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
    rest_angle: float | str | None = quantity(
        ANGLE,
        'rest angle of the spring: an angle, "flat" or "as built"; if not given, that of the law, or else "as built"',
        default=None,
        words=RESTS,
        at_least=-math.pi,
        at_most=math.pi,
    )
    law: Annotated[
        CreaseLawValue,
        Field(
            description="law of the spring: its form, or the name or file of a law, whose values apply where the"
            " design gives none; locking: the spring stiffens beyond lock_angle, so that facets do not pass through"
            " each other",
            examples=["paper"],
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
    branches: Annotated[
        tuple[CreaseBranch, ...],
        BeforeValidator(_without_branches),
        Field(description="Maxwell branches parallel to the spring"),
    ] = ()
    damage: Annotated[
        CreaseDamage | None,
        BeforeValidator(_without_damage),
        Field(
            description="loss of the moment of a crease over many folds; none if not given",
            examples=[{"loss": 0.3, "turn": "36000 deg"}],
        ),
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

    def hash_values(self) -> dict[str, Any]:
        """Return the values that affect a run, with the rest angle of creases if neither key nor law gives one."""
        of_law = self.law.rest_angle if isinstance(self.law, CreaseLawSection) else None
        return ({} if of_law is not None else {"rest_angle": "as built"}) | super().hash_values()


def with_law(crease: Crease) -> Crease:
    """Return the section with the values of its law where it gives none, and the form of the spring as its law."""
    if not isinstance(crease.law, CreaseLawSection):
        return crease
    absent = {key for key in CreaseSpring.model_fields if getattr(crease, key) in (None, ())}
    return crease.model_copy(update={"law": crease.law.kind} | {key: getattr(crease.law, key) for key in absent})


def group_values(group: CreaseGroup) -> dict[str, Any]:
    """Return the values that a group sets, by the keys of [crease]; a law sets all values that a law may contain.

    A law without a yield moment, for example, lets no crease of its group yield. Damping is that of [crease] if neither
    the group nor its law gives one.
    """
    values = {
        key: None if value == NONE else value for key, value in group if key not in ("name", "of") and value is not None
    }
    if group.yield_moment == NONE:
        values["hardening"] = None
    if not isinstance(group.law, CreaseLawSection):
        return values
    of_law = {key: getattr(group.law, key) for key in CreaseSpring.model_fields}
    if of_law["damping"] is None:
        del of_law["damping"]
    return of_law | values | {"law": group.law.kind}


def named_laws_of(crease: Crease) -> dict[str, CreaseLawSection]:
    """Return the laws that the section and its groups name or contain, by the keys of the laws."""
    laws = {"crease.law": crease.law}
    laws |= {f"crease.group.{number}.law": group.law for number, group in enumerate(crease.group) if group.law}
    return {key: law for key, law in laws.items() if isinstance(law, CreaseLawSection)}


def largest_extension(crease: Crease) -> float:
    """Return the largest stiffness per length against opening, of a section and its groups; 0 if no crease opens."""
    return max(crease.extension or 0.0, *(group.extension or 0.0 for group in crease.group), 0.0)
