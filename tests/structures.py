"""Structures that no design file asks for, compiled."""

from collections.abc import Callable

import numpy as np

from forficula.design import FanDesign
from forficula.dynamics import Model, Record, compile_structure, design_in_model_units
from forficula.dynamics.engine.units import ModelUnits, model_units
from forficula.structure import GROUND, Structure
from forficula.structure.fans.vein import Vein

_SI = ModelUnits(length=1.0, mass=1.0, time=1.0)


def compiled(design: FanDesign, build: Callable[[FanDesign, ModelUnits], Structure]) -> Model:
    """Compile what a way of building makes of a design.

    Args:
        design: in SI.
        build: of a design that is in some units, and these units, which are those of the structure, too.
    """
    structure = build(design, _SI)
    units = model_units(structure)
    return compile_structure(design, structure, build(design_in_model_units(design, units), units), units)


def straight_vein(design: FanDesign) -> Vein:
    """A vein along x, its proximal bar fixed, that folds about y, in the units of its design."""
    ring = design.pattern.proximal_length
    return Vein(
        places=(np.zeros(3), np.array([ring, 0, 0]), np.array([ring + design.pattern.distal_length, 0, 0])),
        axes=(np.array([0.0, 1.0, 0.0]),),
        sense=1,
        fixed_base=True,
    )


def supports(structure: Structure) -> list[str]:
    """Names of the bodies that are held: those on the ground without a hinge."""
    hinged = {hinge.body for hinge in structure.hinges}
    bodies = enumerate(structure.bodies)
    return [body.name for number, body in bodies if body.parent == GROUND and number not in hinged]


def motor_work(record: Record, name: str) -> np.ndarray:
    """Work of a motor since the start, J, (time,)."""
    return record.series["motor_work"][:, [motor.name for motor in record.structure.motors].index(name)]
