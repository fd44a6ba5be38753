"""Fold angles of a sheet, computed from the positions of its vertices."""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from forficula.arrays import Array
from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.shared_edges import shared_edges
from forficula.pattern.triangulation import triangulated

_ONTO_ITSELF = 1e-6  # rad from 180 deg; nearer, rounding may change the sign, and the letter defines the sense
_FLAT = 1e-9  # rad; smaller fold angles are rounding


def built_fold_angles(pattern: CreasePattern) -> Array:
    """Compute the fold angle of every edge between two facets.

    With the vectors e along the edge, p in the facet to its left and q in the facet to its right, all from the tail of
    the edge, the fold angle is the angle between the normals e x p and q x e. Its sign is that of q . (e x p): positive
    if the right facet rises to the side from which both are seen counterclockwise. Facets with more than three corners
    are split as in `triangulated`: for one that is not flat, the triangle at the edge is used.

    Args:
        pattern: pattern with faces counterclockwise seen from +z or, for a closed surface, from outside.

    Returns:
        Fold angles, rad, shape (E,), from -pi to pi, valley positive, nan on borders and cuts. An edge within 1e-6 rad
        of 180 deg has the sense of its letter, if that is "M" or "V".

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
        selected = closed & (letters == letter)
        angles[selected] = sense * np.abs(angles[selected])
    return angles


def with_built_fold_angles(pattern: CreasePattern) -> CreasePattern:
    """Return a pattern with its fold angles as built.

    Returns:
        The pattern with `built_fold_angles`; unassigned creases ("U") get the letter of their fold angle.

    Raises:
        InputError: the errors of `built_fold_angles`.
    """
    angles = built_fold_angles(pattern)
    letters = tuple(
        letter if letter != "U" or math.isnan(angle) else "F" if abs(angle) < _FLAT else "V" if angle > 0 else "M"
        for letter, angle in zip(pattern.edges_assignment, angles.tolist(), strict=True)
    )
    return dataclasses.replace(pattern, edges_assignment=letters, edges_fold_angle=angles)
