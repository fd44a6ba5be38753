"""Corners of a bright sheet of paper on a darker ground."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import ndimage
from scipy.spatial import ConvexHull, QhullError

from forficula.arrays import Array, Flags

_COARSE = 400  # [chosen] pixels along the longer side of the picture in which the sheet is intersections
_LEAST_AREA, _MOST_AREA = 0.1, 0.98  # [chosen] of the picture
_LEAST_CONTRAST = 0.12  # [chosen] difference of the brightness of sheet and ground
_SAMPLES = 240  # positions along each side at which the edge is measured
_CORNER_SHARE = 0.04  # share of a side beside each corner that is not used
_LEAST_SHARE = 0.7  # [chosen] least share of the positions that agree with the line of a side
_MOST_RESIDUAL = 1.5  # [chosen] pixels


@dataclass(frozen=True, kw_only=True, eq=False)
class SheetCorners:
    """Corners of a sheet in a picture.

    Attributes:
        corners: pixels, clockwise from the upper left one, shape (4, 2).
        residual: root mean square distance of the measured edge from its four lines, pixels.
    """

    corners: Array
    residual: float


def find_corners(brightness: Array) -> SheetCorners | None:
    """Find the corners of the largest bright sheet with four straight sides.

    Args:
        brightness: 0 to 1, shape (height, width).

    Returns:
        The corners with the accuracy of a fraction of a pixel, or None where the picture shows no complete sheet that
        is brighter than its surroundings.
    """
    step = max(1, -(-max(brightness.shape) // _COARSE))
    coarse = _blocks(brightness, step)
    sheet = _bright_part(coarse)
    if sheet is None:
        return None
    quadrilateral = _quadrilateral(sheet)
    if quadrilateral is None:
        return None
    first = _refined(brightness, step * (quadrilateral + 0.5) - 0.5, reach=6.0 * step)
    # once more beside the lines that were found, because a corner may be further from them than the reach
    return None if first is None else _refined(brightness, first.corners, reach=3.0 * step)


def _blocks(values: Array, step: int) -> Array:
    height, width = (size // step * step for size in values.shape)
    blocks = values[:height, :width].reshape(height // step, step, width // step, step)
    return np.asarray(blocks.mean(axis=(1, 3)))


def _bright_part(coarse: Array) -> Flags | None:
    """Return the largest bright connected part of a coarse picture with its holes filled; None without contrast."""
    smooth = ndimage.median_filter(coarse, 5)
    if np.ptp(smooth) < _LEAST_CONTRAST:
        return None
    threshold = _between_classes(smooth)
    bright = smooth > threshold
    if bright.all() or not bright.any():
        return None
    if smooth[bright].mean() - smooth[~bright].mean() < _LEAST_CONTRAST:
        return None
    labels, _ = ndimage.label(ndimage.binary_opening(bright, iterations=2))
    sizes = np.bincount(labels.ravel())[1:]
    if not len(sizes):
        return None
    part: Flags = ndimage.binary_fill_holes(labels == 1 + int(np.argmax(sizes)))
    share = part.mean()
    rim = np.concatenate([part[0], part[-1], part[:, 0], part[:, -1]])
    if not _LEAST_AREA <= share <= _MOST_AREA or rim.mean() > 0.02:
        return None
    return part


def _between_classes(values: Array) -> float:
    """Return the threshold that separates two classes of values best (Otsu 1979)."""
    counts, edges = np.histogram(values, 128)
    middles = (edges[:-1] + edges[1:]) / 2
    below = np.cumsum(counts)
    above = below[-1] - below
    sums = np.cumsum(counts * middles)
    with np.errstate(divide="ignore", invalid="ignore"):
        between = below * above * (sums / below - (sums[-1] - sums) / above) ** 2
    return float(edges[1 + int(np.nanargmax(between[:-1]))])


def _quadrilateral(part: Flags) -> Array | None:
    """Return the four corners of a part of a picture, clockwise from the upper left one; None for another shape."""
    rim = part & ~ndimage.binary_erosion(part)
    points = np.argwhere(rim)[:, ::-1].astype(np.float64)
    try:
        hull = points[ConvexHull(points).vertices]
    except (QhullError, ValueError):
        return None
    corners = _largest_quadrilateral(hull)
    x, y = corners.T
    area = abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1))) / 2
    if not 0.9 < part.sum() / max(area, 1.0) < 1.12:
        return None
    turns = np.arctan2(*(corners - corners.mean(axis=0)).T[::-1])
    corners = corners[np.argsort(turns)]  # clockwise, because y is downwards
    return np.roll(corners, -int(np.argmin(corners.sum(axis=1))), axis=0)


def _largest_quadrilateral(hull: Array) -> Array:
    """Return the four corners of a convex polygon that enclose the largest area."""
    if len(hull) > 60:
        hull = hull[np.linspace(0, len(hull) - 1, 60).astype(int)]
    offset = hull[np.newaxis] - hull[:, np.newaxis]
    # twice the area of triangles of a diagonal and a third corner, with the sign of its side
    cross = offset[:, :, np.newaxis, 0] * offset[:, np.newaxis, :, 1]
    cross = cross - offset[:, :, np.newaxis, 1] * offset[:, np.newaxis, :, 0]
    total = cross.max(axis=2) - cross.min(axis=2)
    one, other = np.unravel_index(int(np.argmax(total)), total.shape)
    corners = [int(one), int(np.argmax(cross[one, other])), int(other), int(np.argmin(cross[one, other]))]
    return hull[corners]


def _refined(brightness: Array, corners: Array, reach: float) -> SheetCorners | None:
    """Fit a line to the steepest brightness beside every side; None where a side is not straight."""
    lines, residuals = [], []
    offsets = np.arange(-reach, reach + 0.5, 0.5)
    middle = corners.mean(axis=0)
    for start, end in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        along = (end - start) / np.linalg.norm(end - start)
        across = np.array([along[1], -along[0]])
        if across @ (middle - start) < 0:
            across = -across  # towards the sheet
        shares = np.linspace(_CORNER_SHARE, 1 - _CORNER_SHARE, _SAMPLES)
        places = start + shares[:, np.newaxis] * (end - start)
        grid = places[:, np.newaxis] + offsets[:, np.newaxis] * across
        profiles = ndimage.map_coordinates(brightness, [grid[..., 1], grid[..., 0]], order=1, mode="nearest")
        slope = np.gradient(ndimage.gaussian_filter1d(profiles, 2.0, axis=1), axis=1)
        best = np.clip(np.argmax(slope, axis=1), 1, slope.shape[1] - 2)
        rows = np.arange(len(best))
        before, at, after = slope[rows, best - 1], slope[rows, best], slope[rows, best + 1]
        bend = before - 2 * at + after
        shift = np.where(bend < 0, 0.5 * (before - after) / np.minimum(bend, -1e-12), 0.0)
        edge = places + (offsets[best] + 0.5 * np.clip(shift, -1, 1))[:, np.newaxis] * across
        fitted = _trimmed_line(edge)
        if fitted is None:
            return None
        normal, distance, residual = fitted
        lines.append((normal, distance))
        residuals.append(residual)
    intersections = []
    for (one, first), (other, second) in zip([lines[-1], *lines[:-1]], lines, strict=True):
        intersections.append(np.linalg.solve(np.stack([one, other]), [first, second]))
    return SheetCorners(corners=np.array(intersections), residual=float(np.sqrt(np.mean(np.square(residuals)))))


def _trimmed_line(points: Array) -> tuple[Array, float, float] | None:
    """Fit a line without outliers: normal, distance and root mean square residual; None if too few points agree."""
    kept = points
    limit = np.inf
    for _ in range(8):
        middle = kept.mean(axis=0)
        normal = np.linalg.svd(kept - middle, full_matrices=False)[2][1]
        beside = np.abs((points - middle) @ normal)
        limit = max(1.0, 2.5 * 1.4826 * float(np.median(beside)))
        kept = points[beside <= limit]
        if len(kept) < _LEAST_SHARE * len(points):
            return None
    residual = float(np.sqrt(np.mean(((kept - middle) @ normal) ** 2)))
    return (normal, float(normal @ middle), residual) if residual <= _MOST_RESIDUAL else None
