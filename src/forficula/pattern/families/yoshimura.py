"""The Yoshimura pattern: rows of isosceles triangles that roll up to a cylinder."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from forficula.arrays import Indices
from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.dimensions import check_angle, check_count, check_lengths
from forficula.pattern.facet_sheet import Creases, sheet_of_facets
from forficula.pattern.fold_angles import with_built_fold_angles

_ROUNDING = 1 + 1e-9  # allowed overlap of ends that meet, as a factor

_FLAT = 1e-12  # rad


def yoshimura_pattern(columns: int, rows: int, base: float, height: float, fold: float = 0.0) -> CreasePattern:
    """Draw a sheet of diamonds, flat or rolled up.

    The bases of the triangles are straight lines along x, valleys; the other sides are mountains (Yoshimura 1955, NACA
    TM 1390). Every second line is shifted by half a base, so that both ends are zigzag and all triangles whole. The
    sheet rolls up evenly about an axis along y below it: the corners of a line are corners of a regular polygon with
    the central angle delta over every base, and the polygons of neighbouring lines are rotated by delta / 2 (Guest and
    Pellegrino 1994, doi 10.1115/1.2901553). From the middle of its base to its corner, a triangle rises by
    (base / 2) tan(delta / 4) away from the axis, at the inclination fold / 2, so that
    tan(delta / 4) = (2 height / base) sin(fold / 2), and a row is height cos(fold / 2) long. Triangles steeper than
    equilateral ones collide before they are folded flat (big-little-big lemma).

    Vertices: line by line along x, the lines along y. Facets: row by row, two for every base, the one above it first.
    Roles: "base" and "slanted".

    Args:
        columns: number of triangles on every line, along x.
        rows: number of rows of triangles, along y.
        base: base of a triangle, m.
        height: height of a triangle above its base, m.
        fold: size of the fold angle of the bases as built, rad; 0 is flat.

    Returns:
        The pattern as built, the outside of the roll on +z, with the fold angles of the flat-folded sheet.

    Raises:
        InputError: a number is not whole or is below 1; a length is not > 0; the fold is outside 0 to 180 deg, or the
            rolled sheet overlaps itself.
    """
    _check_triangles("columns", columns, 1, rows, base, height)
    check_angle("fold", fold, 0, math.pi, low_too=True)
    # below this the radius of the roll is infinite, or so large that the positions lose all digits
    fold = 0.0 if fold < _FLAT else fold
    over_base = 4 * math.atan(2 * height / base * math.sin(fold / 2))
    if columns * over_base > 2 * math.pi * _ROUNDING:
        most = 2 * math.asin(base / (2 * height) * math.tan(math.pi / (2 * columns)))
        raise InputError(
            f"pattern.fold: need at most {math.degrees(most):.6g} deg, where {columns} columns close around their axis,"
            f" got {math.degrees(fold):.6g} deg"
        )
    halves = _halves(columns + 1, rows)
    middle = columns + 0.5
    if over_base == 0:
        around = np.column_stack([halves * base / 2, np.zeros(len(halves))])
    else:
        radius, angles = base / 2 / math.sin(over_base / 2), (halves - middle) * over_base / 2
        around = np.column_stack(
            [middle * base / 2 + radius * np.sin(angles), -2 * radius * np.square(np.sin(angles / 2))]
        )
    along = np.repeat(np.arange(rows + 1), columns + 1) * height * math.cos(fold / 2)
    faces, creases = _triangles(columns, rows, lambda line, corner: line * (columns + 1) + corner)
    title = f"Yoshimura sheet, {columns} columns, {rows} rows"
    return sheet_of_facets(np.insert(around, 1, along, axis=1), faces, creases, title)


def yoshimura_tube(sides: int, rows: int, base: float, height: float) -> CreasePattern:
    """Draw a closed tube of diamonds around the z axis.

    The tube is the sheet of `yoshimura_pattern` rolled up until its ends meet, delta = 360 deg / sides: every line is a
    regular polygon.

    Vertices, facets and roles are as in that sheet, counterclockwise around the axis and upwards.

    Args:
        sides: number of sides of the polygons, which is the number of triangles on every line.
        rows: number of rows of triangles along the axis.
        base: base of a triangle, m.
        height: height of a triangle above its base, m.

    Returns:
        The pattern with its fold angles as built; seen from outside, bases are valleys.

    Raises:
        InputError: a number is not whole, or below 3 sides or 1 row; a length is not > 0; the triangles are too low to
            reach from one line to the next.
    """
    _check_triangles("sides", sides, 3, rows, base, height)
    climb = base / 2 * math.tan(math.pi / (2 * sides))
    if not climb < height:
        raise InputError(
            f"pattern.height: need > {100 * climb:.6g} cm, the distance of the corners of a line outside the bases of"
            f" the next, base / 2 tan(90 deg / sides), got {100 * height:.6g} cm"
        )
    angles = _halves(sides, rows) * math.pi / sides
    radius = base / 2 / math.sin(math.pi / sides)
    along = np.repeat(np.arange(rows + 1), sides) * math.sqrt((height - climb) * (height + climb))
    coords = np.column_stack([radius * np.cos(angles), radius * np.sin(angles), along])
    faces, creases = _triangles(sides, rows, lambda line, corner: line * sides + corner % sides)
    return with_built_fold_angles(
        sheet_of_facets(coords, faces, creases, f"Yoshimura tube, {sides} sides, {rows} rows")
    )


def _check_triangles(key: str, count: int, least: int, rows: int, base: float, height: float) -> None:
    """Raise InputError for values that do not give rows of triangles."""
    check_count(key, count, least)
    check_count("rows", rows, 1)
    check_lengths({"base": base, "height": height})


def _halves(corners: int, rows: int) -> Indices:
    """Return the positions of the corners of all lines along their line, in halves of a base."""
    return np.concatenate([2 * np.arange(corners) + line % 2 for line in range(rows + 1)])


def _triangles(columns: int, rows: int, vertex: Callable[[int, int], int]) -> tuple[list[tuple[int, ...]], Creases]:
    """Return the facets and creases between the lines; `vertex` gives the number of a corner of a line."""
    faces: list[tuple[int, ...]] = []
    creases: Creases = {}
    for line in range(rows + 1):
        for k in range(columns):
            creases[frozenset((vertex(line, k), vertex(line, k + 1)))] = ("V", "base")
    for line in range(rows):
        for k in range(columns):
            low, low_next = vertex(line, k), vertex(line, k + 1)
            high, high_next = vertex(line + 1, k), vertex(line + 1, k + 1)
            if line % 2:  # the lower line is the shifted one
                faces += [(low, low_next, high_next), (low, high_next, high)]
            else:
                faces += [(low, low_next, high), (low_next, high_next, high)]
    for face in faces:
        for one, other in zip(face, (*face[1:], face[0]), strict=True):
            creases.setdefault(frozenset((one, other)), ("M", "slanted"))
    return faces, creases
