"""The sheet of a design as it is cut: outlines with kerf compensation, windows, relief holes, creases."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from forficula.arrays import Array
from forficula.design import AnyDesign, MakeSection, as_design
from forficula.errors import InputError
from forficula.make.checks.sheet_checks import SheetParts, sheet_checks, sheet_faults
from forficula.make.flat.crease_cuts import crease_width
from forficula.make.flat.cut_lines import CutHole, CutLabel, CutSheet, Kind
from forficula.make.flat.regions import (
    Region,
    area_of,
    disc,
    grown,
    is_empty,
    loop_area,
    loops_of,
    region_of,
    united,
)
from forficula.make.flat.sheet_lines import (
    CREASE_LAYERS,
    Drawn,
    Round,
    crease_ways,
    edge_notes,
    membrane_edge,
    membrane_region,
    open_cuts,
    outline_ways,
    show_area,
)
from forficula.make.flat.sheet_windows import sheet_windows
from forficula.make.flat.unfolding import Unfolding, unfolded
from forficula.names import listed
from forficula.pattern.crease_pattern import face_area, face_sides
from forficula.quantities import show_value
from forficula.structure import structure_of

_ROUNDING = 1e-6  # fraction of the sheet's size, and of its area
_LETTERS = 0.02  # height of a label / size of the sheet


def cut_sheet(design: AnyDesign) -> CutSheet:
    """Return the sheet of a design for a cutter.

    The sheet is the area of its facets, laid flat, extended by `make.margin` on all sides, minus windows (see
    `sheet_windows`) and relief holes. The cutter moves half a kerf outside of the sheet, and half a kerf inside of
    holes, so that the finished sheet has its nominal size, except concave corners, which have the kerf's radius. Slits
    are lines of the kerf's width; they begin and end half a kerf within their nominal ends. A crease continues through
    the margin, which would otherwise hold it flat.

    Args:
        design: in SI, or its name or path.

    Returns:
        In the coordinates of the flat pattern, m, seen from +z, with its checks.

    Raises:
        InputError: unknown design; no pattern; a pattern that cannot be laid flat (see `unfolded`) or overlaps itself;
            a tendon for which no strap can be made; cuts no longer than the kerf.

    Example:
        >>> sheet = cut_sheet("letter-fold")
        >>> [round(1e3 * each) for each in sheet.size], sum(line.kind == "window" for line in sheet.lines)
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
    _check_left("window", make.window, sheet, solid)
    relief = _relief_holes(laid, make, solid)
    holes: list[Round] = [(place, make.peg_diameter, "window") for _, place in pegs]
    rounds, solid, large = _round_holes(sheet, solid, [*holes, *relief])
    widest = max([*holes, *relief], key=lambda hole: hole[1], default=(np.zeros(2), 0.0, "relief"))
    _check_left("relief_hole" if widest[2] == "relief" else "peg_diameter", widest[1], sheet, solid)
    drawn = Drawn(laid=laid, make=make, solid=solid, rounds=rounds, membrane=membrane_region(structure))
    built = _unchecked(design.name, pattern.title, drawn, openings)
    parts = SheetParts(make=make, sheet=sheet, solid=solid, windows=windows, large_holes=large)
    return replace(built, checks=sheet_checks(built, parts), faults=sheet_faults(built, parts))


def _unchecked(name: str, title: str, drawn: Drawn, openings: Sequence[Region]) -> CutSheet:
    """Return a sheet with all its lines, before it is checked; `openings` are its windows."""
    lines, creases, notes = crease_ways(drawn)
    edge, laid, kerf = membrane_edge(drawn), drawn.laid, drawn.make.kerf
    return CutSheet(
        name=name,
        title=title,
        style=drawn.make.crease_style,
        kerf=kerf,
        pattern=laid.pattern,
        outlines=tuple(loops_of(drawn.solid)),
        creases=creases,
        lines=(*outline_ways(drawn, openings), *open_cuts(drawn), *lines, *edge),
        holes=tuple(_hole(place, diameter, kind, kerf) for place, diameter, kind in drawn.rounds),
        labels=_seam_labels(laid),
        notes=(*_seam_notes(laid), *edge_notes(drawn, edge), *notes),
    )


def _check_cuts(make: MakeSection) -> None:
    """Reject cuts and holes that are not larger than the kerf."""
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


