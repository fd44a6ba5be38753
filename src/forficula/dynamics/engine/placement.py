"""Poses and rates of bodies that turn, from the engine's positions and velocities."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array, Indices
from forficula.structure import GROUND, Structure


@dataclass(frozen=True, kw_only=True)
class Placement:
    """A tree of bodies. Some bodies turn freely or by a hinge. Constants may have leading dimensions.

    Attributes:
        levels: numbers of the bodies on the ground, of their children, and so on.
        parents: number of the parent of each body, (body,); -1 for the ground.
        positions: of origins in the axes of parents, (..., body, 3); 0 for bodies that turn freely.
        frames: from their axes to those of their parents, (..., body, 3, 3).
        slides: index of the coordinates of origins in the positions, (body, 3); -1 for held ones.
        free: bodies that turn freely, (free,).
        quaternions: index of their first number in the positions, (free,).
        hinged: bodies that turn by a hinge, (hinged,).
        hinges: index of the hinge's angle in the positions, (hinged,).
        axes: of the hinges in the axes of the body, (..., hinged, 3).
        built: angles of the hinges in the built shape, (..., hinged).
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

    def poses(self, positions: Array) -> tuple[Array, Array]:
        """Compute origins, (..., body, 3), and rotations from bodies' axes to the ground's, (..., body, 3, 3)."""
        lead, count = positions.shape[:-1], len(self.parents)
        held = np.concatenate([positions, np.zeros((*lead, 1))], axis=-1)
        frames = np.broadcast_to(self.frames, (*lead, count, 3, 3)).copy()
        frames[..., self.free, :, :] = _rotations(positions[..., self.quaternions[:, None] + np.arange(4)])
        turns = positions[..., self.hinges] - self.built
        frames[..., self.hinged, :, :] = frames[..., self.hinged, :, :] @ _rotations_about(self.axes, turns)
        origins = self.positions + held[..., self.slides]
        for level in self.levels[1:]:
            parents = self.parents[level]
            carried = (frames[..., parents, :, :] @ origins[..., level, :, None])[..., 0]
            origins[..., level, :] = origins[..., parents, :] + carried
            frames[..., level, :, :] = frames[..., parents, :, :] @ frames[..., level, :, :]
        return origins, frames

    def rates(self, origins: Array, frames: Array, shifts: Array) -> tuple[Array, Array]:
        """Compute displacements and turns of bodies in the axes of the ground for small shifts, (..., body, 3) each.

        Args:
            origins: of bodies, from `poses`.
            frames: of bodies, from `poses`.
            shifts: in the coordinates of velocities, (..., velocity).
        """
        lead, count = shifts.shape[:-1], len(self.parents)
        held = np.concatenate([shifts, np.zeros((*lead, 1))], axis=-1)
        places = np.append(self.velocities, -1)
        moves = held[..., places[self.slides]]
        turns = np.zeros((*lead, count, 3))
        body_turns = shifts[..., self.velocities[self.quaternions][:, None] + np.arange(3)]
        turns[..., self.free, :] = (frames[..., self.free, :, :] @ body_turns[..., None])[..., 0]
        about = (frames[..., self.hinged, :, :] @ self.axes[..., None])[..., 0]
        turns[..., self.hinged, :] = about * shifts[..., self.velocities[self.hinges]][..., None]
        for level in self.levels[1:]:
            parents = self.parents[level]
            arms = origins[..., level, :] - origins[..., parents, :]
            moves[..., level, :] = moves[..., parents, :] + np.cross(turns[..., parents, :], arms)
            turns[..., level, :] += turns[..., parents, :]
        return moves, turns


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
    joints = {hinge.body: hinge for hinge in structure.hinges if not hinge.flaps}
    slides = np.full((count, 3), -1, dtype=np.int64)
    free, quaternions, hinged, hinges, velocities = (list[int]() for _ in range(5))
    depth = np.zeros(count, dtype=np.int64)
    velocity = 0
    for number, body in enumerate(bodies):
        depth[number] = 0 if body.parent == GROUND else depth[body.parent] + 1
        for axis in body.slides:
            slides[number, axis] = len(velocities)
            velocities.append(velocity)
            velocity += 1
        if body.turns:
            free.append(number)
            quaternions.append(len(velocities))
            velocities += [velocity] * 4
            velocity += 3
        if number in joints:
            hinged.append(number)
            hinges.append(len(velocities))
            velocities.append(velocity)
            velocity += 1
    turned = [joints[number] for number in hinged]
    return Placement(
        levels=tuple(np.flatnonzero(depth == level) for level in range(int(depth.max(initial=0)) + 1)),
        parents=np.array([body.parent for body in bodies], dtype=np.int64),
        positions=np.array([np.zeros(3) if body.turns else body.position for body in bodies]),
        frames=np.array([body.frame for body in bodies]),
        slides=slides,
        free=np.array(free, dtype=np.int64),
        quaternions=np.array(quaternions, dtype=np.int64),
        hinged=np.array(hinged, dtype=np.int64),
        hinges=np.array(hinges, dtype=np.int64),
        axes=np.array([hinge.axis for hinge in turned]).reshape(-1, 3),
        built=np.array([hinge.sense * hinge.built for hinge in turned]),
        position_count=len(velocities),
        velocity_count=velocity,
        velocities=np.array(velocities, dtype=np.int64),
    )


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
