"""What bodies weigh, where, and how hard they are to turn: closed forms of bars and plates."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from forficula.structure.structure import Array, Bar, Structure
from forficula.structure.tree import ancestry, built_frames


@dataclass(frozen=True, kw_only=True, eq=False)
class Mass:
    """Of something rigid, in some axes.

    Attributes:
        mass: kg.
        centre: of mass, from the origin of the axes, m, (3,).
        inertia: about the centre, kg m^2, (3, 3).
    """

    mass: float
    centre: Array
    inertia: Array


def bar_mass(bar: Bar) -> Mass:
    """Of a solid cylinder: m r^2 / 2 about its axis, m (r^2 / 4 + l^2 / 12) across it."""
    length, radius = float(np.linalg.norm(bar.end)), bar.diameter / 2
    along = bar.end / length
    mass = bar.density * math.pi * radius**2 * length
    about_axis, across = mass * radius**2 / 2, mass * (radius**2 / 4 + length**2 / 12)
    inertia = across * np.eye(3) + (about_axis - across) * np.outer(along, along)
    return Mass(mass=mass, centre=bar.end / 2, inertia=inertia)


def plate_mass(corners: Array, thickness: float, density: float) -> Mass:
    """Of a prism over a plane polygon, half of its thickness on either side.

    Of the triangles 0, p, q of a fan from the first corner, with signs, the integral of r r^T over the area a is
    a / 12 (p p^T + q q^T + (p + q) (p + q)^T).

    Args:
        corners: one after another, m, (corner, 3).
        thickness: m.
        density: kg/m^3.
    """
    first, second = corners[1:-1] - corners[0], corners[2:] - corners[0]
    doubled = np.cross(first, second)
    normal = doubled.sum(axis=0) / np.linalg.norm(doubled.sum(axis=0))
    areas = doubled @ normal / 2
    area, sums = float(areas.sum()), first + second
    centre = areas @ sums / (3 * area)
    squares = sum(
        share / 12 * (np.outer(p, p) + np.outer(q, q) + np.outer(both, both))
        for share, p, q, both in zip(areas, first, second, sums, strict=True)
    )
    mass = density * thickness * area
    spread = density * thickness * (squares - area * np.outer(centre, centre))
    spread = spread + mass * thickness**2 / 12 * np.outer(normal, normal)
    inertia = np.trace(spread) * np.eye(3) - spread
    return Mass(mass=mass, centre=corners[0] + centre, inertia=np.asarray(inertia))


def end_inertia(*, diameter: float, density: float, length: float, along: float, across: float) -> float:
    """Of a solid cylinder about an axis through the middle of its end, kg m^2.

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


def body_masses(structure: Structure) -> tuple[Mass | None, ...]:
    """Of all bodies, in their own axes, (body,); None for one without a bar or a plate."""
    solids: list[list[Mass]] = [[] for _ in structure.bodies]
    for bar in structure.bars:
        solids[bar.body].append(bar_mass(bar))
    for plate in structure.plates:
        corners = np.array([structure.points[point].place for point in plate.points])
        solids[plate.body].append(plate_mass(corners, plate.thickness, plate.density))
    return tuple(_together(each) if each else None for each in solids)


def _together(solids: list[Mass]) -> Mass:
    mass = sum(solid.mass for solid in solids)
    centre = np.asarray(sum(solid.mass * solid.centre for solid in solids) / mass)
    inertia = sum(solid.inertia + _displaced(solid.mass, solid.centre - centre) for solid in solids)
    return Mass(mass=mass, centre=centre, inertia=np.asarray(inertia))


def _displaced(mass: float, way: Array) -> Array:
    """By how much the inertia grows about an origin that is this far from the centre, kg m^2, (3, 3)."""
    return np.asarray(mass * (way @ way * np.eye(3) - np.outer(way, way)))


def inertia_about(structure: Structure, hinge: int) -> float:
    """Inertia about a hinge's axis of all that turns with it as built, with its armature, kg m^2."""
    origins, frames = built_frames(structure)
    body = structure.hinges[hinge].body
    axis, total = frames[body] @ structure.hinges[hinge].axis, structure.hinges[hinge].armature
    for number, mass in enumerate(body_masses(structure)):
        if mass is not None and body in ancestry(structure, number):
            way = origins[number] + frames[number] @ mass.centre - origins[body]
            inertia = frames[number] @ mass.inertia @ frames[number].T + _displaced(mass.mass, way)
            total += float(axis @ inertia @ axis)
    return total
