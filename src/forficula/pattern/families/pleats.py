"""A strip of panels with parallel creases between them, such as pleats or the folds of a letter."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern

# share of the whole strip; a shorter panel is below the rounding of the coordinates
_POINT = 1e-12


def pleat_pattern(panel_lengths: Sequence[float], width: float, assignment: str) -> CreasePattern:
    """Draw a strip along x, with a crease across it between every two panels.

    Edges, by role: "crease" between panels, in their order, then "end" at both ends and "side" along every panel. So
    crease k, between facets k and k + 1, is edge k. Vertices: those on y = 0, then those on y = width.

    Args:
        panel_lengths: lengths of the panels along the strip, m, two or more.
        width: width of the strip, m.
        assignment: one letter per crease, "M" (mountain) or "V" (valley).

    Returns:
        The pattern, flat in z = 0, with the fold angles of the flat-folded strip.

    Raises:
        InputError: a length is not > 0 or is too small beside the others; there is another letter, or not one letter
            per crease.
    """
    count = len(panel_lengths)
    if count < 2:
        raise InputError(f"pattern.panels: need 2 or more, got {count}")
    for key, length in (
        *((f"panel_lengths.{panel}", length) for panel, length in enumerate(panel_lengths)),
        ("width", width),
    ):
        if not 0 < length < math.inf:
            raise InputError(f"pattern.{key}: need > 0 and finite, got {100 * length:.6g} cm")
    if min(panel_lengths) < _POINT * sum(panel_lengths):
        raise InputError(
            f"pattern.panel_lengths: need panels of more than {_POINT:g} of the whole strip,"
            f" {100 * sum(panel_lengths):.6g} cm, got {100 * min(panel_lengths):.6g} cm"
        )
    if len(assignment) != count - 1 or set(assignment) - {"M", "V"}:
        raise InputError(f'pattern.assignment: need "M" or "V" for each of the {count - 1} creases, got "{assignment}"')
    along = np.concatenate([[0.0], np.cumsum(panel_lengths)])
    low, high = range(count + 1), range(count + 1, 2 * count + 2)
    creases = [(low[k], high[k]) for k in range(1, count)]
    ends = [(low[0], high[0]), (low[count], high[count])]
    sides = [(row[k], row[k + 1]) for row in (low, high) for k in range(count)]
    borders = len(ends) + len(sides)
    return CreasePattern(
        title=f"strip of {count} panels",
        vertices_coords=np.array([(x, y, 0.0) for y in (0.0, width) for x in along.tolist()]),
        edges_vertices=np.array([*creases, *ends, *sides]),
        edges_assignment=(*assignment, *"B" * borders),
        edges_fold_angle=np.array(
            [*(math.pi if letter == "V" else -math.pi for letter in assignment), *[math.nan] * borders]
        ),
        edges_role=(*["crease"] * len(creases), *["end"] * len(ends), *["side"] * len(sides)),
        faces_vertices=tuple((low[k], low[k + 1], high[k + 1], high[k]) for k in range(count)),
    )
