"""Value of a term for a sample: the designs that must run, and then the value."""

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

# row of a design that cannot be built
_NOT_BUILT: Row = {"verdict": Verdict.NOT_BUILT.value}


@dataclass(frozen=True, kw_only=True)
class Observed:
    """The value of a term.

    Attributes:
        value: SI; inconclusive runs count as failed or without a number.
        low: smallest value over all possible outcomes of inconclusive runs; minus infinity if unbounded.
        high: largest such value; infinity if unbounded.
        untold: number of inconclusive runs.
    """

    value: float
    low: float
    high: float
    untold: int


@dataclass(frozen=True, kw_only=True)
class _Numbers:
    """Numbers by condition.

    Attributes:
        values: SI, (conditions,); the absent number where there is none.
        low: smallest value over all possible outcomes of inconclusive runs, (conditions,).
        high: largest such value, (conditions,).
        known: whether there is a number, (conditions,).
        untold: number of inconclusive runs.
    """

    values: Array
    low: Array
    high: Array
    known: Flags
    untold: int

    @property
    def open(self) -> Flags:
        """Whether each number is uncertain, (conditions,)."""
        return np.asarray(self.low < self.high)


def observe(term: Term, places: Mapping[str, tuple[object, ...]], runs: SampleRuns, rows: Rows) -> Observed | Wanted:
    """Return the value of a term, or the designs that must run before it is known.

    The requested runs depend only on the rows of earlier requested runs. Therefore the value does not depend on other
    runs.

    Args:
        term: term of a fact.
        places: conditions of the fact, by key.
        runs: runs of a sample.
        rows: rows by key.
    """
    if is_state(term.quantity) and term.least is None:
        return _count(term, runs, rows)
    numbers = _with_least(term, term.least, runs, rows) if term.least is not None else _plain(term, runs, rows)
    if isinstance(numbers, dict):
        return numbers
    if term.statistic in PLACES:
        value, low, high = _place(term, places, numbers)
    else:
        value, low, high = _statistic(term, numbers)
    return Observed(value=value, low=low, high=high, untold=numbers.untold)


def conditions(term: Term) -> list[Condition]:
    """Return the values of every point of a term's grid, the last factor fastest; a single point without a grid."""
    return list(term.conditions_by_point.values())


def _row(condition: Condition, term: Term, runs: SampleRuns, rows: Rows, wanted: Wanted) -> Row | None:
    """Return the row of a condition; None if it must run first, and add it to `wanted`."""
    built = runs.at(condition, term.until)
    if built is None:
        return _NOT_BUILT
    if built.key not in rows:
        wanted[built.key] = built
        return None
    return rows[built.key]


def _is_conclusive(row: Row) -> bool:
    return Verdict(row["verdict"]).conclusive


def _count(term: Term, runs: SampleRuns, rows: Rows) -> Observed | Wanted:
    """Return the number of conditions under which a state is reached."""
    states = _staircase(term, runs, rows) if term.staircase else _every(term, runs, rows)
    if isinstance(states, dict):
        return states
    holds, untold = int((states == HOLDS).sum()), int((states == UNTOLD).sum())
    return Observed(value=float(holds), low=float(holds), high=float(holds + untold), untold=untold)


def _state(term: Term, row: Row) -> int:
    if not _is_conclusive(row):
        return UNTOLD
    return HOLDS if combined(term.quantity, row) else FAILS


def _every(term: Term, runs: SampleRuns, rows: Rows) -> States | Wanted:
    """Return the state under every condition, by running all of them."""
    wanted: Wanted = {}
    found_rows = [_row(condition, term, runs, rows, wanted) for condition in conditions(term)]
    if wanted:
        return wanted
    return np.array([_state(term, row) for row in found_rows if row is not None], dtype=np.int8)


def _staircase(term: Term, runs: SampleRuns, rows: Rows) -> States | Wanted:
    """Return the state under every condition, by running those along its boundary.

    If the state is reached, the far corner is run, too, where it should be reached most surely. If it is not, the
    boundary is not monotone, and every condition is run.
    """
    keys = [factor.key for factor in term.over]
    rising, falling = (
        tuple(keys.index(key) for key in direction_keys) for direction_keys in (term.rising, term.falling)
    )
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
            all_states = _every(term, runs, rows)
            return all_states if isinstance(all_states, dict) else all_states.reshape(term.shape)
    return states


def _far_corners(shape: tuple[int, ...], rising: tuple[int, ...], falling: tuple[int, ...]) -> list[tuple[int, ...]]:
    """Return the far corners of the grid, one for each value of the axes without an assumed direction."""
    ends = [
        [length - 1] if axis in rising else [0] if axis in falling else list(range(length))
        for axis, length in enumerate(shape)
    ]
    return list(itertools.product(*ends))


def _line(point: tuple[int, ...], rising: tuple[int, ...], falling: tuple[int, ...]) -> tuple[int | slice, ...]:
    """Return the points that lead to a far corner."""
    return tuple(slice(None) if axis in (*rising, *falling) else index for axis, index in enumerate(point))


@lru_cache(maxsize=2**16)
def _following(
    known: bytes, shape: tuple[int, ...], rising: tuple[int, ...], falling: tuple[int, ...]
) -> tuple[States, tuple[int, ...] | None]:
    """Return the states that known states imply, and the next point to run. Cached, because many samples share them."""
    states = follows(np.frombuffer(known, dtype=np.int8).reshape(shape), rising, falling)
    states.setflags(write=False)
    return states, _next(states.tobytes(), shape, rising, falling)


