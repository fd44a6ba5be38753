"""States over a grid that hold from some boundary on: what follows from the runs so far, and which run tells most."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from forficula.study.running.journal import Row

# of a grid's points
OPEN, FAILS, HOLDS, UNTOLD = -1, 0, 1, 2
States = NDArray[np.int8]


def follows(known: States, axes: Sequence[int], reversed_axes: Sequence[int]) -> States:
    """What is known of every point of a grid where some points are known.

    A state that holds goes on holding along an axis, and one that fails has failed before; what was found at a point
    itself stands above what follows from others, and between others holding stands above failing.

    Args:
        known: OPEN, FAILS, HOLDS or UNTOLD of each point, any shape.
        axes: along which it holds more and more.
        reversed_axes: along which it holds less and less.

    Returns:
        As `known`, with OPEN only where nothing follows.
    """
    up, down = _reach(known == HOLDS, axes, reversed_axes), _reach(known == FAILS, reversed_axes, axes)
    found = np.where(up, HOLDS, np.where(down, FAILS, OPEN))
    return np.asarray(np.where(known == OPEN, found, known), dtype=np.int8)


def next_point(states: States, axes: Sequence[int], reversed_axes: Sequence[int]) -> tuple[int, ...] | None:
    """The open point whose run tells most for certain, the first of equal ones; None where no point is open.

    Whichever way it goes, the state of so many open points follows: the smaller number of both ways counts.
    """
    opened = np.argwhere(states == OPEN)
    best: tuple[int, tuple[int, ...]] | None = None
    for point in map(tuple, opened.tolist()):
        alone = np.zeros(states.shape, dtype=bool)
        alone[point] = True
        told = min(
            int((_reach(alone, *ways) & (states == OPEN)).sum())
            for ways in ((axes, reversed_axes), (reversed_axes, axes))
        )
        if best is None or told > best[0]:
            best = told, point
    return None if best is None else best[1]


def _reach(start: NDArray[np.bool_], axes: Sequence[int], reversed_axes: Sequence[int]) -> NDArray[np.bool_]:
    """The points beyond some, themselves among them: upwards along axes, downwards along reversed ones."""
    reached = start
    for axis in axes:
        reached = np.logical_or.accumulate(reached, axis=axis)
    for axis in reversed_axes:
        reached = np.flip(np.logical_or.accumulate(np.flip(reached, axis), axis=axis), axis)
    return reached


@dataclass(kw_only=True)
class Ladder:
    """Which values of a condition were tried, and from which on the state holds.

    Attributes:
        holds: number of the least value that is known to hold; how many there are where none is.
        fails: number of the largest one below it that does not, or is taken for such; -1 where none is.
        untold: numbers of those that do not tell, and of which nothing else tells.
        rows: of what was tried, by number.
    """

    holds: int
    fails: int = -1
    untold: list[int] = field(default_factory=list)
    rows: dict[int, Row] = field(default_factory=dict)

    def next(self, count: int, *, monotone: bool) -> int:
        """Number of the value to try next: the largest first, which other facts ask for, too; then the middle one.

        Args:
            count: of all values.
            monotone: whether what holds with one value is taken to hold with all larger ones; if not, the next one.
        """
        if not monotone:
            return self.fails + 1
        return count - 1 if self.holds == count else (self.fails + self.holds) // 2

    def tell(self, number: int, row: Row, *, holds: bool | None, monotone: bool) -> None:
        """Take in what a value came to.

        Args:
            number: of the value.
            row: of its run.
            holds: whether the state does; None where the run does not tell, which is taken to fail.
            monotone: as of `next`.
        """
        self.rows[number] = row
        if holds:
            self.holds, self.fails = number, self.fails if monotone else number - 1
            return
        self.fails = number
        if holds is None:
            self.untold.append(number)
        elif monotone:
            # what is smaller fails, too
            self.untold = [each for each in self.untold if each > number]

    @property
    def least(self) -> int:
        """Number of the least value that may hold, whatever those that do not tell would have come to."""
        return min([self.holds, *self.untold])
