"""Contact forces between facets, plates and bars, as generalised forces on the engine's velocities.

The engine's own contact of flexes is not used for facets: it ignores triangles that share a node, so that facets that
meet at a vertex pass through each other, and parallel triangles that cover each other do not repel.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import mujoco
import numpy as np

from forficula.arrays import Array, Indices
from forficula.design.section import SMALL_LENGTH
from forficula.dynamics.engine.placement import Placement, Pose, placement_of
from forficula.dynamics.stepping.start_states import start_position
from forficula.errors import InputError
from forficula.quantities import show_quantity, show_value
from forficula.structure import Contact
from forficula.structure.contact.distances import Nearest, crossing_share, row_cross
from forficula.structure.contact.pairs import Pairs, near_pairs, parts_that_cross
from forficula.structure.contact.touching_parts import TouchingParts, touching_parts

if TYPE_CHECKING:
    from forficula.dynamics.engine.model import Model

# tolerance of a thickness, because numbers are shown with four digits
_ROUNDING = 1e-3
# squared sine of the angle of two sides, below which their contact fades, because nodes and triangles replace it
_PARALLEL = 0.01
# share of the thickness up to which the force grows as that of the law; beyond, it grows linearly
_DEEPEST = 15 / 16
# distance, as a share of the thickness and of the mean length of sides, within which pairs are listed
_SKINS = (2.0, 0.1)
# factor on the largest speed in the estimate of the number of steps without contact
_FASTER = 2.0
# [chosen] largest overlap as a share of the thickness: beyond it, parts may have passed through each other
_LARGEST_OVERLAP = 0.5
# largest number of steps without contact
_MANY = 1000


@dataclass(frozen=True, kw_only=True, eq=False)
class Touching:
    """The parts of a structure that touch, and the bodies that carry their nodes, in the model's units.

    Attributes:
        parts: of the structure.
        contact: its contact.
        placement: of its bodies.
        carriers: number of the body of each node, (node,); the number of bodies for the ground.
        places: positions of the nodes in the axes of their bodies, (node, 3).
        mobilities: largest acceleration of each node per force on it, as built, (node,).
        levers: largest distance of a node from the axis of each joint in any shape, (joint,).
        skin: distance within which pairs are listed.
        timestep: of the model.
        engine: the compiled model.
        explicit: whether forces are those in the middle of a step; else they are those at its start.
    """

    parts: TouchingParts
    contact: Contact
    placement: Placement
    carriers: Indices
    places: Array
    mobilities: Array
    levers: Array
    skin: float
    timestep: float
    engine: mujoco.MjModel
    explicit: bool

    def nodes(self, position: Array) -> tuple[Pose, Array, Array]:
        """Return the pose of the bodies, and positions and arms of the nodes, (node, 3), for one position."""
        pose = self.placement.poses(position)
        frames = np.concatenate([pose.frames, np.eye(3)[None]])
        arms = (frames[self.carriers] @ self.places[..., None])[..., 0]
        return pose, np.concatenate([pose.origins, np.zeros((1, 3))])[self.carriers] + arms, arms

    def velocities(self, pose: Pose, arms: Array, velocity: Array) -> Array:
        """Return the velocities of the nodes, (node, 3)."""
        moves, turns = (
            np.concatenate([values, np.zeros((1, 3))])[self.carriers] for values in self.placement.rates(pose, velocity)
        )
        return moves + row_cross(turns, arms)

    def most_moved(self, shift: Array) -> float:
        """Return an upper bound of the motion of any node for a change of the position, or a velocity, (position,).

        It is infinite if bodies turn freely.
        """
        if len(self.placement.free):
            return np.inf
        slides = self.placement.slides
        slid = float(np.abs(shift[slides[slides >= 0]]).max(initial=0.0)) * math.sqrt(3)
        return slid + float(np.abs(shift[self.placement.hinges]) @ self.levers)

    def loads(self, pose: Pose, arms: Array, forces: Array) -> Array:
        """Return the generalised forces of forces on the nodes, (dof,)."""
        count = len(self.placement.parents) + 1
        pushes, torques = np.zeros((2, count, 3))
        np.add.at(pushes, self.carriers, forces)
        np.add.at(torques, self.carriers, row_cross(arms, forces))
        return self.placement.loads(pose, pushes[:-1], torques[:-1])


def touching_of(model: Model) -> Touching | None:
    """Return the parts of a structure that touch; None if the structure has no such parts, or no contact."""
    structure, contact = model.in_units, model.in_units.contact
    parts = None if contact is None else touching_parts(structure, contact)
    if parts is None or contact is None:
        return None
    placement = placement_of(structure)
    points = [structure.points[point] for point in parts.points.tolist()]
    carriers = np.array([point.body if point.body >= 0 else len(structure.bodies) for point in points], dtype=np.int64)
    touching = Touching(
        parts=parts,
        contact=contact,
        placement=placement,
        carriers=carriers,
        places=np.array([point.place for point in points]),
        mobilities=np.zeros(len(points)),
        levers=np.zeros(0),
        skin=0.0,
        timestep=model.timestep,
        engine=model.engine,
        explicit=model.explicit,
    )
    _, places, _ = touching.nodes(np.array(model.engine.qpos0))
    ends = places[parts.sides]
    length = float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).mean())
    return replace(
        touching,
        mobilities=_mobilities(touching),
        levers=_levers(touching),
        skin=max(_SKINS[0] * contact.thickness, _SKINS[1] * length),
    )


def _levers(touching: Touching) -> Array:
    """Return the largest distance of a node from the axis of each joint in any shape, (joint,)."""
    placement = touching.placement
    radii = np.zeros(len(placement.parents) + 1)
    np.maximum.at(radii, touching.carriers, np.linalg.norm(touching.places, axis=1))
    for level in reversed(placement.levels[1:]):
        reach = np.linalg.norm(placement.positions[level], axis=1) + radii[level]
        np.maximum.at(radii, placement.parents[level], reach)
    return radii[placement.hinged]


def check_start(model: Model) -> None:
    """Reject parts that cross or overlap at the start, because contact would push them apart and supply energy.

    Raises:
        InputError: the message names two parts and gives the largest thickness.
    """
    touching = touching_of(model)
    if touching is None:
        return
    parts = touching.parts
    _, places, _ = touching.nodes(start_position(model))
    for one, other in parts_that_cross(parts, places):
        raise _crossing_error(parts, one, other)
    pairs = near_pairs(parts, places, 0.0)
    distances = pairs.nearest(places).distances
    overlaps = pairs.thickness - distances
    if not (overlaps > _ROUNDING * pairs.thickness).any():
        return
    worst = int(np.argmax(overlaps))
    one, other = pairs.parts[worst].tolist()
    if distances[worst] < _ROUNDING * pairs.thickness[worst]:
        raise _crossing_error(parts, one, other)
    halves = parts.half[[one, other]]
    thickness = 2 * float(halves[1])
    # if the other part is a bar, which keeps its diameter, the facet alone becomes thinner
    most = thickness - float(overlaps[worst]) * (1 if halves[0] == halves[1] else 2)
    need, got = (show_quantity(model.units.length * size, SMALL_LENGTH) for size in (most, thickness))
    room = f"need <= {need}" if most > 0 else "need parts that are further apart"
    names = f"{parts.names[one]} and {parts.names[other]}"
    raise InputError(f"contact.thickness: {names} are nearer than that at the start: {room}, got {got}")


def _crossing_error(parts: TouchingParts, one: int, other: int) -> InputError:
    """Return the error that two parts cross at the start."""
    return InputError(
        f"protocol.contact: {parts.names[one]} and {parts.names[other]} pass through each other at the start: need a"
        " start without crossings, or false"
    )


def overlap_doubt(contact: Contact, overlap: float) -> str:
    """Return why a run in which parts overlapped by a share of their thickness is unreliable; empty for a small one."""
    if overlap <= _LARGEST_OVERLAP:
        return ""
    return (
        f"parts that touch overlap by {100 * overlap:.0f} % of their thickness, so that they may have passed through"
        f" each other: need a contact.time_constant shorter than {show_value(contact.stops.time_constant, 's')} and a"
        " timestep that resolves it"
    )


def _mobilities(touching: Touching) -> Array:
    """Compute the largest acceleration of each node in any direction per force on it, as built, (node,)."""
    engine, placement = touching.engine, touching.placement
    data = mujoco.MjData(engine)
    mujoco.mj_forward(engine, data)
    inertia = np.zeros((engine.nv, engine.nv))
    mujoco.mj_fullM(engine, data, inertia)
    if not len(placement.hinged) and not len(placement.free):
        # nodes that slide move independently
        free = np.append(placement.velocities, -1)[placement.slides]
        masses = np.append(np.diag(inertia), np.inf)[free]
        return np.append((1 / masses).max(axis=1), 0.0)[touching.carriers]
    pose, _, arms = touching.nodes(np.array(engine.qpos0))
    moves, turns = (
        np.concatenate([values, np.zeros((engine.nv, 1, 3))], axis=1)[:, touching.carriers]
        for values in placement.rates(pose, np.eye(engine.nv))
    )
    shifts = (moves + row_cross(turns, arms)).transpose(1, 0, 2)
    answers = np.linalg.solve(inertia, shifts.transpose(1, 0, 2).reshape(engine.nv, -1)).reshape(engine.nv, -1, 3)
    return np.linalg.eigvalsh(shifts.transpose(0, 2, 1) @ answers.transpose(1, 0, 2))[:, -1]


@dataclass(kw_only=True, eq=False)
class _Neighbours:
    """Listed pairs of one structure.

    Attributes:
        listed_at: positions of the nodes when the pairs were listed, (node, 3).
        pairs: the pairs.
        known_at: positions of the nodes when their distances were last computed, (node, 3).
        position: position of the engine at that moment, (position,).
        slack: distance by which every node could then move without touching.
    """

    listed_at: Array
    pairs: Pairs
    known_at: Array
    position: Array
    slack: float = 0.0


class ContactForces:
    """Contact forces on structures of one topology.

    The law of a pair at a distance d of its middle surfaces, with touching distance t and s = 1 - d / t > 0, is that of
    `Stops` for slight overlaps: the energy is k t^2 (-s - ln(1 - s)) with k = m / (T zeta)^2, its force k t s / (1 - s)
    grows without bound as middle surfaces approach each other. The damper has the constant 2 m / T. 1 / m is the sum of
    the mobilities of both shapes. The force never pulls. Friction is that of Coulomb; below its limit it is a damper
    with the same constant. Where n pairs push one body, dampers have the factor 1 / sqrt(n), so that the damping ratio
    stays the same.
    """

    def __init__(self, models: Sequence[Model]) -> None:
        """Prepare for structures in their start states."""
        self._touching = [touching for model in models if (touching := touching_of(model)) is not None]
        self._neighbours: dict[int, _Neighbours] = {}

    def forces(self, rows: Indices, position: Array, velocity: Array) -> tuple[Array, Array, int]:
        """Compute the generalised forces on structures, and the number of steps for which they hold.

        Args:
            rows: numbers of the structures.
            position: of the engine, (structure, position).
            velocity: of the engine, (structure, dof).

        Returns:
            Forces, (structure, dof), largest overlaps as shares of the thickness, (structure,), and the number of
            steps: 1 where something touches, else an estimate of the number of steps until something touches, which
            `apart` checks.
        """
        forces, overlaps, steps = np.zeros_like(velocity), np.zeros(len(rows)), _MANY
        for place, row in enumerate(rows.tolist()):
            # a diverging structure has no distances
            if np.isfinite(position[place]).all() and np.isfinite(velocity[place]).all():
                overlaps[place], count = self._push(row, position[place], velocity[place], forces[place])
                steps = min(steps, count)
        return forces, overlaps, steps

    def apart(self, rows: Indices, position: Array) -> bool:
        """Return whether nothing touched since the last call of `forces`, in which nothing touched.

        Args:
            rows: numbers of the structures.
            position: present positions of the engine, (structure, position).
        """
        for place, row in enumerate(rows.tolist()):
            near = self._neighbours.get(row)
            if near is not None and np.isfinite(position[place]).all():
                if self._touching[row].most_moved(position[place] - near.position) <= near.slack:
                    continue
                _, places, _ = self._touching[row].nodes(position[place])
                if _largest(places - near.known_at) > near.slack:
                    return False
        return True

    def _push(self, row: int, position: Array, velocity: Array, forces: Array) -> tuple[float, int]:
        """Add the forces on one structure, (dof,); return its overlap and the number of steps for which they hold."""
        touching, near = self._touching[row], self._neighbours.get(row)
        if near is not None and near.slack:
            left = near.slack - touching.most_moved(position - near.position)
            step = _FASTER * touching.most_moved(self._rates(row, velocity)) * touching.timestep
            if left > step:
                return 0.0, int(min(left / step, _MANY)) if step else _MANY
        if touching.explicit:
            position = position.copy()
            mujoco.mj_integratePos(touching.engine, position, velocity, touching.timestep / 2)
        pose, places, arms = touching.nodes(position)
        near = self._near(row, places)
        nearest = near.pairs.nearest(places)
        overlaps = near.pairs.thickness - nearest.distances
        speeds = touching.velocities(pose, arms, velocity)
        active, step = overlaps > 0, _FASTER * _largest(speeds) * touching.timestep
        deepest = float((overlaps / near.pairs.thickness).max(initial=0.0))
        gap = -float(overlaps.max(initial=-np.inf))
        if step > near.pairs.thickness.min(initial=np.inf) and gap < step:
            # parts could pass through each other within a step
            deepest = max(deepest, 1.0)
        if active.any():
            near.slack = 0.0
            pushes = _pushes(touching, near.pairs.some(active), nearest.some(active), places, speeds)
            forces += touching.loads(pose, arms, pushes)
            return deepest, 1
        clear = min(gap, touching.skin - 2 * _largest(places - near.listed_at))
        near.known_at, near.position, near.slack = places, position, clear / 2
        return deepest, max(1, int(min(near.slack / step, _MANY))) if step else _MANY

    def _rates(self, row: int, velocity: Array) -> Array:
        """Return the rates of the numbers of a position, where no body turns freely, (position,)."""
        return velocity[self._touching[row].placement.velocities]

    def _near(self, row: int, places: Array) -> _Neighbours:
        """Return the listed pairs of a structure; list them again if nodes have moved far."""
        touching, near = self._touching[row], self._neighbours.get(row)
        if near is None or 2 * _largest(places - near.listed_at) >= touching.skin:
            pairs = near_pairs(touching.parts, places, touching.skin)
            near = self._neighbours[row] = _Neighbours(
                listed_at=places, pairs=pairs, known_at=places, position=np.zeros(0)
            )
        return near


def _pushes(touching: Touching, pairs: Pairs, nearest: Nearest, places: Array, speeds: Array) -> Array:
    """Compute the forces of touching pairs on all nodes, (node, 3).

    Args:
        touching: the structure.
        pairs: pairs that touch.
        nearest: their nearest points.
        places: positions of all nodes, (node, 3).
        speeds: velocities of all nodes, (node, 3).
    """
    contact, nodes = touching.contact, pairs.nodes
    weights, normals = nearest.weights, nearest.normals
    first = np.where(np.arange(4) < np.where(np.arange(len(nodes)) < pairs.of_triangles, 1, 2)[:, None], 1, 0)
    on_nodes = touching.mobilities[nodes]
    mobility = np.where(first, on_nodes, 0).max(axis=1) + np.where(first, 0, on_nodes).max(axis=1)
    mass = 1 / np.maximum(mobility, np.finfo(float).tiny)
    mass[mobility <= 0] = 0.0
    energy, push = _law(mass, 1 - nearest.distances / pairs.thickness, pairs.thickness, contact)
    # parallel sides have no definite nearest points
    faded, gradient = _fading(pairs, places)
    moving = np.einsum("pk,pkx->px", weights, speeds[nodes])
    along = np.einsum("px,px->p", moving, normals)
    damper = faded * 2 * mass / contact.stops.time_constant / np.sqrt(_crowd(touching, nodes, weights))
    total = np.maximum(faded * push - damper * along, 0.0)
    vectors = total[:, None] * normals
    if contact.friction:
        sliding = moving - along[:, None] * normals
        speed = np.linalg.norm(sliding, axis=1)
        resistance = np.minimum(damper, contact.friction * total / np.maximum(speed, np.finfo(float).tiny))
        vectors = vectors - resistance[:, None] * sliding
    shares = weights[:, :, None] * vectors[:, None] - energy[:, None, None] * gradient
    pushes = np.zeros_like(places)
    np.add.at(pushes, nodes, shares)
    return pushes


def _law(mass: Array, depth: Array, thickness: Array, contact: Contact) -> tuple[Array, Array]:
    """Return energies and forces of pairs, (pair,), for overlaps `depth` as shares of the thickness."""
    stiffness = mass / (contact.stops.time_constant * contact.stops.damping_ratio) ** 2
    within = np.minimum(depth, _DEEPEST)
    beyond = depth - within
    push = within / (1 - within) + beyond / (1 - _DEEPEST) ** 2
    energy = -within - np.log1p(-within) + beyond * (within / (1 - within) + beyond / (2 * (1 - _DEEPEST) ** 2))
    return stiffness * thickness**2 * energy, stiffness * thickness * push


def _fading(pairs: Pairs, places: Array) -> tuple[Array, Array]:
    """Return the share of the contact of pairs that acts, (pair,), and its gradient by the corners, (pair, 4, 3)."""
    share, gradient = np.ones(len(pairs.nodes)), np.zeros((len(pairs.nodes), 4, 3))
    if pairs.of_triangles == len(pairs.nodes):
        return share, gradient
    square, slope = crossing_share(places[pairs.nodes[pairs.of_triangles :]])
    relative = np.minimum(square / _PARALLEL, 1.0)
    share[pairs.of_triangles :] = relative * (2 - relative)
    gradient[pairs.of_triangles :] = (2 * (1 - relative) / _PARALLEL)[:, None, None] * slope
    return share, gradient


def _crowd(touching: Touching, nodes: Indices, weights: Array) -> Indices:
    """Return for each pair the largest number of pairs that push one of its bodies, (pair,)."""
    bodies = touching.carriers[nodes]
    pushed = np.zeros((len(nodes), len(touching.placement.parents) + 1), dtype=bool)
    np.logical_or.at(pushed, (np.arange(len(nodes))[:, None], bodies), weights != 0)
    pushed[:, -1] = False
    counts = pushed.sum(axis=0)
    crowd: Indices = np.maximum(np.where(weights != 0, counts[bodies], 1).max(axis=1), 1)
    return crowd


def _largest(vectors: Array) -> float:
    """Return the length of the longest vector, (vector, 3)."""
    return float(np.sqrt(np.einsum("vx,vx->v", vectors, vectors).max(initial=0.0)))
