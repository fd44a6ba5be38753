"""Factorisation of a sparse symmetric matrix, with its inertia."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import TypeAlias

import numpy as np
from scipy.linalg.lapack import dpbtrf, dpbtrs, dsytrf, dsytrs
from scipy.sparse import csc_array, csr_array, eye_array
from scipy.sparse.csgraph import reverse_cuthill_mckee
from scipy.sparse.linalg import LinearOperator, eigsh, splu

from forficula.arrays import Array, Indices

Matrix: TypeAlias = csc_array | Array  # symmetric

DENSE = 100  # rows up to which a Hessian is dense, and up to which all eigenvalues are computed
_FEW = 100  # rows up to which SuperLU is as fast as the band
_WIDEST = 600  # diagonals of the lower triangle up to which a matrix is factorised as a band
_NUDGE = 1e-13  # of the largest entry: shift of an exactly singular matrix


@dataclass(frozen=True, kw_only=True, eq=False)
class Factorisation:
    """Factorisation of a symmetric matrix.

    Attributes:
        index: number of negative eigenvalues.
        solve: returns the solution for a right-hand side, (coordinate,), or for several in columns.
    """

    index: int
    solve: Callable[[Array], Array]


def factored(matrix: Matrix, shift: float = 0.0) -> Factorisation:
    """Factorise a symmetric matrix plus a multiple of the identity.

    A dense matrix is factorised by the method of Bunch and Kaufman (1977, doi 10.1090/S0025-5718-1977-0428694-0). A
    large positive definite matrix is factorised as a band by Cholesky's method, which is several times as fast as
    SuperLU. Any other matrix is factorised by SuperLU: its pivots stay on the diagonal (minimum degree order, symmetric
    mode, no threshold), so that their signs give the inertia of the matrix (Sylvester's law).
    """
    if not matrix.shape[0]:
        return Factorisation(index=0, solve=np.copy)
    dense = isinstance(matrix, np.ndarray)
    banded = None if dense or matrix.shape[0] <= _FEW else _cholesky(matrix, shift)
    if banded is not None:
        return banded
    for nudge in (0.0, _NUDGE, -10 * _NUDGE, 100 * _NUDGE):
        by = shift + nudge * (largest_entry(matrix) or 1.0) if nudge else shift
        parts = _pivoted(matrix, by) if dense else _on_diagonal(matrix, by)
        if parts is not None:
            return parts
    raise ArithmeticError("a curvature that no shift makes regular")


def definite(matrix: Matrix, shift: float = 0.0) -> Factorisation | None:
    """Factorise a symmetric matrix plus a multiple of the identity; None if it is not positive definite.

    For a large matrix this takes a fraction of the time in which `factored` counts negative eigenvalues.
    """
    if isinstance(matrix, np.ndarray) or matrix.shape[0] <= _FEW or _band_of(matrix) is None:
        parts = factored(matrix, shift)
        return None if parts.index else parts
    return _cholesky(matrix, shift)


def largest_entry(matrix: Matrix) -> float:
    """Return the largest magnitude of an entry; 0 for an empty matrix."""
    entries = matrix if isinstance(matrix, np.ndarray) else matrix.data
    return float(max(entries.max(initial=0.0), -entries.min(initial=0.0)))


def as_dense(matrix: Matrix) -> Array:
    """Return a matrix with all its entries."""
    return matrix if isinstance(matrix, np.ndarray) else matrix.toarray()


def _pivoted(matrix: Array, shift: float) -> Factorisation | None:
    """Factorise a dense matrix plus a multiple of the identity; None if it is exactly singular."""
    size = len(matrix)
    shifted = matrix.copy()
    if shift:
        shifted.reshape(-1)[:: size + 1] += shift
    # the transpose has the order of LAPACK
    parts, pivots, failed = dsytrf(shifted.T, lower=1, overwrite_a=1)
    if failed:
        return None
    # every pivot of two rows has one negative eigenvalue
    single = pivots > 0
    index = np.count_nonzero(parts.diagonal()[single] < 0) + np.count_nonzero(~single) // 2

    def solve(right: Array) -> Array:
        return np.asarray(dsytrs(parts, pivots, right, lower=1)[0]).reshape(right.shape)

    return Factorisation(index=int(index), solve=solve)


def _on_diagonal(matrix: csc_array, shift: float) -> Factorisation | None:
    """Factorise a sparse matrix plus a multiple of the identity; None if a pivot has left the diagonal."""
    shifted = matrix + shift * eye_array(matrix.shape[0], format="csc") if shift else matrix
    try:
        parts = splu(shifted, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    except RuntimeError:  # exactly singular
        return None
    if not np.array_equal(parts.perm_r, parts.perm_c):
        return None
    return Factorisation(index=int(np.count_nonzero(parts.U.diagonal() < 0)), solve=parts.solve)


@dataclass(frozen=True, kw_only=True, eq=False)
class _Band:
    """Order of the coordinates in which a sparsity pattern is a narrow band (Cuthill and McKee 1969, reversed).

    Attributes:
        order: number of the coordinate at each position of the band, (coordinate,).
        places: position of each entry of the lower triangle in the flattened band, (entry,).
        entries: numbers of these entries among those of the matrix, (entry,).
        shape: number of diagonals, and number of coordinates.
    """

    order: Indices
    places: Indices
    entries: Indices
    shape: tuple[int, int]


@lru_cache(maxsize=8)
def _band(starts: bytes, rows: bytes, kind: str) -> _Band | None:
    """Return the band of a pattern of columns; None if it is too wide to be faster than a sparse factorisation."""
    begin, row = np.frombuffer(starts, dtype=kind).astype(np.int64), np.frombuffer(rows, dtype=kind).astype(np.int64)
    count = len(begin) - 1
    column = np.repeat(np.arange(count), np.diff(begin))
    pattern = csr_array((np.ones(len(row)), (row, column)), shape=(count, count))
    order = np.asarray(reverse_cuthill_mckee(pattern, symmetric_mode=True), dtype=np.int64)
    position = np.empty(count, dtype=np.int64)
    position[order] = np.arange(count)
    below = position[row] - position[column]
    entries = np.flatnonzero(below >= 0)
    width = int(below.max(initial=0)) + 1
    if width > _WIDEST:
        return None
    places = below[entries] * count + position[column[entries]]
    return _Band(order=order, places=places, entries=entries, shape=(width, count))


def _band_of(matrix: csc_array) -> _Band | None:
    return _band(matrix.indptr.tobytes(), matrix.indices.tobytes(), matrix.indices.dtype.str)


def _cholesky(matrix: csc_array, shift: float) -> Factorisation | None:
    """Factorise a positive definite matrix plus a multiple of the identity; None if it is not positive definite."""
    band = _band_of(matrix)
    if band is None:
        return None
    flat = np.zeros(band.shape[0] * band.shape[1])
    flat[band.places] = matrix.data[band.entries]
    if shift:
        flat[: band.shape[1]] += shift
    lower, failed = dpbtrf(flat.reshape(band.shape), lower=1, overwrite_ab=1)
    if failed:
        return None

    def solve(right: Array) -> Array:
        solution = np.empty_like(right)
        solution[band.order] = dpbtrs(lower, right[band.order], lower=1)[0].reshape(right.shape)
        return solution

    return Factorisation(index=0, solve=solve)


def softest(matrix: Matrix, count: int, about: float = 0.0) -> tuple[Array, Array]:
    """Compute the eigenvalues nearest to a number, in ascending order, and their eigenvectors in columns.

    The method is that of Lanczos on the inverse (Ericsson and Ruhe 1980, doi 10.1090/S0025-5718-1980-0583502-2).

    Args:
        matrix: symmetric.
        count: number of eigenvalues, at most the size of the matrix.
        about: the number.
    """
    size = matrix.shape[0]
    if size <= max(DENSE, count + 1):
        values, vectors = np.linalg.eigh(as_dense(matrix))
        near = np.sort(np.argsort(np.abs(values - about))[:count])
        return values[near], vectors[:, near]
    parts = factored(matrix, -about)
    inverse = LinearOperator((size, size), matvec=parts.solve, dtype=np.float64)
    begin = np.random.default_rng(0).standard_normal(size)
    values, vectors = eigsh(matrix, count, sigma=about, OPinv=inverse, v0=begin)
    order = np.argsort(values)
    return values[order], vectors[:, order]


def lowest(matrix: Matrix) -> Array:
    """Compute the eigenvector of the lowest eigenvalue of a matrix with exactly one negative eigenvalue."""
    shift = _NUDGE * largest_entry(matrix)
    while factored(matrix, shift).index:
        shift *= 2
    return softest(matrix, 1, -shift)[1][:, 0]
