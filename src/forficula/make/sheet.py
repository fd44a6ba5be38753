"""The sheet of a design as it is cut: outlines with the kerf made up for, windows, relief holes, creases."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from forficula.design import AnyDesign, MakeSection, as_design
from forficula.errors import InputError
from forficula.make.crease_cuts import CreaseLine, crease_cuts, crease_lines, crease_width
from forficula.make.cut_lines import CutHole, CutLabel, CutLine, CutSheet, Kind, Layer
from forficula.make.regions import (
    Region,
    area_of,
    disc,
    distance_to,
    grown,
    is_empty,
    loop_area,
    loops_of,
    region_of,
    sides_of,
    spans_within,
    united,
)
from forficula.make.sheet_checks import SheetParts, sheet_checks
from forficula.make.sheet_windows import sheet_windows
from forficula.make.unfolding import Unfolding, unfolded
from forficula.names import listed
from forficula.pattern.crease_pattern import face_area, face_sides
from forficula.quantities import show_value
from forficula.structure import structure_of

Array = NDArray[np.float64]

_LAYERS: dict[str, Layer] = {"M": "mountain", "V": "valley", "U": "score"}
_ROUNDING = 1e-6  # share of the sheet's size, and of its area
_ASKEW = 4.0  # of a margin: how far a crease that meets the border askew may run in it
_LETTERS = 0.02  # height of a label by the sheet's size


def cut_sheet(design: AnyDesign) -> CutSheet:
    """The sheet of a design, as a cutter takes it.

    The sheet is what its facets cover, laid flat, `make.margin` wider all around, less windows (see `sheet_windows`)
    and relief holes. The cutter goes half a kerf outside of what stays, and half a kerf inside of holes, so that what
    stays has its nominal size but for corners that turn inwards, which have the kerf's radius. Slits are lines, as wide
    as the kerf, and begin and end half a kerf within their nominal ends. A crease runs on through the margin, for
    otherwise that would hold it flat.

    Args:
        design: in SI, or its name or path.

    Returns:
        In the coordinates of the pattern laid flat, m, seen from +z, with its checks.

    Raises:
        InputError: no such design; no pattern; one that cannot be laid flat (see `unfolded`) or comes to lie on itself;
            a tendon of which no strap can be made; cuts no longer than the kerf.

    Example:
        >>> sheet = cut_sheet("letter-fold")
        >>> [round(1e3 * each) for each in sheet.size], sum(line.kind == "crease" for line in sheet.lines)
        ([297, 210], 2)
    """
    design = as_design(design)
    make, structure = design.make or MakeSection(), structure_of(design)
    pattern = structure.appearance.pattern
    if pattern is None:
        raise InputError(f"{design.name}: has no crease pattern to cut")
    _check_cuts(make)
    laid = unfolded(pattern)
    sheet = _outline(laid, make)
    windows, pegs = sheet_windows(design, structure, pattern, laid)
    openings = [region_of([window.outline]) for window in windows]
    solid = sheet - united(openings)
    relief = _relief_holes(laid, make, solid)
    holes: list[Round] = [(place, make.peg_diameter, "window") for _, place in pegs]
    rounds, solid, large = _round_holes(sheet, solid, [*holes, *relief])
    drawn = _Drawn(laid=laid, make=make, solid=solid, rounds=rounds)
    lines, creases, notes = _creases(drawn)
    built = CutSheet(
        name=design.name,
        title=pattern.title,
        style=make.crease_style,
        kerf=make.kerf,
        pattern=laid.pattern,
        outlines=tuple(loops_of(solid)),
        creases=creases,
        lines=(*_outlines(drawn, openings), *_open_cuts(drawn), *lines),
        holes=tuple(_hole(place, diameter, kind, make.kerf) for place, diameter, kind in rounds),
        labels=_seam_labels(laid),
        notes=(*_seam_notes(laid), *notes),
    )
    parts = SheetParts(make=make, sheet=sheet, solid=solid, windows=windows, large_holes=large)
    return replace(built, checks=sheet_checks(built, parts))


Round = tuple[Array, float, Kind]


@dataclass(frozen=True, kw_only=True, eq=False)
class _Drawn:
    """What lines are drawn on: the flat sheet, how it is made, what stays of it, and the round holes in that."""

    laid: Unfolding
    make: MakeSection
    solid: Region
    rounds: Sequence[Round]

    @property
    def points(self) -> Array:
        """Places of the flat vertices, m, (vertex, 2)."""
        return np.asarray(self.laid.pattern.vertices_coords[:, :2])

    @cached_property
    def facets(self) -> Region:
        """What the facets cover, without a margin."""
        return region_of([self.points[list(face)] for face in self.laid.pattern.faces_vertices])

    @cached_property
    def faces_at(self) -> Counter[frozenset[int]]:
        """How many faces have a side, by its two vertices."""
        return Counter(frozenset(side) for face in self.laid.pattern.faces_vertices for side in face_sides(face))

    @cached_property
    def all_cut(self) -> Region:
        """What stays, with the round holes cut out, too."""
        return self.solid - united([region_of([disc(place, diameter)]) for place, diameter, _ in self.rounds])

    @cached_property
    def _sides(self) -> Array:
        return sides_of(self.facets)

    def on_border(self, place: Array) -> bool:
        """Whether a place lies on the edge of what the facets cover."""
        return distance_to(self._sides, place) <= _ROUNDING * float(np.ptp(self.points, axis=0).max())

    def beyond(self, place: Array) -> float:
        """How far a line that ends at a place may run on, m: through the margin, askew."""
        return _ASKEW * self.make.margin if self.make.margin and self.on_border(place) else 0.0


def _check_cuts(make: MakeSection) -> None:
    """Refuse cuts and holes of which the kerf leaves no line."""
    for key, value in (
        ("crease_cut", make.crease_cut),
        ("relief_hole", make.relief_hole),
        ("peg_diameter", make.peg_diameter),
    ):
        if key == "crease_cut" and make.crease_style == "score":
            continue
        if value is not None and value != 0 and value <= make.kerf:
            raise InputError(
                f"make.{key}: need > make.kerf, {show_value(make.kerf, 'm')}, the width of the cutter, got"
                f" {show_value(value, 'm')}"
            )


def _outline(laid: Unfolding, make: MakeSection) -> Region:
    """What the flat facets cover, with the margin."""
    pattern = laid.pattern
    region = region_of([pattern.vertices_coords[list(face), :2] for face in pattern.faces_vertices])
    area = sum(face_area(pattern.vertices_coords, face) for face in pattern.faces_vertices)
    if area_of(region) < (1 - _ROUNDING) * area:
        raise InputError(
            "pattern: laid flat it lies on itself, so that it cannot be cut from one sheet:"
            f" {show_area(area - area_of(region))} of {show_area(area)} lie on other parts of it"
        )
    if make.margin == 0:
        return region
    if laid.seams:
        raise InputError(
            f"make.margin: need 0 mm for a sheet that is laid flat along seams ({len(laid.seams)} here), for a margin"
            f" would fill them, got {show_value(make.margin, 'm')}"
        )
    around = [grown(region_of([loop]), make.margin) for loop in loops_of(region) if loop_area(loop) > 0]
    holes = [loop[::-1] for loop in loops_of(region) if loop_area(loop) < 0]
    return united(around) - (region_of(holes) if holes else united([]))


def show_area(area: float) -> str:
    """An area in cm^2."""
    return f"{1e4 * area:.4g} cm^2"


def _relief_holes(laid: Unfolding, make: MakeSection, solid: Region) -> list[Round]:
    """Where creases meet within the sheet: of each its place, diameter and kind."""
    diameter = crease_width(make) if make.relief_hole is None else make.relief_hole
    pattern = laid.pattern
    if diameter <= make.kerf:
        return []
    folding = Counter(
        vertex
        for pair, letter in zip(pattern.edges_vertices.tolist(), pattern.edges_assignment, strict=True)
        if letter in _LAYERS
        for vertex in pair
    )
    sides = Counter(frozenset(side) for face in pattern.faces_vertices for side in face_sides(face))
    outer = {vertex for side, count in sides.items() if count == 1 for vertex in side}
    meeting = sorted(vertex for vertex, count in folding.items() if count >= 2 and vertex not in outer)
    places = [pattern.vertices_coords[vertex, :2] for vertex in meeting]
    return [(place, diameter, "relief") for place in places if not is_empty(solid ^ region_of([disc(place, diameter)]))]


def _round_holes(sheet: Region, solid: Region, holes: Sequence[Round]) -> tuple[list[Round], Region, int]:
    """The holes that stay round, what stays of the sheet where others do not, and how many of these are too large.

    A hole that meets a window becomes a part of it. One that meets another hole or the border is too large.
    """
    kept: list[Round] = []
    merged, large = [], 0
    for number, (place, diameter, kind) in enumerate(holes):
        region = region_of([disc(place, diameter)])
        others = [hole for at, hole in enumerate(holes) if at != number]
        apart = all(np.linalg.norm(place - other) > (diameter + its) / 2 for other, its, _ in others)
        inside, whole = (area_of(region ^ each) >= (1 - _ROUNDING) * area_of(region) for each in (sheet, solid))
        if apart and whole:
            kept.append((place, diameter, kind))
        else:
            merged.append(region)
            large += not (apart and inside)
    return kept, solid - united(merged), large


def _hole(place: Array, diameter: float, kind: Kind, kerf: float) -> CutHole:
    return CutHole(kind=kind, place=place, diameter=diameter - kerf, nominal=diameter)


def _outlines(drawn: _Drawn, openings: Sequence[Region]) -> list[CutLine]:
    """The cutter's way around what stays, and within its holes."""
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


