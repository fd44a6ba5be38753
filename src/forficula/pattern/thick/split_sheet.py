"""Sheets of thick panels whose folds are split: two parallel folds with a strip between them replace a fold."""

from __future__ import annotations

import math
from dataclasses import dataclass
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
        pattern: with strips as facets; `edges_share` is 1/2 at the folds beside a strip.
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
    on faces of panels where possible. At an interior vertex the two creases of opposite sense must be one line. Both are
    split with the same width, so that the panels on one side of the line move away from those on the other side,
    normal to the plane in which the line folds, and keep the fold angles of the sheet without thickness.

    Args:
        pattern: flat or folded as built, with mountains, valleys and flat edges.
        thickness: of the panels, m.

    Raises:
        InputError: a vertex or crease that cannot be split, or panels that do not fold onto one another.
    """
    lines = _lines(pattern)
    heights = panel_heights(pattern, flat_folded(pattern), shifted=True, lines=lines)
    if heights is None:
        raise InputError("found no widths of strips with which the panels fold onto one another")
    _, axes, widths = heights
    widths = np.where(widths > _NARROWEST, widths, 0.0)
    return _with_strips(pattern, thickness, thickness * axes, thickness * widths)


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
                f"vertex {vertex.vertex}: need its creases of opposite sense, {ordered[0]} and {ordered[2]}, in one line,"
                " and mirrored sectors on both sides of it, as in a Miura sheet, so that strips fit around the vertex,"
                f" got sectors of {', '.join(f'{math.degrees(sector):.6g}' for sector in sectors)} deg from crease"
                f" {ordered[0]} on; allowed for other vertices of four creases: hinge-shift"
            )
        if abs(sectors[0] - sectors[1]) < _STRAIGHT:
            raise InputError(
                f"vertex {vertex.vertex}: need sectors other than 90 deg, because the strips at creases {ordered[0]} and"
                f" {ordered[2]} would lie in one another when folded flat, got 90 deg"
            )
        line[first(ordered[0])] = first(ordered[2])
        unsplit |= {ordered[1], ordered[3]}
    groups: dict[int, list[int]] = {}
    for edge in line:
        groups.setdefault(first(edge), []).append(edge)
    return tuple(tuple(edges) for edges in groups.values() if not unsplit.intersection(edges))


def _with_strips(pattern: CreasePattern, thickness: float, axes: Array, widths: Array) -> SplitSheet:
    """Return the sheet with strips of given widths, m, (edge,), at folds whose axes are at given heights, m, (edge,)."""
    moved, across = _moved_facets(pattern, widths)
    coords, copies = list(pattern.vertices_coords), dict[int, list[int]]()
    size = float(np.ptp(pattern.vertices_coords, axis=0).max())

    def corner(facet: int, vertex: int) -> int:
        """Return the number of the copy of a vertex that moves with a facet."""
        place = pattern.vertices_coords[vertex] + moved[facet]
        if vertex not in copies:
            copies[vertex] = [vertex]
            coords[vertex] = place
        for copy in copies[vertex]:
            if np.abs(coords[copy] - place).max() < _SAME * size:
                return copy
        copies[vertex].append(len(coords))
        coords.append(place)
        return len(coords) - 1

    faces = [tuple(corner(facet, vertex) for vertex in face) for facet, face in enumerate(pattern.faces_vertices)]
    ends, angles = list(map(tuple, pattern.edges_vertices.tolist())), pattern.edges_fold_angle.copy()
    letters, roles = list(pattern.edges_assignment), list(pattern.edges_role)
    sources, shares = list(range(len(ends))), [1.0] * len(ends)
    sides: dict[frozenset[int], list[int]] = {}
    for facet, face in enumerate(pattern.faces_vertices):
        for side, (tail, head) in zip(face_sides(face), face_sides(faces[facet]), strict=True):
            sides.setdefault(frozenset(side), []).append(facet)
    strips, levels = list[tuple[int, ...]](), [0.0] * len(faces)
    thicknesses, heights = [thickness] * len(faces), list(axes)
    strip_ends = dict[frozenset[int], list[int]]()
    for edge, (tail, head) in enumerate(pattern.edges_vertices.tolist()):
        beside = sides.get(frozenset((tail, head)), [])
        if not beside:
            continue
        ends[edge] = (corner(beside[0], tail), corner(beside[0], head))
        if len(beside) < 2 or {corner(beside[1], tail), corner(beside[1], head)} == set(ends[edge]):
            continue
        other = (corner(beside[1], tail), corner(beside[1], head))
        split = bool(widths[edge])
        ends.append(other)
        letters.append(letters[edge])
        roles.append(roles[edge])
        sources.append(edge)
        heights.append(axes[edge])
        shares[edge] = 0.5 if split else 1.0
        shares.append(shares[edge])
        angles = np.append(angles, angles[edge])
        if not split:
            continue
        left = across[edge]
        (tail_left, head_left), (tail_right, head_right) = (ends[edge], other)[:: 1 if left == beside[0] else -1]
        strips.append((head_left, tail_left, tail_right, head_right))
        depth = min(thickness, widths[edge] / 2)
        thicknesses.append(depth)
        sense = 1.0 if letters[edge] == "V" else -1.0
        levels.append(float(axes[edge]) - sense * depth / 2)
        for side in ((tail_left, tail_right), (head_left, head_right)):
            strip_ends.setdefault(frozenset(side), []).append(len(faces) + len(strips) - 1)
    for side, strips_at in strip_ends.items():
        ends.append(tuple(sorted(side)))
        # the strips of two folds in one line meet at the vertex between them, but are not connected
        letters.append("C" if len(strips_at) > 1 else "B")
        roles.append("border")
        sources.append(-1)
        shares.append(1.0)
        heights.append(0.0)
        angles = np.append(angles, math.nan)
    return SplitSheet(
        pattern=CreasePattern(
            title=pattern.title,
            vertices_coords=np.array(coords),
            edges_vertices=np.array(ends),
            edges_assignment=tuple(letters),
            edges_fold_angle=angles * np.array(shares),
            edges_role=tuple(roles),
            faces_vertices=(*faces, *strips),
            edges_share=np.array(shares),
        ),
        sources=np.array(sources),
        thickness=np.array(thicknesses),
        levels=np.array(levels),
        axes=np.array(heights),
        meeting=tuple((one, other) for one, *others in strip_ends.values() for other in others),
    )


def _moved_facets(pattern: CreasePattern, widths: Array) -> tuple[Array, dict[int, int]]:
    """Return by how much facets move as built so that strips fit between them, m, (facet, 3), and left facets of edges.

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
                f"crease {edge.edge}: need strips that fit around every hole of the sheet, got strips around a hole that"
                f" miss each other by {np.linalg.norm(gap):.3g} m"
            )
    return moved, {edge.edge: edge.left for edge in shared_edges(pattern)}
