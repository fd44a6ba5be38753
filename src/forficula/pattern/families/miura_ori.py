"""The Miura-ori: a sheet of parallelograms that folds in two directions at once."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.dimensions import check_angle, check_count, check_lengths
from forficula.pattern.facet_sheet import Creases, sheet_of_facets


class MiuraSize(NamedTuple):
    """The box around a Miura sheet.

    Attributes:
        width: across the columns, along x, m.
        length: across the rows, along y, with the points of the zigzag at either end, m.
        height: along z, m.
    """

    width: float
    length: float
    height: float


def miura_pattern(
    columns: int, rows: int, long_side: float, short_side: float, acute_angle: float, fold: float = 0.0
) -> CreasePattern:
    """Draw a Miura sheet, flat or folded.

    The straight creases run along y in the flat sheet, one line between every two columns, and alternate between
    mountain and valley along each line. The zigzag creases lie across, one line between every two rows, at constant z
    however far the sheet is folded; such a line is all mountain or all valley, and all zigzag creases fold by one size,
    `fold`. With theta half of that, the inclination of the facets to the plane of the sheet, H, S, L and V of Schenk
    and Guest 2013 (doi 10.1073/pnas.1217998110, equations 1 to 4) give the places: vertex i of line j lies at
    (i S, j L, 0), by V further along y where i is odd and by H up where j is odd. The straight creases fold by
    2 atan(cos(acute_angle) tan(theta)), less than the zigzag ones (Huffman 1976; Tachi 2009).

    Vertices: line by line along x, the lines along y. Facets: likewise. Roles: "straight" and "zigzag".

    Args:
        columns: of parallelograms, along x.
        rows: of parallelograms, along y.
        long_side: of a parallelogram, along the straight creases, m; it may be the shorter one.
        short_side: of a parallelogram, along the zigzag creases, m.
        acute_angle: of a parallelogram, rad.
        fold: size of the fold angle of the zigzag creases as built, rad; 0 is flat.

    Returns:
        The pattern as built, with the fold angles of the sheet that is folded flat.

    Raises:
        InputError: a number that is no whole one, 1 or more; a length that is not > 0; an acute angle outside 0 to
            90 deg; a fold below 0 or of 180 deg and more, where all facets lie on one another.
    """
    check_count("columns", columns, 1)
    check_count("rows", rows, 1)
    along_x, shift, along_y, height = _unit(long_side, short_side, acute_angle, fold)
    coords = np.array(
        [
            (i * along_x, j * along_y + (i % 2) * shift, (j % 2) * height)
            for j in range(rows + 1)
            for i in range(columns + 1)
        ]
    )
    line = columns + 1
    vertex = [[j * line + i for i in range(line)] for j in range(rows + 1)]
    creases: Creases = {}
    for j in range(rows + 1):
        for i in range(line):
            if i < columns:
                creases[frozenset((vertex[j][i], vertex[j][i + 1]))] = ("M" if j % 2 else "V", "zigzag")
            if j < rows:
                creases[frozenset((vertex[j][i], vertex[j + 1][i]))] = ("V" if (i + j) % 2 else "M", "straight")
    faces = [
        (vertex[j][i], vertex[j][i + 1], vertex[j + 1][i + 1], vertex[j + 1][i])
        for j in range(rows)
        for i in range(columns)
    ]
    return sheet_of_facets(coords, faces, creases, f"Miura-ori, {columns} columns, {rows} rows")


def miura_size(
    columns: int, rows: int, long_side: float, short_side: float, acute_angle: float, fold: float = 0.0
) -> MiuraSize:
    """Say how large a Miura sheet is (Schenk and Guest 2013, equations 1 to 4).

    Args:
        columns: as in `miura_pattern`, as are the others.
        rows: of parallelograms.
        long_side: along the straight creases, m.
        short_side: along the zigzag creases, m.
        acute_angle: of a parallelogram, rad.
        fold: size of the fold angle of the zigzag creases, rad.

    Raises:
        InputError: as `miura_pattern`.
    """
    check_count("columns", columns, 1)
    check_count("rows", rows, 1)
    along_x, shift, along_y, height = _unit(long_side, short_side, acute_angle, fold)
    return MiuraSize(columns * along_x, rows * along_y + shift, height)


def _unit(long_side: float, short_side: float, acute_angle: float, fold: float) -> tuple[float, float, float, float]:
    """S, V, L and H of Schenk and Guest 2013, m, written so that nothing is infinite on the way."""
    check_lengths({"long_side": long_side, "short_side": short_side})
    check_angle("acute_angle", acute_angle, 0, math.pi / 2)
    check_angle("fold", fold, 0, math.pi, low_too=True)
    rise = math.sin(fold / 2) * math.sin(acute_angle)
    run = math.hypot(math.cos(acute_angle), math.cos(fold / 2) * math.sin(acute_angle))
    return (
        short_side * math.cos(fold / 2) * math.sin(acute_angle) / run,
        short_side * math.cos(acute_angle) / run,
        long_side * run,
        long_side * rise,
    )
