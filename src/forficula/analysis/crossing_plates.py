"""Plates that pass through each other in a run, for nothing keeps them from it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.dynamics import Record

Array = NDArray[np.float64]

_ROWS = 400  # of a record that are looked at, evenly


@dataclass(frozen=True, kw_only=True)
class CrossingPlates:
    """Two plates that pass through each other.

    Attributes:
        plates: their numbers in the structure.
        time: of the first row that is looked at in which they do, s.
    """

    plates: tuple[int, int]
    time: float


def crossing_plates(record: Record) -> list[CrossingPlates]:
    """The pairs of plates that pass through each other, in the order in which they begin to.

    Both have corners on either side of the other's plane, by more than half its thickness, and the lengths that they
    cut out of the line in which these planes meet overlap by more than that. So plates that touch along an edge or lie
    on one another do not count, nor do those that a hinge joins.

    Returns:
        None of a record without places, or of a run that diverged.
    """
    structure, places = record.structure, record.series.get("point_position")
    plates = structure.plates
    if len(plates) < 2 or places is None or record.diverged_at is not None:
        return []
    rows = np.unique(np.linspace(0, len(places) - 1, _ROWS).astype(np.int64))
    most = max(len(plate.points) for plate in plates)
    # a last corner again and again adds sides without a length, which cross nothing
    numbers = [[*plate.points, *[plate.points[-1]] * (most - len(plate.points))] for plate in plates]
    corners = np.moveaxis(places[rows][:, numbers], 1, 0)
    away = corners - corners[:, :, :1]
    normals = np.cross(away, np.roll(away, -1, axis=2)).sum(axis=2)
    normals /= np.linalg.norm(normals, axis=2, keepdims=True)
    low, high = corners.min(axis=2), corners.max(axis=2)
    bodies = np.array([plate.body for plate in plates])
    parents = np.array([structure.bodies[body].parent for body in bodies])
    half = np.array([plate.thickness for plate in plates]) / 2
    found = []
    for one in range(len(plates) - 1):
        joined = (bodies == parents[one]) | (parents == bodies[one]) | (bodies == bodies[one])
        others = np.flatnonzero(~joined & (np.arange(len(plates)) > one))
        near = np.all((low[others] <= high[one]) & (high[others] >= low[one]), axis=2)
        which, row = np.nonzero(near)
        pair = np.array([np.full(len(which), one), others[which]])
        crosses = _cross(corners[pair, row], normals[pair, row], half[pair])
        crossed, first = np.unique(pair[1, crosses], return_index=True)
        times = record.time[rows[row[crosses][first]]]
        found += [
            CrossingPlates(plates=(one, other), time=time)
            for other, time in zip(crossed.tolist(), times.tolist(), strict=True)
        ]
    return sorted(found, key=lambda each: each.time)


def _cross(corners: Array, normals: Array, half: Array) -> NDArray[np.bool_]:
    """Whether two plates cross, (case,), by corners, (2, case, corner, 3), normals and half thicknesses, (2, case)."""
    # over the other's plane
    height = np.einsum("pckx,pcx->pck", corners - corners[::-1, :, :1], normals[::-1])
    deep = half[::-1, :, None]
    crosses = np.asarray(((height > deep).any(axis=2) & (height < -deep).any(axis=2)).all(axis=0))
    height, corners = height[:, crosses], corners[:, crosses]
    along = np.cross(normals[0, crosses], normals[1, crosses])
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    place = np.einsum("pckx,cx->pck", corners, along)
    after, next_place = (np.roll(each, -1, axis=2) for each in (height, place))
    cut = (height >= 0) != (after >= 0)
    share = np.divide(height, height - after, out=np.zeros_like(height), where=cut)
    # a line goes into a polygon at every other side that it cuts; nan, of the others, overlaps nothing
    cuts = np.sort(np.where(cut, place + share * (next_place - place), np.nan), axis=2)
    start, end = cuts[:, :, :-1:2], cuts[:, :, 1::2]
    overlap = np.minimum(end[0, :, :, None], end[1, :, None]) - np.maximum(start[0, :, :, None], start[1, :, None])
    crosses[crosses] = (overlap > half.max(axis=0)[crosses][:, None, None]).any(axis=(1, 2))
    return crosses
