"""What objectives and margins do near a point: parabolas through the trials around it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Indices

# Trials that nearly coincide, as shares of their distance from the centre, tell a parabola nothing.
_APART = 0.02
# How many trials a coefficient gets.
_TRIALS = 2
# A trial at this share of the distance counts half of one at the centre.
_NEAR = 0.1
LEAST_RADIUS = 1e-6
# A column of which no more than this share is its own is made up by others.
_DEPENDENT = 1e-8


@dataclass(frozen=True, kw_only=True)
class Parabola:
    """A quantity near a centre.

    Attributes:
        value: at the centre.
        slope: its derivatives by the shares of the free axes.
        curvature: its second derivatives, symmetric.
        span: by how much the trials that it goes through differ.
    """

    value: float
    slope: Array
    curvature: Array
    span: float


def nearby(points: Array, away: Array, count: int) -> Indices:
    """Numbers of the points nearest to a centre, the nearest first, without those that nearly coincide.

    Args:
        points: one row each.
        away: their distances from the centre.
        count: how many at most.
    """
    order = np.argsort(away, kind="stable")[: 4 * count]
    chosen: list[int] = []
    for number in order:
        if len(chosen) == count:
            break
        apart = np.abs(points[chosen] - points[number]).max(axis=1, initial=0.0) if chosen else np.ones(1)
        if apart.min() > _APART * away[number]:
            chosen.append(int(number))
    return np.array(chosen, dtype=np.int64)


def fitted(points: Array, values: Array, centre: Array) -> Parabola:
    """The parabola that best fits values near a centre; a plane where there are too few of them.

    Args:
        points: places on the free axes, one row each.
        values: of a quantity there.
        centre: of the neighbourhood.
    """
    steps = points - centre
    # so that squares of small steps are no smaller than the steps
    radius = max(float(np.abs(steps).max()), LEAST_RADIUS)
    steps = steps / radius
    count, axes = steps.shape
    rows, columns = np.triu_indices(axes)
    terms = [np.ones((count, 1)), steps]
    if count >= coefficients(axes) + 2:
        terms.append(steps[:, rows] * steps[:, columns])
    weights = 1 / (_NEAR + np.abs(steps).max(axis=1))
    solution = least_squares(np.hstack(terms) * weights[:, None], values * weights)
    curvature = np.zeros((axes, axes))
    if len(terms) > 2:
        np.add.at(curvature, (rows, columns), solution[1 + axes :])
        curvature += curvature.T
    return Parabola(
        value=float(solution[0]),
        slope=solution[1 : 1 + axes] / radius,
        curvature=curvature / radius**2,
        span=float(np.ptp(values)),
    )


def coefficients(axes: int) -> int:
    """How many coefficients a parabola over so many axes has."""
    return (axes + 1) * (axes + 2) // 2


def wanted_trials(axes: int) -> int:
    """How many trials a parabola is fitted to, if there are as many."""
    return _TRIALS * coefficients(axes)


def least_squares(columns: Array, values: Array) -> Array:
    """What columns must be multiplied with to come nearest to values, by Gram-Schmidt, twice for good measure.

    A column that the ones before already make up gets 0. Sums are taken row by row, so that the last bit is the same on
    every processor, which that of a library is not.

    Args:
        columns: one row a value.
        values: to come near to.
    """
    count = columns.shape[1]
    basis, upper, share = np.zeros_like(columns), np.zeros((count, count)), np.zeros(count)
    sizes = np.sqrt((columns**2).sum(axis=0))
    rest = values.copy()
    for number in range(count):
        column = columns[:, number].copy()
        for _ in range(2):
            along = (basis[:, :number] * column[:, None]).sum(axis=0)
            upper[:number, number] += along
            column -= (basis[:, :number] * along).sum(axis=1)
        size = float(np.sqrt((column**2).sum()))
        if size <= _DEPENDENT * sizes[number]:
            continue
        upper[number, number] = size
        basis[:, number] = column / size
        share[number] = (basis[:, number] * rest).sum()
        rest -= share[number] * basis[:, number]
    found = np.zeros(count)
    for number in reversed(range(count)):
        if upper[number, number] > 0:
            left = share[number] - (upper[number, number + 1 :] * found[number + 1 :]).sum()
            found[number] = left / upper[number, number]
    return found
