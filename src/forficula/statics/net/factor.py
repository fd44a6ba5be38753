"""Factorisation of a sparse symmetric matrix, with its inertia."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from scipy.sparse import csc_array, eye_array
from scipy.sparse.linalg import LinearOperator, eigsh, splu

from forficula.arrays import Array

_DENSE = 100  # rows up to which all eigenvalues are computed
_NUDGE = 1e-13  # of the largest entry: shift of an exactly singular matrix


@dataclass(frozen=True, kw_only=True, eq=False)
class Factorisation:
    """Factorisation of a symmetric matrix.

    Attributes:
        lower_upper: of SuperLU; None for a matrix without rows.
    """

    lower_upper: Any

    @cached_property
    def index(self) -> int:
        """Return the number of negative eigenvalues: that of negative pivots (Sylvester's law of inertia)."""
        return 0 if self.lower_upper is None else int(np.count_nonzero(self.lower_upper.U.diagonal() < 0))

    def solve(self, right: Array) -> Array:
        """Return the solution for a right-hand side, (coordinate,), or for several in columns."""
        return right.copy() if self.lower_upper is None else np.asarray(self.lower_upper.solve(right))


def factored(matrix: csc_array, shift: float = 0.0) -> Factorisation:
    """Factorise a symmetric matrix plus a multiple of the identity.

    Pivots stay on the diagonal (minimum degree order, symmetric mode, no threshold), so that their signs give the
    inertia of the matrix.
    """
    if not matrix.shape[0]:
        return Factorisation(lower_upper=None)
    scale = float(np.abs(matrix.data).max(initial=0.0)) or 1.0
    for nudge in (0.0, _NUDGE * scale, -10 * _NUDGE * scale, 100 * _NUDGE * scale):
        by = shift + nudge
        shifted = matrix + by * eye_array(matrix.shape[0], format="csc") if by else matrix
        try:
            parts = splu(shifted, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
        except RuntimeError:  # exactly singular
            continue
        if np.array_equal(parts.perm_r, parts.perm_c):
            return Factorisation(lower_upper=parts)
    raise ArithmeticError("a curvature that no shift makes regular")


def softest(matrix: csc_array, count: int, about: float = 0.0) -> tuple[Array, Array]:
    """Compute the eigenvalues nearest to a number, in ascending order, and their eigenvectors in columns.

    The method is that of Lanczos on the inverse (Ericsson and Ruhe 1980, doi 10.1090/S0025-5718-1980-0583502-2).

    Args:
        matrix: symmetric.
        count: number of eigenvalues, at most the size of the matrix.
        about: the number.
    """
    size = matrix.shape[0]
    if size <= max(_DENSE, count + 1):
        values, vectors = np.linalg.eigh(matrix.toarray())
        near = np.sort(np.argsort(np.abs(values - about))[:count])
        return values[near], vectors[:, near]
    parts = factored(matrix, -about)
    inverse = LinearOperator((size, size), matvec=parts.solve, dtype=np.float64)
    begin = np.random.default_rng(0).standard_normal(size)
    values, vectors = eigsh(matrix, count, sigma=about, OPinv=inverse, v0=begin)
    order = np.argsort(values)
    return values[order], vectors[:, order]


def lowest(matrix: csc_array) -> Array:
    """Compute the eigenvector of the lowest eigenvalue of a matrix with exactly one negative eigenvalue."""
    shift = _NUDGE * float(np.abs(matrix.data).max())
    while factored(matrix, shift).index:
        shift *= 2
    return softest(matrix, 1, -shift)[1][:, 0]
