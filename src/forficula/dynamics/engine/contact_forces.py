"""Contact forces between facets, plates and bars, as generalised forces on the engine's velocities.

The engine's own contact of flexes is not used for facets: it ignores triangles that share a node, so that facets that
meet at a vertex pass through each other, and parallel triangles that cover each other do not repel.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import mujoco
import numpy as np
from numpy.typing import NDArray

from forficula.arrays import Array, Indices
from forficula.dynamics.engine.contact_geometry import ContactGeometry, contact_geometry
from forficula.structure import Contact
from forficula.structure.contact.distances import Nearest, squared_sines
from forficula.structure.contact.pairs import Pairs, near_pairs

if TYPE_CHECKING:
    from forficula.dynamics.engine.model import Model

# squared sine of the angle of two sides, below which their contact fades, because nodes and triangles replace it
_PARALLEL = 0.01
# share of the thickness up to which the force grows as that of the law; beyond, it grows linearly
_DEEPEST = 15 / 16
# factor on the largest speed in the estimate of the number of steps without contact
_FASTER = 2.0
# largest number of steps without contact
_MANY = 1000


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


@dataclass(frozen=True, kw_only=True, eq=False)
class FrictionSprings:
    """Friction springs of the touching pairs of one structure.

    Attributes:
        nodes: of each pair, (pair, 4).
        anchors: weights of the nodes whose sum is the vector between the ends of each spring, (pair, 4); parts that did
            not slide have the weights of the nearest points at the moment at which they began to touch.
        energy: of all springs, in the model's units.
    """

    nodes: Indices
    anchors: Array
    energy: float = 0.0


# nothing touches
_NO_SPRINGS = FrictionSprings(nodes=np.zeros((0, 4), dtype=np.int64), anchors=np.zeros((0, 4)))


class ContactForces:
    """Contact forces on structures of one topology.

    The law of a pair at a distance d of its middle surfaces, with touching distance t and s = 1 - d / t > 0, is that of
    `Stops` for slight overlaps: the energy is k t^2 (-s - ln(1 - s)) with k = m / (T zeta)^2, its force k t s / (1 - s)
    grows without bound as middle surfaces approach each other. The damper has the constant 2 m / T. 1 / m is the sum of
    the mobilities of both shapes. The force never pulls. Friction is that of Coulomb; below its limit it is a spring
    with the stiffness k and a damper with the same constant (Cundall and Strack 1979). Where n pairs push one body
    that can move, dampers have the factor 1 / sqrt(n), so that the damping ratio stays the same.

    Attributes:
        friction_springs: `FrictionSprings` of each structure at the last computed forces, (structure,).
    """

    def __init__(self, models: Sequence[Model]) -> None:
        """Prepare for structures in their start states."""
        self._geometries = [geometry for model in models if (geometry := contact_geometry(model)) is not None]
        self._neighbours: dict[int, _Neighbours] = {}
        self.friction_springs: NDArray[np.object_] = np.full(len(models), _NO_SPRINGS, dtype=object)

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
                if self._geometries[row].most_moved(position[place] - near.position) <= near.slack:
                    continue
                _, places, _ = self._geometries[row].nodes(position[place])
                if _largest(places - near.known_at) > near.slack:
                    return False
        return True

    def _push(self, row: int, position: Array, velocity: Array, forces: Array) -> tuple[float, int]:
        """Add the forces on one structure, (dof,); return its overlap and the number of steps for which they hold."""
        geometry, near = self._geometries[row], self._neighbours.get(row)
        if near is not None and near.slack:
            left = near.slack - geometry.most_moved(position - near.position)
            step = _FASTER * geometry.most_moved(self._rates(row, velocity)) * geometry.timestep
            if left > step:
                self.friction_springs[row] = _NO_SPRINGS
                return 0.0, int(min(left / step, _MANY)) if step else _MANY
        if geometry.explicit:
            position = position.copy()
            mujoco.mj_integratePos(geometry.engine, position, velocity, geometry.timestep / 2)
        pose, places, arms = geometry.nodes(position)
        near = self._near(row, places)
        nearest = near.pairs.nearest(places)
        overlaps = near.pairs.thickness - nearest.distances
        speeds = geometry.velocities(pose, arms, velocity)
        active, step = overlaps > 0, _FASTER * _largest(speeds) * geometry.timestep
        deepest = float((overlaps / near.pairs.thickness).max(initial=0.0))
        gap = -float(overlaps.max(initial=-np.inf))
        if step > near.pairs.thickness.min(initial=np.inf) and gap < step:
            # parts could pass through each other within a step
            deepest = max(deepest, 1.0)
        if active.any():
            near.slack = 0.0
            touching = near.pairs.some(active), nearest.some(active)
            pushes, self.friction_springs[row] = _pushes(
                geometry, *touching, places, speeds, self.friction_springs[row]
            )
            forces += geometry.loads(pose, arms, pushes)
            return deepest, 1
        self.friction_springs[row] = _NO_SPRINGS
        clear = min(gap, geometry.skin - 2 * _largest(places - near.listed_at))
        near.known_at, near.position, near.slack = places, position, clear / 2
        return deepest, max(1, int(min(near.slack / step, _MANY))) if step else _MANY

    def _rates(self, row: int, velocity: Array) -> Array:
        """Return the rates of the numbers of a position, where no body turns freely, (position,)."""
        return velocity[self._geometries[row].placement.velocities]

    def _near(self, row: int, places: Array) -> _Neighbours:
        """Return the listed pairs of a structure; list them again if nodes have moved far."""
        geometry, near = self._geometries[row], self._neighbours.get(row)
        if near is None or 2 * _largest(places - near.listed_at) >= geometry.skin:
            pairs = near_pairs(geometry.parts, places, geometry.skin)
            near = self._neighbours[row] = _Neighbours(
                listed_at=places, pairs=pairs, known_at=places, position=np.zeros(0)
            )
        return near


def _pushes(
    geometry: ContactGeometry, pairs: Pairs, nearest: Nearest, places: Array, speeds: Array, springs: FrictionSprings
) -> tuple[Array, FrictionSprings]:
    """Compute the forces of touching pairs on all nodes, (node, 3), and their friction springs.

    Args:
        geometry: the structure.
        pairs: pairs that touch.
        nearest: their nearest points.
        places: positions of all nodes, (node, 3).
        speeds: velocities of all nodes, (node, 3).
        springs: friction springs so far.
    """
    contact, nodes = geometry.contact, pairs.nodes
    weights, normals = nearest.weights, nearest.normals
    first = np.where(np.arange(4) < np.where(np.arange(len(nodes)) < pairs.of_triangles, 1, 2)[:, None], 1, 0)
    on_nodes = geometry.mobilities[nodes]
    mobility = np.where(first, on_nodes, 0).max(axis=1) + np.where(first, 0, on_nodes).max(axis=1)
    mass = 1 / np.maximum(mobility, np.finfo(float).tiny)
    mass[mobility <= 0] = 0.0
    energy, push = _law(mass, 1 - nearest.distances / pairs.thickness, pairs.thickness, contact)
    # parallel sides have no definite nearest points
    faded, gradient = _fading(pairs, places)
    moving = np.einsum("pk,pkx->px", weights, speeds[nodes])
    along = np.einsum("px,px->p", moving, normals)
    damper = faded * 2 * mass / contact.stops.time_constant / np.sqrt(_crowd(geometry, nodes, weights))
    total = np.maximum(faded * push - damper * along, 0.0)
    vectors = total[:, None] * normals
    shares = weights[:, :, None] * vectors[:, None] - energy[:, None, None] * gradient
    if contact.friction:
        stiffness = faded * mass / (contact.stops.time_constant * contact.stops.damping_ratio) ** 2
        sliding = moving - along[:, None] * normals
        held, springs = _friction(pairs, nearest, places, stiffness, damper, sliding, contact.friction * total, springs)
        shares = shares + held
    pushes = np.zeros_like(places)
    np.add.at(pushes, nodes, shares)
    return pushes, springs


def _friction(
    pairs: Pairs,
    nearest: Nearest,
    places: Array,
    stiffness: Array,
    damper: Array,
    sliding: Array,
    limit: Array,
    springs: FrictionSprings,
) -> tuple[Array, FrictionSprings]:
    """Compute the forces of friction on the nodes of touching pairs, (pair, 4, 3), and the springs afterwards.

    The ends of a spring are points of both shapes. Where its force exceeds the limit, these points slide towards the
    nearest points. The forces have no resultant and no moment.

    Args:
        pairs: pairs that touch.
        nearest: their nearest points.
        places: positions of all nodes, (node, 3).
        stiffness: of the spring of each pair, (pair,).
        damper: constant of the damper of each pair, (pair,).
        sliding: velocity of the first shape along the second one, (pair, 3).
        limit: of the force of each pair, (pair,).
        springs: friction springs so far.
    """
    weights, normals = nearest.weights, nearest.normals
    anchors = _anchors(springs, pairs.nodes, weights)
    stretch = np.einsum("pk,pkx->px", anchors, places[pairs.nodes])
    across = np.einsum("px,px->p", stretch, normals)
    stretch = stretch - across[:, None] * normals
    size = stiffness * np.linalg.norm(stretch, axis=1)
    kept = np.where(size > limit, limit / np.where(size > limit, size, 1.0), 1.0)
    anchors = weights + kept[:, None] * (anchors - weights)
    across = nearest.distances + kept * (across - nearest.distances)
    pull = (kept * stiffness)[:, None] * stretch
    # the largest share of the damper's force with which both together do not exceed the limit
    drag = damper[:, None] * sliding
    square, mixed = (np.einsum("px,px->p", drag, vector) for vector in (drag, pull))
    left = np.maximum(limit**2 - (kept * size) ** 2, 0.0)
    share = (np.sqrt(mixed**2 + square * left) - mixed) / np.maximum(square, np.finfo(float).tiny)
    drag = np.minimum(share, 1.0)[:, None] * drag
    shift = (stiffness * across)[:, None] * normals
    forces = -anchors[:, :, None] * pull[:, None] - (anchors - weights)[:, :, None] * shift[:, None]
    energy = float(np.sum((kept * size) ** 2 / np.maximum(2 * stiffness, np.finfo(float).tiny)))
    return forces - weights[:, :, None] * drag[:, None], FrictionSprings(
        nodes=pairs.nodes, anchors=anchors, energy=energy
    )


def _anchors(springs: FrictionSprings, nodes: Indices, weights: Array) -> Array:
    """Return the weights of the ends of the springs of pairs, (pair, 4); those of the nearest points for new pairs."""
    if np.array_equal(springs.nodes, nodes):
        return springs.anchors
    if not len(springs.nodes):
        return weights
    known = {tuple(pair): place for place, pair in enumerate(springs.nodes.tolist())}
    places = np.array([known.get(tuple(pair), -1) for pair in nodes.tolist()])
    return np.where((places >= 0)[:, None], springs.anchors[places], weights)


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
    square, slope = squared_sines(places[pairs.nodes[pairs.of_triangles :]])
    relative = np.minimum(square / _PARALLEL, 1.0)
    share[pairs.of_triangles :] = relative * (2 - relative)
    gradient[pairs.of_triangles :] = (2 * (1 - relative) / _PARALLEL)[:, None, None] * slope
    return share, gradient


def _crowd(geometry: ContactGeometry, nodes: Indices, weights: Array) -> Indices:
    """Return for each pair the largest number of pairs that push one of its bodies that can move, (pair,)."""
    bodies = geometry.carriers[nodes]
    pushed = np.zeros((len(nodes), len(geometry.placement.parents) + 1), dtype=bool)
    moves = (weights != 0) & (geometry.mobilities[nodes] > 0)
    np.logical_or.at(pushed, (np.arange(len(nodes))[:, None], bodies), moves)
    counts = pushed.sum(axis=0)
    crowd: Indices = np.maximum(np.where(weights != 0, counts[bodies], 1).max(axis=1), 1)
    return crowd


def _largest(vectors: Array) -> float:
    """Return the length of the longest vector, (vector, 3)."""
    return float(np.sqrt(np.einsum("vx,vx->v", vectors, vectors).max(initial=0.0)))
