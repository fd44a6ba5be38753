"""Homographies between points of a picture and points of a plane sheet."""

from __future__ import annotations

import math

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError

_PARALLEL = 0.02  # [chosen] perspective below which the sides of a sheet count as parallel in the picture


def homography(picture_points: Array, sheet_points: Array) -> Array:
    """Compute the homography that maps points of a picture to points of a sheet.

    Least squares of the direct linear transformation, with both sets of points centred and scaled (Hartley 1997). Four
    points determine the homography exactly if no three of them lie on a line.

    Args:
        picture_points: pixels, shape (N, 2), N at least 4.
        sheet_points: m, shape (N, 2).

    Returns:
        Matrix H, shape (3, 3): the sheet point of (x, y) is (u / w, v / w) with (u, v, w) = H (x, y, 1).

    Raises:
        InputError: fewer than four points, or points that do not determine a homography.
    """
    if picture_points.shape != sheet_points.shape or picture_points.ndim != 2 or len(picture_points) < 4:
        raise InputError(
            f"need 4 points or more, and as many of the sheet, got {len(picture_points)} and {len(sheet_points)}"
        )
    to_picture, to_sheet = _scaling(picture_points), _scaling(sheet_points)
    (x, y), (u, v) = mapped_points(to_picture, picture_points).T, mapped_points(to_sheet, sheet_points).T
    zero, one = np.zeros_like(x), np.ones_like(x)
    rows = np.concatenate(
        [
            np.column_stack([x, y, one, zero, zero, zero, -u * x, -u * y, -u]),
            np.column_stack([zero, zero, zero, x, y, one, -v * x, -v * y, -v]),
        ]
    )
    _, singular, right = np.linalg.svd(rows)
    if singular[7] < 1e-9 * singular[0]:
        raise InputError("need points such that no three lie on a line")
    scaled = np.linalg.solve(to_sheet, right[-1].reshape(3, 3) @ to_picture)
    return np.asarray(scaled / scaled[2, 2])


def _scaling(points: Array) -> Array:
    """Return the similarity that moves points to the origin, at a mean distance of sqrt(2) from it."""
    centre = points.mean(axis=0)
    factor = math.sqrt(2) / max(float(np.linalg.norm(points - centre, axis=1).mean()), 1e-300)
    return np.array([[factor, 0, -factor * centre[0]], [0, factor, -factor * centre[1]], [0, 0, 1]])


def mapped_points(matrix: Array, points: Array) -> Array:
    """Map points by a homography.

    Args:
        matrix: shape (3, 3).
        points: shape (..., 2).

    Returns:
        Shape (..., 2).
    """
    lifted = points @ matrix[:, :2].T + matrix[:, 2]
    return np.asarray(lifted[..., :2] / lifted[..., 2:])


def metres_per_pixel(matrix: Array, points: Array) -> Array:
    """Compute the length on the sheet of one pixel of the picture, as the square root of the ratio of areas.

    Args:
        matrix: homography from pixels to m, shape (3, 3).
        points: pixels, shape (N, 2).

    Returns:
        m per pixel, shape (N,).
    """
    weight = points @ matrix[2, :2] + matrix[2, 2]
    return np.asarray(np.sqrt(np.abs(np.linalg.det(matrix) / weight**3)))


def check_corners(corners: Array, width: int, height: int) -> None:
    """Refuse four corners that no view of a rectangle has.

    Args:
        corners: pixels, x to the right and y downwards, clockwise in the picture, shape (4, 2).
        width: of the picture, pixels.
        height: of the picture, pixels.

    Raises:
        InputError: another shape, corners far outside of the picture, or corners that are not convex and clockwise.
    """
    if corners.shape != (4, 2) or not np.isfinite(corners).all():
        raise InputError(f"need 4 corners, each x and y in pixels, got shape {corners.shape}")
    size = np.array([width, height])
    if ((corners < -size) | (corners > 2 * size)).any():
        raise InputError(f"need corners in or near the picture of {width} x {height} pixels, got {_text(corners)}")
    sides = np.roll(corners, -1, axis=0) - corners
    after = np.roll(sides, -1, axis=0)
    turns = sides[:, 0] * after[:, 1] - sides[:, 1] * after[:, 0]
    if (turns <= 1e-3 * width * height / 100).any():
        raise InputError(
            "need the four corners of the sheet in their order around it, clockwise in the picture from the upper"
            f" left one, got {_text(corners)}"
        )


def _text(corners: Array) -> str:
    return " ".join(f"{x:.6g},{y:.6g}" for x, y in corners.tolist())


def side_ratio(corners: Array, centre: Array) -> tuple[float, bool]:
    """Estimate width / height of a rectangle from its four corners in a picture.

    With square pixels and the optical axis through the centre of the picture, the perspective gives the focal length
    and the ratio (Zhang and He 2007, doi 10.1016/j.dsp.2006.05.006). Where opposite sides are nearly parallel in the
    picture, the perspective is too weak, and the ratio is that of the mean lengths of opposite sides.

    Args:
        corners: pixels, clockwise from the upper left one, shape (4, 2).
        centre: centre of the picture, pixels, shape (2,).

    Returns:
        The ratio, and whether it follows from the perspective.
    """
    upper_left, upper_right, lower_right, lower_left = (np.array([*(corner - centre), 1.0]) for corner in corners)
    lengths = np.linalg.norm(np.roll(corners, -1, axis=0) - corners, axis=1)
    mean = float((lengths[0] + lengths[2]) / (lengths[1] + lengths[3]))
    scale = float(lengths.mean())
    for point in (upper_left, upper_right, lower_right, lower_left):
        point[:2] /= scale
    across = np.cross(upper_left, lower_right)
    second = across @ lower_left / (np.cross(upper_right, lower_right) @ lower_left)
    third = across @ upper_right / (np.cross(lower_left, lower_right) @ upper_right)
    along = second * upper_right - upper_left
    down = third * lower_left - upper_left
    if min(abs(along[2]), abs(down[2])) < _PARALLEL:
        return mean, False
    square = -(along[0] * down[0] + along[1] * down[1]) / (along[2] * down[2])
    if square <= 0:
        return mean, False
    weights = np.array([1 / square, 1 / square, 1.0])
    return math.sqrt(float((along**2 @ weights) / (down**2 @ weights))), True
