"""Checks of a sheet before it is cut: strips, bridges, holes, windows, and whether it stays in one piece."""

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
# m: minimum width of a cut in the model, because a cut without width separates nothing
_THINNEST = 1e-6
_HALVINGS = 12
# Slits of two creases must be apart by this fraction of a bridge. It is below one half, so that the corners of the
# boxes around slits that are a whole bridge apart do not meet. Rounding error of the overlap, m^2.
_NEAR, _SHARED = 0.4, 1e-10
_NARROW = 1 - 1e-3  # share of the least strip below which a strip is too narrow, because outlines are rounded
# upper limit of the search for the narrowest strip, in minimum strips
_FARTHEST = 8


@dataclass(frozen=True, kw_only=True, eq=False)
class SheetParts:
    """Input from which a sheet was drawn.

    Attributes:
        make: how it is made.
        sheet: area of its facets, with the margin.
        solid: the same without windows.
        windows: all windows.
        large_holes: number of round holes that overlap others or leave the sheet.
    """

    make: MakeSection
    sheet: Region
    solid: Region
    windows: tuple[SheetWindow, ...]
    large_holes: int


def sheet_checks(sheet: CutSheet, parts: SheetParts) -> tuple[Check, ...]:
    """Check a sheet, in this order: strips, windows, bridges, slits, rows, round holes, kept holes, one piece.

    Args:
        sheet: sheet as drawn.
        parts: input from which it was drawn.

    Returns:
        Checks. Those that do not apply, such as bridges in a sheet with scores, are omitted.
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
    """Check the narrowest strip between a window and a border, another window or a crease."""
    facets = [region_of([sheet.pattern.vertices_coords[list(face), :2]]) for face in sheet.pattern.faces_vertices]
    openings = united([region_of([window.outline]) for window in parts.windows])
    regions = [(parts.sheet, parts.solid)]
    regions += [(facet, facet - openings) for facet in facets if not is_empty(facet ^ openings)]
    width = min(_narrowest(whole, left) for whole, left in regions)
    most = _FARTHEST * LEAST_STRIP
    shown = f"at least {show_value(most, 'm')}" if width >= most else show_value(width, "m")
    return least_check(
        "strips",
        _PART,
        measured=width,
        least=LEAST_STRIP,
        text=f"the narrowest strip between a window and a border, a window or a crease is {shown} wide, and needs"
        f" {show_value(LEAST_STRIP, 'm')}",
        mend="; reduce make.window, or make straps thicker and thereby narrower",
    )


def _narrowest(whole: Region, left: Region) -> float:
    """Return the smallest width, m, at which eroding a region tears it but not the whole sheet.

    If it does not tear, the upper limit of the search is returned.
    """
    if _topology(left) == (0, 0):
        return 0.0
    most = _FARTHEST * LEAST_STRIP
    low, high = 0.0, most

    def torn(width: float) -> bool:
        # a region that also tears without windows is narrow because of the pattern, not because of windows
        eaten = _topology(rounded(left, -width / 2))
        return eaten != _topology(left) and _topology(rounded(whole, -width / 2)) == _topology(whole)

    widths = np.linspace(0, most, 2 * _FARTHEST + 1)[1:]
    first = next((index for index, width in enumerate(widths) if torn(float(width))), None)
    if first is None:
        return most
    low, high = float(widths[first - 1]) if first else 0.0, float(widths[first])
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        low, high = (low, middle) if torn(middle) else (middle, high)
    return low


def _topology(region: Region) -> tuple[int, int]:
    """Return the number of pieces and the number of holes of a region."""
    areas = [loop_area(loop) for loop in loops_of(region)]
    return sum(area > 0 for area in areas), sum(area < 0 for area in areas)


def _windows_apart(windows: Sequence[SheetWindow]) -> Check:
    """Check the smallest gap between two windows."""
    gaps = []
    for one, other in combinations(windows, 2):
        meet = not is_empty(region_of([one.outline]) ^ region_of([other.outline]))
        gap = 0.0 if meet else min(_gap(one.outline, other.outline), _gap(other.outline, one.outline))
        gaps.append((gap, f"{one.name} and {other.name}"))
    gap, which = min(gaps, default=(np.inf, ""))
    ok = gap > 0
    if not gaps:
        text = "there is only one window"
    else:
        text = f"the windows of {which} " + (f"are {show_value(gap, 'm')} apart" if ok else "overlap")
    return Check(name="windows", part=_PART, ok=ok, value=float(gap), limit=0.0, unit="m", text=text)


def _gap(outline: Array, other: Array) -> float:
    """Return the smallest distance from the corners of a polygon to the sides of another one, m."""
    sides = sides_of(region_of([other]))
    return min(distance_to_sides(sides, corner) for corner in outline)


def _bridges(make: MakeSection) -> Check:
    """Check that bridges between cuts are at least as wide as the cutter, because narrower ones burn away."""
    bridge, kerf = show_value(make.crease_bridge, "m"), show_value(make.kerf, "m")
    return least_check(
        "bridges",
        _PART,
        measured=make.crease_bridge,
        least=make.kerf,
        text=f"bridges between cuts are {bridge} wide, and need at least the width of the cutter, {kerf}",
        mend="; narrower ones burn away: increase make.crease_bridge",
    )


def _slits_apart(sheet: CutSheet, make: MakeSection) -> Check:
    """Check that slits of different creases keep apart. Slits of creases that meet do so by construction."""
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
        else "slits of different creases cross, or nearly so: their creases are too close for make.lattice_rows at"
        " make.lattice_pitch",
    )


def _rows(make: MakeSection) -> Check:
    """Check the width of the strips between the rows of a lattice, which twist."""
    strip = make.lattice_pitch - make.kerf
    return least_check(
        "lattice strips",
        _PART,
        measured=strip,
        least=make.kerf,
        text=f"strips between the rows of a lattice are {1e3 * strip:.4g} mm wide, and need at least the width of the"
        f" cutter, {show_value(make.kerf, 'm')}",
        mend="; narrower ones burn away: increase make.lattice_pitch",
    )


def _holes_apart(sheet: CutSheet, large: int) -> Check:
    """Check that round holes neither overlap nor leave the sheet."""
    gaps = [
        float(np.linalg.norm(one.place - other.place)) - (one.nominal + other.nominal) / 2
        for one, other in combinations(sheet.holes, 2)
    ]
    gap = min(gaps, default=np.inf)
    text = f"round holes are {show_value(gap, 'm')} apart or more" if gaps else ""
    if large:
        text = f"{large} round holes overlap or leave the sheet; reduce make.relief_hole"
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
    """Check that the number of holes is the same after the kerf: a hole narrower than the cutter cannot be cut."""
    nominal = len(sheet.outlines)
    drawn = sum(line.closed for line in sheet.lines)
    text = f"of {nominal} outlines, holes and windows, the cutter can cut {drawn}"
    missed = f"{text}; the others are narrower than the cutter, {show_value(parts.make.kerf, 'm')}"
    return count_check("holes and the cutter", _PART, measured=drawn, wanted=nominal, held=text, missed=missed)


def sheet_faults(sheet: CutSheet, parts: SheetParts) -> tuple[Array, ...]:
    """Return outlines of what makes a sheet fail: windows too close to something, and all pieces but the largest."""
    facets = [region_of([sheet.pattern.vertices_coords[list(face), :2]]) for face in sheet.pattern.faces_vertices]
    regions = [region_of([window.outline]) for window in parts.windows]
    close = [
        any(other is not one and _is_close(one, other, parts.sheet) for other in regions)
        or any(_is_close_inside(one, whole) for whole in (parts.sheet, *facets))
        for one in regions
    ]
    windows = [window.outline for window, fails in zip(parts.windows, close, strict=True) if fails]
    pieces = sorted(_pieces(sheet, parts), key=area_of)[:-1]
    return (*windows, *(loop for piece in pieces for loop in loops_of(piece) if loop_area(loop) > 0))


def _is_close(one: Region, other: Region, sheet: Region) -> bool:
    """Return whether two windows overlap, or leave a strip of the sheet between them that is too narrow."""
    half = _NARROW * LEAST_STRIP / 2
    return not (is_empty(one ^ other) and is_empty(rounded(one, half) ^ rounded(other, half) ^ sheet))


def _is_close_inside(window: Region, whole: Region) -> bool:
    """Return whether a window inside a region leaves a strip to its border that is too narrow."""
    return is_empty(window - whole) and not is_empty(rounded(window, _NARROW * LEAST_STRIP) - whole)


def _pieces(sheet: CutSheet, parts: SheetParts) -> list[Region]:
    """Return the pieces after cutting, including slits and cuts."""
    wide = max(sheet.kerf, _THINNEST)
    slots = [_slot(line, wide) for line in sheet.lines if line.kind in ("slit", "cut")]
    rounds = [disc(hole.place, hole.nominal) for hole in sheet.holes]
    # all at once, because the time of one after another is proportional to the square of their number
    gone = region_of([*slots, *rounds]) if slots or rounds else united([])
    return pieces_of(parts.solid - gone)


def _one_piece(sheet: CutSheet, parts: SheetParts) -> Check:
    """Check the number of pieces after cutting."""
    count = len(_pieces(sheet, parts))
    passed, failed = (
        "the sheet stays in one piece",
        f"the sheet falls into {count} pieces; check its cuts, windows and slits",
    )
    return count_check("one piece", _PART, measured=count, wanted=1, held=passed, missed=failed)


def _slot(line: CutLine, wide: float) -> Array:
    """Return the area that the cutter removes along a line, counterclockwise, m, (4, 2)."""
    start, end = line.points
    along = (end - start) / np.linalg.norm(end - start) * wide / 2
    across = np.array([-along[1], along[0]])
    return np.array([start - along - across, end + along - across, end + along + across, start - along + across])
