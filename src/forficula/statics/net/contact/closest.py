"""Closest points of corners and triangles, and of edges: distances with gradients and Hessians, for many pairs."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from forficula.arrays import Array, Flags

# sides of a triangle by its corners, which are the second to fourth point of a pair
_SIDES = ((1, 2), (2, 3), (3, 1))
_LEAST = 1e-300


class Closest(NamedTuple):
    """Closest points of pairs of four points each.

    Attributes:
        distance: m, (pair,).
        normal: unit vector from the second to the first element of a pair, (pair, 3).
        weights: of the four points in the vector between the closest points, (pair, 4).
        changes: derivatives of the weights by up to two parameters of the closest points, (pair, 4, 2); 0 where a
            closest point is at the end of its range.
    """

    distance: Array
    normal: Array
    weights: Array
    changes: Array


def corner_to_triangle(places: Array, larger: float = 0.0) -> Closest:
    """Find the point of a triangle closest to a corner of another one.

    Args:
        places: of the corner, then of the corners of the triangle, m, (pair, 4, 3).
        larger: share by which the triangle counts as larger.
    """
    scale = _scaled((0,), (1, 2, 3), larger)
    return _closest(places, *_on_triangle(scale @ places), scale)


def _on_triangle(places: Array) -> tuple[Array, Array]:
    """Return weights and their changes for a corner and the point of a triangle closest to it."""
    count = len(places)
    corner, first, second, third = (places[:, number] for number in range(4))
    along, beside, away = second - first, third - first, corner - first
    one, mixed, other = _dot(along, along), _dot(along, beside), _dot(beside, beside)
    size = np.maximum(one * other - mixed**2, _LEAST)
    share = (other * _dot(along, away) - mixed * _dot(beside, away)) / size
    further = (one * _dot(beside, away) - mixed * _dot(along, away)) / size
    inside = (share > 0) & (further > 0) & (share + further < 1)
    weights = np.stack([np.ones(count), -(1 - share - further), -share, -further], axis=1)
    changes = np.zeros((count, 4, 2))
    changes[:, 1], changes[:, 2, 0], changes[:, 3, 1] = 1.0, -1.0, -1.0
    outside = np.flatnonzero(~inside)
    if len(outside):
        candidates = [_on_segment(places[outside], 0, side, 1.0) for side in _SIDES]
        weights[outside], changes[outside] = _nearest(places[outside], candidates)
    return weights, changes


def edge_to_edge(places: Array, larger: float = 0.0) -> Closest:
    """Find the closest points of two edges.

    Args:
        places: of the ends of the first and of the second edge, m, (pair, 4, 3).
        larger: share by which the edges count as longer.
    """
    scale = _scaled((0, 1), (2, 3), larger)
    return _closest(places, *_on_edges(scale @ places), scale)


def _on_edges(places: Array) -> tuple[Array, Array]:
    """Return weights and their changes for the closest points of two edges."""
    count = len(places)
    first, second, away = places[:, 1] - places[:, 0], places[:, 3] - places[:, 2], places[:, 0] - places[:, 2]
    one, mixed, other = _dot(first, first), _dot(first, second), _dot(second, second)
    size = one * other - mixed**2
    known = np.maximum(size, _LEAST)
    share = (mixed * _dot(second, away) - other * _dot(first, away)) / known
    further = (one * _dot(second, away) - mixed * _dot(first, away)) / known
    inside = (share > 0) & (share < 1) & (further > 0) & (further < 1) & (size > 0)
    weights = np.stack([1 - share, share, -(1 - further), -further], axis=1)
    changes = np.zeros((count, 4, 2))
    changes[:, 0, 0], changes[:, 1, 0], changes[:, 2, 1], changes[:, 3, 1] = -1.0, 1.0, 1.0, -1.0
    outside = np.flatnonzero(~inside)
    if len(outside):
        candidates = [_on_segment(places[outside], end, (2, 3), 1.0) for end in (0, 1)]
        candidates += [_on_segment(places[outside], end, (0, 1), -1.0) for end in (2, 3)]
        weights[outside], changes[outside] = _nearest(places[outside], candidates)
    return weights, changes


def distance_hessians(places: Array, closest: Closest) -> Array:
    """Compute Hessians of the distances by the positions of the four points, 1/m, (pair, 12, 12).

    The closest points minimise half the squared distance q over their parameters b. The Hessian of this minimum is
    q_xx - q_xb q_bb^-1 q_bx (implicit function theorem).
    """
    weights, changes, count = closest.weights, closest.changes, len(places)
    between = closest.distance[:, None] * closest.normal
    moved = np.einsum("pim,pix->pxm", changes, places)
    mixed = np.einsum("pi,pxm->pixm", weights, moved) + np.einsum("px,pim->pixm", between, changes)
    inner = np.einsum("pxm,pxn->pmn", moved, moved)
    # a parameter at the end of its range does not change
    fixed = ~changes.any(axis=1)
    inner[:, [0, 1], [0, 1]] += fixed
    mixed = mixed.reshape(count, 12, 2)
    squared = np.einsum("pi,pj,xy->pixjy", weights, weights, np.eye(3)).reshape(count, 12, 12)
    squared -= mixed @ np.linalg.solve(inner, np.swapaxes(mixed, 1, 2))
    slopes = gradients(closest).reshape(count, 12)
    return np.asarray(
        (squared - slopes[:, :, None] * slopes[:, None]) / np.maximum(closest.distance, _LEAST)[:, None, None]
    )


def gradients(closest: Closest) -> Array:
    """Return gradients of the distances by the positions of the four points, (pair, 4, 3)."""
    return closest.weights[:, :, None] * closest.normal[:, None]


def _dot(one: Array, other: Array) -> Array:
    return np.asarray(np.einsum("px,px->p", one, other))


def _on_segment(places: Array, end: int, side: tuple[int, int], sign: float) -> tuple[Array, Array]:
    """Return weights and their changes for the point of a segment closest to another of the four points.

    Args:
        places: m, (pair, 4, 3).
        end: number of the point.
        side: numbers of the ends of the segment.
        sign: weight of the point.
    """
    first, second = side
    along = places[:, second] - places[:, first]
    share = _dot(along, places[:, end] - places[:, first]) / np.maximum(_dot(along, along), _LEAST)
    within: Flags = (share > 0) & (share < 1)
    share = np.clip(share, 0.0, 1.0)
    weights, changes = np.zeros((len(places), 4)), np.zeros((len(places), 4, 2))
    weights[:, end], weights[:, first], weights[:, second] = sign, -sign * (1 - share), -sign * share
    changes[within, first, 0], changes[within, second, 0] = sign, -sign
    return weights, changes


def _nearest(places: Array, candidates: list[tuple[Array, Array]]) -> tuple[Array, Array]:
    """Return the weights and changes of the candidate with the least distance, pair by pair."""
    apart = [np.linalg.norm(np.einsum("pi,pix->px", weights, places), axis=1) for weights, _ in candidates]
    best, rows = np.argmin(apart, axis=0), np.arange(len(places))
    weights, changes = (np.stack(parts)[best, rows] for parts in zip(*candidates, strict=True))
    return weights, changes


def _scaled(first: tuple[int, ...], second: tuple[int, ...], larger: float) -> Array:
    """Return the matrix that moves the four points of a pair away from the middles of both elements, (4, 4)."""
    scale = np.eye(4)
    for corners in (first, second):
        rows = np.ix_(corners, corners)
        scale[rows] += larger * (np.eye(len(corners)) - 1 / len(corners))
    return scale


def _closest(places: Array, weights: Array, changes: Array, scale: Array) -> Closest:
    weights, changes = weights @ scale, np.einsum("pim,ij->pjm", changes, scale)
    between = np.einsum("pi,pix->px", weights, places)
    distance = np.linalg.norm(between, axis=1)
    normal = between / np.maximum(distance, _LEAST)[:, None]
    return Closest(distance, normal, weights, changes)
