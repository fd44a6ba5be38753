"""Where bodies are in rows of a record, and which rows tell the whole motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics import Record, StageEnd
from forficula.statics.tree.pose import pose, tree_of
from forficula.structure import built_frames


@dataclass(frozen=True, kw_only=True, eq=False)
class PartPoses:
    """How bodies are placed from where they are built, in some rows of a record.

    Attributes:
        rows: of the record, rising, (row,).
        frames: rotations, (row, body + 1, 3, 3); the last body is the ground, which stays.
        origins: what is added after them, m, (row, body + 1, 3).
    """

    rows: Indices
    frames: Array
    origins: Array


def poses_of(record: Record, rows: Sequence[int] | Indices) -> PartPoses:
    """How the bodies of a tree are placed in rows of a record, from the angles of its hinges."""
    structure = record.structure
    at = pose(tree_of(structure), record.series["hinge_angle"][np.asarray(rows)])
    origins, frames = built_frames(structure)
    origins, frames = np.vstack([origins, np.zeros((1, 3))]), np.concatenate([frames, np.eye(3)[None]])
    turns = at.frames @ np.swapaxes(frames, 1, 2)
    moves = at.origins - np.einsum("rbij,bj->rbi", turns, origins)
    return PartPoses(rows=np.asarray(rows, dtype=np.int64), frames=turns, origins=moves)


def telling_rows(record: Record, most: int) -> Indices:
    """Rows whose poses are furthest from one another: what moves to and fro is looked at once.

    From the first row on, always the row whose hinges are furthest from all that are taken (Gonzalez 1985).

    Args:
        record: of which.
        most: how many.

    Returns:
        Rising.
    """
    angles = record.series["hinge_angle"]
    taken, apart = [0], np.full(len(angles), np.inf)
    while len(taken) < min(most, len(angles)):
        apart = np.minimum(apart, np.abs(angles - angles[taken[-1]]).max(axis=1))
        furthest = int(np.argmax(apart))
        if not apart[furthest] > 0:
            break
        taken.append(furthest)
    return np.array(sorted(taken), dtype=np.int64)


def stage_at(record: Record, time: float) -> StageEnd:
    """The stage of a record that a time is in; at its end, that which ends."""
    return next((end for end in record.stages if time <= end.end), record.stages[-1])