def _open_cuts(drawn: _Drawn) -> list[CutLine]:
    """Cuts of the pattern that do not gape: lines, which end half a kerf before what they do not cut."""
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


def _closed_cuts(drawn: _Drawn) -> list[int]:
    """Numbers of the cuts that have sheet on both sides, one of the two edges that a cut comes apart into."""
    pattern, counted = drawn.laid.pattern, drawn.faces_at
    found: dict[tuple[float, ...], list[int]] = {}
    for edge, letter in enumerate(pattern.edges_assignment):
        if letter == "C":
            found.setdefault(_key(drawn.points[pattern.edges_vertices[edge]].mean(axis=0)), []).append(edge)
    return [
        edges[0]
        for edges in found.values()
        if sum(counted[frozenset(pattern.edges_vertices[edge].tolist())] for edge in edges) > 1
    ]


def _key(place: Array) -> tuple[float, ...]:
    """A place to the nanometre."""
    return tuple((np.round(place, 9) + 0.0).tolist())


def _spans(sides: Array, tail: Array, head: Array, least: float, most: float) -> list[Array]:
    """The parts of a line within a region that a crease or cut has, from its tail on, m, (2, 2) each."""
    length = float(np.linalg.norm(head - tail))
    along = (head - tail) / length
    return [
        tail + np.outer([low, high], along)
        for low, high in spans_within(sides, tail, along, least, most)
        if high > _ROUNDING * length and low < (1 - _ROUNDING) * length
    ]


