"""Sections of a fan's design, except for tendons and protocol."""

from __future__ import annotations

import math
from typing import Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from forficula.design.section import (
    ANGLE,
    DENSITY,
    HINGE_DAMPING,
    HINGE_STIFFNESS,
    INERTIA,
    LENGTH,
    MASS,
    MODULUS,
    SHORT_TIME,
    SMALL_LENGTH,
    TORQUE,
    Section,
    quantity,
)
from forficula.errors import InputError
from forficula.quantities import show_quantity

Share = Annotated[float, Field(strict=True)]
# one number for each vein or panel, as a multiple of the common value
VeinShares = tuple[Annotated[float, Field(strict=True, gt=0)], ...] | None

# m, smaller than atoms and larger than planets: within this range every power of a length that a unit has is a float
_SMALLEST, _LARGEST = 1e-12, 1e12
MOST_UNITS = 10_000
MOST_ROWS = 1000  # rows of the mesh: with 100 times as many the engine runs out of memory


class FanPatternSection(Section):
    """The crease pattern of the sheet."""

    about: ClassVar[str] = "The crease pattern of the sheet"

    later: ClassVar[tuple[str, ...]] = (
        *("ring_folds", "proximal_shares", "distal_shares", "hub_shares", "sector_shares"),
    )

    kind: Annotated[Literal["earwig-fan"], Field(description="family of crease patterns")]
    proximal_length: float = quantity(LENGTH, "length of a vein from the hub to the ring fold", above=0)
    distal_length: float = quantity(LENGTH, "length of a vein beyond the ring fold", above=0)
    hub_radius: float = quantity(LENGTH, "radius of the circle that the veins are tangent to", at_least=0)
    sector_angle: float = quantity(ANGLE, "angle between neighbouring veins", above=0, below=math.pi)
    units: Annotated[int, Field(strict=True, ge=1, le=MOST_UNITS, description="number of fan units of two panels each")]
    tangent: Annotated[
        Literal["left", "right"],
        Field(description="side of the hub that the proximal veins are tangent to, looking outwards from the hub"),
    ]
    ring_folds: Annotated[
        int,
        Field(
            strict=True,
            ge=1,
            le=2,
            description="number of ring folds across every vein; with two, each folds by half of the angle, and the"
            " gusset between them lets thick layers fold around each other",
        ),
    ] = 1
    pitch: float | None = quantity(
        SMALL_LENGTH,
        "distance between folded layers, with two ring folds; if not given, the larger of a vein's diameter and twice"
        " the thickness of a panel (contact.thickness)",
        default=None,
        above=0,
    )
    proximal_shares: Annotated[
        VeinShares,
        Field(
            min_length=1,
            description="length of every vein up to the ring fold, divided by proximal_length; all 1 if not given",
            examples=[[1.0, 0.95, 0.9]],
        ),
    ] = None
    distal_shares: Annotated[
        VeinShares,
        Field(
            min_length=1,
            description="length of every vein beyond the ring fold, divided by distal_length; all 1 if not given",
            examples=[[1.0, 0.95, 0.9]],
        ),
    ] = None
    hub_shares: Annotated[
        VeinShares,
        Field(
            min_length=1,
            description="radius of the circle that every vein is tangent to, divided by hub_radius; all 1 if not given",
            examples=[[1.0, 0.95, 0.9]],
        ),
    ] = None
    sector_shares: Annotated[
        VeinShares,
        Field(
            min_length=1,
            description="angle from every vein to the next one, divided by sector_angle, one number fewer than veins;"
            " all 1 if not given",
            examples=[[1.1, 0.9]],
        ),
    ] = None

    @model_validator(mode="after")
    def _of_a_size(self) -> FanPatternSection:
        for key, length, least in (
            ("proximal_length", self.proximal_length, _SMALLEST),
            ("distal_length", self.distal_length, _SMALLEST),
            ("hub_radius", self.hub_radius, 0.0),
        ):
            if not least <= length <= _LARGEST:
                raise InputError(
                    f"pattern.{key}: need >= {show_quantity(least, LENGTH)} and <= {show_quantity(_LARGEST, LENGTH)},"
                    f" got {show_quantity(length, LENGTH)}"
                )
        if self.pitch is not None and self.ring_folds == 1:
            raise InputError(
                f"pattern.pitch: is for two ring folds (pattern.ring_folds = 2), got"
                f" {show_quantity(self.pitch, SMALL_LENGTH)} with one"
            )
        return self


