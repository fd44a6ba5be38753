"""Kinematics of a tree of bodies: poses from hinge angles, and positions, velocities and forces of carried points.

The hinges of a tree are the joints of its structure. Creases between flaps are no hinges of the tree, because the
angles of the joints determine their angles.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Indices
from forficula.structure import GROUND, Structure, joint_count

# indices of parts, as a slice if they are evenly spaced, because numpy then needs no copy
Span = slice | Indices

_UNIT = np.eye(3)
# coordinates of the factors of a cross product, by coordinate of the product
_NEXT, _AFTER_NEXT = np.array([1, 2, 0]), np.array([2, 0, 1])


@dataclass(frozen=True, kw_only=True)
class Level:
    """Bodies at one depth of the tree with the same number of hinges, which are placed together.

    Attributes:
        bodies: their numbers.
        parents: numbers of their parents; None for the ground.
        hinges: numbers of their first hinges, of their second hinges, and so on.
        positions: of their origins in the axes of their parents, m, (body, 3).
        frames: from their axes to those of their parents, (body, 3, 3); None if both are the same.
    """

    bodies: Span
    parents: Span | None
    hinges: tuple[Span, ...]
    positions: Array
    frames: Array | None


@dataclass(frozen=True, kw_only=True)
class Tree:
    """Bodies on hinges.

    Attributes:
        levels: parents before their children.
        chains: hinges that move each body, from the ground on.
        carriers: number of the body that each hinge turns, (hinge,).
        axes: unit vectors of the hinges in the axes of their bodies, in their own senses, (hinge, 3).
        built: angles as built, in own senses, rad, (hinge,).
        spins: cross-product matrices of the axes, (hinge, 3, 3).
        squares: squares of these matrices, (hinge, 3, 3).
        outer: 1 if the hinge of the row turns the axis of the hinge of the column, or is the same hinge, else 0,
            (hinge, hinge).
        further: as `outer`, but 0 for the same hinge, (hinge, hinge).
    """

    levels: tuple[Level, ...]
    chains: tuple[tuple[int, ...], ...]
    carriers: Indices
    axes: Array
    built: Array
    spins: Array
    squares: Array
    outer: Array
    further: Array

    @property
    def size(self) -> int:
        """Return the number of hinges."""
        return len(self.carriers)

    def chain(self, body: int) -> tuple[int, ...]:
        """Return the hinges that move a body, from the ground on; empty for the ground."""
        return () if body == GROUND else self.chains[body]


@dataclass(frozen=True, kw_only=True)
class Carried:
    """Points that bodies carry.

    Attributes:
        bodies: number of the body that carries each point, or GROUND, (point,).
        places: positions in the axes of the body, m, (3, point).
        moved: 1 if a hinge moves a point, else 0, (point, hinge).
        pairs: pairs of a point and a hinge that moves it, one point after another: number of the point, number of the
            hinge, (2, pair).
    """

    bodies: Indices
    places: Array
    moved: Array
    pairs: Indices


@dataclass(frozen=True, kw_only=True)
class Pose:
    """Pose of a tree in space, for some cases side by side.

    Attributes:
        origins: of all bodies, and of the ground, m, (case, body, 3).
        frames: from their axes to those of the ground, (case, body, 3, 3).
        axes: unit vectors of all hinges, in their own senses, (3, case, hinge).
        pivots: points on these axes, m, (3, case, hinge).
    """

    origins: Array
    frames: Array
    axes: Array
    pivots: Array


def span(numbers: Sequence[int] | Indices) -> Span:
    """Return indices as a slice if they are evenly spaced, else as an array."""
    steps = np.unique(np.diff(numbers))
    if len(numbers) and len(steps) <= 1 and (not len(steps) or steps[0] > 0):
        step = int(steps[0]) if len(steps) else 1
        return slice(int(numbers[0]), int(numbers[-1]) + 1, step)
    return np.asarray(numbers, dtype=np.int64)


def tree_of(structure: Structure) -> Tree:
    """Return the tree of a structure."""
    joints = structure.hinges[: joint_count(structure)]
    hinges_of: list[list[int]] = [[] for _ in structure.bodies]
    for number, hinge in enumerate(joints):
        hinges_of[hinge.body].append(number)
    chains: list[tuple[int, ...]] = []
    depths: list[int] = []
    groups: dict[tuple[int, int], list[int]] = {}
    for number, body in enumerate(structure.bodies):
        grounded = body.parent == GROUND
        chains.append((*(() if grounded else chains[body.parent]), *hinges_of[number]))
        depths.append(0 if grounded else depths[body.parent] + 1)
        groups.setdefault((depths[number], len(hinges_of[number])), []).append(number)
    axes = np.array([hinge.sense * hinge.axis for hinge in joints]).reshape(-1, 3)
    spins = np.cross(np.eye(3), axes[:, None, :])
    outer = np.zeros((len(axes), len(axes)))
    for chain in chains:
        for place, inner in enumerate(chain):
            outer[list(chain[: place + 1]), inner] = 1.0
    return Tree(
        levels=tuple(_level(structure, groups[key], hinges_of) for key in sorted(groups)),
        chains=tuple(chains),
        carriers=np.array([hinge.body for hinge in joints], dtype=np.int64),
        axes=axes,
        built=np.array([hinge.built for hinge in joints]),
        spins=spins,
        squares=spins @ spins,
        outer=outer,
        further=np.triu(outer, 1),
    )


def _level(structure: Structure, numbers: list[int], hinges_of: list[list[int]]) -> Level:
    bodies = [structure.bodies[number] for number in numbers]
    frames = np.array([body.frame for body in bodies])
    grounded = bodies[0].parent == GROUND
    return Level(
        bodies=span(numbers),
        parents=None if grounded else span([body.parent for body in bodies]),
        hinges=tuple(span(column) for column in zip(*(hinges_of[number] for number in numbers), strict=True)),
        positions=np.array([body.position for body in bodies]),
        frames=frames if grounded or not np.array_equal(frames, np.broadcast_to(np.eye(3), frames.shape)) else None,
    )


def carried_points(tree: Tree, bodies: Sequence[int] | Indices, places: Array) -> Carried:
    """Return points from the bodies that carry them, or GROUND, and positions in the bodies' axes, m, (point, 3)."""
    moved = np.zeros((len(bodies), tree.size))
    for point, body in enumerate(bodies):
        moved[point, list(tree.chain(int(body)))] = 1.0
    return Carried(
        bodies=np.asarray(bodies, dtype=np.int64),
        places=np.ascontiguousarray(np.asarray(places, dtype=np.float64).reshape(-1, 3).T),
        moved=moved,
        pairs=np.array(np.nonzero(moved), dtype=np.int64),
    )


