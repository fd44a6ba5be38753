"""Rows to a labelled table: one entry a point, the failed ones too."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from forficula.analysis import Ending, Verdict, ending_word
from forficula.csv_text import csv_text
from forficula.design import TORQUE, Design
from forficula.quantities import as_written, parse_quantity
from forficula.study.choices import CHOICE, choice_label, own_value
from forficula.study.evaluate import ending_row, row_ending, row_key
from forficula.study.factors import Factor
from forficula.study.journal import Row
from forficula.study.search import fold_design, search_result
from forficula.study.study import Study

if TYPE_CHECKING:
    import xarray

# name: (unit, what it is)
_NUMBERS = {
    "least_fold_torque": ("N m", "least torque that folds"),
    "least_unfold_torque": ("N m", "least torque that opens"),
    "fold_time": ("s", "fold time"),
    "unfold_time": ("s", "opening time"),
    "fold_work": ("J", "work of folding"),
    "unfold_work": ("J", "work of unfolding"),
    "flat_energy": ("J", "energy of the tendons, flat"),
    "folded_energy": ("J", "energy of the tendons, folded"),
    "opened_energy": ("J", "energy of the tendons, opened"),
    "residual": ("", "largest share of the energy that is missing in a run"),
}
_TORQUE = {"units": TORQUE.si, "display": TORQUE.display, "key": "protocol.fold_torque", "long_name": "fold torque"}
# what only opening tells
_OPENING = ("least_unfold_torque", "unfold_time", "unfold_work", "opened_energy", "reference_outcome")
_RUN_NUMBERS = {name: unit for name, unit in _NUMBERS.items() if not name.startswith("least")}
_COLUMNS = (
    *(name for name in _NUMBERS if name not in ("unfold_time", "residual")),
    "status",
    "unfold_time",
    "verdict",
    "residual",
    "folded",
    "opened",
)


def build_table(study: Study, designs: Mapping[int, Design | str], rows: Mapping[str, Row]) -> xarray.Dataset:
    """Label the results of a study.

    Args:
        study: what was asked.
        designs: by number of the point, or why there is none.
        rows: by key, none missing.

    Returns:
        Dimensions are the factors, in the study's order, or "sample" where the points were drawn, or "choice" and the
        grid that is repeated there where factors are varied one at a time, the base first; coordinates in SI with
        `units`, `display` and `key`.
    """
    import xarray

    results = [_result(study, designs[number], rows) for number in range(len(study.points))]
    coordinates, dimensions, shape = table_axes(study)
    numbers = _NUMBERS if study.search is not None else _RUN_NUMBERS
    words: tuple[str, ...] = ("status", "verdict", "outcome")
    if study.search is not None:
        words += ("fold_outcome", "reference_outcome")
    variables: dict[str, Any] = {}
    for name, (unit, meaning) in numbers.items():
        values = np.array([_nan(result.get(name)) for result in results]).reshape(shape)
        variables[name] = (dimensions, values, {"units": unit, "long_name": meaning})
    for name in words:
        texts = np.array([str(result.get(name, result["outcome"])) for result in results], dtype=object).reshape(shape)
        variables[name] = (dimensions, texts)
    if study.search is None:
        for name in ("folded", "opened"):
            variables[name] = (dimensions, np.array([bool(each.get(name)) for each in results]).reshape(shape))
    else:
        variables["reference_outcome"] += ({"torque": study.search.fold_with, "units": "N m"},)
        coordinates["fold_torque"] = ("fold_torque", np.array(study.search.fold_torques), _TORQUE)
        times = [[_nan(each.get("fold_times", {}).get(t)) for t in study.search.fold_torques] for each in results]
        by_torque = np.array(times).reshape(*shape, -1)
        variables["fold_time_by_torque"] = ((*dimensions, "fold_torque"), by_torque, {"units": "s"})
        variables["folded_by_torque"] = ((*dimensions, "fold_torque"), np.isfinite(by_torque))
        became = [
            [each.get("fold_outcomes", {}).get(t, each["outcome"]) for t in study.search.fold_torques]
            for each in results
        ]
        by_torque = np.array(became, dtype=object).reshape(*shape, -1)
        variables["fold_outcome_by_torque"] = ((*dimensions, "fold_torque"), by_torque)
        if not study.search.unfold_torques:
            variables = {name: values for name, values in variables.items() if name not in _OPENING}
    attributes = {
        "name": study.name,
        "source": study.source,
        "design": study.base.name,
        "design_hash": study.base.hash,
        "ask": "run" if study.search is None else "least-torques",
        "veins": study.base.fan.vein_count,
    }
    if study.reproduces is not None:
        attributes["reproduces"] = study.reproduces
    return xarray.Dataset(variables, coordinates, attributes)


def table_csv(study: Study, table: xarray.Dataset) -> str:
    """The table as text, one line a point, units in the names of the columns, empty where there is no number."""
    varied = (*study.factors, *study.grid)
    factors = [_column(factor) for factor in varied]
    names = [name for name in _COLUMNS if name in table]
    units = {name: _suffix(table[name].attrs["units"]) for name in names if table[name].attrs.get("units")}
    rows: list[Sequence[object]] = [
        [*(name for name, _ in factors), *(f"{name}{units.get(name, '')}" for name in names)]
    ]
    columns = [table[name].values.ravel() for name in names]
    silent = [verdict for verdict in Verdict if not verdict.tells]
    told = table["verdict" if "verdict" in table else "outcome"].values
    tells = (~np.isin(told.astype(str).ravel(), silent)).tolist()
    for number, point in enumerate(study.points):
        values = [_point_value(study, factor, point) for factor in varied]
        cells = [
            factor * value if isinstance(value, float) else value
            for value, (_, factor) in zip(values, factors, strict=True)
        ]
        rows.append([*cells, *(_cell(column[number], tells=tells[number]) for column in columns)])
    return csv_text(rows)


def _result(study: Study, design: Design | str, rows: Mapping[str, Row]) -> dict[str, Any]:
    if isinstance(design, str):
        row = ending_row(Ending(verdict=Verdict.NOT_BUILT, why=design))
        return row | {"outcome": ending_word(row_ending(row))}
    if study.search is None:
        row = rows[row_key(design)]
        numbers = {name: row.get(f"{name}_{unit}") for name, (unit, _) in _RUN_NUMBERS.items() if unit}
        return row | numbers | {"outcome": ending_word(row_ending(row))}
    result = search_result(design, study.search, rows)
    tried = {torque: rows[row_key(fold_design(design, torque))] for torque in study.search.fold_torques}
    result["fold_times"] = {torque: row.get("fold_time_s") for torque, row in tried.items()}
    result["fold_outcomes"] = {torque: ending_word(row_ending(row)) for torque, row in tried.items()}
    return result


def table_axes(study: Study) -> tuple[dict[str, Any], tuple[str, ...], tuple[int, ...]]:
    """Coordinates, dimensions and shape of the table."""
    coordinates: dict[str, Any] = {}
    crossed = study.grid if study.choices else () if study.sampled else study.factors
    names, shape = [factor.dimension for factor in crossed], [len(factor.values) for factor in crossed]
    if study.choices:
        names, shape = [CHOICE, *names], [len(study.choices), *shape]
        coordinates[CHOICE] = (CHOICE, [choice_label(study.base, choice) for choice in study.choices])
    elif study.sampled:
        names, shape = ["sample"], [len(study.points)]
    for factor in (*study.factors, *study.grid):
        if factor in crossed:
            dimension, values = factor.dimension, [_factor_value(factor, value) for value in factor.values]
        else:
            dimension, points = names[0], study.choices or study.points
            values = [_point_value(study, factor, point) for point in points]
        unit = factor.unit
        attributes = {"key": factor.key, "long_name": factor.key.replace(".", " ").replace("_", " ")}
        if unit is not None:
            attributes |= {"units": unit.si, "display": unit.display}
        coordinates[factor.dimension] = (dimension, values, attributes)
    return coordinates, tuple(names), tuple(shape)


def _point_value(study: Study, factor: Factor, point: Mapping[str, object]) -> Any:
    """The value of a factor at a point or a choice: the base's where that has none of its own."""
    return _factor_value(factor, point[factor.key] if factor.key in point else own_value(study.base, factor))


def _factor_value(factor: Factor, value: object) -> Any:
    unit = factor.unit
    if unit is None:
        return as_written(value) if isinstance(value, list) else value
    return value if isinstance(value, float) else parse_quantity(value, unit)


def _column(factor: Factor) -> tuple[str, float]:
    """Heading of a factor's column and the factor from SI to it; angles are in degrees, as in all our files."""
    unit = factor.unit
    if unit is None:
        return factor.dimension, 1.0
    if unit.si == "rad":
        return f"{factor.dimension}_deg", 180 / math.pi
    return factor.dimension + _suffix(unit.si), 1.0


def _suffix(unit: str) -> str:
    """Turn "kg/m^3" into "_kg_per_m3"."""
    return "_" + unit.replace("/", "_per_").replace("^", "").replace(" ", "_")


def _nan(value: object) -> float:
    return math.nan if value is None else float(str(value))


def _cell(value: object, *, tells: bool) -> object:
    """A value as text has it; nothing for what there is not, or for yes or no of a run that does not tell."""
    if isinstance(value, bool | np.bool_):
        return str(value).lower() if tells else ""
    return "" if isinstance(value, float) and math.isnan(value) else value
