"""Sizes of facets of a pattern, computed directly from their corners."""

import numpy as np


def corner_distances(pattern, coords=None):
    """All distances between corners of every facet, m: equal lists are congruent facets."""
    coords = pattern.vertices_coords if coords is None else coords
    return [
        np.linalg.norm(coords[list(face)][:, None] - coords[list(face)][None], axis=2)
        for face in pattern.faces_vertices
    ]


def vector_areas(pattern):
    """Half the sum of cross products around every facet, m2, shape (facets, 3)."""
    points = [pattern.vertices_coords[list(face)] for face in pattern.faces_vertices]
    return np.array([np.cross(point, np.roll(point, -1, axis=0)).sum(axis=0) / 2 for point in points])


def folding(pattern):
    """Numbers of the edges that are neither border nor cut."""
    return [edge for edge, letter in enumerate(pattern.edges_assignment) if letter not in "BC"]
