"""The law of a tendon's material in a design: stress against strain, its rate and its past."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field, ValidationInfo, model_validator

from forficula.design.section import Section, field_quantity, quantity
from forficula.errors import InputError
from forficula.material.law.drift import Drift
from forficula.material.law.law_cycle import drifts_of
from forficula.material.law.law_file import load_law
from forficula.material.law.law_keys import law_unit, show_range, show_value
from forficula.material.law.material_law import MaterialLaw, MaxwellBranch, check_rates, chosen, require
from forficula.material.law.softening import OgdenRoxburgh, pulls
from forficula.quantities import Unit, as_written

AREA = Unit(display="mm^2", si="m^2", example="12.5 mm^2")
# of a law file, what is chosen where a material has only a range
_CHOSEN = "modulus.linear"


class LawBranch(Section):
    """A Maxwell branch: a spring and a damper in series."""

    about: ClassVar[str] = "A Maxwell branch: a spring and a damper in series"

    modulus: float = quantity(law_unit("branches.0.modulus"), "modulus of its spring", above=0)
    time: float = quantity(law_unit("branches.0.time"), "relaxation time", above=0)


class LawSoftening(Section):
    """Softening after the largest strain seen (Ogden and Roxburgh 1999)."""

    about: ClassVar[str] = "Softening after the largest strain seen (Ogden and Roxburgh 1999)"

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


class LawDrift(Section):
    """A change over the cycles of a test; see `Drift`."""

    about: ClassVar[str] = "A change over the cycles of a test; see `Drift`"

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


class LawSection(Section):
    """The law of the tendon's material by unit length and area; see `MaterialLaw`.

    Read from values by key, from the name of a material or the path of a law file, or from values with either of these
    under `based_on`.
    """

    about: ClassVar[str] = "The law of the tendon's material by unit length and area; see `MaterialLaw`"

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

    @model_validator(mode="before")
    @classmethod
    def _read_by_name(cls, given: object, info: ValidationInfo) -> object:
        if isinstance(given, str | MaterialLaw):
            given = {"based_on": given}
        if not isinstance(given, dict) or not isinstance(named := given.get("based_on"), str | MaterialLaw):
            return given
        material, si = tendon_material(named), bool(info.context and info.context.get("si"))
        own = {key: value for key, value in given.items() if key != "based_on"}
        _check_choice(material, own.get("linear_modulus"), si=si)
        return law_tables(material, si=si) | own

    @model_validator(mode="after")
    def _pulls(self) -> LawSection:
        if not pulls(self.linear_modulus, self.quadratic_modulus, self.cubic_modulus):
            raise InputError(
                "quadratic_modulus: need >= 0 or > -2 sqrt(linear_modulus cubic_modulus), or the tendon"
                f" would push at some strain, got {show_value('modulus.quadratic', self.quadratic_modulus)}"
            )
        return self

    @model_validator(mode="after")
    def _has_a_range(self) -> LawSection:
        check_rates(self.lowest_strain_rate, self.highest_strain_rate)
        return self

    def hash_values(self) -> dict[str, Any]:
        """The values but for the name of the material."""
        return {key: value for key, value in super().hash_values().items() if key != "name"}

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


def tendon_material(named: str | MaterialLaw) -> MaterialLaw:
    """The material of a name or of the path of a law file, if a tendon can be made of it; a law as it is.

    Raises:
        InputError: there is no such material, or it is for no tendon.
    """
    if isinstance(named, str) and named.strip().lower() == "none":
        raise InputError(
            f'need a material, a law file, or "none" for no law, got {as_written(named)}; did you mean "none"?'
        )
    material = named if isinstance(named, MaterialLaw) else load_law(named)
    if material.no_tendon:
        raise InputError(f"{material.name}: no tendon can be made of it: {material.no_tendon}")
    if material.moduli is None and not any(bounds.key == _CHOSEN for bounds in material.ranges):
        require(material, "modulus")
    return material


def law_tables(material: MaterialLaw, *, si: bool) -> dict[str, Any]:
    """The values of a material by the keys of `LawSection`; what is absent is left out, the moduli, too.

    Args:
        material: whose law it is.
        si: whether numbers are SI floats instead of text.
    """
    values: dict[str, Any] = {"name": material.name}
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
    if si:
        return values
    # a law that needs a choice has no modulus yet
    text = LawSection.model_validate({"linear_modulus": 1.0} | values, context={"si": True}).as_tables()
    return {name: value for name, value in text.items() if name in values}


def _check_choice(material: MaterialLaw, given: object, *, si: bool) -> None:
    """Refuse a linear modulus that is missing where a material has only a range, and one that is not in it."""
    if material.moduli is not None:
        return
    key = "linear_modulus"
    if given is None:
        bounds = next(bounds for bounds in material.ranges if bounds.key == _CHOSEN)
        raise InputError(
            f"{key}: of {material.name} only a range is known, {show_range(bounds.key, bounds.low, bounds.high)};"
            f' choose a value in it, as in tendon.law = {{based_on = "{material.name}", {key} = "1 MPa"}} or'
            f' --set tendon.law.{key}="1 MPa"'
        )
    reader = field_quantity(LawSection.model_fields[key])
    try:
        value = reader.read(given, in_si=si) if reader else None
    except InputError:  # the field itself says what is wrong with it
        return
    try:
        chosen(material, float(value or 0.0))
    except InputError as error:
        raise InputError(f"{key}: {error}") from None


def _filled(terms: tuple[float | None, float | None, float | None]) -> tuple[float, float, float]:
    first, second, third = (term or 0.0 for term in terms)
    return first, second, third
