"""What the runs of a sample say of a term: which must be run to know, and then its value."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache

import numpy as np

from forficula.analysis import Verdict
from forficula.arrays import Array, Flags
from forficula.goals.identify.fact import PLACES, LeastValue, Term
from forficula.goals.identify.row_quantity import combined, is_state
from forficula.goals.identify.sample_runs import Rows, SampleRuns, Wanted
from forficula.goals.identify.staircase import FAILS, HOLDS, OPEN, UNTOLD, Ladder, States, follows, next_point
from forficula.study.running.journal import Row

Condition = Mapping[str, object]

# stands for the row of a design that there is not
_NOT_BUILT: Row = {"verdict": Verdict.NOT_BUILT.value}


@dataclass(frozen=True, kw_only=True)
class Observed:
    """The value of a term.

    Attributes:
        value: SI, runs that do not tell taken for such as fail or have no number.
        low: the least that it may be, whatever these would have come to; minus infinity where it may be anything.
        high: the largest, alike.
        untold: how many runs there are that do not tell.
    """

    value: float
    low: float
    high: float
    untold: int


@dataclass(frozen=True, kw_only=True)
class _Numbers:
    """Numbers by condition.

    Attributes:
        values: SI, (conditions,), the absent number where there is none.
        low: the least that each may be, whatever runs that do not tell would have come to, (conditions,).
        high: the largest, alike, (conditions,).
        there: whether there is one, (conditions,).
        untold: how many runs do not tell.
    """

    values: Array
    low: Array
    high: Array
    there: Flags
    untold: int

    @property
    def open(self) -> Flags:
        """Whether each may be another number than its own, (conditions,)."""
        return np.asarray(self.low < self.high)


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
    if term.statistic in PLACES:
        value, low, high = _place(term, places, found)
    else:
        value, low, high = _statistic(term, found)
    return Observed(value=value, low=low, high=high, untold=found.untold)


def conditions(term: Term) -> list[Condition]:
    """The values of every point of a term's grid, the last factor fastest; one without a grid."""
    return list(term.conditions_by_point.values())


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
    return Observed(value=float(holds), low=float(holds), high=float(holds + untold), untold=untold)


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
    by_point = term.conditions_by_point
    known = np.full(term.shape, OPEN, dtype=np.int8)
    while True:
        states, point = _following(known.tobytes(), term.shape, rising, falling)
        if point is None:
            break
        wanted: Wanted = {}
        row = _row(by_point[point], term, runs, rows, wanted)
        if row is None:
            return wanted
        known[point] = _state(term, row)
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


@lru_cache(maxsize=2**16)
def _following(
    known: bytes, shape: tuple[int, ...], rising: tuple[int, ...], falling: tuple[int, ...]
) -> tuple[States, tuple[int, ...] | None]:
    """What follows from what is known, and the next point to run: the same question comes up for many samples."""
    states = follows(np.frombuffer(known, dtype=np.int8).reshape(shape), rising, falling)
    states.setflags(write=False)
    return states, _next(states.tobytes(), shape, rising, falling)


@cache
def _next(
    states: bytes, shape: tuple[int, ...], rising: tuple[int, ...], falling: tuple[int, ...]
) -> tuple[int, ...] | None:
    """The next point to run, which differs less often than what is known."""
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
    values = np.array([term.absent if number is None else number for number in numbers])
    open_ = np.array([row is not None and not _tells(row) for row in found])
    return _Numbers(
        values=values,
        low=np.where(open_, -np.inf, values),
        high=np.where(open_, np.inf, values),
        there=np.array([number is not None for number in numbers]),
        untold=int(open_.sum()),
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
    points, count = conditions(term), len(least.values)
    ladders = [Ladder(holds=count) for _ in points]
    only_best = not term.quantity and term.statistic == "least"
    while True:
        best = min(each.holds for each in ladders)
        asked = {
            place: each.next(count, monotone=least.monotone)
            for place, each in enumerate(ladders)
            if each.holds - each.fails > 1 and not (only_best and each.fails + 1 >= best)
        }
        if not asked:
            break
        wanted: Wanted = {}
        found = {
            place: _row({**points[place], least.key: least.values[index]}, term, runs, rows, wanted)
            for place, index in asked.items()
        }
        if wanted:
            return wanted
        for place, row in found.items():
            assert row is not None
            holds = bool(row.get(least.state)) if _tells(row) else None
            ladders[place].tell(asked[place], row, holds=holds, monotone=least.monotone)
    return _least_numbers(term, least, ladders)


def _least_numbers(term: Term, least: LeastValue, ladders: Sequence[Ladder]) -> _Numbers:
    """The least values, or the numbers of the runs with them, which may be any where another may be the least."""
    assert term.absent is not None
    untold = sum(len(each.untold) for each in ladders)
    holds = np.array([each.holds for each in ladders])
    lows = np.array([each.least for each in ladders])
    if term.quantity:
        numbers = _numbers(term, [each.rows.get(each.holds) for each in ladders])
        open_ = (lows < holds) | numbers.open
        low, high = np.where(open_, -np.inf, numbers.values), np.where(open_, np.inf, numbers.values)
        return _Numbers(values=numbers.values, low=low, high=high, there=numbers.there, untold=untold)
    values = np.append(least.numbers, term.absent)
    return _Numbers(
        values=values[holds], low=values[lows], high=values[holds], there=holds < len(least.values), untold=untold
    )


def _place(term: Term, places: Mapping[str, tuple[object, ...]], found: _Numbers) -> tuple[float, float, float]:
    """By how much the least, or largest, at places is above, or below, that of all; and the ends of what it may be."""
    assert term.absent is not None
    sign = 1.0 if term.statistic == "least at" else -1.0
    allowed = np.array([all(point[key] in values for key, values in places.items()) for point in conditions(term)])
    value = float((sign * found.values)[allowed].min() - (sign * found.values).min())
    low, high = (0.0 if (found.open & allowed).any() else value), (np.inf if (found.open & ~allowed).any() else value)
    if found.there.any():
        return value, low, high
    far = abs(term.absent)
    return far, 0.0 if found.open.any() else far, np.inf if found.open.any() else far


def _statistic(term: Term, found: _Numbers) -> tuple[float, float, float]:
    """The statistic of what has a number, and the least and most that it may be."""
    assert term.absent is not None
    value, low, high = found.values, found.low, found.high
    if term.where is not None:
        may = found.there | found.open
        none = np.array([term.absent])
        value = value[found.there] if found.there.any() else none
        low, high = (each[may] if may.any() else none for each in (low, high))
    match term.statistic:
        case "least":
            return float(value.min()), float(low.min()), float(high.min())
        case "largest":
            return float(value.max()), float(low.max()), float(high.max())
        case _:
            return float(value.mean()), float(low.mean()), float(high.mean())
