"""Lines of a cut sheet: outlines, cuts, creases, and the edge of the model's membrane."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from forficula.arrays import Array
from forficula.design import MakeSection
from forficula.make.flat.crease_cuts import CreaseLine, crease_cuts, crease_lines
from forficula.make.flat.cut_lines import CutLine, Kind, Layer
from forficula.make.flat.regions import (
    Region,
    area_of,
    disc,
    grown,
    is_empty,
    loop_area,
    loops_of,
    region_of,
    sides_of,
    spans_within,
    united,
)
from forficula.make.flat.unfolding import Unfolding
from forficula.names import listed
from forficula.pattern.crease_pattern import face_sides
from forficula.pattern.geometry import distance_to_sides
from forficula.quantities import show_value
from forficula.structure import Structure, built_frames

CREASE_LAYERS: dict[str, Layer] = {"M": "mountain", "V": "valley", "U": "score"}
_ROUNDING = 1e-6  # fraction of the sheet's size, and of its area
_ASKEW = 4.0  # length, in margins, by which a crease oblique to the border may continue in the margin

Round = tuple[Array, float, Kind]


@dataclass(frozen=True, kw_only=True, eq=False)
class Drawn:
    """Input for the lines of a sheet.

    Attributes:
        laid: the flat sheet.
        make: how it is made.
        solid: the finished sheet without round holes.
        rounds: round holes with position, m, nominal diameter, m, and kind.
        membrane: area of the model's membranes; None if there are none between bars.
    """

    laid: Unfolding
    make: MakeSection
    solid: Region
    rounds: Sequence[Round]
    membrane: Region | None

    @property
    def points(self) -> Array:
        """Positions of the flat vertices, m, (vertex, 2)."""
        return np.asarray(self.laid.pattern.vertices_coords[:, :2])

    @cached_property
    def facets(self) -> Region:
        """Area of the facets, without a margin."""
        return region_of([self.points[list(face)] for face in self.laid.pattern.faces_vertices])

    @cached_property
    def faces_at(self) -> Counter[frozenset[int]]:
        """Number of faces at each side, by its two vertices."""
        return Counter(frozenset(side) for face in self.laid.pattern.faces_vertices for side in face_sides(face))

    @cached_property
    def all_cut(self) -> Region:
        """Finished sheet, including round holes."""
        return self.solid - united([region_of([disc(place, diameter)]) for place, diameter, _ in self.rounds])

    @cached_property
    def _sides(self) -> Array:
        return sides_of(self.facets)

    def on_border(self, place: Array) -> bool:
        """Return whether a point is on the edge of the facets' area."""
        return distance_to_sides(self._sides, place) <= _ROUNDING * float(np.ptp(self.points, axis=0).max())

    def beyond(self, place: Array) -> float:
        """Return the distance, m, by which a line that ends at a point may continue obliquely through the margin."""
        return _ASKEW * self.make.margin if self.make.margin and self.on_border(place) else 0.0


def show_area(area: float) -> str:
    """Return an area in cm^2 as text."""
    return f"{1e4 * area:.4g} cm^2"


def outline_ways(drawn: Drawn, openings: Sequence[Region]) -> list[CutLine]:
    """Return the cutter's paths around the sheet and within its holes."""
    windows, lines = united(openings), []
    for loop in loops_of(grown(drawn.solid, drawn.make.kerf / 2)):
        kind: Kind = "border"
        if loop_area(loop) < 0:
            inside = region_of([loop[::-1]])
            kind = (
                "window"
                if not is_empty(inside ^ windows)
                else "relief"
                if not is_empty(inside ^ drawn.facets)
                else "hole"
            )
        lines.append(CutLine(layer="cut", kind=kind, points=loop, closed=True))
    return lines


def open_cuts(drawn: Drawn) -> list[CutLine]:
    """Return closed cuts of the pattern as lines, which end half a kerf before uncut material."""
    sides, lines = sides_of(drawn.all_cut), []
    cuts = _closed_cuts(drawn)
    ends_at = Counter(_key(drawn.points[vertex]) for edge in cuts for vertex in drawn.laid.pattern.edges_vertices[edge])
    for edge in cuts:
        pair = drawn.laid.pattern.edges_vertices[edge]
        tail, head = drawn.points[pair]
        length = float(np.linalg.norm(head - tail))
        trims = []
        for place in (tail, head):
            goes_on = drawn.on_border(place) or ends_at[_key(place)] > 1
            trims.append(-drawn.beyond(place) if goes_on else drawn.make.kerf / 2)
        number = int(drawn.laid.edges[edge])
        spans = _spans(sides, tail, head, trims[0], length - trims[1])
        lines += [CutLine(layer="cut", kind="cut", points=ends, closed=False, edge=number) for ends in spans]
    return lines


