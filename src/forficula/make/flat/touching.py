"""Who touches whom in the recorded motion: solids placed where a run has their bodies."""

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
from forficula.make.solid.poses import PartPoses, poses_of, stage_at, telling_rows
from forficula.structure import GROUND

# of a record that are looked at
_ROWS = 80
# what counts as touching, mm^3, and in m^3
_TOUCHES = 1e-2
TOUCHES = _TOUCHES / 1e9
# rows, after two touch, in which it is measured by how much
_DEEPEST = 4


@dataclass(frozen=True, kw_only=True)
class Touch:
    """Two pieces of bodies that are in one place for a while, which no two things can be.

    Attributes:
        bodies: names of the two.
        features: what of either it is: "hinge", "peg", "sleeve", "bar", "hub".
        time: when they first do, s.
        stage: name of the stage then.
        after: from the start of that stage, s.
        angles: of the hinges that are between the two, by name, in their own senses, then, rad.
        volume: what they have in common, m^3: the most of then and of four rows later on where their middles are
            nearest to each other.
        deepest: when that is, s.
    """

    bodies: tuple[str, str]
    features: tuple[str, str]
    time: float
    stage: str
    after: float
    angles: dict[str, float]
    volume: float
    deepest: float


def touches(
    parts: PartSet,
    record: Record,
    rows: Indices | None = None,
    *,
    deepest: int = _DEEPEST,
    pieces: Sequence[Piece] | None = None,
) -> tuple[Touch, ...]:
    """Who touches whom in a recorded motion, the first ones first.

    All pairs of bodies that no joint hinges to one another, piece by piece, in at most 80 rows that are as far from one
    another as can be; when two first touch is then found among all rows between two of these, as if they went on to
    touch. Straps and rods bend, and are left out; of bars it is where the run has them, with their feet in the design's
    own joints.

    Args:
        parts: of the design that ran, or others of it that differ in what does not move them.
        record: of a run that did not diverge.
        rows: of it to be looked at, rising; or as above.
        deepest: in how many rows after two touch it is measured by how much: those where their middles are nearest.
        pieces: of the parts, where they are cut already.
    """
    poses = poses_of(record, telling_rows(record, _ROWS) if rows is None else rows)
    found = []
    for one, other in combinations(pieces_of(parts) if pieces is None else pieces, 2):
        if _apart(parts, one.body, other.body):
            volumes = _volumes(one, other, poses, deepest)
            if volumes.max(initial=0.0) > _TOUCHES:
                found.append(_touch(parts, record, (one, other), poses, volumes))
    return tuple(sorted(found, key=lambda touch: (touch.time, touch.bodies, touch.features)))


def built_overlaps(parts: PartSet) -> dict[tuple[str, str], float]:
    """What bodies that no joint hinges to one another have in common as they are built, m^3, by their names.

    Those alone that touch; the root of a bar and the hub among them.
    """
    found: dict[tuple[str, str], float] = {}
    count = len(parts.structure.bodies) + 1
    still = PartPoses(
        rows=np.zeros(1, dtype=np.int64),
        frames=np.broadcast_to(np.eye(3), (1, count, 3, 3)),
        origins=np.zeros((1, count, 3)),
    )
    for one, other in combinations(pieces_of(parts), 2):
        if _apart(parts, one.body, other.body):
            pair = (_name(parts, one.body), _name(parts, other.body))
            found[pair] = found.get(pair, 0.0) + float(_volumes(one, other, still, 0)[0]) / 1e9
    return {pair: volume for pair, volume in found.items() if volume > TOUCHES}


def state_rows(record: Record) -> dict[str, int]:
    """The last row of every stage that ends in a named state, by its name; the last of several."""
    names = record.structure.stage_states
    ends = {name: end.end for name, end in zip(names, record.stages, strict=False) if name}
    return {name: int(np.searchsorted(record.time, time, side="right")) - 1 for name, time in ends.items()}


def overlap(one: Piece, other: Piece, poses: PartPoses, row: int) -> float:
    """What two pieces have in common in a row of poses, by its place there, mm^3."""
    frames, origins = poses.frames[row], poses.origins[row]
    frame = frames[one.body].T @ frames[other.body]
    origin = frames[one.body].T @ (origins[other.body] - origins[one.body])
    return float((one.shape ^ placed(other.shape, frame, origin)).volume())


def _apart(parts: PartSet, one: int, other: int) -> bool:
    """Whether two bodies are two, and not the halves of one joint."""
    halves = [{joint.proximal.body, joint.distal.body} for joint in parts.joints]
    return one != other and {one, other} not in halves


def _volumes(one: Piece, other: Piece, poses: PartPoses, deepest: int) -> Array:
    """What two pieces have in common, mm^3, (row,): up to where they first touch, and where they are nearest then.

    Nothing in other rows.
    """
    volumes = np.zeros(len(poses.rows))
    apart = _distances(*(_placed_ends(each, poses) for each in (one, other)))
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
    """Whether the boxes of two pieces are not parted by a plane along a side of either, (row,)."""
    here, there = (poses.frames[:, each.body] @ each.frame for each in (one, other))
    middles = [
        np.einsum("rij,j->ri", poses.frames[:, each.body], each.middle) + poses.origins[:, each.body]
        for each in (one, other)
    ]
    away, turned = middles[1] - middles[0], np.abs(np.swapaxes(here, 1, 2) @ there)
    apart = np.abs(np.einsum("rij,ri->rj", here, away)) > one.half + turned @ other.half
    apart |= np.abs(np.einsum("rij,ri->rj", there, away)) > other.half + np.swapaxes(turned, 1, 2) @ one.half
    return np.asarray(~apart.any(axis=1))


def _placed_ends(piece: Piece, poses: PartPoses) -> Array:
    """The line in a piece, m, (row, 2, 3)."""
    turned = np.einsum("rij,kj->rki", poses.frames[:, piece.body], piece.ends)
    return np.asarray(turned + poses.origins[:, None, piece.body])


def _distances(one: Array, other: Array) -> Array:
    """Least distances of two lines with ends, (row, 2, 3) each, m, (row,) (Ericson 2005, 5.1.9)."""
    start, along = one[:, 0], one[:, 1] - one[:, 0]
    there, across = other[:, 0], other[:, 1] - other[:, 0]
    away = start - there
    a, e, f = (np.sum(x * y, axis=1) for x, y in ((along, along), (across, across), (across, away)))
    b, c = np.sum(along * across, axis=1), np.sum(along * away, axis=1)
    square = a * e - b * b
    share = np.clip((b * f - c * e) / np.where(square > 0, square, 1.0), 0.0, 1.0)
    far = np.clip((b * share + f) / np.where(e > 0, e, 1.0), 0.0, 1.0)
    share = np.clip((b * far - c) / np.where(a > 0, a, 1.0), 0.0, 1.0)
    gap = away + share[:, None] * along - far[:, None] * across
    return np.asarray(np.linalg.norm(gap, axis=1))


def _touch(parts: PartSet, record: Record, pair: tuple[Piece, Piece], poses: PartPoses, volumes: Array) -> Touch:
    """When two pieces first touch, found among all rows, and where they are deepest in each other."""
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
    return Touch(
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
    """Angles of the joints that the bodies are part of."""
    mine = [joint for joint in parts.joints if {joint.proximal.body, joint.distal.body} & set(bodies)]
    return {joint.name: float(record.series["hinge_angle"][row, joint.hinge]) for joint in mine}


def _name(parts: PartSet, body: int) -> str:
    return "hub" if body == GROUND else parts.structure.bodies[body].name
