"""Table of a tolerance analysis. Only modules that build tables import this one, because xarray is slow to load."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray

from forficula.design import key_quantity, key_value
from forficula.errors import InputError
from forficula.goals.deviation import allowed_ends, deviation_widths
from forficula.goals.tolerance.advice import advice
from forficula.goals.tolerance.indices import Indices
from forficula.goals.tolerance.nearest_failure import Answer, Reach
from forficula.goals.tolerance.question import Question
from forficula.goals.tolerance.samples import margin_names
from forficula.goals.tolerance.tolerance import Tolerance
from forficula.results import Result
from forficula.structure import structure_of
from forficula.study.tables.outcome_kinds import transitions_text


class ToleranceTable(Result, xarray.Dataset):  # type: ignore[no-untyped-call]
    """An `xarray.Dataset` that displays its conclusions in notebooks.

    Attributes:
        tolerance: result from which the table was built. Parts of a table and tables read from a file lack it.
    """

    __slots__ = ("tolerance",)
    tolerance: Tolerance


def tolerance_of_table(table: object) -> Tolerance:
    """Return the result from which a table was built.

    Raises:
        InputError: the table is a part of one, or was read from a file.
    """
    result = getattr(table, "tolerance", None)
    if not isinstance(result, Tolerance):
        raise InputError(
            "need the whole table as tolerance returns it; parts of it and tables that were read from a file have no"
            " design; tolerance returns the table of its folder without new runs"
        )
    return result


def tolerance_table(result: Tolerance) -> xarray.Dataset:
    """Build the labelled table of a tolerance analysis.

    Args:
        result: the result.

    Returns:
        Dimensions: `fact` (works, makes each transition, keeps each state, meets each limit) with `probability` and its
        interval. `group` (factors, and the others as one) and `result` (margins) with first-order and total indices and
        their intervals, and `leads`, the fraction of resamplings in which the index is the largest. `factor` with
        nominal value and width in SI; with screening, also `screening_share` (fraction of the variance explained
        alone), `screening_resolved` (whether it is significant) and `screening_effect` (from a few exchanged rows); the
        range of each factor alone, in widths, NaN if unknown, and why it ends; and the gain of halving its tolerance.
        `map_x` and `map_y`, two factors that deviate alone, with `map_outcome`, if there is a map. `sample`, with every
        value in SI, `answer`, `outcome`, `status`, `verdict` and `margin`. The attribute `says` has the conclusions,
        and `transitions` has the transitions as in the table of a study.
    """
    question = result.question
    variables: dict[str, Any] = {**_facts(result), **_indices(result.indices), **_factors(result)}
    variables |= _samples(result) | _map(result)
    coordinates = {
        "fact": list(result.probabilities),
        "group": list(result.indices.groups),
        "result": list(margin_names(question)),
        "factor": list(question.keys),
        **_values(result),
    }
    attributes = {
        "design": question.design.name,
        "design_hash": question.design.hash,
        "transitions": transitions_text(structure_of(question.design), None),
        "nominal": str(result.nominal.outcomes[0]),
        "seed": result.seed,
        "runs": result.runs,
        "says": "\n".join(advice(result)),
    }
    table = ToleranceTable(variables, coordinates, attributes)
    table.tolerance = result
    return table


def _facts(result: Tolerance) -> dict[str, Any]:
    probabilities = result.probabilities.values()
    return {
        "probability": (
            "fact",
            [np.nan if probability.share is None else probability.share for probability in probabilities],
        ),
        "probability_low": ("fact", [probability.low for probability in probabilities]),
        "probability_high": ("fact", [probability.high for probability in probabilities]),
        "works": ("fact", [probability.works for probability in probabilities]),
        "fails": ("fact", [probability.fails for probability in probabilities]),
        "unknown": ("fact", [probability.unknown for probability in probabilities]),
    }


def _indices(indices: Indices) -> dict[str, Any]:
    over = ("result", "group")
    return {
        "first_index": (over, indices.first),
        "first_index_low": (over, indices.first_low),
        "first_index_high": (over, indices.first_high),
        "total_index": (over, indices.total),
        "total_index_low": (over, indices.total_low),
        "total_index_high": (over, indices.total_high),
        "leads": (over, indices.leads),
    }


def _factors(result: Tolerance) -> dict[str, Any]:
    question = result.question
    units = [_unit(question, factor) for factor in range(len(question.keys))]
    screened, unknown = result.screened, np.full(len(units), np.nan)
    table: dict[str, Any] = {
        "value": ("factor", [float(key_value(question.design, key)) for key in question.keys]),
        "width": ("factor", deviation_widths(question.design, question.deviations)),
        "unit": ("factor", units),
        "distribution": ("factor", [deviation.distribution for deviation in question.deviations]),
        "screening_effect": ("factor", result.effects),
        "screening_share": ("factor", unknown if screened is None else screened.shares),
        "screening_resolved": ("factor", unknown > 0 if screened is None else screened.resolved),
        "gain": ("factor", [narrowed.gain for narrowed in result.narrowed]),
        "gain_low": ("factor", [narrowed.gain_low for narrowed in result.narrowed]),
        "gain_high": ("factor", [narrowed.gain_high for narrowed in result.narrowed]),
    }
    for name, side in (("down", 0), ("up", 1)):
        ranges = [both[side] for both in result.reaches]
        table[f"works_{name}"] = ("factor", [reach.works for reach in ranges] or np.full(len(units), np.nan))
        table[f"fails_{name}"] = ("factor", [_fails(reach) for reach in ranges] or np.full(len(units), np.nan))
        table[f"ends_{name}"] = ("factor", [reach.why.value for reach in ranges] or [""] * len(units))
    if result.nearest is not None:
        table["nearest_failure"] = ("factor", result.nearest.offsets)
    return table


def _samples(result: Tolerance) -> dict[str, Any]:
    samples = result.samples
    return {
        "answer": ("sample", samples.answers.astype(str).astype(object)),
        "outcome": ("sample", samples.outcomes),
        "status": ("sample", samples.statuses),
        "verdict": ("sample", samples.verdicts),
        "margin": (("result", "sample"), samples.margins),
    }


def _map(result: Tolerance) -> dict[str, Any]:
    """Return the outcomes of designs in which only two factors deviate, over their values in SI."""
    if result.map is None:
        return {}
    verdict_map, question = result.map, result.question
    axes: dict[str, Any] = {}
    for name, factor, steps in zip(
        ("map_x", "map_y"), (verdict_map.first, verdict_map.second), verdict_map.steps, strict=True
    ):
        nominal, width = _nominal(question, factor)
        axes[name] = (name, nominal + steps * width, _attributes(question, factor))
    cells = verdict_map.samples.outcomes.reshape(verdict_map.steps.shape[1], -1)
    return {**axes, "map_outcome": (("map_x", "map_y"), cells)}


def _values(result: Tolerance) -> dict[str, Any]:
    """Return the value of every factor in every sample, SI."""
    columns: dict[str, Any] = {}
    for factor, key in enumerate(result.question.keys):
        nominal, width = _nominal(result.question, factor)
        # a value that its key does not allow was replaced by the nearest allowed one
        values = np.clip(
            nominal + width * result.samples.offsets[:, factor], *allowed_ends(result.question.design, key)
        )
        columns[key.replace(".", "_")] = ("sample", values, _attributes(result.question, factor))
    return columns


def _nominal(question: Question, factor: int) -> tuple[float, float]:
    """Return the nominal value of a factor and one width, SI."""
    nominal = float(key_value(question.design, question.keys[factor]))
    return nominal, question.deviations[factor].width(nominal)


def _attributes(question: Question, factor: int) -> dict[str, str]:
    quantity = key_quantity(question.keys[factor], type(question.design))
    display = "" if quantity is None else quantity.unit.display
    return {"units": _unit(question, factor), "display": display, "key": question.keys[factor]}


def _unit(question: Question, factor: int) -> str:
    quantity = key_quantity(question.keys[factor], type(question.design))
    return "" if quantity is None else quantity.unit.si


def _fails(reach: Reach) -> float:
    return np.nan if reach.why is not Answer.FAILS or reach.beyond is None else reach.beyond
