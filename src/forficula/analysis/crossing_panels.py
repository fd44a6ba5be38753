"""How far panels of membranes pass through each other, computed from the record without the engine."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from typing import Annotated
from weakref import WeakKeyDictionary

import numpy as np

from forficula.arrays import Array, Flags, Indices
from forficula.design import stage_drives
from forficula.dynamics import Record
from forficula.pattern.geometry import triangle_normals
from forficula.serial import Key, Metres, Seconds
from forficula.structure import Structure

# rows examined per driven stage and per other stage, and then on both sides of the deepest crossing
_DRIVEN, _OTHERS, _CLOSER = 32, 4, 16
_TOGETHER = 64  # rows that are computed at once
# deepest crossings of records in use: warnings, summary and page of a run all need them
_KNOWN = WeakKeyDictionary["Record", "PanelCrossing | None"]()
_SLIGHT, _ROUNDING = 1e-6, 1e-9  # shares of an edge's length below which panels only touch, and of numbers


@dataclass(frozen=True, kw_only=True)
class PanelCrossing:
    """Deepest crossing of two panels in a run.

    Attributes:
        depth: distance by which one of the two panels would have to retreat, m; 0 where no panels cross.
        names: of the two panels; empty where no panels cross.
        time: s.
    """

    depth: Metres
    names: Annotated[tuple[str, ...], Key("panels")] = ()
    time: Seconds


@dataclass(frozen=True, kw_only=True, eq=False)
class PanelMesh:
    """Triangle mesh of a panel.

    Attributes:
        name: of the panel.
        triangles: three node numbers each, counted from 0, (triangle, 3).
    """

    name: str
    triangles: Indices

    @cached_property
    def edges(self) -> Indices:
        """Return the two nodes of every edge, (edge, 2)."""
        return np.unique(self._sides.reshape(-1, 2), axis=0)

    @cached_property
    def rims(self) -> Flags:
        """Return whether each side of a triangle, from a corner to the next, is on the rim, (triangle, 3)."""
        _, which, count = np.unique(self._sides.reshape(-1, 2), axis=0, return_inverse=True, return_counts=True)
        return np.asarray(count[which.ravel()] == 1).reshape(-1, 3)

    @cached_property
    def on_rim(self) -> Flags:
        """Return whether each node is on the rim, (node,)."""
        return np.isin(np.arange(self.triangles.max() + 1), self._sides[self.rims])

    @property
    def _sides(self) -> Indices:
        """Return the nodes of the sides of each triangle, (triangle, 3, 2)."""
        return np.sort(np.stack([self.triangles, np.roll(self.triangles, -1, axis=1)], axis=-1), axis=-1)


def panel_crossing(record: Record, rows: Sequence[int] | None = None) -> PanelCrossing | None:
    """Find the deepest crossing of panels in a record.

    Args:
        record: of a run.
        rows: rows to examine; if None, rows between which the panels move by equal distances.

    Returns:
        None for a structure without panels, a sparse record, and a run that diverged.
    """
    if rows is not None:
        return _crossing(record, rows)
    if record not in _KNOWN:
        _KNOWN[record] = _crossing(record, None)
    return _KNOWN[record]


def _crossing(record: Record, rows: Sequence[int] | None) -> PanelCrossing | None:
    """Find the deepest crossing of panels; see `panel_crossing`."""
    if record.diverged_at is not None or "membrane_position" not in record.series:
        return None
    meshes = panel_meshes(record.structure)
    if not meshes:
        return None
    if rows is not None:
        return _deepest(record, meshes, rows)
    rows = _evenly_spaced_rows(record)
    result = _deepest(record, meshes, rows)
    # search once more between the rows next to the deepest one
    near = int(np.searchsorted(record.time[rows], result.time))
    low, high = rows[max(near - 1, 0)], rows[min(near + 1, len(rows) - 1)]
    closer = _deepest(record, meshes, np.unique(np.linspace(low, high, _CLOSER).round().astype(np.int64)).tolist())
    return max(result, closer, key=lambda crossing: crossing.depth)


def _deepest(record: Record, meshes: Sequence[PanelMesh], rows: Sequence[int]) -> PanelCrossing:
    """Find the deepest crossing in some rows."""
    places = panel_positions(record, rows)
    result = PanelCrossing(depth=0.0, time=float(record.time[rows[0]]))
    for (one, first_nodes), (other, second_nodes) in combinations(zip(meshes, places, strict=True), 2):
        depths = crossing_depths(one, first_nodes, other, second_nodes)
        row = int(np.argmax(depths))
        if depths[row] > result.depth:
            names = (one.name, other.name)
            result = PanelCrossing(depth=float(depths[row]), names=names, time=float(record.time[rows[row]]))
    return result


def _evenly_spaced_rows(record: Record) -> list[int]:
    """Return rows of every stage between which the panels move by equal distances, with the ends of the stage."""
    steps = np.linalg.norm(np.diff(record.series["membrane_position"], axis=0), axis=2).max(axis=1)
    path = np.concatenate([[0.0], np.cumsum(steps)])
    bounds = np.searchsorted(record.time, [[end.start, end.end] for end in record.stages])
    rows = []
    for (first, last), end in zip(bounds.clip(max=len(path) - 1).tolist(), record.stages, strict=True):
        wanted = np.linspace(path[first], path[last], _DRIVEN if stage_drives(end.stage) else _OTHERS)
        rows += [first, last, *(first + np.searchsorted(path[first : last + 1], wanted)).clip(max=last).tolist()]
    return sorted(set(rows))


def panel_meshes(structure: Structure) -> list[PanelMesh]:
    """Return the meshes of the panels of all surfaces, one surface after another."""
    return [
        PanelMesh(name=name, triangles=np.unique(triangles, return_inverse=True)[1].reshape(-1, 3))
        for surface in (membrane.surface for membrane in structure.membranes if membrane.surface is not None)
        for name, triangles in ((name, surface.triangles[surface.panels == n]) for n, name in enumerate(surface.names))
    ]


def panel_positions(record: Record, rows: Sequence[int]) -> list[Array]:
    """Return the positions of the nodes of every panel, in the order of `panel_meshes`, m, (row, node, 3) each.

    A node moves with its body: its position is a weighted sum of the positions of the recorded points and nodes of that
    body. The weights follow from the shape as built.
    """
    structure = record.structure
    known = np.concatenate(
        [record.series[name][list(rows)] for name in ("point_position", "membrane_position")], axis=1
    )
    bodies = np.concatenate(
        [[point.body for point in structure.points], *(membrane.bodies for membrane in structure.membranes)]
    )
    places = np.concatenate(
        [[point.place for point in structure.points], *(membrane.places for membrane in structure.membranes)]
    )
    result = []
    for surface in (membrane.surface for membrane in structure.membranes if membrane.surface is not None):
        nodes = np.zeros((len(known), len(surface.bodies), 3))
        for body in np.unique(surface.bodies).tolist():
            of_body, of_points = surface.bodies == body, bodies == body
            ones = np.ones((1, int(of_points.sum())))
            wanted = np.vstack([surface.places[of_body].T / structure.span, np.ones((1, int(of_body.sum())))])
            weights = np.linalg.lstsq(np.vstack([places[of_points].T / structure.span, ones]), wanted, rcond=1e-9)[0]
            nodes[:, of_body] = np.einsum("rkx,kn->rnx", known[:, of_points], weights)
        result += [nodes[:, np.unique(surface.triangles[surface.panels == n])] for n in range(len(surface.names))]
    return result


def crossing_depths(one: PanelMesh, first_nodes: Array, other: PanelMesh, second_nodes: Array) -> Array:
    """Compute how far two panels pass through each other, m, (row,); 0 where they do not cross.

    Where an edge of one panel pierces the other panel, each panel is divided into two parts, one on either side of the
    other panel. The part that reaches least far from the other panel is taken as the part that passed through, so the
    depth at a piercing is the least reach of these four parts. The depth of two panels is the largest depth of all
    piercings.

    A part consists of nodes on one side that are joined by edges and that lie in front of or behind the other panel. A
    node beside the other panel has no defined side. A node in the plane of the other panel is on neither side, so a
    whole row of such nodes hides the piercing of their edges, and the depth may be underestimated.

    Args:
        one: a panel.
        first_nodes: its nodes, (row, node, 3).
        other: another panel.
        second_nodes: its nodes, (row, node, 3).
    """
    depths = np.zeros(len(first_nodes))
    apart = (first_nodes.min(axis=1) > second_nodes.max(axis=1)) | (first_nodes.max(axis=1) < second_nodes.min(axis=1))
    near = np.flatnonzero(~apart.any(axis=1))
    for first in range(0, len(near), _TOGETHER):
        rows = near[first : first + _TOGETHER]
        depths[rows] = _depths(one, first_nodes[rows], other, second_nodes[rows])
    return depths


def _depths(one: PanelMesh, first_nodes: Array, other: PanelMesh, second_nodes: Array) -> Array:
    """Compute the depths of `crossing_depths` for all rows at once."""
    through = [_piercings(one, first_nodes, other, second_nodes), _piercings(other, second_nodes, one, first_nodes)]
    cross, depths = np.union1d(through[0][0], through[1][0]), np.zeros(len(first_nodes))
    if not len(cross):
        return depths
    views = [
        _reaches(one, first_nodes[cross], other, second_nodes[cross]),
        _reaches(other, second_nodes[cross], one, first_nodes[cross]),
    ]
    for (rows, edges, triangles), pierces, pierced, view in zip(
        through, (one, other), (other, one), (0, 1), strict=True
    ):
        places = np.searchsorted(cross, rows)[:, None]
        reach, side, distance = (values[places, pierces.edges[edges]] for values in views[view])
        # an edge with both ends on one side only grazes the other panel
        least = np.where(side[:, :1] == side[:, 1:], distance, reach).min(axis=1, initial=np.inf)
        reach, side, _ = (values[places, pierced.triangles[triangles]] for values in views[1 - view])
        for sign in (1, -1):
            part = np.where(side == sign, reach, -np.inf).max(axis=1, initial=-np.inf)
            least = np.minimum(least, np.where(np.isfinite(part), part, np.inf))
        np.maximum.at(depths, rows, least)
    return depths


def _piercings(
    one: PanelMesh, first_nodes: Array, other: PanelMesh, second_nodes: Array
) -> tuple[Indices, Indices, Indices]:
    """Return rows, edges of one panel and triangles of another that these edges pierce, (piercing,) each.

    An edge that only touches, as at the vein where two panels join, does not count.
    """
    start, end = (first_nodes[:, one.edges[:, number], None] for number in (0, 1))
    corners = second_nodes[:, other.triangles]
    normals, along = _normals(corners), end - start
    before, after = (_heights(places, corners, normals) for places in (start, end))
    slight = _SLIGHT * np.linalg.norm(along, axis=-1)
    rows, edges, triangles = np.nonzero((before * after < 0) & (np.abs(before) > slight) & (np.abs(after) > slight))
    before, after = before[rows, edges, triangles], after[rows, edges, triangles]
    place = start[rows, edges, 0] + (before / (before - after))[:, None] * along[rows, edges, 0]
    corners, normals = corners[rows, triangles], normals[rows, triangles]
    inwards = np.cross(np.roll(corners, -1, axis=1) - corners, place[:, None] - corners)
    inside = np.all(np.sum(inwards * normals[:, None], axis=-1) >= 0, axis=1)
    return rows[inside], edges[inside], triangles[inside]


def _reaches(one: PanelMesh, first_nodes: Array, other: PanelMesh, second_nodes: Array) -> tuple[Array, Indices, Array]:
    """Return for each node of a panel the reach of its part from another panel, m, its side, +-1, and distance, m."""
    distance, side, before = _nearest(first_nodes, other, second_nodes)
    reach, before = distance, before & (distance > _SLIGHT * np.ptp(first_nodes, axis=1).max())
    tail, head = one.edges.T
    joined = np.zeros((*reach.shape, reach.shape[1]), dtype=bool)
    joined[:, tail, head] = before[:, tail] & before[:, head] & (side[:, tail] == side[:, head])
    joined |= np.swapaxes(joined, 1, 2)
    while True:
        further = np.maximum(reach, np.where(joined, reach[:, None], 0.0).max(axis=2))
        if np.array_equal(further, reach):
            return reach, side, distance
        reach = further


def _nearest(points: Array, mesh: PanelMesh, nodes: Array) -> tuple[Array, Indices, Flags]:
    """Return distances of points from a panel, m, their sides, +-1, and whether they face it, (row, point)."""
    corners, points = nodes[:, mesh.triangles], points[:, :, None]
    normals = _normals(corners)
    height = _heights(points, corners, normals)
    within, square = np.ones(height.shape, dtype=bool), np.full(height.shape, np.inf)
    beside = np.zeros(height.shape, dtype=bool)
    for corner in range(3):
        following = (corner + 1) % 3
        start, away = corners[:, :, corner][:, None], points - corners[:, :, corner][:, None]
        along = (corners[:, :, following] - corners[:, :, corner])[:, None]
        within &= np.sum(np.cross(along, away) * normals[:, None], axis=-1) >= 0
        share = np.clip(np.sum(away * along, axis=-1) / np.sum(along**2, axis=-1), 0, 1)
        distance = np.sum((points - start - share[..., None] * along) ** 2, axis=-1)
        at_rim = mesh.rims[:, corner] | ((share == 0) & mesh.on_rim[mesh.triangles[:, corner]])
        at_rim |= (share == 1) & mesh.on_rim[mesh.triangles[:, following]]
        beside = np.where(distance < square, at_rim, beside)
        square = np.minimum(square, distance)
    square = np.where(within, height**2, square)
    # of equally near triangles, at an edge, take the one from whose plane the point is furthest
    least = square.min(axis=2, keepdims=True)
    tied = square <= least * (1 + _ROUNDING) + np.finfo(float).tiny
    pick = np.where(tied, np.abs(height), -1.0).argmax(axis=2)[..., None]
    before = np.take_along_axis(within | ~beside, pick, axis=2)[..., 0]
    return np.sqrt(least[..., 0]), np.where(np.take_along_axis(height, pick, axis=2)[..., 0] >= 0, 1, -1), before


def _normals(corners: Array) -> Array:
    """Return unit normals of triangles, (row, triangle, 3)."""
    normals = triangle_normals(corners)
    return np.asarray(normals / np.maximum(np.linalg.norm(normals, axis=2)[..., None], np.finfo(float).tiny))


def _heights(points: Array, corners: Array, normals: Array) -> Array:
    """Return heights of points, (row, point, 1, 3), over the planes of triangles, m, (row, point, triangle)."""
    return np.asarray(np.sum((points - corners[:, None, :, 0]) * normals[:, None], axis=-1))
