"""The tree of bodies: parents and children, and positions in the built shape."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.structure.parts import GROUND, Body, Tendon
from forficula.structure.structure import Structure


def ancestry(structure: Structure, body: int) -> tuple[int, ...]:
    """Return the numbers of a body and its ancestors, without the ground."""
    chain = []
    while body != GROUND:
        chain.append(body)
        body = structure.bodies[body].parent
    return tuple(chain)


def moving_body(structure: Structure, body: int) -> int:
    """Return the nearest of a body and its ancestors that moves relative to its parent; GROUND if none does."""
    turning = {hinge.body for hinge in structure.hinges if hinge.flaps is None}
    moving = (number for number in ancestry(structure, body) if structure.bodies[number].slides or number in turning)
    return next(moving, GROUND)


def joint_count(structure: Structure) -> int:
    """Return the number of joints, which are the first hinges of a structure; creases between flaps follow them.

    Raises:
        InputError: a joint follows a crease.
    """
    jointed = [hinge.flaps is None for hinge in structure.hinges]
    count = sum(jointed)
    if not all(jointed[:count]):
        late = next(hinge.name for hinge in structure.hinges[count:] if hinge.flaps is None)
        raise InputError(f"{structure.name}: need joints before creases between flaps, got the joint {late} after one")
    return count


def hinges_between(structure: Structure, one: int, other: int) -> tuple[int, ...]:
    """Return the numbers of the hinges on the path from one body to another, which change their relative position."""
    apart = set(ancestry(structure, one)) ^ set(ancestry(structure, other))
    return tuple(number for number, hinge in enumerate(structure.hinges) if hinge.body in apart)


def built_points(structure: Structure) -> Array:
    """Compute the positions of all points in the built shape, m, (point, 3)."""
    origins, frames = built_frames(structure)
    return np.array(
        [
            point.place if point.body == GROUND else origins[point.body] + frames[point.body] @ point.place
            for point in structure.points
        ]
    ).reshape(-1, 3)


def drawn_points(structure: Structure) -> list[int]:
    """Return the numbers of the points between which bars, plates and facets are drawn."""
    ends = [part.points for parts in (structure.bars, structure.plates, structure.facets) for part in parts]
    ends += [solid for plate in structure.plates for solid in plate.solids]
    return sorted({point for points in ends for point in points})


def built_lengths(structure: Structure) -> Array:
    """Compute the distances between the tendons' ends in the built shape, m, (tendon,)."""
    points = built_points(structure)
    ends = (tendon.points for tendon in structure.tendons)
    return np.array([float(np.linalg.norm(points[end] - points[start])) for start, end in ends])


def built_strains(structure: Structure) -> Array:
    """Compute the strains of the tendons in the built shape, (tendon,); infinite without a gauge length."""
    gauges = np.array([tendon.gauge_length for tendon in structure.tendons])
    return np.where(gauges > 0, built_lengths(structure) / np.where(gauges > 0, gauges, 1.0) - 1, np.inf)


def built_hinges(structure: Structure) -> tuple[Array, Array]:
    """Compute positions, m, (hinge, 3), and unit vectors along the axes, (hinge, 3), of hinges in the built shape."""
    origins, frames = built_frames(structure)
    bodies = [hinge.body for hinge in structure.hinges]
    axes = [frames[hinge.body] @ hinge.axis for hinge in structure.hinges]
    return origins[bodies].reshape(-1, 3), np.array(axes).reshape(-1, 3)


def outer_ends(structure: Structure) -> Array:
    """Compute the outer ends of the outermost bodies, which have no children, in the built shape, m, (end, 3).

    The outer end of a body is the point furthest from its origin: the tip of a bar or a corner of a plate.
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
    """Return the numbers of the tendons that lie across a single hinge."""
    return tuple(number for number, tendon in enumerate(structure.tendons) if tendon.crossing is not None)


def tendon_arms(structure: Structure, tendon: Tendon) -> tuple[tuple[int, float], ...]:
    """Return the hinges that a tendon crosses, with the longest possible lever arm about each, m.

    The lever arm cannot exceed the distance of the nearer end from the origin of the hinge's body.
    """
    origins, _ = built_frames(structure)
    bodies = [structure.points[point].body for point in tendon.points]
    places = built_points(structure)[list(tendon.points)]
    return tuple(
        (hinge, float(np.linalg.norm(places - origins[structure.hinges[hinge].body], axis=1).min()))
        for hinge in hinges_between(structure, bodies[0], bodies[1])
    )


def built_frames(structure: Structure) -> tuple[Array, Array]:
    """Compute origins of bodies, (body, 3), and rotations from their axes to the ground's, (body, 3, 3), as built."""
    return frames_of(structure.bodies)


def frames_of(bodies: Sequence[Body]) -> tuple[Array, Array]:
    """Compute origins, (body, 3), and rotations to the axes of the ground, (body, 3, 3), of bodies as built.

    Args:
        bodies: parents before their children.
    """
    origins, frames = np.zeros((len(bodies), 3)), np.zeros((len(bodies), 3, 3))
    for number, body in enumerate(bodies):
        if body.parent == GROUND:
            origins[number], frames[number] = body.position, body.frame
        else:
            origins[number] = origins[body.parent] + frames[body.parent] @ body.position
            frames[number] = frames[body.parent] @ body.frame
    return origins, frames
