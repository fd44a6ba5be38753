"""Notches of thick panels, which make room for brackets of other panels along the fold path."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.pattern.rotation import RigidMotion, frame_along
from forficula.pattern.thick.convex import (
    ConvexSolid,
    boxes_overlap,
    overlap_depths,
    packed_solids,
    pair_overlaps,
    solid_within,
)

# [chosen] distance between the region that a bracket sweeps and the sides of its notch, in thicknesses
_MARGIN = 0.05
_TOUCHING = 1e-6  # of the thickness; solids that overlap by less touch
_ON_PLANE = 1e-6  # of the size of a solid; corners that are nearer to a plane lie on it
_MANY = 60  # more points are replaced by the corners of their convex hull
_STAYS = (np.eye(3)[None], np.zeros((1, 3)))


class Plane(NamedTuple):
    """A plane that bounds a solid: normal @ x <= offset in the solid."""

    normal: Array
    offset: float


class Piece(NamedTuple):
    """A convex solid and the planes that bound it."""

    planes: list[Plane]
    solid: ConvexSolid


class Slab(NamedTuple):
    """The space between the faces of a panel.

    Attributes:
        normal: unit vector, (3,).
        low: lower face: normal @ x, m.
        high: upper face, m.
    """

    normal: Array
    low: float
    high: float

    @property
    def least_overlap(self) -> float:
        """Depth to which solids may overlap the panel, m, which is rounding."""
        return _TOUCHING * (self.high - self.low)


def piece_within(planes: Sequence[Plane], inside: Array) -> Piece | None:
    """Return the piece within planes near a position, m, (3,), without planes that do not bound it; None if empty."""
    normals, offsets = np.array([plane.normal for plane in planes]), np.array([at for _, at in planes])
    solid = solid_within(normals, offsets, inside)
    if solid is None:
        return None
    corners = solid.corners - inside
    away = np.abs(corners @ normals.T - (offsets - normals @ inside))
    bounding = (away <= _ON_PLANE * np.abs(corners).max() * np.linalg.norm(normals, axis=1)).sum(axis=0) > 2
    return Piece([plane for plane, bounds in zip(planes, bounding.tolist(), strict=True) if bounds], solid)


def moved_plane(plane: Plane, motion: RigidMotion) -> Plane:
    """Return a plane after a motion."""
    normal = motion.rotation @ plane.normal
    return Plane(normal, plane.offset + float(normal @ motion.shift))


def pieces_without(piece: Piece, notch: Piece, least: float, inside: Array) -> list[Piece]:
    """Return the convex pieces of a piece outside a notch; the piece itself if they overlap by at most `least`, m."""
    if not boxes_overlap(piece.solid.corners, notch.solid.corners):
        return [piece]
    if overlap_depths(piece.solid, _STAYS, notch.solid, _STAYS)[0] <= least:
        return [piece]
    cut = notch.planes
    reaches = [float((piece.solid.corners @ normal).max()) - offset for normal, offset in cut]
    outside = [(number, Plane(-normal, -offset)) for number, (normal, offset) in enumerate(cut) if reaches[number] > 0]
    parts = (piece_within([*piece.planes, *cut[:number], plane], inside) for number, plane in outside)
    return [part for part in parts if part is not None]


def bracket_notches(
    panel: Piece, slab: Slab, bracket: Piece, motions: tuple[Array, Array], inside: Array
) -> list[Piece]:
    """Return the notches of a panel for a bracket of another panel, as convex solids.

    A notch has the shape of the bracket in the flat-folded state where this suffices. Otherwise it is a rectangular
    hole through the panel: the smallest rectangle around the region that the bracket sweeps in the plane of the panel,
    with a margin. A bracket that passes the panel several times along the path has as many notches.

    Args:
        panel: the panel without notches.
        slab: the space between its faces.
        bracket: the bracket.
        motions: rotations, (pose, 3, 3), and shifts, m, (pose, 3), of the bracket in the axes of the panel along the
            fold path; the last ones lead to the flat-folded state.
        inside: a position in the panel, m, (3,).
    """
    turns, shifts = motions
    corners = bracket.solid.corners @ np.swapaxes(turns, 1, 2) + shifts[:, None]
    sides = [(points.min(axis=-2), points.max(axis=-2)) for points in (panel.solid.corners, corners)]
    near = np.flatnonzero(((sides[0][0] < sides[1][1]) & (sides[1][0] < sides[0][1])).all(axis=1))
    if not len(near):
        return []
    folded = _moved_piece(bracket, RigidMotion(turns[-1], shifts[-1]))
    parts = pieces_without(panel, folded, slab.least_overlap, inside)
    closes = len(parts) != 1 or parts[0] is not panel
    solids = packed_solids([bracket.solid, *(part.solid for part in parts)])
    rows, numbers = np.tile(near, len(parts)), np.repeat(np.arange(len(parts)) + 1, len(near))
    stays = (np.repeat(_STAYS[0], len(rows), axis=0), np.repeat(_STAYS[1], len(rows), axis=0))
    depths = pair_overlaps(solids, numbers, np.zeros_like(numbers), stays, (turns[rows], shifts[rows]))
    passing = np.zeros(len(turns), dtype=bool)
    passing[rows[depths > slab.least_overlap]] = True
    result = [folded] if closes else []
    if passing.any():
        # one notch for the last passage and for the flat-folded state
        result = result if not passing[-2:].any() else []
        passing[-1] |= closes and not result
        changes = np.diff(np.concatenate([[False], passing, [False]]).astype(np.int64))
        for start, end in np.flatnonzero(changes).reshape(-1, 2).tolist():
            region = _swept_region(corners[max(start - 1, 0) : end + 1], panel.solid, slab)
            result += _hole(region, slab, inside)
    return result


def _moved_piece(piece: Piece, motion: RigidMotion) -> Piece:
    """Return a piece after a motion."""
    turn, solid = motion.rotation.T, piece.solid
    moved = ConvexSolid(corners=solid.corners @ turn + motion.shift, faces=solid.faces @ turn, edges=solid.edges @ turn)
    return Piece([moved_plane(plane, motion) for plane in piece.planes], moved)


def _swept_region(corners: Array, panel: ConvexSolid, slab: Slab) -> Array:
    """Return the corners, m, (corner, 2), of the region in the plane of a panel that a moving bracket sweeps.

    Between two poses the bracket is inside the convex hull of both, except for the bulge of its arcs, which are short.

    Args:
        corners: of the bracket in every pose, m, (pose, corner, 3).
        panel: the panel without notches.
        slab: the space between its faces.
    """
    across, along, _ = frame_along(slab.normal).T
    plane = np.column_stack([across, along])
    outline = panel.corners @ plane
    outline = outline[scipy.spatial.ConvexHull(outline).vertices]
    polygons = [np.zeros((0, 2))]
    for one, other in pairwise(corners) if len(corners) > 1 else [(corners[0], corners[0])]:
        both = np.concatenate([one, other])
        heights = both @ slab.normal
        inside = (heights >= slab.low) & (heights <= slab.high)
        points = [both[inside] @ plane]
        tails, heads = np.triu_indices(len(both), 1)
        for level in (slab.low, slab.high):
            cross = (heights[tails] - level) * (heights[heads] - level) < 0
            low, high = heights[tails[cross]] - level, heights[heads[cross]] - level
            share = (low / (low - high))[:, None]
            points.append(((1 - share) * both[tails[cross]] + share * both[heads[cross]]) @ plane)
        polygon = np.concatenate(points)
        if len(polygon) > 2:
            polygons.append(_clipped(polygon, outline))
    return np.concatenate(polygons)


def _clipped(points: Array, outline: Array) -> Array:
    """Return corners, (corner, 2), whose convex hull is the part of that of points that lies in a convex polygon.

    Args:
        points: m, (point, 2).
        outline: corners counterclockwise, m, (corner, 2).
    """
    polygon = points
    for tail, head in zip(outline, np.roll(outline, -1, axis=0), strict=True):
        beyond = (polygon - tail) @ np.array([head[1] - tail[1], tail[0] - head[0]])
        inside = beyond <= 0
        if inside.all():
            continue
        if not inside.any():
            return np.zeros((0, 2))
        # all lines between points on different sides, which include the sides of the hull
        ends, low, high = polygon[~inside], beyond[inside], beyond[~inside]
        share = low[:, None] / (low[:, None] - high)
        cut = polygon[inside][:, None] + share[..., None] * (ends - polygon[inside][:, None])
        polygon = np.concatenate([polygon[inside], cut.reshape(-1, 2)])
        if len(polygon) > _MANY:
            polygon = polygon[scipy.spatial.ConvexHull(polygon, qhull_options="QJ").vertices]
    return polygon


def _hole(points: Array, slab: Slab, inside: Array) -> list[Piece]:
    """Return the smallest rectangular hole through a panel around points in its plane, with the margin.

    One side of the smallest rectangle lies on a side of the convex hull (Freeman and Shapira 1975). No hole is needed
    where the bracket only touches the panel.
    """
    try:
        hull = points[scipy.spatial.ConvexHull(points).vertices]
    except (scipy.spatial.QhullError, ValueError):
        return []
    sides = np.roll(hull, -1, axis=0) - hull
    sides /= np.linalg.norm(sides, axis=1)[:, None]
    normals = np.column_stack([-sides[:, 1], sides[:, 0]])
    best = int(np.argmin(np.ptp(hull @ sides.T, axis=0) * np.ptp(hull @ normals.T, axis=0)))
    across, along, _ = frame_along(slab.normal).T
    margin = _MARGIN * (slab.high - slab.low)
    planes = [Plane(slab.normal, slab.high + margin), Plane(-slab.normal, margin - slab.low)]
    for direction in (sides[best], normals[best]):
        normal, reaches = direction[0] * across + direction[1] * along, hull @ direction
        planes += [Plane(normal, float(reaches.max()) + margin), Plane(-normal, margin - float(reaches.min()))]
    hole = piece_within(planes, inside)
    return [] if hole is None else [hole]
