"""Straps as which tendons are made: their width for the stiffness of the design."""

from __future__ import annotations

from dataclasses import dataclass

from forficula.design import Design, MakeSection
from forficula.errors import InputError
from forficula.make.stock import stock_of
from forficula.material.law.law_file import load_law, named_laws
from forficula.material.law.material_law import MaterialLaw, area_for, scaled
from forficula.quantities import show_value
from forficula.structure import Tendon

# material of straps if a design names none
USUAL_MATERIAL = "tpu-95a"
_WIDEST = 100.0  # [chosen] largest width of a strap in lengths; a larger one suggests a wrong unit of the thickness


@dataclass(frozen=True, kw_only=True)
class Strap:
    """A tendon as made: one strap, or two equal ones that share its pull.

    Attributes:
        width: width of one strap, m.
        thickness: thickness of one strap, m.
        count: number of straps.
        rest_length: between its pegs without pull, m.
        material: name.
        area: total cross-section, m^2.
        density: density of the material, kg/m^3; None if its sources give none.
    """

    width: float
    thickness: float
    count: int
    rest_length: float
    material: str
    area: float
    density: float | None

    @property
    def mass(self) -> float | None:
        """Mass of all straps between their pegs, kg; None if the density is unknown."""
        return None if self.density is None else self.density * self.area * self.rest_length


def strap_of(design: Design, tendon: Tendon) -> Strap:
    """Return the strap of a tendon, with the width that gives its stiffness at small extension.

    The area is A = k L / E1, with the tendon's stiffness k and resting length L (without residual strain) and the
    linear modulus E1 of the strap's material: `make.strap_material`, or else the material of the tendon's law, or else
    tpu-95a. With the tendon's own law this is the design's own area. Nonlinear terms of the laws are not compared.

    Args:
        design: in SI, with or without a section on how its parts are made.
        tendon: tendon of its structure.

    Raises:
        InputError: a resting length of 0, a stiffness of 0, a material that no tendon can be made of, or a strap more
            than a hundred times as wide as long.

    Example:
        >>> from forficula.design import load_design
        >>> from forficula.structure import structure_of
        >>> wing = load_design("binder2025")
        >>> strap = strap_of(wing, structure_of(wing).tendons[0])
        >>> strap.material, strap.count, round(1e6 * strap.area, 2), round(1e3 * strap.width, 2)
        ('tpu-95a', 2, 7.32, 3.66)
    """
    make = design.make or MakeSection()
    law = _material(make, tendon)
    try:
        area = area_for(law, length=tendon.gauge_length, stiffness=tendon.law.stiffness[0])
    except InputError as error:
        raise InputError(f"{tendon.key or tendon.name}: cannot be made as a strap: {error}") from None
    width = area / (make.straps * make.strap_thickness)
    if not width <= _WIDEST * tendon.gauge_length:
        raise InputError(
            f"make.strap_thickness: makes {tendon.key or tendon.name} a strap {show_value(width, 'm')} wide and"
            f" {show_value(tendon.gauge_length, 'm')} long; need more, got {show_value(make.strap_thickness, 'm')}"
        )
    return Strap(
        width=width,
        thickness=make.strap_thickness,
        count=make.straps,
        rest_length=tendon.gauge_length,
        material=law.name or "the tendon's own law",
        area=area,
        density=_density(law),
    )


def _material(make: MakeSection, tendon: Tendon) -> MaterialLaw:
    """Return the material law of a tendon's straps."""
    if make.strap_material is not None:
        law = load_law(make.strap_material)
        try:
            scaled(law, length=1.0, area=1.0)
        except InputError as error:
            raise InputError(f"make.strap_material: no strap can be made of it: {error}") from None
        return law
    if tendon.material is not None:
        return tendon.material
    return load_law(USUAL_MATERIAL)


def _density(law: MaterialLaw) -> float | None:
    """Return the density of the material, kg/m^3. Laws in designs lack the facts of their sources."""
    return stock_of(law.name if law.name in named_laws() and not law.facts else law).density
