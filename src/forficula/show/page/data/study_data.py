"""A study's table as data for its page: factors, columns, quantities to map, and reasons for missing values."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from forficula.analysis import Verdict
from forficula.quantities import reading_unit
from forficula.show.page.parts.outcome_words import OTHER_LOOK, OutcomeWords, signs_of
from forficula.show.page.parts.run_sentences import unbuilt_text
from forficula.show.study.bins import Bins, bins_of
from forficula.show.study.boundary_figure import boundary_shapes
from forficula.show.study.factor_text import display_values, number_text, plain_name, value_with_unit
from forficula.show.study.map_panel import MapPanel
from forficula.show.study.maps import energy_noun, missing_reasons, table_view, times_by_value
from forficula.study import Study
from forficula.study.assumptions.choices import CHOICE
from forficula.study.changes import CHANGE
from forficula.study.refine.summary import boundary_text, locates_boundaries
from forficula.study.tables.outcome_kinds import table_transitions

if TYPE_CHECKING:
    from xarray import DataArray, Dataset

_DIGITS = 7
# Largest number of bins along a factor on a page; more rows are higher than a screen. [chosen]
_MOST_BINS = 60
# group of quantities with one value for every torque that was tried


def study_data(study: Study, table: Dataset) -> dict[str, Any]:
    """Return a study as data for JSON.

    Args:
        study: the study.
        table: its results.

    Returns:
        Every list with one entry for each point has the study's order, in which the last factor varies fastest. Numbers
        are in the unit beside them; None if there is no value.

        - `noun`: noun for one point; `file`: file that lists all; `points`: their number; `sampled`: whether they were
          drawn.
        - `keeps`: sentence on which runs are kept.
        - `factors`: `key`, `name`, `unit`, `log` (whether values were drawn by their logarithms), and `values`: those
          of the grid, or one for each drawn point. If factors are varied one at a time, the first of these factors is
          the choice.
        - `axes`: indices of the factors in the order in which maps use them as axes; `cuts`: index of each factor's
          value at which maps of the other factors are drawn.
        - `words`: outcomes, the best first: `word`, `sign`, and `count` of the points with this outcome.
        - `verdicts`: index into `words` for each point; `statuses`: full texts; `built`: whether the point could run.
        - `quantities`: for maps and for the table's columns: `name`, `title`, `group`, `unit`, `values`, `reasons`
          (index into `words` for each point, None if there is a value) and `transition` (index of the transition that
          the quantity belongs to, or None). The first quantity is the verdict and has no values.
        - `boundaries`: of a study that locates boundaries over one or two factors, else None; see `_boundary_data`.
    """
    bins = page_bins(table)
    if bins is not None:
        return _binned_data(study, table, bins)
    signs = signs_of(table)
    words = OutcomeWords(sorted({str(word) for word in table["outcome"].values.ravel()}, key=signs.rank), signs)
    verdicts = words.numbers(table["outcome"])
    quantities = [
        _outcome_quantity(verdicts),
        *(_quantity(table, drawn, words) for drawn in _drawn(table)),
        *_times_by_value(table, words),
    ]
    drawn = [factor.dimension for factor in study.factors]
    names = drawn if study.sampled else [str(name) for name in table["status"].dims]
    return {
        "name": study.name,
        "noun": "point",
        "file": "table.csv",
        "keeps": "The option --keep sets the number of points whose runs are kept.",
        "unbuilt": unbuilt_text("point"),
        "design": study.base.name,
        "points": len(study.points),
        "sampled": study.sampled,
        "search": study.search is not None,
        "factors": [factor_data(table[name]) for name in names],
        "axes": sorted(range(len(names)), key=lambda index: names[index] == CHOICE),
        "cuts": [0 if name == CHOICE else table[name].size // 2 for name in names],
        "built": [str(verdict) != Verdict.NOT_BUILT for verdict in table["verdict"].values.ravel()],
        "statuses": [str(status) for status in table["status"].values.ravel()],
        "verdicts": verdicts,
        "quantities": quantities,
        "words": words.data(verdicts),
        "other": OTHER_LOOK,
        "boundaries": _boundary_data(table) if locates_boundaries(table) else None,
    }


def _boundary_data(table: Dataset) -> dict[str, Any] | None:
    """Return cells and boundaries as data for JSON; None for three factors.

    `x` and `y` are the indices of the factors on the axes; `y` is None for one factor. Every entry of `cells` has the
    least and the largest value of both factors, and every entry of `lines` the two ends of a piece of a boundary.
    `text` says what the boundaries separate.
    """
    shapes = boundary_shapes(table)
    if shapes is None:
        return None
    cells = [[rounded(value) for corner in (corners[0], corners[2]) for value in corner] for corners in shapes.cells]
    lines = [[rounded(value) for end in line for value in end] for line in shapes.lines]
    return {"x": shapes.x, "y": shapes.y, "cells": cells, "lines": lines, "text": boundary_text(table)}


def page_bins(table: Dataset) -> Bins | None:
    """Return the bins in which the page of a study of many points shows its table; None if it shows every point."""
    view = table_view(table)
    return bins_of(view, _MOST_BINS) if CHOICE not in table.dims and CHANGE not in table.dims else None


def _binned_data(study: Study, table: Dataset, bins: Bins) -> dict[str, Any]:
    """Return the bins of a study as data for JSON, in the form of `study_data` with a bin in the place of a point.

    Quantities have the mean of each bin, outcomes the most frequent one; `status` has the shares of all outcomes.
    """
    view, signs = table_view(table), signs_of(table)
    part = view.table
    outcomes = part["outcome"].transpose(*bins.dimensions).values.ravel()
    frequent = bins.most_frequent(outcomes, np.ones(len(outcomes), dtype=bool))
    words = OutcomeWords(sorted({str(word) for word in outcomes.tolist()}, key=signs.rank), signs)
    verdicts = [words.number(str(word)) for word in frequent.tolist()]
    quantities = [_outcome_quantity(verdicts)]
    for drawn in _drawn(part):
        panel = MapPanel(
            title=drawn.title,
            values=part[drawn.name],
            reasons=missing_reasons(part, drawn.name),
            unit=str(part[drawn.name].attrs["units"]),
        )
        means = bins.panel(panel)
        numbers = means.values.values.ravel()
        unit, scale = _unit(part[drawn.name], numbers)
        values = [rounded(scale * value) for value in numbers.tolist()]
        reasons = _reasons(values, means.reasons.values.ravel(), words)
        quantities.append(_quantity_data(part, drawn, unit, values, reasons))
    names = [name for name in (bins.view.y, bins.view.x) if name]
    return {
        "name": study.name,
        "noun": "bin",
        "file": "table.csv",
        "keeps": "The option --keep sets the number of points whose runs are kept.",
        "unbuilt": unbuilt_text("bin"),
        "unkept": "No run of this bin was kept, so none can be played here.",
        "numbers": "Mean values of the bin",
        "design": study.base.name,
        "points": len(bins.counts),
        "sampled": False,
        "search": study.search is not None,
        "factors": [_bin_data(bins.view.table[name]) for name in names],
        "axes": list(range(len(names))),
        "cuts": [0] * len(names),
        "built": [True] * len(bins.counts),
        "statuses": bins.shares(outcomes),
        "verdicts": verdicts,
        "quantities": quantities,
        "words": words.data(verdicts),
        "other": OTHER_LOOK,
    }


def _bin_data(factor: DataArray) -> dict[str, Any]:
    """Return the middles of bins as data for JSON, with as few digits as distinguish them, but at least three."""
    data = factor_data(factor)
    values = data["values"]
    if not all(isinstance(value, float) for value in values):
        return data
    texts = ([f"{value:.{digits}g}" for value in values] for digits in range(3, _DIGITS + 1))
    return data | {"texts": next((item for item in texts if len({*item}) == len(item)), data["texts"])}


def _outcome_quantity(verdicts: list[int]) -> dict[str, Any]:
    return {
        "name": "status",
        "title": "outcome",
        "group": "outcome",
        "unit": "",
        "values": None,
        "reasons": verdicts,
        "transition": None,
    }


@dataclass(frozen=True, kw_only=True)
class _Drawn:
    """Number of a table: its variable, its name on the page, its group, and its transition."""

    group: str
    name: str
    title: str
    transition: int | None


def _drawn(table: Dataset) -> list[_Drawn]:
    """Return the numbers of a table in the order of the page's menu."""
    transitions, start = table_transitions(table), str(table.attrs.get("start_state", ""))
    numbered, noun = list(enumerate(transitions)), energy_noun(table)
    states: dict[str, int | None] = {start: None} if start else {}
    for number, item in numbered:
        states.setdefault(item.state, number)
    margins = [(f"{item.name}_margin", f"margin of {item.wording.noun}", number) for number, item in numbered]
    drawn = [
        *(("margin", name, title, number) for name, title, number in (("margin", "margin", None), *margins)),
        *(("torque", item.least, item.least.replace("_", " "), number) for number, item in numbered if item.least),
        *(("time", f"{item.name}_time", item.wording.time, number) for number, item in numbered),
        *(("work", f"{item.name}_work", f"work of {item.wording.noun}", number) for number, item in numbered),
        *(("energy", f"{state}_energy", f"{noun} when {state}", number) for state, number in states.items()),
        *(
            ("energy", f"{state}_hinge_energy", f"springs' energy when {state}", number)
            for state, number in states.items()
        ),
        *(
            ("energy", f"{state}_spring_energy", f"stretching energy when {state}", number)
            for state, number in states.items()
        ),
        *(
            ("energy", f"{state}_coupling_energy", f"couplings' energy when {state}", number)
            for state, number in states.items()
        ),
    ]
    return [
        _Drawn(group=group, name=name, title=title, transition=transition)
        for group, name, title, transition in drawn
        if name in table
    ]


