"""Where bodies that turn are, and how they move, from the positions and velocities that the engine has."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array, Indices
from forficula.structure import GROUND, Structure


@dataclass(frozen=True, kw_only=True)
class Placement:
    """A tree of bodies of which some turn freely or by a hinge; constants may have leading dimensions.

    Attributes:
        levels: numbers of the bodies on the ground, of those on these, and so on.
        parents: number of the body that each hangs on, (body,); -1 for the ground.
        positions: of origins in the axes of parents, (..., body, 3); 0 of bodies that turn freely.
        frames: from their axes to those of their parents, (..., body, 3, 3).
        slides: place of the coordinates of origins in the positions, (body, 3); -1 where they are held.
        free: which bodies turn freely, (free,).
        quaternions: place of their first number in the positions, (free,).
        hinged: which bodies turn by a hinge, (hinged,).
        hinges: place of its angle in the positions, (hinged,).
        axes: of the hinges in the axes of the body, (..., hinged, 3).
        built: these angles in the built shape, (..., hinged).
        position_count: numbers of a position.
        velocity_count: numbers of a velocity: one less for every body that turns freely.
        velocities: place in the velocities of what is at a place in the positions, (position,); of a quaternion, of the
            three turns about the body's own axes, which come in its place.
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
        """Of some of the structures that `stacked` has put together."""
        return self._with(self.positions[which], self.frames[which], self.axes[which], self.built[which])

    def _with(self, positions: Array, frames: Array, axes: Array, built: Array) -> Placement:
        return replace(self, positions=positions, frames=frames, axes=axes, built=built)

    def poses(self, positions: Array) -> tuple[Array, Array]:
        """Origins, (..., body, 3), and rotations from bodies' axes to those of the ground, (..., body, 3, 3)."""
        lead, count = positions.shape[:-1], len(self.parents)
        held = np.concatenate([positions, np.zeros((*lead, 1))], axis=-1)
        frames = np.broadcast_to(self.frames, (*lead, count, 3, 3)).copy()
        frames[..., self.free, :, :] = _rotations(positions[..., self.quaternions[:, None] + np.arange(4)])
        turns = positions[..., self.hinges] - self.built
        frames[..., self.hinged, :, :] = frames[..., self.hinged, :, :] @ _about(self.axes, turns)
        origins = self.positions + held[..., self.slides]
        for level in self.levels[1:]:
            parents = self.parents[level]
            carried = (frames[..., parents, :, :] @ origins[..., level, :, None])[..., 0]
            origins[..., level, :] = origins[..., parents, :] + carried
            frames[..., level, :, :] = frames[..., parents, :, :] @ frames[..., level, :, :]
        return origins, frames

    def rates(self, origins: Array, frames: Array, shifts: Array) -> tuple[Array, Array]:
        """By how much small shifts move and turn bodies, along and about the axes of the ground, (..., body, 3) each.

        Args:
            origins: of bodies, as of `poses`.
            frames: alike.
            shifts: as velocities have their numbers, (..., velocity).
        """
        lead, count = shifts.shape[:-1], len(self.parents)
        held = np.concatenate([shifts, np.zeros((*lead, 1))], axis=-1)
        places = np.append(self.velocities, -1)
        moves = held[..., places[self.slides]]
        turns = np.zeros((*lead, count, 3))
        own = shifts[..., self.velocities[self.quaternions][:, None] + np.arange(3)]
        turns[..., self.free, :] = (frames[..., self.free, :, :] @ own[..., None])[..., 0]
        about = (frames[..., self.hinged, :, :] @ self.axes[..., None])[..., 0]
        turns[..., self.hinged, :] = about * shifts[..., self.velocities[self.hinges]][..., None]
        for level in self.levels[1:]:
            parents = self.parents[level]
            arms = origins[..., level, :] - origins[..., parents, :]
            moves[..., level, :] = moves[..., parents, :] + np.cross(turns[..., parents, :], arms)
            turns[..., level, :] += turns[..., parents, :]
        return moves, turns


def stacked(placements: Sequence[Placement]) -> Placement:
    """Those of structures of one topology as one, whose constants have a leading dimension, (structure, ...)."""
    return placements[0]._with(
        np.array([each.positions for each in placements]),
        np.array([each.frames for each in placements]),
        np.array([each.axes for each in placements]),
        np.array([each.built for each in placements]),
    )


def placement_of(structure: Structure) -> Placement:
    """Lay out the bodies of a structure, in its units, as the engine does: depth first, as they are listed."""
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
    """Rotations of unit quaternions, real part first, (..., 4), as matrices, (..., 3, 3)."""
    w, x, y, z = np.moveaxis(quaternions, -1, 0)
    rows = [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))


def _about(axes: Array, angles: Array) -> Array:
    """Rotations about unit axes, (..., 3, 3) (Rodrigues)."""
    x, y, z = np.moveaxis(axes, -1, 0)
    none = np.zeros_like(x)
    across = np.moveaxis(np.array([[none, -z, y], [z, none, -x], [-y, x, none]]), (0, 1), (-2, -1))
    angles = angles[..., None, None]
    return np.asarray(np.eye(3) + np.sin(angles) * across + (1 - np.cos(angles)) * (across @ across))