class VeinSection(Section):
    """The bars of the veins."""

    about: ClassVar[str] = "The bars of the veins"

    heading: ClassVar[str] = "Veins"
    later: ClassVar[tuple[str, ...]] = ("added_mass",)

    diameter: float = quantity(SMALL_LENGTH, "diameter of the bars", above=0)
    density: float = quantity(DENSITY, "density of the bars", above=0)
    added_mass: float = quantity(
        MASS,
        "mass of each hinge at the ring fold, half of it at the end of each of its two bars",
        default=0.0,
        at_least=0,
    )


class MembraneSection(Section):
    """The sheet between the bars, which resists stretching but not bending."""

    about: ClassVar[str] = "The sheet between the bars, which resists stretching but not bending"

    later: ClassVar[tuple[str, ...]] = ("density",)
    natural: ClassVar[tuple[str, ...]] = ("damping",)

    youngs_modulus: float = quantity(MODULUS, "Young's modulus", above=0)
    thickness: float = quantity(SMALL_LENGTH, "thickness", above=0)
    density: float = quantity(DENSITY, "density; the mass is lumped onto the veins", default=0.0, at_least=0)
    poisson_ratio: Annotated[float, Field(strict=True, ge=0, lt=0.5, description="Poisson's ratio")]
    damping: float = quantity(SHORT_TIME, "relaxation time of its Kelvin-Voigt damping", at_least=0)
    margin: float = quantity(LENGTH, "width of the strip of each panel that is glued to its vein", above=0)
    margin_limit: Annotated[
        float,
        Field(
            strict=True,
            gt=0,
            lt=1,
            description="largest width of the margin as a share of the panel's width; matters near the hub",
        ),
    ]
    proximal_rows: Annotated[
        tuple[Share, ...],
        Field(
            min_length=1,
            max_length=MOST_ROWS,
            description="rows of the mesh as shares of the proximal length; the membrane begins at the first row",
        ),
    ]
    distal_rows: Annotated[
        tuple[Share, ...],
        Field(
            max_length=MOST_ROWS,
            description="rows of the membrane's mesh between ring fold and tip, as shares of the distal length",
        ),
    ]


class HingeSection(Section):
    """Joints of the veins at the base and at the ring fold."""

    about: ClassVar[str] = "Joints of the veins at the base and at the ring fold"

    heading: ClassVar[str] = "Hinges"

    overbend: float = quantity(
        ANGLE,
        "largest angle by which a distal hinge bends past straight, away from folding",
        at_least=0,
        below=math.pi / 2,
    )
    fold_limit: float = quantity(ANGLE, "largest fold angle of a distal hinge", above=0, at_most=math.pi)
    turn_limit: float = quantity(
        ANGLE, "largest turn of a vein about its own axis, in the sense of folding", above=0, at_most=math.pi
    )
    turn_back: float = quantity(ANGLE, "largest turn of a vein in the opposite sense", at_least=0, at_most=math.pi)
    damping: float = quantity(HINGE_DAMPING, "viscous damping of every hinge", at_least=0)
    friction: float = quantity(
        TORQUE, "dry friction of every hinge: the torque needed to turn it slowly", default=0.0, at_least=0
    )
    armature: float = quantity(INERTIA, "rotor inertia of a motor, added to every hinge", default=0.0, at_least=0)


class CouplingSection(Section):
    """Coupling of the turns of neighbouring veins at the base."""

    about: ClassVar[str] = "Coupling of the turns of neighbouring veins at the base"

    heading: ClassVar[str] = "Basal vein coupling"

    stiffness: float | Literal["rigid"] = quantity(
        HINGE_STIFFNESS,
        'stiffness of the spring between the turns of neighbouring veins; "rigid": all veins turn by the same angle',
        at_least=0,
        words=("rigid",),
    )


class GuardSection(Section):
    """Unstressed length limits between neighbouring tips."""

    about: ClassVar[str] = "Unstressed length limits between neighbouring tips"

    heading: ClassVar[str] = "Guard tendons"

    stretch: Annotated[
        float,
        Field(
            strict=True,
            ge=1,
            description="largest distance between neighbouring tips, divided by their distance when flat",
        ),
    ]
