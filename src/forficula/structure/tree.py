"""The tree of bodies: what hangs on what, and where points are as built."""

from __future__ import annotations

import numpy as np

from forficula.arrays import Array
from forficula.structure.parts import GROUND, Tendon
from forficula.structure.structure import Structure


def ancestry(structure: Structure, body: int) -> tuple[int, ...]:
    """A body and what it hangs on, up to the ground, which is left out."""
    chain = []
    while body != GROUND:
        chain.append(body)
        body = structure.bodies[body].parent
    return tuple(chain)


def hinges_between(structure: Structure, one: int, other: int) -> tuple[int, ...]:
    """Numbers of the hinges that lie on the way from one body to another: those that change how the two are placed."""
    apart = set(ancestry(structure, one)) ^ set(ancestry(structure, other))
    return tuple(number for number, hinge in enumerate(structure.hinges) if hinge.body in apart)


def built_points(structure: Structure) -> Array:
    """Where all points are in the built shape, m, (point, 3)."""
    origins, frames = built_frames(structure)
    return np.array(
        [
            point.place if point.body == GROUND else origins[point.body] + frames[point.body] @ point.place
            for point in structure.points
        ]
    ).reshape(-1, 3)


def drawn_points(structure: Structure) -> list[int]:
    """Numbers of the points that bars, plates and facets are drawn between."""
    ends = [part.points for parts in (structure.bars, structure.plates, structure.facets) for part in parts]
    return sorted({point for points in ends for point in points})


def built_lengths(structure: Structure) -> Array:
    """The distances of the tendons' ends in the built shape, m, (tendon,)."""
    points = built_points(structure)
    ends = (tendon.points for tendon in structure.tendons)
    return np.array([float(np.linalg.norm(points[end] - points[start])) for start, end in ends])


def built_strains(structure: Structure) -> Array:
    """The strains of the tendons in the built shape, (tendon,); infinite without a gauge length."""
    gauges = np.array([tendon.gauge_length for tendon in structure.tendons])
    return np.where(gauges > 0, built_lengths(structure) / np.where(gauges > 0, gauges, 1.0) - 1, np.inf)


def built_hinges(structure: Structure) -> tuple[Array, Array]:
    """Where the hinges are in the built shape, m, (hinge, 3), and unit vectors along their axes, (hinge, 3)."""
    origins, frames = built_frames(structure)
    bodies = [hinge.body for hinge in structure.hinges]
    axes = [frames[hinge.body] @ hinge.axis for hinge in structure.hinges]
    return origins[bodies].reshape(-1, 3), np.array(axes).reshape(-1, 3)


def outer_ends(structure: Structure) -> Array:
    """The points of outermost bodies, those that carry no other, that are furthest from their origins, m, (end, 3).

    One a body, in the built shape: the tip of a bar, a corner of a plate.
    """
    copies = {closure.bodies[1] for closure in structure.closures}
    carrying = {body.parent for number, body in enumerate(structure.bodies) if number not in copies}
    ends = drawn_points(structure)
    furthest: dict[int, int] = {}
    for number in ends:
        point = structure.points[number]
        far = furthest.get(point.body)
        if far is None or np.linalg.norm(point.place) > np.linalg.norm(structure.points[far].place):
            furthest[point.body] = number
    chosen = [number for body, number in furthest.items() if body != GROUND and body not in carrying]
    return built_points(structure)[chosen]


def crossing_tendons(structure: Structure) -> tuple[int, ...]:
    """Numbers of the tendons that lie across one hinge each."""
    return tuple(number for number, tendon in enumerate(structure.tendons) if tendon.crossing is not None)


def tendon_arms(structure: Structure, tendon: Tendon) -> tuple[tuple[int, float], ...]:
    """The hinges that a tendon crosses, and the longest lever that it can have about each, m.

    That is the distance of its nearer end from the hinge's body's origin: the pull is no further from there.
    """
    origins, _ = built_frames(structure)
    bodies = [structure.points[point].body for point in tendon.points]
    places = built_points(structure)[list(tendon.points)]
    return tuple(
        (hinge, float(np.linalg.norm(places - origins[structure.hinges[hinge].body], axis=1).min()))
        for hinge in hinges_between(structure, bodies[0], bodies[1])
    )


def built_frames(structure: Structure) -> tuple[Array, Array]:
    """Origins, (body, 3), and rotations from the axes of bodies to those of the ground, (body, 3, 3), as built."""
    origins, frames = np.zeros((len(structure.bodies), 3)), np.zeros((len(structure.bodies), 3, 3))
    for number, body in enumerate(structure.bodies):
        if body.parent == GROUND:
            origins[number], frames[number] = body.position, body.frame
        else:
            origins[number] = origins[body.parent] + frames[body.parent] @ body.position
            frames[number] = frames[body.parent] @ body.frame
    return origins, frames
