"""Drawn parts of a structure: sheets, plates, bars, tendons and creases between few points that move."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Literal

import numpy as np
import scipy

from forficula.arrays import Array, Indices
from forficula.show.structure.drawn_polygons import convex_pieces, drawn_pieces, plate_polygons, quads
from forficula.structure import (
    Membrane,
    Structure,
    ancestry,
    built_points,
    drawn_points,
    facet_triangles,
    held_corners,
    hinge_groups,
)

# lengths in spans: tolerance of positions, and thickness of lines without bars
_TOLERANCE, _THICKNESS = 1e-7, 0.02
_BY_SIDE = 0.12  # largest thickness, as a share of the length of a facet's side
_DIGITS = 12  # decimals of a share


@dataclass(frozen=True, kw_only=True)
class DrawnBar:
    """Straight round bar.

    Attributes:
        ends: its two vertices.
        radius: radius, m.
        crease: letter of the crease on which it lies; "B" for none.
        region: region whose hue it has, which is a group of bodies; None without one.
    """

    ends: tuple[int, int]
    radius: float
    crease: str
    region: int | None = None


@dataclass(frozen=True, kw_only=True)
class ShapeLine:
    """Line on a sheet or a plate.

    Attributes:
        kind: "crease", "rim" of a sheet, or "edge" of a plate.
        crease: letter of a crease; "B" for other lines.
        path: vertices, connected by straight pieces.
        hinge: index of the hinge whose angle the line shows; None for other lines.
    """

    kind: Literal["crease", "rim", "edge"]
    crease: str
    path: tuple[int, ...]
    hinge: int | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class Shape:
    """Drawn parts of a structure, given by vertices that each lie between two moving points.

    Attributes:
        anchors: indices of the moving points: points of the structure and then nodes of its membranes.
        between: the two anchors of each vertex, indices into `anchors`, (vertex, 2).
        share: position between the first (0) and the second anchor (1), (vertex,).
        built: vertices in the built shape, m, (vertex, 3).
        faces: of sheets and plates, three or four vertices each, counterclockwise seen from above the built shape.
        face_region: region of each face, (face,).
        regions: names of the regions: of groups of bodies if the structure has two or more, else of parts such as
            "distal panel".
        grouped: whether regions are groups of bodies.
        solid: whether the region consists of plates and not of a sheet, (region,).
        bars: bars, in the structure's order.
        lines: rims, creases and edges of plates.
        tendons: two vertices each, in the structure's order.
        joints: vertices of the hinges at the ends of bars, (joint,).
        held: supported vertices of facets, (vertex,).
        thickness: reference for the width of lines: the diameter of the thickest bar, m.
        span: span of the structure, m.
    """

    anchors: Indices
    between: Indices
    share: Array
    built: Array
    faces: tuple[tuple[int, ...], ...]
    face_region: Indices
    regions: tuple[str, ...]
    grouped: bool
    solid: tuple[bool, ...]
    bars: tuple[DrawnBar, ...]
    lines: tuple[ShapeLine, ...]
    tendons: tuple[tuple[int, int], ...]
    joints: Indices
    held: Indices
    thickness: float
    span: float


@dataclass
class _Vertices:
    """Distinct vertices, each identified by two anchors and the share between them."""

    numbers: dict[tuple[int, int, float], int] = field(default_factory=dict)

    def at(self, first: int, second: int, share: float) -> int:
        place = (first, first, 0.0) if share == 0 else (second, second, 0.0) if share == 1 else (first, second, share)
        return self.numbers.setdefault(place, len(self.numbers))


def shape_of(structure: Structure) -> Shape:
    """Return the drawn parts of a structure."""
    vertices = _Vertices()
    faces: list[tuple[int, ...]] = []
    # name of the part to which each face belongs, and its body
    names: list[str] = []
    carriers: list[int] = []
    first = len(structure.points)
    corner_bodies = {
        structure.points[point].body for facet in structure.facets for point in (*facet.points, *facet.inside)
    }
    for membrane in structure.membranes:
        # facets include the membranes that lie on them
        if not set(membrane.bodies.tolist()) <= corner_bodies:
            _add_sheet(vertices, structure, membrane, first, faces, names, carriers)
        first += len(membrane.bodies)
    for point in drawn_points(structure):
        vertices.at(point, point, 0.0)
    keys = list(vertices.numbers)
    rims = [
        ShapeLine(kind="rim", crease="B", path=(min(ends), max(ends)))
        for ends, count in _sides(faces).items()
        if count == 1 and not _along_bar(structure, (keys[end] for end in ends))
    ]
    on_sheets = len(faces)
    triangles, _ = facet_triangles(structure)
    faces += (tuple(vertices.at(point, point, 0.0) for point in corners) for corners in triangles.tolist())
    names += ["facet"] * len(triangles)
    carriers += (max(structure.points[point].body for point in corners) for corners in triangles.tolist())
    before_plates, edges = len(faces), list[ShapeLine]()
    anchors = np.concatenate([built_points(structure), *(membrane.built for membrane in structure.membranes)])
    for plate in structure.plates:
        pieces = list[tuple[int, ...]]()
        for polygon in plate_polygons(plate, anchors):
            corners = [vertices.at(point, point, 0.0) for point in polygon]
            ends = pairwise([*corners, corners[0]])
            edges += (
                ShapeLine(kind="edge", crease="B", path=pair) for pair in ends if pair[0] < pair[1] or not plate.solids
            )
            drawn = drawn_pieces(anchors[list(polygon)]) if not plate.solids else convex_pieces(len(polygon))
            pieces += (tuple(corners[corner] for corner in piece) for piece in drawn)
        faces += pieces
        names += [structure.bodies[plate.body].role] * len(pieces)
        carriers += [plate.body] * len(pieces)
    on_sheet = len(vertices.numbers)
    tendons = tuple(
        (vertices.at(*_place(structure, ends[0])), vertices.at(*_place(structure, ends[1])))
        for ends in (tendon.points for tendon in structure.tendons)
    )
    keys = list(vertices.numbers)
    share = np.array([key[2] for key in keys])
    pairs = np.array([key[:2] for key in keys], dtype=np.int64).reshape(-1, 2)
    built = anchors[pairs[:, 0]] + share[:, np.newaxis] * (anchors[pairs[:, 1]] - anchors[pairs[:, 0]])
    letters, creases = _creases(structure, anchors, built[:on_sheet], faces, names)
    if structure.facets:
        creases = facet_lines(structure, lambda point: vertices.at(point, point, 0.0))
        creases += _between_regions(faces[:on_sheets], names[:on_sheets])
    groups = _groups(structure)
    group_names = tuple(dict.fromkeys(groups.values()))
    named = [groups.get(body, name) for body, name in zip(carriers, names, strict=True)]
    regions = tuple(dict.fromkeys((*group_names, *named)))
    hinged = {hinge.body for hinge in structure.hinges}
    used, places = np.unique(pairs, return_inverse=True)
    return Shape(
        anchors=used,
        between=places.reshape(-1, 2),
        share=share,
        built=built,
        faces=tuple(faces),
        face_region=np.array([regions.index(name) for name in named], dtype=np.int64),
        regions=regions,
        grouped=bool(groups),
        solid=tuple(region in set(named[before_plates:]) - set(named[:before_plates]) for region in regions),
        bars=tuple(
            DrawnBar(
                ends=(vertices.at(bar.points[0], bar.points[0], 0.0), vertices.at(bar.points[1], bar.points[1], 0.0)),
                radius=bar.diameter / 2,
                crease="B" if bar.body in groups else letter,
                region=regions.index(groups[bar.body]) if bar.body in groups else None,
            )
            for bar, letter in zip(structure.bars, letters, strict=True)
        ),
        lines=(*rims, *creases, *edges),
        tendons=tendons,
        joints=np.array(
            [vertices.at(bar.points[0], bar.points[0], 0.0) for bar in structure.bars if bar.body in hinged],
            dtype=np.int64,
        ),
        held=np.array([vertices.at(point, point, 0.0) for point in held_corners(structure)], dtype=np.int64),
        thickness=max((bar.diameter for bar in structure.bars), default=_line_thickness(structure, built, creases)),
        span=structure.span,
    )


def _groups(structure: Structure) -> dict[int, str]:
    """Return the name of the group of each body, if the structure has two groups of bodies or more."""
    if len(structure.groups) < 2:
        return {}
    return {body: group.name for group in structure.groups for body in group.bodies}


def vertex_places(shape: Shape, anchors: Array) -> Array:
    """Return the positions of vertices, m, (..., vertex, 3), from those of the anchors, (..., anchor, 3)."""
    first, second = anchors[..., shape.between[:, 0], :], anchors[..., shape.between[:, 1], :]
    return np.asarray(first + shape.share[:, np.newaxis] * (second - first))


def facet_lines(structure: Structure, vertex: Callable[[int], int]) -> list[ShapeLine]:
    """Return the creases between facets and the rims, with a function that returns the vertex of a point."""
    hinges = [(number, structure.hinges[number]) for number in hinge_groups(structure).get("creases", ())]
    sides = _sides(facet.points for facet in structure.facets)
    rims = [ShapeLine(kind="rim", crease="B", path=tuple(map(vertex, ends))) for ends in sides if sides[ends] == 1]
    creases = []
    for number, hinge in hinges:
        assert hinge.flaps is not None
        letter = hinge.assignment if hinge.assignment in ("M", "V") else "B"
        path = (vertex(hinge.flaps[0]), vertex(hinge.flaps[1]))
        creases.append(ShapeLine(kind="crease", crease=letter, path=path, hinge=number))
    return [*rims, *creases]


def _line_thickness(structure: Structure, built: Array, lines: Sequence[ShapeLine]) -> float:
    """Return the reference for the width of lines without bars, m: smaller for small facets."""
    sides = [float(np.linalg.norm(built[line.path[-1]] - built[line.path[0]])) for line in lines]
    most = _THICKNESS * structure.span
    return min(most, _BY_SIDE * float(np.mean(sides))) if structure.facets else most


def _add_sheet(
    vertices: _Vertices,
    structure: Structure,
    membrane: Membrane,
    first: int,
    faces: list[tuple[int, ...]],
    names: list[str],
    carriers: list[int],
) -> None:
    """Add the faces of a membrane, and of the strips between it and the bars to which it is glued."""
    roots, nodes = [], []
    for number, (body, place) in enumerate(zip(membrane.bodies.tolist(), membrane.places, strict=True)):
        root = place if membrane.roots is None else membrane.roots[number]
        glued = bool(np.linalg.norm(root - place) > _TOLERANCE * structure.span)
        on_bar = _on_bar(structure, body, root)
        roots.append(vertices.at(*on_bar) if glued and on_bar else None)
        on_axis = on_bar is not None and not glued
        nodes.append(vertices.at(*on_bar) if on_bar and on_axis else vertices.at(first + number, first + number, 0.0))
    depths = {body: len(ancestry(structure, body)) for body in set(membrane.bodies.tolist())}

    def add(corners: Sequence[int], face: Sequence[int]) -> None:
        # a face across a hinge belongs to the outer region
        outermost = max((int(membrane.bodies[corner]) for corner in corners), key=lambda body: depths[body])
        faces.append(tuple(face))
        names.append(f"{structure.bodies[outermost].role} panel")
        carriers.append(outermost)

    pieces = quads(membrane.triangles, membrane.built)
    once = _sides(pieces)
    for piece in pieces:
        for one, other in pairwise([*piece, piece[0]]):
            start, end = roots[one], roots[other]
            if once[frozenset((one, other))] == 1 and start is not None and end is not None:
                add((one, other), (start, end, nodes[other], nodes[one]))
        add(piece, [nodes[corner] for corner in piece])


def _sides(faces: Iterable[Sequence[int]]) -> Counter[frozenset[int]]:
    """Count the faces at each side, by its two ends."""
    return Counter(frozenset(ends) for face in faces for ends in pairwise([*face, face[0]]))


def _on_bar(structure: Structure, body: int, place: Array) -> tuple[int, int, float] | None:
    """Return the ends of the bar on which a point of a body lies, and the share along the bar; None if on no bar."""
    for bar in structure.bars:
        if bar.body == body:
            share = float(place @ bar.end) / float(bar.end @ bar.end)
            away = float(np.linalg.norm(place - share * bar.end))
            if away <= _TOLERANCE * structure.span and -_TOLERANCE <= share <= 1 + _TOLERANCE:
                return (*bar.points, round(min(max(share, 0.0), 1.0), _DIGITS))
    return None


def _place(structure: Structure, point: int) -> tuple[int, int, float]:
    """Return a point as a share along its bar, or as itself."""
    chosen = structure.points[point]
    return _on_bar(structure, chosen.body, chosen.place) or (point, point, 0.0)


def _along_bar(structure: Structure, ends: Iterable[tuple[int, int, float]]) -> bool:
    """Return whether both ends of a side lie on one bar."""
    places = {place for end in ends for place in end[:2]}
    return any(places <= set(bar.points) for bar in structure.bars)


def _creases(
    structure: Structure, anchors: Array, built: Array, faces: Sequence[Sequence[int]], names: Sequence[str]
) -> tuple[list[str], list[ShapeLine]]:
    """Return the letter of every bar, and the creases without bars."""
    pattern = structure.appearance.pattern
    if pattern is None:
        return ["B"] * len(structure.bars), _between_regions(faces, names)
    within = _TOLERANCE * structure.span
    letters = {
        frozenset(edge): letter if letter in ("M", "V") else "B"
        for edge, letter in zip(pattern.edges_vertices.tolist(), pattern.edges_assignment, strict=True)
    }
    ends = [point for bar in structure.bars for point in bar.points]
    away, nearest = scipy.spatial.KDTree(pattern.vertices_coords).query(anchors[ends].reshape(-1, 3))
    # points beside the pattern are on none of its edges
    matched = np.where(away <= within, nearest, -1).reshape(-1, 2)
    bars = [frozenset(pair) for pair in matched.tolist()]
    # creases of thick panels are inside them
    inside = any(plate.solids for plate in structure.plates)
    lines = []
    for edge in pattern.edges_vertices.tolist():
        letter = letters[frozenset(edge)]
        if letter == "B" or frozenset(edge) in bars or inside:
            continue
        path = _on_segment(built, pattern.vertices_coords[edge], within)
        if len(path) > 1:
            lines.append(ShapeLine(kind="crease", crease=letter, path=path))
    return [letters.get(bar, "B") for bar in bars], lines


def _on_segment(built: Array, segment: Array, within: float) -> tuple[int, ...]:
    """Return the vertices along a segment, in order; empty if its ends are not vertices."""
    start, end = segment
    length = float(np.linalg.norm(end - start))
    along = (built - start) @ (end - start) / length
    beside = np.linalg.norm(built - start - along[:, np.newaxis] * (end - start) / length, axis=1)
    on_segment = np.flatnonzero((beside <= within) & (along >= -within) & (along <= length + within))
    path: list[int] = []
    for vertex in on_segment[np.argsort(along[on_segment], kind="stable")].tolist():
        if not path or along[vertex] > along[path[-1]] + within:
            path.append(vertex)
    whole = bool(path) and along[path[0]] <= within and along[path[-1]] >= length - within
    return tuple(path) if whole else ()


def _between_regions(faces: Sequence[Sequence[int]], names: Sequence[str]) -> list[ShapeLine]:
    """Return the lines between regions of a sheet: creases without an assignment."""
    regions: dict[frozenset[int], set[str]] = {}
    for face, name in zip(faces, names, strict=True):
        for ends in pairwise([*face, face[0]]):
            regions.setdefault(frozenset(ends), set()).add(name)
    return [
        ShapeLine(kind="crease", crease="B", path=(min(ends), max(ends)))
        for ends, names_at in regions.items()
        if len(names_at) > 1
    ]
