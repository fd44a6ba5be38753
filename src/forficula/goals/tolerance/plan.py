"""Numbers of runs of a tolerance analysis, and the points at which it runs designs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from forficula.arrays import Array
from forficula.goals.latin_points import latin_points


@dataclass(frozen=True, kw_only=True)
class Plan:
    """Numbers of runs for the parts of a tolerance analysis.

    Attributes:
        points: points of the first sample, which gives the probability; a power of two, as the next two.
        screened: number of these points at which every factor alone is changed, to find those that matter.
        rows: number of these points for indices, which need a second sample of the same size; 0 for no indices.
        kept: number of factors with indices of their own; all others together have one.
        steps: deviations of each factor alone, in tolerances; empty to skip this part.
        halvings: number of bisections between success and failure.
        nearest: number of failing samples towards which the nearest failure is searched.
        cells: number of cells per side of the map of the two most important factors; 0 for no map.
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
        """Return whether factors must be screened: there are more than get indices of their own, by at least two."""
        return self.rows > 0 and factors > self.kept + 1

    def most_runs(self, factors: int) -> int:
        """Return the largest number of runs."""
        runs = 1 + self.points + self.rows
        if self.screens(factors):
            runs += self.screened * factors + self.kept * (self.rows - self.screened) + self.rows
        else:
            runs += self.rows * factors
        directions = 2 * factors if self.steps else 0
        return (
            runs + directions * (len(self.steps) + self.halvings) + self.nearest * (1 + self.halvings) + self.cells**2
        )


# from the most runs to the fewest; screened points are some of the rows, which are some of the points
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
    """Return the plan with the most runs for which there is time, or the one with the fewest.

    Args:
        factors: number of factors.
        seconds_a_run: time per run with many runs side by side, s.
        seconds: available time, s.
    """
    fitting = (plan for plan in PLANS if plan.most_runs(factors) * seconds_a_run <= seconds)
    return next(fitting, PLANS[-1])


def two_samples(factors: int, count: int, seed: int) -> tuple[Array, Array]:
    """Draw two samples of the unit cube that are independent of each other, row by row.

    They are the halves of one Latin hypercube with twice as many columns. The first rows do not depend on the count.

    Args:
        factors: number of columns of each sample.
        count: number of rows, a power of two, so that they are balanced.
        seed: seed of the draw.

    Returns:
        Both samples, (count, factors), above 0 and below 1.
    """
    drawn = latin_points(2 * factors, count, seed)
    return drawn[:, :factors], drawn[:, factors:]


def exchanged(first: Array, second: Array, columns: Sequence[int]) -> Array:
    """Return the first sample with some columns of the second.

    Args:
        first: (count, factors).
        second: same shape.
        columns: columns of one factor, or of a group.

    Returns:
        (count, factors).
    """
    mixed = first.copy()
    mixed[:, list(columns)] = second[:, list(columns)]
    return mixed
