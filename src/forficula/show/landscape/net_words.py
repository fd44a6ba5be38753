"""What figures and tables of a net's landscape share: units, and the words for what happens."""

from __future__ import annotations

from forficula.quantities import reading_unit
from forficula.statics.net_course import Course
from forficula.statics.net_state import Withstood
from forficula.structure import Structure, drive_unit, measure_of


def shown_value(value: float, unit: str, digits: int = 4) -> str:
    """Write an SI float in the unit in which it reads well, with a minus sign and not a hyphen."""
    name, factor = reading_unit(unit, abs(value)) if value else (unit.replace("rad", "deg"), 1.0)
    rounded = float(f"{factor * value:.{digits}g}")
    return f"{rounded:g} {name}".replace("-", "−").replace("m/s^2", "m/s²")


def shown_strength(structure: Structure, course: Course, size: float) -> str:
    """The size of a course's drive."""
    return shown_value(size, drive_unit(structure, course.drive))


def held_words(withstood: Withstood) -> str:
    """How much of a load a state withstands."""
    value = shown_value(withstood.value, withstood.unit, 3)
    return {"limit": f"to {value}", "bifurcation": f"to {value}, then sideways", "none": f"beyond {value}"}[
        withstood.kind
    ]


def course_words(structure: Structure, course: Course) -> str:
    """What a slowly growing drive does, in a phrase."""
    size = abs(course.drive.strength)
    snaps = [snap for snap in course.slow.snaps if snap.kind != "branch"]
    told = [f"snaps at {shown_strength(structure, course, snap.factor * size)}" for snap in snaps]
    if len(told) > 3:
        told = [*told[:2], f"{len(told) - 2} times more"]
    if course.largest_force is not None:
        told.append(f"takes {shown_value(course.largest_force, 'N', 3)}")
    return ", ".join(told) or "bends without a snap"


def reading_words(structure: Structure, name: str, readings: list[float]) -> str:
    """The readings of a measure, from the least to the largest."""
    measure = measure_of(structure, name)
    unit = "m" if measure is not None and measure.kind == "distance" else "rad"
    low, high = shown_value(min(readings), unit), shown_value(max(readings), unit)
    return low if low == high else f"{low.removesuffix(' deg')} to {high}"
