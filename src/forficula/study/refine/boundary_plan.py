"""Plan of a study that locates boundaries: the positions that points may have, and what distinguishes regions."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from functools import cached_property
from itertools import accumulate, pairwise
from math import prod

import numpy as np

from forficula.arrays import Array

# indices of a point's values in the values of every axis
Position = tuple[int, ...]

# what distinguishes regions, apart from lists of states
OUTCOME, VERDICT = "outcome", "verdict"


@dataclass(frozen=True, kw_only=True)
class LatticeAxis:
    """Values that a factor may have: those of the initial grid, and equal steps between them.

    Attributes:
        dimension: name of the factor in tables.
        grid: rising values of the initial grid, SI.
        steps: number of steps into which each interval of the grid is divided.
        logarithmic: whether the steps of an interval have equal ratios instead of equal differences.
    """

    dimension: str
    grid: tuple[float, ...]
    steps: tuple[int, ...]
    logarithmic: bool = False

    @cached_property
    def grid_places(self) -> tuple[int, ...]:
        """Indices of the grid's values among all values."""
        return tuple(accumulate(self.steps, initial=0))

    @property
    def size(self) -> int:
        """Number of values."""
        return sum(self.steps) + 1

    @cached_property
    def values(self) -> Array:
        """All values, SI, rising."""
        space = np.geomspace if self.logarithmic else np.linspace
        parts = [
            space(low, high, count + 1)[:-1] for (low, high), count in zip(pairwise(self.grid), self.steps, strict=True)
        ]
        return np.concatenate([*parts, [self.grid[-1]]])

    def places(self, values: Array) -> list[int]:
        """Return the index of the value that is nearest to each of some values."""
        after = np.clip(np.searchsorted(self.values, values), 1, self.size - 1)
        lower = values - self.values[after - 1] < self.values[after] - values
        return [int(place) for place in after - lower]

    def at(self, places: Array) -> Array:
        """Return the values at places that need not be whole numbers."""
        if self.logarithmic:
            return np.asarray(np.exp(np.interp(places, np.arange(self.size), np.log(self.values))))
        return np.asarray(np.interp(places, np.arange(self.size), self.values))


@dataclass(frozen=True, kw_only=True)
class BoundaryPlan:
    """How a study locates the boundaries between regions of different outcomes.

    Attributes:
        axes: values of the factors, in the study's order.
        boundary: what distinguishes regions: "outcome", "verdict", or the names of states that are reached or not.
        probes: number of points inside each cell of the initial grid.
        most_points: number of points at which refinement stops.
    """

    axes: tuple[LatticeAxis, ...]
    boundary: str | tuple[str, ...] = OUTCOME
    probes: int = 1
    most_points: int = 100_000

    @property
    def full_grid(self) -> int:
        """Number of points of the full grid with the same values."""
        return prod(axis.size for axis in self.axes)

    @property
    def initial_grid(self) -> list[Position]:
        """Positions of the initial grid; those of the last axis vary fastest."""
        positions: list[Position] = [()]
        for axis in self.axes:
            positions = [(*position, place) for position in positions for place in axis.grid_places]
        return positions

    def text(self) -> str:
        """Return the plan as text for an attribute of a table."""
        return json.dumps(asdict(self))


def read_plan(text: str) -> BoundaryPlan:
    """Return the plan that `BoundaryPlan.text` wrote."""
    entry = json.loads(text)
    boundary = entry["boundary"]
    return BoundaryPlan(
        axes=tuple(
            LatticeAxis(**{**axis, "grid": tuple(axis["grid"]), "steps": tuple(axis["steps"])})
            for axis in entry["axes"]
        ),
        boundary=boundary if isinstance(boundary, str) else tuple(boundary),
        probes=entry["probes"],
        most_points=entry["most_points"],
    )


def positions_of(plan: BoundaryPlan, columns: Sequence[Array]) -> list[Position]:
    """Return the positions of points from their values, SI, one column for each axis."""
    places = [axis.places(np.asarray(column, dtype=float)) for axis, column in zip(plan.axes, columns, strict=True)]
    return list(zip(*places, strict=True))
