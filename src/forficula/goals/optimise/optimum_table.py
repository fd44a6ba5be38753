"""All candidates of a search as a labelled table."""

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
    """Label what became of every candidate.

    Args:
        goal: what was asked.
        candidates: in the order in which they were tried.
        best: those of them that were verified.
        discarded: those that did not hold when they were.

    Returns:
        One dimension, "candidate"; coordinates are the parameters, in SI with `units`, `display` and `key`. Variables
        are the quantities of the goal; `margin`, the least of all, and those of every limit; `works`, `feasible`,
        `front` and `best`; `probability` with its interval; `status`, `verdict` and `outcome` in words; nan where
        something was not asked.
    """
    from forficula.study.tables.study_table import StudyTable

    variables = {
        **_quantities(goal, candidates),
        **_margins(goal, candidates),
        **_standing(goal, candidates, best, discarded),
    }
    variables |= _probabilities(candidates)
    words = [_words(each) for each in candidates]
    for word in _WORDS:
        variables[word] = (_AXIS, np.array([str(each[word]) for each in words], dtype=object))
    attributes = {
        "name": goal.name,
        "source": goal.source,
        "design": goal.base.name,
        "design_hash": goal.base.hash,
        "objectives": ", ".join(f"{each.kind} {each.quantity.name}" for each in goal.objectives),
        "limits": ", ".join(str(each) for each in (*goal.given, *goal.limits)),
    }
    return StudyTable(variables, _coordinates(goal, candidates), attributes)


def _quantities(goal: Goal, candidates: Sequence[Candidate]) -> dict[str, Any]:
    """What limits and objectives are about; the probability has an interval, and stands by itself."""
    found: dict[str, Any] = {}
    for quantity in goal.quantities:
        if quantity.name != PROBABILITY:
            values = [each.value(quantity) for each in candidates]
            attributes = {"units": quantity.unit.si, "display": quantity.unit.display, "long_name": quantity.meaning}
            found[quantity.dimension] = (_AXIS, _numbers(values), attributes)
    return found


def _margins(goal: Goal, candidates: Sequence[Candidate]) -> dict[str, Any]:
    """The least margin of all, those of every limit, and that of what the protocol asks for."""
    found: dict[str, Any] = {
        "margin": (_AXIS, _numbers([each.found.least for each in candidates]), {"long_name": "least margin"})
    }
    for name, place in _margin_names(goal):
        told = f"margin of {own_limits(goal)[place]}"
        found[name] = (_AXIS, _numbers([each.found.margins[place] for each in candidates]), {"long_name": told})
    works = _numbers([each.found.works for each in candidates])
    found["margin_works"] = (_AXIS, works, {"long_name": "margin of what the protocol asks for"})
    return found


def _standing(
    goal: Goal, candidates: Sequence[Candidate], best: Sequence[Candidate], discarded: Sequence[Candidate]
) -> dict[str, Any]:
    """Which candidates work, meet everything, are beaten by none, and were verified."""
    trials = [trial_of(goal, each) for each in candidates]
    # what was beaten before its neighbours were asked may have too few that work
    asked = [wanted_share(goal) is None or each.neighbours is not None for each in candidates]
    lost = {each.point for each in discarded}
    meets = [trial.feasible and told and trial.point not in lost for trial, told in zip(trials, asked, strict=True)]
    front, verified = {trial.point for trial in pareto_front(trials)}, {each.point for each in best}
    return {
        "works": (_AXIS, np.array([each.found.works > 0 for each in candidates])),
        "feasible": (_AXIS, np.array(meets)),
        "front": (_AXIS, np.array([trial.point in front for trial in trials])),
        "best": (_AXIS, np.array([trial.point in verified for trial in trials])),
    }


def optimum_csv(table: xarray.Dataset) -> str:
    """The table as text, one line a candidate, units in the names of the columns, empty where there is no number."""
    columns = {**table.coords, **table.data_vars}
    names = [f"{name}{unit_suffix(column.attrs.get('units', ''))}" for name, column in columns.items()]
    rows = zip(*(column.values.tolist() for column in columns.values()), strict=True)
    return csv_text([names, *([_cell(value) for value in row] for row in rows)])


def _coordinates(goal: Goal, candidates: Sequence[Candidate]) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for each in goal.parameters:
        unit = each.factor.unit
        attributes = {"key": each.key, "long_name": each.key.replace(".", " ").replace("_", " ")}
        if unit is not None:
            attributes |= {"units": unit.si, "display": unit.display}
        values = [_value(each, candidate.values[each.key]) for candidate in candidates]
        found[each.factor.dimension] = (_AXIS, values, attributes)
    return found


def _value(parameter: Parameter, value: object) -> object:
    """A value in SI, as a number, or as text where it has no unit and is none."""
    unit = parameter.factor.unit
    if unit is None:
        return value if isinstance(value, int | float | str) else as_written(value)
    return value if isinstance(value, float) else parse_quantity(value, unit)


def _margin_names(goal: Goal) -> list[tuple[str, int]]:
    """What the margins of the goal's own limits are called, and their places."""
    found: dict[str, int] = {}
    for place, limit in enumerate(own_limits(goal)):
        name = f"margin_{limit.quantity.dimension}"
        again = sum(each == name or (each.startswith(f"{name}_") and each[len(name) + 1 :].isdigit()) for each in found)
        found[name if not again else f"{name}_{again + 1}"] = place
    return list(found.items())


def _probabilities(candidates: Sequence[Candidate]) -> dict[str, Any]:
    asked = [each.neighbours for each in candidates]
    columns: list[tuple[str, str, list[float | None]]] = [
        (PROBABILITY, "share of neighbours that work", [None if each is None else each.share for each in asked]),
        (
            f"{PROBABILITY}_low",
            "lower end of its 95 % interval",
            [None if each is None else each.interval[0] for each in asked],
        ),
        (
            f"{PROBABILITY}_high",
            "upper end of its 95 % interval",
            [None if each is None else each.interval[1] for each in asked],
        ),
        ("neighbours", "neighbours that were asked", [each.tried if each else 0 for each in asked]),
    ]
    return {name: (_AXIS, _numbers(values), {"long_name": meaning}) for name, meaning, values in columns}


def _words(candidate: Candidate) -> dict[str, object]:
    """How the run of a candidate ended, or why there was none."""
    found = candidate.found
    if isinstance(found.design, str):
        return ending_row(Ending(verdict=Verdict.NOT_BUILT, why=found.design))
    if "verdict" in found.row:
        return found.row
    if found.ruled_out:
        return {"status": "not run: misses a limit before", "verdict": "", "outcome": "not run"}
    return {"status": "not run", "verdict": "", "outcome": "not run"}


def _numbers(values: Sequence[float | None]) -> np.ndarray:
    return np.array([math.nan if each is None else float(each) for each in values])


def _cell(value: object) -> object:
    if isinstance(value, bool):
        return str(value).lower()
    return "" if isinstance(value, float) and math.isnan(value) else value
