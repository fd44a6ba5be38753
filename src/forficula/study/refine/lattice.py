"""Values that points of a study that locates boundaries may have, as in a design file."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from decimal import Decimal
from itertools import pairwise

from forficula.design import Design, key_quantity, key_value
from forficula.errors import InputError
from forficula.quantities import Unit, as_written, parse_quantity
from forficula.study.factors import Factor
from forficula.study.refine.boundary_plan import LatticeAxis, Position

# [chosen]
DIVISIONS = 10
_MOST_GRID_VALUES = 500
_MOST_VALUES = 100_000
# largest number of steps in an interval that is counted
_MOST_COUNTED = 1_000_000_000
_TEXT = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(\D.*?)\s*", re.S)


def read_axis(
    factor: Factor, base: Design, *, width: object = None, divisions: int = DIVISIONS, logarithmic: bool = False
) -> LatticeAxis:
    """Return the values between those of a factor's initial grid.

    Args:
        factor: factor with a list or a range.
        base: the design that is varied.
        width: text with the largest step between values: a quantity, a number for a key without a unit, or, for
            logarithmic steps, a percentage of the value; None to use `divisions`.
        divisions: number of steps in each interval of the initial grid.
        logarithmic: whether steps have equal ratios.

    Raises:
        InputError: values that are not rising numbers, or a width that is not allowed.
    """
    if factor.distribution is not None:
        raise InputError(
            f"factors.{factor.key}: need a list or a range, whose values are the initial grid of"
            ' method = "refine", got a distribution'
        )
    grid = _numbers(factor)
    if len(grid) < 2 or any(first >= second for first, second in pairwise(grid)):
        raise InputError(
            f'factors.{factor.key}: need at least two rising values for method = "refine",'
            f" got {as_written(list(factor.values))}"
        )
    if len(grid) > _MOST_GRID_VALUES:
        raise InputError(f"factors.{factor.key}: need at most {_MOST_GRID_VALUES} values, got {len(grid)}")
    if logarithmic and grid[0] <= 0:
        raise InputError(f"sampling.logarithmic: needs values > 0, got {as_written(factor.values[0])} for {factor.key}")
    if width is None:
        steps = [divisions] * (len(grid) - 1)
    elif logarithmic:
        step = math.log1p(_share(factor.key, width))
        steps = [_count(math.log(second / first), step) for first, second in pairwise(grid)]
    else:
        step = _step(factor, width)
        steps = [_count(second - first, step) for first, second in pairwise(grid)]
    if sum(steps) >= _MOST_VALUES:
        key = f"width.{factor.key}" if width is not None else "divisions"
        got = f"{sum(steps) + 1:.0f}" if max(steps) < _MOST_COUNTED else f"more than {_MOST_COUNTED}"
        raise InputError(f"sampling.{key}: need at most {_MOST_VALUES} values of {factor.key}, got {got}")
    axis = LatticeAxis(dimension=factor.dimension, grid=grid, steps=tuple(steps), logarithmic=logarithmic)
    if _is_whole(factor, base) and any(round(value) != value for value in axis.values.tolist()):
        raise InputError(f"sampling.width: {factor.key} needs steps between whole numbers; give a width of whole steps")
    return axis


def position_values(factors: Sequence[Factor], axes: Sequence[LatticeAxis], position: Position) -> list[object]:
    """Return the values at a position, as in a design file.

    A value between two values of the initial grid is written in their unit, with the digits that a range with this step
    has. A grid with the width as its step therefore has the same designs.
    """
    return [_value(factor, axis, place) for factor, axis, place in zip(factors, axes, position, strict=True)]


def _value(factor: Factor, axis: LatticeAxis, place: int) -> object:
    places = axis.grid_places
    interval = max(index for index, start in enumerate(places) if start <= place)
    if places[interval] == place:
        return factor.values[interval]
    share = place - places[interval], axis.steps[interval]
    ends = factor.values[interval], factor.values[interval + 1]
    if factor.unit is None:
        low, high = (float(str(end)) for end in ends)
        number = _number_between(low, high, share, logarithmic=axis.logarithmic)
        whole = all(isinstance(end, int) for end in ends)
        return int(number) if whole and number.is_integer() else number
    (low, unit), (high, _) = _in_one_unit(ends, factor.unit)
    return f"{_number_between(low, high, share, logarithmic=axis.logarithmic):.12g} {unit}"


def _number_between(low: float, high: float, share: tuple[int, int], *, logarithmic: bool) -> float:
    """Return a number between two numbers, by decimal arithmetic: three of ten steps from 0 to 1 lead to 0.3."""
    if logarithmic:
        return float(f"{low * (high / low) ** (share[0] / share[1]):.12g}")
    start, end = Decimal(repr(low)), Decimal(repr(high))
    return float(f"{float(start + (end - start) * share[0] / share[1]):.12g}")


def _in_one_unit(texts: Sequence[object], unit: Unit) -> list[tuple[float, str]]:
    """Return the numbers of two quantities in their common unit, or in the display unit if they have none."""
    matches = [_TEXT.fullmatch(text) if isinstance(text, str) else None for text in texts]
    names = {match[2] if match else None for match in matches}
    if len(names) == 1 and None not in names:
        return [(float(match[1]), match[2]) for match in matches if match]
    factor = parse_quantity(f"1 {unit.display}", unit)
    return [(float(f"{_si(text, unit) / factor:.12g}"), unit.display) for text in texts]


def _si(value: object, unit: Unit) -> float:
    return value if isinstance(value, float) else parse_quantity(value, unit)


def _numbers(factor: Factor) -> tuple[float, ...]:
    """Return the values of a factor, SI."""
    unit = factor.unit
    if unit is not None:
        return tuple(_si(value, unit) for value in factor.values)
    if not all(isinstance(value, int | float) and not isinstance(value, bool) for value in factor.values):
        words = [value for value in factor.values if isinstance(value, bool) or not isinstance(value, int | float)]
        raise InputError(
            f'factors.{factor.key}: need numbers for method = "refine", between which points can be placed,'
            f" got {as_written(words[0])}"
        )
    return tuple(float(str(value)) for value in factor.values)


def _is_whole(factor: Factor, base: Design) -> bool:
    """Return whether the values of a factor must be whole numbers."""
    now = key_value(base, factor.key)
    return key_quantity(factor.key, factor.model) is None and isinstance(now, int) and not isinstance(now, bool)


def _count(interval: float, step: float) -> int:
    """Return the least number of equal steps in an interval that do not exceed a step."""
    return max(1, math.ceil(min(interval / step * (1 - 1e-9), _MOST_COUNTED)))


def _step(factor: Factor, width: object) -> float:
    """Read a width in the unit of its factor, SI."""
    unit = factor.unit
    if unit is None:
        if isinstance(width, bool) or not isinstance(width, int | float) or not 0 < width < math.inf:
            raise InputError(f"sampling.width.{factor.key}: need a number > 0, got {as_written(width)}")
        return float(width)
    try:
        step = _si(width, unit)
    except InputError as error:
        raise InputError(f"sampling.width.{factor.key}: {error}") from None
    if step <= 0:
        raise InputError(f"sampling.width.{factor.key}: need > 0, got {as_written(width)}")
    return step


def _share(key: str, width: object) -> float:
    """Read the width of logarithmic steps."""
    match = re.fullmatch(r"\s*(\d+\.?\d*|\.\d+)\s*%\s*", width) if isinstance(width, str) else None
    if match is None or not 0 < float(match[1]) <= 1000:
        raise InputError(
            f'sampling.width.{key}: need a percentage of the value, such as "5 %", because {key} is under'
            f" sampling.logarithmic, got {as_written(width)}"
        )
    return float(match[1]) / 100