def pose(tree: Tree, angles: Array) -> Pose:
    """Compute the pose of the bodies.

    Args:
        tree: of bodies.
        angles: of all hinges, in their own senses, rad, (case, hinge); angles of creases may follow and are ignored.
    """
    cases, count = len(angles), len(tree.chains) + 1
    turns = _turned(tree, angles)
    # the last entry is the ground, which has the number -1
    frames, origins = np.empty((cases, count, 3, 3)), np.zeros((cases, count, 3))
    frames[:, GROUND] = _UNIT
    after = np.empty_like(turns)
    for level in tree.levels:
        if level.parents is None:
            current = _UNIT if level.frames is None else level.frames
            origins[:, level.bodies] = level.positions
        else:
            current = frames[:, level.parents]
            origins[:, level.bodies] = origins[:, level.parents] + (current @ level.positions[..., None])[..., 0]
            if level.frames is not None:
                current = current @ level.frames
        for hinges in level.hinges:
            current = current @ turns[:, hinges]
            after[:, hinges] = current
        frames[:, level.bodies] = current
    axes = np.einsum("chij,hj->ich", after, tree.axes)
    pivots = np.ascontiguousarray(origins[:, tree.carriers].transpose(2, 0, 1))
    return Pose(origins=origins, frames=frames, axes=axes, pivots=pivots)


def places_of(carried: Carried, at: Pose) -> Array:
    """Return the positions of carried points, m, (3, case, point)."""
    start = at.origins[:, carried.bodies].transpose(2, 0, 1)
    return np.asarray(start + np.einsum("cpij,jp->icp", at.frames[:, carried.bodies], carried.places))


def moves_of(carried: Carried, at: Pose, places: Array) -> Array:
    """Return the velocities of points per angular speed of the hinges that move them, m, (3, case, pair)."""
    points, hinges = carried.pairs
    axes, arms = at.axes.take(hinges, axis=2), places.take(points, axis=2) - at.pivots.take(hinges, axis=2)
    moves = axes.take(_NEXT, axis=0) * arms.take(_AFTER_NEXT, axis=0)
    moves -= axes.take(_AFTER_NEXT, axis=0) * arms.take(_NEXT, axis=0)
    return np.asarray(moves)


def pulled(tree: Tree, carried: Carried, at: Pose, places: Array, forces: Array) -> tuple[Array, Array]:
    """Convert the gradient of an energy by positions of points into the gradient by the hinges' angles.

    With the arms r from a hinge to the points p that it moves, and K = sum r f^T, the gradient is the hinge's axis
    times sum r x f, the skew part of K. A hinge i also turns the axis a of a hinge j beyond it. This changes the
    velocity a x r, which adds a_i . sum (a x r) x f = a_i . (K - tr K) a to the Hessian.

    Args:
        tree: of bodies.
        carried: the points.
        at: pose of the tree.
        places: positions of the points, m, (3, case, point).
        forces: gradient of the energy by these positions, N, (3, case, point).

    Returns:
        The gradient, N m, (case, hinge), and the part of the Hessian that stems from the curved paths of the points,
        N m/rad, (case, hinge, hinge).
    """
    cases, count = forces.shape[1:]
    parts = np.empty((4, 3, cases, count))
    np.multiply(places[:, None], forces, out=parts[:3])
    parts[3] = forces
    sums = (parts.reshape(12 * cases, count) @ carried.moved).reshape(4, 3, cases, tree.size)
    k, axes = sums[:3] - at.pivots[:, None] * sums[3], at.axes
    slope = axes[0] * (k[1, 2] - k[2, 1]) + axes[1] * (k[2, 0] - k[0, 2]) + axes[2] * (k[0, 1] - k[1, 0])
    bent = np.add.reduce(k * axes, axis=1) - (k[0, 0] + k[1, 1] + k[2, 2]) * axes
    turned = axes.transpose(1, 2, 0) @ bent.transpose(1, 0, 2)
    # pairs of an outer hinge and one that it turns, and the transposed pairs
    curvature = turned * tree.outer
    curvature += (turned * tree.further).swapaxes(1, 2)
    return np.asarray(slope), curvature


def _turned(tree: Tree, angles: Array) -> Array:
    """Return the rotations about the hinges (Rodrigues' formula), (case, hinge, 3, 3)."""
    turned = angles[:, : tree.size] - tree.built
    sine, half = np.sin(turned)[..., None, None], np.sin(turned / 2)[..., None, None]
    return np.asarray(_UNIT + sine * tree.spins + 2 * half**2 * tree.squares)
