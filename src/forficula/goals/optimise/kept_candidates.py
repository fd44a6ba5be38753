"""Candidates of a search that are worth a record, so that they can be played."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from forficula.goals.kept_designs import MOST_KEPT, designs_to_keep
from forficula.goals.optimise.optimum import Optimum
from forficula.study.kept_runs import RunToKeep

Numbers = NDArray[np.int64]


def candidates_to_keep(optimum: Optimum, most: int = MOST_KEPT) -> list[RunToKeep]:
    """The best, the front, and of the others those that meet the goal and those that do not by turns, spread evenly.

    Args:
        optimum: what was found.
        most: runs at most; none where nothing is run.
    """
    if not optimum.goal.simulate:
        return []
    table = optimum.table
    best, front, feasible = (table[name].values.astype(bool) for name in ("best", "front", "feasible"))
    first = [*np.flatnonzero(best), *np.flatnonzero(front & ~best)][:most]
    left = most - len(first)
    ran = table["outcome"].values != "not run"
    others = [_spread(np.flatnonzero(ran & ~best & ~front & kind), left) for kind in (feasible, ~feasible)]
    by_turns = [int(numbers[place]) for place in range(left) for numbers in others[::-1] if place < len(numbers)]
    designs = [each.found.design for each in optimum.candidates]
    return designs_to_keep(designs, [*map(int, first), *by_turns], most)


def _spread(numbers: Numbers, most: int) -> Numbers:
    """So many of some numbers, evenly."""
    if len(numbers) <= most:
        return numbers
    places = np.linspace(0, len(numbers) - 1, max(most, 0)).round().astype(np.int64)
    return np.asarray(numbers[places], dtype=np.int64)
