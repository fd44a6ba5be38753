"""Monotone states over a grid: what completed runs imply, and which run is most informative."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from forficula.study.running.journal import Row

# states of a grid's points
OPEN, FAILS, HOLDS, UNTOLD = -1, 0, 1, 2
States = NDArray[np.int8]


def follows(known: States, axes: Sequence[int], reversed_axes: Sequence[int]) -> States:
    """Return the states of all points of a grid that known points imply.

    A state that holds also holds further along an axis, and one that fails also fails before. A known state takes
    precedence over implied ones, and an implied "holds" over an implied "fails".

    Args:
        known: OPEN, FAILS, HOLDS or UNTOLD for each point, any shape.
        axes: along which the state holds for larger values, too.
        reversed_axes: along which the state holds for smaller values, too.

    Returns:
        Same shape as `known`, with OPEN only where nothing is implied.
    """
    up, down = _reach(known == HOLDS, axes, reversed_axes), _reach(known == FAILS, reversed_axes, axes)
    implied = np.where(up, HOLDS, np.where(down, FAILS, OPEN))
    return np.asarray(np.where(known == OPEN, implied, known), dtype=np.int8)


def next_point(states: States, axes: Sequence[int], reversed_axes: Sequence[int]) -> tuple[int, ...] | None:
    """Return the open point whose run is most informative; None if no point is open.

    It maximises the number of open points whose state is implied in the less favourable case. Of equal points the first
    one is returned.
    """
    open_points = np.argwhere(states == OPEN)
    best: tuple[int, tuple[int, ...]] | None = None
    for point in map(tuple, open_points.tolist()):
        start = np.zeros(states.shape, dtype=bool)
        start[point] = True
        implied = min(
            int((_reach(start, *directions) & (states == OPEN)).sum())
            for directions in ((axes, reversed_axes), (reversed_axes, axes))
        )
        if best is None or implied > best[0]:
            best = implied, point
    return None if best is None else best[1]


def _reach(start: NDArray[np.bool_], axes: Sequence[int], reversed_axes: Sequence[int]) -> NDArray[np.bool_]:
    """Return the points beyond some points, including these: upwards along axes, downwards along reversed ones."""
    reached = start
    for axis in axes:
        reached = np.logical_or.accumulate(reached, axis=axis)
    for axis in reversed_axes:
        reached = np.flip(np.logical_or.accumulate(np.flip(reached, axis), axis=axis), axis)
    return reached


@dataclass(kw_only=True)
class Ladder:
    """Values of a condition that were tried, and the least one that reaches the state.

    Attributes:
        holds: index of the least value that is known to reach it; the number of values if none is.
        fails: index of the largest smaller value that does not reach it, or is treated as such; -1 if none.
        untold: indices of inconclusive values whose result is not implied by others.
        rows: rows of tried values, by index.
    """

    holds: int
    fails: int = -1
    untold: list[int] = field(default_factory=list)
    rows: dict[int, Row] = field(default_factory=dict)

    def next(self, count: int, *, monotone: bool) -> int:
        """Return the index of the next value to try: first the largest, which other facts use, too, then the middle.

        Args:
            count: number of values.
            monotone: whether all values above a successful one are assumed to succeed; if not, the next value is
                returned.
        """
        if not monotone:
            return self.fails + 1
        return count - 1 if self.holds == count else (self.fails + self.holds) // 2

    def tell(self, number: int, row: Row, *, holds: bool | None, monotone: bool) -> None:
        """Record the result of a value.

        Args:
            number: index of the value.
            row: row of its run.
            holds: whether the state is reached; None for an inconclusive run, which is treated as a failure.
            monotone: see `next`.
        """
        self.rows[number] = row
        if holds:
            self.holds, self.fails = number, self.fails if monotone else number - 1
            return
        self.fails = number
        if holds is None:
            self.untold.append(number)
        elif monotone:
            # smaller values fail, too
            self.untold = [index for index in self.untold if index > number]

    @property
    def least(self) -> int:
        """Index of the least value that may hold, for every possible outcome of inconclusive runs."""
        return min([self.holds, *self.untold])
