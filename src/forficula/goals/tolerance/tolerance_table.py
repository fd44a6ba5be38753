"""A tolerance as a labelled table. Only what makes one imports this, for xarray takes long to load."""

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
    """An `xarray.Dataset` that a notebook shows with what it says.

    Attributes:
        tolerance: that the table is of. Parts of a table and tables that were read from a file do not have it.
    """

    __slots__ = ("tolerance",)
    tolerance: Tolerance


def tolerance_of_table(table: object) -> Tolerance:
    """Return the tolerance that a table is of.

    Raises:
        InputError: it is a part of a table, or was read from a file.
    """
    found = getattr(table, "tolerance", None)
    if not isinstance(found, Tolerance):
        raise InputError(
            "need the whole table as tolerance returns it; parts of it and tables that were read from a file have no"
            " design; tolerance returns the table of its folder without new runs"
        )
    return found


def tolerance_table(found: Tolerance) -> xarray.Dataset:
    """Label what a tolerance came to.

    Args:
        found: what the runs say.

    Returns:
        Dimensions: `fact`, that it works, does each transition, stays there, meets each limit, with `probability` and
        its interval; `group`, factors and the others as one, by `margin`, with first-order and total indices and their
        intervals, and `leads`, the share of resamplings in which its index is the largest; `factor`, with value and
        width in SI, what the screening says of it where there is one (`screening_share` of the variance that it decides
        alone, `screening_resolved` whether that exceeds chance, `screening_effect` from a few exchanged rows), how far
        it alone may go down and up, in widths, NaN where that is not known, why it ends there, and what half of its
        tolerance gains; `map_x` and `map_y`, two factors that alone are off, with `map_outcome`, where there is a map;
        `sample`, with every value in SI, `answer`, `outcome`, `status`, `verdict` and `margin`. The attribute `says`
        has the sentences, and `transitions` names the transitions as that of a study does.
    """
    question = found.question
    variables: dict[str, Any] = {**_facts(found), **_indices(found.indices), **_factors(found)}
    variables |= _samples(found) | _map(found)
    coordinates = {
        "fact": list(found.probabilities),
        "group": list(found.indices.groups),
        "result": list(margin_names(question)),
        "factor": list(question.keys),
        **_values(found),
    }
    attributes = {
        "design": question.design.name,
        "design_hash": question.design.hash,
        "transitions": transitions_text(structure_of(question.design), None),
        "nominal": str(found.nominal.outcomes[0]),
        "seed": found.seed,
        "runs": found.runs,
        "says": "\n".join(advice(found)),
    }
    table = ToleranceTable(variables, coordinates, attributes)
    table.tolerance = found
    return table


def _facts(found: Tolerance) -> dict[str, Any]:
    each = found.probabilities.values()
    return {
        "probability": ("fact", [np.nan if one.share is None else one.share for one in each]),
        "probability_low": ("fact", [one.low for one in each]),
        "probability_high": ("fact", [one.high for one in each]),
        "works": ("fact", [one.works for one in each]),
        "fails": ("fact", [one.fails for one in each]),
        "unknown": ("fact", [one.unknown for one in each]),
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


def _factors(found: Tolerance) -> dict[str, Any]:
    question = found.question
    units = [_unit(question, factor) for factor in range(len(question.keys))]
    screened, unknown = found.screened, np.full(len(units), np.nan)
    table: dict[str, Any] = {
        "value": ("factor", [float(key_value(question.design, key)) for key in question.keys]),
        "width": ("factor", deviation_widths(question.design, question.deviations)),
        "unit": ("factor", units),
        "distribution": ("factor", [each.distribution for each in question.deviations]),
        "screening_effect": ("factor", found.effects),
        "screening_share": ("factor", unknown if screened is None else screened.shares),
        "screening_resolved": ("factor", unknown > 0 if screened is None else screened.resolved),
        "gain": ("factor", [each.gain for each in found.narrowed]),
        "gain_low": ("factor", [each.gain_low for each in found.narrowed]),
        "gain_high": ("factor", [each.gain_high for each in found.narrowed]),
    }
    for name, place in (("down", 0), ("up", 1)):
        ways = [each[place] for each in found.reaches]
        table[f"works_{name}"] = ("factor", [each.works for each in ways] or np.full(len(units), np.nan))
        table[f"fails_{name}"] = ("factor", [_fails(each) for each in ways] or np.full(len(units), np.nan))
        table[f"ends_{name}"] = ("factor", [each.why.value for each in ways] or [""] * len(units))
    if found.nearest is not None:
        table["nearest_failure"] = ("factor", found.nearest.offsets)
    return table


def _samples(found: Tolerance) -> dict[str, Any]:
    samples = found.samples
    return {
        "answer": ("sample", samples.answers.astype(str).astype(object)),
        "outcome": ("sample", samples.outcomes),
        "status": ("sample", samples.statuses),
        "verdict": ("sample", samples.verdicts),
        "margin": (("result", "sample"), samples.margins),
    }


def _map(found: Tolerance) -> dict[str, Any]:
    """What became of designs of which two factors alone are off, over the values of these, SI."""
    if found.map is None:
        return {}
    drawn, question = found.map, found.question
    axes: dict[str, Any] = {}
    for name, factor, steps in zip(("map_x", "map_y"), (drawn.first, drawn.second), drawn.steps, strict=True):
        own, width = _own(question, factor)
        axes[name] = (name, own + steps * width, _attributes(question, factor))
    cells = drawn.samples.outcomes.reshape(drawn.steps.shape[1], -1)
    return {**axes, "map_outcome": (("map_x", "map_y"), cells)}


def _values(found: Tolerance) -> dict[str, Any]:
    """What every factor is in every sample, SI."""
    columns: dict[str, Any] = {}
    for factor, key in enumerate(found.question.keys):
        own, width = _own(found.question, factor)
        # what no key allows was built with the nearest value that it does
        values = np.clip(own + width * found.samples.offsets[:, factor], *allowed_ends(found.question.design, key))
        columns[key.replace(".", "_")] = ("sample", values, _attributes(found.question, factor))
    return columns


def _own(question: Question, factor: int) -> tuple[float, float]:
    """The design's own value of a factor and one width, SI."""
    own = float(key_value(question.design, question.keys[factor]))
    return own, question.deviations[factor].width(own)


def _attributes(question: Question, factor: int) -> dict[str, str]:
    quantity = key_quantity(question.keys[factor], type(question.design))
    display = "" if quantity is None else quantity.unit.display
    return {"units": _unit(question, factor), "display": display, "key": question.keys[factor]}


def _unit(question: Question, factor: int) -> str:
    quantity = key_quantity(question.keys[factor], type(question.design))
    return "" if quantity is None else quantity.unit.si


def _fails(reach: Reach) -> float:
    return np.nan if reach.why is not Answer.FAILS or reach.beyond is None else reach.beyond
