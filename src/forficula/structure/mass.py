"""Mass, centre and inertia of bodies, in closed form."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from forficula.arrays import Array
from forficula.structure.parts import Bar, Closure, Plate, PointMass
from forficula.structure.structure import Structure
from forficula.structure.tree import ancestry, built_frames


def mass_of(structure: Structure, body: int) -> tuple[float, Array, Array]:
    """Mass, centre and inertia of a body: of what it is and of what it carries, shared with copies that close loops.

    Args:
        structure: SI, or in other units.
        body: its number.

    Returns:
        Mass, kg; centre of mass in the axes of the body, m, (3,); inertia about the centre in those axes, kg m^2,
        (3, 3). All 0 where it is nothing.
    """
    original, copies = _copies(structure, body)
    if copies:
        mass, centre, inertia = _of_parts(structure, original)
        own = next((each for each in copies if each.bodies[1] == body), None)
        if own is not None:
            centre, inertia = own.frame.T @ (centre - own.position), own.frame.T @ inertia @ own.frame
        return mass / (len(copies) + 1), centre, inertia / (len(copies) + 1)
    return _of_parts(structure, body)


def _copies(structure: Structure, body: int) -> tuple[int, list[Closure]]:
    """What a body is a copy of, itself if of nothing, and all copies of that."""
    original = next((each.bodies[0] for each in structure.closures if each.bodies[1] == body), body)
    return original, [each for each in structure.closures if each.bodies[0] == original]


def _of_parts(structure: Structure, body: int) -> tuple[float, Array, Array]:
    """The same of all bars, plates and masses that it carries alone."""
    parts = [_of_bar(bar) for bar in structure.bars if bar.body == body]
    parts += [
        _of_plate(plate, np.array([structure.points[point].place for point in plate.points]))
        for plate in structure.plates
        if plate.body == body
    ]
    return _together(parts + [_at_one_place(each) for each in structure.masses if each.body == body])


def gathered_mass(masses: Sequence[PointMass]) -> tuple[float, Array, Array]:
    """Mass, centre and inertia about it of what one body carries at places, as of `mass_of`."""
    return _together([_at_one_place(each) for each in masses])


def _at_one_place(each: PointMass) -> tuple[float, Array, Array]:
    return each.mass, each.place, np.zeros((3, 3))


def _together(parts: Sequence[tuple[float, Array, Array]]) -> tuple[float, Array, Array]:
    """Mass, centre and inertia of several of them as one."""
    mass = sum((part[0] for part in parts), 0.0)
    if not mass:
        return 0.0, np.zeros(3), np.zeros((3, 3))
    if len(parts) == 1:
        return parts[0]
    centre = np.sum([weight * place for weight, place, _ in parts], axis=0) / mass
    inertia = np.sum([own + weight * _of_point(place - centre) for weight, place, own in parts], axis=0)
    return mass, centre, inertia


def _of_bar(bar: Bar) -> tuple[float, Array, Array]:
    """A solid cylinder from the origin to its end."""
    length = float(np.linalg.norm(bar.end))
    along, radius = bar.end / length, bar.diameter / 2
    mass = bar.density * math.pi * radius**2 * length
    axial, across = mass * radius**2 / 2, mass * (radius**2 / 4 + length**2 / 12)
    return mass, bar.end / 2, across * np.eye(3) + (axial - across) * np.outer(along, along)


def _of_plate(plate: Plate, corners: Array) -> tuple[float, Array, Array]:
    """A prism over a flat polygon, which lies in its middle.

    Area, first and second moments are sums over the triangles from the first corner to every side (Green's theorem).
    """
    away = corners - corners[0]
    following = np.roll(away, -1, axis=0)
    normals = np.cross(away, following)
    normal = normals.sum(axis=0)
    normal = normal / np.linalg.norm(normal)
    areas = normals @ normal / 2
    area = areas.sum()
    first = (areas[:, None] * (away + following)).sum(axis=0) / 3
    # of a triangle 0, a, b: area / 12 times (a + b) (a + b)' + a a' + b b'
    both = away + following
    second = np.einsum("t,ti,tj->ij", areas / 12, both, both)
    second += np.einsum("t,ti,tj->ij", areas / 12, away, away)
    second += np.einsum("t,ti,tj->ij", areas / 12, following, following)
    mean = first / area
    spread = second / area - np.outer(mean, mean) + plate.thickness**2 / 12 * np.outer(normal, normal)
    mass = plate.density * plate.thickness * area
    return float(mass), corners[0] + mean, mass * (np.trace(spread) * np.eye(3) - spread)


def _of_point(place: Array) -> Array:
    """Inertia of a unit mass at a place about the origin (Huygens and Steiner)."""
    return np.asarray(place @ place * np.eye(3) - np.outer(place, place))


def end_inertia(*, diameter: float, density: float, length: float, along: float, across: float) -> float:
    """Inertia of a solid cylinder about an axis through the middle of its end, kg m^2.

    m r^2 / 2 cos^2 + m (r^2 / 4 + l^2 / 3) sin^2 of the angle between axis and bar.

    Args:
        diameter: m.
        density: kg/m^3.
        length: m.
        along: cosine of that angle.
        across: its sine.
    """
    radius = diameter / 2
    mass = density * math.pi * radius**2 * length
    return mass * (radius**2 / 2 * along**2 + (radius**2 / 4 + length**2 / 3) * across**2)


def turned_inertia(masses: Sequence[PointMass], body: int, axis: Array) -> float:
    """Inertia of what a body carries beside its bars and plates about an axis through its origin, kg m^2.

    Args:
        masses: of all bodies.
        body: its number.
        axis: unit vector in its axes, (3,).
    """
    return sum((each.mass * float(axis @ _of_point(each.place) @ axis) for each in masses if each.body == body), 0.0)


def inertia_about(structure: Structure, hinge: int) -> float:
    """Inertia about a hinge's axis of all that turns with it as built, with its armature, kg m^2."""
    origins, frames = built_frames(structure)
    body = structure.hinges[hinge].body
    axis, total = frames[body] @ structure.hinges[hinge].axis, structure.hinges[hinge].armature
    for number in range(len(structure.bodies)):
        if body in ancestry(structure, number):
            mass, centre, own = mass_of(structure, number)
            way = origins[number] + frames[number] @ centre - origins[body]
            inertia = frames[number] @ own @ frames[number].T + mass * _of_point(way)
            total += float(axis @ inertia @ axis)
    return total
