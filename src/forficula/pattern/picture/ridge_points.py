"""Centre lines of strokes, to a fraction of a pixel."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from forficula.arrays import Array, Indices
from forficula.pattern.picture.ink import Ink

_LEAST_NOISES = 6.0  # [chosen] curvature of a ridge, in standard deviations of the noise
_LEAST_SHARE = 0.12  # [chosen] curvature of a ridge, as a share of that of dark lines
_REACH = 0.6  # pixels between the centre of a pixel and a ridge in it


@dataclass(frozen=True, kw_only=True, eq=False)
class RidgePoints:
    """Points on the centre lines of strokes.

    Attributes:
        places: pixels, x and y, shape (N, 2).
        angles: direction of the stroke, rad, 0 to pi, shape (N,).
        strengths: curvature across the stroke, shape (N,).
        number_at: number of the point at every pixel, -1 without one, shape (height, width).
    """

    places: Array
    angles: Array
    strengths: Array
    number_at: Indices


def ridge_points(ink: Ink) -> RidgePoints:
    """Find points on the centre lines of strokes.

    A point is on a centre line where the first derivative across the stroke vanishes within the pixel and the second is
    negative (Steger 1998, doi 10.1109/34.659930). The derivatives are those of the smoothed ink.
    """
    sigma = max(1.0, ink.line_width / 2.8)
    candidates = np.flatnonzero(ndimage.gaussian_filter(ink.strength, sigma) > max(3 * ink.noise / sigma, 0.04))
    orders = {"x": (0, 1), "y": (1, 0), "xx": (0, 2), "xy": (1, 1), "yy": (2, 0)}
    of = {
        name: ndimage.gaussian_filter(ink.strength, sigma, order=order).ravel()[candidates]
        for name, order in orders.items()
    }
    mean, half = (of["xx"] + of["yy"]) / 2, (of["xx"] - of["yy"]) / 2
    bend = mean - np.hypot(half, of["xy"])  # the smaller eigenvalue
    across = 0.5 * np.arctan2(of["xy"], half) + np.pi / 2  # its direction
    nx, ny = np.cos(across), np.sin(across)
    with np.errstate(divide="ignore", invalid="ignore"):
        shift = -(of["x"] * nx + of["y"] * ny) / bend
    strength = -bend * sigma**2
    dark = float(np.percentile(strength, 95)) if len(strength) else 0.0
    least = max(_LEAST_SHARE * dark, _LEAST_NOISES * ink.noise / (2 * sigma), 0.02)
    kept = (strength > least) & (np.abs(shift * nx) <= _REACH) & (np.abs(shift * ny) <= _REACH)
    y, x = np.divmod(candidates[kept], ink.strength.shape[1])
    places = np.column_stack([x + (shift * nx)[kept], y + (shift * ny)[kept]])
    number_at = np.full(ink.strength.shape, -1, dtype=np.int64)
    number_at[y, x] = np.arange(len(x))
    return RidgePoints(
        places=places,
        angles=(across[kept] + np.pi / 2) % np.pi,
        strengths=strength[kept],
        number_at=number_at,
    )
