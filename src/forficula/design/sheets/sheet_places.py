"""Places on a sheet, by their names in a design file."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from forficula.arrays import Array
from forficula.design.sheets.sheet_creases import creases_between
from forficula.errors import InputError
from forficula.pattern import CreasePattern
from forficula.pattern.geometry import is_inside, polygon_normal
from forficula.quantities import as_written

_NUMBER = r"([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)"
_VERTEX = re.compile(r"vertex (\d{1,9})(?: of facet (\d{1,9}))?")
_EDGE = re.compile(rf"(?:edge|crease) (\d{{1,9}}) at {_NUMBER}")
_FACET = re.compile(rf"facet (\d{{1,9}}) at (?:cent(?:re|er)|{_NUMBER}\s*,\s*{_NUMBER})")
_WHOLE_FACET = re.compile(r"facet (\d{1,9})")
_WHOLE_EDGE = re.compile(r"(?:edge|crease) (\d{1,9})")
_EXAMPLES = '"vertex 4", "vertex 4 of facet 2", "edge 12 at 0.5", "facet 3 at centre" or "facet 3 at 0.5, 1"'
# end of a tendon or a distance that is not on the sheet
GROUND_PLACE = "ground"
# largest distance of a place from its facet, as a share of the facet's size: rounding
_BESIDE = 1e-9
# projected area from above as a share of a facet's area, below which the facet is vertical
_UPRIGHT = 1e-6


@dataclass(frozen=True, kw_only=True, eq=False)
class SheetPlace:
    """A place on a facet.

    Attributes:
        facet: number of the facet that carries the place.
        position: position in the sheet as built, m, (3,), read-only.
    """

    facet: int
    position: Array

    def __post_init__(self) -> None:
        self.position.setflags(write=False)


@lru_cache(maxsize=1024)  # designs that differ in other values have the same places
def place_on(pattern: CreasePattern, text: str) -> SheetPlace:
    """Find a place on a sheet.

    "vertex 4" is on the first facet with this vertex, "edge 12 at 0.5" at half the length of the edge on the first
    facet that it borders, and "facet 3 at centre" at the centroid. "facet 3 at 0.5, 1" is at half of the facet's extent
    along x and at its largest y.

    Raises:
        InputError: the text is not a place, or there is no such place.
    """
    written = as_place(text)
    if match := _VERTEX.fullmatch(written):
        return _at_vertex(pattern, int(match[1]), None if match[2] is None else int(match[2]))
    if match := _EDGE.fullmatch(written):
        return _on_edge(pattern, int(match[1]), float(match[2]))
    if match := _FACET.fullmatch(written):
        facet = _facet(pattern, int(match[1]))
        if match[2] is None:
            return SheetPlace(facet=facet, position=_centre(pattern, facet))
        return _in_facet(pattern, facet, float(match[2]), float(match[3]))
    raise InputError(f"need a place such as {_EXAMPLES}, got {as_written(text)}")


def as_place(text: str) -> str:
    """Return the text of a place with single spaces."""
    return " ".join(text.split())


def is_vertex(text: str) -> bool:
    """Return whether a text has the form of a vertex, such as "vertex 4", even if there is no such vertex."""
    return _VERTEX.fullmatch(as_place(text)) is not None


def facet_of(pattern: CreasePattern, text: str) -> int:
    """Return the number of a facet written as "facet 0".

    Raises:
        InputError: the text is not a facet, or there is no such facet.
    """
    match = _WHOLE_FACET.fullmatch(as_place(text))
    if match is None:
        raise InputError(f'need a facet such as "facet 0", got {as_written(text)}')
    return _facet(pattern, int(match[1]))


def edge_of(pattern: CreasePattern, text: str) -> tuple[int, int]:
    """Return the number of an edge written as "edge 3", and of the first facet that it borders.

    Raises:
        InputError: the text is not an edge, or there is no such edge on a facet.
    """
    match = _WHOLE_EDGE.fullmatch(as_place(text))
    if match is None:
        raise InputError(f'need an edge such as "edge 3", got {as_written(text)}')
    edge = int(match[1])
    return edge, _on_edge(pattern, edge, 0.5).facet


def vertex_of(pattern: CreasePattern, text: str) -> tuple[int, int | None]:
    """Return the number of a vertex, and of the facet in "vertex 4 of facet 2", or None for "vertex 4".

    Raises:
        InputError: the text is not a vertex, or there is no such vertex.
    """
    match = _VERTEX.fullmatch(as_place(text))
    if match is None:
        raise InputError(f'need a vertex such as "vertex 4", got {as_written(text)}')
    facet = None if match[2] is None else int(match[2])
    _at_vertex(pattern, int(match[1]), facet)
    return int(match[1]), facet


@lru_cache(maxsize=1024)
def keeps_distance(pattern: CreasePattern, one: SheetPlace, other: SheetPlace) -> bool:
    """Return whether the distance between two places is constant for all folded states of a sheet of plates.

    A place on the axis of a crease moves with the plates on both sides, so that crease does not change the distance.

    Raises:
        InputError: the facets do not form a tree.
    """
    path = list(creases_between(pattern, one.facet, other.facet))
    while path and _on_axis(pattern, path[0], one):
        path.pop(0)
    while path and _on_axis(pattern, path[-1], other):
        path.pop()
    return not path


def _on_axis(pattern: CreasePattern, edge: int, place: SheetPlace) -> bool:
    """Return whether a place lies on the line through an edge of the sheet as built."""
    tail, head = pattern.vertices_coords[pattern.edges_vertices[edge]]
    along, away = head - tail, place.position - tail
    length = float(np.linalg.norm(along))
    beside = float(np.linalg.norm(np.cross(along / length, away)))
    return beside <= _BESIDE * max(length, float(np.linalg.norm(away)))


def _centre(pattern: CreasePattern, facet: int) -> Array:
    """Compute the centroid of a facet in its own plane, m, (3,) (shoelace formula)."""
    corners = pattern.vertices_coords[list(pattern.faces_vertices[facet])]
    away = corners - corners[0]
    following = np.roll(away, -1, axis=0)
    across = np.cross(away, following)
    normal = across.sum(axis=0)
    areas = across @ (normal / np.linalg.norm(normal))
    centre: Array = corners[0] + (areas[:, None] * (away + following)).sum(axis=0) / (3 * areas.sum())
    return centre


def _at_vertex(pattern: CreasePattern, vertex: int, facet: int | None) -> SheetPlace:
    if vertex >= len(pattern.vertices_coords):
        raise InputError(f"need a vertex from 0 to {len(pattern.vertices_coords) - 1}, got {vertex}")
    having = [number for number, corners in enumerate(pattern.faces_vertices) if vertex in corners]
    if not having or (facet is not None and facet not in having):
        of = "no facet" if not having else f"facets {_listed(having)}"
        raise InputError(f"vertex {vertex} is a corner of {of}, got facet {facet}")
    return SheetPlace(facet=having[0] if facet is None else facet, position=pattern.vertices_coords[vertex])


def _on_edge(pattern: CreasePattern, edge: int, share: float) -> SheetPlace:
    if edge >= len(pattern.edges_vertices):
        raise InputError(f"need an edge from 0 to {len(pattern.edges_vertices) - 1}, got {edge}")
    if not 0 <= share <= 1:
        raise InputError(f"need a share of edge {edge} from 0 to 1, got {share:g}")
    ends = pattern.edges_vertices[edge]
    bordered = [number for number, corners in enumerate(pattern.faces_vertices) if set(ends.tolist()) <= set(corners)]
    if not bordered:
        raise InputError(f"edge {edge} borders no facet: need one that does")
    tail, head = pattern.vertices_coords[ends]
    return SheetPlace(facet=bordered[0], position=(1 - share) * tail + share * head)


def _in_facet(pattern: CreasePattern, facet: int, along: float, across: float) -> SheetPlace:
    corners = pattern.vertices_coords[list(pattern.faces_vertices[facet])]
    low, high = corners.min(axis=0), corners.max(axis=0)
    shares = np.array([along, across, 0.0])
    position = (1 - shares) * low + shares * high
    if high[2] > low[2]:
        normal = polygon_normal(corners)
        if abs(normal[2]) <= _BESIDE * np.linalg.norm(normal):
            raise InputError(f"need a facet that is not vertical for a place along x and y, got facet {facet}")
        position[2] = corners[0, 2] - (position - corners[0])[:2] @ normal[:2] / normal[2]
    if not is_inside(position[:2], corners[:, :2], _BESIDE * float(np.linalg.norm(high - low))):
        raise InputError(
            f"need a place on facet {facet}, in shares of its extent along x and y, got {along:g}, {across:g}, which"
            " lies outside"
        )
    return SheetPlace(facet=facet, position=_lifted(corners, position, facet))


def _lifted(corners: Array, position: Array, facet: int) -> Array:
    """Move a position along z into the mean plane of a facet, m, (3,)."""
    middle, normal = corners.mean(axis=0), polygon_normal(corners)
    if abs(normal[2]) <= _UPRIGHT * np.linalg.norm(normal):
        raise InputError(
            f'need "facet {facet} at centre" or "edge 12 at 0.5", because facet {facet} is vertical as built'
        )
    height = middle[2] - (position - middle)[:2] @ normal[:2] / normal[2]
    return np.array([*position[:2], height])


def _facet(pattern: CreasePattern, facet: int) -> int:
    if facet >= len(pattern.faces_vertices):
        of = f" on {as_written(pattern.title)}" if pattern.title else ""
        raise InputError(f"need a facet from 0 to {len(pattern.faces_vertices) - 1}, got {facet}{of}")
    return facet


def _listed(numbers: tuple[int, ...] | list[int]) -> str:
    shown = ", ".join(str(number) for number in numbers[:12])
    return f"{shown}, ..." if len(numbers) > 12 else shown
