"""Tables of studies: labelled data with one entry per point, including failed ones."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from forficula.analysis import SPRUNG
from forficula.analysis.margin import margin_column
from forficula.analysis.package import flat_package
from forficula.analysis.precision import precision_of
from forficula.arrays import Array
from forficula.design import TORQUE, Design
from forficula.quantities import as_written, parse_quantity
from forficula.structure import Structure, drive_keys, first_state, springs_name, structure_of
from forficula.study.assumptions.choices import CHOICE, choice_label, own_value
from forficula.study.changes import CHANGE
from forficula.study.factors import Factor
from forficula.study.points import SampledPoints
from forficula.study.running.journal import Row
from forficula.study.search_steps import Search, SearchStep
from forficula.study.study import Study
from forficula.study.tables.outcome_kinds import transitions_text
from forficula.study.tables.point_columns import POINTS_TOGETHER, PointColumns, read_columns, varied_keys
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
        A study of named changes or of boundaries that searches nothing also has the margin of every transition and of
        the whole run. The attribute `boundaries` has the plan of a study of boundaries, and `point_runs` the number
        of runs that its points need.
        A search that takes smaller torques to fail where a larger one does (`Search.scan`) also has `monotony`, and
        which torques of the first transition were tried, see `search_result`.
        If a run was computed in single precision, `precision` has the precision of each run. If a run has an
        automatic timestep and nothing is searched, `timestep` has the timestep of each run. If the
        pattern varies, `folding_ratio` and `folded_height` have the size of the flat-folded sheet.
    """
    from forficula.study.tables.study_table import StudyTable

    structure, search = structure_of(study.base), study.search
    numbers = table_numbers(study, structure)
    columns = read_columns(study, designs, rows, numbers)
    coordinates, dimensions, shape = table_axes(study)
    variables: dict[str, Any] = {}
    for name, (unit, meaning) in numbers.items():
        sprung = name.endswith(tuple(f"_{kind}_energy" for kind in SPRUNG))
        # not every structure has springs
        if sprung and name not in columns.known:
            continue
        values = columns.numbers[name].reshape(shape)
        variables[name] = (dimensions, values, {"units": unit, "long_name": meaning})
    for name, texts in columns.words.items():
        variables[name] = (dimensions, texts.reshape(shape))
    if search is None:
        for state, holds in columns.holds.items():
            variables[state] = (dimensions, holds.reshape(shape))
    else:
        variables |= _by_value(search, columns, dimensions, shape)
        coordinates[search.first.value_name] = _tried(search.first)
        if search.second is None:
            del variables["reference_outcome"]
        else:
            variables["reference_outcome"] += ({"torque": search.reference, "units": search.first.unit.si},)
    if any(key.startswith("pattern.") for key in varied_keys(study)):
        variables |= _folded_sizes(designs, dimensions, shape)
    if columns.automatic:
        steps = columns.timesteps.reshape(shape)
        variables["timestep"] = (dimensions, steps, {"units": "s", "long_name": "timestep of the run"})
    if study.base.protocol.device is not None or "protocol.device" in varied_keys(study):
        every = (designs[number] for number in range(len(study.points)))
        precisions = [precision_of(design) if isinstance(design, Design) else "" for design in every]
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
        **({"boundaries": study.boundaries.text()} if study.boundaries is not None else {}),
    }
    table = StudyTable(variables, coordinates, attributes)
    table.study = study
    return table


def _folded_sizes(
    designs: Mapping[int, Design | str], dimensions: tuple[str, ...], shape: tuple[int, ...]
) -> dict[str, Any]:
    """Return the sizes of the flat-folded sheets of designs; none if no sheet folds flat."""
    sizes = [
        flat_package(structure_of(design)) if isinstance(design := designs[number], Design) else None
        for number in range(len(designs))
    ]
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


