"""Parts of a structure that can touch: facets and plates as triangles with sides, and bars as thick lines."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from forficula.arrays import Array, Flags, Indices
from forficula.pattern.triangulation import ears
from forficula.structure.parts import GROUND, Facet, Plate
from forficula.structure.sheets.facets import facet_triangles
from forficula.structure.structure import Structure
from forficula.structure.surroundings import Contact
from forficula.structure.tree import built_hinges, built_points

# points that are nearer than this share of the span as built are one vertex
_SAME = 1e-9


@dataclass(frozen=True, kw_only=True, eq=False)
class TouchingParts:
    """Nodes, triangles and sides of the parts of a structure that push each other apart.

    A pair is a node and a triangle, or two sides. Parts that share a vertex at which they stay together, such as both
    facets at a crease, touch only with nodes and sides that do not meet at this vertex: near the vertex the thickness
    is ignored. Vertices that only coincide as built, such as those of parts of an assembly without a common joint, are
    not shared.

    Attributes:
        points: numbers of the structure's points at the nodes, (node,).
        vertices: number of the vertex of each node; nodes that coincide as built and stay together have the same
            vertex, (node,).
        triangles: three nodes each, (triangle, 3).
        sides: two nodes each, (side, 2).
        half: half the thickness, or the radius of a bar, by part, m, (part,).
        names: of the parts, (part,).
        node_parts: a part of each node, (node,).
        triangle_parts: part of each triangle, (triangle,).
        side_parts: first and last part of each side, (side, 2).
        node_apart: whether a node can touch triangles of a part, (node, part).
        side_apart: whether sides of two parts can touch, (part, part).
    """

    points: Indices
    vertices: Indices
    triangles: Indices
    sides: Indices
    half: Array
    names: tuple[str, ...]
    node_parts: Indices
    triangle_parts: Indices
    side_parts: Indices
    node_apart: Flags
    side_apart: Flags


@dataclass(frozen=True, kw_only=True, eq=False)
class _Part:
    """A part before its nodes are numbered: points of its triangles, sides and corners, and bodies beside it."""

    name: str
    half: float
    triangles: Sequence[tuple[int, ...]]
    sides: Sequence[tuple[int, int]]
    corners: Sequence[int]
    bodies: frozenset[int] = frozenset()
    bar: bool = False

    @property
    def points(self) -> set[int]:
        """Return the numbers of all points of the part."""
        return {*self.corners, *(point for corners in self.triangles for point in corners)}


def has_touching_facets(structure: Structure) -> bool:
    """Return whether facets or plates of a structure touch other parts."""
    return structure.contact is not None and bool(structure.plates or structure.facets)


def touching_parts(structure: Structure, contact: Contact) -> TouchingParts | None:
    """Return the parts of a structure that touch other parts; None if it has neither facets nor plates.

    Bars touch facets and plates here. The engine computes their contact with other bars.

    Args:
        structure: structure in any coherent units.
        contact: its contact, which has the thickness of facets and plates.
    """
    parts = [*_plates(structure, contact), *_facets(structure, contact)]
    if not parts:
        return None
    parts += _bars(structure)
    places = built_points(structure)
    points = np.array(sorted({point for part in parts for point in part.points}), dtype=np.int64)
    number = {point: node for node, point in enumerate(points.tolist())}
    vertices = _vertices(structure, places, points, _SAME * structure.span)
    triangles = [[number[point] for point in corners] for part in parts for corners in part.triangles]
    sides: dict[tuple[int, int], list[int]] = {}
    for owner, part in enumerate(parts):
        for tail, head in part.sides:
            one, other = number[tail], number[head]
            sides.setdefault((min(one, other), max(one, other)), []).append(owner)
    holds = np.zeros((len(parts), int(vertices.max(initial=-1)) + 1), dtype=bool)
    of_nodes = np.zeros((len(points), len(parts)), dtype=bool)
    corner = np.zeros(len(points), dtype=bool)
    for owner, part in enumerate(parts):
        nodes = [number[point] for point in part.points]
        holds[owner, vertices[nodes]] = True
        of_nodes[nodes, owner] = True
        corner[[number[point] for point in part.corners]] = True
    joined = (holds.astype(np.float32) @ holds.T.astype(np.float32)) > 0
    attached = _attached(structure, parts)
    # nodes inside a facet and on its sides must not keep it from folding at its vertices
    beside = (of_nodes.astype(np.float32) @ joined.astype(np.float32)) > 0
    node_apart = ~holds[:, vertices].T & (corner[:, None] | ~beside)
    node_apart &= (of_nodes.astype(np.float32) @ attached.astype(np.float32)) == 0
    return TouchingParts(
        points=points,
        vertices=vertices,
        triangles=np.array(triangles, dtype=np.int64).reshape(-1, 3),
        sides=np.array([*sides], dtype=np.int64).reshape(-1, 2),
        half=np.array([part.half for part in parts]),
        names=tuple(part.name for part in parts),
        node_parts=of_nodes.argmax(axis=1).astype(np.int64),
        triangle_parts=np.repeat(np.arange(len(parts)), [len(part.triangles) for part in parts]),
        side_parts=np.array([[owners[0], owners[-1]] for owners in sides.values()], dtype=np.int64).reshape(-1, 2),
        node_apart=node_apart,
        side_apart=~attached & ~np.eye(len(parts), dtype=bool),
    )


def _plates(structure: Structure, contact: Contact) -> Iterable[_Part]:
    """Yield the plates, split into triangles."""
    for plate in structure.plates:
        # thick panels with solids come nearer at their edges than their thickness
        body, corners = structure.bodies[plate.body], plate.core or plate.points
        places = np.array([structure.points[point].place for point in corners])
        cut = ears(places, range(len(corners)))
        yield _Part(
            name=body.label,
            half=_half(plate, contact),
            triangles=[tuple(corners[place] for place in triangle) for triangle in cut],
            sides=_around(corners),
            corners=corners,
            bodies=frozenset([plate.body]),
        )


def _half(part: Plate | Facet, contact: Contact) -> float:
    """Return half the touching distance of a plate or a facet, m."""
    return (contact.thickness if part.touching_distance is None else part.touching_distance) / 2


def _facets(structure: Structure, contact: Contact) -> Iterable[_Part]:
    """Yield the facets between points of several bodies."""
    triangles, owners = facet_triangles(structure)
    for number, facet in enumerate(structure.facets):
        yield _Part(
            name=f"facet {facet.name.removeprefix('facet')}",
            half=_half(facet, contact),
            triangles=[tuple(corners) for corners in triangles[owners == number].tolist()],
            sides=_around(facet.points),
            corners=facet.points,
        )


def _bars(structure: Structure) -> Iterable[_Part]:
    """Yield the bars of bodies."""
    for bar in structure.bars:
        body = structure.bodies[bar.body]
        near = {bar.body, body.parent} | {
            number for number, other in enumerate(structure.bodies) if other.parent == bar.body
        }
        yield _Part(
            name=body.name,
            half=bar.diameter / 2,
            triangles=[],
            sides=[bar.points],
            corners=bar.points,
            bodies=frozenset(near),
            bar=True,
        )


def _around(corners: Sequence[int]) -> list[tuple[int, int]]:
    """Return the sides of a polygon."""
    return list(zip(corners, [*corners[1:], corners[0]], strict=True))


def _vertices(structure: Structure, places: Array, points: Indices, same: float) -> Indices:
    """Number nodes so that nodes that coincide as built and stay together have the same number, (node,).

    Args:
        structure: structure with the points.
        places: positions of all of its points as built, m, (point, 3).
        points: numbers of the points at the nodes, (node,).
        same: distance of positions that coincide, m.
    """
    near = cKDTree(places[points]).query_ball_point(places[points], same)
    clusters: dict[int, list[int]] = {}
    for node, nodes in enumerate(near):
        clusters.setdefault(min(nodes), []).append(node)
    axes = built_hinges(structure)
    first = np.arange(len(points))
    for nodes in clusters.values():
        bodies = [structure.points[point].body for point in points[nodes].tolist()]
        if len(nodes) > 1:
            joined = _joined_bodies(structure, axes, places, points[nodes[0]], same) if len(set(bodies)) > 1 else {}
            seen: dict[int, int] = {}
            for node, body in zip(nodes, bodies, strict=True):
                first[node] = seen.setdefault(joined.get(body, body), node)
    return np.asarray(np.unique(first, return_inverse=True)[1].ravel(), dtype=np.int64)


def _joined_bodies(
    structure: Structure, axes: tuple[Array, Array], places: Array, point: int, same: float
) -> dict[int, int]:
    """Return a number for every body, equal for bodies that stay together at a point: by joints, closures and springs.

    Args:
        structure: structure with the bodies.
        axes: positions, m, and directions of the axes of its hinges, (hinge, 3) each.
        places: positions of its points as built, m, (point, 3).
        point: number of the point.
        same: distance of positions that coincide, m.
    """
    place = places[point]
    beside = np.linalg.norm(np.cross(place - axes[0], axes[1]), axis=1) > same if len(axes[0]) else np.zeros(0)
    turned = {hinge.body for hinge, off in zip(structure.hinges, beside, strict=True) if off}
    pairs = [
        (number, body.parent)
        for number, body in enumerate(structure.bodies)
        if number not in turned and not body.slides and not body.turns
    ]
    pairs += [closure.bodies for closure in structure.closures]
    pairs += [
        (structure.points[one].body, structure.points[other].body)
        for one, other in (spring.points for spring in structure.springs if not spring.rest_length)
        if max(np.linalg.norm(places[end] - place) for end in (one, other)) <= same
    ]
    first = {number: number for number in range(GROUND, len(structure.bodies))}
    for one, other in pairs:
        low, high = sorted((first[one], first[other]))
        if low != high:
            first = {body: low if root == high else root for body, root in first.items()}
    return first


def _attached(structure: Structure, parts: Sequence[_Part]) -> Flags:
    """Return whether two parts do not touch because the bodies of bars are beside them, or because both are bars."""
    attached = np.zeros((len(parts), len(parts)), dtype=bool)
    for one, part in enumerate(parts):
        for other, beside in enumerate(parts[:one]):
            if part.bar and (beside.bar or part.bodies & _bodies(structure, beside)):
                attached[one, other] = attached[other, one] = True
    return attached


def _bodies(structure: Structure, part: _Part) -> set[int]:
    """Return the bodies that carry the points of a part, and those beside a bar."""
    return {*part.bodies, *(structure.points[point].body for point in part.points)} - {GROUND}
