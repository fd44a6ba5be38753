"""Design and its parts, and the protocol: what a user may choose, checked."""

from __future__ import annotations

import hashlib
import json
import math
import re
from dataclasses import dataclass
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, ValidationInfo, field_validator, model_validator
from pydantic.fields import FieldInfo

from forficula.errors import InputError
from forficula.pattern import EarwigFan, ring_vertices, vein_gaps
from forficula.quantities import Unit, as_written, parse_quantity, reading_unit, show_quantity

LENGTH = Unit(display="cm", si="m", example="12 cm")
SMALL_LENGTH = Unit(display="mm", si="m", example="5 mm")
ANGLE = Unit(display="deg", si="rad", example="15 deg")
DENSITY = Unit(display="g/cm^3", si="kg/m^3", example="1.27 g/cm^3")
MODULUS = Unit(display="MPa", si="Pa", example="1 MPa")
TIME = Unit(display="s", si="s", example="0.5 s")
SHORT_TIME = Unit(display="ms", si="s", example="0.2 ms")
TORQUE = Unit(display="N cm", si="N m", example="50 N cm")
STIFFNESS = Unit(display="N/cm", si="N/m", example="10 N/cm")
TENDON_DAMPING = Unit(display="N s/m", si="N s/m", example="0.1 N s/m")
HINGE_DAMPING = Unit(display="N m s/rad", si="N m s/rad", example="1e-3 N m s/rad")
INERTIA = Unit(display="kg m^2", si="kg m^2", example="1e-5 kg m^2")
ANGULAR_SPEED = Unit(display="deg/s", si="rad/s", example="1 deg/s")
ACCELERATION = Unit(display="m/s^2", si="m/s^2", example="9.81 m/s^2")


@dataclass(frozen=True, kw_only=True)
class Quantity:
    """How a field with a unit is read: text with a unit into an SI float within bounds (SI, too)."""

    unit: Unit
    above: float = -math.inf
    at_least: float = -math.inf
    below: float = math.inf
    at_most: float = math.inf
    words: tuple[str, ...] = ()

    def read(self, value: object, *, in_si: bool) -> float | str:
        """Read text with a unit, or, inside the package, an SI float; raise InputError where it is out of bounds."""
        if isinstance(value, str) and value in self.words:
            return value
        if in_si and isinstance(value, float | int) and not isinstance(value, bool):
            number, got = float(value), show_quantity(float(value), self.unit)
            if not math.isfinite(number):
                raise InputError(f"need a finite number, got {got}")
        else:
            number, got = self.parse(value), as_written(value).strip('"')
        for allowed, rule, bound in (
            (number > self.above, ">", self.above),
            (number >= self.at_least, ">=", self.at_least),
            (number < self.below, "<", self.below),
            (number <= self.at_most, "<=", self.at_most),
        ):
            if not allowed:
                raise InputError(f"need {rule} {show_quantity(bound, self.unit) if bound else 0}, got {got}")
        return number

    def parse(self, value: object) -> float:
        """Read text with a unit, whatever the bounds; raise InputError where it is none."""
        try:
            return parse_quantity(value, self.unit)
        except InputError as error:
            words = "".join(f'; "{word}" is allowed, too' for word in self.words)
            raise InputError(f"{error}{words}") from None

    def __call__(self, schema: dict[str, Any]) -> None:
        """Tell the JSON schema that the field is text with a unit."""
        schema.pop("anyOf", None)
        schema |= {"type": "string", "examples": [self.unit.example]}


def _quantity(unit: Unit, description: str, *, words: tuple[str, ...] = (), **bounds: float) -> Any:
    """A required field that `Quantity` reads."""
    return Field(description=description, json_schema_extra=Quantity(unit=unit, words=words, **bounds))


def field_quantity(field: FieldInfo) -> Quantity | None:
    """How a field is read, or None where it has no unit."""
    return field.json_schema_extra if isinstance(field.json_schema_extra, Quantity) else None


