"""Materials of parts: their values for calculations, each the least one that sources report."""

from __future__ import annotations

from dataclasses import dataclass

from forficula.errors import InputError
from forficula.material.law.law_file import load_law
from forficula.material.law.material_law import MaterialLaw
from forficula.quantities import Unit, parse_quantity

_STRESS = Unit(display="MPa", si="Pa", example="44 MPa")
_DENSITY = Unit(display="g/cm^3", si="kg/m^3", example="1.27 g/cm^3")


@dataclass(frozen=True, kw_only=True)
class Stock:
    """Material of a part.

    Attributes:
        name: name of the material.
        density: kg/m^3; None if its sources give none.
        youngs_modulus: least reported value, Pa; None if there is none.
        strength: least reported value in the plane of printed layers, Pa; None if there is none.
        strength_across: least reported value across printed layers, Pa; that in their plane if sources do not
            distinguish.
        source: source of these numbers.
        density_source: source of the density; "" without one.
    """

    name: str
    density: float | None
    youngs_modulus: float | None
    strength: float | None
    strength_across: float | None
    source: str
    density_source: str


def stock_of(material: str | MaterialLaw) -> Stock:
    """Return the values of a material for parts, by its name or its law.

    Raises:
        InputError: unknown material, or a fact that is neither a value with a unit nor a range.
    """
    law = load_law(material) if isinstance(material, str) else material
    density = fact_range(law, "density", _DENSITY)
    strength = fact_range(law, "strength in plane", _STRESS) or fact_range(law, "strength", _STRESS)
    across = fact_range(law, "strength across layers", _STRESS) or strength
    modulus = next((bounds.low for bounds in law.ranges if bounds.key == "modulus.linear"), None)
    if modulus is None and law.moduli is not None:
        modulus = law.moduli[0]
    facts = {fact.source: None for fact in law.facts}
    return Stock(
        name=law.name,
        density=None if density is None else sum(density) / 2,
        youngs_modulus=modulus,
        strength=None if strength is None else strength[0],
        strength_across=None if across is None else across[0],
        source="; ".join(facts) or law.source,
        density_source=next((fact.source for fact in law.facts if fact.what == "density"), ""),
    )


def fact_range(law: MaterialLaw, what: str, unit: Unit) -> tuple[float, float] | None:
    """Return the range of a number of a material according to its sources, SI; both ends are equal for a single value.

    Returns:
        None if the sources do not report it.

    Raises:
        InputError: the fact is neither a value with a unit nor a range such as "1.25 to 1.29 g/cm^3".

    >>> from forficula.material.law.law_file import load_law
    >>> fact_range(load_law("petg"), "density", Unit(display="g/cm^3", si="kg/m^3", example="1 g/cm^3"))
    (1250.0, 1290.0)
    """
    fact = next((fact for fact in law.facts if fact.what == what), None)
    if fact is None:
        return None
    low, _, high = fact.value.partition(" to ")
    high = high or low
    try:
        top = parse_quantity(high, unit)
        # a range has its unit once, at the end
        bottom = parse_quantity(low if " " in low.strip() else f"{low} {high.strip().partition(' ')[2]}", unit)
    except InputError as error:
        raise InputError(f"{law.name}: facts: {what}: {error}") from None
    return bottom, top
