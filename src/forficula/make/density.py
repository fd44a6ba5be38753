"""How dense a material is, by what its sources say."""

from __future__ import annotations

from forficula.design.part import DENSITY
from forficula.errors import InputError
from forficula.material.law.material_law import MaterialLaw
from forficula.quantities import parse_quantity


def density_of(law: MaterialLaw) -> float | None:
    """The density of a material, kg/m^3, from the fact "density" of its law file; the middle where that is a range.

    Args:
        law: of the material.

    Returns:
        None where its sources give none.

    Raises:
        InputError: the fact is neither a value with a unit nor a range such as "1.25 to 1.29 g/cm^3".

    Example:
        >>> from forficula.material import load_law
        >>> density_of(load_law("petg"))
        1270.0
    """
    fact = next((fact for fact in law.facts if fact.what == "density"), None)
    if fact is None:
        return None
    low, _, high = fact.value.partition(" to ")
    unit = (high or low).strip().partition(" ")[2]
    ends = [low.strip() if " " in low.strip() else f"{low} {unit}", high] if high else [low]
    try:
        values = [parse_quantity(end, DENSITY) for end in ends]
    except InputError as error:
        raise InputError(f"{law.name}: facts, density: {error}") from None
    return sum(values) / len(values)
