"""Results of a study's points, read from rows into one array for each column of a table."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from forficula.analysis import Ending, Verdict
from forficula.analysis.margin import combined_row_margin, margin_column
from forficula.arrays import Array, Flags
from forficula.design import Design
from forficula.structure import structure_of
from forficula.study.running.evaluate import ending_row, row_key
from forficula.study.running.journal import Row
from forficula.study.running.numerical_settings import finds_settings
from forficula.study.running.plan import StudyPlan
from forficula.study.search import search_result
from forficula.study.study import Study
from forficula.study.tables.redundancy import MARGIN

# Number of points whose values are in memory as Python objects at a time. [chosen]
POINTS_TOGETHER = 4096


@dataclass(frozen=True, kw_only=True)
class PointColumns:
    """Results of all points, one array for each column.

    Attributes:
        numbers: numbers in SI by name, nan if missing, (point,).
        known: names of numbers that some point has.
        words: outcomes and texts by name, (point,).
        holds: whether each state holds, by name, (point,); empty for a search.
        timesteps: timestep of each run, s; nan if missing or for a search, (point,).
        automatic: whether a run finds its timestep, or its time constant of contact, and nothing is searched.
        times_tried: for a search, time of the first transition for every value that was tried, s, (point, value).
        outcomes_tried: the outcomes for these values, (point, value).
        tried: whether each of these values was tried, (point, value).
    """

    numbers: Mapping[str, Array]
    known: set[str]
    words: Mapping[str, NDArray[np.object_]]
    holds: Mapping[str, Flags]
    timesteps: Array
    automatic: bool
    times_tried: Array
    outcomes_tried: NDArray[np.object_]
    tried: Flags


def read_columns(
    study: Study,
    designs: Mapping[int, Design | str],
    rows: Mapping[str, Row],
    numbers: Mapping[str, tuple[str, str]],
) -> PointColumns:
    """Read the results of all points, one after another."""
    count, search = len(study.points), study.search
    names: tuple[str, ...] = ("status", "verdict", "outcome")
    if search is not None:
        names += (f"{search.first.transition}_outcome", "reference_outcome")
        names += ("monotony",) * (search.scan == "bracket")
    values_tried = () if search is None else search.first.values
    values = {name: np.full(count, math.nan) for name in numbers}
    words = {name: np.empty(count, dtype=object) for name in names}
    transitions = structure_of(study.base).transitions if search is None else ()
    holds = {transition.state: np.zeros(count, dtype=bool) for transition in transitions}
    timesteps, automatic = np.full(count, math.nan), False
    size = (count, len(values_tried))
    times, outcomes, tried = np.full(size, math.nan), np.empty(size, dtype=object), np.zeros(size, dtype=bool)
    known, texts = set[str](), dict[str, str]()

    def text(word: object) -> str:
        """Return a word; equal words are one object."""
        return texts.setdefault(str(word), str(word))

    for number, (result, is_automatic) in enumerate(_results(study, designs, rows, numbers)):
        for name, column in values.items():
            if (value := result.get(name)) is not None:
                column[number] = value
                known.add(name)
        for name, entries in words.items():
            entries[number] = text(result.get(name, "" if name == "monotony" else result["outcome"]))
        for state, flags in holds.items():
            flags[number] = bool(result.get(state))
        if search is None:
            timesteps[number] = _nan(result.get("timestep_s"))
            automatic |= is_automatic
        for place, value in enumerate(values_tried):
            tried[number, place] = value in result.get("tried", ())
            times[number, place] = _nan(result.get("times_tried", {}).get(value))
            outcomes[number, place] = text(result.get("outcomes_tried", {}).get(value, result["outcome"]))
    return PointColumns(
        numbers=values,
        known=known,
        words=words,
        holds=holds,
        timesteps=timesteps,
        automatic=automatic,
        times_tried=times,
        outcomes_tried=outcomes,
        tried=tried,
    )


def varied_keys(study: Study) -> set[str]:
    """Return the keys that any point of a study changes."""
    keys = {factor.key for factor in (*study.factors, *study.grid)}
    return keys | {key for change in study.plan.changes for key in change.values}


def _results(
    study: Study, designs: Mapping[int, Design | str], rows: Mapping[str, Row], numbers: Mapping[str, tuple[str, str]]
) -> Iterator[tuple[dict[str, Any], bool]]:
    """Yield the result of every point, and whether its design has an automatic timestep.

    A result has numbers in SI by their names in the table, and words.
    """
    keys: Sequence[str | None] = ()
    # a design with a key has the timestep of the base, or a number
    automatic = finds_settings(study.base) and "protocol.timestep" not in varied_keys(study)
    for number in range(len(study.points)):
        if number % POINTS_TOGETHER == 0:
            block = range(number, min(number + POINTS_TOGETHER, len(study.points)))
            keys = designs.keys_without_designs(block) if isinstance(designs, StudyPlan) else [None] * len(block)
        key = keys[number % POINTS_TOGETHER]
        if key is not None and (row := rows.get(key)) is not None:
            yield _of_run(study, row, numbers), automatic
            continue
        design = designs[number]
        if isinstance(design, str):
            yield ending_row(Ending(verdict=Verdict.NOT_BUILT, why=design)), False
        elif study.search is not None:
            yield search_result(design, study.search, rows), False
        else:
            yield _of_run(study, rows[row_key(design)], numbers), finds_settings(design)


def _of_run(study: Study, row: Row, numbers: Mapping[str, tuple[str, str]]) -> dict[str, Any]:
    if study.plan or study.boundaries is not None:
        row = _with_margins(row, study)
    return row | {name: row.get(f"{name}_{unit}") for name, (unit, _) in numbers.items() if unit}


def _with_margins(row: Row, study: Study) -> Row:
    """Return a row with the margin of all transitions; without margins if its verdict is inconclusive."""
    transitions = structure_of(study.base).transitions
    if Verdict(row["verdict"]).conclusive:
        return row | {MARGIN: combined_row_margin(row, transitions)}
    return row | {margin_column(transition.name): None for transition in transitions}


def _nan(value: object) -> float:
    return math.nan if value is None else float(str(value))
