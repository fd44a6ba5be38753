"""Sections of a sheet's design that say what acts on it: its tendons, drives, measures and protocol."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self

from pydantic import AfterValidator, Discriminator, Field, Tag, create_model, field_validator, model_validator

from forficula.design.protocol import Protocol
from forficula.design.section import (
    ACCELERATION,
    ANGLE,
    ANGULAR_SPEED,
    LENGTH,
    SHORT_TIME,
    TIME,
    TORQUE,
    Section,
    quantity,
)
from forficula.design.sheets.sheet_names import checked_name
from forficula.design.tendon import ElasticTendon
from forficula.errors import InputError
from forficula.quantities import Unit

FORCE = Unit(display="N", si="N", example="0.2 N")

_CREASES = "creases, mountains, valleys, a group by name, or crease 2"


def _between(description: str, **default: Any) -> Any:
    """A named part with the keys "from" and "to", which are no names in Python."""
    end: Any = Annotated[str | None if default else str, Field(description=description, **default)]
    ground = quantity(
        LENGTH, 'x, y and z of the ground, where an end is "ground"', default=(), examples=[["0 cm", "0 cm", "-5 cm"]]
    )
    fields: dict[str, Any] = {"name": str, "from": end, "to": end, "ground": (tuple[float, ...], ground)}
    return create_model("_Between", __base__=Section, **fields)


if TYPE_CHECKING:

    class Joined(Section):
        """What `_between` makes."""

        name: str
        ground: tuple[float, ...]

    class _MaybeJoined(Section):
        """What `_between` makes."""

        name: str
        ground: tuple[float, ...]

else:
    Joined = _between(
        "where it ends: vertex 4, edge 12 at 0.5, facet 3 at centre, facet 3 at 0.5, 1, ground where facets bend"
    )
    _MaybeJoined = _between("of a distance: where it begins and ends", default=None)


class SheetTendon(ElasticTendon, Joined):
    """What pulls two places together and never pushes: a spring, or a law of a material."""

    about: ClassVar[str] = "What pulls two places together and never pushes: a spring, or a law of a material"

    needed: ClassVar[tuple[str, ...]] = ("stiffness",)

    name: Annotated[str, Field(description="what tables and figures call it")]

    _checked = field_validator("name")(checked_name)


_KIND = Field(
    description="torque on creases, force at places, displacement of these, or"
    " rest-angle: springs of creases rest further on"
)
_OF = Field(description=f"where it acts: {_CREASES}; of a force or a displacement places: vertex 4, edge 12 at 0.5")
_RISE = quantity(TIME, "time over which it rises evenly from 0; without it protocol.rise", default=None, at_least=0)


def _some_direction(direction: tuple[float, float, float]) -> tuple[float, float, float]:
    if not any(direction):
        raise InputError("need the way it points, such as [0, 0, -1], got [0, 0, 0]")
    return direction


_Direction = Annotated[
    tuple[float, float, float],
    AfterValidator(_some_direction),
    Field(description="of a force or a displacement: the way it points, of any length", examples=[[0, 0, -1]]),
]


class _AnyDrive(Section):
    """What a stage of the protocol switches on."""

    about: ClassVar[str] = "What a stage of the protocol switches on"

    # key of the value that says how strong a drive is
    strength_key: ClassVar[str]

    name: Annotated[str, Field(description="as stages call it")]

    _checked = field_validator("name")(checked_name)

    @model_validator(mode="before")
    @classmethod
    def _value_is_strength(cls, given: object) -> object:
        """Read the key `value` as the strength, which every kind has under a key of its own."""
        if not isinstance(given, dict) or given.get("value") is None or cls.strength_key == "value":
            return given
        others = {key: value for key, value in given.items() if key != "value"}
        return others | {cls.strength_key: given["value"]}


class TorqueDrive(_AnyDrive):
    """What a stage of the protocol switches on.

    A torque on creases.
    """

    strength_key: ClassVar[str] = "value"

    kind: Annotated[Literal["torque"], _KIND]
    of: Annotated[str, _OF]
    value: float = quantity(TORQUE, "of kind torque: on each of these creases, folding where > 0", examples=["3 N cm"])
    no_load_speed: float | None = quantity(
        ANGULAR_SPEED,
        "of kind torque: speed of a crease at which nothing is left of it, as of a motor; without it the torque stays",
        default=None,
        above=0,
        examples=["360 deg/s"],
    )
    rise: float | None = _RISE


class RestAngleDrive(_AnyDrive):
    """What a stage of the protocol switches on.

    A change of the angles at which the springs of creases rest.
    """

    strength_key: ClassVar[str] = "angle"

    kind: Annotated[Literal["rest-angle"], _KIND]
    of: Annotated[str, _OF]
    angle: float | None = quantity(
        ANGLE,
        "of kind rest-angle: by how much further on, folding where > 0",
        default=None,
        at_least=-2 * math.pi,
        at_most=2 * math.pi,
        examples=["90 deg"],
    )
    to: Annotated[
        Literal["target"] | None,
        Field(description="of kind rest-angle, instead of an angle: on to each crease's own target"),
    ] = None
    rise: float | None = _RISE

    @model_validator(mode="after")
    def _angle_or_target(self) -> Self:
        if self.angle is None and self.to is None:
            raise InputError("angle: is missing")
        if self.angle is not None and self.to is not None:
            raise InputError('angle: need either an angle or to = "target", got both')
        return self


class ForceDrive(_AnyDrive):
    """What a stage of the protocol switches on.

    A force at places, in one direction.
    """

    strength_key: ClassVar[str] = "force"

    kind: Annotated[Literal["force"], _KIND]
    of: Annotated[str | tuple[str, ...], _OF]
    force: float = quantity(FORCE, "of kind force: at each of these places")
    direction: _Direction
    rise: float | None = _RISE


class DisplacementDrive(_AnyDrive):
    """What a stage of the protocol switches on.

    A displacement of places, in one direction.
    """

    strength_key: ClassVar[str] = "distance"

    kind: Annotated[Literal["displacement"], _KIND]
    of: Annotated[str | tuple[str, ...], _OF]
    distance: float = quantity(LENGTH, "of kind displacement: by which each of these places goes on from where it is")
    direction: _Direction
    rise: float | None = _RISE


def _tag(given: object) -> str | None:
    """The tag of a drive, or of the table of one, by its kind; None where it has no text there."""
    kind = given.get("kind") if isinstance(given, dict) else getattr(given, "kind", None)
    return f"<{kind}>" if isinstance(kind, str) else None


# pydantic finds a kind by a key only where nothing reads it before; no tag may be taken for a key in errors
SheetDrive = Annotated[
    Annotated[TorqueDrive, Tag("<torque>")]
    | Annotated[ForceDrive, Tag("<force>")]
    | Annotated[DisplacementDrive, Tag("<displacement>")]
    | Annotated[RestAngleDrive, Tag("<rest-angle>")],
    Discriminator(_tag),
]


def places_of(drive: SheetDrive) -> tuple[str, ...]:
    """Places where a drive acts, as text; none for a drive that acts on creases."""
    if isinstance(drive, TorqueDrive | RestAngleDrive):
        return ()
    return (drive.of,) if isinstance(drive.of, str) else drive.of


class SheetMeasure(_MaybeJoined):
    """What is watched by name, for goals and tables."""

    about: ClassVar[str] = "What is watched by name, for goals and tables"

    name: Annotated[str, Field(description="as goals and tables call it")]
    kind: Annotated[
        Literal["fold-angle", "distance"],
        Field(description="fold-angle: of creases, valley positive; distance: of two places"),
    ]
    of: Annotated[str | None, Field(description=f"of a fold angle: {_CREASES}")] = None

    _checked = field_validator("name")(checked_name)

    @model_validator(mode="after")
    def _has_what_its_kind_needs(self) -> SheetMeasure:
        if self.kind == "fold-angle" and self.ground:
            raise InputError('ground: is for kind = "distance"')
        given = [key for key in ("of", "from", "to") if getattr(self, key) is not None]
        needed = ["of"] if self.kind == "fold-angle" else ["from", "to"]
        if given != needed:
            got = " and ".join(given) or "neither of them"
            raise InputError(f'kind = "{self.kind}" needs {" and ".join(needed)}, and nothing else; got {got}')
        return self


class SheetProtocol(Protocol):
    """What is done to a sheet, and what counts as done."""

    about: ClassVar[str] = "What is done to a sheet, and what counts as done"

    timestep: float | Literal["auto"] = quantity(
        SHORT_TIME,
        'step of the integrator, or "auto": halved until verdict and times stay, and the energy balance closes',
        default="auto",
        above=0,
        words=("auto",),
    )
    sample_interval: float = quantity(SHORT_TIME, "time between two rows of the record", default=2e-3, above=0)
    rest_speed: float = quantity(
        ANGULAR_SPEED, "at rest means that every hinge is slower", default=math.radians(2.0), above=0
    )
    window: float = quantity(
        TIME,
        "over which a state is averaged; what rests so long short of its goal, and three times as long as its"
        " tendons' Maxwell branches take to relax, is stuck",
        default=0.1,
        above=0,
    )
    gravity: float = quantity(
        ACCELERATION, "gravity across the sheet, downwards where it lies flat; 0 switches it off", default=0.0
    )
    contact: Annotated[bool, Field(strict=True, description="whether facets touch each other")] = False
    arrival: float = quantity(
        ANGLE, 'goal "target": within which every crease must be of its target', default=math.radians(5.0), above=0
    )
