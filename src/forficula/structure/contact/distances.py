"""Distances of nodes from triangles and of sides from each other, with their gradients."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Flags

_TINY = np.finfo(float).tiny
# the next and the previous coordinate of x, y, z
_NEXT, _BEFORE, _CORNERS = np.array([1, 2, 0]), np.array([2, 0, 1]), np.arange(3)


@dataclass(frozen=True, kw_only=True, eq=False)
class Nearest:
    """Nearest points of pairs of shapes, each with four corners.

    The distance is the length of the sum of the corners times their weights, and the vector `weights * normals` is its
    gradient by the positions of the corners.

    Attributes:
        distances: m, (...).
        weights: of the four corners, positive on the first shape and negative on the second, (..., 4).
        normals: unit vectors from the second shape to the first, (..., 3); zeros where the distance is 0.
    """

    distances: Array
    weights: Array
    normals: Array

    def some(self, which: Flags) -> Nearest:
        """Select pairs."""
        return Nearest(distances=self.distances[which], weights=self.weights[which], normals=self.normals[which])


def node_from_triangle(corners: Array) -> Nearest:
    """Compute the distances of nodes from triangles.

    Args:
        corners: node, then the corners of the triangle, m, (..., 4, 3).
    """
    node, triangle = corners[..., 0, :], corners[..., 1:, :]
    first, second = triangle[..., 1, :] - triangle[..., 0, :], triangle[..., 2, :] - triangle[..., 0, :]
    away = node - triangle[..., 0, :]
    one_one, one_two, two_two = _dot(first, first), _dot(first, second), _dot(second, second)
    on_one, on_two = _dot(away, first), _dot(away, second)
    area = np.maximum(one_one * two_two - one_two**2, _TINY)
    inner = np.stack([two_two * on_one - one_two * on_two, one_one * on_two - one_two * on_one], axis=-1)
    inner = inner / area[..., None]
    shares = np.concatenate([1 - inner.sum(axis=-1, keepdims=True), inner], axis=-1)
    inside = np.min(shares, axis=-1) >= 0
    # outside the triangle, the nearest point is on the nearest of its sides
    along, start = triangle[..., _NEXT, :] - triangle, node[..., None, :] - triangle
    share = _clipped(_dot(start, along) / np.maximum(_dot(along, along), _TINY))
    gaps = start - share[..., None] * along
    side = _dot(gaps, gaps).argmin(axis=-1)[..., None]
    share = np.take_along_axis(share, side, axis=-1)
    on_tail, on_head = np.equal(side, _CORNERS), np.equal(side, _BEFORE)
    at_sides = (1 - share) * on_tail + share * on_head
    best = np.where(inside[..., None], shares, at_sides)
    return _nearest(corners, np.concatenate([np.ones_like(best[..., :1]), -best], axis=-1))


def side_from_side(corners: Array) -> Nearest:
    """Compute the distances of sides from each other (Ericson 2005, Real-Time Collision Detection, section 5.1.9).

    Args:
        corners: both ends of the first side, then of the second, m, (..., 4, 3).
    """
    one, other = corners[..., 1, :] - corners[..., 0, :], corners[..., 3, :] - corners[..., 2, :]
    away = corners[..., 0, :] - corners[..., 2, :]
    one_one, mixed, two_two = _dot(one, one), _dot(one, other), _dot(other, other)
    on_one, on_two = _dot(one, away), _dot(other, away)
    area = one_one * two_two - mixed**2
    skew = area > 1e-14 * one_one * two_two
    first = _clipped(np.where(skew, (mixed * on_two - on_one * two_two) / np.where(skew, area, 1.0), 0.0))
    second = _clipped((mixed * first + on_two) / np.maximum(two_two, _TINY))
    first = _clipped((mixed * second - on_one) / np.maximum(one_one, _TINY))
    return _nearest(corners, np.stack([1 - first, first, second - 1, -second], axis=-1))


def squared_sines(corners: Array) -> tuple[Array, Array]:
    """Compute the squared sines of the angles between sides, which are 0 for parallel sides, with their gradients.

    Args:
        corners: both ends of the first side, then of the second, m, (..., 4, 3).

    Returns:
        The squared sines, (...), and their gradients by the corners, 1/m, (..., 4, 3).
    """
    one, other = corners[..., 1, :] - corners[..., 0, :], corners[..., 3, :] - corners[..., 2, :]
    normal = row_cross(one, other)
    one_one, two_two = (np.maximum(_dot(side, side), _TINY)[..., None] for side in (one, other))
    scale = np.maximum(one_one * two_two, _TINY)
    squares = _dot(normal, normal)[..., None] / scale
    # the sine does not depend on the lengths of the sides
    of_one = 2 * (row_cross(other, normal) / scale - squares / one_one * one)
    of_other = 2 * (row_cross(normal, one) / scale - squares / two_two * other)
    return squares[..., 0], np.stack([-of_one, of_one, -of_other, of_other], axis=-2)


def side_through_triangle(corners: Array) -> Array:
    """Return whether sides pass through triangles, (...).

    Args:
        corners: both ends of the side, then the corners of the triangle, m, (..., 5, 3).
    """
    tail, head, triangle = corners[..., 0, :], corners[..., 1, :], corners[..., 2:, :]
    normal = row_cross(triangle[..., 1, :] - triangle[..., 0, :], triangle[..., 2, :] - triangle[..., 0, :])
    before, after = _dot(tail - triangle[..., 0, :], normal), _dot(head - triangle[..., 0, :], normal)
    spans = before * after < 0
    share = before / np.where(spans, before - after, 1.0)
    place = tail + share[..., None] * (head - tail)
    inside = spans
    for corner in range(3):
        along = triangle[..., (corner + 1) % 3, :] - triangle[..., corner, :]
        inside = inside & (_dot(row_cross(along, place - triangle[..., corner, :]), normal) > 0)
    return np.asarray(inside)


def _nearest(corners: Array, weights: Array) -> Nearest:
    gaps = (weights[..., None] * corners).sum(axis=-2)
    distances = np.sqrt(_dot(gaps, gaps))
    return Nearest(distances=distances, weights=weights, normals=gaps / np.maximum(distances, _TINY)[..., None])


def row_cross(one: Array, other: Array) -> Array:
    """Compute cross products of vectors, (..., 3), for few vectors faster than `np.cross`."""
    return np.asarray(one[..., _NEXT] * other[..., _BEFORE] - one[..., _BEFORE] * other[..., _NEXT])


def _clipped(shares: Array) -> Array:
    return np.minimum(np.maximum(shares, 0.0), 1.0)


def _dot(one: Array, other: Array) -> Array:
    return np.asarray((one * other).sum(axis=-1))
