"""Mass, centre of mass and inertia of bodies, in closed form."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.structure.parts import Bar, Closure, Plate, PointMass
from forficula.structure.structure import Structure
from forficula.structure.tree import ancestry, built_frames


def mass_of(structure: Structure, body: int) -> tuple[float, Array, Array]:
    """Compute mass, centre of mass and inertia of a body with everything that it carries.

    A body and its copies, which close loops, share the mass equally.

    Args:
        structure: structure in SI or in other units.
        body: number of the body.

    Returns:
        Mass, kg; centre of mass in the axes of the body, m, (3,); inertia about the centre in those axes, kg m^2,
        (3, 3). All are 0 for a body without mass.
    """
    original, copies = _copies(structure, body)
    if copies:
        mass, centre, inertia = _of_parts(structure, original)
        copy = next((closure for closure in copies if closure.bodies[1] == body), None)
        if copy is not None:
            centre, inertia = copy.frame.T @ (centre - copy.position), copy.frame.T @ inertia @ copy.frame
        return mass / (len(copies) + 1), centre, inertia / (len(copies) + 1)
    return _of_parts(structure, body)


def _copies(structure: Structure, body: int) -> tuple[int, list[Closure]]:
    """Return the original of a copied body, or the body itself if it is no copy, and all copies of the original."""
    original = next((closure.bodies[0] for closure in structure.closures if closure.bodies[1] == body), body)
    return original, [closure for closure in structure.closures if closure.bodies[0] == original]


def _of_parts(structure: Structure, body: int) -> tuple[float, Array, Array]:
    """Compute mass, centre and inertia of all bars, plates and masses on a body, without sharing."""
    parts = [_of_bar(bar) for bar in structure.bars if bar.body == body]
    for plate in structure.plates:
        if plate.body == body and plate.solids:
            parts += [
                _of_convex(np.array([structure.points[point].place for point in solid]), plate.density)
                for solid in plate.solids
            ]
        elif plate.body == body:
            parts.append(_of_plate(plate, np.array([structure.points[point].place for point in plate.points])))
    return _combined(parts + [_of_point_mass(mass) for mass in structure.masses if mass.body == body])


def gathered_mass(masses: Sequence[PointMass]) -> tuple[float, Array, Array]:
    """Compute mass, centre of mass and inertia about the centre of point masses on one body, as `mass_of`."""
    return _combined([_of_point_mass(mass) for mass in masses])


def _of_point_mass(point: PointMass) -> tuple[float, Array, Array]:
    return point.mass, point.place, np.zeros((3, 3))


def _combined(parts: Sequence[tuple[float, Array, Array]]) -> tuple[float, Array, Array]:
    """Combine several masses, with centres and inertias, to one."""
    mass = sum((part[0] for part in parts), 0.0)
    if not mass:
        return 0.0, np.zeros(3), np.zeros((3, 3))
    if len(parts) == 1:
        return parts[0]
    centre = np.sum([weight * place for weight, place, _ in parts], axis=0) / mass
    inertia = np.sum([central + weight * _of_point(place - centre) for weight, place, central in parts], axis=0)
    return mass, centre, inertia


def _of_bar(bar: Bar) -> tuple[float, Array, Array]:
    """Compute mass, centre and inertia of a solid cylinder from the origin to its end."""
    length = float(np.linalg.norm(bar.end))
    along, radius = bar.end / length, bar.diameter / 2
    mass = bar.density * math.pi * radius**2 * length
    axial, across = mass * radius**2 / 2, mass * (radius**2 / 4 + length**2 / 12)
    return mass, bar.end / 2, across * np.eye(3) + (axial - across) * np.outer(along, along)


def _of_plate(plate: Plate, corners: Array) -> tuple[float, Array, Array]:
    """Compute mass, centre and inertia of a prism whose mid-plane is a flat polygon.

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
    # second moment of a triangle 0, a, b: area / 12 times ((a + b) (a + b)' + a a' + b b')
    both = away + following
    second = np.einsum("t,ti,tj->ij", areas / 12, both, both)
    second += np.einsum("t,ti,tj->ij", areas / 12, away, away)
    second += np.einsum("t,ti,tj->ij", areas / 12, following, following)
    mean = first / area
    spread = second / area - np.outer(mean, mean) + plate.thickness**2 / 12 * np.outer(normal, normal)
    mass = plate.density * plate.thickness * area
    return float(mass), corners[0] + mean, mass * (np.trace(spread) * np.eye(3) - spread)


def _of_convex(corners: Array, density: float) -> tuple[float, Array, Array]:
    """Compute mass, centre and inertia of the convex hull of corners.

    They are sums over the tetrahedra between a position inside and the triangles of the surface. For corners a, b, c
    the volume is V = |a . (b x c)| / 6, and the second moment V / 20 ((a + b + c) (a + b + c)' + a a' + b b' + c c').
    """
    inside = corners.mean(axis=0)
    triangles = (corners - inside)[scipy.spatial.ConvexHull(corners).simplices]
    volumes = np.abs(np.linalg.det(triangles)) / 6
    volume, sums = volumes.sum(), triangles.sum(axis=1)
    mean = volumes @ sums / (4 * volume)
    second = np.einsum("t,ti,tj->ij", volumes / 20, sums, sums)
    second += np.einsum("t,tki,tkj->ij", volumes / 20, triangles, triangles)
    spread = second - volume * np.outer(mean, mean)
    return float(density * volume), inside + mean, density * (np.trace(spread) * np.eye(3) - spread)


def _of_point(place: Array) -> Array:
    """Compute the inertia about the origin of a unit mass at a point (Huygens and Steiner)."""
    return np.asarray(place @ place * np.eye(3) - np.outer(place, place))


def end_inertia(*, diameter: float, density: float, length: float, along: float, across: float) -> float:
    """Compute the inertia of a solid cylinder about an axis through the middle of its end, kg m^2.

    The inertia is m r^2 / 2 cos^2 + m (r^2 / 4 + l^2 / 3) sin^2 of the angle between axis and bar.

    Args:
        diameter: m.
        density: kg/m^3.
        length: m.
        along: cosine of the angle between axis and bar.
        across: sine of this angle.
    """
    radius = diameter / 2
    mass = density * math.pi * radius**2 * length
    return mass * (radius**2 / 2 * along**2 + (radius**2 / 4 + length**2 / 3) * across**2)


def turned_inertia(masses: Sequence[PointMass], body: int, axis: Array) -> float:
    """Compute the inertia of the point masses on a body about an axis through its origin, kg m^2.

    Args:
        masses: point masses of all bodies.
        body: number of the body.
        axis: unit vector in the axes of the body, (3,).
    """
    carried = (mass for mass in masses if mass.body == body)
    return sum((mass.mass * float(axis @ _of_point(mass.place) @ axis) for mass in carried), 0.0)


def inertia_about(structure: Structure, hinge: int) -> float:
    """Compute the inertia about a hinge's axis of all bodies that turn with it as built, with its armature, kg m^2."""
    origins, frames = built_frames(structure)
    body = structure.hinges[hinge].body
    axis, total = frames[body] @ structure.hinges[hinge].axis, structure.hinges[hinge].armature
    for number in range(len(structure.bodies)):
        if body in ancestry(structure, number):
            mass, centre, central = mass_of(structure, number)
            arm = origins[number] + frames[number] @ centre - origins[body]
            inertia = frames[number] @ central @ frames[number].T + mass * _of_point(arm)
            total += float(axis @ inertia @ axis)
    return total
