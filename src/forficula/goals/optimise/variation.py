"""New points from the best ones so far: differences between them, and levels at random."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from forficula.arrays import Array
from forficula.goals.optimise.axis import Axis, Point, placed
from forficula.goals.optimise.trial import Trial

# Share of a difference that is gone, from and to, share of axes that change, and share of places that are drawn anew.
_STEPS, _CROSSED, _DRAWN = (0.4, 0.9), 0.8, 0.1
# The best of the best from which all others start.
_LEADING = 0.05


def varied(axes: Sequence[Axis], best: Sequence[Trial], count: int, generator: np.random.Generator) -> list[Point]:
    """Points by differential evolution from the best.

    Storn and Price, 1997, doi.org/10.1023/A:1008202821328: their "best/1", of a few that are best.

    Args:
        axes: of the search.
        best: trials, the best first.
        count: how many.
        generator: that draws.
    """
    points = np.array([trial.point for trial in best])
    base, first, second = (points[generator.integers(len(points), size=count)] for _ in range(3))
    leading = max(2, round(_LEADING * len(points)))
    start = points[generator.integers(min(leading, len(points)), size=count)]
    moved = start + generator.uniform(*_STEPS, size=(count, 1)) * (first - second)
    unordered = np.array([not axis.ordered for axis in axes])
    # of a choice there is no difference: it is one or another
    moved[:, unordered] = start[:, unordered]
    crossed = generator.random(moved.shape) < _CROSSED
    crossed[np.arange(count), generator.integers(len(axes), size=count)] = True
    children = np.where(crossed, _reflected(moved), base)
    levelled = np.array([axis.levels > 0 for axis in axes])
    drawn = levelled & (generator.random(children.shape) < _DRAWN)
    return placed(axes, np.where(drawn, generator.random(children.shape), children))


def around(
    axes: Sequence[Axis], base: Sequence[float], radius: float, count: int, generator: np.random.Generator
) -> list[Point]:
    """Points drawn from the box of a radius about a point; they tell parabolas of its surroundings."""
    shift = radius * (2 * generator.random((count, len(axes))) - 1)
    shift[:, [not axis.ordered for axis in axes]] = 0.0
    return placed(axes, _reflected(np.asarray(base) + shift))


def _reflected(shares: Array) -> Array:
    """Shares, folded back at 0 and 1."""
    return np.asarray(1 - np.abs(1 - np.abs(shares) % 2))
