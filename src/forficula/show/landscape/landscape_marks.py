"""Elements shared by landscape figures: marks of stable states, barriers, notes and names."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from numpy.typing import ArrayLike

from forficula.arrays import Array
from forficula.names import listed
from forficula.quantities import reading_unit
from forficula.show.style import BLACK, GREEN, in_column
from forficula.statics import EnergyLandscape, Rest
from forficula.statics.landscape import AT_START, LeastTorque
from forficula.statics.net.driven.net_course import Course
from forficula.statics.net.net_state import Withstood
from forficula.structure import (
    Measure,
    Structure,
    Transition,
    drive_of,
    drive_unit,
    measure_of,
    read_angles,
    springs_name,
)

_KINDS = {"stop": "s", "minimum": "o", "neutral": "o"}
_NAMES = {
    "stop": "stable: pressed onto a stop",
    "minimum": "stable: minimum",
    "neutral": "stable: range without torque",
}
_WIDE: dict[str, Any] = {"color": GREEN, "lw": 6, "alpha": 0.35, "solid_capstyle": "butt"}
_TOUCHES = 2  # points named in a sentence at which parts begin to touch
_FLAT = 1e-8  # rad; smaller angles are rounding
_ROUNDING = 1e-6  # share of a tendon's largest moment


def rounding_torque(landscape: EnergyLandscape) -> float:
    """Return the torque up to which a torque counts as rounding error, N m."""
    hinges = landscape.tendons if landscape.hinge is None else (landscape.hinge,)
    return _ROUNDING * max((float(np.abs(hinge.moment).max()) for hinge in hinges), default=0.0)


def rest_name(rest: Rest, between: str = " ") -> str:
    """Return the name of a state, with the earlier state that rests at the same angles, if any."""
    return (rest.name or AT_START) + (f"{between}(as {rest.same_as})" if rest.same_as else "")


def hinge_measure(structure: Structure, hinge: int) -> Measure:
    """Return the first measure that contains a hinge's angle; otherwise the measure of its role."""
    for measure in structure.measures:
        if hinge in measure.hinges:
            return measure
    role_measure = measure_of(structure, structure.hinges[hinge].role)
    assert role_measure is not None  # the hinge itself has the role
    return role_measure


def least_text(landscape: EnergyLandscape, course: LeastTorque, digits: int = 4) -> str:
    """Return the least slowly growing torque or force of a transition as text."""
    kind = "force" if course.unit == "N" else "torque"
    if course.unit not in ("N", "N m"):
        return "not computed"
    if course.least is None:
        return f"no slow {kind}"
    least = course.least
    if course.withstood is not None:
        return f"held up to {shown_value(course.withstood, course.unit, digits)}"
    if course.unit == "N m" and least <= rounding_torque(landscape):
        least = 0.0
    return f"{'≤ ' * course.smallest}{shown_value(least, course.unit, digits)}"


def torque_location(structure: Structure, transition: Transition) -> str:
    """Return where the torque of a transition acts, such as "on every distal hinge"."""
    drive = drive_of(structure, transition.drive)
    if drive.part:
        return f"on every {drive.part}"
    motors = [motor.name for motor, share in zip(structure.motors, drive.shares, strict=True) if share]
    return drive.where or f"on {', '.join(motors)}"


def show_angles(measure: Measure, angles: Array) -> str:
    """Return the reading of a measure at given angles (rad); its range if readings differ."""
    read = read_angles(measure, angles)
    low, high = show_angle(float(read.min())), show_angle(float(read.max()))
    return low if low == high else f"{low} to {high}"


def energy_storing_parts(structure: Structure) -> str:
    """Return the names of the parts that store energy, except membranes and guards."""
    parts = (
        ("tendons", bool(structure.tendons)),
        ("springs", any(hinge.stiffness for hinge in structure.hinges)),
        (springs_name(structure), bool(structure.springs)),
        ("couplings", any(not coupling.rigid for coupling in structure.couplings)),
        ("weight", bool(structure.gravity)),
    )
    return listed(name for name, exists in parts if exists)


def sheet_parts(structure: Structure) -> str:
    """Return the names of the parts that are stretched, except tendons; empty if there are none."""
    parts = (
        (f"membrane{'s' * (not structure.limits)}", bool(structure.membranes)),
        ("guards", bool(structure.limits)),
    )
    return listed(name for name, exists in parts if exists)


def mark_state(axes: Axes, kind: str, place: float, energy: float, range_x: ArrayLike, range_y: ArrayLike) -> None:
    """Mark a stable state by a point, or a range of states by a band along the curve."""
    if kind == "neutral":
        axes.plot(range_x, range_y, zorder=1, clip_on=False, **_WIDE)
    else:
        axes.plot(
            place, energy, _KINDS[kind], color="white", mec=BLACK, mew=1.0, ms=6, zorder=6, clip_on=False, ls="none"
        )


