"""Sheets of thick panels whose folds are split: two parallel folds with a strip between them replace a fold."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern, face_sides
from forficula.pattern.facet_tree import facet_tree
from forficula.pattern.facts.vertex_creases import vertex_creases
from forficula.pattern.geometry import polygon_normal
from forficula.pattern.shared_edges import shared_edges
from forficula.pattern.thick.panel_heights import panel_heights, unique_first
from forficula.pattern.thick.thick_motion import built_angles, flat_folded

_STRAIGHT = 1e-6  # rad, deviation from a straight line that counts as rounding
_SAME = 1e-9  # of the size of the sheet; positions that are closer are one vertex
_NARROWEST = 1e-6  # of the thickness; narrower strips are left out


@dataclass(frozen=True, kw_only=True, eq=False)
class SplitSheet:
    """A sheet of thick panels with the strips of its split folds.

    Facets, edges and vertices of the sheet without thickness keep their numbers. Strips, their second folds and the
    further copies of vertices follow.

    Attributes:
        pattern: with strips as facets; both folds beside a strip are one fold in `edges_fold`.
        sources: number of the edge of the sheet without thickness for every edge; -1 at the ends of strips, (edge,).
        thickness: of every panel and strip, m, (facet,).
        levels: heights of their mid-planes over the sheet without thickness, m, (facet,).
        axes: heights of the axes of folds, m, (edge,).
        meeting: pairs of strips that meet at a vertex, (pair, 2).
    """

    pattern: CreasePattern
    sources: Indices
    thickness: Array
    levels: Array
    axes: Array
    meeting: tuple[tuple[int, int], ...]

    def path(self, path: Array) -> Array:
        """Return the fold angles of this sheet from those of the sheet without thickness, rad, (pose, edge)."""
        return np.where(self.sources >= 0, path[:, self.sources] * self.pattern.edges_share, 0.0)


@lru_cache(maxsize=64)  # the pattern, checks and structures of a design need it
def split_sheet(pattern: CreasePattern, thickness: float) -> SplitSheet:
    """Split the folds of a sheet so that its level panels fold flat around one another.

    A strip of the width w between two folds of 90 deg leaves a gap of w in addition to that of the hinges. All axes lie
    on faces of panels where possible. At an interior vertex the two creases of opposite sense must be one line. Both
    are split with the same width, so that the panels on one side of the line move away from those on the other side,
    normal to the plane in which the line folds, and keep the fold angles of the sheet without thickness.

    Args:
        pattern: flat or folded as built, with mountains, valleys and flat edges.
        thickness: of the panels, m.

    Raises:
        InputError: a vertex or crease that cannot be split, or panels that do not fold onto one another.
    """
    check_unsplit(pattern)
    lines = _lines(pattern)
    heights = panel_heights(pattern, flat_folded(pattern), shifted=True, lines=lines)
    if heights is None:
        raise InputError("found no widths of strips with which the panels fold onto one another")
    _, axes, widths = heights
    widths = np.where(widths > _NARROWEST, widths, 0.0)
    return _with_strips(pattern, thickness, thickness * axes, thickness * widths)


def check_unsplit(pattern: CreasePattern) -> None:
    """Refuse a sheet with split folds, such as that of a file, to which no thickness can be added.

    Raises:
        InputError: the first edge of a split fold.
    """
    for edge in np.flatnonzero(pattern.edges_share < 1)[:1].tolist():
        raise InputError(f'need "none" for a pattern that has split folds (folds), got one at edge {edge}')


def _lines(pattern: CreasePattern) -> tuple[tuple[int, ...], ...]:
    """Return the groups of creases that are split with one width; other creases are not split.

    Raises:
        InputError: a vertex around which strips do not fit.
    """
    line = {edge.edge: edge.edge for edge in shared_edges(pattern) if pattern.edges_assignment[edge.edge] in "MV"}
    unsplit: set[int] = set()

    def first(edge: int) -> int:
        while line[edge] != edge:
            edge = line[edge]
        return edge

    for vertex in vertex_creases(pattern):
        if not len(vertex.edges):
            continue
        ordered, sectors, _ = unique_first(pattern, vertex)
        if (
            abs(sectors[0] + sectors[1] - math.pi) > _STRAIGHT
            or abs(sectors[0] + sectors[2] - math.pi) > _STRAIGHT
            or abs(vertex.total - 2 * math.pi) > _STRAIGHT
        ):
            raise InputError(
                f"vertex {vertex.vertex}: need its creases of opposite sense, {ordered[0]} and {ordered[2]}, in one"
                " line, and mirrored sectors on both sides of the line, as in a Miura sheet, so that strips fit around"
                " the vertex, got sectors of"
                f" {', '.join(f'{math.degrees(sector):.6g}' for sector in sectors)} deg from crease"
                f" {ordered[0]} on; allowed for other vertices of four creases: hinge-shift"
            )
        if abs(sectors[0] - sectors[1]) < _STRAIGHT:
            raise InputError(
                f"vertex {vertex.vertex}: need sectors other than 90 deg, because the strips at creases {ordered[0]}"
                f" and {ordered[2]} would lie in one another when folded flat, got 90 deg"
            )
        line[first(ordered[0])] = first(ordered[2])
        unsplit |= {ordered[1], ordered[3]}
    groups: dict[int, list[int]] = {}
    for edge in line:
        groups.setdefault(first(edge), []).append(edge)
    return tuple(tuple(edges) for edges in groups.values() if not unsplit.intersection(edges))


@dataclass(frozen=True)
class _Edge:
    """An edge of the sheet with strips.

    Attributes:
        ends: its vertices.
        letter: assignment.
        angle: target angle of the whole fold, rad.
        role: label.
        source: number of the edge of the sheet without thickness, or -1.
        share: part of the fold angle.
        axis: height of the axis, m.
    """

    ends: tuple[int, int]
    letter: str
    angle: float = math.nan
    role: str = "border"
    source: int = -1
    share: float = 1.0
    axis: float = 0.0


@dataclass(frozen=True)
class _Strip:
    """A strip: its corners, thickness, m, and the height of its mid-plane, m."""

    corners: tuple[int, int, int, int]
    thickness: float
    level: float


class _Corners:
    """Copies of the vertices of a sheet whose facets move: the first copy keeps the number of the vertex."""

    def __init__(self, pattern: CreasePattern, moved: Array) -> None:
        self.coords = list(pattern.vertices_coords)
        self._copies: dict[int, list[int]] = {}
        self._built, self._moved = pattern.vertices_coords, moved
        self._same = _SAME * float(np.ptp(pattern.vertices_coords, axis=0).max())

    def of(self, facet: int, vertex: int) -> int:
        """Return the number of the copy of a vertex that moves with a facet."""
        place = self._built[vertex] + self._moved[facet]
        if vertex not in self._copies:
            self._copies[vertex] = [vertex]
            self.coords[vertex] = place
        for copy in self._copies[vertex]:
            if np.abs(self.coords[copy] - place).max() < self._same:
                return copy
        self._copies[vertex].append(len(self.coords))
        self.coords.append(place)
        return len(self.coords) - 1


def _with_strips(pattern: CreasePattern, thickness: float, axes: Array, widths: Array) -> SplitSheet:
    """Return the sheet with strips at split folds.

    Args:
        pattern: without strips.
        thickness: of the panels, m.
        axes: heights of the axes of creases, m, (edge,).
        widths: of strips, m, (edge,); 0 where a fold is not split.
    """
    corners = _Corners(pattern, _moved_facets(pattern, widths))
    faces = [tuple(corners.of(facet, vertex) for vertex in face) for facet, face in enumerate(pattern.faces_vertices)]
    beside: dict[frozenset[int], list[int]] = {}
    for facet, face in enumerate(pattern.faces_vertices):
        for side in face_sides(face):
            beside.setdefault(frozenset(side), []).append(facet)
    first, second, strips = list[_Edge](), list[_Edge](), list[_Strip]()
    strips_at: dict[frozenset[int], list[int]] = {}
    left_of = {edge.edge: edge.left for edge in shared_edges(pattern)}
    for number, (tail, head) in enumerate(pattern.edges_vertices.tolist()):
        edge = _Edge(
            ends=(tail, head),
            letter=pattern.edges_assignment[number],
            angle=float(pattern.edges_fold_angle[number]),
            role=pattern.edges_role[number],
            source=number,
            share=0.5 if widths[number] else 1.0,
            axis=float(axes[number]),
        )
        # the facet on the left first
        facets = sorted(beside.get(frozenset((tail, head)), []), key=lambda facet: facet != left_of.get(number))
        sides = [(corners.of(facet, tail), corners.of(facet, head)) for facet in facets] or [(tail, head)]
        first.append(replace(edge, ends=sides[0]))
        second += [replace(edge, ends=side) for side in sides[1:] if side != sides[0]]
        if widths[number]:
            strips.append(_strip(edge, sides, thickness, float(widths[number])))
            for end in zip(*sides, strict=True):
                strips_at.setdefault(frozenset(end), []).append(len(faces) + len(strips) - 1)
    # the strips of two folds in one line meet at the vertex between them, but are not connected
    tips = [
        _Edge(ends=(min(end), max(end)), letter="C" if len(numbers) > 1 else "B") for end, numbers in strips_at.items()
    ]
    edges = [*first, *second, *tips]
    return SplitSheet(
        pattern=CreasePattern(
            title=pattern.title,
            vertices_coords=np.array(corners.coords),
            edges_vertices=np.array([edge.ends for edge in edges]),
            edges_assignment=tuple(edge.letter for edge in edges),
            edges_fold_angle=np.array([edge.share * edge.angle for edge in edges]),
            edges_role=tuple(edge.role for edge in edges),
            faces_vertices=(*faces, *(strip.corners for strip in strips)),
            edges_fold=np.array([edge.source if edge.source >= 0 else number for number, edge in enumerate(edges)]),
        ),
        sources=np.array([edge.source for edge in edges]),
        thickness=np.array([*[thickness] * len(faces), *(strip.thickness for strip in strips)]),
        levels=np.array([*[0.0] * len(faces), *(strip.level for strip in strips)]),
        axes=np.array([edge.axis for edge in edges]),
        meeting=tuple((one, other) for one, *others in strips_at.values() for other in others),
    )


def _strip(edge: _Edge, sides: Sequence[tuple[int, int]], thickness: float, width: float) -> _Strip:
    """Return the strip between two sides, the left one first; it is on the side to which its folds open."""
    (tail_left, head_left), (tail_right, head_right) = sides
    depth = min(thickness, width / 2)
    away = -1.0 if edge.letter == "V" else 1.0
    return _Strip((head_left, tail_left, tail_right, head_right), depth, edge.axis + away * depth / 2)


def _moved_facets(pattern: CreasePattern, widths: Array) -> Array:
    """Return by how much facets move as built so that strips fit between them, m, (facet, 3).

    A strip halves the fold angle between its facets.

    Raises:
        InputError: strips that do not fit around a hole.
    """
    built = built_angles(pattern)
    normals = np.array([polygon_normal(pattern.vertices_coords[list(face)]) for face in pattern.faces_vertices])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    coords = pattern.vertices_coords

    def strip(edge: int, tail: int, head: int, facet: int) -> Array:
        """Return the vector across a strip from the facet on the left of an edge, m, (3,)."""
        outwards = np.cross(coords[head] - coords[tail], normals[facet])
        outwards /= np.linalg.norm(outwards)
        half = built[edge] / 2
        return np.asarray(widths[edge] * (math.cos(half) * outwards + math.sin(half) * normals[facet]))

    moved = np.zeros_like(normals)
    for link in facet_tree(pattern):
        if link.parent is not None and link.edge is not None and not link.closes:
            moved[link.facet] = moved[link.parent] + strip(link.edge, link.tail, link.head, link.parent)
    size = float(np.ptp(coords, axis=0).max())
    for edge in shared_edges(pattern):
        gap = moved[edge.right] - moved[edge.left] - strip(edge.edge, edge.tail, edge.head, edge.left)
        if np.abs(gap).max() > 1e-6 * size:
            raise InputError(
                f"crease {edge.edge}: need strips that fit around every hole of the sheet, got strips around a hole"
                f" that miss each other by {np.linalg.norm(gap):.3g} m"
            )
    return moved
