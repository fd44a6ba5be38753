"""Structures that no design file asks for, compiled."""

from collections.abc import Callable

from forficula.design import Design
from forficula.dynamics import Model, compile_structure, design_in_model_units
from forficula.dynamics.units import ModelUnits, model_units
from forficula.structure import Structure

_SI = ModelUnits(length=1.0, mass=1.0, time=1.0)


def compiled(design: Design, build: Callable[[Design, ModelUnits], Structure]) -> Model:
    """Compile what a way of building makes of a design.

    Args:
        design: in SI.
        build: of a design that is in some units, and these units, which are those of the structure, too.
    """
    structure = build(design, _SI)
    units = model_units(structure)
    return compile_structure(design, structure, build(design_in_model_units(design, units), units), units)
