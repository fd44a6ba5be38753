"""The sections of a design for tendons, and the law that they come to."""

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

# by what follows from a law, what to set instead
_FOLLOWING = {
    "stiffness": "tendon.area or tendon.law.linear_modulus",
    "damping": "tendon.area or tendon.law.linear_viscosity",
}
# what is given by hand is what follows, but for how it was written
_ROUNDING = 1e-9


class ElasticTendon(Section):
    """What pulls: a spring with a damper, or the law of a material."""

    about: ClassVar[str] = "What pulls: a spring with a damper, or the law of a material"

    # keys that one without a law must have
    needed: ClassVar[tuple[str, ...]] = ("stiffness", "damping")
    natural: ClassVar[tuple[str, ...]] = ("law",)
    later: ClassVar[tuple[str, ...]] = ("pushes_when_slack",)

    stiffness: float | None = quantity(
        STIFFNESS, "force by extension beyond the resting length", default=None, at_least=0
    )
    rest_length: float = quantity(LENGTH, "length below which it does not pull", at_least=0)
    damping: float | None = quantity(
        TENDON_DAMPING,
        "viscous damping while it is taut; spring and damper together never push",
        default=None,
        at_least=0,
    )
    pushes_when_slack: Annotated[
        bool,
        Field(
            strict=True,
            description="whether its damping and Maxwell branches act when it is slack, too, and push, as a strut's do",
        ),
    ] = False
    area: float | None = quantity(AREA, "cross-section; with a law or a density", default=None, above=0)
    law: Annotated[
        LawSection | None,
        Field(
            description="a material, or a law file, instead of stiffness and damping; with an area",
            examples=["tpu-82a"],
        ),
    ] = None

    @property
    def weighs(self) -> bool:
        """Whether it has a mass."""
        return False

    @model_validator(mode="after")
    def _spring_or_law(self) -> Self:
        """Keep the law alone where stiffness and damping are given, too, and agree with it."""
        if self.law is None:
            if self.area is not None and not self.weighs:
                raise InputError(
                    "area: needs tendon.law, which gives force by area; give a law, too, or tendon.stiffness instead"
                )
            for key in self.needed:
                if getattr(self, key) is None:
                    raise InputError(f"{key}: is missing")
            return self
        if self.area is None:
            raise InputError(f'area: is missing; tendon.law gives force by area, so give one such as "{AREA.example}"')
        if self.rest_length == 0:
            raise InputError(
                "rest_length: need > 0 with tendon.law, for strain is extension by resting length, got 0 cm"
            )
        for key, follows in small_extension(self).items():
            given, reader = getattr(self, key), field_quantity(type(self).model_fields[key])
            if given is not None and reader is not None and not math.isclose(given, follows, rel_tol=_ROUNDING):
                raise InputError(
                    f"{key}: follows from tendon.law, {show_quantity(follows, reader.unit)}; set {_FOLLOWING[key]}"
                    f" instead, got {show_quantity(given, reader.unit)}"
                )
        return self.model_copy(update=dict.fromkeys(_FOLLOWING))

    def hash_values(self) -> dict[str, Any]:
        """The values that tell it from others, with the stiffness and the damping that follow from a law."""
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
        "mass by volume; its ends carry that of its area and resting length by halves",
        default=0.0,
        at_least=0,
    )
    proximal_attachment: float = quantity(LENGTH, "distance of its end on the proximal bar from the ring fold", above=0)
    distal_attachment: float = quantity(LENGTH, "distance of its end on the distal bar from the ring fold", above=0)
    proximal_offset: float = quantity(
        LENGTH, "how far that end stands off the proximal bar's axis, towards the overbend side", default=0.0
    )
    distal_offset: float = quantity(LENGTH, "alike, of its end on the distal bar", default=0.0)
    proximal_aside: float = quantity(
        LENGTH, "how far its end on the proximal bar lies beside the bar's axis, towards the next vein", default=0.0
    )
    distal_aside: float = quantity(LENGTH, "alike, of its end on the distal bar", default=0.0)

    @property
    def weighs(self) -> bool:
        """Whether it has a mass."""
        return self.density > 0

    @model_validator(mode="after")
    def _of_a_volume(self) -> Self:
        if self.weighs and not self.area:
            raise InputError("area: is missing; tendon.density needs the volume, an area by the resting length")
        return self

    @property
    def mass(self) -> float:
        """Of all of it, in the design's unit."""
        return self.density * (self.area or 0.0) * self.rest_length


def check_on_bars(key: str, tendon: TendonSection, proximal_length: float, distal_length: float) -> None:
    """Refuse a tendon that does not end on its bars, which are so long, m.

    Args:
        key: of the tendon, such as "tendon.1".
        tendon: across a distal hinge.
        proximal_length: of the bar up to the hinge.
        distal_length: of that beyond it.

    Raises:
        InputError: which end, and what is allowed.
    """
    for end, length in (("proximal", proximal_length), ("distal", distal_length)):
        attachment, bar = getattr(tendon, f"{end}_attachment"), show_quantity(length, LENGTH)
        if attachment > length:
            raise InputError(
                f"{key}.{end}_attachment: lies beyond the bar: need <= pattern.{end}_length,"
                f" {bar}, got {show_quantity(attachment, LENGTH)}"
            )
        for way in ("offset", "aside"):
            if abs(value := getattr(tendon, f"{end}_{way}")) > length:
                raise InputError(
                    f"{key}.{end}_{way}: need >= -{bar} and <= {bar}, pattern.{end}_length,"
                    f" got {show_quantity(value, LENGTH)}"
                )


def tendon_law(tendon: ElasticTendon) -> TendonLaw:
    """The law of a tendon, in its units, whatever they are; linear, with linear damping, where it names no material.

    Raises:
        InputError: the law gives no number that can be computed with.
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
    """Stiffness and damping of a tendon where it is hardly stretched: with a law E1 A / L and eta1 A / L."""
    if tendon.law is None:
        return {"stiffness": tendon.stiffness or 0.0, "damping": tendon.damping or 0.0}
    law = tendon_law(tendon)
    return {"stiffness": law.stiffness[0], "damping": 0.0 if law.damping is None else law.damping[0]}
