"""The axes of the unit cube in which a search moves, and the places on them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Point = tuple[float, ...]
# Fine enough for every quantity, and coarse enough that the last bit of a sum is not another point.
_DIGITS = 6


@dataclass(frozen=True, kw_only=True)
class Axis:
    """A parameter as a search sees it: a share from 0 to 1.

    Attributes:
        levels: how many places it has, evenly spaced; 0 where it is continuous.
        ordered: whether near places are alike: those of steps are, those of a choice are not.
    """

    levels: int = 0
    ordered: bool = True

    def __post_init__(self) -> None:
        if self.levels < 0 or (self.levels == 0 and not self.ordered):
            raise ValueError(f"levels: need >= 1 of a choice and >= 0 of what is ordered, got {self.levels}")


def placed(axes: Sequence[Axis], shares: NDArray[np.float64]) -> list[Point]:
    """The nearest places of shares, which may lie outside of 0 to 1; places of n levels are the middles of n parts.

    Args:
        axes: as many as the shares have columns.
        shares: one row a point.
    """
    columns = []
    for axis, column in zip(axes, np.clip(shares, 0.0, 1.0).T, strict=True):
        parts = np.minimum(np.floor(column * axis.levels), axis.levels - 1)
        columns.append(np.round((parts + 0.5) / axis.levels if axis.levels else column, _DIGITS))
    return [tuple(float(value) for value in row) for row in zip(*columns, strict=True)]


def distances(axes: Sequence[Axis], points: NDArray[np.float64], centre: Sequence[float]) -> NDArray[np.float64]:
    """How far points lie from a centre: the greatest difference of any share; 1 where a choice differs."""
    apart = np.abs(points - np.asarray(centre))
    unordered = np.array([not axis.ordered for axis in axes])
    return np.asarray(np.where(unordered & (apart > 0), 1.0, apart).max(axis=1))
