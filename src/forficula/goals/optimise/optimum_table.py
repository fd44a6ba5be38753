"""Table of all candidates of a search."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from forficula.analysis import Ending, Verdict
from forficula.csv_text import csv_text
from forficula.goals.goal import Goal, own_limits
from forficula.goals.optimise.candidate import Candidate, trial_of, wanted_share
from forficula.goals.optimise.trials import pareto_front
from forficula.goals.outcome_quantity import PROBABILITY
from forficula.goals.parameter import Parameter
from forficula.quantities import as_written, parse_quantity
from forficula.serial import unit_suffix
from forficula.study.running.evaluate import ending_row

if TYPE_CHECKING:
    import xarray

_AXIS = "candidate"
_WORDS = ("status", "verdict", "outcome")


def optimum_table(
    goal: Goal, candidates: Sequence[Candidate], best: Sequence[Candidate], discarded: Sequence[Candidate]
) -> xarray.Dataset:
    """Build the labelled table of all candidates.

    Args:
        goal: the goal.
        candidates: in the order in which they were tried.
        best: those that passed verification.
        discarded: those that failed it.

    Returns:
        One dimension, "candidate". Coordinates are the parameters, in SI with `units`, `display` and `key`. Variables
        are the quantities of the goal; `margin` (the smallest one) and the margins of all limits; `works`, `feasible`,
        `front` and `best`; `probability` with its interval; `status`, `verdict` and `outcome` in words; nan if not
        computed.
    """
    from forficula.study.tables.study_table import StudyTable

    variables = {
        **_quantities(goal, candidates),
        **_margins(goal, candidates),
        **_standing(goal, candidates, best, discarded),
    }
    variables |= _probabilities(candidates)
    words = [_words(item) for item in candidates]
    for word in _WORDS:
        variables[word] = (_AXIS, np.array([str(item[word]) for item in words], dtype=object))
    attributes = {
        "name": goal.name,
        "source": goal.source,
        "design": goal.base.name,
        "design_hash": goal.base.hash,
        "objectives": ", ".join(f"{item.kind} {item.quantity.name}" for item in goal.objectives),
        "limits": ", ".join(str(item) for item in (*goal.torque_limits, *goal.limits)),
    }
    return StudyTable(variables, _coordinates(goal, candidates), attributes)


def _quantities(goal: Goal, candidates: Sequence[Candidate]) -> dict[str, Any]:
    """Return the quantities of limits and objectives, except the probability, which has an interval of its own."""
    columns: dict[str, Any] = {}
    for quantity in goal.quantities:
        if quantity.name != PROBABILITY:
            values = [candidate.value(quantity) for candidate in candidates]
            attributes = {"units": quantity.unit.si, "display": quantity.unit.display, "long_name": quantity.meaning}
            columns[quantity.dimension] = (_AXIS, _numbers(values), attributes)
    return columns


def _margins(goal: Goal, candidates: Sequence[Candidate]) -> dict[str, Any]:
    """Return the smallest margin, those of every limit, and that of the protocol."""
    columns: dict[str, Any] = {
        "margin": (
            _AXIS,
            _numbers([candidate.screened.least for candidate in candidates]),
            {"long_name": "smallest margin"},
        )
    }
    for name, index in _margin_names(goal):
        meaning = f"margin of {own_limits(goal)[index]}"
        columns[name] = (
            _AXIS,
            _numbers([candidate.screened.margins[index] for candidate in candidates]),
            {"long_name": meaning},
        )
    works = _numbers([candidate.screened.works for candidate in candidates])
    columns["margin_works"] = (_AXIS, works, {"long_name": "margin of the protocol's goals"})
    return columns


def _standing(
    goal: Goal, candidates: Sequence[Candidate], best: Sequence[Candidate], discarded: Sequence[Candidate]
) -> dict[str, Any]:
    """Return which candidates work, meet everything, are on the front, and passed verification."""
    trials = [trial_of(goal, candidate) for candidate in candidates]
    # a candidate that was worse before its neighbours were evaluated may have too few working ones
    evaluated = [wanted_share(goal) is None or candidate.neighbours is not None for candidate in candidates]
    failed = {candidate.point for candidate in discarded}
    meets = [
        trial.feasible and is_evaluated and trial.point not in failed
        for trial, is_evaluated in zip(trials, evaluated, strict=True)
    ]
    front, verified = {trial.point for trial in pareto_front(trials)}, {candidate.point for candidate in best}
    return {
        "works": (_AXIS, np.array([candidate.screened.works > 0 for candidate in candidates])),
        "feasible": (_AXIS, np.array(meets)),
        "front": (_AXIS, np.array([trial.point in front for trial in trials])),
        "best": (_AXIS, np.array([trial.point in verified for trial in trials])),
    }


def optimum_csv(table: xarray.Dataset) -> str:
    """Return the table as text: one line per candidate, units in column names, empty cells for missing numbers."""
    columns = {**table.coords, **table.data_vars}
    names = [f"{name}{unit_suffix(column.attrs.get('units', ''))}" for name, column in columns.items()]
    rows = zip(*(column.values.tolist() for column in columns.values()), strict=True)
    return csv_text([names, *([_cell(value) for value in row] for row in rows)])


def _coordinates(goal: Goal, candidates: Sequence[Candidate]) -> dict[str, Any]:
    coordinates: dict[str, Any] = {}
    for parameter in goal.parameters:
        unit = parameter.factor.unit
        attributes = {"key": parameter.key, "long_name": parameter.key.replace(".", " ").replace("_", " ")}
        if unit is not None:
            attributes |= {"units": unit.si, "display": unit.display}
        values = [_value(parameter, candidate.values[parameter.key]) for candidate in candidates]
        coordinates[parameter.factor.dimension] = (_AXIS, values, attributes)
    return coordinates


def _value(parameter: Parameter, value: object) -> object:
    """Return a value in SI, as a number if it has a unit or is one, else as text."""
    unit = parameter.factor.unit
    if unit is None:
        return value if isinstance(value, int | float | str) else as_written(value)
    return value if isinstance(value, float) else parse_quantity(value, unit)


def _margin_names(goal: Goal) -> list[tuple[str, int]]:
    """Return the names of the margins of the goal's own limits, and their indices."""
    names: dict[str, int] = {}
    for index, limit in enumerate(own_limits(goal)):
        name = f"margin_{limit.quantity.dimension}"
        count = sum(
            other == name or (other.startswith(f"{name}_") and other[len(name) + 1 :].isdigit()) for other in names
        )
        names[name if not count else f"{name}_{count + 1}"] = index
    return list(names.items())


