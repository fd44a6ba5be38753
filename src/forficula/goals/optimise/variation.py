"""New points from the best ones so far: differences between them, and levels at random."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from forficula.goals.optimise.axis import Axis, Point, placed
from forficula.goals.optimise.trial import Trial

# Share of a difference that is gone, share of axes that change, and share of places that are drawn anew.
_STEP, _CROSSED, _DRAWN = 0.6, 0.8, 0.1
# The best of the best that all others may move towards.
_LEADING = 0.2


def varied(axes: Sequence[Axis], best: Sequence[Trial], count: int, generator: np.random.Generator) -> list[Point]:
    """Points by differential evolution towards the best.

    Zhang and Sanderson, 2009, doi.org/10.1109/TEVC.2009.2014613.

    Args:
        axes: of the search.
        best: trials, the best first.
        count: how many.
        generator: that draws.
    """
    points = np.array([trial.point for trial in best])
    leading = max(2, round(_LEADING * len(points)))
    base, first, second = (points[generator.integers(len(points), size=count)] for _ in range(3))
    towards = points[generator.integers(min(leading, len(points)), size=count)]
    moved = base + _STEP * (towards - base) + _STEP * (first - second)
    unordered = np.array([not axis.ordered for axis in axes])
    # of a choice there is no difference: it is one or another
    moved[:, unordered] = towards[:, unordered]
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


def _reflected(shares: NDArray[np.float64]) -> NDArray[np.float64]:
    """Shares, folded back at 0 and 1."""
    return np.asarray(1 - np.abs(1 - np.abs(shares) % 2))
