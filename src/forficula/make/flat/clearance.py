"""Collisions of parts in a recorded motion: solids are placed at the positions of their bodies in a run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from forficula.arrays import Array, Flags, Indices
from forficula.dynamics import Record
from forficula.make.flat.pieces import Piece, pieces_of
from forficula.make.part import PartSet
from forficula.make.solid.mesh import placed
from forficula.make.solid.poses import PartPoses, different_rows, poses_of, stage_at
from forficula.structure import GROUND

# largest number of rows of a record that are checked
_ROWS = 80
# overlap that counts as a collision, mm^3, and in m^3
_TOUCHES = 1e-2
LEAST_OVERLAP = _TOUCHES / 1e9
# number of later rows in which the volume of a collision is measured
_DEEPEST = 4


@dataclass(frozen=True, kw_only=True)
class Collision:
    """A collision: two pieces of bodies that overlap for a while.

    Attributes:
        bodies: names of the two.
        features: piece of either body: "hinge", "peg", "sleeve", "bar", "hub".
        time: time of the first overlap, s.
        stage: name of the stage at this time.
        after: time since the start of this stage, s.
        angles: angles of the hinges between the two at this time, by name, in their own senses, rad.
        volume: volume of the overlap, m^3: the largest one at this time and in the four later rows in which their
            middles are nearest to each other.
        deepest: time of this volume, s.
    """

    bodies: tuple[str, str]
    features: tuple[str, str]
    time: float
    stage: str
    after: float
    angles: dict[str, float]
    volume: float
    deepest: float


def recorded_collisions(
    parts: PartSet,
    record: Record,
    rows: Indices | None = None,
    *,
    deepest: int = _DEEPEST,
    pieces: Sequence[Piece] | None = None,
) -> tuple[Collision, ...]:
    """Return the collisions in a recorded motion, sorted by time.

    All pairs of bodies without a common joint are checked, piece by piece, in at most 80 rows that are as different
    from each other as possible. The time of the first overlap is then refined by bisection among all rows between two
    of these. Straps and rods are excluded, because they bend. Bars have their positions in the run, with their ends in
    the joints of the design.

    Args:
        parts: parts of the design that ran, or with changes that do not affect the motion.
        record: record of a run that did not diverge.
        rows: rows to check, rising; by default as above.
        deepest: number of rows after the first overlap in which its volume is measured: those with the nearest middles.
        pieces: pieces of the parts, if they have been cut already.
    """
    poses = poses_of(record, different_rows(record, _ROWS) if rows is None else rows)
    collisions = []
    for one, other in combinations(pieces_of(parts) if pieces is None else pieces, 2):
        if _apart(parts, one.body, other.body):
            volumes = _volumes(one, other, poses, deepest)
            if volumes.max(initial=0.0) > _TOUCHES:
                collisions.append(_touch(parts, record, (one, other), poses, volumes))
    return tuple(sorted(collisions, key=lambda touch: (touch.time, touch.bodies, touch.features)))


def built_overlaps(parts: PartSet) -> dict[tuple[str, str], float]:
    """Return the overlaps of bodies without a common joint as built, m^3, by their names.

    Only bodies that overlap are returned, including the root of a bar and the hub.
    """
    volumes: dict[tuple[str, str], float] = {}
    count = len(parts.structure.bodies) + 1
    built_poses = PartPoses(
        rows=np.zeros(1, dtype=np.int64),
        frames=np.broadcast_to(np.eye(3), (1, count, 3, 3)),
        origins=np.zeros((1, count, 3)),
    )
    for one, other in combinations(pieces_of(parts), 2):
        if _apart(parts, one.body, other.body):
            pair = (_name(parts, one.body), _name(parts, other.body))
            volumes[pair] = volumes.get(pair, 0.0) + float(_volumes(one, other, built_poses, 0)[0]) / 1e9
    return {pair: volume for pair, volume in volumes.items() if volume > LEAST_OVERLAP}


def state_rows(record: Record) -> dict[str, int]:
    """Return the last row of every stage that ends in a named state, by its name; of several, the last one."""
    names = record.structure.stage_states
    ends = {name: end.end for name, end in zip(names, record.stages, strict=False) if name}
    return {name: int(np.searchsorted(record.time, time, side="right")) - 1 for name, time in ends.items()}


def overlap(one: Piece, other: Piece, poses: PartPoses, row: int) -> float:
    """Return the overlap of two pieces in a row of poses, mm^3."""
    frames, origins = poses.frames[row], poses.origins[row]
    frame = frames[one.body].T @ frames[other.body]
    origin = frames[one.body].T @ (origins[other.body] - origins[one.body])
    return float((one.shape ^ placed(other.shape, frame, origin)).volume())


def _apart(parts: PartSet, one: int, other: int) -> bool:
    """Return whether two bodies are different and not the halves of one joint."""
    halves = [{joint.proximal.body, joint.distal.body} for joint in parts.joints]
    return one != other and {one, other} not in halves


def _volumes(one: Piece, other: Piece, poses: PartPoses, deepest: int) -> Array:
    """Return the overlap of two pieces, mm^3, (row,): up to the first collision, and in the nearest rows after it.

    It is 0 in other rows.
    """
    volumes = np.zeros(len(poses.rows))
    apart = _distances(*(_placed_ends(piece, poses) for piece in (one, other)))
    near = np.flatnonzero((apart < one.radius + other.radius) & _boxes_meet(one, other, poses))
    for row in near:
        volumes[row] = overlap(one, other, poses, int(row))
        if volumes[row] > _TOUCHES:
            later = near[near > row]
            for deep in later[np.argsort(apart[later], kind="stable")[:deepest]]:
                volumes[deep] = overlap(one, other, poses, int(deep))
            break
    return volumes


def _boxes_meet(one: Piece, other: Piece, poses: PartPoses) -> Flags:
    """Return whether no plane along a side of either box separates the boxes of two pieces, (row,)."""
    axes, other_axes = (poses.frames[:, piece.body] @ piece.frame for piece in (one, other))
    middles = [
        np.einsum("rij,j->ri", poses.frames[:, piece.body], piece.middle) + poses.origins[:, piece.body]
        for piece in (one, other)
    ]
    away, turned = middles[1] - middles[0], np.abs(np.swapaxes(axes, 1, 2) @ other_axes)
    apart = np.abs(np.einsum("rij,ri->rj", axes, away)) > one.half + turned @ other.half
    apart |= np.abs(np.einsum("rij,ri->rj", other_axes, away)) > other.half + np.swapaxes(turned, 1, 2) @ one.half
    return np.asarray(~apart.any(axis=1))


def _placed_ends(piece: Piece, poses: PartPoses) -> Array:
    """Return the line of a piece in every row, m, (row, 2, 3)."""
    turned = np.einsum("rij,kj->rki", poses.frames[:, piece.body], piece.ends)
    return np.asarray(turned + poses.origins[:, None, piece.body])


def _distances(one: Array, other: Array) -> Array:
    """Return the smallest distances of two line segments, (row, 2, 3) each, m, (row,) (Ericson 2005, 5.1.9)."""
    start, along = one[:, 0], one[:, 1] - one[:, 0]
    other_start, across = other[:, 0], other[:, 1] - other[:, 0]
    away = start - other_start
    a, e, f = (np.sum(x * y, axis=1) for x, y in ((along, along), (across, across), (across, away)))
    b, c = np.sum(along * across, axis=1), np.sum(along * away, axis=1)
    square = a * e - b * b
    share = np.clip((b * f - c * e) / np.where(square > 0, square, 1.0), 0.0, 1.0)
    far = np.clip((b * share + f) / np.where(e > 0, e, 1.0), 0.0, 1.0)
    share = np.clip((b * far - c) / np.where(a > 0, a, 1.0), 0.0, 1.0)
    gap = away + share[:, None] * along - far[:, None] * across
    return np.asarray(np.linalg.norm(gap, axis=1))


def _touch(parts: PartSet, record: Record, pair: tuple[Piece, Piece], poses: PartPoses, volumes: Array) -> Collision:
    """Return a collision: its first time, found among all rows, and its deepest overlap."""
    first = int(np.argmax(volumes > _TOUCHES))
    row = int(poses.rows[first])
    free = int(poses.rows[first - 1]) if first else row
    while row - free > 1:
        middle = (row + free) // 2
        if overlap(*pair, poses_of(record, [middle]), 0) > _TOUCHES:
            row = middle
        else:
            free = middle
    time, most = float(record.time[row]), int(np.argmax(volumes))
    stage = stage_at(record, time)
    bodies = [piece.body for piece in pair]
    return Collision(
        bodies=(_name(parts, bodies[0]), _name(parts, bodies[1])),
        features=(pair[0].feature, pair[1].feature),
        time=time,
        stage=stage.stage.name,
        after=time - stage.start,
        angles=_angles(parts, record, bodies, row),
        volume=float(volumes[most]) / 1e9,
        deepest=float(record.time[poses.rows[most]]),
    )


def _angles(parts: PartSet, record: Record, bodies: Sequence[int], row: int) -> dict[str, float]:
    """Return the angles of the joints of two bodies."""
    joints = [joint for joint in parts.joints if {joint.proximal.body, joint.distal.body} & set(bodies)]
    return {joint.name: float(record.series["hinge_angle"][row, joint.hinge]) for joint in joints}


def _name(parts: PartSet, body: int) -> str:
    return "hub" if body == GROUND else parts.structure.bodies[body].name
