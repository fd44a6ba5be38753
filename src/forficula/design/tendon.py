"""Sections of a design for tendons, and the tendon law that results."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Annotated, Any, ClassVar, Self

from pydantic import Field, model_validator

from forficula.design.law import AREA, LawSection
from forficula.design.section import DENSITY, LENGTH, STIFFNESS, TENDON_DAMPING, Section, field_quantity, quantity
from forficula.errors import InputError
from forficula.material.law.material_law import scaled
from forficula.material.law.tendon_law import TendonLaw
from forficula.quantities import show_quantity

# by keys that follow from a law, the keys to set instead
_FOLLOWING = {
    "stiffness": "tendon.area or tendon.law.linear_modulus",
    "damping": "tendon.area or tendon.law.linear_viscosity",
}
# largest relative difference between a given value and the one that follows from a law: rounding of text
_ROUNDING = 1e-9


class ElasticTendon(Section):
    """A pull-only tendon: a spring with a damper, or the law of a material."""

    about: ClassVar[str] = "A pull-only tendon: a spring with a damper, or the law of a material"

    # keys that a tendon without a law must have
    needed: ClassVar[tuple[str, ...]] = ("stiffness", "damping")
    natural: ClassVar[tuple[str, ...]] = ("law",)
    later: ClassVar[tuple[str, ...]] = ("pushes_when_slack",)

    stiffness: float | None = quantity(
        STIFFNESS, "force per extension beyond the resting length", default=None, at_least=0
    )
    rest_length: float = quantity(LENGTH, "length below which the tendon is slack", at_least=0)
    damping: float | None = quantity(
        TENDON_DAMPING,
        "viscous damping while the tendon is taut; spring and damper together never push",
        default=None,
        at_least=0,
    )
    pushes_when_slack: Annotated[
        bool,
        Field(
            strict=True,
            description="whether damping and Maxwell branches also act, and push, while the tendon is slack, as in a"
            " strut",
        ),
    ] = False
    area: float | None = quantity(AREA, "cross-section; needed with a law or a density", default=None, above=0)
    law: Annotated[
        LawSection | None,
        Field(
            description="material or law file that replaces stiffness and damping; needs an area",
            examples=["tpu-82a"],
        ),
    ] = None

    @property
    def weighs(self) -> bool:
        """Whether the tendon has a mass."""
        return False

    @model_validator(mode="after")
    def _spring_or_law(self) -> Self:
        """Drop stiffness and damping where they agree with a law that is also given."""
        if self.law is None:
            if self.area is not None and not self.weighs:
                raise InputError(
                    "area: needs tendon.law, which gives force per area; also give a law, or tendon.stiffness instead"
                )
            for key in self.needed:
                if getattr(self, key) is None:
                    raise InputError(f"{key}: is missing")
            return self
        if self.area is None:
            raise InputError(f'area: is missing; tendon.law gives force per area, so give one such as "{AREA.example}"')
        if self.rest_length == 0:
            raise InputError(
                "rest_length: need > 0 with tendon.law, because strain is extension per resting length, got 0 cm"
            )
        for key, follows in small_extension(self).items():
            value, reader = getattr(self, key), field_quantity(type(self).model_fields[key])
            if value is not None and reader is not None and not math.isclose(value, follows, rel_tol=_ROUNDING):
                raise InputError(
                    f"{key}: follows from tendon.law, {show_quantity(follows, reader.unit)}; set {_FOLLOWING[key]}"
                    f" instead, got {show_quantity(value, reader.unit)}"
                )
        return self.model_copy(update=dict.fromkeys(_FOLLOWING))

    def hash_values(self) -> dict[str, Any]:
        """Return the values that enter the hash, with the stiffness and the damping that follow from a law."""
        return super().hash_values() | small_extension(self)


class TendonSection(ElasticTendon):
    """The elastic patch across each distal hinge."""

    about: ClassVar[str] = "The elastic patch across each distal hinge"

    heading: ClassVar[str] = "Tendons"
    later: ClassVar[tuple[str, ...]] = (
        *ElasticTendon.later,
        *("density", "proximal_offset", "distal_offset", "proximal_aside", "distal_aside"),
    )

    density: float = quantity(
        DENSITY,
        "density; the mass, from area and resting length, is divided equally between the two ends",
        default=0.0,
        at_least=0,
    )
    proximal_attachment: float = quantity(LENGTH, "distance from the ring fold to the end on the proximal bar", above=0)
    distal_attachment: float = quantity(LENGTH, "distance from the ring fold to the end on the distal bar", above=0)
    proximal_offset: float = quantity(
        LENGTH,
        "distance of the end on the proximal bar from the bar's axis, normal to the sheet, positive towards the"
        " overbend side",
        default=0.0,
    )
    distal_offset: float = quantity(LENGTH, "the same for the end on the distal bar", default=0.0)
    proximal_aside: float = quantity(
        LENGTH,
        "distance of the end on the proximal bar from the bar's axis, in the sheet, positive towards the next vein",
        default=0.0,
    )
    distal_aside: float = quantity(LENGTH, "the same for the end on the distal bar", default=0.0)

    @property
    def weighs(self) -> bool:
        """Whether the tendon has a mass."""
        return self.density > 0

    @model_validator(mode="after")
    def _of_a_volume(self) -> Self:
        if self.weighs and not self.area:
            raise InputError("area: is missing; tendon.density needs the volume, an area by the resting length")
        return self

    @property
    def mass(self) -> float:
        """Mass of the tendon, in the design's unit."""
        return self.density * (self.area or 0.0) * self.rest_length


