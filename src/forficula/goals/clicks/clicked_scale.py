"""Scales of clicked points: from pixels of a picture to m."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError, error_prefix
from forficula.pattern.picture.homography import homography, mapped_points
from forficula.pattern.picture.trace_options import read_corners, read_length, read_size
from forficula.quantities import as_written

_LARGEST = 1e6  # [chosen] pixels, more than any picture that is read has
_MOST = 1000  # [chosen] points of a list


def clicked_points(value: object, key: str) -> Array:
    """Return clicked points, pixels, shape (N, 2); a point that was not clicked, [], has nan.

    Raises:
        InputError: not a list of points, each x and y. The message names the key.
    """
    if isinstance(value, str) or not isinstance(value, Sequence | np.ndarray):
        raise InputError(f"{key}: need a list of points, each [x, y] in pixels, got {as_written(value)}")
    if len(value) > _MOST:
        raise InputError(f"{key}: need at most {_MOST} points, got {len(value)}")
    points = np.full((len(value), 2), np.nan)
    for number, point in enumerate(value):
        numbers = point.tolist() if isinstance(point, np.ndarray) else point
        if isinstance(numbers, list | tuple) and (not numbers or list(map(str, numbers)) == ["nan", "nan"]):
            continue
        points[number] = clicked_point(numbers, f"{key}: entry {number}")
    return points


def clicked_point(value: object, key: str) -> Array:
    """Return a clicked point, pixels, shape (2,).

    Raises:
        InputError: not x and y. The message names the key.
    """
    try:
        point = np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError):
        point = np.zeros(0)
    if point.shape != (2,) or isinstance(value, str) or not (np.abs(point) <= _LARGEST).all():
        raise InputError(f"{key}: need a point [x, y] in pixels, got {as_written(value)}")
    return point


def picture_matrix(scale: object, length: object, corners: object, size: object) -> Array:
    """Return the homography from pixels, y downwards, to m, y upwards.

    Args:
        scale: two points at a known distance, or None.
        length: their distance, such as "5 mm" or in m, or None.
        corners: four corners of a rectangle, clockwise from the upper left one, or None.
        size: width and height of the rectangle, such as "20 x 15 cm", or None.

    Returns:
        Shape (3, 3).

    Raises:
        InputError: neither or both of the two scales, or points that determine no scale.
    """
    if (scale is None) == (corners is None):
        raise InputError(
            "scale: need two points and their distance (scale and length), or four corners and their distances"
            f" (corners and size), got {'neither' if scale is None else 'both'}"
        )
    if scale is not None:
        if length is None:
            raise InputError('length: is missing; give the distance of the two points of scale, such as "5 mm"')
        ends = clicked_points(scale, "scale")
        if ends.shape != (2, 2) or np.isnan(ends).any():
            raise InputError(f"scale: need two points, got {as_written(scale)}")
        apart = float(np.linalg.norm(ends[1] - ends[0]))
        if apart <= 1:
            raise InputError(f"scale: need two points more than 1 pixel apart, got {apart:.3g} pixels")
        factor = read_length(length, "length") / apart
        return np.diag([factor, -factor, 1.0])
    if size is None:
        raise InputError('size: is missing; give width and height between the four corners, such as "20 x 15 cm"')
    places, _ = read_corners(corners)  # type: ignore[arg-type]
    width, height = read_size(size)
    if places is None or height is None:
        raise InputError(f'size: need width and height between the four corners, such as "20 x 15 cm", got {size!r}')
    with error_prefix("corners: "):
        return homography(places, np.array([[0.0, height], [width, height], [width, 0.0], [0.0, 0.0]]))


def to_metres(matrix: Array, points: Array) -> Array:
    """Map clicked points to m; nan stays nan."""
    return mapped_points(matrix, points)
