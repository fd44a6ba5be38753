"""The points of a structure at the vertices of its crease pattern."""

from __future__ import annotations

import numpy as np
import scipy

from forficula.structure import Structure, built_points

_SAME = 1e-6  # distance below which positions are the same, as a share of the span


def pattern_points(structure: Structure) -> list[int] | None:
    """Return the point or membrane node at every vertex of the pattern, as built.

    Returns:
        Indices of the points, then of the nodes of the membranes, (vertex,). None without a pattern, or if a vertex has
        no point of its own.
    """
    pattern = structure.appearance.pattern
    if pattern is None:
        return None
    places = np.concatenate([built_points(structure), *(membrane.built for membrane in structure.membranes)])
    away, nearest = scipy.spatial.KDTree(places).query(pattern.vertices_coords)
    points: list[int] = nearest.tolist()
    return points if (away <= _SAME * structure.span).all() and len(set(points)) == len(points) else None
