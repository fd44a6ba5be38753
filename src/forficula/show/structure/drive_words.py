"""What drives are called, and the unit of how strong they are: torques, forces and rest angles."""

from __future__ import annotations

from forficula.quantities import show_value
from forficula.structure import Drive, Structure, drive_unit


def acting(structure: Structure) -> str:
    """What motors of a structure set in one word: "torques" where all set these."""
    return "torques" if all(motor.kind == "torque" for motor in structure.motors) else "drives"


def drive_text(structure: Structure, drive: Drive, value: float) -> str:
    """How strong a drive is, in its unit."""
    return show_value(value, drive_unit(structure, drive))
