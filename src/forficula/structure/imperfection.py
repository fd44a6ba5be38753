"""A sheet that is not quite as it was drawn: what decides which way it leaves a flat state."""

from __future__ import annotations

import dataclasses

import numpy as np

from forficula.design import Imperfection
from forficula.pattern import CreasePattern
from forficula.pattern.geometry import triangle_normals


def imperfect(triangles: CreasePattern, imperfection: Imperfection) -> CreasePattern:
    """Shift every vertex square to the sheet by a random way, normally distributed.

    Args:
        triangles: a sheet of triangles.
        imperfection: standard deviation of the shifts, in the pattern's units, and the seed of the random numbers.
    """
    if not imperfection.size:
        return triangles
    coords, corners = triangles.vertices_coords, np.array(triangles.faces_vertices)
    normals = np.zeros_like(coords)
    np.add.at(normals, corners, triangle_normals(coords[corners])[:, None])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), np.finfo(float).tiny)
    ways = imperfection.size * np.random.default_rng(imperfection.seed).normal(size=(len(coords), 1))
    return dataclasses.replace(triangles, vertices_coords=coords + ways * normals)
