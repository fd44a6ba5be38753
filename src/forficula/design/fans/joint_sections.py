"""Sections of a joint's design, but for its bars and its protocol."""

from __future__ import annotations

import math
from typing import Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from forficula.design.section import ANGLE, HINGE_DAMPING, INERTIA, LENGTH, TORQUE, Section, quantity
from forficula.design.tendon import TendonSection
from forficula.errors import InputError
from forficula.pattern import CreasePattern, strip_pattern
from forficula.quantities import show_quantity

# beyond atoms and worlds, m: within, every power that a unit has of a length is a float
_SMALLEST, _LARGEST = 1e-12, 1e12
# both bars and the crease are to be told apart
_LEAST_SECTOR = math.radians(1)


class JointPattern(Section):
    """Two bars in the flat sheet, and the crease that their hinge lies on."""

    about: ClassVar[str] = "Two bars in the flat sheet, and the crease that their hinge lies on"

    kind: Annotated[Literal["joint"], Field(description="the family of crease patterns")]
    proximal_length: float = quantity(LENGTH, "length of the bar that is held, up to the hinge", above=0)
    distal_length: float = quantity(LENGTH, "length of the bar beyond the hinge", above=0)
    proximal_sector: float = quantity(
        ANGLE,
        "angle between the proximal bar and the half of the crease on its left, seen outwards",
        at_least=_LEAST_SECTOR,
        at_most=math.pi - _LEAST_SECTOR,
        examples=["87 deg"],
    )
    distal_sector: float = quantity(
        ANGLE,
        "angle between the distal bar and the same half; 180 deg with the other where the bars are in line",
        at_least=_LEAST_SECTOR,
        at_most=math.pi - _LEAST_SECTOR,
        examples=["107 deg"],
    )
    sense: Annotated[
        Literal["mountain", "valley"],
        Field(description="how the crease folds, seen from above: the distal bar goes down, or up"),
    ]
    width: float = quantity(LENGTH, "width of the sheet along the crease, which is drawn and cut and bears nothing")

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
        ANGLE, "how far it bends past straight, away from folding", at_least=0, below=math.pi / 2
    )
    fold_limit: float = quantity(ANGLE, "how far it folds", above=0, at_most=math.pi)
    damping: float = quantity(HINGE_DAMPING, "its viscous damping", at_least=0)
    friction: float = quantity(
        TORQUE, "its dry friction: the torque that it takes to turn it slowly", default=0.0, at_least=0
    )
    armature: float = quantity(INERTIA, "inertia of a motor on it, added to it", default=0.0, at_least=0)


class JointTendon(TendonSection):
    """The elastic tendon across the hinge."""

    about: ClassVar[str] = "The elastic tendon across the hinge"

    heading: ClassVar[str] = "Tendon"

    proximal_attachment: float = quantity(LENGTH, "distance of its end on the proximal bar from the hinge", above=0)
    distal_attachment: float = quantity(LENGTH, "distance of its end on the distal bar from the hinge", above=0)
    proximal_aside: float = quantity(
        LENGTH, "how far its end on the proximal bar lies beside the bar's axis, on the left seen outwards", default=0.0
    )