def _check_left(key: str, value: float, sheet: Region, solid: Region) -> None:
    """Reject values with which nothing of the sheet remains."""
    if is_empty(solid):
        size = " by ".join(show_value(side, "m") for side in np.ptp(np.concatenate(loops_of(sheet)), axis=0))
        raise InputError(f"make.{key}: leaves nothing of the sheet of {size}; need less, got {show_value(value, 'm')}")


def _outline(laid: Unfolding, make: MakeSection) -> Region:
    """Return the area of the flat facets, with the margin."""
    pattern = laid.pattern
    region = region_of([pattern.vertices_coords[list(face), :2] for face in pattern.faces_vertices])
    area = sum(face_area(pattern.vertices_coords, face) for face in pattern.faces_vertices)
    if area_of(region) < (1 - _ROUNDING) * area:
        raise InputError(
            "pattern: laid flat, it overlaps itself, so it cannot be cut from one sheet:"
            f" {show_area(area - area_of(region))} of {show_area(area)} overlap other parts"
        )
    if make.margin == 0:
        return region
    if laid.seams:
        raise InputError(
            f"make.margin: need 0 mm for a sheet that is laid flat along seams ({len(laid.seams)} here), because a"
            f" margin would fill them, got {show_value(make.margin, 'm')}"
        )
    around = [grown(region_of([loop]), make.margin) for loop in loops_of(region) if loop_area(loop) > 0]
    holes = [loop[::-1] for loop in loops_of(region) if loop_area(loop) < 0]
    return united(around) - (region_of(holes) if holes else united([]))


def _relief_holes(laid: Unfolding, make: MakeSection, solid: Region) -> list[Round]:
    """Return position, diameter and kind of the holes where creases meet within the sheet."""
    diameter = crease_width(make) if make.relief_hole is None else make.relief_hole
    pattern = laid.pattern
    if diameter <= make.kerf:
        return []
    folding = Counter(
        vertex
        for pair, letter in zip(pattern.edges_vertices.tolist(), pattern.edges_assignment, strict=True)
        if letter in CREASE_LAYERS
        for vertex in pair
    )
    sides = Counter(frozenset(side) for face in pattern.faces_vertices for side in face_sides(face))
    outer = {vertex for side, count in sides.items() if count == 1 for vertex in side}
    meeting = sorted(vertex for vertex, count in folding.items() if count >= 2 and vertex not in outer)
    positions = [pattern.vertices_coords[vertex, :2] for vertex in meeting]
    return [
        (position, diameter, "relief")
        for position in positions
        if not is_empty(solid ^ region_of([disc(position, diameter)]))
    ]


def _round_holes(sheet: Region, solid: Region, holes: Sequence[Round]) -> tuple[list[Round], Region, int]:
    """Return the holes that stay round, the sheet without the others, and the number of holes that are too large.

    A hole that overlaps a window becomes part of the window. A hole that overlaps another hole or the border is too
    large.
    """
    kept: list[Round] = []
    merged, large = [], 0
    places, diameters = np.array([hole[0] for hole in holes]), np.array([hole[1] for hole in holes])
    for number, (place, diameter, kind) in enumerate(holes):
        region = region_of([disc(place, diameter)])
        gaps = np.linalg.norm(places - place, axis=1) - (diameters + diameter) / 2
        apart = bool((np.delete(gaps, number) > 0).all())
        inside, whole = (area_of(region ^ area) >= (1 - _ROUNDING) * area_of(region) for area in (sheet, solid))
        if apart and whole:
            kept.append((place, diameter, kind))
        else:
            merged.append(region)
            large += not (apart and inside)
    return kept, solid - united(merged), large


def _hole(place: Array, diameter: float, kind: Kind, kerf: float) -> CutHole:
    return CutHole(kind=kind, place=place, diameter=diameter - kerf, nominal=diameter)


def _seam_labels(laid: Unfolding) -> tuple[CutLabel, ...]:
    """Return labels with numbers beside both edges of every seam, within the sheet."""
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
            # in a slender facet at most a third of the distance to its centre
            reach = min(1.2 * _LETTERS * size / float(np.linalg.norm(inwards)), 1 / 3)
            text = str(laid.seams.index(built) + 1)
            labels.append(CutLabel(text=text, place=middle + reach * inwards, height=_LETTERS * size))
    return tuple(labels)


def _seam_notes(laid: Unfolding) -> tuple[str, ...]:
    """Return a note with the seams to be joined."""
    count = len(laid.seams)
    if not count:
        return ()
    which = f"crease {laid.seams[0]}" if count == 1 else f"creases {listed(map(str, laid.seams))}"
    return (f"the flat sheet is open along {which} of the pattern: join the edges with the same number",)
