"""Rasterisation of triangles with a depth buffer: the nearest triangle is visible."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from forficula.arrays import Array, Indices

Picture = NDArray[np.uint8]

SAMPLES = 2  # samples per pixel, across and upwards
# a key contains a triangle's depth in the high bits and its index in the low bits
_BITS = 24
_NAMES, _DEPTHS = (1 << _BITS) - 1, 2.0**38
_NARROW = 1e-9  # samples, width below which a triangle has one depth per row
_AT_ONCE = 1 << 16  # samples per batch, which limits memory


def rasterise(triangles: Array, colours: Array, size: tuple[int, int], samples: int = SAMPLES) -> Picture:
    """Draw triangles that may hide, intersect or touch one another.

    A triangle covers the samples whose centres lie in it, so triangles with a common side leave no gap. Of equally
    close triangles the last one is visible. Parts outside the picture and values that are not finite are left out.

    Args:
        triangles: pixels to the right and downwards, and closeness to the eye in any unit, (triangle, 3, 3).
        colours: red, green, blue, 0 to 1, (triangle, 3).
        size: pixels across and downwards.
        samples: samples per pixel, across and upwards.

    Returns:
        Red, green, blue and opacity of every pixel, 0 to 255, the highest row first, (height, width, 4).
    """
    width, height = size
    nearest = np.full((height * samples, width * samples), -1, dtype=np.int64)
    sound = np.flatnonzero(np.isfinite(triangles).all(axis=(1, 2)))
    if len(sound):
        _fill(nearest, triangles[sound] * [samples, samples, 1.0], sound)
    # four numbers in one, without overflow when samples are added; the last entry is the background
    shades = np.zeros((len(colours) + 1, 4), dtype=np.uint16)
    shades[:-1] = np.column_stack([np.rint(255 * np.clip(colours, 0, 1)), np.full(len(colours), 255)])
    packed = shades.view(np.uint64).ravel()
    total = np.zeros((height, width), dtype=np.uint64)
    for row in range(samples):
        for column in range(samples):
            keys = nearest[row::samples, column::samples]
            total += packed[np.where(keys < 0, len(colours), keys & _NAMES)]
    summed = total.view(np.uint16).reshape(height, width, 4)
    counted = summed[..., 3:] // 255
    summed[..., :3] //= np.maximum(counted, 1)
    summed[..., 3] //= samples**2
    return summed.astype(np.uint8)


def _fill(nearest: Indices, corners: Array, names: Indices) -> None:
    """Store in every sample the key of the nearest triangle: its depth, then its index."""
    height, width = nearest.shape
    # sort the corners of each triangle from top to bottom
    order = np.argsort(corners[:, :, 1], axis=1, kind="stable")
    top, middle, bottom = np.take_along_axis(corners, order[:, :, np.newaxis], axis=1).swapaxes(0, 1)
    which, row = _ranges(*_between(top[:, 1], bottom[:, 1], height))
    y = row.astype(np.float64) + 0.5
    along = _at(top[which], bottom[which], y)
    upper = (y < middle[which, 1])[:, np.newaxis]
    beside = _at(np.where(upper, top[which], middle[which]), np.where(upper, middle[which], bottom[which]), y)
    swapped = along[:, :1] > beside[:, :1]
    left, right = np.where(swapped, beside, along), np.where(swapped, along, beside)
    first, last = _between(left[:, 0], right[:, 0], width)
    depth = corners[:, :, 2]
    extent = float(np.ptp(depth))
    scale = _DEPTHS / extent if extent else 0.0
    slope = scale * (right[:, 2] - left[:, 2]) / np.maximum(right[:, 0] - left[:, 0], _NARROW)
    start = scale * (left[:, 2] - depth.min()) + (first + 0.5 - left[:, 0]) * slope
    counts, names, flat = last - first, names[which], nearest.reshape(-1)
    ends = np.cumsum(counts)
    most = ends[-1] if len(ends) else 0
    cuts = np.searchsorted(ends, np.arange(_AT_ONCE, most + _AT_ONCE, _AT_ONCE), side="right").tolist()
    for begin, end in pairwise([0, *cuts]):
        rows = slice(begin, end)
        many = counts[rows]
        number = np.arange(many.sum()) - (np.cumsum(many) - many).repeat(many)
        away = start[rows].repeat(many) + number * slope[rows].repeat(many)
        keys = (away.astype(np.int64) << _BITS) | names[rows].repeat(many)
        np.maximum.at(flat, number + (row[rows] * width + first[rows]).repeat(many), keys)


def _between(low: Array, high: Array, most: int) -> tuple[Indices, Indices]:
    """Return the first sample whose centre is not before `low`, and the first not before `high`, in the picture."""
    first, last = (np.ceil(np.clip(item, 0, most) - 0.5).astype(np.int64) for item in (low, high))
    return first, last


def _ranges(first: Indices, last: Indices) -> tuple[Indices, Indices]:
    """Return all numbers from the first to before the last of each range: the range's index, and the number."""
    counts = last - first
    which = np.repeat(np.arange(len(counts)), counts)
    return which, np.arange(len(which)) - np.repeat(np.cumsum(counts) - counts - first, counts)


def _at(upper: Array, lower: Array, y: Array) -> Array:
    """Return points on lines at a height, (line, 3)."""
    share = (y - upper[:, 1]) / (lower[:, 1] - upper[:, 1])
    return np.asarray(upper + share[:, np.newaxis] * (lower - upper))
