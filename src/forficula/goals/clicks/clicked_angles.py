"""Angles that one view can measure, with their uncertainties from those of clicks."""

from __future__ import annotations

import math

import numpy as np

from forficula.arrays import Array


def turn_angles(points: Array, accuracy: float) -> tuple[Array, Array]:
    """Compute the fold angle at the middle one of three points, for an axis along the view.

    Args:
        points: pixels, y downwards, shape (frames, 3, 2).
        accuracy: standard uncertainty of a coordinate, pixels.

    Returns:
        Angles, 0 where the points are in line, counterclockwise positive, without jumps of 360 deg; and their standard
        uncertainties; rad, (frames,) each.
    """
    upwards = points * [1, -1]
    inner, outer = upwards[:, 1] - upwards[:, 0], upwards[:, 2] - upwards[:, 1]
    cross = inner[:, 0] * outer[:, 1] - inner[:, 1] * outer[:, 0]
    angles = np.unwrap(np.arctan2(cross, (inner * outer).sum(axis=1)))
    # gradients of the directions of both segments
    of_inner, of_outer = (
        np.stack([-side[:, 1], side[:, 0]], axis=1) / (side**2).sum(axis=1)[:, None] for side in (inner, outer)
    )
    squares = (of_inner**2 + of_outer**2 + (of_inner + of_outer) ** 2).sum(axis=1)
    return angles, accuracy * np.sqrt(squares)


def foreshortened_angles(lengths: Array, length: float, accuracy: float) -> tuple[Array, Array]:
    """Compute the inclination of a segment to the picture plane, |angle| = acos(projected / true length).

    Near 0 the projected length does not depend on the angle in first order. The uncertainty there is the angle that
    shortens the segment by the uncertainty of its length.

    Args:
        lengths: projected lengths, m, (frames,).
        length: true length, m.
        accuracy: standard uncertainty of a coordinate, m.

    Returns:
        Angles, from 0 to 90 deg, and their standard uncertainties, rad, (frames,) each.
    """
    ratio, of_ratio = np.minimum(lengths / length, 1.0), math.sqrt(2) * accuracy / length
    angles = np.arccos(ratio)
    least = math.sqrt(2 * of_ratio)
    return angles, np.minimum(of_ratio / np.maximum(np.sin(angles), 1e-12), least)
