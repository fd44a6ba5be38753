"""States over a grid that hold from some boundary on: what follows from the runs so far, and which run tells most."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

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