def _probabilities(candidates: Sequence[Candidate]) -> dict[str, Any]:
    neighbours = [result.neighbours for result in candidates]
    columns: list[tuple[str, str, list[float | None]]] = [
        (
            PROBABILITY,
            "fraction of neighbours that work",
            [None if result is None else result.share for result in neighbours],
        ),
        (
            f"{PROBABILITY}_low",
            "lower end of its 95 % interval",
            [None if result is None else result.interval[0] for result in neighbours],
        ),
        (
            f"{PROBABILITY}_high",
            "upper end of its 95 % interval",
            [None if result is None else result.interval[1] for result in neighbours],
        ),
        ("neighbours", "neighbours that were evaluated", [result.tried if result else 0 for result in neighbours]),
    ]
    return {name: (_AXIS, _numbers(values), {"long_name": meaning}) for name, meaning, values in columns}


def _words(candidate: Candidate) -> dict[str, object]:
    """Return the ending of a candidate's run, or why there was no run."""
    result = candidate.screened
    if isinstance(result.design, str):
        return ending_row(Ending(verdict=Verdict.NOT_BUILT, why=result.design))
    if "verdict" in result.row:
        return result.row
    if result.ruled_out:
        return {"status": "not run: misses a limit before the run", "verdict": "", "outcome": "not run"}
    return {"status": "not run", "verdict": "", "outcome": "not run"}


def _numbers(values: Sequence[float | None]) -> np.ndarray:
    return np.array([math.nan if value is None else float(value) for value in values])


def _cell(value: object) -> object:
    if isinstance(value, bool):
        return str(value).lower()
    return "" if isinstance(value, float) and math.isnan(value) else value
