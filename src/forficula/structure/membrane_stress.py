"""Strains and stresses of membranes: triangles of a Saint Venant-Kirchhoff sheet in plane stress."""

from __future__ import annotations

import numpy as np

from forficula.arrays import Array
from forficula.structure.membranes import MembraneLaw


def principal_strains(built: Array, now: Array) -> Array:
    """Return the principal Green strains of triangles, the smaller one first, (..., 2).

    Green's strain of a flat triangle is E = (F^T F - 1) / 2, where F maps its sides as built to its present sides.

    Args:
        built: corners without strain, m, (triangle, corner, 3).
        now: corners, m, (..., triangle, corner, 3).
    """
    moved = _sides(now)
    inverse = np.linalg.inv(_in_plane(_sides(built)))
    metric = np.einsum("...ix,...jx->...ij", moved, moved)
    strains = (np.swapaxes(inverse, -1, -2) @ metric @ inverse - np.eye(2)) / 2
    return np.asarray(np.linalg.eigvalsh(strains), dtype=np.float64)


def principal_stresses(law: MembraneLaw, principal: Array) -> Array:
    """Return the principal stresses (second Piola-Kirchhoff), Pa, for principal Green strains, (..., 2).

    The stress of a Saint Venant-Kirchhoff sheet in plane stress is Y / (1 - nu^2) ((1 - nu) E + nu tr(E)) (Holzapfel
    2000, Nonlinear Solid Mechanics, equation 6.151, with zero stress across the sheet).
    """
    nu = law.poisson_ratio
    both = principal.sum(axis=-1, keepdims=True)
    return np.asarray(law.youngs_modulus / (1 - nu**2) * ((1 - nu) * principal + nu * both))


def _sides(corners: Array) -> Array:
    """Return two sides of triangles from their first corners, m, (..., 2, 3)."""
    return np.asarray(corners[..., 1:, :] - corners[..., :1, :])


def _in_plane(sides: Array) -> Array:
    """Return two sides of triangles in axes of their planes, as columns, m, (..., 2, 2)."""
    lengths = np.linalg.norm(sides, axis=-1)
    along = np.sum(sides[..., 0, :] * sides[..., 1, :], axis=-1) / lengths[..., 0]
    across = np.linalg.norm(np.cross(sides[..., 0, :], sides[..., 1, :]), axis=-1) / lengths[..., 0]
    columns = [[lengths[..., 0], along], [np.zeros_like(along), across]]
    return np.moveaxis(np.array(columns), (0, 1), (-2, -1))