@cache
def _next(
    states: bytes, shape: tuple[int, ...], rising: tuple[int, ...], falling: tuple[int, ...]
) -> tuple[int, ...] | None:
    """Return the next point to run. Cached, because many known states imply the same states."""
    return next_point(np.frombuffer(states, dtype=np.int8).reshape(shape), rising, falling)


def _plain(term: Term, runs: SampleRuns, rows: Rows) -> _Numbers | Wanted:
    """Return the number under every condition."""
    wanted: Wanted = {}
    found_rows = [_row(condition, term, runs, rows, wanted) for condition in conditions(term)]
    if wanted:
        return wanted
    return _numbers(term, found_rows)


def _numbers(term: Term, found_rows: Sequence[Row | None]) -> _Numbers:
    """Return the numbers of rows; None is a condition without a row."""
    assert term.absent is not None
    numbers = [_number(term, row) for row in found_rows]
    values = np.array([term.absent if number is None else number for number in numbers])
    open_ = np.array([row is not None and not _is_conclusive(row) for row in found_rows])
    return _Numbers(
        values=values,
        low=np.where(open_, -np.inf, values),
        high=np.where(open_, np.inf, values),
        known=np.array([number is not None for number in numbers]),
        untold=int(open_.sum()),
    )


def _number(term: Term, row: Row | None) -> float | None:
    if row is None or not _is_conclusive(row) or (term.where is not None and not row.get(term.where)):
        return None
    return combined(term.quantity, row)


def _with_least(term: Term, least: LeastValue, runs: SampleRuns, rows: Rows) -> _Numbers | Wanted:
    """Return the least value under every condition, or the number of the run with it.

    All conditions advance by one run at a time, so that the requested runs do not depend on existing rows. If only the
    smallest of all least values is needed, only conditions that may still have it advance.
    """
    points, count = conditions(term), len(least.values)
    ladders = [Ladder(holds=count) for _ in points]
    only_best = not term.quantity and term.statistic == "least"
    while True:
        best = min(ladder.holds for ladder in ladders)
        requested = {
            position: ladder.next(count, monotone=least.monotone)
            for position, ladder in enumerate(ladders)
            if ladder.holds - ladder.fails > 1 and not (only_best and ladder.fails + 1 >= best)
        }
        if not requested:
            break
        wanted: Wanted = {}
        found_rows = {
            position: _row({**points[position], least.key: least.values[index]}, term, runs, rows, wanted)
            for position, index in requested.items()
        }
        if wanted:
            return wanted
        for position, row in found_rows.items():
            assert row is not None
            holds = bool(row.get(least.state)) if _is_conclusive(row) else None
            ladders[position].tell(requested[position], row, holds=holds, monotone=least.monotone)
    return _least_numbers(term, least, ladders)


def _least_numbers(term: Term, least: LeastValue, ladders: Sequence[Ladder]) -> _Numbers:
    """Return the least values, or the numbers of the runs with them, and their bounds."""
    assert term.absent is not None
    untold = sum(len(ladder.untold) for ladder in ladders)
    holds = np.array([ladder.holds for ladder in ladders])
    lows = np.array([ladder.least for ladder in ladders])
    if term.quantity:
        numbers = _numbers(term, [ladder.rows.get(ladder.holds) for ladder in ladders])
        open_ = (lows < holds) | numbers.open
        low, high = np.where(open_, -np.inf, numbers.values), np.where(open_, np.inf, numbers.values)
        return _Numbers(values=numbers.values, low=low, high=high, known=numbers.known, untold=untold)
    values = np.append(least.numbers, term.absent)
    return _Numbers(
        values=values[holds], low=values[lows], high=values[holds], known=holds < len(least.values), untold=untold
    )


def _place(term: Term, places: Mapping[str, tuple[object, ...]], numbers: _Numbers) -> tuple[float, float, float]:
    """Return by how much the extreme number at the required positions deviates from that of all, with its bounds."""
    assert term.absent is not None
    sign = 1.0 if term.statistic == "least at" else -1.0
    allowed = np.array([all(point[key] in values for key, values in places.items()) for point in conditions(term)])
    value = float((sign * numbers.values)[allowed].min() - (sign * numbers.values).min())
    low, high = (
        (0.0 if (numbers.open & allowed).any() else value),
        (np.inf if (numbers.open & ~allowed).any() else value),
    )
    if numbers.known.any():
        return value, low, high
    far = abs(term.absent)
    return far, 0.0 if numbers.open.any() else far, np.inf if numbers.open.any() else far


def _statistic(term: Term, numbers: _Numbers) -> tuple[float, float, float]:
    """Return the statistic of existing numbers, and its bounds."""
    assert term.absent is not None
    value, low, high = numbers.values, numbers.low, numbers.high
    if term.where is not None:
        may = numbers.known | numbers.open
        none = np.array([term.absent])
        value = value[numbers.known] if numbers.known.any() else none
        low, high = (ends[may] if may.any() else none for ends in (low, high))
    match term.statistic:
        case "least":
            return float(value.min()), float(low.min()), float(high.min())
        case "largest":
            return float(value.max()), float(low.max()), float(high.max())
        case _:
            return float(value.mean()), float(low.mean()), float(high.mean())
