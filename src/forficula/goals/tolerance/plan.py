"""Numbers of runs of a tolerance analysis, and the points at which it runs designs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from forficula.arrays import Array
from forficula.goals.latin_points import latin_points


@dataclass(frozen=True, kw_only=True)
class Plan:
    """How many runs go into what.

    Attributes:
        points: of the first sample, at which the probability is counted; a power of two, as the next two.
        screened: of these, those from which every factor is changed alone, to see which ones matter.
        rows: of these, those from which indices come, which take a second sample as large; 0 for no indices.
        kept: factors that get indices of their own; all others together get one.
        steps: how far each factor goes alone, in tolerances; empty where none does.
        halvings: of a stretch in which it fails.
        nearest: samples that fail, to which the way is halved.
        cells: on a side of the map of the two factors that decide most; 0 for no map.
    """

    points: int
    screened: int
    rows: int
    kept: int
    steps: tuple[float, ...]
    halvings: int
    nearest: int
    cells: int

    def screens(self, factors: int) -> bool:
        """Whether there are more factors than get indices of their own, by more than one."""
        return self.rows > 0 and factors > self.kept + 1

    def most_runs(self, factors: int) -> int:
        """How many runs it takes at most."""
        runs = 1 + self.points + self.rows
        if self.screens(factors):
            runs += self.screened * factors + self.kept * (self.rows - self.screened) + self.rows
        else:
            runs += self.rows * factors
        ways = 2 * factors if self.steps else 0
        return runs + ways * (len(self.steps) + self.halvings) + self.nearest * (1 + self.halvings) + self.cells**2


# from the most runs to the fewest; the screened points of each are some of its rows, these some of its points
PLANS = (
    Plan(points=256, screened=16, rows=128, kept=8, steps=(1, 2, 4, 8), halvings=4, nearest=8, cells=13),
    Plan(points=256, screened=8, rows=64, kept=8, steps=(1, 2, 4, 8), halvings=3, nearest=8, cells=11),
    Plan(points=128, screened=8, rows=32, kept=6, steps=(1, 2, 4), halvings=3, nearest=4, cells=9),
    Plan(points=128, screened=0, rows=0, kept=0, steps=(1, 3), halvings=3, nearest=4, cells=7),
    Plan(points=64, screened=0, rows=0, kept=0, steps=(1,), halvings=3, nearest=2, cells=0),
    Plan(points=64, screened=0, rows=0, kept=0, steps=(), halvings=0, nearest=0, cells=0),
    Plan(points=32, screened=0, rows=0, kept=0, steps=(), halvings=0, nearest=0, cells=0),
    Plan(points=16, screened=0, rows=0, kept=0, steps=(), halvings=0, nearest=0, cells=0),
)


def plan_within(factors: int, seconds_a_run: float, seconds: float) -> Plan:
    """The plan with the most runs that there is time for, or that with the fewest.

    Args:
        factors: how many.
        seconds_a_run: what a run takes, many side by side, s.
        seconds: how long it may take, s.
    """
    fitting = (plan for plan in PLANS if plan.most_runs(factors) * seconds_a_run <= seconds)
    return next(fitting, PLANS[-1])


def two_samples(factors: int, count: int, seed: int) -> tuple[Array, Array]:
    """Two samples of the unit cube that are independent of one another, row by row.

    They are the halves of one Latin hypercube of twice as many columns. The first rows are the same, however many there
    are.

    Args:
        factors: columns of each.
        count: rows, a power of two, which keeps them balanced.
        seed: of the draw.

    Returns:
        Both, (count, factors), above 0 and below 1.
    """
    drawn = latin_points(2 * factors, count, seed)
    return drawn[:, :factors], drawn[:, factors:]


def exchanged(first: Array, second: Array, columns: Sequence[int]) -> Array:
    """The first sample with some columns of the second.

    Args:
        first: (count, factors).
        second: as the first.
        columns: of one factor, or of a group.

    Returns:
        (count, factors).
    """
    mixed = first.copy()
    mixed[:, list(columns)] = second[:, list(columns)]
    return mixed
