"""Poses and rates of bodies that turn, from the engine's positions and velocities."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from forficula.arrays import Array, Indices
from forficula.structure import GROUND, Structure


class Pose(NamedTuple):
    """Pose of a tree of bodies in the axes of the ground.

    Attributes:
        origins: of bodies, (..., body, 3).
        frames: rotations from bodies' axes to the ground's, (..., body, 3, 3).
        axes: unit vectors of joints, (..., joint, 3).
    """

    origins: Array
    frames: Array
    axes: Array


@dataclass(frozen=True, kw_only=True)
class Placement:
    """A tree of bodies. Bodies turn freely or by joints. Constants may have leading dimensions.

    Attributes:
        levels: numbers of the bodies on the ground, of their children, and so on.
        parents: number of the parent of each body, (body,); -1 for the ground.
        positions: of origins in the axes of parents, (..., body, 3); 0 for bodies that turn freely.
        frames: from their axes to those of their parents, (..., body, 3, 3).
        slides: index of the coordinates of origins in the positions, (body, 3); -1 for held ones.
        free: bodies that turn freely, (free,).
        quaternions: index of their first number in the positions, (free,).
        hinged: number of the body that each joint turns, (joint,), joints in the order of the structure.
        rounds: indices of the first joints of bodies, of their second joints, and so on.
        hinges: index of the joint's angle in the positions, (joint,).
        axes: of the joints in the axes of the body, (..., joint, 3).
        built: angles of the joints in the built shape, (..., joint).
        position_count: length of a position.
        velocity_count: length of a velocity: one less for every body that turns freely.
        velocities: index in the velocities for each index in the positions, (position,); for a quaternion, the index of
            the first of three turns about the body's own axes.
    """

    levels: tuple[Indices, ...]
    parents: Indices
    positions: Array
    frames: Array
    slides: Indices
    free: Indices
    quaternions: Indices
    hinged: Indices
    rounds: tuple[Indices, ...]
    hinges: Indices
    axes: Array
    built: Array
    position_count: int
    velocity_count: int
    velocities: Indices

    def some(self, which: Indices) -> Placement:
        """Select structures of `stacked` by index."""
        return self._moved_to(self.positions[which], self.frames[which], self.axes[which], self.built[which])

    def _moved_to(self, positions: Array, frames: Array, axes: Array, built: Array) -> Placement:
        return replace(self, positions=positions, frames=frames, axes=axes, built=built)

    def poses(self, positions: Array) -> Pose:
        """Compute the pose of all bodies and joints for the engine's positions, (..., position)."""
        lead, count = positions.shape[:-1], len(self.parents)
        held = np.concatenate([positions, np.zeros((*lead, 1))], axis=-1)
        frames = np.broadcast_to(self.frames, (*lead, count, 3, 3)).copy()
        frames[..., self.free, :, :] = _rotations(positions[..., self.quaternions[:, None] + np.arange(4)])
        turns = positions[..., self.hinges] - self.built
        turned = _rotations_about(self.axes, turns)
        axes = np.zeros((*lead, len(self.hinged), 3))
        for which in self.rounds:
            bodies = self.hinged[which]
            frames[..., bodies, :, :] = frames[..., bodies, :, :] @ turned[..., which, :, :]
            axes[..., which, :] = (frames[..., bodies, :, :] @ self.axes[..., which, :, None])[..., 0]
        origins = self.positions + held[..., self.slides]
        for level in self.levels[1:]:
            parents = self.parents[level]
            carried = (frames[..., parents, :, :] @ origins[..., level, :, None])[..., 0]
            origins[..., level, :] = origins[..., parents, :] + carried
            frames[..., level, :, :] = frames[..., parents, :, :] @ frames[..., level, :, :]
        carriers = self.parents[self.hinged]
        moving = carriers != GROUND
        axes[..., moving, :] = (frames[..., carriers[moving], :, :] @ axes[..., moving, :, None])[..., 0]
        return Pose(origins, frames, axes)

    def rates(self, pose: Pose, shifts: Array) -> tuple[Array, Array]:
        """Compute displacements and turns of bodies in the axes of the ground for small shifts, (..., body, 3) each.

        Args:
            pose: from `poses`.
            shifts: in the coordinates of velocities, (..., velocity).
        """
        origins, frames, axes = pose
        lead, count = shifts.shape[:-1], len(self.parents)
        held = np.concatenate([shifts, np.zeros((*lead, 1))], axis=-1)
        places = np.append(self.velocities, -1)
        moves = held[..., places[self.slides]]
        turns = np.zeros((*lead, count, 3))
        body_turns = shifts[..., self.velocities[self.quaternions][:, None] + np.arange(3)]
        turns[..., self.free, :] = (frames[..., self.free, :, :] @ body_turns[..., None])[..., 0]
        about = axes * shifts[..., self.velocities[self.hinges]][..., None]
        for which in self.rounds:
            turns[..., self.hinged[which], :] += about[..., which, :]
        for level in self.levels[1:]:
            parents = self.parents[level]
            arms = origins[..., level, :] - origins[..., parents, :]
            moves[..., level, :] = moves[..., parents, :] + np.cross(turns[..., parents, :], arms)
            turns[..., level, :] += turns[..., parents, :]
        return moves, turns

    def loads(self, pose: Pose, forces: Array, torques: Array) -> Array:
        """Compute generalised forces of forces at the origins of bodies, the transpose of `rates`, (velocity,).

        Args:
            pose: one pose from `poses`.
            forces: in the axes of the ground, (body, 3).
            torques: about the origins of the bodies, (body, 3).
        """
        forces, torques = forces.copy(), torques.copy()
        for level in reversed(self.levels[1:]):
            parents = self.parents[level]
            carried = torques[level] + np.cross(pose.origins[level] - pose.origins[parents], forces[level])
            np.add.at(forces, parents, forces[level])
            np.add.at(torques, parents, carried)
        loads = np.zeros(self.velocity_count + 1)
        loads[np.append(self.velocities, -1)[self.slides]] = forces
        turns = (np.swapaxes(pose.frames[self.free], -1, -2) @ torques[self.free, :, None])[..., 0]
        loads[self.velocities[self.quaternions][:, None] + np.arange(3)] = turns
        loads[self.velocities[self.hinges]] = np.sum(pose.axes * torques[self.hinged], axis=1)
        return loads[:-1]