def _creases(drawn: _Drawn) -> tuple[list[CutLine], tuple[CreaseLine, ...], list[str]]:
    """The creases by their style, and what is to be said of those that it does not suit."""
    pattern, make = drawn.laid.pattern, drawn.make
    folds = [
        edge
        for edge, letter in enumerate(pattern.edges_assignment)
        if letter in _LAYERS and drawn.faces_at[frozenset(pattern.edges_vertices[edge].tolist())] > 1
    ]
    creases = crease_lines(drawn.points, pattern.edges_vertices, folds, _closed_cuts(drawn))
    whole, kept = sides_of(drawn.all_cut), sides_of(grown(drawn.all_cut, -make.crease_bridge))
    lines, short = [], []
    for edge, plain in creases.items():
        crease = replace(plain, beyond=(drawn.beyond(plain.tail), drawn.beyond(plain.head)))
        layer, number = _LAYERS[pattern.edges_assignment[edge]], int(drawn.laid.edges[edge])
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
    """Say which creases are too short for their style."""
    if not short:
        return []
    which = f"crease {short[0]} is" if len(short) == 1 else f"creases {listed(map(str, short))} are"
    return [
        f"{which} too short for a cut of {show_value(make.crease_cut, 'm')} with a bridge of"
        f" {show_value(make.crease_bridge, 'm')} at both ends, and scored instead"
    ]


def _seam_labels(laid: Unfolding) -> tuple[CutLabel, ...]:
    """Numbers beside both edges of every seam, within the sheet."""
    pattern, points = laid.pattern, laid.pattern.vertices_coords[:, :2]
    beside = {
        frozenset(side): points[list(face)].mean(axis=0) for face in pattern.faces_vertices for side in face_sides(face)
    }
    size = float(np.ptp(points, axis=0).max())
    labels = []
    for edge, built in enumerate(laid.edges.tolist()):
        if built in laid.seams:
            pair = pattern.edges_vertices[edge]
            middle = points[pair].mean(axis=0)
            inwards = beside[frozenset(pair.tolist())] - middle
            # within a slender facet no further than a third of the way to its middle
            reach = min(1.2 * _LETTERS * size / float(np.linalg.norm(inwards)), 1 / 3)
            text = str(laid.seams.index(built) + 1)
            labels.append(CutLabel(text=text, place=middle + reach * inwards, height=_LETTERS * size))
    return tuple(labels)


def _seam_notes(laid: Unfolding) -> tuple[str, ...]:
    """Say what is to be joined again."""
    count = len(laid.seams)
    if not count:
        return ()
    which = f"crease {laid.seams[0]}" if count == 1 else f"creases {listed(map(str, laid.seams))}"
    return (f"laid flat the sheet is open along {which} of the pattern: join the edges that have one number",)
