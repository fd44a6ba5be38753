"""Facets that pass through each other, in a run or in one shape, because their contact is not modelled."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Flags, Indices
from forficula.dynamics import Record
from forficula.pattern.geometry import polygon_normal
from forficula.pattern.rotation import motion_from
from forficula.pattern.thick.convex import solid_of
from forficula.pattern.thick.thick_motion import panel_overlaps
from forficula.structure import Structure, built_points, facet_triangles

_ROWS = 400  # number of evenly spaced rows of a record that are examined
_TOGETHER = 16  # rows whose bounding boxes are compared at once
# [chosen] depth, in thicknesses, at which the solids of two plates count as crossing; with contact, which yields
_DEEP, _DEEP_IN_CONTACT = 0.01, 0.1
_SWINGS = np.radians(5.0)  # allowed swing of a folded crease past 180 deg, because no stop limits its springs


@dataclass(frozen=True, kw_only=True)
class CrossingFacets:
    """Two plates, or two facets between points, that pass through each other.

    Attributes:
        names: of both facets; plates have the names of their bodies.
        time: time of the first examined row in which they cross, s.
    """

    names: tuple[str, str]
    time: float


@dataclass(frozen=True, kw_only=True)
class _Pieces:
    """Flat polygons that may cross.

    Attributes:
        corners: points of each piece, padded by repeating the last one, (piece, corner).
        half: half the thickness of each piece, m, (piece,).
        owner: number of the plate or facet that the piece belongs to, (piece,).
        names: of plates and facets, (owner,).
        joined: whether a hinge or a common side joins two pieces, (piece, piece).
    """

    corners: Indices
    half: Array
    owner: Indices
    names: tuple[str, ...]
    joined: Flags


def facets_that_cross(record: Record) -> list[CrossingFacets]:
    """Find the pairs of facets that pass through each other in a run, in the order in which they first cross.

    Facets that share a crease cross where the crease is folded beyond 180 deg by more than 5 deg.

    Returns:
        The pairs; empty for a record without positions of points, and for a run that diverged.
    """
    places = record.series.get("point_position")
    if places is None or record.diverged_at is not None:
        return []
    rows = np.unique(np.linspace(0, len(places) - 1, _ROWS).astype(np.int64))
    pieces = _pieces(record.structure)
    crossings = [
        (pieces.names[one], pieces.names[other], row) for one, other, row in _first_crossings(pieces, places[rows])
    ]
    crossings += _overlapping_solids(record.structure, places[rows])
    result = [CrossingFacets(names=(one, other), time=float(record.time[rows[row]])) for one, other, row in crossings]
    return sorted([*_turned_through(record), *result], key=lambda crossing: crossing.time)


def _turned_through(record: Record) -> list[CrossingFacets]:
    """Find the pairs of facets between points that are folded through each other at their common crease."""
    angles, structure = record.series.get("hinge_angle"), record.structure
    result: dict[tuple[str, ...], float] = {}
    for number, hinge in enumerate(structure.hinges if angles is not None else ()):
        past = np.flatnonzero(np.abs(angles[:, number]) > np.pi + _SWINGS) if angles is not None else np.zeros(0)
        if hinge.flaps is None or not len(past):
            continue
        ends = set(hinge.flaps[:2])
        names = tuple(
            f"facet {facet.name.removeprefix('facet')}" for facet in structure.facets if ends <= set(facet.points)
        )
        time = float(record.time[past[0]])
        if len(names) == 2:
            result[names] = min(time, result.get(names, time))
    return [CrossingFacets(names=(one, other), time=time) for (one, other), time in result.items()]


def crossing_facets(structure: Structure, places: Array) -> list[tuple[str, str]]:
    """Return the names of the pairs of facets that cross, for points at the positions `places`, m, (point, 3)."""
    pieces = _pieces(structure)
    crossings = [(pieces.names[one], pieces.names[other]) for one, other, _ in _first_crossings(pieces, places[None])]
    return [*crossings, *((one, other) for one, other, _ in _overlapping_solids(structure, places[None]))]


def _overlapping_solids(structure: Structure, places: Array) -> list[tuple[str, str, int]]:
    """Return the names of pairs of plates whose solids overlap, and the first row; places, m, (row, point, 3).

    All pairs are compared, including those that a hinge joins.
    """
    plates = [plate for plate in structure.plates if plate.solids]
    if not plates:
        return []
    built = built_points(structure)
    motions = [motion_from(built[list(plate.points)], places[:, list(plate.points)]) for plate in plates]
    turns, shifts = (np.stack(parts, axis=1) for parts in zip(*motions, strict=True))
    panels = [[solid_of(built[list(solid)]) for solid in plate.solids] for plate in plates]
    names = [structure.bodies[plate.body].label for plate in plates]
    deep = (_DEEP if structure.contact is None else _DEEP_IN_CONTACT) * max(plate.thickness for plate in plates)
    result = [
        (names[one], names[other], int(np.argmax(depths > deep)))
        for one, other, depths in panel_overlaps(panels, turns, shifts)
        if depths.max() > deep
    ]
    return sorted(result, key=lambda entry: entry[2])


def _pieces(structure: Structure) -> _Pieces:
    """Return all plates that are prisms over their mid-planes, and the triangles of all facets."""
    triangles, numbers = facet_triangles(structure)
    plates, facets = [plate for plate in structure.plates if not plate.solids], structure.facets
    polygons = [plate.points for plate in plates] + [tuple(corners) for corners in triangles.tolist()]
    most = max(map(len, polygons), default=0)
    # a repeated last corner adds sides of zero length, which cross nothing
    corners = [[*points, *[points[-1]] * (most - len(points))] for points in polygons]
    thickness = [plate.thickness for plate in plates] + [facets[number].thickness for number in numbers.tolist()]
    bodies = [structure.bodies[plate.body] for plate in plates]
    joined = np.zeros((len(polygons), len(polygons)), dtype=bool)
    plate_bodies = np.array([plate.body for plate in plates], dtype=np.int64)
    parents = np.array([body.parent for body in bodies], dtype=np.int64)
    hinged = plate_bodies[:, None] == parents
    joined[: len(plates), : len(plates)] = hinged | hinged.T | (plate_bodies[:, None] == plate_bodies)
    common = (triangles[:, None, :, None] == triangles[None, :, None, :]).sum(axis=(2, 3))
    joined[len(plates) :, len(plates) :] = common > 1
    return _Pieces(
        corners=np.array(corners, dtype=np.int64).reshape(len(polygons), most),
        half=np.array(thickness) / 2,
        owner=np.concatenate([np.arange(len(plates)), len(plates) + numbers]),
        names=(
            *(structure.bodies[plate.body].label for plate in plates),
            *(f"facet {facet.name.removeprefix('facet')}" for facet in facets),
        ),
        joined=joined,
    )


def _first_crossings(pieces: _Pieces, places: Array) -> list[tuple[int, int, int]]:
    """Return pairs of owners and the first row in which they cross, ordered by rows; places, (row, point, 3).

    Two pieces cross if each has corners on both sides of the other's plane, further away than half its thickness, and
    if the segments that they cut out of the line of intersection of both planes overlap by more than that. Pieces that
    touch along a side or at a corner, or that lie on one another, therefore do not count.
    """
    result: dict[tuple[int, int], int] = {}
    for first in range(0, len(places) if len(pieces.corners) > 1 else 0, _TOGETHER):
        corners = np.moveaxis(places[first : first + _TOGETHER, pieces.corners], 1, 0)
        pair, row = _overlapping_boxes(pieces, corners)
        normals = polygon_normal(corners)
        normals /= np.maximum(np.linalg.norm(normals, axis=2, keepdims=True), 1e-300)
        crosses = _cross(corners[pair, row], normals[pair, row], pieces.half[pair])
        owners = pieces.owner[pair[:, crosses]]
        order = np.argsort(row[crosses], kind="stable")
        for one, other, when in np.vstack([np.sort(owners, axis=0), row[crosses]]).T[order].tolist():
            result.setdefault((one, other), first + when)
    return sorted(((one, other, row) for (one, other), row in result.items()), key=lambda entry: entry[2])


def _overlapping_boxes(pieces: _Pieces, corners: Array) -> tuple[Indices, Indices]:
    """Return pairs of pieces, (2, case), and rows, (case,), whose boxes overlap; corners, (piece, row, corner, 3)."""
    low, high = corners.min(axis=2), corners.max(axis=2)
    # first compare the boxes over all rows
    least, most = low.min(axis=1), high.max(axis=1)
    near = np.triu(~pieces.joined, 1)
    for axis in range(3):
        near &= (least[:, None, axis] <= most[None, :, axis]) & (most[:, None, axis] >= least[None, :, axis])
    one, other = np.nonzero(near)
    which, row = np.nonzero(np.all((low[one] <= high[other]) & (high[one] >= low[other]), axis=2))
    return np.array([one[which], other[which]]), row


def _cross(corners: Array, normals: Array, half: Array) -> Flags:
    """Return whether two facets cross, (case,).

    Args:
        corners: of both facets, (2, case, corner, 3).
        normals: of both facets, (2, case, 3).
        half: half their thicknesses, (2, case).
    """
    # height over the plane of the other facet
    height = np.einsum("pckx,pcx->pck", corners - corners[::-1, :, :1], normals[::-1])
    deep = half[::-1, :, None]
    crosses = np.asarray(((height > deep).any(axis=2) & (height < -deep).any(axis=2)).all(axis=0))
    height, corners = height[:, crosses], corners[:, crosses]
    along = np.cross(normals[0, crosses], normals[1, crosses])
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    place = np.einsum("pckx,cx->pck", corners, along)
    after, next_place = (np.roll(values, -1, axis=2) for values in (height, place))
    cut = (height >= 0) != (after >= 0)
    share = np.divide(height, height - after, out=np.zeros_like(height), where=cut)
    # a line enters a polygon at every other side that it cuts; nan, for sides that are not cut, overlaps nothing
    cuts = np.sort(np.where(cut, place + share * (next_place - place), np.nan), axis=2)
    start, end = cuts[:, :, :-1:2], cuts[:, :, 1::2]
    overlap = np.minimum(end[0, :, :, None], end[1, :, None]) - np.maximum(start[0, :, :, None], start[1, :, None])
    crosses[crosses] = (overlap > half.max(axis=0)[crosses][:, None, None]).any(axis=(1, 2))
    return crosses