def state_handles(kinds: set[str]) -> list[Line2D]:
    """Return the legend's entries for kinds of stable states."""
    handles = []
    for kind in ("stop", "minimum", "neutral"):
        if kind not in kinds:
            continue
        if kind == "neutral":
            handles.append(Line2D([], [], label=_NAMES[kind], **_WIDE))
        else:
            handles.append(
                Line2D([], [], ls="none", marker=_KINDS[kind], color="white", mec=BLACK, ms=6, label=_NAMES[kind])
            )
    return handles


def mark_barrier(axes: Axes, place: float, height: float, text: str) -> None:
    """Draw an arrow from a zero line to the top of a barrier, with its height."""
    axes.axhline(0, color="0.6", lw=0.5, zorder=0)
    axes.annotate(
        "",
        xy=(place, height),
        xytext=(place, 0),
        arrowprops={"arrowstyle": "<->", "lw": 0.7, "shrinkA": 0, "shrinkB": 0},
    )
    words = text.replace(" ", "\n", 1) if in_column(axes) else text
    axes.text(place, -0.12 * height, words, ha="center", va="top", fontsize=7)


def write_note(axes: Axes, place: tuple[float, float], text: str, width: int = 44) -> None:
    """Write a sentence at a position in shares of the axes."""
    axes.text(
        *place,
        textwrap.fill(text, width // 2 if in_column(axes) else width),
        transform=axes.transAxes,
        ha="center",
        va="center",
        fontsize=7,
        color="0.25",
    )


def show_angle(angle: float) -> str:
    """Write an angle (rad) in degrees, with a minus sign and not a hyphen."""
    # adding 0 turns -0 into 0
    return f"{round(math.degrees(angle), 1) + 0.0:.1f}°".replace("-", "−")


def shown_value(value: float, unit: str, digits: int = 4) -> str:
    """Return an SI value in a legible unit, with a minus sign and not a hyphen."""
    name, factor = reading_unit(unit, abs(value)) if value else (unit.replace("rad", "deg"), 1.0)
    rounded = float(f"{factor * value:.{digits}g}")
    return f"{rounded:g} {name}".replace("-", "−").replace("m/s^2", "m/s²")


def shown_strength(structure: Structure, course: Course, size: float) -> str:
    """Return the strength of a course's drive as text."""
    return shown_value(size, drive_unit(structure, course.drive))


def withstood_text(withstood: Withstood) -> str:
    """Return the load that a state withstands as text."""
    value = shown_value(withstood.value, withstood.unit, 3)
    return {"limit": f"to {value}", "bifurcation": f"to {value}, then sideways", "none": f"beyond {value}"}[
        withstood.kind
    ]


def touching_text(contacts: Mapping[str, float]) -> str:
    """Return the parts that touch in a state, with the largest force of a pair, as text."""
    if not contacts:
        return "none"
    name, force = max(contacts.items(), key=lambda entry: entry[1])
    largest = shown_value(force, "N", 3)
    return f"{name}: {largest}" if len(contacts) == 1 else f"{len(contacts)} pairs, up to {largest} ({name})"


def slow_path_text(structure: Structure, course: Course) -> str:
    """Return a phrase on the equilibria under a slowly growing drive."""
    size = abs(course.drive.strength)
    snaps = [snap for snap in course.slow.snaps if snap.kind != "branch"]
    phrases = [f"snaps at {shown_strength(structure, course, snap.factor * size)}" for snap in snaps]
    if len(phrases) > 3:
        phrases = [*phrases[:2], f"{len(phrases) - 2} more times"]
    for touch in course.touches[:_TOUCHES]:
        pairs = touch.parts[0] if len(touch.parts) == 1 else f"{len(touch.parts)} pairs of parts"
        phrases.append(f"{pairs} touch from {shown_strength(structure, course, touch.point.factor * size)}")
    if course.largest_force is not None:
        phrases.append(f"requires {shown_value(course.largest_force, 'N', 3)}")
    return ", ".join(phrases) or "bends without a snap"


def reading_words(structure: Structure, name: str, readings: list[float]) -> str:
    """Return the range of a measure's readings."""
    measure = measure_of(structure, name)
    unit = "m" if measure is not None and measure.kind == "distance" else "rad"
    if unit == "rad":
        readings = [0.0 if abs(reading) < _FLAT else reading for reading in readings]
    low, high = shown_value(min(readings), unit), shown_value(max(readings), unit)
    return low if low == high else f"{low.removesuffix(' deg')} to {high}"