def table_numbers(study: Study, structure: Structure) -> dict[str, tuple[str, str]]:
    """Return unit and meaning of the numbers of a table, by name."""
    search = study.search
    drives = [step.drive for step in search.steps] if search is not None else []
    studied = [transition for transition in structure.transitions if search is None or transition.drive in drives]
    start = [state for state in [first_state(structure, structure.stage_states)] if state]
    numbers: dict[str, tuple[str, str]] = {}
    for step in search.steps if search is not None else ():
        does = next(transition.wording.does for transition in studied if transition.drive == step.drive)
        what = "torque" if step.unit is TORQUE else step.key
        numbers[step.result_name] = (step.unit.si, f"{step.extreme} {what} with which the structure {does}")
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
    if (study.plan or study.boundaries is not None) and search is None:
        names = [transition.name for transition in structure.transitions]
        numbers |= {margin_column(name): ("", f"margin of {name}, from -1 to 1; negative: failed") for name in names}
        numbers[MARGIN] = ("", "margin of all transitions together")
    numbers["residual"] = ("", "largest share of the energy that is missing in a run that decides the result")
    return numbers


def _ask(study: Study) -> str:
    if study.search is None:
        return "run"
    return "least-torques" if study.search.first.key in drive_keys(study.base) else "least-value"


def _by_value(
    search: Search, columns: PointColumns, dimensions: tuple[str, ...], shape: tuple[int, ...]
) -> dict[str, Any]:
    """Return the result of the first transition for every value that was tried."""
    first, kind = search.first, "torque" if search.first.unit is TORQUE else "value"
    axes = (*dimensions, first.value_name)
    times = columns.times_tried.reshape(*shape, -1)
    marks = {f"{first.transition}_tried_by_{kind}": (axes, columns.tried.reshape(*shape, -1))}
    return {
        f"{first.transition}_time_by_{kind}": (axes, times, {"units": "s"}),
        f"{first.state}_by_{kind}": (axes, np.isfinite(times)),
        f"{first.transition}_outcome_by_{kind}": (axes, columns.outcomes_tried.reshape(*shape, -1)),
        **(marks if search.scan == "bracket" else {}),
    }


def _tried(step: SearchStep) -> tuple[str, Array, dict[str, str]]:
    name, unit = step.value_name, step.unit
    meaning = name.replace("_", " ")
    return (
        name,
        np.array(step.values),
        {"units": unit.si, "display": unit.display, "key": step.key, "long_name": meaning},
    )


def table_axes(study: Study) -> tuple[dict[str, Any], tuple[str, ...], tuple[int, ...]]:
    """Return coordinates, dimensions and shape of the table."""
    coordinates: dict[str, Any] = {}
    values: Sequence[Any]
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
            values = _sampled_values(study, factor) or [point_value(study, factor, point) for point in points]
        unit = factor.unit
        attributes = {"key": factor.key, "long_name": factor.key.replace(".", " ").replace("_", " ")}
        if unit is not None:
            attributes |= {"units": unit.si, "display": unit.display}
        coordinates[factor.dimension] = (dimension, values, attributes)
    return coordinates, tuple(names), tuple(shape)


def _sampled_values(study: Study, factor: Factor) -> list[float] | None:
    """Return the values of a factor at all sampled points, SI; None if its values are not sampled numbers."""
    if not isinstance(study.points, SampledPoints):
        return None
    place = study.factors.index(factor)
    blocks = (
        range(first, min(first + POINTS_TOGETHER, len(study.points)))
        for first in range(0, len(study.points), POINTS_TOGETHER)
    )
    return [value for block in blocks for value in study.points.si_values(block)[:, place].tolist()]


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


def point_value(study: Study, factor: Factor, point: Mapping[str, object]) -> Any:
    """Return the value of a factor at a point or a choice; the base's value if the point has none."""
    return _factor_value(factor, point[factor.key] if factor.key in point else own_value(study.base, factor))


def _factor_value(factor: Factor, value: object) -> Any:
    unit = factor.unit
    if unit is None:
        return as_written(value) if isinstance(value, list) else value
    return value if isinstance(value, float) else parse_quantity(value, unit)
