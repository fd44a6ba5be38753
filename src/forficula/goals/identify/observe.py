"""What the runs of a sample say of a term: which must be run to know, and then its value."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from forficula.analysis import Verdict
from forficula.goals.identify.fact import PLACES, LeastValue, Term
from forficula.goals.identify.row_quantity import combined, is_state
from forficula.goals.identify.sample_runs import Rows, SampleRuns, Wanted
from forficula.goals.identify.staircase import FAILS, HOLDS, OPEN, UNTOLD, States, follows, next_point
from forficula.study.journal import Row

Condition = Mapping[str, object]

# stands for the row of a design that there is not
_NOT_BUILT: Row = {"verdict": Verdict.NOT_BUILT.value}


@dataclass(frozen=True, kw_only=True)
class Observed:
    """The value of a term.

    Attributes:
        value: SI, runs that do not tell taken for such as fail or have no number.
        other: the same, where these are taken for such as hold a state.
        untold: how many runs there are that do not tell.
    """

    value: float
    other: float
    untold: int


@dataclass(frozen=True, kw_only=True)
class _Numbers:
    """Numbers by condition.

    Attributes:
        values: SI, (conditions,), the absent number where there is none.
        there: whether there is one, (conditions,).
        untold: how many runs do not tell.
    """

    values: NDArray[np.float64]
    there: NDArray[np.bool_]
    untold: int


def observe(term: Term, places: Mapping[str, tuple[object, ...]], runs: SampleRuns, rows: Rows) -> Observed | Wanted:
    """Say what a term comes to, or which designs must run before that is known.

    What is asked for follows from the rows of the runs that were asked for before, and from no others: the value is the
    same whatever else has run.

    Args:
        term: of a fact.
        places: of the fact.
        runs: of a sample.
        rows: by key.
    """
    if is_state(term.quantity) and term.least is None:
        return _count(term, runs, rows)
    found = _with_least(term, term.least, runs, rows) if term.least is not None else _plain(term, runs, rows)
    if isinstance(found, dict):
        return found
    value = _statistic(term, places, found)
    return Observed(value=value, other=value, untold=found.untold)


def conditions(term: Term) -> list[dict[str, object]]:
    """The values of every point of a term's grid, the last factor fastest; one without a grid."""
    keys = [factor.key for factor in term.over]
    points = itertools.product(*(factor.values for factor in term.over))
    return [{**term.settings, **dict(zip(keys, point, strict=True))} for point in points]


def _row(condition: Condition, term: Term, runs: SampleRuns, rows: Rows, wanted: Wanted) -> Row | None:
    """The row of a condition; None where it must run first, and is then wanted."""
    built = runs.at(condition, term.until)
    if built is None:
        return _NOT_BUILT
    if built.key not in rows:
        wanted[built.key] = built
        return None
    return rows[built.key]


def _tells(row: Row) -> bool:
    return Verdict(row["verdict"]).tells


def _count(term: Term, runs: SampleRuns, rows: Rows) -> Observed | Wanted:
    """Under how many conditions a state holds."""
    states = _staircase(term, runs, rows) if term.staircase else _every(term, runs, rows)
    if isinstance(states, dict):
        return states
    holds, untold = int((states == HOLDS).sum()), int((states == UNTOLD).sum())
    return Observed(value=float(holds), other=float(holds + untold), untold=untold)


def _state(term: Term, row: Row) -> int:
    if not _tells(row):
        return UNTOLD
    return HOLDS if combined(term.quantity, row) else FAILS


def _every(term: Term, runs: SampleRuns, rows: Rows) -> States | Wanted:
    """The state under every condition, each of which is run."""
    wanted: Wanted = {}
    found = [_row(condition, term, runs, rows, wanted) for condition in conditions(term)]
    if wanted:
        return wanted
    return np.array([_state(term, row) for row in found if row is not None], dtype=np.int8)


def _staircase(term: Term, runs: SampleRuns, rows: Rows) -> States | Wanted:
    """The state under every condition, of which those along its boundary are run.

    The far corner is run, too, where the state is taken to hold before all others: does it not, there is another
    boundary, and every condition is run.
    """
    keys = [factor.key for factor in term.over]
    rising, falling = (tuple(keys.index(key) for key in each) for each in (term.rising, term.falling))
    by_point = dict(zip(itertools.product(*map(range, term.shape)), conditions(term), strict=True))
    states = np.full(term.shape, OPEN, dtype=np.int8)
    known = states.copy()
    while (point := _next(states.tobytes(), term.shape, rising, falling)) is not None:
        wanted: Wanted = {}
        row = _row(by_point[point], term, runs, rows, wanted)
        if row is None:
            return wanted
        known[point] = _state(term, row)
        states = follows(known, rising, falling)
    if not (states == HOLDS).any():
        return states
    for point in _far_corners(term.shape, rising, falling):
        wanted = {}
        row = _row(by_point[point], term, runs, rows, wanted)
        if row is None:
            return wanted
        if _state(term, row) != HOLDS and (states == HOLDS)[_line(point, rising, falling)].any():
            every = _every(term, runs, rows)
            return every if isinstance(every, dict) else every.reshape(term.shape)
    return states


