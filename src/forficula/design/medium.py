"""The fluid around a structure: air, water, or none."""

from __future__ import annotations

from typing import ClassVar

from forficula.design.section import DENSITY, Section, quantity
from forficula.errors import InputError
from forficula.quantities import Unit, show_quantity

VISCOSITY = Unit(display="Pa s", si="Pa s", example="1.8e-5 Pa s")
# largest neglected buoyancy, as a share of the weight
_BUOYANCY = 0.01


class MediumSection(Section):
    """The fluid around the structure; a vacuum without density and viscosity."""

    about: ClassVar[str] = "The fluid around the structure; a vacuum without density and viscosity"

    heading: ClassVar[str] = "Air or water around it"
    natural: ClassVar[tuple[str, ...]] = ("viscosity",)

    density: float = quantity(
        DENSITY, "density: air 1.2, water 1000 kg/m^3", default=0.0, at_least=0, examples=["1.2 kg/m^3", "1000 kg/m^3"]
    )
    viscosity: float = quantity(
        VISCOSITY,
        "viscosity: air 1.8e-5, water 1e-3 Pa s",
        default=0.0,
        at_least=0,
        examples=["1.8e-5 Pa s", "1e-3 Pa s"],
    )


def check_medium(medium: MediumSection | None, gravity: float, lightest: float, key: str) -> None:
    """Refuse a medium with considerable buoyancy, which the model ignores.

    Args:
        medium: fluid around the structure.
        gravity: acceleration, m/s^2.
        lightest: density of the lightest part, kg/m^3.
        key: key of that density.

    Raises:
        InputError: the buoyancy exceeds a hundredth of the weight.
    """
    if medium is None or not gravity or medium.density <= _BUOYANCY * lightest:
        return
    raise InputError(
        f"medium.density: buoyancy is not modelled: need <= {show_quantity(_BUOYANCY * lightest, DENSITY)},"
        f" a hundredth of {key}, or protocol.gravity = 0, got {show_quantity(medium.density, DENSITY)}"
    )
