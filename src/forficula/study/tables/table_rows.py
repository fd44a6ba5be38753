"""Rows of a study's table as text and as plain data, one per point."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any

from forficula.analysis import Verdict
from forficula.csv_text import csv_text
from forficula.serial import Written, key_with_unit, unit_suffix
from forficula.structure import structure_of
from forficula.study.changes import CHANGE
from forficula.study.factors import Factor
from forficula.study.study import Study
from forficula.study.tables.point_columns import POINTS_TOGETHER
from forficula.study.tables.redundancy import CHANGED_VALUES
from forficula.study.tables.table import point_value, table_numbers

if TYPE_CHECKING:
    import xarray


def _columns(study: Study, table: xarray.Dataset) -> list[str]:
    """Return the columns of a table as text, in order: numbers, words, and whether each state holds."""
    structure = structure_of(study.base)
    numbers = list(table_numbers(study, structure))
    late = [f"{transition.name}_time" for transition in structure.transitions[1:]]
    early = [name for name in numbers if name not in (*late, "residual")]
    holds = [transition.state for transition in structure.transitions]
    folded = ("folding_ratio", "folded_height")
    columns = (*early, *folded, "status", *late, "verdict", "residual", "timestep", "precision", *holds, "monotony")
    return [name for name in columns if name in table]


def csv_lines(study: Study, table: xarray.Dataset) -> Iterator[str]:
    """Yield the lines of `table_csv`."""
    names, rows = _rows(study, table)
    varied = len(study.factors) + len(study.grid) + len(_texts_of_changes(study))
    yield csv_text([names])
    for row in rows:
        yield csv_text([[*row[:varied], *map(_cell, row[varied:])]])


def table_csv(study: Study, table: xarray.Dataset) -> str:
    """Return the table as text: one line per point, units in column names, empty cells for missing numbers."""
    return "".join(csv_lines(study, table))


@dataclass(frozen=True, kw_only=True)
class TableRow:
    """A point of a study.

    Attributes:
        status: outcome in a few words.
        verdict: verdict of the run.
        others: values of the factors, and numbers and states of the run, by name with unit.
    """

    status: str
    verdict: Verdict
    others: Annotated[Mapping[str, float | str | bool | None], Written.BESIDE]


def json_rows(study: Study, table: xarray.Dataset) -> Iterator[dict[str, Any]]:
    """Yield the rows of `table_csv` as plain data, with the keys of `TableRow`; None for missing values."""
    names, rows = _rows(study, table)
    return (dict(zip(names, row, strict=True)) for row in rows)


def column_types(study: Study, table: xarray.Dataset) -> dict[str, type]:
    """Return the type of each column of `json_rows`: float, int, bool or str; each value may also be None."""
    names, _ = _rows(study, table)
    varied = [factor.dimension for factor in (*study.factors, *study.grid)]
    variables = [*_texts_of_changes(study), *varied, *_columns(study, table)]
    kinds = {"f": float, "i": int, "b": bool}
    return {name: kinds.get(table[variable].dtype.kind, str) for name, variable in zip(names, variables, strict=True)}


def _rows(study: Study, table: xarray.Dataset) -> tuple[list[str], Iterator[list[Any]]]:
    """Return column names and rows of a table, one per point; None for missing or inconclusive values."""
    varied = (*study.factors, *study.grid)
    factors, texts = [_column(factor) for factor in varied], _texts_of_changes(study)
    names = _columns(study, table)
    units = {name: unit_suffix(table[name].attrs.get("units", "")) for name in names}

    def rows() -> Iterator[list[Any]]:
        inconclusive = {str(verdict) for verdict in Verdict if not verdict.conclusive}
        words = table["verdict" if "verdict" in table else "outcome"].values.ravel()
        flat = [table[name].values.ravel() for name in names]
        coordinates = [_values_at_points(study, factor, table) for factor in varied]
        for first in range(0, len(study.points), POINTS_TOGETHER):
            block = slice(first, first + POINTS_TOGETHER)
            columns = [column[block].tolist() for column in flat]
            factor_values = [values(block) for values in coordinates]
            for place, word in enumerate(words[block].tolist()):
                cells = [
                    *(str(table[name].values[first + place]) for name in texts),
                    *(
                        factor * value if isinstance(value, float) else value
                        for value, (_, factor) in zip((column[place] for column in factor_values), factors, strict=True)
                    ),
                ]
                conclusive = str(word) not in inconclusive
                yield [*cells, *(_known(column[place], conclusive=conclusive) for column in columns)]

    return [*texts, *(name for name, _ in factors), *(name + units[name] for name in names)], rows()


def _values_at_points(study: Study, factor: Factor, table: xarray.Dataset) -> Callable[[slice], list[Any]]:
    """Return a function that returns the values of a factor at a slice of the points, in the form of the table."""
    if study.sampled and table[factor.dimension].dtype.kind == "f":
        column = table[factor.dimension].values
        return lambda block: list(column[block].tolist())
    return lambda block: [point_value(study, factor, point) for point in study.points[block]]


def _texts_of_changes(study: Study) -> tuple[str, ...]:
    """Return the names of the columns with the changes; none for a study that varies factors."""
    return (CHANGE, CHANGED_VALUES) if study.plan else ()


def _column(factor: Factor) -> tuple[str, float]:
    """Return the name of a factor's column and the conversion factor from SI; angles are in degrees."""
    unit = factor.unit
    if unit is None:
        return factor.dimension, 1.0
    if unit.si == "rad":
        return key_with_unit(factor.dimension, unit.si), 180 / math.pi
    return key_with_unit(factor.dimension, unit.si), 1.0


def _known(value: object, *, conclusive: bool) -> object:
    """Return a value; None if it is missing, or if it is true or false from an inconclusive run."""
    if isinstance(value, bool) and not conclusive:
        return None
    return None if isinstance(value, float) and math.isnan(value) else value


def _cell(value: object) -> object:
    """Return a value as in CSV text."""
    if isinstance(value, bool):
        return str(value).lower()
    return "" if value is None else value