class Part(BaseModel):
    """A section of a design file: frozen, no unknown keys."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    @field_validator("*", mode="before")
    @classmethod
    def _read_quantities(cls, value: object, info: ValidationInfo) -> object:
        quantity = field_quantity(cls.model_fields[str(info.field_name)])
        return value if quantity is None else quantity.read(value, in_si=bool(info.context and info.context.get("si")))


class Pattern(Part):
    """The sheet: where it folds."""

    kind: Annotated[Literal["earwig-fan"], Field(description="the family of crease patterns")]
    proximal_length: float = _quantity(LENGTH, "length of a vein from the hub to the ring fold", above=0)
    distal_length: float = _quantity(LENGTH, "length of a vein beyond the ring fold", above=0)
    hub_radius: float = _quantity(LENGTH, "radius of the circle that the veins are tangent to", at_least=0)
    sector_angle: float = _quantity(ANGLE, "angle between neighbouring veins", above=0, below=math.pi)
    units: Annotated[int, Field(strict=True, ge=1, le=10_000, description="fan units, of two panels each")]
    tangent: Annotated[
        Literal["left", "right"], Field(description="side of the hub on which the proximal veins pass, seen outwards")
    ]


class Vein(Part):
    """The bars."""

    diameter: float = _quantity(SMALL_LENGTH, "diameter of the bars", above=0)
    density: float = _quantity(DENSITY, "mass of the bars by volume", above=0)


Share = Annotated[float, Field(strict=True)]


class Membrane(Part):
    """The sheet between the bars: stretch elasticity only."""

    youngs_modulus: float = _quantity(MODULUS, "Young's modulus", above=0)
    thickness: float = _quantity(SMALL_LENGTH, "thickness", above=0)
    poisson_ratio: Annotated[float, Field(strict=True, ge=0, lt=0.5, description="Poisson's ratio")]
    damping: float = _quantity(SHORT_TIME, "relaxation time of its Kelvin-Voigt damping", at_least=0)
    margin: float = _quantity(LENGTH, "width of the strip of each panel that is glued to its vein", above=0)
    margin_limit: Annotated[
        float,
        Field(
            strict=True,
            gt=0,
            lt=1,
            description="largest share of the panel's width that the margin takes, near the hub",
        ),
    ]
    proximal_rows: Annotated[
        tuple[Share, ...],
        Field(min_length=1, description="rows of its mesh, in shares of the proximal length; the first is its edge"),
    ]
    distal_rows: Annotated[
        tuple[Share, ...],
        Field(description="rows of its mesh between ring fold and tip, in shares of the distal length"),
    ]


class Hinge(Part):
    """Joints of the veins at the base and at the ring fold."""

    overbend: float = _quantity(
        ANGLE, "how far a distal hinge bends past straight, away from folding", at_least=0, below=math.pi / 2
    )
    fold_limit: float = _quantity(ANGLE, "how far a distal hinge folds", above=0, at_most=math.pi)
    turn_limit: float = _quantity(ANGLE, "how far a vein turns about its axis while folding", above=0, at_most=math.pi)
    turn_back: float = _quantity(ANGLE, "how far a vein turns the other way", at_least=0, at_most=math.pi)
    damping: float = _quantity(HINGE_DAMPING, "viscous damping of every hinge", at_least=0)
    armature: float = _quantity(INERTIA, "inertia added to every hinge", at_least=0)


class Tendon(Part):
    """The elastic patch across each distal hinge."""

    stiffness: float = _quantity(STIFFNESS, "force by extension beyond the resting length", at_least=0)
    rest_length: float = _quantity(LENGTH, "length below which it does not pull", at_least=0)
    damping: float = _quantity(TENDON_DAMPING, "viscous damping, which works at any length, slack or taut", at_least=0)
    proximal_attachment: float = _quantity(
        LENGTH, "distance of its end on the proximal bar from the ring fold", above=0
    )
    distal_attachment: float = _quantity(LENGTH, "distance of its end on the distal bar from the ring fold", above=0)


class Guard(Part):
    """The unstressed length limits between neighbouring tips."""

    stretch: Annotated[
        float, Field(strict=True, ge=1, description="largest distance between neighbouring tips, by the flat one")
    ]


class Stage(Part):
    """A part of the protocol: what drives the wing, and when it ends."""

    name: Annotated[str, Field(min_length=1, description="what figures and tables call it")]
    drive: Annotated[Literal["none", "fold", "unfold"], Field(description="which torque acts")]
    until: Annotated[Literal["time", "rest", "folded", "opened"], Field(description="goal that ends it")]
    hold: float = _quantity(TIME, "how long the goal must hold before the stage ends", at_least=0)
    time_limit: float = _quantity(TIME, "longest duration", above=0)


class Protocol(Part):
    """What is done to the wing, and what counts as done."""

    timestep: float | Literal["auto"] = _quantity(
        SHORT_TIME,
        'step of the integrator, or "auto": a quarter of what the stiffest mode allows',
        above=0,
        words=("auto",),
    )
    sample_interval: float = _quantity(SHORT_TIME, "time between two rows of the record", above=0)
    fold_torque: float = _quantity(TORQUE, "torque on every proximal turn axis while folding", at_least=0)
    unfold_torque: float = _quantity(TORQUE, "torque on every distal and proximal axis while unfolding", at_least=0)
    initial_overbend: float = _quantity(ANGLE, "where every distal hinge starts, past straight")
    folded_angle: float = _quantity(
        ANGLE, "folded means that every distal hinge is beyond it", above=0, at_most=math.pi
    )
    opened_angle: float = _quantity(
        ANGLE, "opened means that every distal hinge is at or past it, on the overbend side"
    )
    rest_speed: float = _quantity(ANGULAR_SPEED, "at rest means that every hinge is slower", above=0)
    window: float = _quantity(
        TIME, "over which a state is averaged; a wing that rests so long short of its goal is stuck", above=0
    )
    gravity: float = _quantity(ACCELERATION, "gravity across the wing, downwards where it lies flat; 0 switches it off")
    contact: Annotated[bool, Field(strict=True, description="whether bars touch each other")]
    stages: Annotated[tuple[Stage, ...], Field(min_length=1, description="what happens, in order")]

    @model_validator(mode="after")
    def _stages_in_order(self) -> Protocol:
        drives = [stage.drive for stage in self.stages]
        for drive in ("fold", "unfold"):
            if drives.count(drive) > 1:
                raise InputError(
                    f'protocol.stages: need at most one stage with drive = "{drive}", got {drives.count(drive)}'
                )
        if "unfold" in drives and "fold" not in drives[: drives.index("unfold")]:
            raise InputError(
                'protocol.stages: need a stage with drive = "fold" before the one with drive = "unfold",'
                f" got {as_written(drives)}"
            )
        if drives[0] != "none":
            raise InputError(
                'protocol.stages: need a first stage with drive = "none", whose end is the flat state,'
                f' got "{drives[0]}"'
            )
        return self


class Design(Part):
    """The thing to build and what is done to it; every number in SI and radians."""

    name: Annotated[str, Field(min_length=1, description="what outputs call it")]
    source: Annotated[str, Field(description="where its values come from")]
    pattern: Pattern
    vein: Vein
    membrane: Membrane
    hinge: Hinge
    tendon: Tendon
    guard: Guard
    protocol: Protocol

    @field_validator("name")
    @classmethod
    def _names_a_folder(cls, name: str) -> str:
        if re.search(r"[/\\\x00-\x1f\x7f]", name) or not name.strip(" ."):
            raise InputError(f"need a name that a folder can have, without slashes, got {as_written(name)}")
        return name

    @model_validator(mode="after")
    def _fits_together(self) -> Design:
        apart, width = float(vein_gaps(self.fan, np.ones(1))[0]), _ring_chord(self.fan)
        margin = self.membrane.margin
        for key, value, bound, unit, fault in (
            ("vein.diameter", self.vein.diameter, apart, SMALL_LENGTH, "the veins overlap at the ring fold"),
            ("membrane.margin", margin, width, LENGTH, "the margin is wider than the panel at the ring fold"),
        ):
            if not value < bound:
                raise InputError(
                    f"{key}: {fault}: need < {show_quantity(bound, unit)}, from vein to vein,"
                    f" got {show_quantity(value, unit)}"
                )
        for end, length in (("proximal", self.pattern.proximal_length), ("distal", self.pattern.distal_length)):
            attachment = getattr(self.tendon, f"{end}_attachment")
            if attachment > length:
                raise InputError(
                    f"tendon.{end}_attachment: lies beyond the bar: need <= pattern.{end}_length,"
                    f" {show_quantity(length, LENGTH)}, got {show_quantity(attachment, LENGTH)}"
                )
        for key, rows in (("proximal_rows", self.membrane.proximal_rows), ("distal_rows", self.membrane.distal_rows)):
            if list(rows) != sorted({row for row in rows if 0 < row < 1}):
                raise InputError(f"membrane.{key}: need rising shares between 0 and 1, got {list(rows)}")
        if not -self.hinge.fold_limit <= self.protocol.initial_overbend <= self.hinge.overbend:
            raise InputError(
                f"protocol.initial_overbend: need >= {show_quantity(-self.hinge.fold_limit, ANGLE)} (-hinge.fold_limit)"
                f" and <= {show_quantity(self.hinge.overbend, ANGLE)} (hinge.overbend),"
                f" got {show_quantity(self.protocol.initial_overbend, ANGLE)}"
            )
        return self

    @property
    def fan(self) -> EarwigFan:
        """The crease pattern's construction."""
        chosen = self.pattern
        return EarwigFan(
            proximal_length=chosen.proximal_length,
            distal_length=chosen.distal_length,
            hub_radius=chosen.hub_radius,
            sector_angle=chosen.sector_angle,
            units=chosen.units,
            tangent=chosen.tangent,
        )

    @property
    def hash(self) -> str:
        """Sixteen hexadecimal digits that name the values, whatever the design is called."""
        values = self.model_dump(mode="json", exclude={"name", "source"})
        return hashlib.sha256(json.dumps(values, sort_keys=True).encode()).hexdigest()[:16]


def design_warnings(design: Design) -> list[str]:
    """What a person should know of a design that is valid all the same, one sentence each."""
    shares = np.linspace(0, 1, 1001)
    overlapping = shares[vein_gaps(design.fan, shares) < design.vein.diameter]
    if not len(overlapping):
        return []
    distance = float(overlapping[-1]) * design.pattern.proximal_length
    return [
        f"neighbouring veins of {_readable(design.vein.diameter)} overlap within {_readable(distance)} of the hub,"
        " which the simulation allows: a part to print needs thinner veins or a larger hub"
    ]


def _readable(length: float) -> str:
    unit, factor = reading_unit("m", length)
    return f"{factor * length:.4g} {unit}"


def _ring_chord(fan: EarwigFan) -> float:
    first, second = ring_vertices(fan)[:2]
    return math.dist(first, second)