def factor_data(factor: DataArray) -> dict[str, Any]:
    """Return a factor as data for JSON, with its values in the display unit."""
    values, unit = display_values(factor)
    return {
        "key": str(factor.attrs.get("key", factor.name)),
        "name": plain_name(factor),
        "unit": unit,
        "values": [rounded(value) for value in values.tolist()],
        "log": factor.attrs.get("prior") == "log-uniform",
        "texts": [number_text(value) for value in values.tolist()],
    }


def _quantity(table: Dataset, drawn: _Drawn, words: OutcomeWords) -> dict[str, Any]:
    numbers = table[drawn.name].values.ravel()
    unit, scale = _unit(table[drawn.name], numbers)
    values = [rounded(scale * value) for value in numbers.tolist()]
    reasons = _reasons(values, missing_reasons(table, drawn.name).values.ravel(), words)
    return _quantity_data(table, drawn, unit, values, reasons)


def _quantity_data(
    table: Dataset, drawn: _Drawn, unit: str, values: list[float | None], reasons: list[int | None]
) -> dict[str, Any]:
    return {
        "name": drawn.name,
        "title": drawn.title,
        "group": drawn.group,
        "unit": unit,
        "energy": table[drawn.name].attrs["units"] == "J",
        "shares": drawn.group == "energy",
        "values": values,
        "reasons": reasons,
        "transition": drawn.transition,
    }


