"""Search for the least values with which a structure reaches its states: the runs to do and their evaluation."""

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

# texts that add the tried values to a status; pages fill in the same fields
SEARCH_TEXTS = {
    "with": "{text} with {value}",
    "used": "{text} ({used})",
    "then": "{text}; with {value}: {next}",
    "failed": "with {value}: {next}",
}
_NUMBERS = {"time": "s", "work": "J"}


def search_designs(design: Design, search: Search, rows: Rows) -> dict[str, Design]:
    """Return the designs to run next in order to find the least values, by the keys of their rows.

    The first transition is tried with every value, because success need not be monotone. Only its least successful
    value is also released. If there is one, the second transition is tried in rising order, starting from the state
    that the search's reference value leads to, until a value succeeds. It is skipped if the search has no second
    transition. Later runs can depend on the rows of earlier ones: call again until no row is missing.
    """
    values = _values(design, search, rows, search.first)
    designs = [first_design(design, search, value) for value in values]
    keys = [row_key(first_try) for first_try in designs]
    designs_by_key, results = dict(zip(keys, designs, strict=True)), [rows.get(key) for key in keys]
    if any(row is None for row in results):
        return designs_by_key
    least, _ = _decided({value: row for value, row in zip(values, results, strict=True) if row}, search.first.state)
    if least is None:
        return designs_by_key
    if search.next_drive is not None:
        release = release_design(design, search, least)
        designs_by_key[row_key(release)] = release
    for value in _values(design, search, rows, search.second):
        second = second_design(design, search, value)
        designs_by_key[key := row_key(second)] = second
        if search.second is not None and rows.get(key, {}).get(search.second.state):
            break
    return designs_by_key


def most_runs(search: Search) -> int:
    """Return the largest number of runs for one point."""
    steps = len(search.first.values) + (0 if search.second is None else len(search.second.values))
    return steps + 1 + 2 * search.refinements


def search_result(design: Design, search: Search, rows: Rows) -> dict[str, Any]:
    """Evaluate the rows of one point: least values (SI), times (s), work and energies (J), and the outcome.

    Times, work and energies of a transition belong to its least successful value; None if no value succeeds.
    `times_tried` and `outcomes_tried` have the times and outcomes of the first transition by tried value.
    """
    first, second = search.first, search.second
    tried = {
        value: rows[row_key(first_design(design, search, value))] for value in _values(design, search, rows, first)
    }
    least_first, done = _decided(tried, first.state)
    # the second transition is not tried above its least successful value
    later = {
        value: row
        for value in _values(design, search, rows, second)
        if least_first is not None and (row := rows.get(row_key(second_design(design, search, value)))) is not None
    }
    if least_first is not None and search.next_drive is not None:
        done = rows[row_key(release_design(design, search, least_first))]
        if not Verdict(done["verdict"]).conclusive:
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
        if not Verdict(row["verdict"]).conclusive and row.get(goal) is None:
            return None, row
        if row.get(goal):
            return value, row
    return None, list(tried.values())[-1] if tried else {}


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
    least_second: float | None,
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
    value = least_second if least_second is not None else list(later)[-1]
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


def first_design(design: Design, search: Search, value: float) -> Design:
    """Return the design with a value (SI) of the first transition; its protocol ends before the next drive, if any."""
    stages, first = design.protocol.stages, search.first
    if search.next_drive is not None:
        stages = until_driven(stages, _first_driven(stages, first.drive))
    return _with(design, stages, {first.key: first.sign * value})


def until_driven(stages: Sequence[StageSection], last: int) -> tuple[StageSection, ...]:
    """Return the stages up to a driven one, which takes over the final state of the release after it.

    Args:
        stages: stages of a protocol.
        last: number of the driven stage.
    """
    return (*stages[:last], *(_ending_in(stage, stages[last + 1 :]) for stage in stages[last : last + 1]))


def _ending_in(stage: StageSection, following: Sequence[StageSection]) -> StageSection:
    """Return a driven stage with the state in which the release after it, which is removed, would end."""
    release = next((stage_after for stage_after in following[:1] if not stage_drives(stage_after)), None)
    if stage.state is not None or release is None or release.state is None:
        return stage
    return stage.model_copy(update={"state": release.state})


def release_design(design: Design, search: Search, value: float) -> Design:
    """Return the design with a value (SI) of the first transition, whose protocol ends before the second."""
    stages, first = design.protocol.stages, search.first
    return _with(design, stages[: _first_driven(stages, search.next_drive or "")], {first.key: first.sign * value})


def second_design(design: Design, search: Search, value: float) -> Design:
    """Return the design with the reference value of the first transition and a value (SI) of the second."""
    if search.second is None:
        return design
    first, second = search.first, search.second
    values = {first.key: first.sign * search.reference, second.key: second.sign * value}
    return _with(design, design.protocol.stages, values)


def _first_driven(stages: Sequence[StageSection], drive: str) -> int:
    """Return the number of the first stage that has a drive; the number of stages if none has it."""
    return next((number for number, stage in enumerate(stages) if drive in stage_drives(stage)), len(stages))


def _with(design: Design, stages: Sequence[StageSection], values: Mapping[str, float]) -> Design:
    """Replace stages and values. Strengths of drives were checked when they were read; other values are checked here.

    Other values may change dependent ones: a law determines the stiffness.
    """
    design = put(design, "protocol.stages", tuple(stages))
    for key, value in values.items():
        design = put(design, key, value) if key in drive_keys(design) else with_values(design, {key: value})
    return design


def _values(design: Design, search: Search, rows: Rows, step: SearchStep | None) -> list[float]:
    """Return the values to try: the grid, and points that halve the step below the first success, as far as known."""
    if step is None:
        return []
    tried = list(step.values)
    if not search.refinements:
        return tried
    designs = first_design if step is search.first else second_design
    results = [rows.get(row_key(designs(design, search, value))) for value in tried]
    for _ in range(search.refinements):
        first_success = next((index for index, row in enumerate(results) if row is None or row.get(step.state)), 0)
        if first_success == 0 or results[first_success] is None:
            return tried
        half = (tried[first_success - 1] + tried[first_success]) / 2
        tried.insert(first_success, half)
        results.insert(first_success, rows.get(row_key(designs(design, search, half))))
    return tried


def point_design(base: Design, point: Mapping[str, object], search: Search | None = None) -> Design:
    """Return the design at a point of a study.

    Args:
        base: the design that is varied.
        point: values by key.
        search: the design must also accept the values of this search.

    Raises:
        InputError: the values are not allowed together.
    """
    design = with_values(base, dict(point))
    for step in search.steps if search is not None else ():
        if step.key not in drive_keys(design):
            for value in step.values:
                with_values(design, {step.key: value})
    return design
