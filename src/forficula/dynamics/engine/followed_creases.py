"""Creases whose numbers in the engine are computed every few steps: between flaps, and joints that remember.

The engine's spring of a joint is linear. Every few steps it receives a new stiffness and a new rest angle, so that its
moment and its slope at the present angle are those of the joint's law.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import mujoco
import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics.energies.crease_moments import CreaseMoments, Past, crease_moments
from forficula.dynamics.energies.creases import engine_rows
from forficula.dynamics.engine.crease_rows import CreaseRows, crease_rows
from forficula.dynamics.engine.model import Model
from forficula.dynamics.engine.plate_creases import PlateRows, plate_rows

# least slope of a spring, as a share of its stiffness: its rest angle is then far away, without loss of accuracy
_LEAST = 1e-9


@dataclass(frozen=True, kw_only=True)
class JointSprings:
    """Joints that remember, of structures of one topology, side by side.

    Attributes:
        joints: indices of the joints in the engine's model, (joint,).
        positions: their indices in the engine's positions, (joint,).
        moments: of the joints.
    """

    joints: Indices
    positions: Indices
    moments: CreaseMoments

    def follow(self, positions: Array, efforts: Array, past: Past) -> tuple[Array, Array, Array]:
        """Compute the angles of joints, and springs with their moments and slopes at these angles.

        Args:
            positions: of the structures, (structure, position).
            efforts: settings of the motors, (structure, motor).
            past: of the joints.

        Returns:
            Angles in own senses, rad, (structure, joint), memory, (slot, structure, joint), and stiffnesses and rest
            angles of the engine's springs, (structure, 2, joint).
        """
        moments = self.moments
        angles = moments.senses * positions[:, self.positions]
        moment, slope, memory = moments.at(angles, np.zeros_like(angles), efforts, past)
        least = _LEAST * (np.asarray(moments.law.stiffness) + np.sum(moments.law.branch_stiffness, axis=-1))
        slope = np.where(np.abs(slope) < least, least, slope)
        shift = np.divide(moment, slope, out=np.zeros_like(moment), where=slope != 0)
        return angles, memory, np.stack([slope, moments.senses * (angles - shift)], axis=1)


@dataclass(frozen=True, kw_only=True)
class FollowedCreases:
    """The creases of structures of one topology whose numbers in the engine are computed every few steps.

    Attributes:
        rows: creases between flaps, which come first; None without them.
        springs: joints that remember; None without them.
    """

    rows: CreaseRows | PlateRows | None
    springs: JointSprings | None

    def some(self, which: Indices) -> FollowedCreases:
        """Select structures by index, in ascending order."""
        rows, springs = self.rows, self.springs
        return FollowedCreases(
            rows=None if rows is None else rows.some(which),
            springs=None if springs is None else replace(springs, moments=springs.moments.some(which)),
        )

    def update(
        self, engines: Sequence[mujoco.MjModel], positions: Array, velocities: Array, efforts: Array, past: Past
    ) -> tuple[Array, Array]:
        """Change the numbers of the engine's models for states of their structures.

        Args:
            engines: models of the structures.
            positions: (structure, position).
            velocities: (structure, dof).
            efforts: settings of the motors, (structure, motor).
            past: of the creases.

        Returns:
            Angles of the creases, rad, (structure, crease), and their memory, (slot, structure, crease).
        """
        count = past.angles.shape[1] - (0 if self.springs is None else len(self.springs.joints))
        parts: list[tuple[Array, Array]] = []
        if self.rows is not None:
            angles, memory, values = self.rows.follow(positions, velocities, efforts, past.some(slice(count)))
            for engine, numbers in zip(engines, values, strict=True):
                engine_rows(engine)[self.rows.rows] = numbers
            parts.append((angles, memory))
        if self.springs is not None:
            angles, memory, values = self.springs.follow(positions, efforts, past.some(slice(count, None)))
            for engine, (stiffness, rest) in zip(engines, values, strict=True):
                engine.jnt_stiffness[self.springs.joints] = stiffness.reshape(-1, *engine.jnt_stiffness.shape[1:])
                engine.qpos_spring[self.springs.positions] = rest
            parts.append((angles, memory))
        if len(parts) == 1:
            return parts[0]
        angles, memory = (np.concatenate(pieces, axis=-1) for pieces in zip(*parts, strict=True))
        return angles, memory


def followed_creases(models: Sequence[Model]) -> FollowedCreases | None:
    """Collect the creases of structures of one topology side by side; None if there are none."""
    creases, engine = models[0].creases, models[0].engine
    if creases is None:
        return None
    rows = crease_rows(models) if models[0].folds.placement is None else plate_rows(models)
    joints = creases.joints[creases.joints >= 0]
    if not len(joints):
        return FollowedCreases(rows=rows, springs=None)
    return FollowedCreases(
        rows=rows,
        springs=JointSprings(
            joints=joints,
            positions=np.asarray(engine.jnt_qposadr[joints], dtype=np.int64),
            moments=crease_moments(models, joints=True),
        ),
    )
