"""Distance of a run from the motion that another program wrote as the frames of a FOLD file."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics import Record
from forficula.errors import InputError, error_prefix
from forficula.pattern import CreasePattern, read_fold, read_folded_frames
from forficula.show.structure.pattern_points import pattern_points

_LENGTHS = 0.01  # largest deviation of an edge's length, as a share of the mean length of the edges
_TRIED = 8  # number of frames between which and their neighbours positions are interpolated
_BLOCK = 200_000  # pairs of a moment and a frame that are aligned at once


@dataclass(frozen=True, kw_only=True, eq=False)
class FoldMotion:
    """Folded states from a FOLD file.

    Attributes:
        name: name of the file.
        pattern: pattern of the file, in its unit.
        frames: positions of the vertices, in the unit of the file, (frame, vertex, 3).
    """

    name: str
    pattern: CreasePattern
    frames: Array


def read_motion(path: Path) -> FoldMotion:
    """Read the frames of a FOLD file.

    Raises:
        InputError: the file cannot be read, or has no frame of the class "foldedForm".
    """
    # sizes are compared with the run, so that any unit may stand for a missing one
    unit = None
    try:
        pattern = read_fold(path)
    except InputError as error:
        if "unit" not in str(error):
            raise
        unit = 1.0
        pattern = read_fold(path, unit)
    frames = read_folded_frames(path, unit)
    if not frames:
        raise InputError(f'{path}: need frames of the class "foldedForm" in file_frames, got none')
    return FoldMotion(name=path.name, pattern=pattern, frames=np.stack([places for _, places, _ in frames]))


def fold_distances(record: Record, rows: Indices, motion: FoldMotion) -> Array:
    """Compute the distance of a run from the nearest frame of a motion, at some moments.

    The distance is the root mean square over the vertices of the pattern after the best translation and rotation
    (Kabsch 1976), so that the times, the unit and the position of the frames do not matter. Positions between
    frames are interpolated.

    Args:
        record: the run.
        rows: rows of the record.
        motion: frames of the same pattern.

    Returns:
        m, (row,).

    Raises:
        InputError: the run has no pattern, or the file has another one.
    """
    structure = record.structure
    points, pattern = pattern_points(structure), structure.appearance.pattern
    with error_prefix(f"{motion.name}: "):
        if points is None or pattern is None:
            raise InputError(f"need a run with a point at every vertex of its crease pattern, got {structure.name}")
        frames = _scale(pattern, motion) * motion.frames
    places = np.concatenate([record.series["point_position"], record.series["membrane_position"]], axis=1)
    moments = places[rows][:, points]
    block = max(_BLOCK // len(frames), 1)
    parts = [_nearest(moments[start : start + block], frames) for start in range(0, len(moments), block)]
    return np.concatenate(parts)


def _scale(pattern: CreasePattern, motion: FoldMotion) -> float:
    """Return the length of the unit of a motion, m, from the lengths of all edges."""
    count, expected = len(motion.pattern.vertices_coords), len(pattern.vertices_coords)
    if count != expected:
        raise InputError(f"need the pattern of the run with {expected} vertices, got one with {count}")
    ends = pattern.edges_vertices
    lengths, other = (
        np.linalg.norm(places[ends[:, 1]] - places[ends[:, 0]], axis=1)
        for places in (pattern.vertices_coords, motion.pattern.vertices_coords)
    )
    scale = float(lengths.sum() / other.sum()) if other.sum() > 0 else 1.0
    if np.abs(scale * other - lengths).max() > _LENGTHS * lengths.mean():
        raise InputError("need the vertices of the run's pattern in the same order, got edges of other lengths")
    return scale


def _nearest(moments: Array, frames: Array) -> Array:
    """Return the distances of shapes from the nearest of some frames and of the lines between them, m, (moment,)."""
    one, other = (shapes - shapes.mean(axis=1, keepdims=True) for shapes in (moments, frames))
    overlap = np.einsum("mvi,fvj->mfij", one, other)
    sizes = np.linalg.svd(overlap, compute_uv=False)
    # a reflection is no rotation: the smallest singular value then counts as negative
    best = sizes[..., 0] + sizes[..., 1] + np.sign(np.linalg.det(overlap)) * sizes[..., 2]
    squares = np.sum(one**2, axis=(1, 2))[:, np.newaxis] + np.sum(other**2, axis=(1, 2)) - 2 * best
    # a motion may pass a shape several times, with frames at other distances from it
    order = np.argsort(squares, axis=1)[:, :_TRIED]
    rows = np.arange(len(moments))[:, np.newaxis]
    least = np.full(len(moments), np.inf)
    for nearest in order.T:
        beside = np.clip(nearest[:, np.newaxis] + [-1, 0, 1], 0, len(frames) - 1)
        left, _, right = np.linalg.svd(overlap[rows, beside])
        left[..., 2] *= np.sign(np.linalg.det(left) * np.linalg.det(right))[..., np.newaxis]
        turned = np.einsum("mkij,mkvj->mkvi", left @ right, other[beside])
        for end in (0, 2):
            least = np.minimum(least, _distance_to_line(one, turned[:, 1], turned[:, end]))
    return np.asarray(least / np.sqrt(moments.shape[1]))


def _distance_to_line(places: Array, start: Array, end: Array) -> Array:
    """Return the distances of shapes from straight lines between two others, m, (moment,)."""
    way, apart = end - start, places - start
    length = np.sum(way**2, axis=(1, 2))
    along = np.divide(np.sum(apart * way, axis=(1, 2)), length, out=np.zeros(len(places)), where=length > 0)
    rest = apart - np.clip(along, 0, 1)[:, np.newaxis, np.newaxis] * way
    return np.asarray(np.sqrt(np.sum(rest**2, axis=(1, 2))))
