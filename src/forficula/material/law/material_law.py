"""The law of a material: engineering stress as a function of strain, strain rate and strain history."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Annotated

from forficula.displayed import Displayed
from forficula.errors import InputError
from forficula.material.law.drift import Drift
from forficula.material.law.law_keys import law_unit, show_range, show_value
from forficula.material.law.maxwell_element import MaxwellElement
from forficula.material.law.softening import OgdenRoxburgh, Triple, pulls
from forficula.material.law.tendon_law import TendonLaw
from forficula.quantities import Unit, show_quantity
from forficula.serial import Written

_LENGTH = Unit(display="cm", si="m", example="6 cm")
_AREA = Unit(display="mm^2", si="m^2", example="5 mm^2")


@dataclass(frozen=True, kw_only=True)
class MaxwellBranch:
    """A spring and a damper in series, whose stress decays with a relaxation time.

    Attributes:
        modulus: Pa, > 0.
        time: relaxation time, s, > 0.

    Raises:
        InputError: a number that is not > 0 and finite.
    """

    modulus: float
    time: float

    def __post_init__(self) -> None:
        for name, unit in (("modulus", "Pa"), ("time", "s")):
            value = getattr(self, name)
            if not (math.isfinite(value) and value > 0):
                raise InputError(f"branches.{name}: need a finite number > 0, got {value:g} {unit}")


@dataclass(frozen=True, kw_only=True)
class Bounds:
    """Bounds of a value.

    Attributes:
        key: key of the value in a law file, such as "modulus.linear" or "branches.0.time".
        low: lower bound in SI.
        high: upper bound in SI.
    """

    key: str
    low: float
    high: float


@dataclass(frozen=True, kw_only=True)
class Unknown:
    """A section of a law that no source gives, and the reason or what is known instead."""

    key: str
    why: str


@dataclass(frozen=True, kw_only=True)
class LawFact:
    """A fact about a material in addition to its law, as text with units, with its source."""

    what: str
    value: str
    source: Annotated[str, Written.NEVER]


@dataclass(frozen=True, kw_only=True)
class MaterialLaw(Displayed):
    """Engineering stress (force per initial area) as a function of strain (extension per resting length).

    The stress is the sum of three terms, the last two at any strain. A spring has the stress E1 x + E2 x^2 + E3 x^3
    for x > 0 and 0 when slack, where x is the strain minus the set. A damper has
    eta1 e' + eta2 e' abs(e') + eta3 e'^3 (Kelvin and Voigt; for the nonlinear form see MuJoCo 4's tendon damping).
    Maxwell branches form a generalised Maxwell or Zener model. The set is initially the residual strain, and creeps so
    that x never exceeds the yield strain (ideal plasticity). None means that a value is absent; `require` reports why.

    Attributes:
        name: name of the material.
        source: source of the numbers.
        moduli: E1, E2, E3, Pa; the spring must pull at every strain.
        viscosity: eta1 in Pa s, eta2 in Pa s^2, eta3 in Pa s^3, each >= 0.
        branches: Maxwell branches.
        yield_strain: yield strain of the spring, > 0; None if the spring never yields.
        residual_strain: initial set, >= 0.
        softening: softening below the largest strain reached so far; None without softening.
        largest_strain: largest strain of the measurements.
        lowest_strain_rate: lowest strain rate of the measurements, 1/s.
        highest_strain_rate: highest strain rate of the measurements, 1/s.
        stiffness_drift: relative drift of every stress over the cycles; None if it is not known.
        residual_strain_drift: drift of the residual strain over the cycles, a difference; None if it is not known.
        ranges: ranges of values for which a source gives no single value.
        intervals: 95 % confidence intervals of fitted values.
        unknown: absent sections, with the reason.
        facts: further facts from the sources.
        no_tendon: reason why no tendon can be made of the material; empty if one can.

    Raises:
        InputError: a number out of these bounds or not finite.
    """

    name: str
    source: str = ""
    moduli: Triple | None = None
    viscosity: Triple | None = None
    branches: tuple[MaxwellBranch, ...] = ()
    yield_strain: float | None = None
    residual_strain: float = 0.0
    softening: OgdenRoxburgh | None = None
    largest_strain: float | None = None
    lowest_strain_rate: float | None = None
    highest_strain_rate: float | None = None
    stiffness_drift: Drift | None = None
    residual_strain_drift: Drift | None = None
    ranges: tuple[Bounds, ...] = ()
    intervals: tuple[Bounds, ...] = ()
    unknown: tuple[Unknown, ...] = ()
    facts: tuple[LawFact, ...] = ()
    no_tendon: str = ""

    def __repr__(self) -> str:
        """Name and values with units; absent values and facts are left out."""
        values = {
            f"{section}.{term}": value
            for section, triple in (("modulus", self.moduli), ("viscosity", self.viscosity))
            for term, value in zip(("linear", "quadratic", "cubic"), triple or (), strict=False)
            if value
        }
        for number, branch in enumerate(self.branches):
            values |= {f"branches.{number}.modulus": branch.modulus, f"branches.{number}.time": branch.time}
        for key in ("yield_strain", "residual_strain", "largest_strain"):
            if value := getattr(self, key):
                values[key] = value
        text = ", ".join(f"{key} {show_value(key, value)}" for key, value in values.items())
        return f"<MaterialLaw {self.name}: {text or self.no_tendon or 'no values'}>"

    def __post_init__(self) -> None:
        for section, values in (("modulus", self.moduli), ("viscosity", self.viscosity)):
            for term, value in zip(("linear", "quadratic", "cubic"), values or (), strict=False):
                may_be_negative = (section, term) == ("modulus", "quadratic")
                if not (math.isfinite(value) and (value >= 0 or may_be_negative)):
                    raise InputError(f"{section}.{term}: {_rule(not may_be_negative)}, got {value:g}")
        if self.moduli is not None and not pulls(*self.moduli):
            raise InputError(
                "modulus.quadratic: need >= 0 or > -2 sqrt(linear cubic), or the material would push at some strain,"
                f" got {show_quantity(self.moduli[1], law_unit('modulus.quadratic'))}"
            )
        for name in ("yield_strain", "largest_strain", "lowest_strain_rate", "highest_strain_rate"):
            value = getattr(self, name)
            if value is not None and not (math.isfinite(value) and value > 0):
                kind = "strain" if name.endswith("strain") else "rate"
                raise InputError(f"{name}: need a finite {kind} > 0, got {value:g}")
        check_rates(self.lowest_strain_rate, self.highest_strain_rate)
        if not (math.isfinite(self.residual_strain) and self.residual_strain >= 0):
            raise InputError(f"residual_strain: need a finite strain >= 0, got {self.residual_strain:g}")
        if self.stiffness_drift is not None and not self.stiffness_drift.relative:
            raise InputError("drift.stiffness: need a drift that is relative")
        if self.residual_strain_drift is not None and self.residual_strain_drift.relative:
            raise InputError("drift.residual_strain: need a drift that is a difference")


def check_rates(lowest: float | None, highest: float | None) -> None:
    """Refuse a range of strain rates, 1/s, whose highest rate is below the lowest; each may be unknown.

    Raises:
        InputError: the highest rate is below the lowest.
    """
    if lowest is not None and highest is not None and lowest > highest:
        raise InputError(f"lowest_strain_rate: need <= highest_strain_rate, {highest:g} 1/s, got {lowest:g} 1/s")


def _rule(bounded: bool) -> str:
    return "need a finite number >= 0" if bounded else "need a finite number"


def require(law: MaterialLaw, section: str) -> None:
    """Check that a section of a law is present.

    Args:
        law: law of a material.
        section: "modulus", "viscosity", "branches", "yield_strain", "softening" or "largest_strain".

    Raises:
        InputError: the section is absent; the message gives the known range, or the reason.
    """
    sections = {
        "modulus": law.moduli,
        "viscosity": law.viscosity,
        "branches": law.branches,
        "yield_strain": law.yield_strain,
        "softening": law.softening,
        "largest_strain": law.largest_strain,
    }
    if section not in sections:
        raise InputError(f"{section}: is not a section of a material law; need {', '.join(sections)}")
    for bounds in law.ranges:
        if sections[section] is None and (bounds.key == section or bounds.key.startswith(f"{section}.")):
            raise InputError(
                f"{law.name}: {bounds.key}: known only as a range, {show_range(bounds.key, bounds.low, bounds.high)};"
                " choose a value in it"
            )
    for entry in law.unknown:
        if not sections[section] and entry.key == section:
            raise InputError(f"{law.name}: {section}: is unknown: {entry.why}")
    if sections[section] is None:
        raise InputError(f"{law.name}: {section}: is not given by its source, {law.source or 'which is not named'}")


def known_moduli(law: MaterialLaw) -> Triple:
    """Return the moduli of a law, Pa.

    Raises:
        InputError: the moduli are absent; see `require`.
    """
    require(law, "modulus")
    return law.moduli or (0.0, 0.0, 0.0)


def with_linear_modulus(law: MaterialLaw, linear_modulus: float) -> MaterialLaw:
    """Set the modulus of a material for which only a range is known.

    Args:
        law: law with a range of the linear modulus.
        linear_modulus: value within the range, Pa.

    Returns:
        A linear law with that modulus.

    Raises:
        InputError: the law has no such range, or the value is outside.
    """
    key = "modulus.linear"
    bounds = next((entry for entry in law.ranges if entry.key == key), None)
    if bounds is None:
        raise InputError(f"{law.name}: {key}: has no range to choose from")
    if not bounds.low <= linear_modulus <= bounds.high:
        got = show_quantity(linear_modulus, law_unit(key))
        raise InputError(f"{law.name}: {key}: need a value in {show_range(key, bounds.low, bounds.high)}, got {got}")
    return replace(law, moduli=(linear_modulus, 0.0, 0.0))


def scaled(law: MaterialLaw, *, length: float, area: float) -> TendonLaw:
    """Compute the law of a tendon from that of its material: k = E A / L, and 1 / L for each further power of strain.

    Args:
        law: law of the material.
        length: unstretched length, m, > 0.
        area: cross-section, m^2, > 0.

    Returns:
        The law of the tendon. Its resting length is `length` increased by the residual strain. It has no damping if the
        viscosity of the material is absent.

    Raises:
        InputError: a length or area that is not > 0, an absent modulus, or a material that is not for tendons.
    """
    if law.no_tendon:
        raise InputError(f"{law.name}: no tendon can be made of it: {law.no_tendon}")
    if not (math.isfinite(length) and length > 0):
        raise InputError(
            "length: need a resting length > 0, because strain is extension per resting length,"
            f" got {show_quantity(length, _LENGTH)}"
        )
    if not (math.isfinite(area) and area > 0):
        raise InputError(f"area: need a cross-section > 0, got {show_quantity(area, _AREA)}")
    return TendonLaw(
        rest_length=length * (1 + law.residual_strain),
        stiffness=_by_length(known_moduli(law), length, area),
        damping=None if law.viscosity is None else _by_length(law.viscosity, length, area),
        branches=tuple(
            MaxwellElement(stiffness=branch.modulus * area / length, time=branch.time) for branch in law.branches
        ),
        yield_extension=None if law.yield_strain is None else law.yield_strain * length,
    )


def area_for(law: MaterialLaw, *, length: float, stiffness: float) -> float:
    """Compute the cross-section of a tendon with a given stiffness at small extension, A = k L / E1, m^2.

    Args:
        law: law of the material.
        length: unstretched length, m, > 0.
        stiffness: N/m, > 0.

    Raises:
        InputError: the errors of `scaled`, a stiffness that is not > 0, or a law without a linear term.
    """
    unit_area = scaled(law, length=length, area=1.0)
    if not (math.isfinite(stiffness) and stiffness > 0):
        raise InputError(f"stiffness: need > 0, got {stiffness:g} N/m")
    if unit_area.stiffness[0] == 0:
        raise InputError(f"{law.name}: modulus.linear: need > 0 to size a tendon by its stiffness, got 0")
    return stiffness / unit_area.stiffness[0]


def _by_length(terms: Triple, length: float, area: float) -> Triple:
    first, second, third = terms
    return first * area / length, second * area / length**2, third * area / length**3
