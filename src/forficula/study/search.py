"""Search for the least values with which a structure reaches its states: the runs to do and their evaluation."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from forficula.analysis import SPRUNG, Verdict
from forficula.design import TORQUE, Design
from forficula.quantities import show_quantity
from forficula.study.running.evaluate import row_key
from forficula.study.running.journal import Row
from forficula.study.search_steps import Search, SearchStep
from forficula.study.study_designs import first_design, release_design, second_design

Rows = Mapping[str, Row]

# texts that add the tried values to a status; pages fill in the same fields
SEARCH_TEXTS = {
    "with": "{text} with {value}",
    "used": "{text} ({used})",
    "then": "{text}; with {value}: {next}",
    "failed": "with {value}: {next}",
}
# [chosen] share of the points of a study at which all values are tried to check the assumption of a bracket
_CHECKED = 0.05
_NUMBERS = {"time": "s", "work": "J"}


def search_designs(design: Design, search: Search, rows: Rows) -> dict[str, Design]:
    """Return the designs to run next in order to find the least values, by the keys of their rows.

    The first transition is tried with every value that its row in the table needs: success need not be monotone. Only
    its least successful value is also released. If there is one, the second transition is tried, starting from the
    state that the search's reference value leads to, until its least successful value is known. It is skipped if the
    search has no second transition. Later runs can depend on the rows of earlier ones: call again until no row is
    missing. The designs are listed in the order in which they are tried, see `needed_values`.
    """
    first = _trials(design, search, rows, search.first)
    designs = {row_key(run): run for run in (first_design(design, search, value) for value in first.needed)}
    if any(key not in rows for key in designs):
        return designs
    least, _ = _decided(first.rows, search.first.state)
    if least is None:
        return designs
    if search.next_drive is not None:
        release = release_design(design, search, least)
        designs[row_key(release)] = release
    if search.second is not None:
        needed = _trials(design, search, rows, search.second).needed
        designs |= {row_key(run): run for run in (second_design(design, search, value) for value in needed)}
    return designs


def most_runs(search: Search) -> int:
    """Return the largest number of runs for one point."""
    steps = len(search.first.values) + (0 if search.second is None else len(search.second.values))
    return steps + 1 + 2 * search.refinements


def search_result(design: Design, search: Search, rows: Rows) -> dict[str, Any]:
    """Evaluate the rows of one point: least values (SI), times (s), work and energies (J), and the outcome.

    Times, work and energies of a transition belong to its least successful value; None if no value succeeds.
    `times_tried` and `outcomes_tried` have the times and outcomes of the first transition by value. A value that was
    not tried, because a larger one stayed short of its goal, has no time and the outcome of the larger one, although it
    may fail in another manner; `tried` has the tried values. `monotony` is "assumed" if values were left out, "checked"
    or "violated" if all of them were tried, and "unknown" if the search ended at a value whose result is unknown.
    `residual` is the largest one of the runs that decide the least values.
    """
    first, second = search.first, search.second
    first_trials = _trials(design, search, rows, first)
    tried = first_trials.rows
    least_first, done = _decided(tried, first.state)
    later_trials = None if second is None or least_first is None else _trials(design, search, rows, second)
    if least_first is not None and search.next_drive is not None:
        done = rows[row_key(release_design(design, search, least_first))]
        if not Verdict(done["verdict"]).conclusive:
            least_first, later_trials = None, None
    later = {} if later_trials is None else later_trials.rows
    least_second, next_done = _decided(later, "" if second is None else second.state)
    deciding = [*_deciding(first_trials, None), done]
    if later_trials is not None:
        deciding += _deciding(later_trials, next_done)
    residuals = [row["residual"] for row in deciding if row.get("residual") is not None]
    result = {
        first.result_name: least_first,
        f"{first.transition}_outcome": done["outcome"],
        "reference_outcome": _reference(search, next_done),
        "residual": max(residuals, default=None),
        "times_tried": {value: row.get(f"{first.transition}_time_s") for value, row in tried.items()},
        "outcomes_tried": {
            value: tried[value]["outcome"] if value in tried else first.missed for value in first_trials.values
        },
        "tried": set(tried),
        "monotony": _monotony([first_trials, *([] if later_trials is None else [later_trials])]),
        **_ending(search, done, next_done, _used(search, tried, least_first, later, next_done)),
    }
    if search.start_state:
        result |= _energies(search.start_state, done)
    if second is not None:
        result[second.result_name] = least_second
    if least_first is not None:
        result |= _numbers(first, done)
    if second is not None and least_second is not None:
        result |= _numbers(second, next_done)
    return result


def _numbers(step: SearchStep, row: Row) -> dict[str, Any]:
    """Return time and work of a transition, and the energies of the state that it leads to."""
    numbers = {f"{step.transition}_{name}": row[f"{step.transition}_{name}_{unit}"] for name, unit in _NUMBERS.items()}
    return numbers | _energies(step.state, row)


def _energies(state: str, row: Row) -> dict[str, Any]:
    """Return the energy that the tendons store in a state, and that of each kind of spring."""
    names = ("energy", *(f"{kind}_energy" for kind in SPRUNG))
    return {f"{state}_{name}": row.get(f"{state}_{name}_J") for name in names}


def _decided(tried: Mapping[float, Row], goal: str) -> tuple[float | None, Row]:
    """Return the least value that reaches a goal, and its row; or None and the row that explains the failure.

    Values are examined in their order. If a row without a conclusive verdict comes before the first success, the search
    fails with this row, because a smaller value might succeed. If no value succeeds, the row is that of the last value,
    or an empty row if nothing was tried.
    """
    for value, row in tried.items():
        if _ends(row, goal):
            return value if row.get(goal) else None, row
    return None, list(tried.values())[-1] if tried else {}


def _ends(row: Row, goal: str) -> bool:
    """Return whether a row decides a search from below: it reached the goal, or it is unknown whether it did."""
    return bool(row.get(goal)) or (not Verdict(row["verdict"]).conclusive and row.get(goal) is None)


def _reference(search: Search, row: Row) -> str:
    """Return one word for the outcome of the first transition at the reference value; empty if it was not tried."""
    if not row:
        return ""
    return search.first.done if row[search.first.state] else str(row["outcome"])


def _used(
    search: Search,
    tried: Mapping[float, Row],
    least_first: float | None,
    later: Mapping[float, Row],
    next_done: Row,
) -> tuple[str, str]:
    """Return texts with the values in the status: of the first transition, and of both; empty if not tried."""
    first, second = search.first, search.second
    if first.unit is not TORQUE:  # the value of another key is in the row itself
        return "", ""
    last_of_first = least_first if least_first is not None else next(reversed(list(tried)), None)
    used_first = (
        "" if last_of_first is None else _with_value(first.transition, show_quantity(last_of_first, first.unit))
    )
    if second is None or not later:
        return used_first, ""
    value = next(value for value, row in later.items() if row is next_done)
    large = show_quantity(search.reference, first.unit)
    last_of_second = show_quantity(value, second.unit)
    return used_first, f"{_with_value(first.transition, large)}, {_with_value(second.transition, last_of_second)}"


def _with_value(text: str, value: str) -> str:
    return SEARCH_TEXTS["with"].format(text=text, value=value)


def _ending(search: Search, done: Row, next_done: Row, used: tuple[str, str]) -> dict[str, Any]:
    """Return status, verdict and outcome of a search.

    They are those of the second transition if the first succeeds and the second was tried at the reference value.
    Otherwise they are those of the first transition or its release. The status contains the values.

    Args:
        search: the search.
        done: row of the first transition.
        next_done: row of the second transition; empty if it was not tried.
        used: texts with the values of the first transition, and of both.
    """
    state = search.first.state
    row = done if not (done.get(state) and next_done) else next_done
    ending = {"status": row["status"], "verdict": row["verdict"], "outcome": row["outcome"]}
    large = show_quantity(search.reference, search.first.unit)
    if row is done:
        if next_done:
            ending["status"] = SEARCH_TEXTS["then"].format(text=row["status"], value=large, next=next_done["status"])
        elif used[0] and Verdict(row["verdict"]).conclusive:
            ending["status"] = SEARCH_TEXTS["used"].format(text=row["status"], used=used[0])
    elif next_done[state]:
        if used[1]:
            ending["status"] = SEARCH_TEXTS["used"].format(text=row["status"], used=used[1])
    else:
        ending["status"] = SEARCH_TEXTS["failed"].format(value=large, next=next_done["status"])
        if Verdict(next_done["verdict"]).conclusive:
            ending["outcome"] = _with_value(row["outcome"], large)
    return ending


@dataclass(frozen=True, kw_only=True)
class _Trials:
    """Values of a transition: all of them, those to try, and those that were tried.

    Attributes:
        step: the transition.
        values: rising or falling, with the points that halve the step below the first success, as far as known.
        rows: rows of the tried values, in the order of the values.
        needed: values to try, in the order in which they are tried.
    """

    step: SearchStep
    values: Sequence[float]
    rows: Mapping[float, Row]
    needed: Sequence[float]

    @property
    def violated(self) -> bool:
        """Whether a value did not fail although a larger one stayed short of its goal."""
        rows = list(self.rows.values())
        below = rows[: _last([_stays_short(row, self.step) for row in rows]) + 1]
        return not all(_fails(row, self.step) for row in below)

    @property
    def ends_unknown(self) -> bool:
        """Whether the search ended at a value whose result is unknown, so that larger values were not tried."""
        end = next((value for value, row in self.rows.items() if _ends(row, self.step.state)), None)
        return (
            end is not None
            and not self.rows[end].get(self.step.state)
            and any(value not in self.rows for value in self.values[self.values.index(end) :])
        )

    @property
    def failures(self) -> int:
        """Number of the first values that are taken to fail, because the last of them stayed short of its goal."""
        return 0 if self.violated else _last([self.short(value) for value in self.values]) + 1

    def short(self, value: float) -> bool:
        """Return whether a value was tried and stayed short of its goal."""
        return value in self.rows and _stays_short(self.rows[value], self.step)


def _trials(design: Design, search: Search, rows: Rows, step: SearchStep) -> _Trials:
    """Return the values of a transition as far as the rows show."""
    run = first_design if step is search.first else second_design

    def trials(values: Sequence[float]) -> _Trials:
        every = {value: rows.get(row_key(run(design, search, value))) for value in values}
        known = {value: row for value, row in every.items() if row is not None}
        result = _Trials(step=step, values=values, rows=known, needed=())
        return replace(result, needed=_needed(design, search, result))

    result = trials(step.values)
    for _ in range(search.refinements):
        values, first = list(result.values), result.failures
        while first < len(values) and values[first] in result.rows and not result.rows[values[first]].get(step.state):
            first += 1
        if first in (0, len(values)) or values[first] not in result.rows:
            return result
        result = trials([*values[:first], (values[first - 1] + values[first]) / 2, *values[first:]])
    return result


def _needed(design: Design, search: Search, trials: _Trials) -> list[float]:
    """Return the values of a transition to try, in the order in which they are tried.

    A full scan tries every value of the first transition, because tables contain all of its outcomes, and rising values
    of the second one until one succeeds. A bracket tries falling values of the first transition until one stays short
    of its goal. Of the second transition it tries the largest value, and then halves the interval between the largest
    value that stays short of its goal and the least one that succeeds or has an unknown result, which ends the search.
    It tries all values of a point that is checked, and of one where a value succeeded although a larger one stayed
    short.
    """
    values, rows, first, goal = trials.values, trials.rows, trials.step is search.first, trials.step.state
    success = next((place for place, value in enumerate(values) if rows.get(value, {}).get(goal)), None)
    checked = is_checked(design)
    if search.scan == "full" or checked or trials.violated:
        if first:
            return list(values)
        until = list(values if success is None else values[: success + 1])
        # the largest value shows whether the failure of a larger value would have hidden a success
        return [*until, *(values[-1:] if checked and search.scan == "bracket" else ())]
    # runs pass over the values below one that missed its goal, also if the miss implies nothing for them: they then run
    # in rising order
    if first:
        # tables contain the outcome in words, and below a structure that is stuck on the way it is unknown
        plain = [trials.short(value) and rows[value]["outcome"] == trials.step.missed for value in values]
        left = list(values[max(_last(plain), 0) :])
        passed = any(_fails(rows[value], trials.step) for value in left[any(plain) :] if value in rows)
        return left if passed else left[::-1]
    failures = trials.failures
    end = next((place for place, value in enumerate(values) if value in rows and _ends(rows[value], goal)), len(values))
    between = range(failures, end)
    unknown = [place for place in between if values[place] not in rows]
    if not any(_fails(rows[values[place]], trials.step) for place in between if values[place] in rows):
        largest = [place for place in unknown[-1:] if place == len(values) - 1]
        unknown = [*largest, *_halving(unknown[: len(unknown) - len(largest)])]
    return [*(value for value in values if value in rows), *(values[place] for place in unknown)]


def _halving(places: Sequence[int]) -> list[int]:
    """Return places in an order in which the first one that is not yet decided halves those that are undecided."""
    order, parts = [], deque([places])
    while parts:
        part = parts.popleft()
        if part:
            middle = len(part) // 2
            order.append(part[middle])
            parts += [part[:middle], part[middle + 1 :]]
    return order


def is_checked(design: Design) -> bool:
    """Return whether all values of a point are tried to check that failures are monotone: a share of all points."""
    return int(design.hash[:8], 16) < _CHECKED * 16**8


def _stays_short(row: Row, step: SearchStep) -> bool:
    """Return whether a run rested short of the goal of a transition, so that smaller values are taken to miss it, too.

    A run that met the goal for a moment, or that still moved when its time was over, does not count.
    """
    return row["verdict"] == Verdict.STUCK and _misses(row, step)


def _misses(row: Row, step: SearchStep) -> bool:
    """Return whether a run never met the goal of a transition."""
    return reached_state(row, step.state) is False and row["goal"] == step.transition


def reached_state(row: Row, state: str) -> bool | None:
    """Return whether a run reached the state of the transition that it tries; False if it stayed short of the goal.

    None as for `reached_goal`, which evaluates the record of a run instead of its row.
    """
    if not Verdict(row["verdict"]).conclusive:
        return None
    return True if row.get(state) else False if row.get("short_of_goal") else None


def _fails(row: Row, step: SearchStep) -> bool:
    """Return whether a run failed for certain."""
    return Verdict(row["verdict"]).conclusive and not row.get(step.state)


def _last(flags: Sequence[bool]) -> int:
    """Return the last place of a true value; -1 if there is none."""
    return next((place for place in reversed(range(len(flags))) if flags[place]), -1)


def _deciding(trials: _Trials, last: Row | None) -> list[Row]:
    """Return the rows that decide a least value: from the largest failure below it on, up to a row if it is given."""
    rows = list(trials.rows.values())
    rows = rows[: rows.index(last) + 1] if last in rows else rows
    start = _last([_stays_short(row, trials.step) for row in rows])
    return rows[start if start > 0 and all(_fails(row, trials.step) for row in rows[:start]) else 0 :]


def _monotony(every: Sequence[_Trials]) -> str:
    """Return whether least values assume that all values below one that stays short of its goal fail."""
    if any(trials.violated for trials in every):
        return "violated"
    if any(trials.ends_unknown for trials in every):
        return "unknown"
    left_out = any(value not in trials.rows for trials in every for value in trials.values[: trials.failures])
    return "assumed" if left_out else "checked"
