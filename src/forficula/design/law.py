"""The law of a tendon's material in a design: stress as a function of strain, strain rate and strain history."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field, ValidationInfo, model_validator

from forficula.design.section import Section, field_quantity, quantity
from forficula.errors import InputError
from forficula.material.law.drift import Drift
from forficula.material.law.law_cycle import drifts_of
from forficula.material.law.law_file import load_law
from forficula.material.law.law_keys import law_unit, show_range, show_value
from forficula.material.law.material_law import MaterialLaw, MaxwellBranch, check_rates, require, with_linear_modulus
from forficula.material.law.softening import OgdenRoxburgh, pulls
from forficula.quantities import Unit, as_written

AREA = Unit(display="mm^2", si="m^2", example="12.5 mm^2")
# key of a law file whose value the design must choose where the material has only a range
_CHOSEN = "modulus.linear"


class LawBranch(Section):
    """A Maxwell branch: a spring and a damper in series."""

    about: ClassVar[str] = "A Maxwell branch: a spring and a damper in series"

    modulus: float = quantity(law_unit("branches.0.modulus"), "modulus of its spring", above=0)
    time: float = quantity(law_unit("branches.0.time"), "relaxation time", above=0)


class LawSoftening(Section):
    """Softening below the largest strain reached so far (Ogden and Roxburgh 1999)."""

    about: ClassVar[str] = "Softening below the largest strain reached so far (Ogden and Roxburgh 1999)"

    r: Annotated[float, Field(strict=True, ge=1, description="1/r is the largest share of the stress that is lost")]
    m: float = quantity(law_unit("softening.m"), "constant part of the energy scale of softening", at_least=0)
    beta: Annotated[
        float,
        Field(
            strict=True, ge=0, description="share of the largest stored energy that is added to m, for the energy scale"
        ),
    ] = 0.0

    @model_validator(mode="after")
    def _has_a_scale(self) -> LawSoftening:
        if self.m == self.beta == 0:
            raise InputError("need m or beta > 0, got 0 for both")
        return self


Number = Annotated[float, Field(strict=True)]
Whole = Annotated[int, Field(strict=True, ge=1)]


class LawDrift(Section):
    """A change of a material over the cycles of a test; see `Drift`."""

    about: ClassVar[str] = "A change of a material over the cycles of a test; see `Drift`"

    kind: Annotated[
        Literal["none", "logarithm", "plateau"], Field(description="how the value changes from cycle to cycle")
    ]
    rate: Annotated[
        Number,
        Field(description="rate a of the change in cycle N: a ln N, or a (1 - exp(-(N - 1) / cycles)) for a plateau"),
    ] = 0.0
    interval: Annotated[tuple[Number, Number], Field(description="95 % confidence interval of the rate")] = (0.0, 0.0)
    cycles: Annotated[Number, Field(description="decay constant of the approach to a plateau, in cycles")] = 0.0
    seen: Annotated[tuple[Whole, Whole], Field(description="first and last cycle of the data")]

    @model_validator(mode="after")
    def _is_a_drift(self) -> LawDrift:
        self.drift(relative=True)
        return self

    def drift(self, *, relative: bool) -> Drift:
        """Return the drift as the material package has it."""
        return Drift(
            kind=self.kind,
            rate=self.rate,
            interval=self.interval,
            cycles=self.cycles,
            relative=relative,
            seen=self.seen,
        )


class LawSection(Section):
    """The law of the tendon's material, stress against strain; see `MaterialLaw`.

    It is read from values by key, from the name of a material or the path of a law file, or from values with either of
    these under `based_on`.
    """

    about: ClassVar[str] = "The law of the tendon's material, stress against strain; see `MaterialLaw`"

    name: Annotated[str, Field(description="name of the material")] = ""
    linear_modulus: float = quantity(law_unit("modulus.linear"), "stress per strain", at_least=0)
    quadratic_modulus: float = quantity(law_unit("modulus.quadratic"), "stress per strain squared", default=0.0)
    cubic_modulus: float = quantity(law_unit("modulus.cubic"), "stress per strain cubed", default=0.0, at_least=0)
    linear_viscosity: float | None = quantity(
        law_unit("viscosity.linear"), "stress per strain rate", default=None, at_least=0
    )
    quadratic_viscosity: float | None = quantity(
        law_unit("viscosity.quadratic"), "stress per strain rate squared", default=None, at_least=0
    )
    cubic_viscosity: float | None = quantity(
        law_unit("viscosity.cubic"), "stress per strain rate cubed", default=None, at_least=0
    )
    branches: Annotated[tuple[LawBranch, ...], Field(description="Maxwell branches")] = ()
    yield_strain: float | None = quantity(
        law_unit("yield_strain"), "strain beyond which the resting length grows", default=None, above=0
    )
    residual_strain: float = quantity(
        law_unit("residual_strain"), "strain by which the resting length has already grown", default=0.0, at_least=0
    )
    largest_strain: float | None = quantity(
        law_unit("largest_strain"), "largest strain of the measurements", default=None, above=0
    )
    lowest_strain_rate: float | None = quantity(
        law_unit("lowest_strain_rate"), "lowest strain rate of the measurements", default=None, above=0
    )
    highest_strain_rate: float | None = quantity(
        law_unit("highest_strain_rate"), "highest strain rate of the measurements", default=None, above=0
    )
    softening: Annotated[
        LawSoftening | None, Field(description="softening below the largest strain reached so far")
    ] = None

    stiffness_drift: Annotated[
        LawDrift | None, Field(description="change of the logarithm of every stress over the cycles")
    ] = None
    residual_strain_drift: Annotated[
        LawDrift | None, Field(description="change of the residual strain over the cycles")
    ] = None

    @model_validator(mode="before")
    @classmethod
    def _read_by_name(cls, value: object, info: ValidationInfo) -> object:
        if isinstance(value, str | MaterialLaw):
            value = {"based_on": value}
        if not isinstance(value, dict) or not isinstance(named := value.get("based_on"), str | MaterialLaw):
            return value
        material, si = tendon_material(named), bool(info.context and info.context.get("si"))
        values = {key: value for key, value in value.items() if key != "based_on"}
        _check_choice(material, values.get("linear_modulus"), si=si)
        return law_tables(material, si=si) | values

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
        """Return all values except the name of the material."""
        return {key: value for key, value in super().hash_values().items() if key != "name"}

    @property
    def material(self) -> MaterialLaw:
        """The law as the material package has it."""
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
    """Return the material law for a name or the path of a law file; return a law unchanged.

    Raises:
        InputError: there is no such material, or no tendon can be made of it.
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
    """Return the values of a material law by the keys of `LawSection`; absent values, also moduli, are left out.

    Args:
        material: the law.
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
    # a law whose modulus the design must choose has no modulus yet
    text = LawSection.model_validate({"linear_modulus": 1.0} | values, context={"si": True}).as_tables()
    return {name: value for name, value in text.items() if name in values}


def _check_choice(material: MaterialLaw, number: object, *, si: bool) -> None:
    """Refuse a linear modulus that is missing, or outside the range, where a material has only a range."""
    if material.moduli is not None:
        return
    key = "linear_modulus"
    if number is None:
        bounds = next(bounds for bounds in material.ranges if bounds.key == _CHOSEN)
        raise InputError(
            f"{key}: of {material.name} only a range is known, {show_range(bounds.key, bounds.low, bounds.high)};"
            f' choose a value in it, as in tendon.law = {{based_on = "{material.name}", {key} = "1 MPa"}} or'
            f' --set tendon.law.{key}="1 MPa"'
        )
    reader = field_quantity(LawSection.model_fields[key])
    try:
        value = reader.read(number, in_si=si) if reader else None
    except InputError:  # validation of the field reports the error
        return
    try:
        with_linear_modulus(material, float(value or 0.0))
    except InputError as error:
        raise InputError(f"{key}: {error}") from None


def _filled(terms: tuple[float | None, float | None, float | None]) -> tuple[float, float, float]:
    first, second, third = (term or 0.0 for term in terms)
    return first, second, third
