"""The law of a tendon's material in a design: stress against strain, its rate and its past."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from forficula.design.part import Part, quantity
from forficula.errors import InputError
from forficula.material.law.drift import Drift
from forficula.material.law.law_cycle import drifts_of
from forficula.material.law.law_keys import law_unit, show_value
from forficula.material.law.material_law import MaterialLaw, MaxwellBranch, check_rates
from forficula.material.law.softening import OgdenRoxburgh, pulls
from forficula.quantities import Unit

AREA = Unit(display="mm^2", si="m^2", example="12.5 mm^2")


class LawBranch(Part):
    """A Maxwell branch: a spring and a damper in series."""

    modulus: float = quantity(law_unit("branches.0.modulus"), "modulus of its spring", above=0)
    time: float = quantity(law_unit("branches.0.time"), "relaxation time", above=0)


class LawSoftening(Part):
    """Softening after the largest strain seen (Ogden and Roxburgh 1999)."""

    r: Annotated[float, Field(strict=True, ge=1, description="the largest share that is lost is 1/r")]
    m: float = quantity(law_unit("softening.m"), "energy scale", at_least=0)
    beta: Annotated[float, Field(strict=True, ge=0, description="share of the largest energy in the scale")] = 0.0

    @model_validator(mode="after")
    def _has_a_scale(self) -> LawSoftening:
        if self.m == self.beta == 0:
            raise InputError("need m or beta > 0, got 0 for both")
        return self


Number = Annotated[float, Field(strict=True)]
Whole = Annotated[int, Field(strict=True, ge=1)]


class LawDrift(Part):
    """A change over the cycles of a test; see `Drift`."""

    kind: Annotated[Literal["none", "logarithm", "plateau"], Field(description="its course over the cycles")]
    rate: Annotated[Number, Field(description="of the change")] = 0.0
    interval: Annotated[tuple[Number, Number], Field(description="of the rate, 95 % confidence")] = (0.0, 0.0)
    cycles: Annotated[Number, Field(description="of the plateau")] = 0.0
    seen: Annotated[tuple[Whole, Whole], Field(description="first and last cycle of the data")]

    @model_validator(mode="after")
    def _is_a_drift(self) -> LawDrift:
        self.drift(relative=True)
        return self

    def drift(self, *, relative: bool) -> Drift:
        """The same as the material's drift."""
        return Drift(
            kind=self.kind,
            rate=self.rate,
            interval=self.interval,
            cycles=self.cycles,
            relative=relative,
            seen=self.seen,
        )


class Law(Part):
    """The law of the tendon's material by unit length and area; see `MaterialLaw`."""

    name: Annotated[str, Field(description="of the material")] = ""
    linear_modulus: float = quantity(law_unit("modulus.linear"), "stress by strain", at_least=0)
    quadratic_modulus: float = quantity(law_unit("modulus.quadratic"), "stress by strain squared", default=0.0)
    cubic_modulus: float = quantity(law_unit("modulus.cubic"), "stress by strain cubed", default=0.0, at_least=0)
    linear_viscosity: float | None = quantity(
        law_unit("viscosity.linear"), "stress by strain rate", default=None, at_least=0
    )
    quadratic_viscosity: float | None = quantity(
        law_unit("viscosity.quadratic"), "stress by strain rate squared", default=None, at_least=0
    )
    cubic_viscosity: float | None = quantity(
        law_unit("viscosity.cubic"), "stress by strain rate cubed", default=None, at_least=0
    )
    branches: Annotated[tuple[LawBranch, ...], Field(description="Maxwell branches")] = ()
    yield_strain: float | None = quantity(
        law_unit("yield_strain"), "beyond it the resting length grows", default=None, above=0
    )
    residual_strain: float = quantity(
        law_unit("residual_strain"), "by which the resting length has grown before", default=0.0, at_least=0
    )
    largest_strain: float | None = quantity(
        law_unit("largest_strain"), "up to which it was measured", default=None, above=0
    )
    lowest_strain_rate: float | None = quantity(
        law_unit("lowest_strain_rate"), "from which on it was measured", default=None, above=0
    )
    highest_strain_rate: float | None = quantity(
        law_unit("highest_strain_rate"), "up to which it was measured", default=None, above=0
    )
    softening: Annotated[LawSoftening | None, Field(description="softening after the largest strain seen")] = None

    stiffness_drift: Annotated[LawDrift | None, Field(description="of ln of every stress over the cycles")] = None
    residual_strain_drift: Annotated[LawDrift | None, Field(description="of the residual strain over the cycles")] = (
        None
    )

    @model_validator(mode="after")
    def _pulls(self) -> Law:
        if not pulls(self.linear_modulus, self.quadratic_modulus, self.cubic_modulus):
            raise InputError(
                "tendon.law.quadratic_modulus: need >= 0 or > -2 sqrt(linear_modulus cubic_modulus), or the tendon"
                f" would push at some strain, got {show_value('modulus.quadratic', self.quadratic_modulus)}"
            )
        return self

    @model_validator(mode="after")
    def _has_a_range(self) -> Law:
        check_rates(self.lowest_strain_rate, self.highest_strain_rate)
        return self

    @property
    def material(self) -> MaterialLaw:
        """The same as the material's law."""
        viscosity = (self.linear_viscosity, self.quadratic_viscosity, self.cubic_viscosity)
        soft, stiffness, longer = self.softening, self.stiffness_drift, self.residual_strain_drift
        return MaterialLaw(
            name=self.name,
            moduli=(self.linear_modulus, self.quadratic_modulus, self.cubic_modulus),
            viscosity=None if viscosity == (None, None, None) else _filled(viscosity),
            branches=tuple(MaxwellBranch(modulus=branch.modulus, time=branch.time) for branch in self.branches),
            yield_strain=self.yield_strain,
            residual_strain=self.residual_strain,
            softening=None if soft is None else OgdenRoxburgh(r=soft.r, m=soft.m, beta=soft.beta),
            largest_strain=self.largest_strain,
            lowest_strain_rate=self.lowest_strain_rate,
            highest_strain_rate=self.highest_strain_rate,
            stiffness_drift=None if stiffness is None else stiffness.drift(relative=True),
            residual_strain_drift=None if longer is None else longer.drift(relative=False),
        )


def law_fields(material: MaterialLaw) -> dict[str, object]:
    """The fields of `Law` that a material has, SI; what is absent is left out, the moduli, too."""
    values: dict[str, object] = {"name": material.name}
    for section, terms in (("modulus", material.moduli), ("viscosity", material.viscosity)):
        if terms is not None:
            values |= dict(zip((f"{term}_{section}" for term in ("linear", "quadratic", "cubic")), terms, strict=True))
    values["branches"] = [{"modulus": branch.modulus, "time": branch.time} for branch in material.branches]
    numbers = ("yield_strain", "residual_strain", "largest_strain", "lowest_strain_rate", "highest_strain_rate")
    values |= {name: getattr(material, name) for name in numbers if getattr(material, name) is not None}
    if material.softening is not None:
        values["softening"] = {name: getattr(material.softening, name) for name in ("r", "m", "beta")}
    for name, drift in drifts_of(material).items():
        values[f"{name}_drift"] = {key: getattr(drift, key) for key in LawDrift.model_fields}
    return values


def _filled(terms: tuple[float | None, float | None, float | None]) -> tuple[float, float, float]:
    first, second, third = (term or 0.0 for term in terms)
    return first, second, third
