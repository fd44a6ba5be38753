"""Least squares of a fan to clicked points, with known numbers of the veins."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np
from scipy.optimize import least_squares

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.pattern import Picture

_ANGLES = 360  # [chosen] sector angles of the scan, between which the last vein turns by 2 deg
_STARTS = 3  # [chosen] largest number of minima of the scan that are refined
_WORST_START = 25.0  # [chosen] ratio to the least sum of squares above which a minimum is not refined


@dataclass(frozen=True, kw_only=True, eq=False)
class FanClicks:
    """Clicked points of a fan.

    Attributes:
        points: position of the base, the ring vertex and the tip of every vein, m, y upwards, shape (veins, 3, 2); nan
            where a point was not clicked.
        hub: centre of the hub, m; None if it was not clicked.
        numbers: numbers of the veins; None to find out which veins were not clicked.
        matrix: homography from pixels to m, shape (3, 3).
        picture: the picture; None without one.
        name: name of the picture or of the file.
    """

    points: Array
    hub: Array | None = None
    numbers: tuple[int, ...] | None = None
    matrix: Array = field(default_factory=lambda: np.diag([1.0, -1.0, 1.0]))
    picture: Picture | None = None
    name: str = ""


def as_complex(points: Array) -> Array:
    """Return points of the plane, shape (..., 2) or with more coordinates, as complex numbers."""
    return np.asarray(points[..., 0] + 1j * points[..., 1])


def fan_points(unknowns: Array, numbers: Array | Indices) -> Array:
    """Return base, ring vertex and tip of veins, m, shape (veins, 3, 2).

    Args:
        unknowns: signed hub radius, proximal and distal length, signed sector angle, x and y of the centre, direction
            of the first ring vertex.
        numbers: numbers of the veins.
    """
    hub, proximal, distal, sector, x, y, turn = unknowns
    epsilon = math.atan2(hub, proximal)
    ray = np.exp(1j * (turn + sector * numbers))
    base = hub * ray * np.exp(1j * (epsilon - math.pi / 2))
    ring = math.hypot(proximal, hub) * ray
    points = np.stack([base, ring, ring + distal * ray * np.exp(-1j * epsilon)], axis=1) + (x + 1j * y)
    return np.stack([points.real, points.imag], axis=-1)


def _apart(unknowns: Array, clicks: FanClicks, numbers: Indices) -> Array:
    """Return the deviations of all clicked coordinates from a fan, m."""
    apart = (clicks.points - fan_points(unknowns, numbers)).ravel()
    of_hub = np.zeros(0) if clicks.hub is None else clicks.hub - unknowns[4:6]
    return np.concatenate([apart[~np.isnan(apart)], of_hub])


def least_squares_fan(clicks: FanClicks, numbers: Indices) -> tuple[Array, Array, Array]:
    """Return the unknowns of the best fan with these numbers of veins, its residuals, m, and the Jacobian."""
    best = None
    whole = clicks.points[~np.isnan(clicks.points[:, :, 0])]
    size = float(np.ptp(whole, axis=0).max())
    if size == 0:
        raise InputError("need clicked points at different positions, got one position")
    for start in _starts(clicks, numbers):
        scales = np.array([size, size, size, 1 / max(int(numbers.max()), 1), size, size, 1.0])
        done = least_squares(
            lambda unknowns: _apart(unknowns, clicks, numbers) / size,
            start,
            x_scale=scales,
            method="lm",
            max_nfev=2000,
        )
        if best is None or done.cost * size**2 < best[0]:
            best = done.cost * size**2, done.x, size * done.fun, size * done.jac
    assert best is not None
    unknowns = best[1]
    if unknowns[1] < 0:  # the same fan with the veins on the other side of the centre
        unknowns = unknowns * np.array([-1, -1, 1, 1, 1, 1, 1]) + np.array([0, 0, 0, 0, 0, 0, math.pi])
        best = best[0], unknowns, best[2], best[3] * np.array([-1, -1, 1, 1, 1, 1, 1])
    return unknowns, best[2], best[3]


def _starts(clicks: FanClicks, numbers: Indices) -> Iterator[Array]:
    """Yield starts: the minima of linear least squares over sector angles."""
    known = ~np.isnan(clicks.points[:, :, 0])
    vein, role = np.nonzero(known)
    places = as_complex(clicks.points[vein, role])
    most = min(2 * math.pi / max(int(numbers.max()), 1), math.pi)
    angles = most * (np.arange(_ANGLES) + 0.5 - _ANGLES / 2) / (_ANGLES / 2)
    rays = np.exp(1j * angles[:, None] * numbers[vein])
    columns = [np.ones_like(rays), rays * (role >= 1), rays * (role == 2)]
    if (role == 0).any():
        columns.append(rays * (role == 0))
    matrix = np.stack(columns, axis=-1)
    if clicks.hub is not None:
        row = np.zeros((_ANGLES, 1, matrix.shape[-1]))
        row[..., 0] = 1
        matrix, places = np.concatenate([matrix, row], axis=1), np.append(places, as_complex(clicks.hub))
    solved = np.linalg.pinv(matrix) @ places
    costs = np.sum(np.abs((matrix @ solved[..., None])[..., 0] - places) ** 2, axis=1)
    around = np.concatenate([[np.inf], costs, [np.inf]])
    minima = np.flatnonzero((costs <= around[:-2]) & (costs <= around[2:]))
    minima = minima[np.argsort(costs[minima])][:_STARTS]
    for index in minima[costs[minima] <= _WORST_START * costs[minima[0]]]:
        centre, radius, distal = solved[index, :3].tolist()
        epsilon = -float(np.angle(distal / radius)) if radius and distal else 0.0
        # a hub whose tangents point outwards
        epsilon = min(max(epsilon, -1.4), 1.4)
        yield np.array(
            [
                abs(radius) * math.sin(epsilon),
                abs(radius) * math.cos(epsilon),
                abs(distal),
                angles[index],
                centre.real,
                centre.imag,
                float(np.angle(radius)),
            ]
        )
