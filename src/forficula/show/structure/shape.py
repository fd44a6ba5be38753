"""What is drawn of a structure: sheets, plates, bars, tendons and creases, laid between few points that move."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Literal

import numpy as np
import scipy

from forficula.arrays import Array, Indices
from forficula.pattern.geometry import polygon_normal
from forficula.pattern.triangulation import ears
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

# lengths by that of the whole: what lies on what, and the thickness of lines where there are no bars
_TOLERANCE, _THICKNESS = 1e-7, 0.02
_BY_SIDE = 0.12  # that thickness by the length of a facet's side, where that is less
_DIGITS = 12  # of a share


@dataclass(frozen=True, kw_only=True)
class DrawnBar:
    """A straight round bar.

    Attributes:
        ends: two vertices.
        radius: m.
        crease: letter of the crease that it lies on; "B" where it lies on none.
    """

    ends: tuple[int, int]
    radius: float
    crease: str


@dataclass(frozen=True, kw_only=True)
class ShapeLine:
    """A line on a sheet or a plate.

    Attributes:
        kind: "crease" where it folds, "rim" of a sheet, or "edge" of a plate.
        crease: letter of a crease; "B" of the others.
        path: vertices that it is straight between.
        hinge: number of the hinge that it is, whose angle it shows; None of others.
    """

    kind: Literal["crease", "rim", "edge"]
    crease: str
    path: tuple[int, ...]
    hinge: int | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class Shape:
    """What is drawn of a structure, by vertices that each lie between two points that move.

    Attributes:
        anchors: numbers of the points that move: those of the structure, then, counted on, nodes of its membranes.
        between: the two anchors of each vertex, places in `anchors`, (vertex, 2).
        share: how far it is from the first to the second, 0 to 1, (vertex,).
        built: vertices in the built shape, m, (vertex, 3).
        faces: of sheets and plates, three or four vertices each, counterclockwise seen from above the built shape.
        face_region: number of each one's region, (face,).
        regions: what these are called, such as "distal panel".
        solid: whether a region is of plates rather than of a sheet, (region,).
        bars: of the structure, in its order.
        lines: rims, creases and edges of plates.
        tendons: two vertices each, in the structure's order.
        joints: vertices of the hinges at the ends of bars, (joint,).
        held: vertices of facets that cannot go every way, (vertex,).
        thickness: of what lines are drawn by: that of the thickest bar, m.
        span: of the structure, m.
    """

    anchors: Indices
    between: Indices
    share: Array
    built: Array
    faces: tuple[tuple[int, ...], ...]
    face_region: Indices
    regions: tuple[str, ...]
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
    """Vertices collected so far, each once, by two anchors and the share between them."""

    numbers: dict[tuple[int, int, float], int] = field(default_factory=dict)

    def at(self, first: int, second: int, share: float) -> int:
        place = (first, first, 0.0) if share == 0 else (second, second, 0.0) if share == 1 else (first, second, share)
        return self.numbers.setdefault(place, len(self.numbers))


def shape_of(structure: Structure) -> Shape:
    """Lay out what is drawn of a structure."""
    vertices = _Vertices()
    faces: list[tuple[int, ...]] = []
    names: list[str] = []
    first = len(structure.points)
    # where there are facets, they are what a membrane lies on
    for membrane in () if structure.facets else structure.membranes:
        _add_sheet(vertices, structure, membrane, first, faces, names)
        first += len(membrane.bodies)
    for point in drawn_points(structure):
        vertices.at(point, point, 0.0)
    keys = list(vertices.numbers)
    rims = [
        ShapeLine(kind="rim", crease="B", path=(min(ends), max(ends)))
        for ends, count in _sides(faces).items()
        if count == 1 and not _along_bar(structure, (keys[end] for end in ends))
    ]
    triangles, _ = facet_triangles(structure)
    faces += (tuple(vertices.at(point, point, 0.0) for point in corners) for corners in triangles.tolist())
    names += ["facet"] * len(triangles)
    sheets, edges = set(names), list[ShapeLine]()
    anchors = np.concatenate([built_points(structure), *(membrane.built for membrane in structure.membranes)])
    for plate in structure.plates:
        corners = [vertices.at(point, point, 0.0) for point in plate.points]
        edges += (ShapeLine(kind="edge", crease="B", path=ends) for ends in pairwise([*corners, corners[0]]))
        pieces = drawn_pieces(anchors[list(plate.points)])
        faces += (tuple(corners[corner] for corner in piece) for piece in pieces)
        names += [structure.bodies[plate.body].role] * len(pieces)
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
    regions = tuple(dict.fromkeys(names))
    hinged = {hinge.body for hinge in structure.hinges}
    used, places = np.unique(pairs, return_inverse=True)
    return Shape(
        anchors=used,
        between=places.reshape(-1, 2),
        share=share,
        built=built,
        faces=tuple(faces),
        face_region=np.array([regions.index(name) for name in names], dtype=np.int64),
        regions=regions,
        solid=tuple(region not in sheets for region in regions),
        bars=tuple(
            DrawnBar(
                ends=(vertices.at(bar.points[0], bar.points[0], 0.0), vertices.at(bar.points[1], bar.points[1], 0.0)),
                radius=bar.diameter / 2,
                crease=letter,
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


def vertex_places(shape: Shape, anchors: Array) -> Array:
    """Where the vertices are, m, (..., vertex, 3), with the anchors at (..., anchor, 3)."""
    first, second = anchors[..., shape.between[:, 0], :], anchors[..., shape.between[:, 1], :]
    return np.asarray(first + shape.share[:, np.newaxis] * (second - first))


def facet_lines(structure: Structure, vertex: Callable[[int], int]) -> list[ShapeLine]:
    """The creases between facets, and their sides that no other facet has, by what finds the vertex at a point."""
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
    """By what lines are drawn where there are no bars, m: less where facets are small."""
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
) -> None:
    """The faces of a membrane, and of the strips by which it is glued to bars: that is sheet, too."""
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
        # what lies beyond a hinge counts with what is beyond
        outermost = max((int(membrane.bodies[corner]) for corner in corners), key=lambda body: depths[body])
        faces.append(tuple(face))
        names.append(f"{structure.bodies[outermost].role} panel")

    pieces = _quads(membrane.triangles, membrane.built)
    once = _sides(pieces)
    for piece in pieces:
        for one, other in pairwise([*piece, piece[0]]):
            start, end = roots[one], roots[other]
            if once[frozenset((one, other))] == 1 and start is not None and end is not None:
                add((one, other), (start, end, nodes[other], nodes[one]))
        add(piece, [nodes[corner] for corner in piece])


def _quads(triangles: Indices, built: Array) -> list[tuple[int, ...]]:
    """Two triangles one after another that are halves of a quadrilateral as that, the others as they are."""
    pieces: list[tuple[int, ...]] = []
    for corners in map(tuple, triangles.tolist()):
        last = pieces[-1] if pieces else ()
        if len(last) == 3 and corners[:2] == (last[0], last[2]) and is_convex(built[[*last, corners[2]]]):
            pieces[-1] = (*last, corners[2])
        else:
            pieces.append(corners)
    return pieces


def _sides(faces: Iterable[Sequence[int]]) -> Counter[frozenset[int]]:
    """How many faces have a side, by its two ends."""
    return Counter(frozenset(ends) for face in faces for ends in pairwise([*face, face[0]]))


def _on_bar(structure: Structure, body: int, place: Array) -> tuple[int, int, float] | None:
    """The ends of a body's bar, and how far a place in the body's axes is from the first to the second; None beside."""
    for bar in structure.bars:
        if bar.body == body:
            share = float(place @ bar.end) / float(bar.end @ bar.end)
            away = float(np.linalg.norm(place - share * bar.end))
            if away <= _TOLERANCE * structure.span and -_TOLERANCE <= share <= 1 + _TOLERANCE:
                return (*bar.points, round(min(max(share, 0.0), 1.0), _DIGITS))
    return None


def _place(structure: Structure, point: int) -> tuple[int, int, float]:
    """A point by the ends of the bar that it lies on, or by itself."""
    chosen = structure.points[point]
    return _on_bar(structure, chosen.body, chosen.place) or (point, point, 0.0)


def _along_bar(structure: Structure, ends: Iterable[tuple[int, int, float]]) -> bool:
    """Whether both ends of a side lie on one bar."""
    places = {place for end in ends for place in end[:2]}
    return any(places <= set(bar.points) for bar in structure.bars)


def _creases(
    structure: Structure, anchors: Array, built: Array, faces: Sequence[Sequence[int]], names: Sequence[str]
) -> tuple[list[str], list[ShapeLine]]:
    """The letter of every bar, and the creases on which no bar lies."""
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
    # what is beside the pattern is on none of its edges
    found = np.where(away <= within, nearest, -1).reshape(-1, 2)
    bars = [frozenset(pair) for pair in found.tolist()]
    lines = []
    for edge in pattern.edges_vertices.tolist():
        letter = letters[frozenset(edge)]
        if letter == "B" or frozenset(edge) in bars:
            continue
        path = _on_segment(built, pattern.vertices_coords[edge], within)
        if len(path) > 1:
            lines.append(ShapeLine(kind="crease", crease=letter, path=path))
    return [letters.get(bar, "B") for bar in bars], lines


def _on_segment(built: Array, segment: Array, within: float) -> tuple[int, ...]:
    """Vertices from one place to another, those between them in order; none where these are not at vertices."""
    start, end = segment
    length = float(np.linalg.norm(end - start))
    along = (built - start) @ (end - start) / length
    beside = np.linalg.norm(built - start - along[:, np.newaxis] * (end - start) / length, axis=1)
    there = np.flatnonzero((beside <= within) & (along >= -within) & (along <= length + within))
    path: list[int] = []
    for vertex in there[np.argsort(along[there], kind="stable")].tolist():
        if not path or along[vertex] > along[path[-1]] + within:
            path.append(vertex)
    whole = bool(path) and along[path[0]] <= within and along[path[-1]] >= length - within
    return tuple(path) if whole else ()


def _between_regions(faces: Sequence[Sequence[int]], names: Sequence[str]) -> list[ShapeLine]:
    """Where regions of a sheet meet: creases of which nothing else is known."""
    regions: dict[frozenset[int], set[str]] = {}
    for face, name in zip(faces, names, strict=True):
        for ends in pairwise([*face, face[0]]):
            regions.setdefault(frozenset(ends), set()).add(name)
    return [
        ShapeLine(kind="crease", crease="B", path=(min(ends), max(ends)))
        for ends, found in regions.items()
        if len(found) > 1
    ]


def is_convex(corners: Array) -> bool:
    """Return whether no corner of a polygon, m, (corner, axis), points inwards."""
    sides = np.roll(corners, -1, axis=0) - corners
    return bool((np.cross(sides, np.roll(sides, -1, axis=0)) @ polygon_normal(corners) >= 0).all())


def drawn_pieces(corners: Array) -> list[tuple[int, ...]]:
    """Cut a flat polygon without crossings into pieces of three or four corners.

    Args:
        corners: m, (corner, axis).

    Returns:
        Numbers of the corners of each piece, counterclockwise seen from above, or in the order given where the polygon
        stands upright. A convex polygon of four corners is one piece.
    """
    around = range(len(corners)) if polygon_normal(corners)[2] >= 0 else range(len(corners))[::-1]
    return [tuple(around)] if len(around) == 4 and is_convex(corners) else [*ears(corners, around)]
