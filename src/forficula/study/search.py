"""The least values that bring a structure to its states: which runs find them, and what these say."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from forficula.analysis import SPRUNG, Verdict
from forficula.design import TORQUE, Design, StageSection, put, stage_drives, with_values
from forficula.quantities import show_quantity
from forficula.structure import drive_keys
from forficula.study.running.evaluate import row_key
from forficula.study.running.journal import Row
from forficula.study.search_steps import Search, SearchStep

Rows = Mapping[str, Row]

# how a status names the values that were tried; pages fill in the same fields
SEARCH_TEXTS = {
    "with": "{text} with {value}",
    "used": "{text} ({used})",
    "then": "{text}; with {value}: {next}",
    "failed": "with {value}: {next}",
}
_NUMBERS = {"time": "s", "work": "J"}


def search_designs(design: Design, search: Search, rows: Rows) -> dict[str, Design]:
    """The designs that must run to find the least values, as far as the rows so far tell, by the keys of their rows.

    The first transition is tried with every value, for it need not be monotone, and only the least that does it is also
    released. The second is tried where there is a least value of the first, from where the search's reference value
    left the first, rising, up to the least value that does it; a search that does not ask for it leaves that out. What
    runs next can depend on the last rows: ask again until none is missing.
    """
    values = _values(design, search, rows, search.first)
    tried = [first_design(design, search, value) for value in values]
    keys = [row_key(each) for each in tried]
    wanted, found = dict(zip(keys, tried, strict=True)), [rows.get(key) for key in keys]
    if any(row is None for row in found):
        return wanted
    least, _ = _decided({value: row for value, row in zip(values, found, strict=True) if row}, search.first.state)
    if least is None:
        return wanted
    if search.next_drive is not None:
        release = release_design(design, search, least)
        wanted[row_key(release)] = release
    for value in _values(design, search, rows, search.second):
        second = second_design(design, search, value)
        wanted[key := row_key(second)] = second
        if search.second is not None and rows.get(key, {}).get(search.second.state):
            break
    return wanted


def most_runs(search: Search) -> int:
    """How many runs a point takes at most."""
    steps = len(search.first.values) + (0 if search.second is None else len(search.second.values))
    return steps + 1 + 2 * search.refinements


def search_result(design: Design, search: Search, rows: Rows) -> dict[str, Any]:
    """What the rows say of one point: the least values (SI), times (s), work and energies (J), and its ending.

    Times, work and energies of a transition are those at the least value that does it; None where no value does. By
    value there are times and outcomes of the first transition, `times_tried` and `outcomes_tried`.
    """
    first, second = search.first, search.second
    tried = {
        value: rows[row_key(first_design(design, search, value))] for value in _values(design, search, rows, first)
    }
    least_first, done = _decided(tried, first.state)
    # there are none above the least value that does it
    later = {
        value: row
        for value in _values(design, search, rows, second)
        if least_first is not None and (row := rows.get(row_key(second_design(design, search, value)))) is not None
    }
    if least_first is not None and search.next_drive is not None:
        done = rows[row_key(release_design(design, search, least_first))]
        if not Verdict(done["verdict"]).tells:
            least_first, later = None, {}
    least_second, next_done = _decided(later, "" if second is None else second.state)
    residuals = [row["residual"] for row in (*tried.values(), done, *later.values()) if row.get("residual") is not None]
    result = {
        first.least_name: least_first,
        f"{first.transition}_outcome": done["outcome"],
        "reference_outcome": _reference(search, next_done),
        "residual": max(residuals, default=None),
        "times_tried": {value: row.get(f"{first.transition}_time_s") for value, row in tried.items()},
        "outcomes_tried": {value: row["outcome"] for value, row in tried.items()},
        **_ending(search, done, next_done, _used(search, tried, least_first, later, least_second)),
    }
    if search.start_state:
        result |= _energies(search.start_state, done)
    if second is not None:
        result[second.least_name] = least_second
    if least_first is not None:
        result |= _numbers(first, done)
    if second is not None and least_second is not None:
        result |= _numbers(second, next_done)
    return result


def _numbers(step: SearchStep, row: Row) -> dict[str, Any]:
    """Time and work of a transition, and the energies of the state that it led to."""
    numbers = {f"{step.transition}_{name}": row[f"{step.transition}_{name}_{unit}"] for name, unit in _NUMBERS.items()}
    return numbers | _energies(step.state, row)


def _energies(state: str, row: Row) -> dict[str, Any]:
    """What the tendons store in a state, and each kind of springs."""
    names = ("energy", *(f"{kind}_energy" for kind in SPRUNG))
    return {f"{state}_{name}": row.get(f"{state}_{name}_J") for name in names}


def _decided(found: Mapping[float, Row], goal: str) -> tuple[float | None, Row]:
    """The least value that reaches a goal and its row, or none and the row that says why.

    That is the first one, in the order of the values, that does not say whether it reaches the goal: before what does
    it may hide a value that does. Otherwise it is that of the last value; an empty one where nothing was tried.
    """
    for value, row in found.items():
        if not Verdict(row["verdict"]).tells and row.get(goal) is None:
            return None, row
        if row.get(goal):
            return value, row
    return None, list(found.values())[-1] if found else {}


def _reference(search: Search, row: Row) -> str:
    """What became of the first transition with the reference value, in a word; empty where that was not tried."""
    if not row:
        return ""
    return search.first.done if row[search.first.state] else str(row["outcome"])


def _used(
    search: Search,
    tried: Mapping[float, Row],
    least_first: float | None,
    later: Mapping[float, Row],
    least_second: float | None,
) -> tuple[str, str]:
    """The values that the ending of a search is of: of the first transition, and of both; empty where not tried."""
    first, second = search.first, search.second
    if first.unit is not TORQUE:  # the value of another key is in the row itself
        return "", ""
    last = least_first if least_first is not None else next(reversed(list(tried)), None)
    one = "" if last is None else _with_value(first.transition, show_quantity(last, first.unit))
    if second is None or not later:
        return one, ""
    value = least_second if least_second is not None else list(later)[-1]
    large = show_quantity(search.reference, first.unit)
    last_of_second = show_quantity(value, second.unit)
    return one, f"{_with_value(first.transition, large)}, {_with_value(second.transition, last_of_second)}"


def _with_value(text: str, value: str) -> str:
    return SEARCH_TEXTS["with"].format(text=text, value=value)


def _ending(search: Search, done: Row, next_done: Row, used: tuple[str, str]) -> dict[str, Any]:
    """How the second transition went where some value does the first, or what failed before.

    That is the release of the first one, or the first one with the reference value. The status names the values.

    Args:
        search: what was looked for.
        done: row of the first transition.
        next_done: of the second; empty where that was not tried.
        used: the values of the first transition, and of both, in words.
    """
    state = search.first.state
    told = done if not (done.get(state) and next_done) else next_done
    ending = {"status": told["status"], "verdict": told["verdict"], "outcome": told["outcome"]}
    large = show_quantity(search.reference, search.first.unit)
    if told is done:
        if next_done:
            ending["status"] = SEARCH_TEXTS["then"].format(text=told["status"], value=large, next=next_done["status"])
        elif used[0] and Verdict(told["verdict"]).tells:
            ending["status"] = SEARCH_TEXTS["used"].format(text=told["status"], used=used[0])
    elif next_done[state]:
        if used[1]:
            ending["status"] = SEARCH_TEXTS["used"].format(text=told["status"], used=used[1])
    else:
        ending["status"] = SEARCH_TEXTS["failed"].format(value=large, next=next_done["status"])
        if Verdict(next_done["verdict"]).tells:
            ending["outcome"] = _with_value(told["outcome"], large)
    return ending


def first_design(design: Design, search: Search, value: float) -> Design:
    """The design with a value, SI, of the first transition; where another follows, its protocol ends with the first."""
    stages, first = design.protocol.stages, search.first
    if search.next_drive is not None:
        stages = until_driven(stages, _first_driven(stages, first.drive))
    return _with(design, stages, {first.key: first.sign * value})


def until_driven(stages: Sequence[StageSection], last: int) -> tuple[StageSection, ...]:
    """The stages up to a driven one, which ends in the state that its release was to end in.

    Args:
        stages: of a protocol.
        last: number of the driven stage.
    """
    return (*stages[:last], *(_ending_in(stage, stages[last + 1 :]) for stage in stages[last : last + 1]))


def _ending_in(stage: StageSection, following: Sequence[StageSection]) -> StageSection:
    """A driven stage with the state that the release after it, which is cut off, is to end in."""
    release = next((each for each in following[:1] if not stage_drives(each)), None)
    if stage.state is not None or release is None or release.state is None:
        return stage
    return stage.model_copy(update={"state": release.state})


def release_design(design: Design, search: Search, value: float) -> Design:
    """The design whose protocol ends before any second transition, with a value, SI, of the first."""
    stages, first = design.protocol.stages, search.first
    return _with(design, stages[: _first_driven(stages, search.next_drive or "")], {first.key: first.sign * value})


def second_design(design: Design, search: Search, value: float) -> Design:
    """The design with the reference value of the first transition and a value, SI, of the second."""
    if search.second is None:
        return design
    first, second = search.first, search.second
    values = {first.key: first.sign * search.reference, second.key: second.sign * value}
    return _with(design, design.protocol.stages, values)


def _first_driven(stages: Sequence[StageSection], drive: str) -> int:
    """Number of the first stage with a drive; how many there are where none has it."""
    return next((number for number, stage in enumerate(stages) if drive in stage_drives(stage)), len(stages))


def _with(design: Design, stages: Sequence[StageSection], values: Mapping[str, float]) -> Design:
    """Replace stages and strengths of drives, which were checked when they were read, and whatever else as it is set.

    With another value than a drive's others may follow, as a stiffness follows its law.
    """
    design = put(design, "protocol.stages", tuple(stages))
    for key, value in values.items():
        design = put(design, key, value) if key in drive_keys(design) else with_values(design, {key: value})
    return design


def _values(design: Design, search: Search, rows: Rows, step: SearchStep | None) -> list[float]:
    """Values to try: the grid, and halves of the step before the first that works as far as it is known."""
    if step is None:
        return []
    tried = list(step.values)
    if not search.refinements:
        return tried
    designs = first_design if step is search.first else second_design
    found = [rows.get(row_key(designs(design, search, value))) for value in tried]
    for _ in range(search.refinements):
        least = next((index for index, row in enumerate(found) if row is None or row.get(step.state)), 0)
        if least == 0 or found[least] is None:
            return tried
        half = (tried[least - 1] + tried[least]) / 2
        tried.insert(least, half)
        found.insert(least, rows.get(row_key(designs(design, search, half))))
    return tried


def point_design(base: Design, point: Mapping[str, object], search: Search | None = None) -> Design:
    """The design at a point of a study.

    Args:
        base: that is varied.
        point: values by key.
        search: whose values the design must be able to take, too.

    Raises:
        InputError: the values do not fit together there.
    """
    design = with_values(base, dict(point))
    for step in search.steps if search is not None else ():
        if step.key not in drive_keys(design):
            for value in step.values:
                with_values(design, {step.key: value})
    return design
