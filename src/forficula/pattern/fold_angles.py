"""How far a sheet is folded as its vertices lie."""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from forficula.arrays import Array
from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.shared_edges import shared_edges
from forficula.pattern.triangulation import triangulated

_ONTO_ITSELF = 1e-6  # rad from 180 deg; nearer, rounding may turn the sense around, and the letter says it
_FLAT = 1e-9  # rad; what folds less is flat but for rounding


def built_fold_angles(pattern: CreasePattern) -> Array:
    """Measure the fold angle of every edge between two facets.

    With e along the edge, p in the facet to its left, q in that to its right, all from its tail, the fold angle is
    that between the normals e x p and q x e, with the sign of q . (e x p): positive where the right facet rises on the
    side from which both are seen counterclockwise. Facets of more than three corners count as `triangulated` splits
    them: where one is not flat, the triangle at the edge says how it lies there.

    Args:
        pattern: with faces counterclockwise seen from +z or, of a closed surface, from outside.

    Returns:
        rad, shape (E,), from -pi to pi, valley positive, nan on borders and cuts. An edge within 1e-6 rad of being
        folded onto itself has the sense of its letter, if that is "M" or "V".

    Raises:
        InputError: faces that are not counterclockwise, or that cannot be split into triangles.
    """
    triangles = triangulated(pattern).pattern
    angles = np.full(len(pattern.edges_vertices), np.nan)
    shared = np.array(shared_edges(triangles), dtype=np.int64).reshape(-1, 5)
    shared = shared[shared[:, 0] < len(angles)]
    edge, tail, head, left, right = shared.T
    corners = np.array(triangles.faces_vertices).sum(axis=1)
    coords = pattern.vertices_coords
    ends = (head, corners[left] - tail - head, corners[right] - tail - head)
    along, p, q = (coords[end] - coords[tail] for end in ends)
    left_normal, right_normal = np.cross(along, p), np.cross(q, along)
    rise = np.linalg.norm(along, axis=1) * np.einsum("ij,ij->i", q, left_normal)
    angles[edge] = np.arctan2(rise, np.einsum("ij,ij->i", left_normal, right_normal)) + 0.0
    letters = np.array(pattern.edges_assignment)
    closed = np.abs(angles) > math.pi - _ONTO_ITSELF
    for letter, sense in (("M", -1.0), ("V", 1.0)):
        these = closed & (letters == letter)
        angles[these] = sense * np.abs(angles[these])
    return angles


def kept_as_built(pattern: CreasePattern) -> CreasePattern:
    """Let the fold angles of a pattern be those that it has as built.

    Returns:
        The pattern with `built_fold_angles`; creases that were unassigned ("U") get the letter of how they fold.

    Raises:
        InputError: as `built_fold_angles`.
    """
    angles = built_fold_angles(pattern)
    letters = tuple(
        letter if letter != "U" or math.isnan(angle) else "F" if abs(angle) < _FLAT else "V" if angle > 0 else "M"
        for letter, angle in zip(pattern.edges_assignment, angles.tolist(), strict=True)
    )
    return dataclasses.replace(pattern, edges_assignment=letters, edges_fold_angle=angles)