def _reasons(values: Sequence[float | None], reasons: NDArray[np.object_], words: OutcomeWords) -> list[int | None]:
    """Return the reason for each missing value."""
    pairs = zip(values, reasons.tolist(), strict=True)
    return [words.number(str(reason)) if value is None else None for value, reason in pairs]


def _times_by_value(table: Dataset, words: OutcomeWords) -> Iterator[dict[str, Any]]:
    """Yield a map for every value of the first transition that was tried, all in one unit."""
    tried_times = times_by_value(table)
    if tried_times is None:
        return
    times, tried = table[tried_times.times], table[tried_times.value]
    unit, scale = _unit(times, times.values)
    for index in range(tried.size):
        values = [rounded(scale * value) for value in times.isel({tried_times.value: index}).values.ravel().tolist()]
        became = table[tried_times.outcomes].isel({tried_times.value: index}).values.ravel()
        yield {
            "name": f"{tried_times.times}:{index}",
            "title": f"{tried_times.label} with {value_with_unit(tried, index)}",
            "group": "time by torque",
            "unit": unit,
            "shares": True,
            "tried": True,
            "values": values,
            "reasons": _reasons(values, became, words),
            "transition": 0,
        }


def _unit(variable: DataArray, values: Any) -> tuple[str, float]:
    """Return a legible unit for some values, and its factor from SI."""
    largest = np.nanmax(np.abs(values), initial=0.0, where=np.isfinite(values))
    return reading_unit(str(variable.attrs["units"]), float(largest))


def rounded(value: Any) -> Any:
    """Return a number rounded to the digits of the page; None for nan and infinity."""
    if not isinstance(value, float):
        return value
    return float(f"{value:.{_DIGITS}g}") if math.isfinite(value) else None