def check_on_bars(key: str, tendon: TendonSection, proximal_length: float, distal_length: float) -> None:
    """Refuse a tendon that does not end on its bars.

    Args:
        key: key of the tendon, such as "tendon.1".
        tendon: tendon across a distal hinge.
        proximal_length: length of the bar up to the hinge, m.
        distal_length: length of the bar beyond the hinge, m.

    Raises:
        InputError: an end beyond its bar.
    """
    for end, length in (("proximal", proximal_length), ("distal", distal_length)):
        attachment, bar = getattr(tendon, f"{end}_attachment"), show_quantity(length, LENGTH)
        if attachment > length:
            raise InputError(
                f"{key}.{end}_attachment: lies beyond the bar: need <= pattern.{end}_length,"
                f" {bar}, got {show_quantity(attachment, LENGTH)}"
            )
        for direction in ("offset", "aside"):
            if abs(value := getattr(tendon, f"{end}_{direction}")) > length:
                raise InputError(
                    f"{key}.{end}_{direction}: need >= -{bar} and <= {bar}, pattern.{end}_length,"
                    f" got {show_quantity(value, LENGTH)}"
                )


def tendon_law(tendon: ElasticTendon) -> TendonLaw:
    """Return the law of a tendon in the units of its section; linear with linear damping where no material is named.

    Raises:
        InputError: the law gives a number that is not finite.
    """
    if tendon.law is not None and tendon.area is not None:
        law = scaled(tendon.law.material, length=tendon.rest_length, area=tendon.area)
        return replace(law, pushes=tendon.pushes_when_slack)
    return TendonLaw(
        rest_length=tendon.rest_length,
        stiffness=(tendon.stiffness or 0.0, 0.0, 0.0),
        damping=(tendon.damping or 0.0, 0.0, 0.0),
        pushes=tendon.pushes_when_slack,
    )


def small_extension(tendon: ElasticTendon) -> dict[str, float]:
    """Compute stiffness and damping of a tendon at small extension: with a law, E1 A / L and eta1 A / L."""
    if tendon.law is None:
        return {"stiffness": tendon.stiffness or 0.0, "damping": tendon.damping or 0.0}
    law = tendon_law(tendon)
    return {"stiffness": law.stiffness[0], "damping": 0.0 if law.damping is None else law.damping[0]}
