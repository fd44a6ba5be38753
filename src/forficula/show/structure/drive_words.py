"""What drives are called, and the unit of how strong they are: torques, forces and rest angles."""

from __future__ import annotations

from forficula.quantities import show_value
from forficula.structure import Drive, Structure

_UNITS = {"torque": "N m", "force": "N", "displacement": "m", "rest-angle": "rad"}


def acting(structure: Structure) -> str:
    """What motors of a structure set in one word: "torques" where all set these."""
    return "torques" if all(motor.kind == "torque" for motor in structure.motors) else "drives"


def drive_unit(structure: Structure, drive: Drive) -> str:
    """The SI unit of how strong a drive is."""
    kinds = [motor.kind for motor, share in zip(structure.motors, drive.shares, strict=True) if share]
    # one of several kinds is as strong as its first
    return _UNITS[kinds[0]] if kinds else "N m"


def drive_text(structure: Structure, drive: Drive, value: float) -> str:
    """How strong a drive is, in its unit."""
    return show_value(value, drive_unit(structure, drive))
