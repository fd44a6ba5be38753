"""Count first-order mechanisms and states of self-stress of a sheet."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from scipy.sparse import csc_array, csr_array, eye_array
from scipy.sparse.linalg import splu

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.facet_nodes import FacetNodes, facet_nodes
from forficula.pattern.triangulation import triangulated

_MOST_DENSE = 900  # columns; computing that many singular values takes a second
_LARGEST_ZERO = 1e-5  # share of the largest singular value; above the rounding error of files with seven digits
_ROUNDING = 1e-15  # share of the largest singular value; smaller ones are set to this
_SHIFTS = (1e-11, 1e-9)  # shares of the largest squared singular value; none should lie between the two


@dataclass(frozen=True, kw_only=True)
class Rigidity:
    """First-order freedom of a sheet whose edges do not change length.

    Attributes:
        mechanisms: number of independent first-order motions, without the six rigid ones of every piece.
        self_stress: number of independent sets of forces that balance without a load.
        parts: number of pieces that nothing joins.
        clear: whether the rank is distinct from rounding: the singular values that count as 0 are at least a factor of
            100 below the others.
    """

    mechanisms: int
    self_stress: int
    parts: int
    clear: bool


def rigidity(pattern: CreasePattern, coords: Array | None = None, *, bending: bool = False) -> Rigidity:
    """Count mechanisms and states of self-stress from the rank of the rigidity matrix.

    With b rows for j points in p pieces and the rank r there are 3 j - 6 p - r mechanisms and b - r states of
    self-stress (Pellegrino and Calladine 1986). Every edge is a bar and contributes one row. A facet of n corners that
    bends has n - 3 further bars along the diagonals of `triangulated`, and folds along them (Schenk and Guest 2011). A
    rigid facet has n - 3 rows against bending in addition. Its rows are combined to 3 n - 6 orthonormal rows, which
    leave only the rigid motions of a plate of n points. A plate consists of the facets that flat edges connect; flat
    edges fold where facets bend.

    The rank is determined from a gap: in the descending singular values it ends at the largest ratio of neighbours
    whose smaller value is below 1e-5 of the first. Up to 900 columns all singular values are computed; beyond, those
    below 3e-6 and below 3e-5 of an upper bound of the largest are counted by the signs of pivots (Sylvester's law of
    inertia).

    Args:
        pattern: pattern with counterclockwise faces.
        coords: positions of the vertices, m, shape (N, 3); those of the pattern if not given.
        bending: whether facets bend.

    Returns:
        The counts; a flat sheet has more first-order motions than real folding motions.

    Raises:
        InputError: coords have another shape, faces are not counterclockwise, or facets bend and cannot be split into
            triangles.
    """
    places = pattern.vertices_coords if coords is None else np.asarray(coords, dtype=np.float64)
    if places.shape != pattern.vertices_coords.shape:
        raise InputError(f"coords: need shape {pattern.vertices_coords.shape}, got {places.shape}")
    nodes = facet_nodes(triangulated(pattern).pattern if bending else pattern)
    points = places[nodes.vertices]
    rows = list(_bars(nodes, points) if bending else _plates(nodes, points))
    matrix = _matrix(rows, 3 * len(points))
    twice = 0
    if not bending:
        twice = sum(nodes.plates[item.left] != nodes.plates[item.right] for item in nodes.shared)
    zeros, clear = nullity(matrix)
    parts = int(nodes.parts.max()) + 1
    rank = matrix.shape[1] - zeros
    return Rigidity(
        mechanisms=zeros - 6 * parts, self_stress=matrix.shape[0] - int(twice) - rank, parts=parts, clear=clear
    )


def _plates(nodes: FacetNodes, points: Array) -> Iterator[tuple[Indices, Array]]:
    """Return the points and the rows, (rows, points, 3), of every plate: all motions except rigid ones."""
    for plate in range(int(nodes.plates.max()) + 1):
        facets = np.flatnonzero(nodes.plates == plate)
        held = np.unique(np.concatenate([nodes.facets[facet] for facet in facets]))
        arms = points[held] - points[held].mean(axis=0)
        arms /= np.abs(arms).max()
        turns = np.cross(np.eye(3)[:, np.newaxis], arms).reshape(3, -1)
        motions = np.concatenate([np.tile(np.eye(3), len(held)), turns])
        complete, _ = np.linalg.qr(motions.T, mode="complete")
        yield held, complete[:, 6:].T.reshape(-1, len(held), 3)


def _bars(nodes: FacetNodes, points: Array) -> Iterator[tuple[Indices, Array]]:
    """Return the points and the rows, (1, 2, 3), of every side of a triangle."""
    sides = np.concatenate([[facet, np.roll(facet, -1)] for facet in nodes.facets], axis=1).T
    for bar in np.unique(np.sort(sides, axis=1), axis=0):
        along = points[bar[1]] - points[bar[0]]
        along /= np.linalg.norm(along)
        yield bar, np.stack([-along, along])[np.newaxis]


def _matrix(blocks: list[tuple[Indices, Array]], columns: int) -> csr_array:
    """The rows of all blocks as one matrix."""
    values, across, count = [], [], []
    for held, rows in blocks:
        places = (3 * held[:, np.newaxis] + np.arange(3)).ravel()
        values.append(rows.ravel())
        across.append(np.tile(places, len(rows)))
        count.append(np.full(len(rows), len(places)))
    starts = np.concatenate([[0], np.cumsum(np.concatenate(count))])
    return csr_array((np.concatenate(values), np.concatenate(across), starts), shape=(len(starts) - 1, columns))


def nullity(matrix: csr_array) -> tuple[int, bool]:
    """Count the independent vectors that a matrix maps to 0, and report whether the count is clear; see `rigidity`."""
    columns = matrix.shape[1]
    if not min(matrix.shape):
        return columns, True
    if columns <= _MOST_DENSE:
        values = np.linalg.svd(matrix.toarray(), compute_uv=False)
        values = np.maximum(values / values[0], _ROUNDING)
        below = np.flatnonzero(values[1:] < _LARGEST_ZERO)
        ratios = values[below] / values[below + 1]
        rank = int(below[np.argmax(ratios)]) + 1 if len(below) else len(values)
        return columns - rank, not len(below) or bool(ratios.max() > 100)
    gram = (matrix.T @ matrix).tocsc()
    largest = float(np.abs(gram).sum(axis=0).max())
    fewer, more = (_eigenvalues_below(gram, shift * largest) for shift in _SHIFTS)
    return fewer, fewer == more


def _eigenvalues_below(gram: csc_array, shift: float) -> int:
    """Count the eigenvalues below a shift: the negative pivots of a factorisation without row exchanges."""
    shifted = (gram - shift * eye_array(gram.shape[0], format="csc")).tocsc()
    factors = splu(shifted, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    return int((factors.U.diagonal() < 0).sum())
