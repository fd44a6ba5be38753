"""What a structure moves in: air, water, or nothing."""

from __future__ import annotations

from typing import ClassVar

from forficula.design.section import DENSITY, Section, quantity
from forficula.errors import InputError
from forficula.quantities import Unit, show_quantity

VISCOSITY = Unit(display="Pa s", si="Pa s", example="1.8e-5 Pa s")
# of what weighs, which nobody would measure; more would float
_BORNE = 0.01


class MediumSection(Section):
    """What a structure moves in; without density and viscosity it is empty space."""

    about: ClassVar[str] = "What a structure moves in; without density and viscosity it is empty space"

    heading: ClassVar[str] = "Air or water around it"
    natural: ClassVar[tuple[str, ...]] = ("viscosity",)

    density: float = quantity(
        DENSITY, "air 1.2, water 1000 kg/m^3", default=0.0, at_least=0, examples=["1.2 kg/m^3", "1000 kg/m^3"]
    )
    viscosity: float = quantity(
        VISCOSITY, "air 1.8e-5, water 1e-3 Pa s", default=0.0, at_least=0, examples=["1.8e-5 Pa s", "1e-3 Pa s"]
    )


def check_medium(medium: MediumSection | None, gravity: float, lightest: float, key: str) -> None:
    """Refuse a medium that would bear what weighs: that is no part of the model.

    Args:
        medium: what surrounds the structure.
        gravity: m/s^2.
        lightest: density of the lightest part, kg/m^3.
        key: of that.

    Raises:
        InputError: it bears more than a hundredth of the weight.
    """
    if medium is None or not gravity or medium.density <= _BORNE * lightest:
        return
    raise InputError(
        f"medium.density: what it bears of the weight is left out: need <= {show_quantity(_BORNE * lightest, DENSITY)},"
        f" a hundredth of {key}, or protocol.gravity = 0, got {show_quantity(medium.density, DENSITY)}"
    )
