"""Sections of a joint's design, except for bars and protocol."""

from __future__ import annotations

import math
from typing import Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from forficula.design.section import ANGLE, HINGE_DAMPING, INERTIA, LENGTH, TORQUE, Section, quantity
from forficula.design.tendon import TendonSection
from forficula.errors import InputError
from forficula.pattern import CreasePattern, strip_pattern
from forficula.quantities import show_quantity

# m, smaller than atoms and larger than planets: within this range every power of a length that a unit has is a float
_SMALLEST, _LARGEST = 1e-12, 1e12
# least angle between a bar and the crease
_LEAST_SECTOR = math.radians(1)


class JointPattern(Section):
    """Two bars in the flat sheet, and the crease on which their hinge lies."""

    about: ClassVar[str] = "Two bars in the flat sheet, and the crease on which their hinge lies"

    kind: Annotated[Literal["joint"], Field(description="family of crease patterns")]
    proximal_length: float = quantity(LENGTH, "length of the bar that is held, up to the hinge", above=0)
    distal_length: float = quantity(LENGTH, "length of the bar beyond the hinge", above=0)
    proximal_sector: float = quantity(
        ANGLE,
        "angle between the proximal bar and the half of the crease on its left, looking outwards",
        at_least=_LEAST_SECTOR,
        at_most=math.pi - _LEAST_SECTOR,
        examples=["87 deg"],
    )
    distal_sector: float = quantity(
        ANGLE,
        "angle between the distal bar and the same half of the crease; both angles add up to 180 deg if the bars are in"
        " line",
        at_least=_LEAST_SECTOR,
        at_most=math.pi - _LEAST_SECTOR,
        examples=["107 deg"],
    )
    sense: Annotated[
        Literal["mountain", "valley"],
        Field(description="sense in which the crease folds, seen from above: mountain: the distal bar moves down"),
    ]
    width: float = quantity(
        LENGTH, "width of the sheet along the crease; the sheet is drawn and cut, but carries no load"
    )

    @model_validator(mode="after")
    def _of_a_size(self) -> JointPattern:
        for key in ("proximal_length", "distal_length", "width"):
            if not _SMALLEST <= (length := getattr(self, key)) <= _LARGEST:
                raise InputError(
                    f"pattern.{key}: need >= {show_quantity(_SMALLEST, LENGTH)} and <="
                    f" {show_quantity(_LARGEST, LENGTH)}, got {show_quantity(length, LENGTH)}"
                )
        bend = self.proximal_sector + self.distal_sector - math.pi
        if not abs(bend) < math.pi / 2:
            raise InputError(
                "pattern.distal_sector: need > 90 deg and < 270 deg together with pattern.proximal_sector, or the bars"
                f" lie beside one another in the flat sheet, got {show_quantity(bend + math.pi, ANGLE)}"
            )
        return self

    @property
    def sheet(self) -> CreasePattern:
        """The crease pattern."""
        drawn: CreasePattern = self.once("sheet", self._drawn)
        return drawn

    def _drawn(self) -> CreasePattern:
        return strip_pattern(
            self.proximal_length,
            self.distal_length,
            self.proximal_sector,
            self.distal_sector,
            self.width,
            valley=self.sense == "valley",
        )


class JointHinge(Section):
    """The hinge between the two bars."""

    about: ClassVar[str] = "The hinge between the two bars"

    heading: ClassVar[str] = "Hinge"

    overbend: float = quantity(
        ANGLE,
        "largest angle by which the hinge bends past straight, away from folding",
        at_least=0,
        below=math.pi / 2,
    )
    fold_limit: float = quantity(ANGLE, "largest fold angle of the hinge", above=0, at_most=math.pi)
    damping: float = quantity(HINGE_DAMPING, "viscous damping of the hinge", at_least=0)
    friction: float = quantity(
        TORQUE, "dry friction of the hinge: the torque needed to turn it slowly", default=0.0, at_least=0
    )
    armature: float = quantity(INERTIA, "rotor inertia of a motor, added to the hinge", default=0.0, at_least=0)


class JointTendon(TendonSection):
    """The elastic tendon across the hinge."""

    about: ClassVar[str] = "The elastic tendon across the hinge"

    heading: ClassVar[str] = "Tendon"

    proximal_attachment: float = quantity(LENGTH, "distance from the hinge to the end on the proximal bar", above=0)
    distal_attachment: float = quantity(LENGTH, "distance from the hinge to the end on the distal bar", above=0)
    proximal_aside: float = quantity(
        LENGTH,
        "distance of the end on the proximal bar from the bar's axis, in the sheet, positive to the left looking"
        " outwards",
        default=0.0,
    )
