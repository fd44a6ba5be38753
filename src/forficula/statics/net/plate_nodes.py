"""Rigid plates as parts of a net: every position on a plate is a weighted sum of its four nodes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.pattern.rotation import IDENTITY_MOTION, RigidMotion, frame_along
from forficula.structure import GROUND, Hinge, Structure, mass_of
from forficula.structure.tree import built_frames

_STIFF = 1e6  # stiffness of bars of plates and pins of joints, divided by that of the stiffest other part
_ENDS = tuple((one, other) for one in range(4) for other in range(one))


@dataclass(frozen=True, kw_only=True, eq=False)
class PlateNodes:
    """The nodes of all plates.

    Attributes:
        nodes: four of each plate that is not a copy: at its origin and along its axes, m, (node, 3).
        first: number of the first node of each body, that of the original for a copy, and that of the body that
            carries it for a body without joints, (body,).
        free: whether a body may move, (body,).
        size: distance of the nodes along the axes from the origin, m.
        mass: mass matrix, the same for x, y and z, kg, (node, node).
        bars: pairs of nodes.
    """

    nodes: Array
    first: tuple[int, ...]
    free: tuple[bool, ...]
    size: float
    mass: Array
    bars: tuple[tuple[int, int], ...]


def plate_nodes(structure: Structure) -> PlateNodes:
    """Compute the nodes of every plate.

    A plate's kinetic energy is that of the nodes with the mass matrix A [[m, m c], [m c, S]] A^T, where c is its
    centre, S the integral of r r^T, and A maps (1, r) to the weights of the nodes.
    """
    origins, _ = built_frames(structure)
    size = structure.span / 4
    copies = {closure.bodies[1]: closure.bodies[0] for closure in structure.closures}
    carriers = [_carrier(structure, body) for body in range(len(structure.bodies))]
    originals = [body for body, (carrier, _) in enumerate(carriers) if body not in copies and carrier == body]
    hinged = {hinge.body for hinge in structure.hinges}
    mass = np.zeros((4 * len(originals), 4 * len(originals)))
    for body, (carrier, motion) in enumerate(carriers):
        if body in copies:
            continue
        index = originals.index(copies.get(carrier, carrier))
        weight, centre, inertia = mass_of(structure, body)
        if carrier != body:
            centre, inertia = motion.of(centre), motion.rotation @ inertia @ motion.rotation.T
        spread = np.trace(inertia) / 2 * np.eye(3) - inertia + weight * np.outer(centre, centre)
        moments = np.block([[np.array([[weight]]), weight * centre[None]], [weight * centre[:, None], spread]])
        shares = np.block([[np.ones((1, 1)), -np.ones((1, 3)) / size], [np.zeros((3, 1)), np.eye(3) / size]])
        count = 1 + list(copies.values()).count(body)
        mass[4 * index : 4 * index + 4, 4 * index : 4 * index + 4] += count * shares @ moments @ shares.T
    axes = np.concatenate((np.zeros((1, 3)), size * np.eye(3)))
    return PlateNodes(
        nodes=np.concatenate([origins[body] + axes for body in originals]),
        first=tuple(4 * originals.index(copies.get(carrier, carrier)) for carrier, _ in carriers),
        free=tuple(bool(structure.bodies[carrier].slides) or carrier in hinged for carrier, _ in carriers),
        size=size,
        mass=mass,
        bars=tuple((4 * index + one, 4 * index + other) for index in range(len(originals)) for one, other in _ENDS),
    )


def posed_nodes(structure: Structure, nodes: Array, first: tuple[int, ...], origins: Array, frames: Array) -> Array:
    """Return the nodes of plates in a pose, m, (node, 3); other nodes are as built.

    Args:
        structure: with plates.
        nodes: as built, m, (node, 3).
        first: number of the first node of each body, as in `PlateNodes`.
        origins: of the bodies in the pose, m, (body, 3).
        frames: rotations from their axes to the ground's, (body, 3, 3).
    """
    positions, (built, axes) = nodes.copy(), built_frames(structure)
    for body, begin in enumerate(first):
        turn = frames[body] @ axes[body].T
        positions[begin : begin + 4] = origins[body] + (nodes[begin : begin + 4] - built[body]) @ turn.T
    return positions


def _carrier(structure: Structure, body: int) -> tuple[int, RigidMotion]:
    """Return the body that carries a body without joints, itself for others, and the motion to the axes of the carrier.

    A body that is fixed to the ground carries itself.
    """
    motion, hinged = IDENTITY_MOTION, {hinge.body for hinge in structure.hinges}
    while body not in hinged and not structure.bodies[body].slides and structure.bodies[body].parent != GROUND:
        motion = RigidMotion(structure.bodies[body].frame, structure.bodies[body].position).after(motion)
        body = structure.bodies[body].parent
    return body, motion


def place_weights(structure: Structure, plates: PlateNodes, body: int, place: Array) -> dict[int, float]:
    """Return the weight of each node, by the number of the node, for a position in the axes of a body."""
    carrier, motion = _carrier(structure, body)
    if carrier != body:
        body, place = carrier, motion.of(place)
    closure = next((entry for entry in structure.closures if entry.bodies[1] == body), None)
    if closure is not None:
        place = closure.position + closure.frame @ place
    shares = place / plates.size
    weights = [1 - float(shares.sum()), *shares.tolist()]
    return {plates.first[body] + number: weight for number, weight in enumerate(weights)}


def joint_places(structure: Structure, hinge: Hinge, size: float) -> list[tuple[int, Array]]:
    """Return bodies and positions of the two flaps of a joint as a crease whose angle is sense x that of the joint.

    The crease runs against the hinge axis. Seen along the crease, the left flap is on the body's parent.
    """
    body = structure.bodies[hinge.body]
    axis = hinge.axis / np.linalg.norm(hinge.axis)
    across, upwards, _ = frame_along(axis).T
    turned = hinge.sense * hinge.built
    right = -np.cos(turned) * across - np.sin(turned) * upwards
    ours = [size * axis, np.zeros(3)]
    theirs = [body.position + body.frame @ place for place in (*ours, size * (axis / 2 + across))]
    parent = [(body.parent, place) for place in theirs]
    return [*parent, *((hinge.body, place) for place in (*ours, size * (axis / 2 + right)))]


def stiffness_of(structure: Structure, size: float) -> float:
    """Return the stiffness of bars in plates and of pins of joints, N/m."""
    springs = [spring.stiffness for spring in structure.springs]
    tendons = [float(tendon.law.elastic.stiffness(1.1 * tendon.law.rest_length + size)) for tendon in structure.tendons]
    turning = [hinge.stiffness / size**2 for hinge in structure.hinges]
    return _STIFF * max([*springs, *tendons, *turning], default=1.0)
