"""Nouns of drives, and their strengths with units: torques, forces and rest angles."""

from __future__ import annotations

from forficula.quantities import show_value
from forficula.structure import Drive, Structure, drive_unit


def acting(structure: Structure) -> str:
    """Return "torques" if all motors of a structure are torques, otherwise "drives"."""
    return "torques" if all(motor.kind == "torque" for motor in structure.motors) else "drives"


def drive_text(structure: Structure, drive: Drive, value: float) -> str:
    """Return the strength of a drive with its unit."""
    return show_value(value, drive_unit(structure, drive))
