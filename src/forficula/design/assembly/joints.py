"""Sections of an assembly for the joints between its parts, and for drives on these joints."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self

from pydantic import AfterValidator, Discriminator, Field, Tag, create_model, field_validator, model_validator

from forficula.design.section import (
    ANGLE,
    ANGULAR_SPEED,
    HINGE_DAMPING,
    HINGE_STIFFNESS,
    INERTIA,
    LENGTH,
    MASS,
    STIFFNESS,
    TENDON_DAMPING,
    TIME,
    TORQUE,
    Section,
    kind_tag,
    quantity,
)
from forficula.design.sheets.sheet_drives import NamedDrive
from forficula.design.sheets.sheet_names import checked_name
from forficula.design.tendon import ElasticTendon
from forficula.errors import InputError
from forficula.quantities import Unit

GROUND_BODY = "ground"
FORCE = Unit(display="N", si="N", example="0.2 N")

_POINT = 'a point of a part, such as "fan.tip0"'
_Direction = tuple[float, float, float]


def _some_direction(direction: _Direction) -> _Direction:
    if not any(direction):
        raise InputError("need a direction that is not zero, such as [0, 0, 1], got [0, 0, 0]")
    return direction


_Vector = Annotated[_Direction, AfterValidator(_some_direction)]


class _AnyJoint(Section):
    """A joint between two parts, or between a part and the ground."""

    about: ClassVar[str] = "A joint between two parts, or between a part and the ground"

    name: Annotated[str, Field(description="name of the joint, for drives, bounds and tables")]

    _checked = field_validator("name")(checked_name)


class PlacingJoint(_AnyJoint):
    """A joint between two parts, or between a part and the ground.

    The joint carries a part: what the part fixes to the ground moves with a body of another part instead.

    The joint also places the part: its first point comes to lie on the first point of the other part, or at `position`,
    and the direction from its first to its second point becomes that of the other part's points, or `along`. The part
    is then turned about this line so that its z axis is as near as possible to `up`.
    """

    part: Annotated[str, Field(description="part that the joint carries and places", examples=["fan"])]
    to: Annotated[
        str,
        Field(
            description='body that carries the part: "ground", or a body of another part, such as "midwing.facet1"',
            examples=["midwing.facet1"],
        ),
    ] = GROUND_BODY
    points: Annotated[
        tuple[str, ...],
        Field(
            max_length=2,
            description="one or two points of the part by name; without points, the part keeps the coordinates of its"
            " own design",
            examples=[["hub0", "ring0"]],
        ),
    ] = ()
    onto: Annotated[
        tuple[str, ...],
        Field(
            max_length=2,
            description="points of the body on which `points` lie, one for each of them: the second one only gives the"
            " direction",
            examples=[["facet1_vertex0", "facet1_vertex2"]],
        ),
    ] = ()
    position: tuple[float, ...] = quantity(
        LENGTH,
        "x, y and z of the first point as built, instead of onto",
        default=(),
        examples=[["0 cm", "0 cm", "2 cm"]],
    )
    along: Annotated[
        _Vector | None,
        Field(description="direction from the first to the second point, instead of onto", examples=[[1, 0, 0]]),
    ] = None
    up: Annotated[
        _Vector | None,
        Field(
            description="direction of the z axis of the part, as far as a rotation about the line through both points"
            " allows; if not given, the part is turned as little as possible",
            examples=[[0, 0, 1]],
        ),
    ] = None

    @model_validator(mode="after")
    def _places_once(self) -> Self:
        if self.position and len(self.position) != 3:
            raise InputError(f"position: need x, y and z, got {len(self.position)} values")
        if self.onto and (self.position or self.along is not None):
            raise InputError("onto: need either onto, or position and along, got both")
        if self.onto and len(self.onto) != len(self.points):
            raise InputError(f"onto: need as many points as `points`, {len(self.points)}, got {len(self.onto)}")
        if self.points and not (self.onto or self.position):
            raise InputError("onto: is missing; give onto or position, the position of the points in the assembly")
        if (self.position or self.along is not None) and not self.points:
            raise InputError("points: is missing; name the point of the part that position places")
        if self.along is not None and len(self.points) < 2:
            raise InputError("along: needs two entries of points, whose direction it sets")
        return self


class RigidJoint(PlacingJoint):
    """A joint between two parts, or between a part and the ground.

    A rigid joint: the part is fixed to a body.
    """

    kind: Annotated[Literal["rigid"], Field(description="kind of joint")]


class HingeJoint(PlacingJoint):
    """A joint between two parts, or between a part and the ground.

    A hinge about the line through both points; its angle is 0 as built, and right-handed about the direction from the
    first to the second point.
    """

    kind: Annotated[Literal["hinge"], Field(description="kind of joint")]
    stiffness: float = quantity(HINGE_STIFFNESS, "for kind hinge: stiffness of its spring", default=0.0, at_least=0)
    rest_angle: float = quantity(ANGLE, "for kind hinge: rest angle of its spring", default=0.0)
    damping: float = quantity(HINGE_DAMPING, "for kind hinge: viscous damping", default=0.0, at_least=0)
    friction: float = quantity(TORQUE, "for kind hinge: torque of dry friction", default=0.0, at_least=0)
    armature: float = quantity(INERTIA, "for kind hinge: added inertia", default=0.0, at_least=0)
    lower: float | None = quantity(ANGLE, "for kind hinge: least angle, a stop", default=None, at_most=0)
    upper: float | None = quantity(ANGLE, "for kind hinge: largest angle, a stop", default=None, at_least=0)
    start: float = quantity(ANGLE, "for kind hinge: initial angle", default=0.0)
    mass: float = quantity(
        MASS,
        "for kind hinge: mass that it carries in addition to the part, divided equally between the points that the part"
        " fixes to the ground",
        default=0.0,
        at_least=0,
    )

    @model_validator(mode="after")
    def _has_an_axis(self) -> Self:
        if len(self.points) != 2:
            raise InputError(f"points: need two points of the part, on the axis of the hinge, got {len(self.points)}")
        low, high = -math.inf if self.lower is None else self.lower, math.inf if self.upper is None else self.upper
        if not low <= self.start <= high:
            raise InputError("start: need an angle between lower and upper")
        return self


class CouplingJoint(_AnyJoint):
    """A joint between two parts, or between a part and the ground.

    A coupling of the angles of two joints: the second angle is the first one times a ratio.
    """

    kind: Annotated[Literal["coupling"], Field(description="kind of joint")]
    hinges: Annotated[
        tuple[str, str],
        Field(
            description="for kind coupling: two hinges by name; their angles are relative to the built shape",
            examples=[["midwing.crease1", "fan.turn0"]],
        ),
    ]
    ratio: Annotated[
        float,
        Field(description="for kind coupling: angle of the second hinge divided by that of the first"),
    ] = 1.0
    stiffness: float | Literal["rigid"] = quantity(
        HINGE_STIFFNESS,
        'for kind coupling: stiffness of its spring, or "rigid"',
        default="rigid",
        at_least=0,
        words=("rigid",),
    )

    @field_validator("ratio")
    @classmethod
    def _not_zero(cls, ratio: float) -> float:
        if not ratio:
            raise InputError("need a ratio that is not 0, got 0")
        return ratio


def _between(base: type[Section]) -> Any:
    """Create a section with the keys "from" and "to", which are not names in Python."""
    end: Any = Annotated[str, Field(description=f'for kinds spring and tendon: {_POINT}, or "ground"')]
    ground = quantity(
        LENGTH,
        'for kinds spring and tendon: x, y and z of the point on the ground, if an end is "ground"',
        default=(),
        examples=[["0 cm", "0 cm", "-5 cm"]],
    )
    fields: dict[str, Any] = {"from": (end, ...), "to": (end, ...), "ground": (tuple[float, ...], ground)}
    return create_model("_Between", __base__=base, **fields)


if TYPE_CHECKING:

    class _Joined(_AnyJoint):
        """The class that `_between` creates, for the type checker."""

        ground: tuple[float, ...]

    class _JoinedTendon(ElasticTendon, _AnyJoint):
        """The class that `_between` creates, for the type checker."""

        ground: tuple[float, ...]

else:
    _Joined = _between(_AnyJoint)

    class _NamedTendon(ElasticTendon, _AnyJoint):
        """A joint between two parts, or between a part and the ground."""

        about: ClassVar[str] = _AnyJoint.about

    _JoinedTendon = _between(_NamedTendon)


class SpringJoint(_Joined):
    """A joint between two parts, or between a part and the ground.

    A spring between two points, which pulls and pushes.
    """

    kind: Annotated[Literal["spring"], Field(description="kind of joint")]
    stiffness: float = quantity(STIFFNESS, "for kind spring: force per extension", at_least=0)
    rest_length: float = quantity(LENGTH, "for kind spring: length without a force", at_least=0)
    damping: float = quantity(TENDON_DAMPING, "for kind spring: viscous damping", default=0.0, at_least=0)


class TendonJoint(_JoinedTendon):
    """A joint between two parts, or between a part and the ground.

    A pull-only tendon between two points: a spring, or the law of a material.
    """

    needed: ClassVar[tuple[str, ...]] = ("stiffness",)

    kind: Annotated[Literal["tendon"], Field(description="kind of joint")]


Joint = Annotated[
    Annotated[RigidJoint, Tag("<rigid>")]
    | Annotated[HingeJoint, Tag("<hinge>")]
    | Annotated[CouplingJoint, Tag("<coupling>")]
    | Annotated[SpringJoint, Tag("<spring>")]
    | Annotated[TendonJoint, Tag("<tendon>")],
    Discriminator(kind_tag),
]

_DRIVE_KIND = Field(description="torque on hinges, or force at points")
_Targets = Annotated[
    str | tuple[str, ...],
    Field(
        description='hinges by name or role for a torque, such as "claval line" or "fan.turn0"; points for a force, '
        'such as "fan.tip0"'
    ),
]
_RISE = quantity(
    TIME, "time over which the drive rises linearly from 0; if not given, protocol.rise", default=None, at_least=0
)


class HingeDrive(NamedDrive):
    """A drive of the assembly, in addition to those of its parts.

    A torque on hinges.
    """

    about: ClassVar[str] = "A drive of the assembly, in addition to those of its parts"
    strength_key: ClassVar[str] = "value"

    kind: Annotated[Literal["torque"], _DRIVE_KIND]
    of: _Targets
    value: float = quantity(TORQUE, "for kind torque: torque on each of these hinges, in the hinge's own sense")
    no_load_speed: float | None = quantity(
        ANGULAR_SPEED,
        "for kind torque: speed of a hinge at which the torque has fallen to 0, as in a motor; if not given, the torque"
        " is constant",
        default=None,
        above=0,
        examples=["360 deg/s"],
    )
    rise: float | None = _RISE


class PointDrive(NamedDrive):
    """A drive of the assembly, in addition to those of its parts.

    A force at points, in one direction.
    """

    about: ClassVar[str] = "A drive of the assembly, in addition to those of its parts"
    strength_key: ClassVar[str] = "force"

    kind: Annotated[Literal["force"], _DRIVE_KIND]
    of: _Targets
    force: float = quantity(FORCE, "for kind force: force at each of these points")
    direction: Annotated[
        _Vector, Field(description="direction of a force, as a vector of any length", examples=[[0, 0, -1]])
    ]
    rise: float | None = _RISE


JointDrive = Annotated[
    Annotated[HingeDrive, Tag("<torque>")] | Annotated[PointDrive, Tag("<force>")], Discriminator(kind_tag)
]


def drive_targets(drive: HingeDrive | PointDrive) -> tuple[str, ...]:
    """Return the names of the hinges or points that a drive acts on."""
    return (drive.of,) if isinstance(drive.of, str) else drive.of
