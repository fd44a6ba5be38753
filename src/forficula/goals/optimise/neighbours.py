"""How many designs within the tolerances of one work, asked no longer than it matters."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from forficula.arrays import Array
from forficula.design import Design
from forficula.errors import InputError
from forficula.goals.assessor import Assessor
from forficula.goals.deviation import off_values
from forficula.goals.goal import Goal
from forficula.goals.latin_points import latin_points
from forficula.goals.optimise.screening import screened
from forficula.goals.share_interval import share_interval
from forficula.serial import Written

# Neighbours that are asked first; each time after that twice as many are known.
_FIRST = 8


@dataclass(frozen=True, kw_only=True)
class Neighbours:
    """What became of designs within the tolerances of one.

    Attributes:
        works: how many do all that the goal asks.
        tried: how many were asked.
        wanted: how many there are to ask; more than were, where it was plain that too few would work.
        runs: how many of them had to be simulated.
        looks: out of how many designs this one was chosen for what its neighbours do.
    """

    works: int
    tried: int
    wanted: Annotated[int, Written.NEVER]
    runs: Annotated[int, Written.NEVER]
    looks: Annotated[int, Written.NEVER] = 1

    @property
    def share(self) -> Annotated[float, Written.ALWAYS]:
        """Of those that were asked, the ones that work."""
        return self.works / self.tried

    @property
    def interval(self) -> tuple[float, float]:
        """Of the share, at 95 %."""
        return share_interval(self.works, self.tried, self.looks)

    @property
    def ends(self) -> Annotated[Mapping[str, float], Written.BESIDE]:
        """The ends of the interval by name."""
        return dict(zip(("low", "high"), self.interval, strict=True))


def neighbour_offsets(goal: Goal, count: int, seed: int) -> Array:
    """By how many widths neighbours are off, the same of every design, (count, deviation)."""
    shares = latin_points(len(goal.deviations), 2 ** math.ceil(math.log2(max(count, 1))), seed)[:count]
    columns = [deviation.offsets(column) for deviation, column in zip(goal.deviations, shares.T, strict=True)]
    return np.array(columns).T


def neighbours_of(
    goal: Goal, assess: Assessor, designs: Sequence[Design], offsets: Array, least: float | None
) -> list[Neighbours]:
    """Ask neighbours of designs, ever more of them, until it is plain that a wanted share cannot be reached.

    Args:
        goal: what is asked of each.
        assess: that answers.
        designs: whose neighbours are asked.
        offsets: by how many widths each neighbour is off, (neighbour, deviation).
        least: share that is to work; None to ask all of them.
    """
    count = len(offsets)
    allowed = count if least is None else count - math.ceil(least * count - 1e-9)
    works, runs, tried = [0] * len(designs), [0] * len(designs), [0] * len(designs)
    going, asked = list(range(len(designs))), 0
    while going and asked < count:
        upto = min(count, max(_FIRST, 2 * asked))
        owners = [number for number in going for _ in range(asked, upto)]
        off = [_off(goal, designs[number], offsets[row]) for number in going for row in range(asked, upto)]
        for number, found in zip(owners, screened(goal, assess, off, runs_first=True), strict=True):
            works[number] += found.meets
            runs[number] += goal.simulate and not found.ruled_out
            tried[number] += 1
        going = [number for number in going if tried[number] - works[number] <= allowed]
        asked = upto
    return [
        Neighbours(works=works[number], tried=tried[number], wanted=count, runs=runs[number])
        for number in range(len(designs))
    ]


def _off(goal: Goal, design: Design, offsets: Array) -> Design | str:
    """A design that is off, or why it cannot be built so."""
    try:
        return design.with_values(off_values(design, goal.deviations, [float(each) for each in offsets]))
    except InputError as error:
        return str(error)
