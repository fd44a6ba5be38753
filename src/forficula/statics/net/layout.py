"""Assembly pattern of a net: how sides of elements depend on nodes and where contributions add up, computed once."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from scipy.sparse import bsr_array, csc_array, csr_array, vstack

from forficula.arrays import Array, Indices
from forficula.statics.net.factor import DENSE, Matrix
from forficula.statics.net.net import Net

_SMALL = 20_000  # entries up to which a matrix multiplies faster as a dense one


@dataclass(frozen=True, kw_only=True, eq=False)
class Layout:
    """The fixed sparsity pattern of a net's gradient and Hessian.

    Sides are vectors between points: one for a spring or a tendon; three for a crease, namely along the crease (the
    mean if it is open) and from its tails to its left and right corners; two for a triangle. Small matrices are dense,
    because their products are then several times as fast.

    Attributes:
        sides: weights of the nodes, (side, node): of springs, then of tendons, of all first, second and third sides of
            creases, and of both sides of every triangle.
        counts: of springs, tendons, creases and triangles.
        gather: weights with which 3 x 3 blocks of pairs of sides add up to blocks of pairs of nodes, (block, pair).
        columns: column of each block, (block,).
        rows: index at which each row of blocks begins, (node + 1,).
        free: numbers of the free coordinates, (coordinate,).
        taken: entries of all blocks that belong to the free part, in its order, (entry,).
        free_rows: rows of these entries, (entry,).
        free_starts: index at which each column of the free part begins, (coordinate + 1,).
        weight: forces of gravity, N, (node, 3).
        on_planes: weights with which stiffnesses of springs of planes add up to blocks, (block, plane).
    """

    sides: csr_array | Array
    counts: tuple[int, int, int, int]
    gather: csr_array | Array
    columns: Indices
    rows: Indices
    free: Indices
    taken: Indices
    free_rows: Indices
    free_starts: Indices
    weight: Array
    on_planes: csr_array

    @cached_property
    def on_nodes(self) -> csr_array | Array:
        """Return the matrix that turns forces along sides into forces on nodes, (node, side)."""
        return self.sides.T if isinstance(self.sides, np.ndarray) else csr_array(self.sides.T)

    @cached_property
    def _dense_places(self) -> Indices:
        """Return the position of each entry of the free part in the flattened dense matrix, (entry,)."""
        columns = np.repeat(np.arange(len(self.free)), np.diff(self.free_starts))
        return np.asarray(self.free_rows * len(self.free) + columns, dtype=np.int64)

    @cached_property
    def dampers(self) -> Array:
        """Return the damping matrix of equal dampers along all sides, in the order of the free part, (entry,).

        They resist every relative motion of the ends of a side. Its largest entry is 1.
        """
        springs, tendons, creases, triangles = self.counts
        by_pair = [np.ones(springs + tendons), np.repeat(np.eye(3).ravel(), creases)]
        by_pair.append(np.tile(np.eye(2).ravel(), triangles))
        blocks = np.asarray(self.gather @ np.outer(np.concatenate(by_pair), np.eye(3).ravel()))
        entries = blocks.reshape(-1)[self.taken]
        return np.asarray(entries / entries.max(initial=1.0))

    @cached_property
    def damping(self) -> csc_array:
        """Return the damping matrix of `dampers` by the free coordinates."""
        size = len(self.free)
        return csc_array((self.dampers, self.free_rows, self.free_starts), shape=(size, size))

    def whole(self, blocks: Array) -> bsr_array:
        """Return the Hessian by all coordinates from its blocks, (block, 9)."""
        size = 3 * (len(self.rows) - 1)
        return bsr_array((blocks.reshape(-1, 3, 3), self.columns, self.rows), shape=(size, size))

    def free_part(self, blocks: Array) -> Matrix:
        """Return the Hessian by the free coordinates from the blocks by all coordinates, (block, 9)."""
        size = len(self.free)
        data = blocks.reshape(-1)[self.taken]
        if size > DENSE:
            return csc_array((data, self.free_rows, self.free_starts), shape=(size, size))
        dense = np.zeros(size * size)
        dense[self._dense_places] = data
        return dense.reshape(size, size)


@lru_cache(maxsize=8)
def layout_of(net: Net) -> Layout:
    """Compute the layout of a net; layouts of the last nets are cached."""
    sides = _sides(net)
    triangles = 0 if net.membranes is None else len(net.membranes.points)
    counts = (len(net.springs.points), len(net.tendons.points), len(net.creases.points), triangles)
    first, second = _pairs(counts)
    gather, columns, rows = _block_weights(sides, first, second)
    free = np.flatnonzero(net.free.ravel())
    size = 3 * len(net.nodes)
    numbered = bsr_array((1 + np.arange(9.0 * len(columns)).reshape(-1, 3, 3), columns, rows), shape=(size, size))
    part = csc_array(numbered.tocsc()[:, free].tocsr()[free].tocsc())
    part.sort_indices()
    weight = net.gravity * np.outer(np.asarray(net.mass_matrix.sum(axis=1)).ravel(), net.down)
    return Layout(
        sides=_dense_if_small(sides),
        counts=counts,
        gather=_dense_if_small(gather),
        columns=columns,
        rows=rows,
        free=free,
        taken=np.asarray(np.round(part.data) - 1, dtype=np.int64),
        free_rows=part.indices,
        free_starts=part.indptr,
        weight=weight,
        on_planes=_plane_weights(net, columns, rows),
    )


def _plane_weights(net: Net, columns: Indices, rows: Indices) -> csr_array:
    """Return `Layout.on_planes`; the nodes of a plate, which weigh its points, have a block for each pair."""
    count = len(net.nodes)
    if net.planes is None:
        return csr_array((len(columns), 0))
    blocks = np.repeat(np.arange(count), np.diff(rows)) * count + columns
    plane, at, weights = list[Indices](), list[Indices](), list[Array]()
    matrix = net.planes.weights
    for number in range(matrix.shape[0]):
        entries = slice(*matrix.indptr[number : number + 2])
        nodes, shares = matrix.indices[entries].astype(np.int64), matrix.data[entries]
        at.append(np.searchsorted(blocks, (nodes[:, None] * count + nodes).ravel()))
        weights.append(np.outer(shares, shares).ravel())
        plane.append(np.full(len(weights[-1]), number))
    entry = np.concatenate(weights), (np.concatenate(at), np.concatenate(plane))
    return csr_array(entry, shape=(len(columns), matrix.shape[0]))


def _sides(net: Net) -> csr_array:
    points = csr_array(net.points)
    tail, head, left, far_tail, far_head, right = net.creases.points.T
    parts = [_end_differences(points, net.springs.points), _end_differences(points, net.tendons.points)]
    along = 0.5 * (points[head] - points[tail] + points[far_head] - points[far_tail])
    parts += [along, points[left] - points[tail], points[right] - points[far_tail]]
    if net.membranes is not None:
        a, b, c = net.membranes.points.T
        parts.append(_interleaved([points[b] - points[a], points[c] - points[a]]))
    sides = csr_array(vstack(parts))
    sides.eliminate_zeros()
    return sides


def _dense_if_small(matrix: csr_array) -> csr_array | Array:
    return matrix.toarray() if matrix.shape[0] * matrix.shape[1] <= _SMALL else matrix


def _end_differences(points: csr_array, ends: Indices) -> csr_array:
    return csr_array(points[ends[:, 1]] - points[ends[:, 0]])


def _interleaved(parts: list[csr_array]) -> csr_array:
    """Return the interleaved rows of several matrices."""
    count = parts[0].shape[0]
    order = np.arange(count * len(parts)).reshape(len(parts), count).T.ravel()
    return csr_array(vstack(parts, format="csr"))[order]


def _pairs(counts: tuple[int, int, int, int]) -> tuple[Indices, Indices]:
    """Return pairs of sides of the same element, in the order of the blocks of the Hessian.

    A pair of first, second or third sides of creases comes after the same pair of the crease before.
    """
    straight, creases, triangles = counts[0] + counts[1], counts[2], counts[3]
    single = np.arange(straight)
    by_crease = straight + np.arange(3 * creases).reshape(3, creases)
    firsts = np.broadcast_to(by_crease[:, None], (3, 3, creases))
    seconds = np.broadcast_to(by_crease[None], (3, 3, creases))
    by_triangle = straight + 3 * creases + np.arange(2 * triangles).reshape(triangles, 2)
    ones = np.broadcast_to(by_triangle[:, :, None], (triangles, 2, 2))
    others = np.broadcast_to(by_triangle[:, None], (triangles, 2, 2))
    first = np.concatenate([single, firsts.ravel(), ones.ravel()])
    return first, np.concatenate([single, seconds.ravel(), others.ravel()])


def _block_weights(sides: csr_array, first: Indices, second: Indices) -> tuple[csr_array, Indices, Indices]:
    """Return weights of pairs of sides in blocks of pairs of nodes, and columns and row starts of these blocks."""
    starts, nodes, weights = sides.indptr.astype(np.int64), sides.indices.astype(np.int64), sides.data
    many, more = np.diff(starts)[first], np.diff(starts)[second]
    pair = np.repeat(np.arange(len(first)), many * more)
    within = np.arange(len(pair)) - np.repeat(np.cumsum(many * more) - many * more, many * more)
    row = starts[first][pair] + within // np.maximum(more[pair], 1)
    column = starts[second][pair] + within % np.maximum(more[pair], 1)
    count = sides.shape[1]
    # every node has a diagonal block, so that a shift can be added
    places = np.concatenate((nodes[row] * count + nodes[column], np.arange(count) * (count + 1)))
    blocks, block = np.unique(places, return_inverse=True)
    gather = csr_array((weights[row] * weights[column], (block[: len(pair)], pair)), shape=(len(blocks), len(first)))
    rows = np.searchsorted(blocks // count, np.arange(count + 1))
    return gather, blocks % count, rows
