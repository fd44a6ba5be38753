"""Fit of a fan whose veins differ to clicked points."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from typing import Annotated

import numpy as np
from scipy.optimize import least_squares

from forficula.arrays import Array, Indices
from forficula.design import Design
from forficula.errors import InputError
from forficula.goals.clicks.fan_least_squares import FanClicks, as_complex
from forficula.pattern import EarwigFan, Tangent, hub_points, ring_vertices, tips
from forficula.serial import Metres, Radians, Written

_FEWEST_DIFFERENT = 5  # veins, from which on a fan with different veins has fewer unknowns than coordinates


@dataclass(frozen=True, kw_only=True, eq=False)
class DifferentVeins:
    """Fit of a fan whose veins differ: a length of every part of a vein and a sector angle of every panel.

    Attributes:
        rms: root mean square distance of the clicked points, m.
        freedoms: number of coordinates minus the number of unknowns.
        unknowns: number of unknowns, with the placement.
        hub_radius: hub radius, m.
        proximal_lengths: length of every vein up to the ring fold, counterclockwise, m.
        distal_lengths: length of every vein beyond the ring fold, counterclockwise, m.
        sector_angles: angle from every vein to the next one, counterclockwise, rad.
        design: design with these veins; None where the fan family does not allow them.
    """

    rms: Metres
    freedoms: int
    unknowns: int
    hub_radius: Metres
    proximal_lengths: tuple[Metres, ...]
    distal_lengths: tuple[Metres, ...]
    sector_angles: tuple[Radians, ...]
    design: Annotated[Design | None, Written.NEVER] = None


def fit_different_veins(clicks: FanClicks, numbers: Indices, unknowns: Array) -> tuple[DifferentVeins, Array] | None:
    """Fit a fan whose veins differ; return it with the deviations of all points, m, shape (veins, 3, 2).

    Returns None where a vein lacks its ring vertex or its tip, for an even number of veins or fewer than 5, and where
    the family of fans allows no such fan near the common one.
    """
    count = len(numbers)
    whole = not np.isnan(clicks.points[:, 1:]).any() and (np.diff(numbers) == 1).all()
    if not whole or count % 2 == 0 or count < _FEWEST_DIFFERENT:
        return None
    order = np.arange(count) if unknowns[3] > 0 else np.arange(count)[::-1]
    clicked = clicks.points[order]
    size = float(unknowns[1] + unknowns[2])
    tangent: Tangent = "right" if unknowns[0] >= 0 else "left"

    def fan_of(values: Array) -> EarwigFan:
        proximal, distal, sectors = np.split(values[4:], [count, 2 * count])
        return EarwigFan(
            proximal_length=float(proximal.mean()) * size,
            distal_length=float(distal.mean()) * size,
            hub_radius=float(values[0]) * size,
            sector_angle=float(sectors.mean()),
            units=(count - 1) // 2,
            tangent=tangent,
            proximal_shares=tuple((proximal / proximal.mean()).tolist()),
            distal_shares=tuple((distal / distal.mean()).tolist()),
            sector_shares=tuple((sectors / sectors.mean()).tolist()),
        )

    def apart_of(values: Array) -> Array:
        fan = fan_of(values)
        drawn = np.stack([as_complex(part) for part in (hub_points(fan), ring_vertices(fan), tips(fan))], axis=1)
        placed = drawn * np.exp(1j * values[3]) + size * (values[1] + 1j * values[2])
        return np.asarray(clicked - np.stack([placed.real, placed.imag], axis=-1))

    def residuals(values: Array) -> Array:
        try:
            apart = apart_of(values).ravel()
        except InputError:
            return np.full(coordinates, 10.0)
        of_hub = np.zeros(0) if clicks.hub is None else clicks.hub - size * values[1:3]
        return np.concatenate([apart[~np.isnan(apart)], of_hub]) / size

    coordinates = int((~np.isnan(clicked)).sum()) + (0 if clicks.hub is None else 2)
    middle = float(unknowns[6] + unknowns[3] * (count - 1) / 2)
    common = [unknowns[1] / size, unknowns[2] / size, abs(unknowns[3])]
    sides = [[value] * (count - (position == 2)) for position, value in enumerate(common)]
    start = np.array([abs(unknowns[0]) / size, *(unknowns[4:6] / size), middle, *itertools.chain(*sides)])
    freedoms = coordinates - len(start)
    if freedoms < 1 or residuals(start)[0] == 10.0:
        return None
    low = np.full(len(start), -np.inf)
    low[0], low[4:] = 0.0, 1e-3
    done = least_squares(residuals, np.maximum(start, low + 1e-9), bounds=(low, np.inf), x_scale="jac", max_nfev=60)
    best = done.x
    if done.fun[0] == 10.0:
        return None
    apart = apart_of(best)
    squares = (apart**2).sum(axis=-1)
    distances = squares[~np.isnan(squares)].tolist()
    if clicks.hub is not None:
        distances.append(float(((clicks.hub - size * best[1:3]) ** 2).sum()))
    proximal, distal, sectors = np.split(best[4:], [count, 2 * count])
    fit = DifferentVeins(
        rms=math.sqrt(float(np.mean(distances))),
        freedoms=freedoms,
        unknowns=len(best),
        hub_radius=float(best[0]) * size,
        proximal_lengths=tuple((size * proximal).tolist()),
        distal_lengths=tuple((size * distal).tolist()),
        sector_angles=tuple(sectors.tolist()),
    )
    return fit, apart[np.argsort(order)]
