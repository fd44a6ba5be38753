"""Tables of studies: labelled data with one entry per point, including failed ones."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np

from forficula.analysis import SPRUNG, Ending, Verdict
from forficula.analysis.margin import combined_row_margin, margin_column
from forficula.analysis.package import flat_package
from forficula.analysis.precision import precision_of
from forficula.arrays import Array
from forficula.csv_text import csv_text
from forficula.design import TORQUE, Design
from forficula.quantities import as_written, parse_quantity
from forficula.serial import Written, key_with_unit, unit_suffix
from forficula.structure import Structure, drive_keys, first_state, springs_name, structure_of
from forficula.study.assumptions.choices import CHOICE, choice_label, own_value
from forficula.study.changes import CHANGE
from forficula.study.factors import Factor
from forficula.study.running.evaluate import ending_row, row_key
from forficula.study.running.journal import Row
from forficula.study.search import search_result
from forficula.study.search_steps import Search, SearchStep
from forficula.study.study import Study
from forficula.study.tables.outcome_kinds import transitions_text
from forficula.study.tables.redundancy import CHANGED_VALUES, FIRST, MARGIN, SECOND, omitted_text

if TYPE_CHECKING:
    import xarray


def build_table(study: Study, designs: Mapping[int, Design | str], rows: Mapping[str, Row]) -> xarray.Dataset:
    """Build the labelled table of a study's results.

    Args:
        study: the study.
        designs: designs by index of the point, or the reason why there is none.
        rows: rows by key, none missing.

    Returns:
        Dimensions are the factors, in the study's order; or "sample" if the points were sampled; or "choice" (the base
        first) and the repeated grid if factors are varied one at a time; or "change" (the base first) if the study
        makes named changes. Coordinates are in SI, with `units`, `display` and `key`; those of named changes are texts:
        the names of the changes, and the changed values. Variables are time and work of every transition of the base;
        the energy of the tendons and, if they exist, of the hinges' springs in every state; and the least value of
        every searched transition. The attribute
        `transitions` has the transitions, see `table_transitions`; `whole` is the noun for the structure in sentences.
        A study of named changes that searches nothing also has the margin of every transition and of the whole run.
        If a run was computed in single precision, `precision` has the precision of each run. If a run has an
        automatic timestep and nothing is searched, `timestep` has the timestep of each run. If the
        pattern varies, `folding_ratio` and `folded_height` have the size of the flat-folded sheet.
    """
    from forficula.study.tables.study_table import StudyTable

    structure, search = structure_of(study.base), study.search
    numbers = _numbers(study, structure)
    results = [_result(study, designs[number], rows, numbers) for number in range(len(study.points))]
    coordinates, dimensions, shape = table_axes(study)
    words: tuple[str, ...] = ("status", "verdict", "outcome")
    if search is not None:
        words += (f"{search.first.transition}_outcome", "reference_outcome")
    variables: dict[str, Any] = {}
    for name, (unit, meaning) in numbers.items():
        sprung = name.endswith(tuple(f"_{kind}_energy" for kind in SPRUNG))
        # not every structure has springs
        if sprung and all(result.get(name) is None for result in results):
            continue
        values = np.array([_nan(result.get(name)) for result in results]).reshape(shape)
        variables[name] = (dimensions, values, {"units": unit, "long_name": meaning})
    for name in words:
        texts = np.array([str(result.get(name, result["outcome"])) for result in results], dtype=object).reshape(shape)
        variables[name] = (dimensions, texts)
    if search is None:
        for transition in structure.transitions:
            holds = np.array([bool(result.get(transition.state)) for result in results]).reshape(shape)
            variables[transition.state] = (dimensions, holds)
    else:
        variables |= _by_value(search, results, dimensions, shape)
        coordinates[search.first.value_name] = _tried(search.first)
        if search.second is None:
            del variables["reference_outcome"]
        else:
            variables["reference_outcome"] += ({"torque": search.reference, "units": search.first.unit.si},)
    if any(key.startswith("pattern.") for point in study.points for key in point):
        variables |= _folded_sizes([designs[number] for number in range(len(results))], dimensions, shape)
    automatic = (isinstance(design, Design) and design.protocol.timestep == "auto" for design in designs.values())
    if search is None and any(automatic):
        steps = np.array([_nan(result.get("timestep_s")) for result in results]).reshape(shape)
        variables["timestep"] = (dimensions, steps, {"units": "s", "long_name": "timestep of the run"})
    precisions = [precision_of(design) if isinstance(design, Design) else "" for design in designs.values()]
    if "single" in precisions:
        variables["precision"] = (dimensions, np.array(precisions, dtype=object).reshape(shape))
    attributes = {
        "name": study.name,
        "source": study.source,
        "design": study.base.name,
        "design_hash": study.base.hash,
        "ask": _ask(study),
        "tendons": len(structure.tendons),
        "transitions": transitions_text(structure, search),
        "start_state": first_state(structure, structure.stage_states),
        "whole": structure.appearance.whole,
        **_confirmations(rows),
        **({"reproduces": study.reproduces} if study.reproduces is not None else {}),
        **({"omitted_pairs": omitted_text(study.plan)} if study.plan else {}),
    }
    table = StudyTable(variables, coordinates, attributes)
    table.study = study
    return table


def _folded_sizes(
    designs: Sequence[Design | str], dimensions: tuple[str, ...], shape: tuple[int, ...]
) -> dict[str, Any]:
    """Return the sizes of the flat-folded sheets of designs; none if no sheet folds flat."""
    sizes = [flat_package(structure_of(design)) if isinstance(design, Design) else None for design in designs]
    if not any(sizes):
        return {}
    ratios = np.array([math.nan if size is None else size.folding_ratio for size in sizes]).reshape(shape)
    heights = np.array([math.nan if size is None else size.height for size in sizes]).reshape(shape)
    what = "of the sheet folded flat along all creases"
    return {
        "folding_ratio": (
            dimensions,
            ratios,
            {"units": "", "long_name": f"area of the open sheet / outline area {what}"},
        ),
        "folded_height": (
            dimensions,
            heights,
            {"units": "m", "long_name": f"number of layers {what}, times the thickness"},
        ),
    }


def _confirmations(rows: Mapping[str, Row]) -> dict[str, int]:
    """Return the numbers of runs, of runs repeated at half the timestep, and of changed verdicts."""
    confirmed = [row["confirmed"] for row in rows.values() if row.get("confirmed") is not None]
    return {"runs": len(rows), "runs_repeated": len(confirmed), "runs_undecided": confirmed.count(False)}


def _numbers(study: Study, structure: Structure) -> dict[str, tuple[str, str]]:
    """Return unit and meaning of the numbers of a table, by name."""
    search = study.search
    drives = [step.drive for step in search.steps] if search is not None else []
    studied = [transition for transition in structure.transitions if search is None or transition.drive in drives]
    start = [state for state in [first_state(structure, structure.stage_states)] if state]
    numbers: dict[str, tuple[str, str]] = {}
    for step in search.steps if search is not None else ():
        does = next(transition.wording.does for transition in studied if transition.drive == step.drive)
        what = "torque" if step.unit is TORQUE else step.key
        numbers[step.least_name] = (step.unit.si, f"least {what} with which the structure {does}")
    numbers |= {f"{transition.name}_time": ("s", transition.wording.time) for transition in studied}
    numbers |= {
        f"{transition.name}_work": ("J", f"work of {transition.wording.noun}, even if it failed")
        for transition in studied
    }
    stored = "energy of the tendons" if structure.tendons else "stored energy"
    # a failed transition has the energy of its final state
    ends = {transition.state: f"{transition.state}, or where {transition.wording.noun} ended" for transition in studied}
    for state, where in ({state: state for state in start} | ends).items():
        numbers[f"{state}_energy"] = ("J", f"{stored}, {where}")
        numbers[f"{state}_hinge_energy"] = ("J", f"energy of the hinges' springs, {where}")
        numbers[f"{state}_spring_energy"] = ("J", f"energy of the {springs_name(structure)}, {where}")
        numbers[f"{state}_coupling_energy"] = ("J", f"energy of the couplings, {where}")
    if study.plan and search is None:
        names = [transition.name for transition in structure.transitions]
        numbers |= {margin_column(name): ("", f"margin of {name}, from -1 to 1; negative: failed") for name in names}
        numbers[MARGIN] = ("", "margin of all transitions together")
    numbers["residual"] = ("", "largest share of the energy that is missing in a run")
    return numbers


def _ask(study: Study) -> str:
    if study.search is None:
        return "run"
    return "least-torques" if study.search.first.key in drive_keys(study.base) else "least-value"


def _columns(study: Study, table: xarray.Dataset) -> list[str]:
    """Return the columns of a table as text, in order: numbers, words, and whether each state holds."""
    structure = structure_of(study.base)
    numbers = list(_numbers(study, structure))
    late = [f"{transition.name}_time" for transition in structure.transitions[1:]]
    early = [name for name in numbers if name not in (*late, "residual")]
    holds = [transition.state for transition in structure.transitions]
    folded = ("folding_ratio", "folded_height")
    columns = (*early, *folded, "status", *late, "verdict", "residual", "timestep", "precision", *holds)
    return [name for name in columns if name in table]


def _by_value(
    search: Search, results: Sequence[Mapping[str, Any]], dimensions: tuple[str, ...], shape: tuple[int, ...]
) -> dict[str, Any]:
    """Return the result of the first transition for every value that was tried."""
    first, kind = search.first, "torque" if search.first.unit is TORQUE else "value"
    axes = (*dimensions, first.value_name)
    times = np.array([[_nan(result.get("times_tried", {}).get(value)) for value in first.values] for result in results])
    outcomes = [
        [result.get("outcomes_tried", {}).get(value, result["outcome"]) for value in first.values] for result in results
    ]
    times = times.reshape(*shape, -1)
    return {
        f"{first.transition}_time_by_{kind}": (axes, times, {"units": "s"}),
        f"{first.state}_by_{kind}": (axes, np.isfinite(times)),
        f"{first.transition}_outcome_by_{kind}": (axes, np.array(outcomes, dtype=object).reshape(*shape, -1)),
    }


def _tried(step: SearchStep) -> tuple[str, Array, dict[str, str]]:
    name, unit = step.value_name, step.unit
    meaning = name.replace("_", " ")
    return (
        name,
        np.array(step.values),
        {"units": unit.si, "display": unit.display, "key": step.key, "long_name": meaning},
    )


def table_csv(study: Study, table: xarray.Dataset) -> str:
    """Return the table as text: one line per point, units in column names, empty cells for missing numbers."""
    names, rows = _rows(study, table)
    varied = len(study.factors) + len(study.grid) + len(_texts_of_changes(study))
    return csv_text([names, *([*row[:varied], *map(_cell, row[varied:])] for row in rows)])


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


def table_json(study: Study, table: xarray.Dataset) -> list[dict[str, Any]]:
    """Return the rows of `table_csv` as plain data, with the keys of `TableRow`; None for missing values."""
    names, rows = _rows(study, table)
    return [dict(zip(names, row, strict=True)) for row in rows]


def _rows(study: Study, table: xarray.Dataset) -> tuple[list[str], list[list[Any]]]:
    """Return column names and rows of a table, one per point; None for missing or inconclusive values."""
    varied = (*study.factors, *study.grid)
    factors, texts = [_column(factor) for factor in varied], _texts_of_changes(study)
    names = _columns(study, table)
    units = {name: unit_suffix(table[name].attrs.get("units", "")) for name in names}
    columns = [table[name].values.ravel().tolist() for name in names]
    inconclusive = [verdict for verdict in Verdict if not verdict.conclusive]
    words = table["verdict" if "verdict" in table else "outcome"].values
    conclusive = (~np.isin(words.astype(str).ravel(), inconclusive)).tolist()
    rows: list[list[Any]] = []
    for number, point in enumerate(study.points):
        values = [_point_value(study, factor, point) for factor in varied]
        cells = [
            *(str(table[name].values[number]) for name in texts),
            *(
                factor * value if isinstance(value, float) else value
                for value, (_, factor) in zip(values, factors, strict=True)
            ),
        ]
        rows.append([*cells, *(_known(column[number], conclusive=conclusive[number]) for column in columns)])
    return [*texts, *(name for name, _ in factors), *(name + units[name] for name in names)], rows


def _texts_of_changes(study: Study) -> tuple[str, ...]:
    """Return the names of the columns with the changes; none for a study that varies factors."""
    return (CHANGE, CHANGED_VALUES) if study.plan else ()


def _result(
    study: Study, design: Design | str, rows: Mapping[str, Row], numbers: Mapping[str, tuple[str, str]]
) -> dict[str, Any]:
    """Return the result of a point: numbers in SI by their names in the table, and words."""
    if isinstance(design, str):
        return ending_row(Ending(verdict=Verdict.NOT_BUILT, why=design))
    if study.search is not None:
        return search_result(design, study.search, rows)
    row = rows[row_key(design)]
    if study.plan:
        row = _with_margins(row, study)
    return row | {name: row.get(f"{name}_{unit}") for name, (unit, _) in numbers.items() if unit}


def _with_margins(row: Row, study: Study) -> Row:
    """Return a row with the margin of all transitions; without margins if its verdict is inconclusive."""
    transitions = structure_of(study.base).transitions
    if Verdict(row["verdict"]).conclusive:
        return row | {MARGIN: combined_row_margin(row, transitions)}
    return row | {margin_column(transition.name): None for transition in transitions}


def table_axes(study: Study) -> tuple[dict[str, Any], tuple[str, ...], tuple[int, ...]]:
    """Return coordinates, dimensions and shape of the table."""
    coordinates: dict[str, Any] = {}
    if study.plan:
        return _changes(study), (CHANGE,), (len(study.points),)
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


def _changes(study: Study) -> dict[str, Any]:
    """Return the coordinates of a study of named changes: labels, the names of both changes, and the changed values."""
    names = [study.plan.names(point) for point in range(len(study.points))]
    changed = [choice_label(study.base, point) if point else "" for point in study.points]
    columns = {
        CHANGE: [" + ".join(pair) or study.base.name for pair in names],
        FIRST: [pair[0] if pair else "" for pair in names],
        SECOND: [pair[1] if len(pair) > 1 else "" for pair in names],
        CHANGED_VALUES: changed,
    }
    return {name: (CHANGE, texts) for name, texts in columns.items()}


def _point_value(study: Study, factor: Factor, point: Mapping[str, object]) -> Any:
    """Return the value of a factor at a point or a choice; the base's value if the point has none."""
    return _factor_value(factor, point[factor.key] if factor.key in point else own_value(study.base, factor))


def _factor_value(factor: Factor, value: object) -> Any:
    unit = factor.unit
    if unit is None:
        return as_written(value) if isinstance(value, list) else value
    return value if isinstance(value, float) else parse_quantity(value, unit)


def _column(factor: Factor) -> tuple[str, float]:
    """Return the name of a factor's column and the conversion factor from SI; angles are in degrees."""
    unit = factor.unit
    if unit is None:
        return factor.dimension, 1.0
    if unit.si == "rad":
        return key_with_unit(factor.dimension, unit.si), 180 / math.pi
    return key_with_unit(factor.dimension, unit.si), 1.0


def _nan(value: object) -> float:
    return math.nan if value is None else float(str(value))


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
