"""Crease patterns: vertices, edges and faces of a sheet, and conditions for flat folding of its vertices."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import lru_cache

import numpy as np

from forficula.arrays import Array, Indices
from forficula.errors import InputError

ASSIGNMENTS = {"B": "border", "M": "mountain", "V": "valley", "F": "flat", "U": "unassigned", "C": "cut"}
_EQUAL_SECTORS = 1e-9  # rad; sectors closer than this count as equal, far above rounding and below any real design
_SHORTEST_EDGE = 1e-100  # of the size of the sheet; the squares of shorter edges are lost in rounding


@dataclass(frozen=True, kw_only=True, eq=False)
class CreasePattern:
    """Vertices, edges and faces of a sheet, as in the FOLD 1.2 format but in metres and radians.

    Arrays are copied and made read-only.

    Attributes:
        vertices_coords: positions, m, shape (N, 3).
        edges_vertices: the two vertices of every edge, shape (E, 2).
        edges_assignment: E letters: "B" border, "M" mountain, "V" valley, "F" flat, "U" unassigned, "C" cut.
        edges_fold_angle: rad, shape (E,), valley positive, flat 0; nan without a fold angle, as on a border.
        faces_vertices: the vertices of every face, counterclockwise seen from +z; each side is an edge.
        edges_role: E labels such as "ring"; if empty, every label is "".
        title: title of the sheet.
        edges_fold: number of the fold of every edge, shape (E,): two parallel edges that replace a fold of thick panels
            (`split_sheet`) are one fold; if empty, every edge is a fold.
    """

    vertices_coords: Array
    edges_vertices: Indices
    edges_assignment: tuple[str, ...]
    edges_fold_angle: Array
    faces_vertices: tuple[tuple[int, ...], ...]
    edges_role: tuple[str, ...] = ()
    title: str = ""
    edges_fold: Indices = field(default_factory=lambda: np.zeros(0, dtype=np.int64))

    def __post_init__(self) -> None:
        coords = _checked_coords(self.vertices_coords)
        edges = check_edges(self.edges_vertices, coords)
        edge_count = len(edges)
        fold_angle = _real_array(self.edges_fold_angle, "edges_fold_angle")
        if fold_angle.shape != (edge_count,):
            raise InputError(f"edges_fold_angle: need shape ({edge_count},), got {fold_angle.shape}")
        if np.isinf(fold_angle).any():
            raise InputError(
                f"edges_fold_angle[{int(np.argmax(np.isinf(fold_angle)))}]: need a finite angle or nan, got inf"
            )
        _check_letters(self.edges_assignment, edge_count)
        roles = tuple(self.edges_role) or ("",) * edge_count
        if len(roles) != edge_count:
            raise InputError(f"edges_role: need one label for each of the {edge_count} edges, got {len(roles)}")
        fold = np.array(self.edges_fold, dtype=np.int64)
        # also in a copy with other edges
        fold = np.arange(edge_count) if np.array_equal(fold, np.arange(len(fold))) else fold
        if fold.shape != (edge_count,) or ((fold < 0) | (fold >= edge_count)).any():
            raise InputError(
                f"edges_fold: need {edge_count} numbers from 0 to {edge_count - 1}, got {fold[:12].tolist()}"
            )
        _check_folds(fold, self.edges_assignment)
        for array in (coords, edges, fold_angle, fold):
            array.setflags(write=False)
        object.__setattr__(self, "vertices_coords", coords)
        object.__setattr__(self, "edges_vertices", edges)
        object.__setattr__(self, "edges_assignment", tuple(self.edges_assignment))
        object.__setattr__(self, "edges_fold_angle", fold_angle)
        object.__setattr__(self, "edges_role", roles)
        object.__setattr__(self, "edges_fold", fold)
        object.__setattr__(self, "faces_vertices", _checked_faces(self.faces_vertices, len(coords), edges))

    @property
    def edges_share(self) -> Array:
        """Part of the angle of its fold by which every edge folds, (edge,): 1/2 for each of two edges, else 1."""
        return np.asarray(1 / np.bincount(self.edges_fold)[self.edges_fold])


def _check_folds(folds: Indices, letters: tuple[str, ...]) -> None:
    """Check the letters of edges that are one fold."""
    _, first, place = np.unique(folds, return_index=True, return_inverse=True)
    for edge in np.flatnonzero(first[place] != np.arange(len(folds))).tolist():
        if (both := letters[first[place[edge]]] + letters[edge]) not in ("MM", "VV"):
            raise InputError(f"edges_fold[{edge}]: need two mountains or valleys as one fold, got letters {both}")


def _real_array(values: object, key: str) -> Array:
    """Copy to float64."""
    try:
        return np.array(values, dtype=np.float64)
    except (TypeError, ValueError, OverflowError) as error:
        raise InputError(f"{key}: need an array of numbers, got {type(values).__name__} ({error})") from error


def _checked_coords(values: object) -> Array:
    """Copy the positions of the vertices."""
    coords = _real_array(values, "vertices_coords")
    if coords.ndim != 2 or coords.shape[1] != 3 or len(coords) == 0:
        raise InputError(f"vertices_coords: need shape (vertices, 3), got {coords.shape}")
    finite = np.isfinite(coords).all(axis=1)
    if not finite.all():
        vertex = int(np.argmin(finite))
        raise InputError(f"vertices_coords[{vertex}]: need finite numbers, got {coords[vertex].tolist()} m")
    return coords


def check_edges(values: object, coords: Array) -> Indices:
    """Copy the edges of a pattern and check them.

    Args:
        values: vertex numbers, shape (E, 2).
        coords: positions of the vertices, m, shape (N, 3).

    Returns:
        The checked edges, shape (E, 2).

    Raises:
        InputError: a vertex that does not exist, an edge shorter than 1e-100 of the sheet's size, a repeated edge.
    """
    array = np.asarray(values)
    if array.ndim != 2 or array.shape[1] != 2 or len(array) == 0:
        raise InputError(f"edges_vertices: need shape (edges, 2), got {array.shape}")
    if array.dtype.kind not in "iu":
        raise InputError(f"edges_vertices: need whole numbers, got {array.dtype}")
    edges = array.astype(np.int64)
    shortest = _SHORTEST_EDGE * float(np.ptp(coords, axis=0).max(initial=0)) if len(coords) else 0.0
    seen: dict[tuple[int, int], int] = {}
    for edge, (tail, head) in enumerate(edges.tolist()):
        for vertex in (tail, head):
            check_vertex(f"edges_vertices[{edge}]", vertex, len(coords))
        if tail == head or np.abs(coords[tail] - coords[head]).max() <= shortest:
            raise InputError(f"edges_vertices[{edge}]: need two vertices apart, got {tail} and {head} at one place")
        first = seen.setdefault((min(tail, head), max(tail, head)), edge)
        if first != edge:
            raise InputError(f"edges_vertices[{edge}]: need every edge once, got edge {first} again ({tail}, {head})")
    return edges


def check_vertex(key: str, vertex: int, count: int) -> None:
    """Refuse a vertex that does not exist.

    Raises:
        InputError: the number is not between 0 and count - 1.
    """
    if not 0 <= vertex < count:
        plural = "vertex" if count == 1 else "vertices"
        raise InputError(f"{key}: vertex {vertex} does not exist, the pattern has {count} {plural} (0 to {count - 1})")


def _check_letters(letters: Sequence[str], edge_count: int) -> None:
    """Refuse letters that the FOLD format does not define."""
    if len(letters) != edge_count:
        raise InputError(f"edges_assignment: need one letter for each of the {edge_count} edges, got {len(letters)}")
    for edge, letter in enumerate(letters):
        if letter not in ASSIGNMENTS:
            allowed = ", ".join(f"{known} ({meaning})" for known, meaning in ASSIGNMENTS.items())
            raise InputError(f"edges_assignment[{edge}]: need one of {allowed}, got {letter!r}")


def _checked_faces(faces: Sequence[Sequence[int]], vertex_count: int, edges: Indices) -> tuple[tuple[int, ...], ...]:
    """Copy and check the faces: vertices exist, every side is an edge, nothing is repeated."""
    if len(faces) == 0:
        raise InputError("faces_vertices: need at least one face, got none")
    known = {frozenset(pair) for pair in edges.tolist()}
    seen: dict[frozenset[frozenset[int]], int] = {}
    for number, face in enumerate(faces):
        if len(face) < 3:
            raise InputError(f"faces_vertices[{number}]: need at least 3 vertices, got {len(face)}")
        for vertex in face:
            check_vertex(f"faces_vertices[{number}]", vertex, vertex_count)
        if len(set(face)) < len(face):
            twice = next(vertex for place, vertex in enumerate(face) if vertex in face[:place])
            raise InputError(f"faces_vertices[{number}]: need every vertex once, got {twice} twice")
        first = seen.setdefault(frozenset(map(frozenset, face_sides(face))), number)
        if first != number:
            raise InputError(f"faces_vertices[{number}]: need every face once, got {first} again")
        for tail, head in face_sides(face):
            if frozenset((tail, head)) not in known:
                raise InputError(
                    f"faces_vertices[{number}]: need an edge along every side, got none from {tail} to {head}"
                )
    return tuple(tuple(int(vertex) for vertex in face) for face in faces)


def face_sides(face: Sequence[int]) -> list[tuple[int, int]]:
    """List the directed sides of a face, from every vertex to the next and from the last to the first."""
    return list(zip(face, [*face[1:], *face[:1]], strict=True))


def face_area(points: Array, face: Sequence[int]) -> float:
    """Compute the area of a face, positive if it is counterclockwise (shoelace formula).

    Args:
        points: m, shape (N, 2) or (N, 3); z is ignored.
        face: vertices of the face.

    Returns:
        m^2.
    """
    return math.fsum(points[a, 0] * points[b, 1] - points[b, 0] * points[a, 1] for a, b in face_sides(face)) / 2


def check_flat(pattern: CreasePattern) -> None:
    """Refuse a sheet that does not lie in a plane of constant z, or is folded onto itself.

    Raises:
        InputError: the vertices differ in z, or a face is turned over.
    """
    heights = pattern.vertices_coords[:, 2]
    if np.ptp(heights) > 0:
        raise InputError(
            f"vertices_coords: need one z for all vertices, got {heights.min():.6g} to {heights.max():.6g} m"
        )
    for number, face in enumerate(pattern.faces_vertices):
        if face_area(pattern.vertices_coords, face) < 0:
            raise InputError(
                f"faces_vertices[{number}]: need a sheet laid flat, all faces counterclockwise seen from +z, got a face"
                " turned over, as in a sheet that is folded flat"
            )


def is_unfolded(pattern: CreasePattern) -> bool:
    """Return whether a sheet lies in a plane of constant z and no face is turned over, as in a flat-folded sheet."""
    coords = pattern.vertices_coords
    if np.ptp(coords[:, 2]) > 0:
        return False
    x, y = coords[:, 0], coords[:, 1]
    return all(sum(x[a] * y[b] - x[b] * y[a] for a, b in face_sides(face)) > 0 for face in pattern.faces_vertices)


def interior_vertices(pattern: CreasePattern) -> Indices:
    """Find the interior vertices of a sheet.

    An interior vertex has edges, none of them is a border or a cut, and each lies between two faces.

    Returns:
        Vertex numbers in increasing order, shape (n_interior,).
    """
    faces_at_edge: dict[frozenset[int], int] = {}
    for face in pattern.faces_vertices:
        for side in face_sides(face):
            faces_at_edge[frozenset(side)] = faces_at_edge.get(frozenset(side), 0) + 1
    inside = np.zeros(len(pattern.vertices_coords), dtype=bool)
    inside[pattern.edges_vertices.ravel()] = True
    for ends, letter in zip(pattern.edges_vertices.tolist(), pattern.edges_assignment, strict=True):
        if letter in "BC" or faces_at_edge.get(frozenset(ends), 0) < 2:
            inside[ends] = False
    return np.flatnonzero(inside).astype(np.int64)


@lru_cache(maxsize=4)  # all checks of a pattern need the result
def creases_inside(pattern: CreasePattern) -> tuple[tuple[int, Indices], ...]:
    """List every interior vertex with its edges, except flat ones.

    Args:
        pattern: a flat sheet.

    Returns:
        For every vertex, in the order of `interior_vertices`: its number, and the numbers of its edges, shape
        (degree,), counterclockwise seen from +z, the lowest first.

    Raises:
        InputError: the sheet is not flat.
    """
    check_flat(pattern)
    inside = interior_vertices(pattern).tolist()
    edges: dict[int, list[int]] = {vertex: [] for vertex in inside}
    for edge, (ends, letter) in enumerate(zip(pattern.edges_vertices.tolist(), pattern.edges_assignment, strict=True)):
        for vertex in ends:
            if letter != "F" and vertex in edges:
                edges[vertex].append(edge)
    return tuple(
        (vertex, _counterclockwise(pattern, vertex, np.array(edges[vertex], dtype=np.int64))) for vertex in inside
    )


def _counterclockwise(pattern: CreasePattern, vertex: int, edges: Indices) -> Indices:
    """Sort edges at a vertex counterclockwise, starting with the lowest number."""
    if len(edges) == 0:
        return edges
    away = _away_from(pattern, vertex, edges)
    counterclockwise = edges[np.argsort(np.arctan2(away[:, 1], away[:, 0]))]
    return np.roll(counterclockwise, -int(np.argmin(counterclockwise)))


def _away_from(pattern: CreasePattern, vertex: int, edges: Indices) -> Array:
    """Compute vectors along the edges, pointing away from the vertex, m, shape (degree, 3)."""
    far_ends = pattern.edges_vertices[edges].sum(axis=1) - vertex
    vectors: Array = pattern.vertices_coords[far_ends] - pattern.vertices_coords[vertex]
    return vectors


def sectors_between(pattern: CreasePattern, vertex: int, edges: Indices) -> Array:
    """Compute the angles between neighbouring creases at a vertex.

    Each angle follows from the cross and the dot product of two edge vectors, so its error is a few units in the last
    place of the coordinates divided by the shorter edge.

    Args:
        pattern: a flat sheet.
        vertex: number of the vertex.
        edges: numbers of its creases, counterclockwise, as `creases_inside` lists them.

    Returns:
        Angles, rad, shape (degree,), counterclockwise; number i lies between creases i and i + 1.
    """
    if len(edges) == 1:
        return np.array([2 * math.pi])
    away = _away_from(pattern, vertex, edges)
    following = np.roll(away, -1, axis=0)
    cross = away[:, 0] * following[:, 1] - away[:, 1] * following[:, 0]
    dot = away[:, 0] * following[:, 0] + away[:, 1] * following[:, 1]
    angles = np.arctan2(cross, dot)
    turned: Array = np.where(angles < 0, angles + 2 * math.pi, angles)
    return turned


def kawasaki_residuals(pattern: CreasePattern) -> Array:
    """Compute the residual of Kawasaki's condition for flat folding at every interior vertex.

    Around a vertex that folds flat, every second sector sums to 180 deg (Kawasaki 1989; Justin 1986). The residual is
    the alternating sum of the sectors: first minus second plus third and so on. In a flat sheet all sectors sum to
    360 deg, so a residual of 0 means that both halves are 180 deg. A vertex with an odd number of creases never folds
    flat; its residual is inf.

    Args:
        pattern: a flat sheet.

    Returns:
        rad, shape (n_interior,), in the order of `interior_vertices`.

    Raises:
        InputError: the sheet is not flat.
    """
    residuals = []
    for vertex, edges in creases_inside(pattern):
        sectors = sectors_between(pattern, vertex, edges)
        if len(sectors) % 2:
            residuals.append(math.inf)
        else:
            residuals.append(math.fsum([*sectors[0::2], *-sectors[1::2]]))
    return np.array(residuals, dtype=np.float64)


def maekawa_residuals(pattern: CreasePattern) -> Indices:
    """Compute the residual of Maekawa's condition for flat folding at every interior vertex.

    At a vertex that folds flat, the numbers of mountains and valleys differ by two (Maekawa; Justin 1986; proof in Hull
    1994). The residual is |mountains - valleys| - 2. Flat and unassigned creases are not counted; a vertex without
    creases has residual 0.

    Args:
        pattern: a flat sheet.

    Returns:
        Shape (n_interior,), in the order of `interior_vertices`.

    Raises:
        InputError: the sheet is not flat.
    """
    residuals = []
    for _, edges in creases_inside(pattern):
        letters = [pattern.edges_assignment[edge] for edge in edges]
        residuals.append(abs(letters.count("M") - letters.count("V")) - 2 if letters else 0)
    return np.array(residuals, dtype=np.int64)


def big_little_big_residuals(pattern: CreasePattern) -> Indices:
    """Count, at every interior vertex, the sectors that would be trapped between two larger ones.

    A sector that is strictly smaller than both neighbours needs one mountain and one valley as its sides, because
    otherwise the large sectors would pass through each other (big-little-big lemma; Kawasaki 1989, Hull 1994). The
    residual is the number of such sectors with two mountains or two valleys. Sectors that are equal to 1e-9 rad are not
    strictly smaller; unassigned sides may be either; flat creases are ignored.

    Args:
        pattern: a flat sheet.

    Returns:
        Shape (n_interior,), in the order of `interior_vertices`.

    Raises:
        InputError: the sheet is not flat.
    """
    residuals = []
    for vertex, edges in creases_inside(pattern):
        sectors = sectors_between(pattern, vertex, edges)
        letters = [pattern.edges_assignment[edge] for edge in edges]
        smallest_neighbour = np.minimum(np.roll(sectors, 1), np.roll(sectors, -1))
        trapped = 0
        for sector in np.flatnonzero(sectors < smallest_neighbour - _EQUAL_SECTORS).tolist():
            sides = (letters[sector], letters[(sector + 1) % len(letters)])
            trapped += sides in (("M", "M"), ("V", "V"))
        residuals.append(trapped)
    return np.array(residuals, dtype=np.int64)
