"""Points of a study, enumerated: a point is computed from its index, and no list of all points exists."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import overload

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.design import key_quantity
from forficula.errors import InputError
from forficula.quantities import format_quantity
from forficula.study.factors import MOST_VALUES, Factor

# Number of sampled points that are computed together. [chosen]
_BLOCK = 4096

Point = dict[str, object]


@dataclass(frozen=True)
class GridPoints(Sequence[Point]):
    """Every combination of the factors' values; the last factor varies fastest.

    Attributes:
        factors: factors with values.
    """

    factors: tuple[Factor, ...]

    def __len__(self) -> int:
        """Return the number of points."""
        return math.prod(len(factor.values) for factor in self.factors)

    @overload
    def __getitem__(self, index: int) -> Point: ...
    @overload
    def __getitem__(self, index: slice) -> list[Point]: ...
    def __getitem__(self, index: int | slice) -> Point | list[Point]:
        """Return the point at an index, or the points of a slice."""
        return _selected(index, len(self), self._point)

    def _point(self, number: int) -> Point:
        values: list[object] = []
        for factor in reversed(self.factors):
            number, place = divmod(number, len(factor.values))
            values.append(factor.values[place])
        return dict(zip((factor.key for factor in self.factors), reversed(values), strict=True))

    def si_values(self, numbers: range) -> Array:
        """Return the values of some points, SI, (point, factor); nan for words and other values without a unit."""
        places, columns = np.arange(numbers.start, numbers.stop, numbers.step), list[Array]()
        for factor in reversed(self.factors):
            places, indices = np.divmod(places, len(factor.values))
            columns.append(_si_column(factor)[indices])
        return np.stack(columns[::-1], axis=1)


@dataclass(frozen=True)
class SampledPoints(Sequence[Point]):
    """Points sampled from the distributions of all factors, with values as in a design file.

    A point depends only on its index, the seed and, for "random", on the number of factors. It does not depend on the
    points that were computed before.

    Attributes:
        factors: factors with distributions.
        method: "random", or "sobol" for scrambled Sobol points (Owen 1998), which fill the space more evenly.
        size: number of points.
        seed: seed of the generator; the same seed gives the same points.
    """

    factors: tuple[Factor, ...]
    method: str
    size: int
    seed: int

    def __len__(self) -> int:
        """Return the number of points."""
        return self.size

    @overload
    def __getitem__(self, index: int) -> Point: ...
    @overload
    def __getitem__(self, index: slice) -> list[Point]: ...
    def __getitem__(self, index: int | slice) -> Point | list[Point]:
        """Return the point at an index, or the points of a slice."""
        return _selected(index, self.size, self._point)

    def _point(self, number: int) -> Point:
        block, place = divmod(number, _BLOCK)
        values = _sampled_block(self.factors, self.method, self.seed, block)[place].tolist()
        return {factor.key: _written(factor, value) for factor, value in zip(self.factors, values, strict=True)}

    def si_values(self, numbers: range) -> Array:
        """Return the values of some points, SI, (point, factor), which equal those of their texts bitwise."""
        blocks = range(numbers.start // _BLOCK, numbers[-1] // _BLOCK + 1) if numbers else range(0)
        parts = [np.zeros((0, len(self.factors)))]
        for block in blocks:
            first = max(numbers.start, block * _BLOCK)
            first += -(first - numbers.start) % numbers.step
            last = min(numbers.stop, (block + 1) * _BLOCK)
            if first < last:
                values = _sampled_block(self.factors, self.method, self.seed, block)
                parts.append(values[first - block * _BLOCK : last - block * _BLOCK : numbers.step])
        return np.concatenate(parts)


def grid_points(factors: tuple[Factor, ...], times: int = 1) -> GridPoints:
    """Return every combination of the factors' values; the last factor varies fastest.

    Args:
        factors: factors with values.
        times: number of times that the study repeats this grid.

    Raises:
        InputError: more than a million points in total.
    """
    points = GridPoints(factors)
    if times * len(points) > MOST_VALUES:
        raise InputError(f"factors: need at most {MOST_VALUES} points, got {times * len(points)}")
    return points


def _selected(index: int | slice, count: int, point: Callable[[int], Point]) -> Point | list[Point]:
    """Return the point at an index, which may be negative, or the points of a slice."""
    if isinstance(index, slice):
        return [point(number) for number in range(*index.indices(count))]
    return point(range(count)[index])


@lru_cache(maxsize=8)
def _sampled_block(factors: tuple[Factor, ...], method: str, seed: int, block: int) -> Array:
    """Return the values of a block of sampled points, SI, (point, factor)."""
    first = block * _BLOCK
    if method == "sobol":
        engine = scipy.stats.qmc.Sobol(len(factors), rng=np.random.default_rng(seed))
        if first:
            engine.fast_forward(first)
        probabilities = engine.random(_BLOCK)
    else:
        generator = np.random.PCG64(seed)
        generator.advance(first * len(factors))  # one draw for each number
        probabilities = np.random.Generator(generator).random((_BLOCK, len(factors)))
    columns = [
        factor.distribution.quantiles(column)
        for factor, column in zip(factors, probabilities.T, strict=True)
        if factor.distribution is not None
    ]
    return np.stack(columns, axis=1)


@lru_cache(maxsize=64)
def _si_column_of(key: str, model: type, values: tuple[object, ...]) -> Array:
    quantity = key_quantity(key, model)
    numbers = np.full(len(values), math.nan)
    for place, value in enumerate(values):
        if quantity is not None and value not in quantity.words:
            numbers[place] = quantity.parse(value)
        elif quantity is None and isinstance(value, float):
            numbers[place] = value
    return numbers


def _si_column(factor: Factor) -> Array:
    """Return the values of a factor, SI; nan for words and whole numbers."""
    if any(isinstance(value, list) for value in factor.values):
        return np.full(len(factor.values), math.nan)
    return _si_column_of(factor.key, factor.model, factor.values)


def _written(factor: Factor, value: float) -> object:
    quantity = key_quantity(factor.key, factor.model)
    return value if quantity is None else format_quantity(value, quantity.unit)
