"""The waterbomb: its base, which is one bistable vertex, and its tessellation."""

from __future__ import annotations

import dataclasses
import math
from typing import Literal, get_args

import numpy as np

from forficula.errors import InputError
from forficula.names import one_of
from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.dimensions import check_angle, check_count, check_lengths
from forficula.pattern.facet_sheet import Creases, sheet_of_facets

Apex = Literal["up", "down"]


def waterbomb_base(side: float, fold: float = 0.0, apex: Apex = "up") -> CreasePattern:
    """Draw the waterbomb base: a square with eight creases that meet in its centre, diagonals M and midlines V.

    The base is bistable: with the creases folded in the same senses, the centre is above the rim or below it (Hanna,
    Lund, Lang, Magleby and Howell 2014, doi 10.1088/0964-1726/23/9/094009). In both states the facets are flat and the
    shape is symmetric about the centre: all diagonals have one inclination and all midlines another. Two neighbouring
    midlines are 90 deg apart about the axis, and the two sectors of 45 deg between them fold by the angle rho of the
    diagonal. The law of cosines on the sphere, once in the triangle of those sectors and once about the axis, gives
    sin(rho / 2) for the sine of the midlines' inclination, which is therefore rho / 2; in the same manner the
    inclination of the diagonals is half of the fold angle of the midlines. With b = rho / 2 the sector between a
    midline and a diagonal then requires the inclination atan(sqrt(2) tan b) - atan(sin b) of the diagonals, on the side
    of the midlines, with the apex up, and atan(sqrt(2) tan b) + atan(sin b) with the apex down.

    Vertices: the centre, then counterclockwise the end of a midline, on +x, that of a diagonal, and so on. Crease k
    leads to vertex k + 1; the order of the edges differs. Roles: "diagonal" and "midline".

    Args:
        side: side of the square, m.
        fold: size of the fold angle of the diagonals as built, rad; 0 is flat.
        apex: whether the centre is above the rim as built or below it.

    Returns:
        The pattern as built. Its fold angles are those of the base folded to four flaps, apex up: diagonals -180 deg,
        midlines 90 deg. With four mountains and four valleys it does not fold flat (Maekawa).

    Raises:
        InputError: the side is not > 0, the apex is neither up nor down, or the fold is outside 0 to 180 deg or, with
            the apex down, 0 to 90 deg, where the diagonals meet above the centre.
    """
    check_lengths({"side": side})
    if apex not in get_args(Apex):
        raise InputError(f"pattern.apex: need {one_of(get_args(Apex), apex)}")
    check_angle("fold", fold, 0, math.pi if apex == "up" else math.pi / 2, low_too=True)
    midline, sense = fold / 2, -1 if apex == "up" else 1
    diagonal = math.atan(math.sqrt(2) * math.tan(midline)) + sense * math.atan(math.sin(midline))
    azimuths = np.arange(8) * math.pi / 4
    lengths = np.where(np.arange(8) % 2, side / math.sqrt(2), side / 2)
    inclinations = sense * np.where(np.arange(8) % 2, diagonal, midline)
    ends = lengths[:, None] * np.column_stack(
        [np.cos(inclinations) * np.cos(azimuths), np.cos(inclinations) * np.sin(azimuths), np.sin(inclinations)]
    )
    creases: Creases = {frozenset((0, k + 1)): ("M", "diagonal") if k % 2 else ("V", "midline") for k in range(8)}
    faces = [(0, k + 1, (k + 1) % 8 + 1) for k in range(8)]
    drawn = sheet_of_facets(np.concatenate([np.zeros((1, 3)), ends + 0.0]), faces, creases, "waterbomb base")
    flaps = np.array([{"M": -math.pi, "V": math.pi / 2}.get(letter, math.nan) for letter in drawn.edges_assignment])
    return dataclasses.replace(drawn, edges_fold_angle=flaps)


def waterbomb_pattern(columns: int, rows: int, side: float) -> CreasePattern:
    """Draw a flat waterbomb tessellation: squares in rows, with every second row shifted by half a square.

    Every square has two diagonals and the midline along y, six creases at its centre. Six creases meet at every inner
    corner, too: two diagonals, two sides along the row, and a side between squares that continues as a midline in the
    next row (Chen, Feng, Ma, Peng and You 2016, doi 10.1098/rspa.2015.0846). Diagonals are mountains, all others
    valleys; seen from the other side these are exchanged. The sheet is a rectangle: rows 1, 3, 5 and so on begin and
    end with half a square.

    The sheet is built flat, because vertices of six creases leave the flat state in many ways and there is no closed
    form of a folded state of all rows. Evenly folded it curls to a tube, along which waves may occur that follow a
    recurrence between rows (Imada and Tachi 2022, J. Mech. Robot. 14, 041009).

    Vertices: the corners and the midpoints of sides along the lines between rows, line by line; then the centres, row
    by row. Facets: triangles, row by row, three in every half square. Roles: "diagonal", "midline", "row" for sides
    along a row, "side" for those between two squares.

    Args:
        columns: number of squares along x.
        rows: number of squares along y.
        side: side of a square, m.

    Returns:
        The pattern, flat in z = 0, with the fold angles of the flat-folded sheet.

    Raises:
        InputError: a number is not whole or is below 1, or the side is not > 0.
    """
    check_count("columns", columns, 1)
    check_count("rows", rows, 1)
    check_lengths({"side": side})
    line = 2 * columns + 1
    places = [(k / 2, float(row)) for row in range(rows + 1) for k in range(line)]
    centre: dict[tuple[int, int], int] = {}
    for row in range(rows):
        for k in range((row + 1) % 2, line, 2):
            centre[row, k] = len(places)
            places.append((k / 2, row + 0.5))
    faces: list[tuple[int, ...]] = []
    creases: Creases = {}
    for row in range(rows):
        for half in range(line - 1):
            low, high = row * line + half, (row + 1) * line + half
            at_right = (row, half + 1) in centre
            middle = centre[row, half + 1 if at_right else half]
            faces += [(low, low + 1, middle), (high + 1, high, middle)]
            faces.append((middle, high, low) if at_right else (low + 1, high + 1, middle))
            corner, mid = (0, 1) if at_right else (1, 0)
            creases[frozenset((low + corner, high + corner))] = ("V", "side")
            for start in (low, high):
                creases[frozenset((start, start + 1))] = ("V", "row")
                creases[frozenset((start + corner, middle))] = ("M", "diagonal")
                creases[frozenset((start + mid, middle))] = ("V", "midline")
    coords = side * np.column_stack([np.array(places), np.zeros(len(places))])
    return sheet_of_facets(coords, faces, creases, f"waterbomb sheet, {columns} columns, {rows} rows")
