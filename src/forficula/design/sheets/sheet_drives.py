"""Sections of a sheet's design for tendons, drives, measures and protocol."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self

from pydantic import AfterValidator, Discriminator, Field, Tag, create_model, field_validator, model_validator

from forficula.design.protocol import CommonProtocol
from forficula.design.section import (
    ANGLE,
    ANGULAR_SPEED,
    LENGTH,
    TIME,
    TORQUE,
    Section,
    kind_tag,
    quantity,
)
from forficula.design.sheets.sheet_names import checked_name
from forficula.design.tendon import ElasticTendon
from forficula.errors import InputError
from forficula.quantities import Unit

FORCE = Unit(display="N", si="N", example="0.2 N")

_CREASES = "creases, mountains, valleys, a group by name, or crease 2"


def _between(description: str, **default: Any) -> Any:
    """Create a section with a name and the keys "from" and "to", which are not names in Python."""
    end: Any = Annotated[str | None if default else str, Field(description=description, **default)]
    ground = quantity(
        LENGTH,
        'x, y and z of the point on the ground, if an end is "ground"',
        default=(),
        examples=[["0 cm", "0 cm", "-5 cm"]],
    )
    fields: dict[str, Any] = {"name": str, "from": end, "to": end, "ground": (tuple[float, ...], ground)}
    return create_model("_Between", __base__=Section, **fields)


if TYPE_CHECKING:

    class Joined(Section):
        """The class that `_between` creates, for the type checker."""

        name: str
        ground: tuple[float, ...]

    class _MaybeJoined(Section):
        """The class that `_between` creates, for the type checker."""

        name: str
        ground: tuple[float, ...]

else:
    Joined = _between(
        'end of the tendon: "vertex 4", "edge 12 at 0.5" (share of its length), "facet 3 at centre", "facet 3 at 0.5,'
        ' 1" (shares of its extent along x and y), or, if facets bend, "ground"'
    )
    _MaybeJoined = _between("end of a distance, for kind distance: a place such as vertex 4", default=None)


class SheetTendon(ElasticTendon, Joined):
    """A pull-only tendon between two places: a spring, or the law of a material."""

    about: ClassVar[str] = "A pull-only tendon between two places: a spring, or the law of a material"

    needed: ClassVar[tuple[str, ...]] = ("stiffness",)

    name: Annotated[str, Field(description="name of the tendon in tables and figures")]

    _checked = field_validator("name")(checked_name)


_KIND = Field(
    description="torque on creases, force at points of the sheet, displacement of such points, or rest-angle: change of"
    " the rest angles of creases"
)
_OF = Field(
    description=f"where the drive acts: {_CREASES}; for a force or a displacement, points: vertex 4, edge 12 at 0.5"
)
_RISE = quantity(
    TIME, "time over which the drive rises linearly from 0; if not given, protocol.rise", default=None, at_least=0
)


def _some_direction(direction: tuple[float, float, float]) -> tuple[float, float, float]:
    if not any(direction):
        raise InputError("need a direction that is not zero, such as [0, 0, -1], got [0, 0, 0]")
    return direction


_Direction = Annotated[
    tuple[float, float, float],
    AfterValidator(_some_direction),
    Field(description="direction of a force or a displacement, as a vector of any length", examples=[[0, 0, -1]]),
]


class NamedDrive(Section):
    """A drive, which stages of the protocol switch on."""

    about: ClassVar[str] = "A drive, which stages of the protocol switch on"

    # key of the strength of a drive
    strength_key: ClassVar[str]

    name: Annotated[str, Field(description="name of the drive, for stages")]

    _checked = field_validator("name")(checked_name)

    @model_validator(mode="before")
    @classmethod
    def _value_is_strength(cls, table: object) -> object:
        """Accept the key `value` for the strength, for which every kind also has another key."""
        if not isinstance(table, dict) or table.get("value") is None or cls.strength_key == "value":
            return table
        # of two, the last one was laid over the other
        last = next(key for key in reversed(table) if key in ("value", cls.strength_key))
        others = {key: value for key, value in table.items() if key != "value"}
        return others | {cls.strength_key: table[last]}


class TorqueDrive(NamedDrive):
    """A drive, which stages of the protocol switch on.

    A torque on creases.
    """

    strength_key: ClassVar[str] = "value"

    kind: Annotated[Literal["torque"], _KIND]
    of: Annotated[str, _OF]
    value: float = quantity(TORQUE, "for kind torque: torque on each of these creases; > 0 folds", examples=["3 N cm"])
    no_load_speed: float | None = quantity(
        ANGULAR_SPEED,
        "for kind torque: speed of a crease at which the torque has fallen to 0, as in a motor; if not given, the"
        " torque is constant",
        default=None,
        above=0,
        examples=["360 deg/s"],
    )
    rise: float | None = _RISE


class RestAngleDrive(NamedDrive):
    """A drive, which stages of the protocol switch on.

    A change of the rest angles of the springs of creases.
    """

    strength_key: ClassVar[str] = "angle"

    kind: Annotated[Literal["rest-angle"], _KIND]
    of: Annotated[str, _OF]
    angle: float | None = quantity(
        ANGLE,
        "for kind rest-angle: change of the rest angle of each of these creases; > 0 folds",
        default=None,
        at_least=-2 * math.pi,
        at_most=2 * math.pi,
        examples=["90 deg"],
    )
    to: Annotated[
        Literal["target"] | None,
        Field(description="for kind rest-angle, instead of an angle: rest angles change to the target of each crease"),
    ] = None
    rise: float | None = _RISE

    @model_validator(mode="after")
    def _angle_or_target(self) -> Self:
        if self.angle is None and self.to is None:
            raise InputError("angle: is missing")
        if self.angle is not None and self.to is not None:
            raise InputError('angle: need either an angle or to = "target", got both')
        return self


class ForceDrive(NamedDrive):
    """A drive, which stages of the protocol switch on.

    A force at places, in one direction.
    """

    strength_key: ClassVar[str] = "force"

    kind: Annotated[Literal["force"], _KIND]
    of: Annotated[str | tuple[str, ...], _OF]
    force: float = quantity(FORCE, "for kind force: force at each of these places")
    direction: _Direction
    rise: float | None = _RISE


class DisplacementDrive(NamedDrive):
    """A drive, which stages of the protocol switch on.

    A displacement of places, in one direction.
    """

    strength_key: ClassVar[str] = "distance"

    kind: Annotated[Literal["displacement"], _KIND]
    of: Annotated[str | tuple[str, ...], _OF]
    distance: float = quantity(
        LENGTH, "for kind displacement: distance by which each of these places moves on from its current position"
    )
    direction: _Direction
    rise: float | None = _RISE


SheetDrive = Annotated[
    Annotated[TorqueDrive, Tag("<torque>")]
    | Annotated[ForceDrive, Tag("<force>")]
    | Annotated[DisplacementDrive, Tag("<displacement>")]
    | Annotated[RestAngleDrive, Tag("<rest-angle>")],
    Discriminator(kind_tag),
]


def places_of(drive: SheetDrive) -> tuple[str, ...]:
    """Return the places where a drive acts, as text; none for a drive that acts on creases."""
    if isinstance(drive, TorqueDrive | RestAngleDrive):
        return ()
    return (drive.of,) if isinstance(drive.of, str) else drive.of


class SheetMeasure(_MaybeJoined):
    """A measure: an angle or a distance that is recorded, for goals and tables."""

    about: ClassVar[str] = "A measure: an angle or a distance that is recorded, for goals and tables"

    name: Annotated[str, Field(description="name of the measure, for goals and tables")]
    kind: Annotated[
        Literal["fold-angle", "distance"],
        Field(description="fold-angle of creases, valley positive, or distance between two places"),
    ]
    of: Annotated[str | None, Field(description=f"creases of a fold angle: {_CREASES}")] = None

    _checked = field_validator("name")(checked_name)

    @model_validator(mode="after")
    def _has_what_its_kind_needs(self) -> SheetMeasure:
        if self.kind == "fold-angle" and self.ground:
            raise InputError('ground: is for kind = "distance"')
        present = [key for key in ("of", "from", "to") if getattr(self, key) is not None]
        needed = ["of"] if self.kind == "fold-angle" else ["from", "to"]
        if present != needed:
            got = " and ".join(present) or "none of these"
            raise InputError(f'kind = "{self.kind}" needs {" and ".join(needed)}, and nothing else; got {got}')
        return self


class SheetProtocol(CommonProtocol):
    """The stages in which the sheet is driven, and the criteria by which a run is judged."""

    about: ClassVar[str] = "The stages in which the sheet is driven, and the criteria by which a run is judged"

    arrival: float = quantity(
        ANGLE,
        'the goal "target" is reached when every crease is at most this far from its target angle',
        default=math.radians(5.0),
        above=0,
    )
