"""Solids of thick panels as convex pieces, with brackets for axes outside a panel and notches for these brackets."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from forficula.arrays import Array
from forficula.pattern.crease_pattern import CreasePattern, face_sides
from forficula.pattern.rotation import RigidMotion
from forficula.pattern.shared_edges import SharedEdge, shared_edges
from forficula.pattern.thick.convex import (
    ConvexSolid,
    connected_parts,
    convex_faces,
    overlap_depths,
    relative_motions,
    volume_of,
)
from forficula.pattern.thick.notches import (
    Piece,
    Plane,
    Slab,
    bracket_notches,
    moved_plane,
    piece_within,
    pieces_without,
)

# [chosen] width of a face that holds two pieces of a panel together, in thicknesses
_HELD = 0.1
# [chosen] largest share of the volume of a panel that is left out where notches separate it from the rest
_LOOSE = 0.01
_MOST_CUTS = 40  # [chosen] most cuts of the ends of two strips that meet
_ROUNDING = 1e-9
_TOUCHING = 1e-6  # of the thickness; solids that overlap by less touch


class Layer(NamedTuple):
    """A panel of uniform thickness over a facet.

    Attributes:
        origin: shift of the facet from the sheet without thickness, m, (3,).
        normal: unit vector to the side to which valleys rise, (3,).
        level: height of the mid-plane over the facet, m.
        thickness: m.
    """

    origin: Array
    normal: Array
    level: float
    thickness: float

    def slab(self, base: Array) -> Slab:
        """Return the space between the faces, over the facet that contains the position `base`, m, (3,)."""
        middle = float(self.at(base, self.level) @ self.normal)
        return Slab(self.normal, middle - self.thickness / 2, middle + self.thickness / 2)

    def at(self, position: Array, height: float) -> Array:
        """Return the position at a height over a position on the sheet without thickness, m, (3,)."""
        return np.asarray(position + self.origin + height * self.normal)


class PanelSolids(NamedTuple):
    """The convex solids of a panel, in the position as built.

    Attributes:
        pieces: parts of the panel, which touch but do not overlap.
        brackets: solids that carry axes outside the panel.
        notches: solids that were cut out of the panel.
        divided: whether notches divide the panel.
    """

    pieces: tuple[ConvexSolid, ...]
    brackets: tuple[ConvexSolid, ...]
    notches: tuple[ConvexSolid, ...]
    divided: bool


@dataclass(frozen=True, kw_only=True, eq=False)
class _Draft:
    """The solids of a panel before they are cut out.

    Attributes:
        panel: planes of the panel.
        brackets: planes of each bracket.
        inside: a position in the panel, m, (3,).
    """

    panel: list[Plane]
    brackets: list[list[Plane]]
    inside: Array


def panel_solids(
    pattern: CreasePattern,
    layers: Sequence[Layer],
    axes: Array,
    motions: Sequence[Sequence[RigidMotion]],
    limits: Sequence[tuple[float, float]] | None,
    cuts: Sequence[Sequence[Plane]],
    slots: Sequence[tuple[float, float]],
    facets: Collection[int],
) -> list[PanelSolids]:
    """Return the convex solids of all panels.

    An axis outside a panel is carried by a bracket between panel and axis. Brackets may pass through other panels along
    the fold path, and lie in them in the flat-folded state: those panels have notches.

    Args:
        pattern: flat or folded as built.
        layers: panels over the facets.
        axes: heights of the axes of creases, m, (edge,).
        motions: motions of the facets from the position as built along the fold path, (pose, facet); the last pose is
            the flat-folded state.
        limits: least and largest fold angle of every edge, rad, to which panels are trimmed; None if they fold flat
            and keep the outlines of their facets.
        cuts: further planes of every panel, see `strip_cuts`.
        slots: parts of edges with the brackets of both facets, see `bracket_slots`.
        facets: facets whose panels are needed; others have only brackets.
    """
    sides = _sides(pattern)
    drafts = [
        _draft(pattern, layer, axes, facet, sides[facet], limits if limits is not None else (), cuts[facet], slots)
        for facet, layer in enumerate(layers)
    ]
    brackets = [
        (facet, piece)
        for facet, draft in enumerate(drafts)
        for planes in draft.brackets
        if (piece := piece_within(planes, draft.inside)) is not None
    ]
    turns = np.array([[motion.rotation for motion in pose] for pose in motions])
    shifts = np.array([[motion.shift for motion in pose] for pose in motions])
    result = []
    for facet, (draft, layer) in enumerate(zip(drafts, layers, strict=True)):
        whole = piece_within(draft.panel, draft.inside) if facet in facets else None
        slab = layer.slab(pattern.vertices_coords[pattern.faces_vertices[facet][0]])
        notches = list[Piece]()
        for carrier, bracket in brackets:
            if carrier != facet and whole is not None:
                moved = relative_motions((turns[:, facet], shifts[:, facet]), (turns[:, carrier], shifts[:, carrier]))
                notches += bracket_notches(whole, slab, bracket, moved, draft.inside)
        pieces = [] if whole is None else [whole]
        for notch in notches:
            pieces = [
                part for piece in pieces for part in pieces_without(piece, notch, slab.least_overlap, draft.inside)
            ]
        carried = [bracket.solid for carrier, bracket in brackets if carrier == facet]
        kept = [piece.solid for piece in pieces]
        loose = _loose_pieces(kept, carried, layer.thickness) if notches and kept else []
        result.append(
            PanelSolids(
                pieces=tuple(piece for piece in kept if piece not in (loose or ())),
                brackets=tuple(carried),
                notches=(*(notch.solid for notch in notches), *(loose or ())),
                divided=loose is None,
            )
        )
    return result


def _loose_pieces(
    pieces: Sequence[ConvexSolid], brackets: Sequence[ConvexSolid], thickness: float
) -> list[ConvexSolid] | None:
    """Return small pieces that notches separate from a panel; None if they separate large ones or brackets."""
    solids = [*pieces, *brackets]
    parts = connected_parts(solids, _HELD * thickness)
    if len(parts) == 1:
        return []
    volumes = [volume_of([solids[number] for number in part]) for part in parts]
    largest = int(np.argmax(volumes))
    loose = [number for part in parts if part is not parts[largest] for number in part]
    if max(loose) >= len(pieces) or sum(volumes) - volumes[largest] > _LOOSE * sum(volumes):
        return None
    return [solids[number] for number in loose]


def strip_cuts(
    pattern: CreasePattern,
    layers: Sequence[Layer],
    axes: Array,
    motions: Sequence[Sequence[RigidMotion]],
    meeting: Sequence[tuple[int, int]],
) -> list[list[Plane]]:
    """Return planes that cut the ends of strips, by facet, so that strips do not overlap at the vertex where they meet.

    Where two strips overlap most along the fold path, one of them ends at a face of the other one. The face is that
    which leaves the largest volume. This is repeated until they do not overlap.

    Args:
        pattern: flat or folded as built, with strips.
        layers: panels and strips.
        axes: heights of the axes of creases, m, (edge,).
        motions: motions of the facets from the position as built in every pose of the fold path, (pose, facet).
        meeting: pairs of strips with a common vertex.
    """
    sides, slots = _sides(pattern), [(0.0, 1.0)] * len(axes)
    cuts: list[list[Plane]] = [[] for _ in layers]
    for pair in meeting:
        moved = [_relative_motion(pose[pair[1]], pose[pair[0]]) for pose in motions]
        poses = (np.array([motion.rotation for motion in moved]), np.array([motion.shift for motion in moved]))
        stays = (np.repeat(_STAYS[0], len(moved), axis=0), np.zeros((len(moved), 3)))
        for _ in range(_MOST_CUTS):
            drafts = [
                _draft(pattern, layers[facet], axes, facet, sides[facet], (), cuts[facet], slots) for facet in pair
            ]
            one, other = (piece_within(draft.panel, draft.inside) for draft in drafts)
            if one is None or other is None:
                break
            depths = overlap_depths(one.solid, stays, other.solid, poses)
            worst = int(np.argmax(depths))
            if depths[worst] <= _TOUCHING * layers[pair[0]].thickness:
                break
            back = _relative_motion(motions[worst][pair[0]], motions[worst][pair[1]])
            tried = [
                (cut, Plane(-face.normal, -face.offset))
                for cut, motion in ((0, moved[worst]), (1, back))
                for face in (moved_plane(plane, motion) for plane in drafts[1 - cut].panel[-2:])
            ]
            cuttings = [piece_within([*drafts[cut].panel, plane], drafts[cut].inside) for cut, plane in tried]
            volumes = [0.0 if piece is None else volume_of([piece.solid]) for piece in cuttings]
            cut, plane = tried[int(np.argmax(volumes))]
            cuts[pair[cut]].append(plane)
    return cuts


def _relative_motion(one: RigidMotion, other: RigidMotion) -> RigidMotion:
    """Return the motion of one body in the axes of another one."""
    back = other.rotation.T
    return RigidMotion(back @ one.rotation, back @ (one.shift - other.shift))


def panel_cores(
    pattern: CreasePattern,
    layers: Sequence[Layer],
    limits: Sequence[tuple[float, float]] | None,
    cuts: Sequence[Sequence[Plane]],
) -> tuple[Array | None, ...]:
    """Return the corners of a polygon in the mid-plane of each panel, m, (corner, 3), for contact.

    Everything within half the thickness of the polygon lies inside the panel without its notches, so that polygons of
    panels that do not overlap are at least a thickness apart.

    Args:
        pattern: flat or folded as built.
        layers: panels over the facets.
        limits: as for `panel_solids`.
        cuts: as for `panel_solids`.

    Returns:
        None for a panel without such a polygon.
    """
    sides = _sides(pattern)
    return tuple(_core(pattern, layer, facet, sides[facet], limits, cuts[facet]) for facet, layer in enumerate(layers))


def _core(
    pattern: CreasePattern,
    layer: Layer,
    facet: int,
    sides: Sequence[tuple[int, int, SharedEdge | None]],
    limits: Sequence[tuple[float, float]] | None,
    cuts: Sequence[Plane],
) -> Array | None:
    """Return the core of a panel, as `panel_cores`."""
    coords, half = pattern.vertices_coords, layer.thickness / 2
    planes = list[Plane]()
    for tail, head, edge in sides:
        outwards = np.cross(coords[head] - coords[tail], layer.normal)
        outwards = outwards / np.linalg.norm(outwards)
        limit = 0.0 if limits is None or edge is None else max(np.abs(limits[edge.edge]))
        # distance from the axis at which a ball of half the thickness touches the plane that bisects the folded panels
        inset = half / math.cos(limit / 2)
        planes.append(Plane(outwards, float(outwards @ layer.at(coords[tail], 0.0)) - inset))
    middle = layer.at(coords[list(pattern.faces_vertices[facet])].mean(axis=0), layer.level)
    base = float(middle @ layer.normal)
    for normal, offset in cuts:
        # a ball of half the thickness around a position in the mid-plane touches the plane
        upwards = float(normal @ layer.normal)
        planes.append(Plane(normal - upwards * layer.normal, offset - half - upwards * base))
    core = piece_within([*planes, Plane(layer.normal, base + half), Plane(-layer.normal, half - base)], middle)
    if core is None:
        return None
    corners = core.solid.corners
    heights = corners @ layer.normal - base
    faces = [list(face) for face in convex_faces(corners)]
    top = max(faces, key=lambda face: float(heights[face].min()))
    return np.asarray(corners[top] - half * layer.normal)


_STAYS = (np.eye(3)[None], np.zeros((1, 3)))


def _sides(pattern: CreasePattern) -> list[list[tuple[int, int, SharedEdge | None]]]:
    """Return tail and head of the sides of every facet, counterclockwise, and the creases along them."""
    creases: dict[tuple[int, int], SharedEdge] = {}
    for edge in shared_edges(pattern):
        creases |= {(edge.tail, edge.head): edge, (edge.head, edge.tail): edge}
    return [[(*side, creases.get(side)) for side in face_sides(face)] for face in pattern.faces_vertices]


def _draft(
    pattern: CreasePattern,
    layer: Layer,
    axes: Array,
    facet: int,
    sides: Sequence[tuple[int, int, SharedEdge | None]],
    limits: Sequence[tuple[float, float]],
    cuts: Sequence[Plane],
    slots: Sequence[tuple[float, float]],
) -> _Draft:
    """Return the planes of a panel and of its brackets."""
    coords, normal, half = pattern.vertices_coords, layer.normal, layer.thickness / 2
    outline, trimmed, brackets = list[Plane](), list[Plane](), list[list[Plane]]()
    for tail, head, edge in sides:
        outwards = np.cross(coords[head] - coords[tail], normal)
        outwards = outwards / np.linalg.norm(outwards)
        start = layer.at(coords[tail], 0.0)
        outline.append(Plane(outwards, float(outwards @ start)))
        if limits and edge is not None:
            # the upper half gets narrower towards its face where the panel rises, the lower half where it falls
            low, high = limits[edge.edge]
            for limit, upwards in ((max(high, 0.0), normal), (max(-low, 0.0), -normal)):
                leaning = outwards + math.tan(limit / 2) * upwards
                trimmed += [Plane(leaning, float(leaning @ start))] if limit else []
    base = float(layer.at(coords[sides[0][0]], 0.0) @ normal)

    def between(low: float, high: float) -> list[Plane]:
        return [Plane(normal, base + high), Plane(-normal, -base - low)]

    for (tail, head, edge), side in zip(sides, outline, strict=True):
        if edge is None or pattern.edges_assignment[edge.edge] == "F":
            continue
        away = float(axes[edge.edge]) - layer.level
        if abs(away) <= half * (1 + _ROUNDING):
            continue
        start_share, end_share = slots[edge.edge]
        middle_share = (start_share + end_share) / 2
        first, last = (start_share, middle_share) if edge.left == facet else (middle_share, end_share)
        if edge.tail != tail:
            first, last = 1 - last, 1 - first
        start, end = (layer.at(coords[tail] + share * (coords[head] - coords[tail]), 0.0) for share in (first, last))
        along = (end - start) / np.linalg.norm(end - start)
        walls = [Plane(-along, -float(along @ start)), Plane(along, float(along @ end))]
        walls.append(Plane(-side.normal, layer.thickness - side.offset))
        low, high = sorted((layer.level + math.copysign(half, away), float(axes[edge.edge])))
        brackets.append([*outline, *walls, *between(low, high)])
    middle = coords[list(pattern.faces_vertices[facet])].mean(axis=0)
    return _Draft(
        panel=[*outline, *trimmed, *cuts, *between(layer.level - half, layer.level + half)],
        brackets=brackets,
        inside=layer.at(middle, layer.level),
    )