def _closed_cuts(drawn: Drawn) -> list[int]:
    """Return indices of the cuts that have sheet on both sides, one of the two edges of each cut."""
    pattern, counted = drawn.laid.pattern, drawn.faces_at
    cuts_at: dict[tuple[float, ...], list[int]] = {}
    for edge, letter in enumerate(pattern.edges_assignment):
        if letter == "C":
            cuts_at.setdefault(_key(drawn.points[pattern.edges_vertices[edge]].mean(axis=0)), []).append(edge)
    return [
        edges[0]
        for edges in cuts_at.values()
        if sum(counted[frozenset(pattern.edges_vertices[edge].tolist())] for edge in edges) > 1
    ]


def _key(place: Array) -> tuple[float, ...]:
    """Return a position, rounded to the nanometre."""
    return tuple((np.round(place, 9) + 0.0).tolist())


def _spans(sides: Array, tail: Array, head: Array, least: float, most: float) -> list[Array]:
    """Return the parts of a crease or cut within a region, from its tail, m, (2, 2) each."""
    length = float(np.linalg.norm(head - tail))
    along = (head - tail) / length
    return [
        tail + np.outer([low, high], along)
        for low, high in spans_within(sides, tail, along, least, most)
        if high > _ROUNDING * length and low < (1 - _ROUNDING) * length
    ]


def crease_ways(drawn: Drawn) -> tuple[list[CutLine], tuple[CreaseLine, ...], list[str]]:
    """Return the creases in their style, and notes on those that are too short for it."""
    pattern, make = drawn.laid.pattern, drawn.make
    folds = [
        edge
        for edge, letter in enumerate(pattern.edges_assignment)
        if letter in CREASE_LAYERS and drawn.faces_at[frozenset(pattern.edges_vertices[edge].tolist())] > 1
    ]
    creases = crease_lines(drawn.points, pattern.edges_vertices, folds, _closed_cuts(drawn))
    whole, kept = sides_of(drawn.all_cut), sides_of(grown(drawn.all_cut, -make.crease_bridge - make.kerf / 2))
    lines, short = [], []
    for edge, plain in creases.items():
        crease = replace(plain, beyond=(drawn.beyond(plain.tail), drawn.beyond(plain.head)))
        layer, number = CREASE_LAYERS[pattern.edges_assignment[edge]], int(drawn.laid.edges[edge])
        spans = _spans(whole, crease.tail, crease.head, -crease.beyond[0], crease.length + crease.beyond[1])
        if make.crease_style != "score":
            slits = crease_cuts(crease, make, kept)
            for ends in slits:
                inwards = make.kerf / 2 * np.array([crease.along, -crease.along])
                lines.append(CutLine(layer=layer, kind="slit", points=ends + inwards, closed=False, edge=number))
            if slits or not spans:
                continue
            short.append(number)
            layer = "score"
        lines += [CutLine(layer=layer, kind="crease", points=ends, closed=False, edge=number) for ends in spans]
    return lines, tuple(creases.values()), _short_notes(short, make)


def _short_notes(short: Sequence[int], make: MakeSection) -> list[str]:
    """Return a note on the creases that are too short for their style."""
    if not short:
        return []
    which = f"crease {short[0]} is" if len(short) == 1 else f"creases {listed(map(str, short))} are"
    return [
        f"{which} too short for a cut of {show_value(make.crease_cut, 'm')} with a bridge of"
        f" {show_value(make.crease_bridge, 'm')} at both ends, and scored instead"
    ]


def membrane_region(structure: Structure) -> Region | None:
    """Return the area of the model's membranes, including glued strips; None if they are not between bars."""
    surfaces = [membrane.surface for membrane in structure.membranes if membrane.surface is not None]
    if not surfaces or not structure.bars:
        return None
    origins, frames = built_frames(structure)
    loops = []
    for surface in surfaces:
        turned = np.einsum("nij,nj->ni", frames[surface.bodies], surface.places)
        positions = (origins[surface.bodies] + turned)[:, :2]
        loops += [loop if loop_area(loop) > 0 else loop[::-1] for loop in positions[surface.triangles]]
    return region_of(loops)


def membrane_edge(drawn: Drawn) -> list[CutLine]:
    """Return the edge of the model's membrane within the sheet. Unlike the facets, it leaves the base of a fan open."""
    if drawn.membrane is None:
        return []
    size, solid = float(np.ptp(drawn.points, axis=0).max()), sides_of(drawn.all_cut)
    lines = []
    for ends in sides_of(drawn.membrane):
        if all(drawn.on_border(place) for place in (*ends, ends.mean(axis=0))):
            continue
        if np.linalg.norm(ends[1] - ends[0]) > _ROUNDING * size:
            spans = _spans(solid, ends[0], ends[1], 0.0, float(np.linalg.norm(ends[1] - ends[0])))
            lines += [CutLine(layer="mark", kind="edge", points=points, closed=False) for points in spans]
    return lines


def edge_notes(drawn: Drawn, edge: Sequence[CutLine]) -> tuple[str, ...]:
    """Return a note on the area that the model's membrane leaves open."""
    if drawn.membrane is None or not edge:
        return ()
    whole, left = area_of(drawn.facets), area_of(drawn.facets - drawn.membrane)
    return (
        f"the membrane in the model leaves {show_area(left)} of the {show_area(whole)} of all facets open: to make the"
        " same sheet, cut along the lines in MARK, too",
    )