def stacked(placements: Sequence[Placement]) -> Placement:
    """Combine placements of structures of one topology; constants get a leading dimension, (structure, ...)."""
    return placements[0]._moved_to(
        np.array([placement.positions for placement in placements]),
        np.array([placement.frames for placement in placements]),
        np.array([placement.axes for placement in placements]),
        np.array([placement.built for placement in placements]),
    )


def placement_of(structure: Structure) -> Placement:
    """Lay out the bodies of a structure, in its units, in the engine's order: depth first, as listed."""
    bodies, count = structure.bodies, len(structure.bodies)
    joints: dict[int, list[int]] = {}
    turned = [hinge for hinge in structure.hinges if not hinge.flaps]
    for number, hinge in enumerate(turned):
        joints.setdefault(hinge.body, []).append(number)
    slides = np.full((count, 3), -1, dtype=np.int64)
    free, quaternions, velocities = (list[int]() for _ in range(3))
    hinges = np.zeros(len(turned), dtype=np.int64)
    depth = np.zeros(count, dtype=np.int64)
    for number, body in enumerate(bodies):
        depth[number] = 0 if body.parent == GROUND else depth[body.parent] + 1
    velocity = 0
    for number in _depth_first(structure):
        body = bodies[number]
        for axis in body.slides:
            slides[number, axis] = len(velocities)
            velocities.append(velocity)
            velocity += 1
        if body.turns:
            free.append(number)
            quaternions.append(len(velocities))
            velocities += [velocity] * 4
            velocity += 3
        for joint in joints.get(number, ()):
            hinges[joint] = len(velocities)
            velocities.append(velocity)
            velocity += 1
    most = max(map(len, joints.values()), default=0)
    return Placement(
        levels=tuple(np.flatnonzero(depth == level) for level in range(int(depth.max(initial=0)) + 1)),
        parents=np.array([body.parent for body in bodies], dtype=np.int64),
        positions=np.array([np.zeros(3) if body.turns else body.position for body in bodies]),
        frames=np.array([body.frame for body in bodies]),
        slides=slides,
        free=np.array(free, dtype=np.int64),
        quaternions=np.array(quaternions, dtype=np.int64),
        hinged=np.array([hinge.body for hinge in turned], dtype=np.int64),
        rounds=tuple(
            np.array([numbers[place] for numbers in joints.values() if len(numbers) > place], dtype=np.int64)
            for place in range(most)
        ),
        hinges=hinges,
        axes=np.array([hinge.axis for hinge in turned]).reshape(-1, 3),
        built=np.array([hinge.sense * hinge.built for hinge in turned]),
        position_count=len(velocities),
        velocity_count=velocity,
        velocities=np.array(velocities, dtype=np.int64),
    )


def _depth_first(structure: Structure) -> list[int]:
    """Return the numbers of the bodies depth first, children of a body in the order in which they are listed."""
    children: dict[int, list[int]] = {}
    for number, body in enumerate(structure.bodies):
        children.setdefault(body.parent, []).append(number)
    order, left = list[int](), list(reversed(children.get(GROUND, [])))
    while left:
        order.append(left.pop())
        left += reversed(children.get(order[-1], []))
    return order


def _rotations(quaternions: Array) -> Array:
    """Return rotation matrices, (..., 3, 3), of unit quaternions, real part first, (..., 4)."""
    w, x, y, z = np.moveaxis(quaternions, -1, 0)
    rows = [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))


def _rotations_about(axes: Array, angles: Array) -> Array:
    """Return rotations about unit axes, (..., 3, 3) (Rodrigues)."""
    x, y, z = np.moveaxis(axes, -1, 0)
    none = np.zeros_like(x)
    across = np.moveaxis(np.array([[none, -z, y], [z, none, -x], [-y, x, none]]), (0, 1), (-2, -1))
    angles = angles[..., None, None]
    return np.asarray(np.eye(3) + np.sin(angles) * across + (1 - np.cos(angles)) * (across @ across))
