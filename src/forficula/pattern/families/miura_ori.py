"""The Miura-ori: a sheet of parallelograms that folds in two directions at once."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.dimensions import check_angle, check_count, check_lengths
from forficula.pattern.facet_sheet import Creases, sheet_of_facets


class MiuraSize(NamedTuple):
    """Bounding box of a Miura sheet.

    Attributes:
        width: size along x, across the columns, m.
        length: size along y, across the rows, including the zigzag at both ends, m.
        height: size along z, m.
    """

    width: float
    length: float
    height: float


def miura_pattern(
    columns: int, rows: int, long_side: float, short_side: float, acute_angle: float, fold: float = 0.0
) -> CreasePattern:
    """Draw a Miura sheet, flat or folded.

    The straight creases are parallel to y in the flat sheet, one line between every two columns, and alternate between
    mountain and valley along every line. The zigzag creases lie across them, one line between every two rows, and
    remain at constant z in every folded state. Such a line is all mountain or all valley, and all zigzag creases fold
    by the same size, `fold`. With theta = fold / 2, the inclination of the facets to the plane of the sheet, the
    positions follow from H, S, L and V of Schenk and Guest 2013 (doi 10.1073/pnas.1217998110, equations 1 to 4):
    vertex i of line j is at (i S, j L, 0), shifted by V along y where i is odd and by H along z where j is odd. The
    straight creases fold by 2 atan(cos(acute_angle) tan(theta)), less than the zigzag ones (Huffman 1976; Tachi 2009).

    Vertices: line by line along x, the lines along y. Facets: likewise. Roles: "straight" and "zigzag".

    Args:
        columns: number of parallelograms along x.
        rows: number of parallelograms along y.
        long_side: side of a parallelogram along the straight creases, m; it may be the shorter one.
        short_side: side of a parallelogram along the zigzag creases, m.
        acute_angle: acute angle of a parallelogram, rad.
        fold: size of the fold angle of the zigzag creases as built, rad; 0 is flat.

    Returns:
        The pattern as built, with the fold angles of the flat-folded sheet.

    Raises:
        InputError: a number is not whole or is below 1; a length is not > 0; the acute angle is outside 0 to 90 deg;
            the fold is below 0, or 180 deg or more, where all facets lie on one another.
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
    """Compute the bounding box of a Miura sheet (Schenk and Guest 2013, equations 1 to 4).

    Args:
        columns: number of parallelograms along x, as for `miura_pattern`.
        rows: number of parallelograms along y.
        long_side: side along the straight creases, m.
        short_side: side along the zigzag creases, m.
        acute_angle: acute angle of a parallelogram, rad.
        fold: size of the fold angle of the zigzag creases, rad.

    Raises:
        InputError: as for `miura_pattern`.
    """
    check_count("columns", columns, 1)
    check_count("rows", rows, 1)
    along_x, shift, along_y, height = _unit(long_side, short_side, acute_angle, fold)
    return MiuraSize(columns * along_x, rows * along_y + shift, height)


def _unit(long_side: float, short_side: float, acute_angle: float, fold: float) -> tuple[float, float, float, float]:
    """Compute S, V, L and H of Schenk and Guest 2013, m, in a form without infinite intermediate values."""
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