def _far_corners(shape: tuple[int, ...], rising: tuple[int, ...], falling: tuple[int, ...]) -> list[tuple[int, ...]]:
    """The points that every other one leads to, one for each value of the axes along which nothing is taken to hold."""
    ends = [
        [length - 1] if axis in rising else [0] if axis in falling else list(range(length))
        for axis, length in enumerate(shape)
    ]
    return list(itertools.product(*ends))


def _line(point: tuple[int, ...], rising: tuple[int, ...], falling: tuple[int, ...]) -> tuple[int | slice, ...]:
    """The points that lead to a far corner."""
    return tuple(slice(None) if axis in (*rising, *falling) else place for axis, place in enumerate(point))


@cache
def _next(
    states: bytes, shape: tuple[int, ...], rising: tuple[int, ...], falling: tuple[int, ...]
) -> tuple[int, ...] | None:
    """The next point to run: the same question comes up for many samples."""
    return next_point(np.frombuffer(states, dtype=np.int8).reshape(shape), rising, falling)


def _plain(term: Term, runs: SampleRuns, rows: Rows) -> _Numbers | Wanted:
    """The number under every condition."""
    wanted: Wanted = {}
    found = [_row(condition, term, runs, rows, wanted) for condition in conditions(term)]
    if wanted:
        return wanted
    return _numbers(term, found)


def _numbers(term: Term, found: Sequence[Row | None]) -> _Numbers:
    """The numbers of rows; None stands for a condition without any."""
    assert term.absent is not None
    numbers = [_number(term, row) for row in found]
    return _Numbers(
        values=np.array([term.absent if number is None else number for number in numbers]),
        there=np.array([number is not None for number in numbers]),
        untold=sum(row is not None and not _tells(row) for row in found),
    )


def _number(term: Term, row: Row | None) -> float | None:
    if row is None or not _tells(row) or (term.where is not None and not row.get(term.where)):
        return None
    return combined(term.quantity, row)


def _with_least(term: Term, least: LeastValue, runs: SampleRuns, rows: Rows) -> _Numbers | Wanted:
    """The least value under every condition, or the number of the run with it.

    All conditions go on by one run at a time, so that which ones run does not depend on what is there already. Of the
    least of all least values only those conditions go on that may still have it.
    """
    points, count, untold = conditions(term), len(least.values), 0
    fails, holds = np.full(len(points), -1), np.full(len(points), count)
    rows_at: dict[tuple[int, int], Row] = {}
    only_best = not term.quantity and term.statistic == "least"
    while True:
        under_way = holds - fails > 1
        if only_best:
            under_way &= fails + 1 < holds.min()
        if not under_way.any():
            break
        asked = {int(point): _next_value(int(fails[point]), int(holds[point]), count, least.monotone)
                 for point in np.flatnonzero(under_way)}  # fmt: skip
        wanted: Wanted = {}
        found = {
            point: _row({**points[point], least.key: least.values[index]}, term, runs, rows, wanted)
            for point, index in asked.items()
        }
        if wanted:
            return wanted
        for point, row in found.items():
            assert row is not None
            untold += not _tells(row)
            rows_at[point, asked[point]] = row
            if _tells(row) and row.get(least.state):
                holds[point] = asked[point]
                fails[point] = fails[point] if least.monotone else asked[point] - 1
            else:
                fails[point] = asked[point]
    if term.quantity:
        numbers = _numbers(term, [rows_at.get((point, int(index))) for point, index in enumerate(holds)])
        return _Numbers(values=numbers.values, there=numbers.there, untold=untold)
    assert term.absent is not None
    values = np.append(least.numbers, term.absent)[holds]
    return _Numbers(values=values, there=holds < count, untold=untold)


def _next_value(fails: int, holds: int, count: int, monotone: bool) -> int:
    """Number of the value to try next: the largest first, which other facts ask for, too; then the middle one."""
    if not monotone:
        return fails + 1
    return count - 1 if holds == count else (fails + holds) // 2


def _statistic(term: Term, places: Mapping[str, tuple[object, ...]], found: _Numbers) -> float:
    assert term.absent is not None
    values = found.values
    if term.statistic in PLACES:
        if not found.there.any():
            return abs(term.absent)
        sign = 1.0 if term.statistic == "least at" else -1.0
        allowed = [all(point[key] in values for key, values in places.items()) for point in conditions(term)]
        return float((sign * values)[allowed].min() - (sign * values).min())
    if term.where is not None:
        values = values[found.there] if found.there.any() else np.array([term.absent])
    match term.statistic:
        case "least":
            return float(values.min())
        case "largest":
            return float(values.max())
        case _:
            return float(values.mean())
