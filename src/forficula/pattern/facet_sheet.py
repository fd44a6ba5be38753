"""Construction of a pattern from its facets, whose sides are the edges."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from forficula.arrays import Array
from forficula.pattern.crease_pattern import CreasePattern, face_sides

Creases = dict[frozenset[int], tuple[str, str]]
FOLDED = {"M": -math.pi, "V": math.pi, "F": 0.0}  # rad, fold angles of a flat-folded sheet


def sheet_of_facets(
    coords: Array,
    faces: Sequence[tuple[int, ...]],
    creases: Mapping[frozenset[int], tuple[str, str]],
    title: str,
) -> CreasePattern:
    """Build a pattern from facets and creases.

    Args:
        coords: positions of the vertices, m, shape (N, 3).
        faces: vertices of every facet, counterclockwise seen from +z or from outside.
        creases: letter and role by the two ends; entries for sides of a single facet are ignored.
        title: title of the sheet.

    Returns:
        The pattern. Its edges are the sides between two facets, in the order of the facets, then the other sides, "B"
        with the role "border". Fold angles are 180 deg on valleys, -180 deg on mountains, 0 on flat creases, and nan on
        unassigned creases and borders.
    """
    facets_at: dict[frozenset[int], int] = {}
    for face in faces:
        for side in map(frozenset, face_sides(face)):
            facets_at[side] = facets_at.get(side, 0) + 1
    inside = [side for side, count in facets_at.items() if count > 1]
    border = [side for side, count in facets_at.items() if count == 1]
    letters = [creases[side][0] for side in inside]
    return CreasePattern(
        title=title,
        vertices_coords=coords,
        edges_vertices=np.array([sorted(side) for side in (*inside, *border)]),
        edges_assignment=(*letters, *"B" * len(border)),
        edges_fold_angle=np.array([*(FOLDED.get(letter, math.nan) for letter in letters), *[math.nan] * len(border)]),
        edges_role=(*(creases[side][1] for side in inside), *["border"] * len(border)),
        faces_vertices=tuple(faces),
    )
