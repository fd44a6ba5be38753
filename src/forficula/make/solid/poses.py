"""Positions of bodies in rows of a record, and selection of rows that represent the whole motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics import Record, StageEnd
from forficula.statics.tree.pose import pose, tree_of
from forficula.structure import Structure, built_frames


@dataclass(frozen=True, kw_only=True, eq=False)
class PartPoses:
    """Motions of bodies from their built positions, in some rows of a record.

    Attributes:
        rows: rows of the record, rising, (row,).
        frames: rotations, (row, body + 1, 3, 3); the last body is the ground, which stays.
        origins: translations after the rotations, m, (row, body + 1, 3).
    """

    rows: Indices
    frames: Array
    origins: Array


def poses_of(record: Record, rows: Sequence[int] | Indices) -> PartPoses:
    """Return the positions of the bodies of a tree in rows of a record, from the angles of its hinges."""
    return tree_poses(record.structure, record.series["hinge_angle"][np.asarray(rows)], rows)


def tree_poses(structure: Structure, angles: Array, rows: Sequence[int] | Indices) -> PartPoses:
    """Return the positions of the bodies of a tree at angles of its hinges, in their own senses, rad, (row, hinge)."""
    at = pose(tree_of(structure), angles)
    origins, frames = built_frames(structure)
    origins, frames = np.vstack([origins, np.zeros((1, 3))]), np.concatenate([frames, np.eye(3)[None]])
    turns = at.frames @ np.swapaxes(frames, 1, 2)
    moves = at.origins - np.einsum("rbij,bj->rbi", turns, origins)
    return PartPoses(rows=np.asarray(rows, dtype=np.int64), frames=turns, origins=moves)


def different_rows(record: Record, most: int) -> Indices:
    """Return rows whose poses are as different from each other as possible. Repeated poses are included only once.

    From the first row on, the row whose hinge angles are furthest from all selected rows is added (Gonzalez 1985).

    Args:
        record: record of a run.
        most: largest number of rows.

    Returns:
        Rising.
    """
    angles = record.series["hinge_angle"]
    selected, apart = [0], np.full(len(angles), np.inf)
    while len(selected) < min(most, len(angles)):
        apart = np.minimum(apart, np.abs(angles - angles[selected[-1]]).max(axis=1))
        furthest = int(np.argmax(apart))
        if not apart[furthest] > 0:
            break
        selected.append(furthest)
    return np.array(sorted(selected), dtype=np.int64)


def stage_at(record: Record, time: float) -> StageEnd:
    """Return the stage of a record at a time; at its end, the stage that ends."""
    return next((end for end in record.stages if time <= end.end), record.stages[-1])
