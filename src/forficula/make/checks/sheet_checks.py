"""What is checked of a sheet before it is cut: strips, bridges, holes, windows, and that it stays in one piece."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from forficula.arrays import Array
from forficula.design import MakeSection
from forficula.make.checks.check import Check, count_check, least_check
from forficula.make.flat.cut_lines import CutLine, CutSheet
from forficula.make.flat.regions import (
    Region,
    area_of,
    disc,
    is_empty,
    loop_area,
    loops_of,
    pieces_of,
    region_of,
    rounded,
    sides_of,
    united,
)
from forficula.make.flat.sheet_windows import LEAST_STRIP, SheetWindow
from forficula.pattern.geometry import distance_to_sides
from forficula.quantities import show_value

_PART = "sheet"
# m: a cut without width parts nothing, so that it is given at least this
_THINNEST = 1e-6
_HALVINGS = 12
# share of a bridge by which slits of two creases are apart at least, such that boxes around those that are a whole one
# apart do not meet with their corners; and m^2 of rounding in that
_NEAR, _SHARED = 0.4, 1e-10
# of the least strip: how far is looked for the narrowest one
_FARTHEST = 8


@dataclass(frozen=True, kw_only=True, eq=False)
class SheetParts:
    """What a sheet was drawn from.

    Attributes:
        make: how it is made.
        sheet: what its facets cover, with the margin.
        solid: the same without windows.
        windows: all of them.
        large_holes: how many round holes run into another one or out of the sheet.
    """

    make: MakeSection
    sheet: Region
    solid: Region
    windows: tuple[SheetWindow, ...]
    large_holes: int


def sheet_checks(sheet: CutSheet, parts: SheetParts) -> tuple[Check, ...]:
    """Check a sheet, in this order: strips, windows, bridges, slits, rows, round holes, kept holes, one piece.

    Args:
        sheet: as drawn.
        parts: that it was drawn from.

    Returns:
        What there is nothing of, such as bridges in a sheet with scores, is not checked, and left out.
    """
    make, checks = parts.make, []
    if parts.windows:
        checks += [_strips(sheet, parts), _windows_apart(parts.windows)]
    if make.crease_style != "score":
        checks += [_bridges(make), _slits_apart(sheet, make)]
    if make.crease_style == "lattice":
        checks.append(_rows(make))
    if len(sheet.holes) > 1 or parts.large_holes:
        checks.append(_holes_apart(sheet, parts.large_holes))
    return (*checks, _kept_holes(sheet, parts), _one_piece(sheet, parts))


def _strips(sheet: CutSheet, parts: SheetParts) -> Check:
    """The narrowest strip between a window and a border, another window or a crease."""
    facets = [region_of([sheet.pattern.vertices_coords[list(face), :2]]) for face in sheet.pattern.faces_vertices]
    openings = united([region_of([window.outline]) for window in parts.windows])
    regions = [(parts.sheet, parts.solid)]
    regions += [(facet, facet - openings) for facet in facets if not is_empty(facet ^ openings)]
    width = min(_narrowest(whole, left) for whole, left in regions)
    most = _FARTHEST * LEAST_STRIP
    found = f"at least {show_value(most, 'm')}" if width >= most else show_value(width, "m")
    return least_check(
        "strips",
        _PART,
        found=width,
        least=LEAST_STRIP,
        text=f"the narrowest strip that windows leave beside a border, a window or a crease is {found} wide, and needs"
        f" {show_value(LEAST_STRIP, 'm')}",
        mend="; make make.window smaller, or straps thicker and so narrower",
    )


def _narrowest(whole: Region, left: Region) -> float:
    """The least width at which eating a region away from its edges tears it, where it does not tear the whole alike.

    m; as far as is looked for where it does not.
    """
    if _topology(left) == (0, 0):
        return 0.0
    most = _FARTHEST * LEAST_STRIP
    low, high = 0.0, most

    def torn(width: float) -> bool:
        # what tears without a window, or is as narrow all over, is the pattern's own shape
        eaten = _topology(rounded(left, -width / 2))
        return eaten != _topology(left) and _topology(rounded(whole, -width / 2)) == _topology(whole)

    widths = np.linspace(0, most, 2 * _FARTHEST + 1)[1:]
    first = next((place for place, width in enumerate(widths) if torn(float(width))), None)
    if first is None:
        return most
    low, high = float(widths[first - 1]) if first else 0.0, float(widths[first])
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        low, high = (low, middle) if torn(middle) else (middle, high)
    return low


def _topology(region: Region) -> tuple[int, int]:
    """How many pieces a region has, and how many holes."""
    areas = [loop_area(loop) for loop in loops_of(region)]
    return sum(area > 0 for area in areas), sum(area < 0 for area in areas)


def _windows_apart(windows: Sequence[SheetWindow]) -> Check:
    """The least gap between two windows."""
    gaps = []
    for one, other in combinations(windows, 2):
        meet = not is_empty(region_of([one.outline]) ^ region_of([other.outline]))
        gap = 0.0 if meet else min(_gap(one.outline, other.outline), _gap(other.outline, one.outline))
        gaps.append((gap, f"{one.name} and {other.name}"))
    gap, which = min(gaps, default=(np.inf, ""))
    ok = gap > 0
    if not gaps:
        text = "there is one window, which meets no other"
    else:
        text = f"the windows of {which} " + (f"are {show_value(gap, 'm')} apart" if ok else "overlap")
    return Check(name="windows", part=_PART, ok=ok, value=float(gap), limit=0.0, unit="m", text=text)


def _gap(outline: Array, other: Array) -> float:
    """From the corners of a polygon to the nearest side of another one, m."""
    sides = sides_of(region_of([other]))
    return min(distance_to_sides(sides, corner) for corner in outline)


def _bridges(make: MakeSection) -> Check:
    """Bridges between cuts are as wide as the cutter, or burn away."""
    bridge, kerf = show_value(make.crease_bridge, "m"), show_value(make.kerf, "m")
    return least_check(
        "bridges",
        _PART,
        found=make.crease_bridge,
        least=make.kerf,
        text=f"bridges between cuts are {bridge} wide, and need the width of the cutter, {kerf}",
        mend=", or they burn away; make make.crease_bridge larger",
    )


def _slits_apart(sheet: CutSheet, make: MakeSection) -> Check:
    """Slits of different creases keep apart; those of creases that meet do by how they are drawn."""
    slots: dict[int, list[Array]] = {}
    for line in sheet.lines:
        if line.kind == "slit":
            slots.setdefault(line.edge, []).append(_slot(line, sheet.kerf + _NEAR * make.crease_bridge))
    around = [region_of(loops) for loops in slots.values()]
    shared = sum(map(area_of, around)) - area_of(united(around))
    ok = shared <= _SHARED
    return Check(
        name="slits",
        part=_PART,
        ok=ok,
        value=shared,
        limit=_SHARED,
        unit="m^2",
        text="slits of different creases leave bridges between them"
        if ok
        else "slits of different creases cross or nearly do: their creases are too near for make.lattice_rows at"
        " make.lattice_pitch",
    )


def _rows(make: MakeSection) -> Check:
    """Strips between the rows of a lattice, which twist."""
    strip = make.lattice_pitch - make.kerf
    return least_check(
        "lattice strips",
        _PART,
        found=strip,
        least=make.kerf,
        text=f"strips between the rows of a lattice are {1e3 * strip:.4g} mm wide, and need the width of the cutter,"
        f" {show_value(make.kerf, 'm')}",
        mend=", or they burn away; make make.lattice_pitch larger",
    )


def _holes_apart(sheet: CutSheet, large: int) -> Check:
    """Round holes run neither into one another nor out of the sheet."""
    gaps = [
        float(np.linalg.norm(one.place - other.place)) - (one.nominal + other.nominal) / 2
        for one, other in combinations(sheet.holes, 2)
    ]
    gap = min(gaps, default=np.inf)
    text = f"round holes are {show_value(gap, 'm')} apart or more" if gaps else ""
    if large:
        text = f"{large} round holes run into one another or out of the sheet; make make.relief_hole smaller"
    return Check(
        name="round holes",
        part=_PART,
        ok=large == 0,
        value=0.0 if large else gap,
        limit=0.0,
        unit="m",
        text=text,
    )


def _kept_holes(sheet: CutSheet, parts: SheetParts) -> Check:
    """Whether holes are as many after the kerf as before: a hole narrower than the cutter has no way for it."""
    nominal = len(sheet.outlines)
    drawn = sum(line.closed for line in sheet.lines)
    text = f"of {nominal} outlines, holes and windows the cutter goes around {drawn}"
    missed = f"{text}; the others are narrower than it, {show_value(parts.make.kerf, 'm')}"
    return count_check("holes and the cutter", _PART, found=drawn, wanted=nominal, held=text, missed=missed)


def sheet_faults(sheet: CutSheet, parts: SheetParts) -> tuple[Array, ...]:
    """Outlines of what makes a sheet fail: windows that meet others, and all pieces but the largest."""
    regions = [region_of([window.outline]) for window in parts.windows]
    meet = [any(other is not one and not is_empty(one ^ other) for other in regions) for one in regions]
    windows = [window.outline for window, fails in zip(parts.windows, meet, strict=True) if fails]
    pieces = sorted(_pieces(sheet, parts), key=area_of)[:-1]
    return (*windows, *(loop for piece in pieces for loop in loops_of(piece) if loop_area(loop) > 0))


def _pieces(sheet: CutSheet, parts: SheetParts) -> list[Region]:
    """What comes off the cutter, slits and cuts and all."""
    wide = max(sheet.kerf, _THINNEST)
    slots = [_slot(line, wide) for line in sheet.lines if line.kind in ("slit", "cut")]
    rounds = [disc(hole.place, hole.nominal) for hole in sheet.holes]
    # all at once: one after another takes as long as there are slits, squared
    gone = region_of([*slots, *rounds]) if slots or rounds else united([])
    return pieces_of(parts.solid - gone)


def _one_piece(sheet: CutSheet, parts: SheetParts) -> Check:
    """In how many pieces the sheet comes off the cutter."""
    count = len(_pieces(sheet, parts))
    held, missed = (
        "the sheet stays in one piece",
        f"the sheet falls into {count} pieces; see its cuts, windows and slits",
    )
    return count_check("one piece", _PART, found=count, wanted=1, held=held, missed=missed)


def _slot(line: CutLine, wide: float) -> Array:
    """What the cutter takes away along a line, counterclockwise, m, (4, 2)."""
    start, end = line.points
    along = (end - start) / np.linalg.norm(end - start) * wide / 2
    across = np.array([-along[1], along[0]])
    return np.array([start - along - across, end + along - across, end + along + across, start - along + across])
